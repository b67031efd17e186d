#include "commands/islandtransform.h"

namespace autocuts {

IslandTransform::IslandTransform(Document &document, UvEdit edit, const std::vector<int> &islands)
    : mDocument(document), mEdit(edit), mGesture(document.undoStack().newGesture())
{
    const Islands &all = document.islands();
    std::vector<int> movable;
    for (int island : islands) {
        if (document.marks().flagsOf(all.faces(island)).locked == 0)
            movable.push_back(island);
    }
    mIslandCount = static_cast<int>(movable.size());
    mCorners = all.corners(document.mesh(), movable);
    mStart = document.uv()(mCorners, Eigen::all);
    for (int corner : mCorners) {
        if (const UvPin *pin = document.constraints().pin(corner))
            mPins.push_back(*pin);
    }
}

std::unique_ptr<SetUvs> IslandTransform::command(const Eigen::Affine2d &transform) const
{
    // The identity has to give back the very bits of the start, and a product would lose the sign of zero.
    const bool identity = transform.matrix() == Eigen::Affine2d::Identity().matrix();
    const auto moved = [&](const Vec2 &point) { return identity ? point : Vec2(transform * point); };
    UvMatrix uv = mDocument.uv();
    for (std::size_t i = 0; i < mCorners.size(); ++i)
        uv.row(mCorners[i]) = moved(mStart.row(static_cast<Eigen::Index>(i)).transpose()).transpose();
    UvEditExtras extras;
    extras.count = mIslandCount;
    extras.pins = mPins;
    for (UvPin &pin : extras.pins)
        pin.position = moved(pin.position);
    auto command = std::make_unique<SetUvs>(mDocument, mEdit, uv, extras);
    command->setGesture(mGesture);
    return command;
}

} // namespace autocuts
