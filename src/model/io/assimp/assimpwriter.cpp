#include "model/io/assimp/assimpwriter.h"

#include "model/io/assimp/assimpscene.h"
#include "model/io/assimp/assimpviews.h"
#include "model/io/collada/assimpanimations.h"
#include "model/io/files/savefile.h"
#include "model/io/gltf/assimpgltf.h"
#include "model/io/gltf/gltffile.h"
#include "model/io/gltf/gltfsource.h"

#include <QFileInfo>
#include <QtEndian>

#include <assimp/Exporter.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <exception>
#include <memory>

namespace autocuts {

namespace {

//! Assimp's id of the exporter for a suffix. PLY is written as text: its binary variant writes colours in
//! another type than its header declares.
const char *exporterId(const QString &suffix)
{
    if (suffix == QLatin1String("ply"))
        return "ply";
    return suffix == QLatin1String("dae") ? "collada" : "glb2";
}

QByteArrayView bytesOf(const aiExportDataBlob &blob)
{
    return {static_cast<const char *>(blob.data), static_cast<qsizetype>(blob.size)};
}

constexpr const char *companionBase = "autocuts-buffer";

//! The bytes of a .glb file with a text in UTF-8: names may be none, and make a file that programs refuse.
QByteArray withUtf8(const QByteArray &glb)
{
    constexpr qsizetype head = 12, text = 20; // where the length of the text and the text begin
    if (glb.size() < text)
        return glb;
    const auto length = qFromLittleEndian<quint32>(glb.constData() + head);
    QByteArray utf8 = QString::fromUtf8(glb.mid(text, length)).toUtf8();
    utf8.append(-utf8.size() & 3, ' ');
    QByteArray result =
        glb.first(head) + QByteArray(4, 0) + glb.mid(head + 4, 4) + utf8 + glb.mid(text + length);
    qToLittleEndian(static_cast<quint32>(utf8.size()), result.data() + head);
    qToLittleEndian(static_cast<quint32>(result.size()), result.data() + 8);
    return result;
}

//! What Assimp wrote as .glb, with what it leaves out, as the bytes of a file. The buffer of a .gltf file is
//! inside of it: two files cannot be replaced atomically.
QByteArray gltfBytes(const Scene &scene, const ExportScene &exported, const aiExportDataBlob &blob,
                     const QString &path)
{
    GltfFile file{withUtf8(bytesOf(blob).toByteArray()), {}};
    GltfDocument document = openGltf(file);
    const bool binary = QFileInfo(path).suffix().toLower() == QLatin1String("glb");
    completeGltf(document, scene, exported, path);
    if (binary)
        return glbBytes(std::move(document));
    for (std::size_t b = 0; b < document.buffers.size(); ++b)
        document.json["buffers"][b]["uri"] = dataUri(document.buffers[b]);
    return jsonText(document.json, "{\n  \n");
}

//! The names of the UV sets in the place of those that Assimp gives to their sources: <source id="...-texN"
//! name="...">.
QByteArray withUvSetNames(const QByteArray &text, const Scene &scene)
{
    static const QByteArray key = "<source id=\"";
    QByteArray named;
    qsizetype copied = 0;
    for (qsizetype at = text.indexOf(key); at >= 0; at = text.indexOf(key, at)) {
        at += key.size();
        const qsizetype idEnd = text.indexOf('"', at), first = text.indexOf("name=\"", idEnd) + 6;
        const QByteArray id = text.mid(at, idEnd - at);
        const qsizetype tag = id.lastIndexOf("-tex");
        bool isNumber = false;
        const std::size_t set = tag < 0 ? 0 : id.mid(tag + 4).toUInt(&isNumber);
        if (!isNumber || first < 6 || set >= scene.uvSets.size())
            continue;
        named += text.mid(copied, first - copied) + scene.uvSets[set].name.toHtmlEscaped().toUtf8();
        copied = text.indexOf('"', first);
    }
    return named + text.mid(copied);
}

//! The text with a fixed date instead of that of now: the same model gives the same bytes.
QByteArray withFixedDate(QByteArray text)
{
    for (const QByteArray &name : {QByteArray("created"), QByteArray("modified")}) {
        const QByteArray tag = '<' + name + '>';
        const qsizetype at = text.indexOf(tag), end = text.indexOf("</" + name + '>', at);
        if (at >= 0 && end >= 0)
            text.replace(at + tag.size(), end - at - tag.size(), "1970-01-01T00:00:00");
    }
    return text;
}

//! What Assimp wrote as Collada, with what it leaves out: materials of joined meshes, the names of the UV
//! sets, views and an animation.
QByteArray colladaBytes(const Scene &scene, const ExportScene &exported, const aiExportDataBlob &blob)
{
    // Names that are no UTF-8 would make a file that programs refuse.
    const QByteArray bytes = withFixedDate(QString::fromUtf8(bytesOf(blob)).toUtf8());
    const std::string whole = withMaterials({bytes.constData(), std::size_t(bytes.size())}, exported.parts());
    const std::string views = withViews(whole, *exported.get(), isGltfFormat(scene.format));
    const std::string bones = withBareBones(views, exported.bareBones());
    const QByteArray text = withUvSetNames(QByteArray::fromStdString(bones), scene);
    if (const auto *source = dynamic_cast<const AssimpSource *>(scene.source.get()))
        return QByteArray::fromStdString(
            withAnimations({text.constData(), std::size_t(text.size())}, *source->scene, exported.changes()));
    return text;
}

//! Exports to a blob that belongs to the exporter; nullptr on failure.
const aiExportDataBlob *exportBlob(Assimp::Exporter &exporter, const ExportScene &exported,
                                   const QString &suffix)
{
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
    MaterialLooks looks(scene, path);
    if (suffix == QLatin1String("dae"))
        options.looks = &looks;
    try {
        Assimp::Exporter exporter;
        auto exported = std::make_unique<ExportScene>(scene, options);
        const aiExportDataBlob *blob = exportBlob(exporter, *exported, suffix);
        if (!blob && options.animations) {
            // Some animations cannot be expressed by an exporter. Then the model is written without them.
            options.animations = false;
            exported = std::make_unique<ExportScene>(scene, options);
            blob = exportBlob(exporter, *exported, suffix);
        }
        if (!blob)
            return notWritten(path, QString::fromUtf8(exporter.GetErrorString()));
        if (isGltfFormat(suffix))
            return saveAtomically(path, gltfBytes(scene, *exported, *blob, path));
        FileSet files;
        if (Result<Done> added = looks.addFiles(files); !added)
            return added;
        const QByteArray bytes = suffix == QLatin1String("dae") ? colladaBytes(scene, *exported, *blob)
                                                                : bytesOf(*blob).toByteArray();
        if (Result<Done> added = files.add(path, bytes); !added)
            return added;
        return files.putInPlace();
    } catch (const std::exception &e) {
        return notWritten(path, QString::fromUtf8(e.what()));
    }
}

} // namespace autocuts
