#include "views/control/editing/cleanfaces.h"

#include "model/document/document.h"
#include "solver/overlap/cleanhalf.h"
#include "solver/overlap/cleanregion.h"
#include "views/control/session/shownmap.h"

#include <algorithm>

namespace autocuts {

MapWithSeams::MapWithSeams(const Document &document, const ShownMap &shownMap)
    : mesh(document.state().scene.mesh), soupUv(shownMap.uv()), cut(mesh->edgePairs.size())
{
    for (std::size_t e = 0; e < cut.size(); ++e)
        cut[e] = !mesh->edgePairs[e].diagonal && shownMap.isSeam(static_cast<int>(e));
}

CleanPart cleanPart(const MapWithSeams &map, int triangle, const JobContext &job)
{
    if (!map.soupUv.middleRows(3 * triangle, 3).allFinite())
        return {};
    overlap::OverlapOptions options;
    options.job = job;
    std::vector<int> triangles = overlap::cleanHalf(*map.mesh, map.soupUv, map.cut, triangle, options);
    CleanPart part;
    part.restIsClean = !triangles.empty();
    if (triangles.empty())
        triangles = overlap::cleanRegion(*map.mesh, map.soupUv, map.cut, triangle, options);
    if (job.stopped())
        return {};
    for (int t : triangles) {
        // The triangles of a face are consecutive.
        if (part.faces.isEmpty() || part.faces.last() != map.mesh->triangleFace[t])
            part.faces << map.mesh->triangleFace[t];
    }
    std::sort(part.faces.begin(), part.faces.end());
    return part;
}

} // namespace autocuts
