#include "model/io/meshes/instances.h"

#include "model/io/collada/colladasource.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxrewriter.h"
#include "model/io/fbx/fbxuniquemeshes.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfsource.h"
#include "model/io/gltf/gltfuniquemeshes.h"
#include "model/io/meshes/tilescaling.h"
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

//! The instances of a mesh, the first of which is the one that glTF and Collada files get the map from.
struct SharedMesh
{
    int faceCount = 0;
    std::vector<Instance> instances;
};

//! Where a piece of the soup is in a file: a mesh, and a part of it.
using MeshPlace = std::pair<std::size_t, std::size_t>;

//! The meshes that objects share. \param unique those only that stay shared where the scene wants unique ones
std::vector<SharedMesh> sharedMeshes(const Scene &scene, bool unique)
{
    std::vector<SharedMesh> meshes;
    std::map<MeshPlace, SharedMesh> known;
    const auto add = [&known](const MeshPlace &place, const auto &piece) {
        SharedMesh &mesh = known[place];
        mesh.faceCount = piece.faceCount;
        mesh.instances.push_back({piece.firstFace, piece.mirrored});
    };
    if (const FbxSource *fbx = fbxSourceOf(scene)) {
        for (const FbxUse &use : fbx->uses) {
            if (unique && hasCopyableGeometries(*fbx))
                break;
            SharedMesh mesh{use.faceCount, {}};
            for (const FbxUse::Instance &instance : use.instances)
                mesh.instances.push_back({instance.firstFace, instance.mirrored});
            meshes.push_back(std::move(mesh));
        }
    } else if (const GltfSource *gltf = gltfSourceOf(scene)) {
        for (const GltfPiece &piece : gltf->pieces) {
            if (!unique)
                add({piece.mesh, piece.primitive}, piece);
        }
    } else if (const ColladaSource *collada = colladaSourceOf(scene)) {
        for (std::size_t p = 0; p < collada->pieces.size(); ++p) {
            const ColladaPlace &place = collada->places[p];
            if (!unique || place.url == 0)
                add({place.geometry, place.primitive}, collada->pieces[p]);
        }
    }
    for (auto &[place, mesh] : known)
        meshes.push_back(std::move(mesh));
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

bool hasSharedMeshes(const Scene &scene)
{
    return sharedMeshes(scene, false).size() > sharedMeshes(scene, true).size();
}

bool keepsSharedMeshes(const Scene &scene, const QString &format)
{
    if (fbxSourceOf(scene))
        return format == QLatin1String("fbx");
    if (gltfSourceOf(scene))
        return isGltfFormat(format);
    return colladaSourceOf(scene) && format == QLatin1String("dae");
}

Result<Scene> withUniqueMeshes(const Scene &scene)
{
    Scene result = scene;
    result.uniqueMeshes = false;
    try {
        if (const FbxSource *fbx = fbxSourceOf(scene); fbx && hasCopyableGeometries(*fbx)) {
            Result<QByteArray> bytes = withUniqueGeometries(*fbx, scene.path);
            const Result<Scene> file =
                bytes ? parseFbx(std::move(bytes).value(), scene.path) : Result<Scene>(bytes.error());
            if (!file)
                return file.error();
            result.source = file->source;
        } else if (const GltfSource *gltf = gltfSourceOf(scene)) {
            const Result<Scene> file = parseGltf(withUniqueMeshes(gltf->file), scene.path);
            if (!file)
                return file.error();
            auto source = std::make_shared<GltfSource>(*gltfSourceOf(file.value()));
            source->firstCopy = 0;
            for (const GltfPiece &piece : gltf->pieces)
                source->firstCopy = std::max(source->firstCopy, piece.mesh + 1);
            result.source = std::move(source);
        } else if (const ColladaSource *collada = colladaSourceOf(scene)) {
            result.source = withUniqueGeometries(*collada);
        }
    } catch (const GltfError &e) {
        return Error{QStringLiteral("the meshes cannot be made unique: %1").arg(QString::fromUtf8(e.what())),
                     scene.path, 0, QStringLiteral("Save it in another format, for example as OBJ")};
    }
    return result;
}

Scene asWritten(const Scene &original, const QString &format, double tileHeight)
{
    const QString suffix = format == QLatin1String("acproj") ? original.format : format;
    const FbxSource *fbx = fbxSourceOf(original);
    const std::vector<SharedMesh> meshes = sharedMeshes(original, original.uniqueMeshes);
    Scene result = original;
    if (meshes.empty() || !keepsSharedMeshes(original, suffix) ||
        (fbx && !hasUnequalInstances(*fbx, original)))
        return result;
    if (!fbx) {
        for (const SharedMesh &shared : meshes) {
            for (UvSet &set : result.uvSets)
                eachCopy(*original.mesh, shared,
                         [&set](int to, int from) { set.uv.row(to) = set.uv.row(from); });
        }
        return result;
    }
    Result<Scene> file = parseFbx(rewriteFbx(*fbx, scaledForFile(original, tileHeight)), original.path);
    if (!file)
        return result;
    scaleFromFile(file.value(), tileHeight);
    for (UvSet &set : result.uvSets) {
        const auto same = [&set](const UvSet &other) { return other.name == set.name; };
        const auto found = std::ranges::find_if(file->uvSets, same);
        if (found != file->uvSets.end() && found->uv.rows() == set.uv.rows())
            set.uv = found->uv;
    }
    return result;
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
