#include "jobs/carriedsurface.h"

#include "jobs/shadedscene.h"
#include "model/plain/uvlayout.h"
#include "model/transfer/facematch.h"

#include <algorithm>

namespace autocuts {

CarriedSurface carriedSurface(const Scene &before, const Scene &after, double tileHeight)
{
    CarriedSurface from;
    const MeshData &old = *before.mesh, &fresh = *after.mesh;
    if (samePolygons(old, fresh)) {
        from.surface = shadedSurface(before, tileHeight);
        return from;
    }
    const FaceMatch match = matchFacesInPlace(old, fresh);
    const auto found = std::ranges::count_if(match.face, [](int face) { return face >= 0; });
    if (found < fresh.faceCount() || before.uvSets.empty()) {
        from.surface = shadedSurface(before, tileHeight);
        from.sameTriangles = false;
        return from;
    }
    Scene reordered = after;
    reordered.uvSets = {{QString(), emptyLayout(fresh)}};
    for (int corner = 0; corner < old.cornerCount(); ++corner) {
        if (match.corner[corner] >= 0)
            reordered.uvSets.front().uv.row(match.corner[corner]) = before.uvSets.front().uv.row(corner);
    }
    from.surface = shadedSurface(reordered, tileHeight);
    return from;
}

} // namespace autocuts
