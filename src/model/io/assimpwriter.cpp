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

//! Assimp's name of the exporter. Its binary FBX cannot be read back, and ASCII PLY rounds.
const char *exporterId(const QString &suffix)
{
    if (suffix == QLatin1String("glb"))
        return "glb2";
    if (suffix == QLatin1String("gltf"))
        return "gltf2";
    if (suffix == QLatin1String("ply"))
        return "plyb";
    if (suffix == QLatin1String("dae"))
        return "collada";
    return "fbxa";
}

QByteArrayView bytesOf(const aiExportDataBlob &blob)
{
    return {static_cast<const char *>(blob.data), static_cast<qsizetype>(blob.size)};
}

constexpr const char *companionBase = "autocuts-buffer";

//! A gltf file with its one buffer inside: two files cannot be replaced at once, and a name in it would have
//! to be escaped in a way that not every reader undoes.
QByteArray withEmbeddedBuffer(const aiExportDataBlob &main)
{
    QByteArray text = bytesOf(main).toByteArray();
    const QByteArray name = QByteArray(companionBase) + ".bin";
    text.replace('"' + name + '"', "\"data:application/octet-stream;base64," +
                                       bytesOf(*main.next).toByteArray().toBase64() + '"');
    return text;
}

Error notWritten(const QString &path, const QString &reason)
{
    return {QStringLiteral("the model cannot be written in this format: %1").arg(reason.simplified()), path,
            0, QStringLiteral("Save it in another format, for example as OBJ")};
}

} // namespace

Result<Done> writeWithAssimp(const Scene &scene, const QString &path)
{
    const QFileInfo info(path);
    const QString suffix = info.suffix().toLower();
    try {
        const ExportScene exported(scene, suffix == QLatin1String("glb") || suffix == QLatin1String("gltf"));
        Assimp::Exporter exporter;
        Assimp::ExportProperties properties;
        properties.SetPropertyString(AI_CONFIG_EXPORT_BLOB_NAME, companionBase);
        const aiExportDataBlob *blob =
            exporter.ExportToBlob(exported.get(), exporterId(suffix), 0, &properties);
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
