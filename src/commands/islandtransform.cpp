#include "commands/islandtransform.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! True when lines along the axes stay such lines.
bool keepsAxes(const Eigen::Affine2d &transform)
{
    constexpr double tolerance = 1e-9;
    const Eigen::Matrix2d sizes = transform.linear().cwiseAbs();
    const double least = tolerance * sizes.maxCoeff();
    return std::max(sizes(0, 1), sizes(1, 0)) <= least || std::max(sizes(0, 0), sizes(1, 1)) <= least;
}

} // namespace

IslandTransform::IslandTransform(Document &document, UvEdit edit, const std::vector<int> &islands)
    : mDocument(document), mEdit(edit), mGesture(document.undoStack().newGesture())
{
    const Islands &all = document.islands();
    for (int island : islands) {
        if (document.marks().flagsOf(all.faces(island)).locked != 0)
            continue;
        const std::vector<int> corners = all.corners(document.mesh(), {island});
        mCorners.insert(mCorners.end(), corners.begin(), corners.end());
        mOwner.insert(mOwner.end(), corners.size(), static_cast<int>(mIslands.size()));
        mIslands.push_back(island);
    }
    const auto isAligned = [](const IslandFlags &flags) { return flags.aligned != 0; };
    if (std::ranges::any_of(document.marks().faceFlags, isAligned))
        mFlags = document.marks().faceFlags;
    mStart = document.uv()(mCorners, Eigen::all);
    for (std::size_t i = 0; i < mCorners.size(); ++i) {
        if (const UvPin *pin = document.constraints().pin(mCorners[i])) {
            mPins.push_back(*pin);
            mPinOwner.push_back(mOwner[i]);
        }
    }
}

std::unique_ptr<SetUvs> IslandTransform::command(const Eigen::Affine2d &transform) const
{
    return command([&transform](int) { return transform; });
}

std::unique_ptr<SetUvs>
IslandTransform::command(const std::function<Eigen::Affine2d(int island)> &transformOf) const
{
    std::vector<Eigen::Affine2d> transforms;
    for (int island : mIslands)
        transforms.push_back(transformOf(island));
    // The identity must give exactly the bits of the start; multiplying would lose the sign of a negative
    // zero.
    const auto moved = [&](int owner, const Vec2 &point) {
        const Eigen::Affine2d &transform = transforms[owner];
        const bool identity = transform.matrix() == Eigen::Affine2d::Identity().matrix();
        return identity ? point : Vec2(transform * point);
    };
    UvMatrix uv = mDocument.uv();
    for (std::size_t i = 0; i < mCorners.size(); ++i)
        uv.row(mCorners[i]) =
            moved(mOwner[i], mStart.row(static_cast<Eigen::Index>(i)).transpose()).transpose();
    UvEditExtras extras;
    extras.count = static_cast<int>(mIslands.size());
    extras.pins = mPins;
    for (std::size_t i = 0; i < mPins.size(); ++i)
        extras.pins[i].position = moved(mPinOwner[i], mPins[i].position);
    extras.flags = mFlags;
    for (std::size_t i = 0; !mFlags.empty() && i < mIslands.size(); ++i) {
        for (const int face : mDocument.islands().faces(mIslands[i]))
            extras.flags[face].aligned = keepsAxes(transforms[i]) ? mFlags[face].aligned : 0;
    }
    auto command = std::make_unique<SetUvs>(mDocument, mEdit, uv, extras);
    command->setGesture(mGesture);
    return command;
}

std::unique_ptr<SetUvs> movePieces(Document &document, UvEdit edit, std::span<const IslandPiece> pieces,
                                   std::span<const Eigen::Affine2d> transforms)
{
    std::map<int, std::size_t> pieceOf;
    std::vector<int> islands;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        for (int island : pieces[p].islands) {
            if (pieces[p].locked)
                continue; // one locked island keeps its whole piece in place
            pieceOf[island] = p;
            islands.push_back(island);
        }
    }
    const IslandTransform transform(document, edit, islands);
    return transform.command([&](int island) { return transforms[pieceOf.at(island)]; });
}

} // namespace autocuts
