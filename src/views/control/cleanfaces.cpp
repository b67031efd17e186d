#include "views/control/cleanfaces.h"

#include "model/document.h"
#include "solver/overlap/cleanregion.h"
#include "views/control/shownmap.h"

namespace autocuts {

QList<int> cleanFaces(const Document &document, const ShownMap &shownMap, int triangle)
{
    const MeshData &mesh = document.mesh();
    if (!shownMap.uv().middleRows(3 * triangle, 3).allFinite())
        return {};
    std::vector<bool> cut(mesh.edgePairs.size());
    for (std::size_t e = 0; e < cut.size(); ++e)
        cut[e] = !mesh.edgePairs[e].diagonal && shownMap.isSeam(static_cast<int>(e));
    QList<int> faces;
    for (int t : cleanRegion(mesh, shownMap.uv(), cut, triangle)) {
        // The triangles of a face follow each other.
        if (faces.isEmpty() || faces.last() != mesh.triangleFace[t])
            faces << mesh.triangleFace[t];
    }
    return faces;
}

} // namespace autocuts
