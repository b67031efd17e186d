#include "solver/packing/packmap.h"

#include "model/plain/udimtiles.h"

namespace autocuts::packing {

PackResult packMap(const MeshData &mesh, const RigidPieces &pieces, const PackOptions &settings,
                   DensityBasis basis, UvMatrix &uv, const JobContext &job)
{
    UvMatrix packed = uv;
    if (!settings.keepScale && basis != DensityBasis::Given)
        equalizeTexelDensity(mesh, pieces.pieces, packed, pieces.locked, basis);
    std::vector<PackIsland> islands = makePackIslands(mesh, packed, pieces.pieces, pieces.locked);
    for (std::size_t i = 0; i < islands.size(); ++i) {
        islands[i].upright = pieces.upright[i];
        islands[i].aligned = pieces.aligned[i];
    }
    const PackResult result = packIslands(islands, settings, job);
    if (result.complete) {
        applyPlacements(result, mesh, pieces.pieces, packed, pieces.locked);
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
