#include "model/io/meshfile.h"

#include "model/io/assimpreader.h"
#include "model/io/assimpscene.h"
#include "model/io/assimpwriter.h"
#include "model/io/fbxreader.h"
#include "model/io/fbxrewriter.h"
#include "model/io/fbxtwin.h"
#include "model/io/fbxwriter.h"
#include "model/io/objreader.h"
#include "model/io/objwriter.h"
#include "model/io/savefile.h"

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

Result<Done> writeAs(const Scene &scene, const QString &path)
{
    const QString suffix = suffixOf(path);
    if (suffix == QLatin1String("obj"))
        return writeObj(scene, path);
    const FbxSource *fbx = fbxSourceOf(scene);
    if (fbx && suffix == QLatin1String("fbx"))
        return saveAtomically(path, rewriteFbx(*fbx, scene));
    if (suffix == QLatin1String("fbx") && !isFromAssimp(scene))
        return saveAtomically(path, fbxBytes(scene));
    const std::optional<Scene> twin = fbx ? assimpTwin(scene, *fbx) : std::nullopt;
    return writeWithAssimp(twin ? *twin : scene, path);
}

} // namespace

QStringList readableFormats()
{
    return QStringLiteral("obj ply stl off gltf glb fbx dae 3ds blend").split(QLatin1Char(' '));
}

QStringList writableFormats()
{
    return QStringLiteral("obj glb gltf dae fbx ply").split(QLatin1Char(' '));
}

Result<Scene> readMesh(const QString &path, const std::atomic<bool> *stop)
{
    const QString suffix = suffixOf(path);
    if (!readableFormats().contains(suffix))
        return unknownFormat(path, readableFormats(), QStringLiteral("read"));
    try {
        if (suffix == QLatin1String("obj"))
            return readObj(path, stop);
        return suffix == QLatin1String("fbx") ? readFbx(path, stop) : readWithAssimp(path, stop);
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

Result<Done> writeMesh(const Scene &scene, const QString &path)
{
    if (Result<Done> format = checkWriteFormat(path); !format)
        return format;
    try {
        return writeAs(scene, path);
    } catch (const std::bad_alloc &) {
        return outOfMemory(path);
    }
}

} // namespace autocuts
