#include "model/io/instances.h"

#include "model/io/fbxreader.h"
#include "model/io/fbxrewriter.h"
#include "model/io/gltf/gltfsource.h"
#include "model/plain/unionfind.h"
#include "model/plain/uvseams.h"

#include <algorithm>
#include <map>
#include <optional>

namespace autocuts {

namespace {

//! A range of faces that shows a mesh.
struct Instance
{
    int firstFace = 0;
    bool mirrored = false;
};

//! The instances of a mesh, the first of which is the one that glTF files get the map from.
struct SharedMesh
{
    int faceCount = 0;
    std::vector<Instance> instances;
};

std::vector<SharedMesh> sharedMeshes(const Scene &scene)
{
    std::vector<SharedMesh> meshes;
    if (const FbxSource *fbx = fbxSourceOf(scene)) {
        for (const FbxUse &use : fbx->uses) {
            SharedMesh mesh{use.faceCount, {}};
            for (const FbxUse::Instance &instance : use.instances)
                mesh.instances.push_back({instance.firstFace, instance.mirrored});
            meshes.push_back(std::move(mesh));
        }
    } else if (const GltfSource *gltf = gltfSourceOf(scene)) {
        std::map<std::pair<std::size_t, std::size_t>, SharedMesh> known;
        for (const GltfPiece &piece : gltf->pieces) {
            SharedMesh &mesh = known[{piece.mesh, piece.primitive}];
            mesh.faceCount = piece.faceCount;
            mesh.instances.push_back({piece.firstFace, piece.mirrored});
        }
        for (auto &[number, mesh] : known)
            meshes.push_back(std::move(mesh));
    }
    std::erase_if(meshes, [](const SharedMesh &mesh) { return mesh.instances.size() < 2; });
    return meshes;
}

//! Calls take(corner of an instance, that of the first instance) for all corners of the others.
template <typename Take>
void eachCopy(const MeshData &mesh, const SharedMesh &shared, const Take &take)
{
    const Instance &first = shared.instances.front();
    for (std::size_t i = 1; i < shared.instances.size(); ++i) {
        const Instance &other = shared.instances[i];
        for (int f = 0; f < shared.faceCount; ++f) {
            const int from = mesh.faceStart[first.firstFace + f], to = mesh.faceStart[other.firstFace + f];
            const int size = mesh.faceStart[first.firstFace + f + 1] - from;
            for (int k = 0; k < size; ++k)
                take(to + (first.mirrored == other.mirrored ? k : size - 1 - k), from + k);
        }
    }
}

} // namespace

Scene asWritten(const Scene &scene, const QString &format)
{
    Scene result = scene;
    const FbxSource *fbx = fbxSourceOf(scene);
    if (fbx && format == QLatin1String("fbx") && hasUnequalInstances(*fbx, scene)) {
        const Result<Scene> file = parseFbx(rewriteFbx(*fbx, scene), scene.path);
        for (UvSet &set : result.uvSets) {
            const auto same = [&set](const UvSet &other) { return other.name == set.name; };
            const auto found = file ? std::ranges::find_if(file->uvSets, same) : file->uvSets.end();
            if (file && found != file->uvSets.end() && found->uv.rows() == set.uv.rows())
                set.uv = found->uv;
        }
    } else if (isGltfFormat(format) && gltfSourceOf(scene)) {
        for (const SharedMesh &shared : sharedMeshes(scene)) {
            for (UvSet &set : result.uvSets)
                eachCopy(*scene.mesh, shared,
                         [&set](int to, int from) { set.uv.row(to) = set.uv.row(from); });
        }
    }
    return result;
}

std::vector<IslandFlags> withInstanceStacks(const Scene &scene, std::vector<IslandFlags> flags)
{
    const std::vector<SharedMesh> meshes = sharedMeshes(scene);
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
        const Instance &first = shared.instances.front();
        for (int f = 0; f < shared.faceCount; ++f) {
            const auto [place, isNew] = stackOf.try_emplace(charts.find(first.firstFace + f), stack + 1);
            stack += isNew ? 1 : 0;
            for (const Instance &instance : shared.instances) {
                IslandFlags &flag = flags[static_cast<std::size_t>(instance.firstFace + f)];
                if (flag.stack == 0)
                    flag.stack = place->second;
            }
        }
    }
    return flags;
}

} // namespace autocuts
