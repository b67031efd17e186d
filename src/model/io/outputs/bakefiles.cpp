#include "model/io/outputs/bakefiles.h"

#include "model/io/outputs/fileclashes.h"
#include "model/pictures/texturefiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

QString bakedPath(const QString &folder, const QString &modelPath, const QString &map, int tile,
                  bool severalTiles, const QString &suffix)
{
    const QString name = QFileInfo(modelPath).completeBaseName() + u'_' + map;
    return QDir(folder).filePath(severalTiles ? u"%1.%2.%3"_s.arg(name).arg(tile).arg(suffix)
                                              : name + u'.' + suffix);
}

TextureKind textureKindOf(const QString &path, PictureDepth depth)
{
    const QString name = QFileInfo(path).completeBaseName().toLower();
    const auto has = [&name](const char *words) {
        return QRegularExpression(u"(^|[^a-z])(%1)([^a-z]|$)"_s.arg(QString::fromLatin1(words)))
            .match(name)
            .hasMatch();
    };
    if (name.contains(u"normaldx"_s) || (name.contains(u"normal"_s) && has("dx|directx")))
        return TextureKind::NormalDirectX;
    if (name.contains(u"normal"_s) || has("nrm|nor|nml"))
        return TextureKind::Normal;
    if (depth == PictureDepth::Float || name.contains(u"rough"_s) || name.contains(u"metal"_s) ||
        name.contains(u"occlusion"_s) || name.contains(u"height"_s) || name.contains(u"displace"_s) ||
        name.contains(u"opacity"_s) || name.contains(u"curvature"_s) || name.contains(u"thickness"_s) ||
        name.contains(u"mask"_s) || name.contains(u"position"_s) || has("ao|orm|mra|gloss|bump|disp|alpha"))
        return TextureKind::Linear;
    return TextureKind::Srgb;
}

namespace {

void add(ReadPictures &read, DecodedPicture decoded, int tile)
{
    read.depth = std::max(read.depth, decoded.depth);
    read.width = std::max(read.width, decoded.picture.width);
    read.height = std::max(read.height, decoded.picture.height);
    auto picture = std::make_shared<const Picture>(std::move(decoded.picture));
    (tile == 0 ? read.pictures.repeated : read.pictures.tiles[tile]) = std::move(picture);
}

Result<ReadPictures> readTiles(const QString &path)
{
    const std::vector<TextureTile> tiles = textureTiles(path);
    if (tiles.empty())
        return Error{QCoreApplication::translate("PictureFiles", "there is no such picture"), path, 0,
                     QCoreApplication::translate("PictureFiles", "Check its name")};
    ReadPictures result;
    for (const TextureTile &tile : tiles) {
        const Result<QByteArray> bytes = loadPictureFile(tile.path);
        if (!bytes)
            return bytes.error();
        Result<DecodedPicture> decoded = decodePicture(bytes.value(), tile.path);
        if (!decoded)
            return decoded.error();
        add(result, std::move(decoded).value(), tile.tile);
    }
    return result;
}

} // namespace

Result<ReadPictures> readPictures(const SceneTexture &texture)
{
    if (texture.content.isEmpty())
        return readTiles(texture.file);
    Result<DecodedPicture> decoded = decodePicture(texture.content, texture.file);
    if (!decoded)
        return decoded.error();
    ReadPictures result;
    add(result, std::move(decoded).value(), 0);
    return result;
}

std::optional<SurfaceTexture> readBaseColors(const DocumentState &model, QStringList &missing)
{
    SurfaceTexture texture;
    bool found = false, floats = true;
    const std::size_t count = model.scene.materialNames.size();
    texture.ofMaterial.resize(count + 1); // the last one is for faces without a material
    FolderNames folders;
    std::map<std::pair<QByteArray, QByteArray>, TiledPicture> known; // by file and content: read once
    for (const int material : usedMaterials(model.scene)) {
        TiledPicture &ofMaterial = texture.ofMaterial[material < 0 ? count : std::size_t(material)];
        const TextureSet set = model.textureSet(material);
        const auto color = set.find(TextureChannel::BaseColor);
        if (color == set.end() || color->second.picture.isEmpty())
            continue;
        SceneTexture one = color->second.picture;
        if (one.content.isEmpty())
            one.file = texturePath(one.file, isChosenTexture(model, material, TextureChannel::BaseColor),
                                   model.scene.path, &folders);
        const std::pair key(one.content.isEmpty() ? fileKey(one.file) : QByteArray(), one.content);
        if (const auto same = known.find(key); same != known.end()) {
            ofMaterial = same->second;
            continue;
        }
        Result<ReadPictures> pictures = readPictures(one);
        if (!pictures) {
            missing << color->second.picture.file;
            continue;
        }
        found = true;
        floats = floats && pictures->depth == PictureDepth::Float;
        ofMaterial = known[key] = std::move(pictures->pictures);
    }
    if (!found)
        return std::nullopt;
    texture.kind = floats ? TextureKind::Linear : TextureKind::Srgb;
    return texture;
}

bool addColors(const DocumentState &model, ColorSource from, ShadedSurface &surface, QStringList &missing)
{
    const bool anything = from == ColorSource::Auto;
    if (!anything && from != ColorSource::Vertices)
        surface.cornerColors = nullptr;
    if (anything || from == ColorSource::Textures) {
        if (std::optional<SurfaceTexture> colors = readBaseColors(model, missing))
            surface.textures.push_back(std::move(*colors));
    }
    switch (from) {
    case ColorSource::Textures:
        return !surface.textures.empty();
    case ColorSource::Vertices:
        return surface.cornerColors != nullptr;
    case ColorSource::Materials:
        return std::ranges::any_of(model.scene.materialColors, [](QRgb color) { return color != 0; });
    case ColorSource::Auto:
        break;
    }
    return true;
}

} // namespace autocuts
