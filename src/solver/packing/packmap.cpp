#include "solver/packing/packmap.h"

#include "model/plain/udimtiles.h"
#include "solver/packing/islandgeometry.h"

namespace autocuts::packing {

PackResult packMap(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &locked,
                   const PackOptions &settings, UvMatrix &uv, const JobContext &job)
{
    UvMatrix packed = uv;
    if (!settings.keepScale)
        equalizeTexelDensity(mesh, charts, packed, locked);
    PackResult result = packIslands(makePackIslands(mesh, packed, charts, locked), settings, job);
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
    options.lower = udimCorner(settings.udimTile);
    options.upper = options.lower + Vec2::Ones();
    return options;
}

} // namespace autocuts::packing
