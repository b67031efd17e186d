#include "model/io/meshes/meshfile.h"

#include "model/io/formats/tilescaling.h"
#include "model/io/meshes/formatcalls.h"

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
    const FileSource *source = sourceOf(scene);
    const SceneWriter rewrite = source ? source->rewriter(suffix) : nullptr;
    if (rewrite && scene.uniqueMeshes) {
        Scene unique = scene;
        Result<std::shared_ptr<const FileSource>> file = source->withUniqueMeshes(scene.path);
        if (!file)
            return file.error();
        unique.uniqueMeshes = false;
        if (file.value())
            unique.source = std::move(file).value();
        return rewrite(unique, path);
    }
    if (rewrite)
        return rewrite(scene, path);
    const FormatCalls &format = callsOf(suffix);
    const auto read = source && format.takesNodes ? source->asAssimpReads(scene) : std::nullopt;
    return format.write(read ? *read : scene, path);
}

} // namespace

Result<Scene> readMesh(const QString &path, const std::atomic<bool> *stop, double tileHeight)
{
    const QString suffix = suffixOf(path);
    if (!readableFormats().contains(suffix))
        return unknownFormat(path, readableFormats(), QStringLiteral("read"));
    try {
        Result<Scene> scene = callsOf(suffix).read(path, stop);
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
