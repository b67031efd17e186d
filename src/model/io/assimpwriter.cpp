#include "model/io/assimpwriter.h"

#include "model/io/assimpscene.h"
#include "model/io/savefile.h"

#include <QFileInfo>

#include <assimp/Exporter.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <exception>

namespace autocuts {

namespace {

//! Assimp's id of the exporter for a suffix. Text variants are used for FBX and PLY: Assimp cannot read its
//! own binary FBX, and its binary PLY writes colours in another type than its header declares.
const char *exporterId(const QString &suffix)
{
    if (suffix == QLatin1String("glb"))
        return "glb2";
    if (suffix == QLatin1String("gltf"))
        return "gltf2";
    if (suffix == QLatin1String("ply"))
        return "ply";
    if (suffix == QLatin1String("dae"))
        return "collada";
    return "fbxa";
}

QByteArrayView bytesOf(const aiExportDataBlob &blob)
{
    return {static_cast<const char *>(blob.data), static_cast<qsizetype>(blob.size)};
}

constexpr const char *companionBase = "autocuts-buffer";

//! Embeds the buffer of a glTF file as base64. Two files cannot be replaced atomically, and the name of a
//! buffer file would need escaping that some readers do not undo.
QByteArray withEmbeddedBuffer(const aiExportDataBlob &main)
{
    QByteArray text = bytesOf(main).toByteArray();
    const QByteArray name = QByteArray(companionBase) + ".bin";
    text.replace('"' + name + '"', "\"data:application/octet-stream;base64," +
                                       bytesOf(*main.next).toByteArray().toBase64() + '"');
    return text;
}

//! Exports to a blob that belongs to the exporter; nullptr on failure.
const aiExportDataBlob *exportBlob(Assimp::Exporter &exporter, const Scene &scene, const QString &suffix,
                                   const ExportOptions &options)
{
    const ExportScene exported(scene, options);
    Assimp::ExportProperties properties;
    properties.SetPropertyString(AI_CONFIG_EXPORT_BLOB_NAME, companionBase);
    return exporter.ExportToBlob(exported.get(), exporterId(suffix), 0, &properties);
}

Error notWritten(const QString &path, const QString &reason)
{
    const QString why = reason.isEmpty()
                            ? QStringLiteral("a name with a quotation mark, or data it has no room for")
                            : reason.simplified();
    return {QStringLiteral("the model cannot be written in this format: %1").arg(why), path, 0,
            QStringLiteral("Save it in another format, for example as OBJ")};
}

} // namespace

Result<Done> writeWithAssimp(const Scene &scene, const QString &path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    ExportOptions options = exportOptions(suffix);
    try {
        Assimp::Exporter exporter;
        const aiExportDataBlob *blob = exportBlob(exporter, scene, suffix, options);
        if (!blob && options.animations) {
            // Some animations cannot be expressed by an exporter. Then the model is written without them.
            options.animations = false;
            blob = exportBlob(exporter, scene, suffix, options);
        }
        if (!blob)
            return notWritten(path, QString::fromUtf8(exporter.GetErrorString()));
        if (blob->next)
            return saveAtomically(path, withEmbeddedBuffer(*blob));
        return saveAtomically(path, bytesOf(*blob));
    } catch (const std::exception &e) {
        return notWritten(path, QString::fromUtf8(e.what()));
    }
}

} // namespace autocuts
