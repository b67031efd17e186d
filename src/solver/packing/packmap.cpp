#include "solver/packing/packmap.h"

#include "model/plain/udimtiles.h"

namespace autocuts::packing {

PackResult packMap(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &locked,
                   const std::vector<bool> &upright, const PackOptions &settings, DensityBasis basis,
                   UvMatrix &uv, const JobContext &job)
{
    UvMatrix packed = uv;
    if (!settings.keepScale)
        equalizeTexelDensity(mesh, charts, packed, locked, basis);
    std::vector<PackIsland> islands = makePackIslands(mesh, packed, charts, locked);
    for (std::size_t i = 0; i < upright.size(); ++i)
        islands[i].upright = upright[i];
    const PackResult result = packIslands(islands, settings, job);
    if (result.complete) {
        applyPlacements(result, mesh, charts, packed, locked);
        uv = std::move(packed);
    }
    return result;
}

PackOptions tileOptions(const PackingSettings &settings)
{
    PackOptions options;
    static_cast<PackingSettings &>(options) = settings;
    const Eigen::AlignedBox2d tile = udimTile(settings.udimTile, settings.tileHeight());
    options.lower = tile.min();
    options.upper = tile.max();
    return options;
}

} // namespace autocuts::packing
