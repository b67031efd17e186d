#include "solver/unwrap/packjob.h"

#include "model/plain/rigidpieces.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "solver/overlap/nearcharts.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/packing/packmap.h"
#include "solver/straight/straightening.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! After a stop more pieces than this are only laid into shelves.
constexpr int mostHurriedPieces = 100;

//! How far an island may reach out of its rectangle. Chosen by hand far above rounding.
constexpr double boxTolerance = 1e-9;

constexpr double lostByRounding = 1e-6; // share of a distance

//! A place that islands are packed into.
struct Bin
{
    Eigen::AlignedBox2d box;
    bool isRectangle = false;

    bool operator==(const Bin &o) const
    {
        return isRectangle == o.isRectangle && box.min() == o.box.min() && box.max() == o.box.max();
    }
};

//! Packs the pieces bin by bin.
class BinPacker
{
public:
    BinPacker(const MeshData &mesh, const ChartMap &charts, const PackJob &pack) : mMesh(mesh), mPack(pack)
    {
        std::vector<IslandFlags> flags = pack.faceFlags;
        flags.resize(mesh.faceCount());
        mRigid = rigidPieces(charts, flags, pack.movable);
        for (int face = 0; face < mesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece >= 0 && !pack.stays.empty() && pack.stays[face])
                mRigid.locked[piece] = true;
        }
        findBins();
    }

    bool lieFree(const UvMatrix &uv, const JobContext &job) const
    {
        for (std::size_t bin = 0; bin < mBins.size(); ++bin) {
            if (!liesFree(mBins[bin].box, lockedFor(bin), std::vector<bool>(mRigid.pieces.count, true), uv,
                          job))
                return false;
        }
        bool free = true;
        visitNearer(mPack.gap, uv,
                    [&](int p, int q, double) { free = free && mRigid.locked[p] && mRigid.locked[q]; });
        return free;
    }

    std::vector<bool> misplaced(const UvMatrix &uv, const JobContext &job) const
    {
        const ChartMap &pieces = mRigid.pieces;
        std::vector<bool> away(pieces.count, false);
        std::vector<double> area(pieces.count, 0);
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const auto &[a, b, c] = mMesh.triangles[t];
            if (const int piece = pieces.faceChart[mMesh.triangleFace[t]]; piece >= 0)
                area[piece] += std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c))));
        }
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = pieces.faceChart[face];
            if (piece >= 0 && !mRigid.locked[piece] && !liesIn(mBins[mBinOf[piece]].box, face, uv))
                away[piece] = true;
        }
        std::vector<std::vector<int>> meets(pieces.count);
        const auto meet = [&](int p, int q) {
            if (!meets[p].empty() && meets[p].back() == q)
                return;
            meets[p].push_back(q);
            meets[q].push_back(p);
        };
        overlap::OverlapOptions options;
        options.job = job.quiet();
        overlap::visitOverlaps(soupUv(mMesh, uv), options, [&](int a, int b, double) {
            const int p = pieces.faceChart[mMesh.triangleFace[a]],
                      q = pieces.faceChart[mMesh.triangleFace[b]];
            if (p >= 0 && q >= 0 && p != q)
                meet(p, q);
            return true;
        });
        visitNearer(mPack.gap, uv, [&](int p, int q, double) { meet(p, q); });
        std::vector<int> order(pieces.count);
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](int p, int q) {
            return mRigid.locked[p] != mRigid.locked[q] ? mRigid.locked[p] : area[p] > area[q];
        });
        std::vector<bool> stays(pieces.count, false);
        for (const int piece : order) {
            stays[piece] = mRigid.locked[piece] || !away[piece];
            if (!mRigid.locked[piece]) {
                stays[piece] = stays[piece] && std::none_of(meets[piece].begin(), meets[piece].end(),
                                                            [&](int other) { return stays[other]; });
            }
        }
        std::vector<bool> faces(mMesh.faceCount(), false);
        for (int face = 0; face < mMesh.faceCount(); ++face)
            faces[face] = pieces.faceChart[face] >= 0 && !stays[pieces.faceChart[face]];
        return faces;
    }

    bool run(UvMatrix &uv, const JobContext &job) const
    {
        UvMatrix packed = uv;
        std::vector<bool> placed = placedBefore(uv);
        for (std::size_t bin = 0; bin < mBins.size(); ++bin) {
            const std::vector<bool> locked = lockedFor(bin);
            if (std::find(locked.begin(), locked.end(), false) == locked.end())
                continue;
            const bool stays = mBins[bin].isRectangle && !mPack.fillRectangles &&
                               liesFree(mBins[bin].box, locked, placed, packed, job);
            if (!stays && !packBin(bin, placed, packed, job))
                return false;
            for (std::size_t piece = 0; piece < placed.size(); ++piece)
                placed[piece] = placed[piece] || !locked[piece];
        }
        uv = std::move(packed);
        return true;
    }

    //! See movingCharts().
    int movingCharts(const ChartMap &charts) const
    {
        std::vector<bool> moves(charts.count);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece >= 0 && !mRigid.locked[piece])
                moves[charts.faceChart[face]] = true;
        }
        return static_cast<int>(std::ranges::count(moves, true));
    }

    //! See keptGap().
    double keptGap(const UvMatrix &uv) const
    {
        const double margin = mPack.options.margin / mPack.options.textureSize;
        std::map<std::pair<int, int>, double> distances;
        visitNearer(margin, uv, [&](int p, int q, double distance) {
            if (mRigid.locked[p] && mRigid.locked[q])
                return;
            double &least = distances.try_emplace(std::minmax(p, q), distance).first->second;
            least = std::min(least, distance);
        });
        double gap = margin;
        for (const auto &[pieces, distance] : distances) {
            if (distance > 0) // others touch or overlap: on purpose, or they are moved apart
                gap = std::min(gap, distance);
        }
        return (1 - lostByRounding) * gap;
    }

private:
    //! Calls visit(piece, other, distance) for all pieces that are nearer to each other than a distance.
    void visitNearer(double distance, const UvMatrix &uv,
                     const std::function<void(int, int, double)> &visit) const
    {
        if (distance > 0)
            overlap::NearCharts(overlap::chartBorders(mMesh, mRigid.pieces, uv)).visitNearer(distance, visit);
    }

    //! Per piece: true when it is where it belongs before anything is packed. The others are no obstacles.
    std::vector<bool> placedBefore(const UvMatrix &uv) const
    {
        std::vector<bool> placed(mRigid.pieces.count);
        for (std::size_t piece = 0; piece < placed.size(); ++piece)
            placed[piece] = mRigid.locked[piece] || (mBinOf[piece] >= 0 && mBins[mBinOf[piece]].isRectangle);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece >= 0 && placed[piece] && !mRigid.locked[piece])
                placed[piece] = liesIn(mBins[mBinOf[piece]].box, face, uv);
        }
        return placed;
    }

    bool liesIn(const Eigen::AlignedBox2d &box, int face, const UvMatrix &uv) const
    {
        for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
            if (box.exteriorDistance(Vec2(uv.row(c))) > boxTolerance)
                return false;
        }
        return true;
    }

    //! Per piece: true when it stays while a bin is packed.
    std::vector<bool> lockedFor(std::size_t bin) const
    {
        std::vector<bool> locked = mRigid.locked;
        for (std::size_t piece = 0; piece < locked.size(); ++piece)
            locked[piece] = locked[piece] || mBinOf[piece] != static_cast<int>(bin);
        return locked;
    }

    void findBins()
    {
        const Bin usual{{mPack.options.lower, mPack.options.upper}, false};
        // Rectangles first: the others are packed around what they hold.
        for (const PackRectangle &rectangle : mPack.rectangles)
            addBin({rectangle.box, true});
        mBinOf.assign(mRigid.pieces.count, -1);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece < 0)
                continue;
            for (const PackRectangle &rectangle : mPack.rectangles) {
                if (mBinOf[piece] < 0 && rectangle.faces[face])
                    mBinOf[piece] = addBin({rectangle.box, true});
            }
        }
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece < 0 || mBinOf[piece] >= 0)
                continue;
            const int tile = mPack.tiles.empty() ? 0 : mPack.tiles[face];
            mBinOf[piece] = addBin(tile > 0 ? Bin{udimTile(tile, mPack.options.tileHeight()), false} : usual);
        }
    }

    int addBin(const Bin &bin)
    {
        const auto found = std::find(mBins.begin(), mBins.end(), bin);
        if (found == mBins.end())
            mBins.push_back(bin);
        return static_cast<int>(std::find(mBins.begin(), mBins.end(), bin) - mBins.begin());
    }

    //! True when all pieces that may move lie in the box and overlap nothing that has its place.
    bool liesFree(const Eigen::AlignedBox2d &box, const std::vector<bool> &locked,
                  const std::vector<bool> &placed, const UvMatrix &uv, const JobContext &job) const
    {
        const auto pieceOf = [&](int triangle) {
            return mRigid.pieces.faceChart[mMesh.triangleFace[triangle]];
        };
        const auto moves = [&](int piece) { return piece >= 0 && !locked[piece]; };
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            if (moves(mRigid.pieces.faceChart[face]) && !liesIn(box, face, uv))
                return false;
        }
        overlap::OverlapOptions options;
        options.job = job.quiet();
        return overlap::visitOverlaps(soupUv(mMesh, uv), options, [&](int a, int b, double) {
            const int p = pieceOf(a), q = pieceOf(b);
            const auto inPlace = [&](int piece) { return moves(piece) || piece < 0 || placed[piece]; };
            return !(moves(p) || moves(q)) || !inPlace(p) || !inPlace(q);
        });
    }

    //! The pieces of a bin, and those that have their place.
    RigidPieces presentPieces(std::size_t bin, const std::vector<bool> &placed) const
    {
        const std::vector<bool> locked = lockedFor(bin);
        RigidPieces present;
        std::vector<int> number(mRigid.pieces.count, -1);
        for (int piece = 0; piece < mRigid.pieces.count; ++piece) {
            if (locked[piece] && !placed[piece])
                continue;
            number[piece] = present.pieces.count++;
            present.locked.push_back(locked[piece]);
            present.upright.push_back(mRigid.upright[piece]);
            present.aligned.push_back(mRigid.aligned[piece]);
        }
        for (const int piece : mRigid.pieces.faceChart)
            present.pieces.faceChart.push_back(piece < 0 ? -1 : number[piece]);
        return present;
    }

    bool packBin(std::size_t index, const std::vector<bool> &placed, UvMatrix &uv,
                 const JobContext &job) const
    {
        const Bin &bin = mBins[index];
        const RigidPieces present = presentPieces(index, placed);
        packing::PackOptions options = mPack.options;
        options.lower = bin.box.min();
        options.upper = bin.box.max();
        const bool scaleLater =
            !options.keepScale && !mPack.fillRectangles && (mPack.keepScaleIfPossible || bin.isRectangle);
        const bool keepsScale = options.keepScale;
        // At the scale that the map has, where that is wanted and there is room, else at another one.
        const auto pack = [&](const JobContext &how) {
            const auto packAt = [&](bool givenScale) {
                options.keepScale = givenScale;
                const packing::PackResult packed =
                    packing::packMap(mMesh, present, options, mPack.density, uv, how);
                // Where there was no room by chance, islands that keep their densities do not grow.
                if (packed.complete && !givenScale && scaleLater && packed.scale > 1 &&
                    mPack.density == packing::DensityBasis::Given)
                    scalePieces(present, 1 / packed.scale, uv);
                return packed.complete;
            };
            return packAt(keepsScale || scaleLater) || (scaleLater && packAt(false));
        };
        const bool always = mPack.hurry == PackHurry::Always;
        const auto hurries = [&] {
            return always || (job.stopped() && mPack.hurry == PackHurry::WhenStopped);
        };
        if (!hurries() && pack(job))
            return true;
        if (!hurries())
            return false;
        const bool many = present.pieces.count > mostHurriedPieces;
        options.effort = many ? 0 : std::min(options.effort, packing::hurriedEffort);
        return pack(always ? job : job.unstoppable());
    }

    //! Scales the pieces that may move about the middles of their boxes.
    void scalePieces(const RigidPieces &pieces, double factor, UvMatrix &uv) const
    {
        std::vector<Eigen::AlignedBox2d> boxes(pieces.pieces.count);
        const auto visit = [&](const auto &visitor) {
            for (int face = 0; face < mMesh.faceCount(); ++face) {
                const int piece = pieces.pieces.faceChart[face];
                if (piece < 0 || pieces.locked[piece])
                    continue;
                for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                    visitor(piece, c);
            }
        };
        visit([&](int piece, int c) { boxes[piece].extend(Vec2(uv.row(c))); });
        visit([&](int piece, int c) {
            const Vec2 middle = boxes[piece].center();
            uv.row(c) = middle + factor * (Vec2(uv.row(c)) - middle);
        });
    }

    const MeshData &mMesh;
    const PackJob &mPack;
    RigidPieces mRigid;
    std::vector<Bin> mBins;
    std::vector<int> mBinOf; //!< per piece; -1: it has no faces
};

} // namespace

void PackJob::packInto(const Eigen::AlignedBox2d &box)
{
    options.lower = box.min();
    options.upper = box.max();
    tiles.clear();
    rectangles.clear();
}

PackJob steeredPackJob(const Snapshot &snapshot, const packing::PackOptions &options)
{
    const MeshData &mesh = *snapshot.mesh;
    PackJob pack{.options = options, .faceFlags = snapshot.steering->faceFlags};
    // What was turned to the axes, or upright, is not turned away from there.
    pack.options.rotation = straight::StraightPlan::of(snapshot).rotation(options.rotation);
    pack.options.seed = snapshot.settings.seed;
    if (snapshot.keepTiles && snapshot.uv)
        pack.tiles = udimTiles(mesh, *snapshot.uv, options.tileHeight());
    pack.stays.assign(mesh.faceCount(), false);
    for (int face = 0; snapshot.scope && face < mesh.faceCount(); ++face)
        pack.stays[face] = !snapshot.scope->faces[face];
    for (const Pin &pin : snapshot.steering->pins)
        pack.stays[mesh.triangleFace[pin.soupCorner / 3]] = true;
    for (const UvRectangle &box : snapshot.steering->rectangles) {
        PackRectangle rectangle{{Vec2(snapshot.uvScale * box.lower), Vec2(snapshot.uvScale * box.upper)},
                                std::vector<bool>(mesh.faceCount(), false)};
        for (const int corner : box.soupCorners)
            rectangle.faces[mesh.triangleFace[corner / 3]] = true;
        pack.rectangles.push_back(std::move(rectangle));
    }
    return pack;
}

double marginGap(const packing::PackOptions &options)
{
    return (1 - lostByRounding) * options.margin / options.textureSize;
}

int movingCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack)
{
    return BinPacker(mesh, charts, pack).movingCharts(charts);
}

double keptGap(const MeshData &mesh, const PackJob &pack, const UvMatrix &before)
{
    return BinPacker(mesh, findCharts(mesh, before), pack).keptGap(before);
}

bool onlyRectangles(const PackJob &pack)
{
    if (pack.rectangles.empty() || std::ranges::find(pack.stays, true) != pack.stays.end() ||
        std::ranges::any_of(pack.faceFlags, [](const IslandFlags &flags) { return flags.locked != 0; }))
        return false;
    const std::size_t faces = pack.rectangles.front().faces.size();
    for (std::size_t face = 0; face < faces; ++face) {
        if (std::ranges::none_of(pack.rectangles,
                                 [&](const PackRectangle &rectangle) { return rectangle.faces[face]; }))
            return false;
    }
    return true;
}

bool packCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                const JobContext &job)
{
    return BinPacker(mesh, charts, pack).run(uv, job);
}

bool packAround(const MeshData &mesh, const ChartMap &charts, PackJob pack, const std::vector<bool> &faces,
                UvMatrix &uv, const JobContext &job)
{
    pack.stays.resize(faces.size());
    for (std::size_t face = 0; face < faces.size(); ++face)
        pack.stays[face] = pack.stays[face] || !faces[face];
    pack.options.keepScale = true;
    return packCharts(mesh, charts, pack, uv, job);
}

bool packTilesOf(const MeshData &mesh, const ChartMap &charts, PackJob pack, const std::vector<bool> &faces,
                 UvMatrix &uv, const JobContext &job)
{
    std::set<int> tiles;
    for (std::size_t face = 0; face < pack.tiles.size(); ++face) {
        if (faces[face])
            tiles.insert(pack.tiles[face]);
    }
    pack.stays.resize(faces.size());
    for (std::size_t face = 0; face < pack.tiles.size(); ++face)
        pack.stays[face] = pack.stays[face] || !tiles.contains(pack.tiles[face]);
    return packCharts(mesh, charts, pack, uv, job);
}

namespace {

bool packWithoutOthers(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                       const std::vector<bool> &misplaced, UvMatrix &uv, const JobContext &job)
{
    if (std::ranges::find(misplaced, true) == misplaced.end())
        return true;
    PackJob unturned = pack;
    unturned.options.rotation = PackRotation::None;
    return packAround(mesh, charts, unturned, misplaced, uv, job) ||
           packAround(mesh, charts, pack, misplaced, uv, job);
}

} // namespace

bool packOnlyMisplaced(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                       const JobContext &job)
{
    return packWithoutOthers(mesh, charts, pack, misplacedFaces(mesh, charts, pack, uv, job), uv, job);
}

bool packMisplaced(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                   const JobContext &job)
{
    const std::vector<bool> misplaced = misplacedFaces(mesh, charts, pack, uv, job);
    return packWithoutOthers(mesh, charts, pack, misplaced, uv, job) ||
           packTilesOf(mesh, charts, pack, misplaced, uv, job);
}

std::vector<bool> misplacedFaces(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                                 const UvMatrix &uv, const JobContext &job)
{
    return BinPacker(mesh, charts, pack).misplaced(uv, job);
}

bool liesFree(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, const UvMatrix &uv,
              const JobContext &job)
{
    return BinPacker(mesh, charts, pack).lieFree(uv, job);
}

} // namespace autocuts::unwrap
