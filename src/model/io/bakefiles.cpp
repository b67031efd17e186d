#include "model/io/bakefiles.h"

#include "model/io/texturefiles.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

QString bakedPath(const QString &folder, const QString &modelPath, const QString &map, int tile,
                  bool severalTiles, const QString &suffix)
{
    const QString name = QFileInfo(modelPath).completeBaseName() + u'_' + map;
    return QDir(folder).filePath(severalTiles ? u"%1.%2.%3"_s.arg(name).arg(tile).arg(suffix)
                                              : name + u'.' + suffix);
}

QString CarriedTexture::newPath(const QString &folder, int tile) const
{
    QString name = QFileInfo(path).fileName();
    if (name.contains(u"<UDIM>"_s)) {
        name.replace(u"<UDIM>"_s, QString::number(tile));
    } else if (tile > 0) {
        const QFileInfo info(name);
        name = u"%1.%2.%3"_s.arg(info.completeBaseName()).arg(tile).arg(info.suffix());
    }
    return QDir(folder).filePath(name);
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

Result<CarriedTexture> readCarriedTexture(const QString &path)
{
    CarriedTexture result;
    result.path = path;
    const std::vector<TextureTile> tiles = textureTiles(path);
    if (tiles.empty())
        return Error{u"there is no such picture"_s, path, 0, u"Check its name"_s};
    TiledPicture pictures;
    for (const TextureTile &tile : tiles) {
        const Result<QByteArray> bytes = loadPictureFile(tile.path);
        if (!bytes)
            return bytes.error();
        Result<DecodedPicture> decoded = decodePicture(bytes.value(), tile.path);
        if (!decoded)
            return decoded.error();
        result.depth = std::max(result.depth, decoded->depth);
        result.width = std::max(result.width, decoded->picture.width);
        result.height = std::max(result.height, decoded->picture.height);
        auto picture = std::make_shared<const Picture>(std::move(decoded->picture));
        (tile.tile == 0 ? pictures.repeated : pictures.tiles[tile.tile]) = std::move(picture);
    }
    result.texture.kind = textureKindOf(path, result.depth);
    result.texture.ofMaterial.push_back(std::move(pictures));
    return result;
}

} // namespace autocuts
