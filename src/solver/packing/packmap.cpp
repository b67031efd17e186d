#include "solver/packing/packmap.h"

#include "solver/packing/islandgeometry.h"

namespace autocuts::packing {

PackResult packMap(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &locked,
                   const PackSettings &settings, UvMatrix &uv, const std::atomic<bool> *cancel,
                   const std::function<void(double)> &progress)
{
    UvMatrix packed = uv;
    if (!settings.keepScale)
        equalizeTexelDensity(mesh, charts, packed, locked);
    PackResult result =
        packIslands(makePackIslands(mesh, packed, charts, locked), settings, cancel, progress);
    if (result.complete) {
        applyPlacements(result, mesh, charts, packed, locked);
        uv = std::move(packed);
    }
    return result;
}

Vec2 tileCorner(int udim)
{
    constexpr int first = 1001, perRow = 10;
    return {(udim - first) % perRow, (udim - first) / perRow};
}

} // namespace autocuts::packing
