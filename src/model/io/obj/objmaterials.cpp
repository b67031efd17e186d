#include "model/io/obj/objmaterials.h"

#include "model/document/materialcolor.h"
#include "model/io/files/savefile.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <map>
#include <optional>

namespace autocuts {

namespace {

//! Chosen by hand, far above what is usual.
constexpr qint64 maxMaterialFile = 16 << 20;
constexpr qsizetype maxMaterialFiles = 16;

//! The rest of a line after its keyword; nothing when the line has another keyword.
std::optional<QByteArrayView> restAfter(QByteArrayView line, QByteArrayView keyword)
{
    line = line.trimmed();
    if (!line.startsWith(keyword) || line.size() <= keyword.size())
        return std::nullopt;
    const char next = line[keyword.size()];
    if (next != ' ' && next != '\t')
        return std::nullopt;
    return line.sliced(keyword.size()).trimmed();
}

template <typename Visit>
void visitLines(QByteArrayView bytes, Visit visit)
{
    while (!bytes.isEmpty()) {
        const qsizetype end = bytes.indexOf('\n');
        visit(end < 0 ? bytes : bytes.first(end));
        bytes = end < 0 ? QByteArrayView() : bytes.sliced(end + 1);
    }
}

QRgb diffuseColor(QByteArrayView numbers)
{
    const QList<QByteArray> parts = numbers.toByteArray().simplified().split(' ');
    bool valid[3] = {};
    if (parts.size() != 3)
        return 0;
    const QRgb color = materialColor(parts[0].toDouble(&valid[0]), parts[1].toDouble(&valid[1]),
                                     parts[2].toDouble(&valid[2]));
    return valid[0] && valid[1] && valid[2] ? color : 0;
}

//! What a material file says of a material.
struct Material
{
    std::optional<QRgb> color;
    QString texture;
    TextureSet set;
};

//! Keywords of the other maps; roughness, metalness and norm are of the extension for physically based
//! materials (D. McKerracher, "Physically-Based Rendering (PBR) extension to MTL").
constexpr std::pair<const char *, TextureChannel> mapKeywords[] = {
    {"map_Pr", TextureChannel::Roughness}, {"map_Pm", TextureChannel::Metalness},
    {"norm", TextureChannel::Normal},      {"map_Kn", TextureChannel::Normal},
    {"map_Ke", TextureChannel::Emission},  {"map_Bump", TextureChannel::Normal},
    {"map_bump", TextureChannel::Normal},  {"bump", TextureChannel::Normal},
    {"disp", TextureChannel::Height}};
constexpr std::pair<const char *, TextureChannel> numberKeywords[] = {{"Pr", TextureChannel::Roughness},
                                                                      {"Pm", TextureChannel::Metalness}};

//! The next word; it is taken from the text.
QByteArrayView takeWord(QByteArrayView &text)
{
    text = text.trimmed();
    qsizetype end = 0;
    while (end < text.size() && text[end] != ' ' && text[end] != '\t')
        ++end;
    const QByteArrayView word = text.first(end);
    text = text.sliced(end).trimmed();
    return word;
}

//! The file name of a map, without the options before it; it may have spaces.
QString fileOfMap(QByteArrayView text)
{
    while (text.startsWith('-')) {
        const QByteArrayView option = takeWord(text);
        // -o, -s and -t have one to three numbers, -mm has two, the others one word.
        const bool vector = option == "-o" || option == "-s" || option == "-t";
        for (int word = 0; word < (vector ? 3 : option == "-mm" ? 2 : 1); ++word) {
            QByteArrayView rest = text;
            const QByteArrayView value = takeWord(rest);
            bool isNumber = false;
            value.toByteArray().toDouble(&isNumber);
            if (word > 0 && vector && !isNumber)
                break;
            text = rest;
        }
    }
    return QString::fromUtf8(text);
}

void readChannel(QByteArrayView line, TextureSet &set)
{
    for (const auto &[keyword, channel] : numberKeywords) {
        if (const auto number = restAfter(line, keyword); number && !set.contains(channel))
            set[channel].factor = std::clamp(number->toByteArray().toDouble(), 0.0, 1.0);
    }
    for (const auto &[keyword, channel] : mapKeywords) {
        const auto map = restAfter(line, keyword);
        if (!map)
            continue;
        if (ChannelPicture &entry = set[channel]; entry.picture.isEmpty())
            entry = {
                {fileOfMap(*map), {}}, -1, false, 1}; // the number of a channel with a map does not count
    }
}

void readMaterialFile(QByteArrayView bytes, std::map<QString, Material> &materials)
{
    QString name;
    visitLines(bytes, [&](QByteArrayView line) {
        if (const auto called = restAfter(line, "newmtl")) {
            name = QString::fromUtf8(*called);
        } else if (const auto numbers = restAfter(line, "Kd")) {
            if (Material &material = materials[name]; !material.color)
                material.color = diffuseColor(*numbers);
        } else if (const auto map = restAfter(line, "map_Kd")) {
            if (Material &material = materials[name]; material.texture.isEmpty())
                material.texture = fileOfMap(*map);
        } else {
            readChannel(line, materials[name].set);
        }
    });
}

} // namespace

QStringList materialFiles(QByteArrayView bytes, const QString &path)
{
    QStringList files;
    visitLines(bytes, [&](QByteArrayView line) {
        const auto file = restAfter(line, "mtllib");
        if (!file || files.size() >= maxMaterialFiles)
            return;
        // Only the name counts: a model must not make us read files elsewhere.
        const QString name = QFileInfo(QString::fromUtf8(*file).replace(u'\\', u'/')).fileName();
        files << QFileInfo(path).dir().filePath(name);
    });
    return files;
}

void readMaterials(QByteArrayView bytes, const QString &path, Scene &scene)
{
    if (scene.materialNames.empty())
        return;
    std::map<QString, Material> materials;
    for (const QString &file : materialFiles(bytes, path)) {
        if (const auto content = loadFile(file, maxMaterialFile))
            readMaterialFile(content.value(), materials);
    }
    for (const QString &name : scene.materialNames) {
        const Material &material = materials[name];
        scene.materialColors.push_back(material.color.value_or(0));
        scene.materialTextures.push_back({material.texture, {}});
        scene.materialSets.push_back(material.set);
    }
}

} // namespace autocuts
