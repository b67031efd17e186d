#include "model/pictures/texturefiles.h"

#include "model/document/documentstate.h"
#include "model/io/files/meshlimits.h"
#include "model/io/files/savefile.h"
#include "model/plain/packingsettings.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <set>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QLatin1StringView token = "<UDIM>"_L1;
//! Numbers without <UDIM> are those of tiles only in the first ten rows, since years and sizes look alike.
constexpr int lastPlainTile = 1100;
//! What more tiles could hold is not looked for. Chosen by hand.
constexpr int lastKnownTile = 2000;

//! What stands before and after the number of a tile.
struct TileName
{
    QString before, after;
    int last = 0; //!< numbers above are none of tiles
};

std::optional<TileName> tileName(const QString &name)
{
    if (const qsizetype at = name.indexOf(token, 0, Qt::CaseInsensitive); at >= 0)
        return TileName{name.first(at), name.sliced(at + token.size()), lastKnownTile};
    static const QRegularExpression numbered(u"^(.*[._])(\\d{4})(\\.[^.]+)$"_s);
    const QRegularExpressionMatch match = numbered.match(name);
    const int number = match.captured(2).toInt();
    if (number < PackingSettings::firstTile || number > lastPlainTile)
        return std::nullopt;
    return TileName{match.captured(1), match.captured(3), lastPlainTile};
}

QString withoutDots(const QString &path)
{
    return QDir::cleanPath(QFileInfo(path).absoluteFilePath());
}

bool isThere(const QString &path, FolderNames *folders)
{
    if (QFileInfo(path).isFile())
        return true;
    return tileName(QFileInfo(path).fileName()) && !textureTiles(path, folders).empty();
}

} // namespace

const std::vector<QString> &FolderNames::in(const QString &folder)
{
    const auto [found, isNew] = mNames.try_emplace(folder);
    if (isNew) {
        const QStringList names = QDir(folder).entryList(QDir::Files, QDir::Unsorted);
        found->second.assign(names.begin(), names.end());
        std::ranges::sort(found->second);
    }
    return found->second;
}

std::vector<TextureTile> textureTiles(const QString &path, FolderNames *folders)
{
    const QFileInfo file(path);
    std::vector<TextureTile> tiles;
    FolderNames own;
    if (const std::optional<TileName> name = tileName(file.fileName())) {
        const std::vector<QString> &names = (folders ? *folders : own).in(file.path());
        const qsizetype length = name->before.size() + 4 + name->after.size();
        for (auto other = std::ranges::lower_bound(names, name->before);
             other != names.end() && other->startsWith(name->before); ++other) {
            if (other->size() != length || !other->endsWith(name->after))
                continue;
            bool ok = false;
            const int number = QStringView(*other).sliced(name->before.size(), 4).toInt(&ok);
            if (ok && number >= PackingSettings::firstTile && number <= name->last)
                tiles.push_back({number, file.dir().filePath(*other)});
        }
    } else if (file.isFile()) {
        tiles.push_back({0, path});
    }
    return tiles;
}

QString findTexture(const QString &named, const QString &modelPath, FolderNames *folders)
{
    const QString spelled = QString(named).replace(u'\\', u'/').trimmed();
    const QString name = QFileInfo(spelled).fileName();
    if (name.isEmpty())
        return {};
    const QFileInfo model(modelPath);
    const QDir folder = model.dir();
    const QString parent = withoutDots(folder.filePath(u".."_s));
    QStringList candidates;
    const bool relative = QDir::isRelativePath(spelled) && !spelled.contains(u':');
    if (const QString path = withoutDots(folder.filePath(spelled));
        relative && path.startsWith(parent.endsWith(u'/') ? parent : parent + u'/'))
        candidates << path;
    candidates << folder.filePath(name);
    for (const QString &usual : {u"textures"_s, u"Textures"_s, u"maps"_s, u"images"_s,
                                 model.completeBaseName() + u".fbm"_s, u"../textures"_s})
        candidates << folder.filePath(usual + u'/' + name);
    const auto found = std::ranges::find_if(
        candidates, [folders](const QString &candidate) { return isThere(candidate, folders); });
    return found == candidates.end() ? QString() : QDir::cleanPath(*found);
}

std::vector<int> usedMaterials(const Scene &scene)
{
    if (scene.faceMaterial.empty())
        return {-1};
    const std::set<int> used(scene.faceMaterial.begin(), scene.faceMaterial.end());
    return {used.begin(), used.end()};
}

bool hasTextures(const DocumentState &state)
{
    for (int material = -1; material < std::ssize(state.scene.materialNames); ++material) {
        const TextureSet set = state.textureSet(material);
        if (std::ranges::any_of(set, [](const auto &entry) { return !entry.second.picture.isEmpty(); }))
            return true;
    }
    return false;
}

bool isChosenTexture(const DocumentState &state, int material, TextureChannel channel)
{
    const auto place = static_cast<std::size_t>(material + 1);
    if (place >= state.textureSets.size())
        return false;
    const auto found = state.textureSets[place].find(channel);
    return found != state.textureSets[place].end() && !found->second.fromModel;
}

Scene withChosenTextures(Scene scene, const std::vector<TextureSet> &sets)
{
    const std::size_t materials = scene.materialNames.size();
    const QDir folder = QFileInfo(scene.path).absoluteDir();
    for (std::size_t place = 1; place < std::min(sets.size(), materials + 1); ++place) {
        for (const auto &[channel, entry] : sets[place]) {
            const QString path = texturePath(entry.picture.file, true, scene.path);
            if (entry.fromModel || path.isEmpty() || textureTiles(path).empty())
                continue;
            ChannelPicture chosen = entry;
            const QString relative = folder.relativeFilePath(QFileInfo(path).absoluteFilePath());
            if (findTexture(relative, scene.path) == QDir::cleanPath(folder.filePath(relative))) {
                chosen.picture = {relative, {}};
            } else if (Result<QByteArray> content = loadFile(path, maxMeshFileSize)) {
                chosen.picture = {QFileInfo(path).fileName(), std::move(content).value()};
            } else {
                continue;
            }
            scene.materialTextures.resize(materials);
            scene.materialSets.resize(materials);
            if (channel == TextureChannel::BaseColor)
                scene.materialTextures[place - 1] = chosen.picture;
            else
                scene.materialSets[place - 1][channel] = chosen;
        }
    }
    return scene;
}

QString texturePath(const QString &file, bool chosen, const QString &modelPath, FolderNames *folders)
{
    if (file.isEmpty() || (chosen && !textureTiles(file, folders).empty()))
        return file;
    const QString found = findTexture(file, modelPath, folders);
    return found.isEmpty() && chosen ? file : found;
}

} // namespace autocuts
