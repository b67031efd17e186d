#include "model/io/layoutfiles.h"

#include "model/io/savefile.h"
#include "model/io/uvexport.h"
#include "model/plain/udimtiles.h"

#include <QDir>
#include <QFileInfo>

namespace autocuts {

std::vector<LayoutPicture> layoutPictures(const QString &path, const MeshData &mesh, const UvMatrix &uv,
                                          double tileHeight, int otherTile, bool numbered)
{
    std::vector<int> tiles = usedTiles(islandTiles(mesh, findCharts(mesh, uv), uv, tileHeight));
    if (tiles.empty())
        tiles = {otherTile};
    const QFileInfo file(path);
    std::vector<LayoutPicture> pictures;
    for (const int tile : tiles) {
        const QString name =
            QStringLiteral("%1.%2.%3").arg(file.completeBaseName(), QString::number(tile), file.suffix());
        pictures.push_back({tile, numbered || tiles.size() > 1 ? file.dir().filePath(name) : path});
    }
    return pictures;
}

Result<Done> writeLayoutPicture(const LayoutPicture &picture, const MeshData &mesh, UvMatrix uv,
                                const LayoutOptions &options)
{
    uv.rowwise() -= udimTile(picture.tile, options.tileHeight).min().transpose();
    const bool svg = picture.path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive);
    const Result<QByteArray> bytes = svg ? layoutSvg(mesh, uv, options) : layoutPng(mesh, uv, options);
    if (!bytes)
        return bytes.error();
    return saveAtomically(picture.path, bytes.value());
}

} // namespace autocuts
