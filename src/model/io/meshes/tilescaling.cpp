#include "model/io/meshes/tilescaling.h"

#include "model/io/collada/colladasource.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxsource.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/obj/objsource.h"

#include <algorithm>

namespace autocuts {

namespace {

//! The UV sets of the scene's file; empty when the scene does not hold its file.
std::vector<UvSet> setsInFile(const Scene &scene)
{
    if (const auto *obj = dynamic_cast<const ObjSource *>(scene.source.get()))
        return {{scene.uvSets.empty() ? QString() : scene.uvSets.front().name, obj->originalUv()}};
    if (const ColladaSource *collada = colladaSourceOf(scene))
        return collada->uvSets;
    const FbxSource *fbx = fbxSourceOf(scene);
    const GltfSource *gltf = gltfSourceOf(scene);
    if (!fbx && !gltf)
        return {};
    Result<Scene> read = fbx ? parseFbx(fbx->bytes, scene.path) : parseGltf(gltf->file, scene.path);
    return read ? std::move(read->uvSets) : std::vector<UvSet>();
}

//! Divides v. Where the product of the file's v has the same bits, v is that of the file.
void scaleBack(UvMatrix &uv, const UvMatrix *inFile, double tileHeight)
{
    for (Eigen::Index row = 0; row < uv.rows(); ++row) {
        const bool isThere = inFile && (*inFile)(row, 1) * tileHeight == uv(row, 1);
        uv(row, 1) = isThere ? (*inFile)(row, 1) : uv(row, 1) / tileHeight;
    }
}

} // namespace

void scaleFromFile(Scene &scene, double tileHeight)
{
    for (UvSet &set : scene.uvSets)
        set.uv.col(1) *= tileHeight;
}

Scene scaledForFile(const Scene &scene, double tileHeight)
{
    Scene result = scene;
    if (tileHeight == 1)
        return result;
    const std::vector<UvSet> inFile = setsInFile(scene);
    for (UvSet &set : result.uvSets) {
        const auto same = std::find_if(inFile.begin(), inFile.end(), [&](const UvSet &other) {
            return other.name == set.name && other.uv.rows() == set.uv.rows();
        });
        scaleBack(set.uv, same == inFile.end() ? nullptr : &same->uv, tileHeight);
    }
    return result;
}

} // namespace autocuts
