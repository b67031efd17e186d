#include "model/io/formats/filesource.h"

namespace autocuts {

namespace {

//! Calls take(corner of an instance, that of the first instance) for all corners of the others.
template <typename Take>
void eachCopy(const MeshData &mesh, const SharedMesh &shared, const Take &take)
{
    const SharedMesh::Instance &first = shared.instances.front();
    for (std::size_t i = 1; i < shared.instances.size(); ++i) {
        const SharedMesh::Instance &other = shared.instances[i];
        for (int f = 0; f < shared.faceCount; ++f) {
            const int from = mesh.faceStart[first.firstFace + f], to = mesh.faceStart[other.firstFace + f];
            const int size = mesh.faceStart[first.firstFace + f + 1] - from;
            for (int k = 0; k < size; ++k)
                take(to + (first.mirrored == other.mirrored ? k : size - 1 - k), from + k);
        }
    }
}

} // namespace

std::vector<SharedMesh> severalTimesShown(std::vector<SharedMesh> meshes)
{
    std::erase_if(meshes, [](const SharedMesh &mesh) { return mesh.instances.size() < 2; });
    return meshes;
}

std::vector<SharedMesh> severalTimesShown(MeshesByPlace meshes)
{
    std::vector<SharedMesh> list;
    for (auto &[place, mesh] : meshes)
        list.push_back(std::move(mesh));
    return severalTimesShown(std::move(list));
}

Scene FileSource::asRewritten(const Scene &scene, double /*tileHeight*/) const
{
    Scene result = scene;
    for (const SharedMesh &shared : sharedMeshes(scene.uniqueMeshes)) {
        for (UvSet &set : result.uvSets)
            eachCopy(*scene.mesh, shared, [&set](int to, int from) { set.uv.row(to) = set.uv.row(from); });
    }
    return result;
}

} // namespace autocuts
