#include "solver/unwrap/tilepacking.h"

#include "model/plain/rigidpieces.h"
#include "model/plain/udimtiles.h"
#include "solver/packing/islandgeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace autocuts::unwrap {

namespace {

using packing::PackIsland;
using packing::PackOptions;
using packing::PackPlacement;
using packing::PackResult;

// Chosen by hand, by the number of tiles that some maps need and the time for it.
//! How often islands are tried in a tile, each time with what the attempt before says that there is room for.
constexpr int tileAttempts = 5;
constexpr double moreArea = 1.15, lessArea = 0.95; //!< of the next attempt, at least and at most
//! Smaller islands are then put between them: those below these shares of the room that is left.
constexpr std::array topUpShares{0.25, 0.06, 0.015};
constexpr double topUpRoom = 0.7;
constexpr double topUpEffort = 0.1; //!< seconds, see PackingSettings::effort
constexpr int topUpAttempts = 4;

//! Where a piece goes: p' = scale * R(angle) * p + translation.
struct Move
{
    double scale = 1;
    PackPlacement placement;
};

Vec2 moved(const Move &move, const Vec2 &point)
{
    return move.scale * (Eigen::Rotation2Dd(move.placement.angle) * point) + move.placement.translation;
}

//! Sums over the triangles of a piece.
struct PieceSize
{
    double uvArea = 0, target = 0; //!< target: see MeshData::targetArea()
    double room = 0;               //!< area that it takes of a tile; the islands of a stack share it
    Eigen::AlignedBox2d box;
};

std::vector<PieceSize> sizesOf(const MeshData &mesh, const ChartMap &pieces, const UvMatrix &uv)
{
    std::vector<PieceSize> sizes(pieces.count);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int piece = pieces.faceChart[mesh.triangleFace[t]];
        if (piece < 0)
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        for (const int corner : mesh.triangles[t])
            sizes[piece].box.extend(Vec2(uv.row(corner)));
        sizes[piece].uvArea += std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)))) / 2;
        sizes[piece].target += mesh.targetArea(t);
    }
    for (PieceSize &size : sizes)
        size.room = size.box.isEmpty() ? 0 : std::min(size.uvArea, size.box.volume());
    return sizes;
}

RigidPieces piecesOf(const MeshData &mesh, const ChartMap &charts, const PackJob &pack)
{
    std::vector<IslandFlags> flags = pack.faceFlags;
    flags.resize(mesh.faceCount());
    RigidPieces rigid = rigidPieces(charts, flags, pack.movable);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int piece = rigid.pieces.faceChart[face];
        if (piece >= 0 && !pack.stays.empty() && pack.stays[face])
            rigid.locked[piece] = true;
    }
    return rigid;
}

//! Distributes the pieces, tile by tile.
class TilePacker
{
public:
    TilePacker(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, const TilePacking &tiles,
               const UvMatrix &uv, const JobContext &job)
        : mMesh(mesh), mPack(pack), mTiles(tiles), mJob(job), mUv(uv)
    {
        mRigid = piecesOf(mesh, charts, pack);
        scaleToDensity();
        mIslands = packing::makePackIslands(mesh, mUv, mRigid.pieces, mRigid.locked);
        for (int piece = 0; piece < mRigid.pieces.count; ++piece) {
            mIslands[piece].upright = mRigid.upright[piece];
            mIslands[piece].aligned = mRigid.aligned[piece];
            if (!mRigid.locked[piece])
                mLeft.push_back(piece);
        }
        mMoves.resize(mIslands.size());
        std::stable_sort(mLeft.begin(), mLeft.end(),
                         [&](int a, int b) { return mSizes[a].room > mSizes[b].room; });
    }

    TilePackingResult run()
    {
        TilePackingResult result;
        result.packed = static_cast<int>(mLeft.size());
        const auto all = mLeft.size();
        std::set<int> used;
        int next = mTiles.firstTile;
        for (std::size_t number = 0; !mLeft.empty(); ++number) {
            const bool given = number < mTiles.tilesFirst.size();
            if (!given && number > mTiles.tilesFirst.size())
                ++next;
            const int tile = given ? mTiles.tilesFirst[number] : next;
            if (tile > PackingSettings::lastTile)
                return ended(TilePackingResult::Outcome::TooMany);
            if (!given && std::find(mTiles.tilesFirst.begin(), mTiles.tilesFirst.end(), tile) !=
                              mTiles.tilesFirst.end())
                continue;
            const std::size_t before = mLeft.size();
            if (!fill(tile, result))
                return ended(mJob.stopped() ? TilePackingResult::Outcome::Stopped
                                            : TilePackingResult::Outcome::NoRoom);
            if (mLeft.size() < before)
                used.insert(tile);
            mJob.report(1 - static_cast<double>(mLeft.size()) / static_cast<double>(all));
        }
        result.tiles.assign(used.begin(), used.end());
        applyMoves();
        result.uv = std::move(mUv);
        return result;
    }

private:
    static TilePackingResult ended(TilePackingResult::Outcome outcome)
    {
        TilePackingResult result;
        result.outcome = outcome;
        return result;
    }

    void scaleToDensity()
    {
        mSizes = sizesOf(mMesh, mRigid.pieces, mUv);
        std::vector<double> factors(mSizes.size(), 1);
        for (std::size_t piece = 0; mTiles.density > 0 && piece < mSizes.size(); ++piece) {
            PieceSize &size = mSizes[piece];
            if (mRigid.locked[piece] || !(size.uvArea > 0) || !(size.target > 0))
                continue;
            factors[piece] =
                mTiles.density / mPack.options.textureSize / std::sqrt(size.uvArea / size.target);
            size.room *= factors[piece] * factors[piece];
        }
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece < 0 || factors[piece] == 1)
                continue;
            const Vec2 middle = mSizes[piece].box.center();
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                mUv.row(c) = middle + factors[piece] * (Vec2(mUv.row(c)) - middle);
        }
    }

    //! The largest pieces that together have no more than this area, of those from a place on.
    std::vector<int> largest(std::size_t from, double area) const
    {
        std::vector<int> chosen;
        for (std::size_t i = from; i < mLeft.size(); ++i) {
            if (const double own = mSizes[mLeft[i]].room; own <= area) {
                area -= own;
                chosen.push_back(mLeft[i]);
            }
        }
        return chosen;
    }

    //! What lies in a tile: pieces that stay, and those that were placed there.
    std::vector<PackIsland> obstaclesIn(const Eigen::AlignedBox2d &tile, const std::vector<int> &placed) const
    {
        std::vector<PackIsland> obstacles;
        for (std::size_t piece = 0; piece < mIslands.size(); ++piece) {
            if (mRigid.locked[piece] && mSizes[piece].box.intersects(tile))
                obstacles.push_back(mIslands[piece]);
        }
        for (const int piece : placed) {
            obstacles.push_back(mIslands[piece]);
            obstacles.back().locked = true;
            for (Vec2 &point : obstacles.back().points)
                point = moved(mMoves[piece], point);
        }
        return obstacles;
    }

    //! Packs pieces into a tile around what lies there, at their size or at the largest one that is found.
    PackResult packInto(const Eigen::AlignedBox2d &tile, const std::vector<int> &pieces,
                        const std::vector<PackIsland> &obstacles, double effort, bool keepScale) const
    {
        PackOptions options = mPack.options;
        options.lower = tile.min();
        options.upper = tile.max();
        options.keepScale = keepScale;
        options.effort = std::min(options.effort, effort);
        const bool hurried = mPack.hurry == PackHurry::WhenStopped && mJob.stopped();
        if (hurried)
            options.effort = 0;
        std::vector<PackIsland> islands;
        for (const int piece : pieces)
            islands.push_back(mIslands[piece]);
        islands.insert(islands.end(), obstacles.begin(), obstacles.end());
        return packing::packIslands(islands, options, hurried ? mJob.unstoppable() : mJob.quiet());
    }

    //! True when the pieces fit into a tile at their size; then they have their places.
    bool place(const std::vector<int> &pieces, const Eigen::AlignedBox2d &tile,
               const std::vector<PackIsland> &obstacles, double effort)
    {
        const PackResult packed = packInto(tile, pieces, obstacles, effort, true);
        for (std::size_t i = 0; packed.complete && i < pieces.size(); ++i)
            mMoves[pieces[i]] = {1, packed.placements[i]};
        return packed.complete;
    }

    void take(const std::vector<int> &pieces)
    {
        const std::set<int> taken(pieces.begin(), pieces.end());
        std::erase_if(mLeft, [&](int piece) { return taken.contains(piece); });
    }

    double areaOf(const std::vector<int> &pieces) const
    {
        return std::accumulate(pieces.begin(), pieces.end(), 0.0,
                               [&](double sum, int piece) { return sum + mSizes[piece].room; });
    }

    //! Packs as many of the pieces from a place on as fit into the room; which they are.
    std::vector<int> packMost(std::size_t from, const Eigen::AlignedBox2d &tile, double room,
                              const std::vector<PackIsland> &obstacles, double effort, int attempts)
    {
        std::vector<int> best, last;
        double most = 0, least = std::numeric_limits<double>::infinity(); // areas that did and did not fit
        double area = room;
        for (int attempt = 0; attempt < attempts && !ends(); ++attempt) {
            const std::vector<int> pieces = largest(from, area);
            if (pieces.empty() || pieces == last)
                break;
            last = pieces;
            area = areaOf(pieces);
            const std::vector<Move> before = mMoves;
            if (place(pieces, tile, obstacles, effort)) {
                best = pieces;
                most = area;
                if (from + pieces.size() == mLeft.size())
                    break;
                area = std::isfinite(least) ? (most + least) / 2 : moreArea * area;
            } else {
                mMoves = before;
                least = area;
                // What there is room for, by the scale at which they would fit.
                const double scale = packInto(tile, pieces, obstacles, effort, false).scale;
                area *= std::min(scale * scale, lessArea);
                if (area <= most)
                    area = (most + least) / 2;
            }
        }
        return best;
    }

    bool ends() const { return mJob.stopped() && mPack.hurry != PackHurry::WhenStopped; }

    //! Puts smaller pieces between those that a tile has.
    void topUp(const Eigen::AlignedBox2d &tile, double room, std::vector<int> &packed)
    {
        take(packed);
        for (const double share : topUpShares) {
            const auto small = std::find_if(mLeft.begin(), mLeft.end(),
                                            [&](int piece) { return mSizes[piece].room <= share * room; });
            if (small == mLeft.end() || ends())
                continue;
            const std::vector<int> more =
                packMost(static_cast<std::size_t>(small - mLeft.begin()), tile, topUpRoom * room,
                         obstaclesIn(tile, packed), topUpEffort, topUpAttempts);
            room -= areaOf(more);
            packed.insert(packed.end(), more.begin(), more.end());
            take(more);
        }
    }

    //! Fills a tile. False when stopped, or when nothing fits into a tile at all.
    bool fill(int number, TilePackingResult &result)
    {
        const Eigen::AlignedBox2d tile = udimTile(number, mPack.options.tileHeight());
        const std::vector<PackIsland> obstacles = obstaclesIn(tile, {});
        double room = tile.volume();
        for (std::size_t piece = 0; piece < mIslands.size(); ++piece) {
            if (mRigid.locked[piece] && mSizes[piece].box.intersects(tile))
                room -= mSizes[piece].room;
        }
        const double effort = mPack.options.effort;
        std::vector<int> packed = packMost(0, tile, room, obstacles, effort, tileAttempts);
        // Where the largest do not fit between what lies there, smaller ones may.
        if (packed.empty() && obstacles.empty() && !ends()) {
            packed = {mLeft.front()};
            if (!placeAlone(packed.front(), tile, result))
                return false;
        }
        topUp(tile, room - areaOf(packed), packed);
        return !ends();
    }

    //! Packs a piece into an empty tile: at its size or, when it is larger than a tile, at the one that fits.
    bool placeAlone(int piece, const Eigen::AlignedBox2d &tile, TilePackingResult &result)
    {
        const PackResult packed = packInto(tile, {piece}, {}, mPack.options.effort, false);
        if (!packed.complete)
            return false;
        Move &move = mMoves[piece];
        move = {packed.scale, packed.placements.front()};
        if (packed.scale < 1) {
            mSizes[piece].room *= packed.scale * packed.scale;
            ++result.tooLarge;
        } else { // not enlarged, around the same middle
            const Vec2 middle = mSizes[piece].box.center();
            const Vec2 place = moved(move, middle);
            move = {1, {move.placement.angle, Vec2::Zero()}};
            move.placement.translation = place - moved(move, middle);
        }
        return true;
    }

    void applyMoves()
    {
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            const int piece = mRigid.pieces.faceChart[face];
            if (piece < 0 || mRigid.locked[piece])
                continue;
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                mUv.row(c) = moved(mMoves[piece], Vec2(mUv.row(c)));
        }
    }

    const MeshData &mMesh;
    const PackJob &mPack;
    const TilePacking &mTiles;
    const JobContext &mJob;
    UvMatrix mUv; //!< at the density
    RigidPieces mRigid;
    std::vector<PieceSize> mSizes;    //!< per piece
    std::vector<PackIsland> mIslands; //!< per piece
    std::vector<Move> mMoves;         //!< per piece
    std::vector<int> mLeft;           //!< pieces without a tile, the largest first
};

} // namespace

TilePacking fillingTiles(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                         const UvMatrix &uv)
{
    const RigidPieces rigid = piecesOf(mesh, charts, pack);
    std::vector<bool> stays(mesh.faceCount());
    double uvArea = 0, target = 0;
    for (int face = 0; face < mesh.faceCount(); ++face)
        stays[face] = rigid.pieces.faceChart[face] >= 0 && rigid.locked[rigid.pieces.faceChart[face]];
    const std::vector<PieceSize> sizes = sizesOf(mesh, rigid.pieces, uv);
    for (std::size_t piece = 0; piece < sizes.size(); ++piece) {
        if (rigid.locked[piece]) {
            uvArea += sizes[piece].uvArea;
            target += sizes[piece].target;
        }
    }
    TilePacking tiles;
    tiles.tilesFirst = usedTiles(islandTiles(mesh, charts, uv, pack.options.tileHeight()), stays);
    tiles.firstTile = tiles.tilesFirst.empty() ? pack.options.udimTile : tiles.tilesFirst.back() + 1;
    if (!pack.options.keepScale && uvArea > 0 && target > 0)
        tiles.density = pack.options.textureSize * std::sqrt(uvArea / target);
    return tiles;
}

TilePackingResult packOverTiles(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                                const TilePacking &tiles, const UvMatrix &uv, const JobContext &job)
{
    return TilePacker(mesh, charts, pack, tiles, uv, job).run();
}

} // namespace autocuts::unwrap
