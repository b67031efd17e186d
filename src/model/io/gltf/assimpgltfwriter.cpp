#include "model/io/gltf/assimpgltfwriter.h"

#include "model/io/assimp/assimpwriter.h"
#include "model/io/formats/modelunits.h"
#include "model/io/gltf/assimpgltf.h"

#include <QDir>
#include <QFileInfo>
#include <QtEndian>

namespace autocuts {

namespace {

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

//! What Assimp wrote as .glb, with what it leaves out, as the bytes of a file.
QByteArray completeNewGltf(const Scene &scene, const ExportScene &exported, const QByteArray &written,
                           const QString &path)
{
    GltfFile file{withUtf8(written), {}};
    GltfDocument document = openGltf(file);
    const bool binary = QFileInfo(path).suffix().toLower() == QLatin1String("glb");
    completeGltf(document, scene, exported, path);
    if (binary)
        return glbBytes(std::move(document));
    for (std::size_t b = 0; b < document.buffers.size(); ++b)
        document.json["buffers"][b]["uri"] = dataUri(document.buffers[b]);
    return jsonText(document.json, "{\n  \n");
}

} // namespace

Result<Done> writeNewGltf(const Scene &scene, const QString &path)
{
    AssimpFormat gltf{"glb2", {}, [&](const ExportScene &exported, const QByteArray &written) {
                          return completeNewGltf(scene, exported, written, path);
                      }};
    ExportOptions &options = gltf.options;
    options.triangulate = options.namesAllBones = options.weighsAll = options.linearColors = true;
    options.units = unitsOfFormat(QStringLiteral("glb"));
    return writeWithAssimp(scene, path, gltf);
}

QStringList filesBesideGltf(const Scene & /*scene*/, const QString &path)
{
    const QFileInfo info(path);
    if (info.suffix().toLower() != QLatin1String("gltf"))
        return {};
    return {info.dir().filePath(info.completeBaseName() + QStringLiteral(".bin"))};
}

} // namespace autocuts
