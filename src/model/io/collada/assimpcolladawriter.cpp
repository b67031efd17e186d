#include "model/io/collada/assimpcolladawriter.h"

#include "model/io/assimp/assimpviews.h"
#include "model/io/assimp/assimpwriter.h"
#include "model/io/collada/assimpanimations.h"
#include "model/io/formats/materiallooks.h"
#include "model/io/formats/meshformats.h"
#include "model/io/formats/modelunits.h"

namespace autocuts {

namespace {

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

//! What Assimp wrote, with what it leaves out: materials of joined meshes, the names of the UV sets, views
//! and an animation.
QByteArray completeCollada(const Scene &scene, const ExportScene &exported, const QByteArray &written)
{
    // Names that are no UTF-8 would make a file that programs refuse.
    const QByteArray bytes = withFixedDate(QString::fromUtf8(written).toUtf8());
    const std::string whole = withMaterials({bytes.constData(), std::size_t(bytes.size())}, exported.parts());
    const std::string views = withViews(whole, *exported.get(), isGltfFormat(scene.format));
    const std::string bones = withBareBones(views, exported.bareBones());
    const QByteArray text = withUvSetNames(QByteArray::fromStdString(bones), scene);
    if (const auto *source = sourceOf<AssimpSource>(scene))
        return QByteArray::fromStdString(
            withAnimations({text.constData(), std::size_t(text.size())}, *source->scene, exported.changes()));
    return text;
}

} // namespace

Result<Done> writeNewCollada(const Scene &scene, const QString &path)
{
    MaterialLooks looks(scene, path);
    AssimpFormat collada{"collada", {}, [&scene](const ExportScene &exported, const QByteArray &written) {
                             return completeCollada(scene, exported, written);
                         }};
    ExportOptions &options = collada.options;
    // Assimp cannot read back its own Collada files with animations: withAnimations() writes them.
    options.animations = false;
    options.bindsAtParent = options.joinsMaterials = true;
    options.laysOutSkeletons = options.namesAllBones = true;
    options.units = unitsOfFormat(QStringLiteral("dae"));
    options.looks = &looks;
    return writeWithAssimp(scene, path, collada);
}

QStringList filesBesideCollada(const Scene &scene, const QString &path)
{
    return MaterialLooks(scene, path).placeAll();
}

} // namespace autocuts
