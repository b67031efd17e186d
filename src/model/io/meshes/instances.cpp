#include "model/io/meshes/instances.h"

#include "model/io/formats/filesource.h"
#include "model/plain/unionfind.h"
#include "model/plain/uvseams.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! \param unique those only that stay shared where the scene wants unique ones
std::vector<SharedMesh> sharedMeshes(const Scene &scene, bool unique)
{
    const FileSource *source = sourceOf(scene);
    return source ? source->sharedMeshes(unique) : std::vector<SharedMesh>();
}

} // namespace

bool hasSharedMeshes(const Scene &scene)
{
    return sharedMeshes(scene, false).size() > sharedMeshes(scene, true).size();
}

Scene asWritten(const Scene &scene, const QString &format, double tileHeight)
{
    const FileSource *source = sourceOf(scene);
    const bool keeps = source && source->rewriter(format == QLatin1String("acproj") ? scene.format : format);
    return keeps ? source->asRewritten(scene, tileHeight) : scene;
}

std::vector<IslandFlags> withInstanceStacks(const Scene &scene, std::vector<IslandFlags> flags)
{
    const std::vector<SharedMesh> meshes = sharedMeshes(scene, scene.uniqueMeshes);
    if (meshes.empty() || !scene.hasUv())
        return flags;
    const MeshData &mesh = *scene.mesh;
    const UvMatrix &uv = scene.uvSets.front().uv;
    flags.resize(static_cast<std::size_t>(mesh.faceCount()));
    std::int32_t stack = 0;
    for (const IslandFlags &flag : flags)
        stack = std::max(stack, flag.stack);
    UnionFind charts(mesh.faceCount());
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto &triangle = mesh.edgePairs[e].triangle;
        if (!open[2 * e] && !open[2 * e + 1])
            charts.unite(mesh.triangleFace[triangle[0]], mesh.triangleFace[triangle[1]]);
    }
    for (const SharedMesh &shared : meshes) {
        std::map<int, std::int32_t> stackOf; // by the island of the first instance
        const SharedMesh::Instance &first = shared.instances.front();
        for (int f = 0; f < shared.faceCount; ++f) {
            const auto [place, isNew] = stackOf.try_emplace(charts.find(first.firstFace + f), stack + 1);
            stack += isNew ? 1 : 0;
            for (const SharedMesh::Instance &instance : shared.instances) {
                IslandFlags &flag = flags[static_cast<std::size_t>(instance.firstFace + f)];
                if (flag.stack == 0)
                    flag.stack = place->second;
            }
        }
    }
    return flags;
}

} // namespace autocuts
