#include "jobs/packmap.h"

#include "solver/unwrap/tilepacking.h"

namespace autocuts::jobs {

namespace {

using Kind = Remark::Kind;

PackedMap failed(const Remark &why)
{
    return {{}, {{}, {why}}};
}

PackedMap packOverTiles(const MeshData &mesh, const ChartMap &charts, const unwrap::PackJob &pack,
                        const PackChoice &choice, const UvMatrix &uv, const JobContext &job)
{
    using Outcome = unwrap::TilePackingResult::Outcome;
    unwrap::TilePacking tiles;
    tiles.firstTile = choice.firstTile;
    if (choice.fillTiles)
        tiles = unwrap::fillingTiles(mesh, charts, pack, uv);
    if (choice.density > 0)
        tiles.density = choice.density;
    unwrap::TilePackingResult packed = unwrap::packOverTiles(mesh, charts, pack, tiles, uv, job);
    switch (packed.outcome) {
    case Outcome::Done:
        break;
    case Outcome::Stopped:
        return failed({Kind::MapCancelled});
    case Outcome::NoRoom:
        return failed(noRoom(pack.options.keepScale));
    case Outcome::TooMany:
        return failed({Kind::TooManyTiles});
    }
    PackedMap result{std::move(packed.uv), {}};
    result.remarks.notes.push_back({Kind::IslandsPacked, double(packed.packed), {}, packed.tiles});
    if (packed.tooLarge > 0)
        result.remarks.problems.push_back({Kind::LargerThanTile, double(packed.tooLarge)});
    return result;
}

} // namespace

PackedMap packMap(const MeshData &mesh, ChartMap charts, unwrap::PackJob pack, const PackChoice &choice,
                  const UvMatrix &uv, const JobContext &job)
{
    pack.options.keepStraight = true;
    charts = dividedByObjects(std::move(charts), choice.groups);
    if (choice.density > 0 || choice.fillTiles)
        return packOverTiles(mesh, charts, pack, choice, uv, job);
    if (!choice.groups.empty()) {
        pack.tiles = tilesOfGroups(choice.groups, charts, choice.firstTile);
        if (pack.tiles.empty())
            return failed({Kind::TooManyGroups});
    }
    const int count = unwrap::movingCharts(mesh, charts, pack);
    PackedMap result{uv, {}};
    if (!unwrap::packCharts(mesh, charts, pack, result.uv, job))
        return failed(job.stopped() ? Remark{Kind::MapCancelled} : noRoom(pack.options.keepScale));
    result.remarks.notes.push_back({Kind::IslandsPacked, double(count)});
    return result;
}

} // namespace autocuts::jobs
