#include "model/pictures/texturenames.h"

#include "model/pictures/picturefiles.h"
#include "model/pictures/texturefiles.h"
#include "model/plain/packingsettings.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

using Channel = TextureChannel;

struct Part
{
    Channel channel = Channel::BaseColor;
    int component = -1;
    bool flipped = false;
};

//! Names of channels, lower case and without what separates words.
const std::map<QString, std::vector<Part>> &channelNames()
{
    static const std::map<QString, std::vector<Part>> names = [] {
        std::map<QString, std::vector<Part>> result;
        const auto add = [&](Channel channel, const char *words, bool flipped = false) {
            for (const QString &word : QString::fromLatin1(words).split(u' '))
                result[word] = {{channel, -1, flipped}};
        };
        add(Channel::BaseColor,
            "basecolor basecolour base albedo alb diffuse diffusecolor diff dif color colour "
            "col bc d");
        add(Channel::Roughness, "roughness rough rgh");
        add(Channel::Roughness, "gloss glossiness smoothness", true);
        add(Channel::Metalness, "metallic metalness metal met");
        add(Channel::Normal, "normal normals normalmap norm nrm nor n normalgl normalopengl normalogl norgl "
                             "normalsgl");
        add(Channel::Normal, "normaldx normaldirectx nordx normalsdx normald3d", true);
        add(Channel::Occlusion, "ao occlusion ambientocclusion occ mixedao ambient");
        add(Channel::Emission, "emissive emission emissivecolor emissioncolor emit glow");
        add(Channel::Height, "height heightmap displacement disp bump");
        for (const char *word : {"orm", "arm", "aorm", "occlusionroughnessmetallic", "aoroughnessmetallic"})
            result[QLatin1StringView(word)] = {
                {Channel::Occlusion, 0}, {Channel::Roughness, 1}, {Channel::Metalness, 2}};
        for (const char *word : {"metallicroughness", "roughnessmetallic", "metalroughness", "metalrough"})
            result[QLatin1StringView(word)] = {{Channel::Roughness, 1}, {Channel::Metalness, 2}};
        result[u"rma"_s] = {{Channel::Roughness, 0}, {Channel::Metalness, 1}, {Channel::Occlusion, 2}};
        result[u"mra"_s] = {{Channel::Metalness, 0}, {Channel::Roughness, 1}, {Channel::Occlusion, 2}};
        return result;
    }();
    return names;
}

//! Words after the name of a channel that say something else: sizes, colour spaces, kinds of files, maps that
//! textures were carried over to.
bool saysNothing(const QString &word)
{
    static const QRegularExpression pattern(u"^(\\d{1,2}k|256|512|1024|2048|4096|8192|srgb|raw|linear|lin|"
                                            u"acescg|utility|jpg|png|exr|tif|bit|8bit|"
                                            u"16bit|32bit|map|tex|texture|uv\\d*)$"_s);
    return pattern.match(word.toLower()).hasMatch();
}

//! The longest name of a channel at the end of the words, which are taken away; empty when there is none.
std::vector<Part> takeChannel(QStringList &words)
{
    const std::map<QString, std::vector<Part>> &names = channelNames();
    for (qsizetype count = std::min<qsizetype>(3, words.size()); count > 0; --count) {
        const auto found = names.find(words.last(count).join(QString()).toLower());
        if (found == names.end())
            continue;
        words = words.first(words.size() - count);
        return found->second;
    }
    // Written together, as in woodBaseColor.
    const QString last = words.isEmpty() ? QString() : words.last();
    const std::pair<const QString, std::vector<Part>> *best = nullptr;
    for (const auto &entry : names) {
        const qsizetype size = entry.first.size();
        const bool fits = size >= 5 && last.size() > size && last[last.size() - size].isUpper() &&
                          last.endsWith(entry.first, Qt::CaseInsensitive);
        if (fits && (!best || size > best->first.size()))
            best = &entry;
    }
    if (!best)
        return {};
    words.last().chop(best->first.size());
    return best->second;
}

//! Letters and digits only, lower case.
QString plainName(const QString &name)
{
    QString result;
    for (const QChar c : name) {
        if (c.isLetterOrNumber())
            result += c.toLower();
    }
    return result;
}

//! The material with the longest name that is in the stem, or in which the stem is; -2 for none. All names
//! are plain.
int materialOf(const QString &plain, const std::vector<QString> &names)
{
    int best = -2;
    qsizetype length = 0;
    for (std::size_t m = 0; m < names.size(); ++m) {
        const QString &name = names[m];
        const bool same = name == plain, within = !name.isEmpty() && plain.contains(name),
                   around = plain.size() >= 3 && name.contains(plain);
        const qsizetype size = same ? 10000 : within ? name.size() : around ? 1 : 0;
        if (size > length) {
            best = static_cast<int>(m);
            length = size;
        }
    }
    return best;
}

//! Adds the channels that the set does not have yet. Normals for OpenGL replace those for DirectX.
void join(TextureSet &set, const TextureSet &more)
{
    for (const auto &[channel, picture] : more) {
        const auto [found, isNew] = set.try_emplace(channel, picture);
        if (!isNew && found->second.flipped && !picture.flipped)
            found->second = picture;
    }
}

} // namespace

std::optional<NamedTexture> textureOfName(const QString &fileName)
{
    static const QRegularExpression tile(u"^(.*[._])(\\d{4}|<UDIM>)$"_s,
                                         QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression separators(u"[\\s._-]+"_s);
    const QFileInfo info(fileName);
    QString base = info.completeBaseName();
    NamedTexture result;
    result.file = fileName;
    if (const auto match = tile.match(base); match.hasMatch()) {
        const int number = match.captured(2).toInt();
        const bool isTile = number == 0 || (number >= PackingSettings::firstTile && number <= 1100);
        if (isTile) {
            base = match.captured(1);
            result.file = base + u"<UDIM>."_s + info.suffix();
        }
    }
    QStringList words = base.split(separators, Qt::SkipEmptyParts);
    while (words.size() > 1 && saysNothing(words.last()))
        words.removeLast();
    const std::vector<Part> parts = takeChannel(words);
    if (parts.empty())
        return std::nullopt;
    result.stem = words.join(u'_');
    for (const Part &part : parts)
        result.channels[part.channel] = {{result.file, {}}, part.component, part.flipped, 1};
    return result;
}

FolderTextures texturesInFolder(const QString &folder, const Scene &scene)
{
    const QDir dir(folder);
    const QStringList suffixes = pictureSuffixes();
    std::map<QString, TextureSet> ofStem; // by plain names
    std::map<QString, QStringList> filesOfStem;
    for (const QString &name : dir.entryList(QDir::Files | QDir::Readable, QDir::Name | QDir::IgnoreCase)) {
        if (!suffixes.contains(QFileInfo(name).suffix().toLower()))
            continue;
        std::optional<NamedTexture> found = textureOfName(name);
        if (!found)
            continue;
        for (auto &[channel, entry] : found->channels)
            entry.picture.file = dir.absoluteFilePath(found->file);
        const QString stem = plainName(found->stem);
        join(ofStem[stem], found->channels);
        filesOfStem[stem] << name;
    }
    FolderTextures result;
    const std::vector<int> used = usedMaterials(scene);
    result.sets.resize(scene.materialNames.size() + 1);
    const auto give = [&](int material, const TextureSet &set) {
        join(result.sets[static_cast<std::size_t>(material + 1)], set);
        result.pictures += static_cast<int>(set.size());
    };
    std::vector<QString> materials;
    for (const QString &name : scene.materialNames)
        materials.push_back(plainName(name));
    bool anyFits = false;
    for (const auto &[stem, set] : ofStem)
        anyFits = anyFits || materialOf(stem, materials) >= 0;
    for (const auto &[stem, set] : ofStem) {
        if (const int material = materialOf(stem, materials); material >= 0) {
            give(material, set);
        } else if (!anyFits && (ofStem.size() == 1 || used.size() == 1)) {
            for (const int each : used)
                give(each, set);
        } else {
            result.left << filesOfStem[stem];
        }
    }
    result.sets = withoutEmptyEnd(std::move(result.sets));
    return result;
}

} // namespace autocuts
