#include "jobs/carryplan.h"

#include "model/io/outputs/bakefiles.h"
#include "model/io/outputs/fileclashes.h"
#include "model/pictures/texturefiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

struct CarryTexts
{
    Q_DECLARE_TR_FUNCTIONS(CarriedTextures)
};

constexpr QLatin1StringView tileToken = "<UDIM>"_L1;

//! The names of channels in new files, as texturenames.h understands them.
QString nameOf(const std::vector<TextureChannel> &channels)
{
    using enum TextureChannel;
    if (channels.size() == 3 && channels.front() == Roughness)
        return u"ORM"_s;
    if (channels.size() > 1)
        return u"MetallicRoughness"_s;
    switch (channels.empty() ? BaseColor : channels.front()) {
    case BaseColor:
        return u"BaseColor"_s;
    case Roughness:
        return u"Roughness"_s;
    case Metalness:
        return u"Metallic"_s;
    case Normal:
        return u"Normal"_s;
    case Occlusion:
        return u"AO"_s;
    case Emission:
        return u"Emissive"_s;
    case Height:
        return u"Height"_s;
    }
    return {};
}

TextureKind kindOf(TextureChannel channel, const ChannelPicture &picture)
{
    if (channel == TextureChannel::Normal)
        return picture.flipped ? TextureKind::NormalDirectX : TextureKind::Normal;
    const bool color = channel == TextureChannel::BaseColor || channel == TextureChannel::Emission;
    return color ? TextureKind::Srgb : TextureKind::Linear;
}

//! The number of a tile before the suffix of a name, with the sign before it.
const QRegularExpression &tileNumber()
{
    static const QRegularExpression number(u"[._]1\\d{3}$"_s);
    return number;
}

QString withoutSigns(QString name)
{
    static const QRegularExpression signs(u"[^\\w .-]"_s, QRegularExpression::UseUnicodePropertiesOption);
    return name.replace(signs, u"_"_s);
}

//! The suffix of a file that is written for a source.
QString formatOf(const SceneTexture &source, const QString &wanted)
{
    if (!wanted.isEmpty())
        return wanted;
    QString suffix = QFileInfo(source.file).suffix().toLower();
    if (QStringList{u"png"_s, u"tif"_s, u"tiff"_s, u"tga"_s, u"exr"_s}.contains(suffix))
        return suffix;
    return suffix == "hdr"_L1 ? u"exr"_s : u"png"_s;
}

bool isTiled(const SceneTexture &source)
{
    const std::vector<TextureTile> tiles = textureTiles(source.file);
    return source.content.isEmpty() && !tiles.empty() && tiles.front().tile != 0;
}

//! The name of a new file, without its folder. \param fallback of pictures without a name
QString newName(const SceneTexture &source, const QString &fallback, const CarryTarget &target)
{
    const bool wasTiled = isTiled(source);
    QString stem = QFileInfo(QString(source.file).replace(u'\\', u'/')).completeBaseName();
    stem.remove(u"."_s + tileToken).remove(u"_"_s + tileToken).remove(tileToken);
    if (wasTiled)
        stem.remove(tileNumber());
    if (stem.isEmpty() || !source.content.isEmpty())
        stem = fallback;
    static const QRegularExpression number(u"\\d+$"_s);
    const QString word = QString(target.suffix).remove(number);
    if (!word.isEmpty())
        stem.remove(QRegularExpression(QRegularExpression::escape(word) + u"\\d*$"_s));
    const QString tile = wasTiled || target.tiled ? u"."_s + tileToken : QString();
    return withoutSigns(stem + target.suffix) + tile + u'.' + formatOf(source, target.format);
}

//! Gives the pictures names that differ.
void nameFiles(CarryPlan &plan, const std::vector<QString> &fallbacks, const CarryTarget &target)
{
    std::set<QString> taken;
    std::map<QString, int> numbers; // the last one of each name
    for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
        CarriedPicture &picture = plan.pictures[i];
        const QString name = newName(picture.source, fallbacks[i], target);
        QString free = name;
        int &number = numbers.try_emplace(name.toLower(), 1).first->second;
        while (!taken.insert(free.toLower()).second)
            free = QString(name).insert(name.indexOf(u'.'), u'_' + QString::number(++number));
        picture.newFile = QDir(target.folder).filePath(free);
    }
}

QString fallbackName(const Scene &scene, const CarriedPicture &picture)
{
    QStringList words{scene.path.isEmpty() ? u"model"_s : QFileInfo(scene.path).completeBaseName()};
    const int material = picture.materials.front();
    if (scene.materialNames.size() > 1 && material >= 0)
        words << scene.materialNames[static_cast<std::size_t>(material)];
    return (words << nameOf(picture.channels)).join(u'_');
}

} // namespace

QStringList CarryPlan::existingFiles() const
{
    QStringList files;
    for (const CarriedPicture &picture : pictures) {
        for (const TextureTile &tile : textureTiles(picture.newFile))
            files << tile.path;
    }
    files.removeDuplicates();
    return files;
}

QString CarryPlan::overwrittenSource() const
{
    const auto filesOf = [](const QString &path) {
        QStringList files{path};
        for (const TextureTile &tile : textureTiles(path))
            files << tile.path;
        return files;
    };
    std::set<QByteArray> sources;
    for (const CarriedPicture &picture : pictures) {
        if (!picture.source.content.isEmpty())
            continue;
        for (const QString &file : filesOf(picture.source.file))
            sources.insert(fileKey(file));
    }
    for (const CarriedPicture &picture : pictures) {
        for (const QString &file : filesOf(picture.newFile)) {
            if (sources.contains(fileKey(file)))
                return file;
        }
    }
    return {};
}

CarryPlan planCarrying(const DocumentState &state, const CarryTarget &target)
{
    CarryPlan plan;
    FolderNames folders;
    std::map<std::tuple<QString, QByteArray, TextureKind>, std::size_t> places; // in plan.pictures
    for (const int material : usedMaterials(state.scene)) {
        for (const auto &[channel, entry] : state.textureSet(material)) {
            SceneTexture source = entry.picture;
            if (source.isEmpty())
                continue;
            if (source.content.isEmpty()) {
                source.file = texturePath(source.file, isChosenTexture(state, material, channel),
                                          state.scene.path, &folders);
                if (textureTiles(source.file, &folders).empty()) {
                    plan.missing << QFileInfo(QString(entry.picture.file).replace(u'\\', u'/')).fileName();
                    continue;
                }
            }
            const TextureKind kind = kindOf(channel, entry);
            const auto [place, isNew] =
                places.try_emplace({source.file, source.content, kind}, plan.pictures.size());
            if (isNew)
                plan.pictures.push_back({source, kind, {}, {}, {}});
            CarriedPicture &same = plan.pictures[place->second];
            if (same.materials.empty() || same.materials.back() != material)
                same.materials.push_back(material);
            if (std::ranges::find(same.channels, channel) == same.channels.end())
                same.channels.push_back(channel);
        }
    }
    plan.missing.removeDuplicates();
    std::vector<QString> fallbacks;
    for (const CarriedPicture &picture : plan.pictures)
        fallbacks.push_back(fallbackName(state.scene, picture));
    nameFiles(plan, fallbacks, target);
    return plan;
}

CarryPlan planCarrying(const QStringList &files, const CarryTarget &target)
{
    CarryPlan plan;
    for (const QString &file : files) {
        if (textureTiles(file).empty())
            plan.missing << file;
        else
            plan.pictures.push_back({{file, {}}, textureKindOf(file, PictureDepth::Eight), {}, {}, {}});
    }
    nameFiles(plan, std::vector<QString>(plan.pictures.size()), target);
    return plan;
}

QString freeSuffix(const DocumentState &state, CarryTarget target)
{
    for (int number = 2;; ++number) {
        target.suffix = u"_uv%1"_s.arg(number);
        const CarryPlan plan = planCarrying(state, target);
        if (plan.existingFiles().isEmpty())
            return target.suffix;
    }
}

std::vector<TextureSet> carriedSets(const DocumentState &state, const CarryPlan &plan)
{
    std::vector<TextureSet> sets = state.textureSets;
    for (const CarriedPicture &picture : plan.pictures) {
        for (const int material : picture.materials) {
            const auto place = static_cast<std::size_t>(material) + 1;
            sets.resize(std::max(sets.size(), place + 1));
            for (const auto &[channel, entry] : state.textureSet(material)) {
                SceneTexture source = entry.picture;
                if (source.content.isEmpty())
                    source.file =
                        texturePath(source.file, isChosenTexture(state, material, channel), state.scene.path);
                if (!(source == picture.source) || kindOf(channel, entry) != picture.kind)
                    continue;
                ChannelPicture fresh = entry;
                fresh.picture = {picture.newFile, {}};
                fresh.fromModel = false;
                sets[place][channel] = fresh;
            }
        }
    }
    return sets;
}

QString fileOfTile(QString path, int tile)
{
    return path.replace(tileToken, QString::number(tile));
}

} // namespace autocuts::jobs
