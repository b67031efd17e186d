#include "commands/newmap.h"

#include "model/plain/uvlayout.h"

#include <algorithm>

namespace autocuts {

namespace {

//! The number of the map's islands that are not as they are in the document.
int changedIslands(const Document &document, const UvMatrix &uv)
{
    const MeshData &mesh = document.mesh();
    const Islands islands(mesh, uv);
    std::vector<bool> changed(islands.count(), false);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[face], count = mesh.faceStart[face + 1] - first;
        if (const int island = islands.islandOfFace(face); island >= 0 && !changed[island])
            changed[island] = !sameBits(uv.middleRows(first, count), document.uv().middleRows(first, count));
    }
    return static_cast<int>(std::count(changed.begin(), changed.end(), true));
}

} // namespace

std::unique_ptr<SetUvs> newMapCommand(Document &document, UvEdit edit, const UvMatrix &uv,
                                      std::optional<int> count, const std::vector<IslandFlags> &flags)
{
    UvEditExtras extras;
    extras.flags = flags;
    extras.count = count ? *count : changedIslands(document, uv);
    if (sameBits(uv, document.uv()))
        return std::make_unique<SetUvs>(document, edit, uv, extras);
    extras.scale = layoutScale(document.mesh(), uv);
    return std::make_unique<SetUvs>(document, edit, uv, extras);
}

} // namespace autocuts
