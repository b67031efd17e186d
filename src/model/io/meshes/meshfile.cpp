#include "model/io/meshes/meshfile.h"

#include "model/io/assimp/assimpmatch.h"
#include "model/io/assimp/assimpreader.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/assimp/assimpwriter.h"
#include "model/io/collada/colladasource.h"
#include "model/io/fbx/fbxassimpscene.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxrewriter.h"
#include "model/io/fbx/fbxwriter.h"
#include "model/io/files/savefile.h"
#include "model/io/gltf/gltfnodes.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfwriter.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/tilescaling.h"
#include "model/io/obj/objreader.h"
#include "model/io/obj/objwriter.h"

#include <QFileInfo>

#include <new>

namespace autocuts {

namespace {

QString suffixOf(const QString &path)
{
    return QFileInfo(path).suffix().toLower();
}

Error unknownFormat(const QString &path, const QStringList &formats, const QString &verb)
{
    const QString suffix = suffixOf(path);
    const QString what = suffix.isEmpty() ? QStringLiteral("a file without a suffix")
                                          : QStringLiteral("the format \"%1\"").arg(suffix);
    return {QStringLiteral("%1 cannot be %2").arg(what, verb), path, 0,
            QStringLiteral("Supported are %1").arg(formats.join(QLatin1String(", ")))};
}

Error outOfMemory(const QString &path)
{
    return {QStringLiteral("there is not enough memory for this model"), path, 0,
            QStringLiteral("Close other programs or split the model into several files")};
}

//! The scene as Assimp reads it from the same file, so that formats that Assimp writes get what else is in
//! it. The scene as it is when Assimp reads other polygons.
Scene forAssimp(const Scene &scene)
{
    try {
        GltfFile file{sourceAsGlb(*gltfSourceOf(scene)), {}};
        const auto complete = [&](aiScene &, AssimpSource &made) {
            made.limbs = jointNames(openGltf(file).json);
        };
        return asAssimpReads(scene, file.main, QStringLiteral("glb"), Eigen::Matrix4d::Identity(), complete)
            .value_or(scene);
    } catch (const GltfError &) {
        return scene;
    }
}

Result<Done> writeAs(const Scene &scene, const QString &path)
{
    const QString suffix = suffixOf(path);
    if (scene.uniqueMeshes && keepsSharedMeshes(scene, suffix)) {
        const Result<Scene> unique = withUniqueMeshes(scene);
        return unique ? writeAs(unique.value(), path) : unique.error();
    }
    if (suffix == QLatin1String("obj"))
        return writeObj(scene, path);
    const FbxSource *fbx = fbxSourceOf(scene);
    if (fbx && suffix == QLatin1String("fbx"))
        return saveAtomically(path, rewriteFbx(*fbx, scene));
    if (suffix == QLatin1String("fbx"))
        return saveAtomically(path, fbxBytes(gltfSourceOf(scene) ? forAssimp(scene) : scene, path));
    if (isGltfFormat(suffix) && gltfSourceOf(scene))
        return writeGltf(scene, path);
    if (suffix == QLatin1String("dae") && colladaSourceOf(scene))
        return writeCollada(scene, path);
    if (gltfSourceOf(scene))
        return writeWithAssimp(forAssimp(scene), path);
    const std::optional<Scene> twin = fbx ? assimpTwin(scene, *fbx) : std::nullopt;
    return writeWithAssimp(twin ? *twin : scene, path);
}

Result<Scene> readAs(const QString &suffix, const QString &path, const std::atomic<bool> *stop)
{
    if (suffix == QLatin1String("obj"))
        return readObj(path, stop);
    if (suffix == QLatin1String("fbx"))
        return readFbx(path, stop);
    if (isGltfFormat(suffix))
        return readGltf(path, stop);
    Result<Scene> scene = readWithAssimp(path, stop);
    if (scene && suffix == QLatin1String("dae"))
        keepCollada(scene.value());
    return scene;
}

} // namespace

Result<Scene> readMesh(const QString &path, const std::atomic<bool> *stop, double tileHeight)
{
    const QString suffix = suffixOf(path);
    if (!readableFormats().contains(suffix))
        return unknownFormat(path, readableFormats(), QStringLiteral("read"));
    try {
        Result<Scene> scene = readAs(suffix, path, stop);
        if (scene && tileHeight != 1)
            scaleFromFile(scene.value(), tileHeight);
        return scene;
    } catch (const std::bad_alloc &) {
        return outOfMemory(path);
    }
}

Result<Done> checkWriteFormat(const QString &path)
{
    const QString suffix = suffixOf(path);
    if (suffix == QLatin1String("stl"))
        return Error{QStringLiteral("STL files cannot hold UVs"), path, 0,
                     QStringLiteral("Save as one of %1").arg(writableFormats().join(QLatin1String(", ")))};
    if (!writableFormats().contains(suffix))
        return unknownFormat(path, writableFormats(), QStringLiteral("written"));
    return Done{};
}

Result<Done> writeMesh(const Scene &scene, const QString &path, double tileHeight)
{
    if (Result<Done> format = checkWriteFormat(path); !format)
        return format;
    try {
        return tileHeight == 1 ? writeAs(scene, path) : writeAs(scaledForFile(scene, tileHeight), path);
    } catch (const std::bad_alloc &) {
        return outOfMemory(path);
    }
}

} // namespace autocuts
