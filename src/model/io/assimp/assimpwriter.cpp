#include "model/io/assimp/assimpwriter.h"

#include "model/io/files/savefile.h"
#include "model/io/formats/modelunits.h"

#include <assimp/Exporter.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <exception>
#include <memory>

namespace autocuts {

namespace {

constexpr const char *companionBase = "autocuts-buffer";

//! Exports to a blob that belongs to the exporter; nullptr on failure.
const aiExportDataBlob *exportBlob(Assimp::Exporter &exporter, const ExportScene &exported,
                                   const AssimpFormat &format)
{
    Assimp::ExportProperties properties;
    properties.SetPropertyString(AI_CONFIG_EXPORT_BLOB_NAME, companionBase);
    return exporter.ExportToBlob(exported.get(), format.exporter, 0, &properties);
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

Result<Done> writeWithAssimp(const Scene &scene, const QString &path, const AssimpFormat &format)
{
    ExportOptions options = format.options;
    try {
        Assimp::Exporter exporter;
        auto exported = std::make_unique<ExportScene>(scene, options);
        const aiExportDataBlob *blob = exportBlob(exporter, *exported, format);
        if (!blob && options.animations) {
            // Some animations cannot be expressed by an exporter. Then the model is written without them.
            options.animations = false;
            exported = std::make_unique<ExportScene>(scene, options);
            blob = exportBlob(exporter, *exported, format);
        }
        if (!blob)
            return notWritten(path, QString::fromUtf8(exporter.GetErrorString()));
        QByteArray bytes(static_cast<const char *>(blob->data), static_cast<qsizetype>(blob->size));
        if (format.complete)
            bytes = format.complete(*exported, std::move(bytes));
        FileSet files;
        if (options.looks) {
            if (Result<Done> added = options.looks->addFiles(files); !added)
                return added;
        }
        if (Result<Done> added = files.add(path, bytes); !added)
            return added;
        return files.putInPlace();
    } catch (const std::exception &e) {
        return notWritten(path, QString::fromUtf8(e.what()));
    }
}

Result<Done> writePly(const Scene &scene, const QString &path)
{
    // As text: Assimp's binary variant writes colours in another type than its header declares.
    AssimpFormat ply{"ply", {}, {}};
    ply.options.units = unitsOfFormat(QStringLiteral("ply"));
    return writeWithAssimp(scene, path, ply);
}

} // namespace autocuts
