#include "model/layouts/layoutfiles.h"

#include "model/io/files/savefile.h"
#include "model/layouts/uvexport.h"
#include "model/plain/udimtiles.h"

#include <QCoreApplication>
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

Result<Done> writeLayoutPictures(const std::vector<LayoutPicture> &pictures, const MeshData &mesh,
                                 const UvMatrix &uv, const LayoutOptions &options,
                                 const std::atomic<bool> *stop)
{
    FileSet files;
    for (const LayoutPicture &picture : pictures) {
        UvMatrix ofTile = uv;
        ofTile.rowwise() -= udimTile(picture.tile, options.tileHeight).min().transpose();
        const bool svg = picture.path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive);
        const Result<QByteArray> bytes =
            svg ? layoutSvg(mesh, ofTile, options) : layoutPng(mesh, ofTile, options, stop);
        if (stop && *stop)
            return Error{QCoreApplication::translate("FileErrors", "cancelled: no picture was written"),
                         picture.path,
                         0,
                         {}};
        if (!bytes)
            return bytes.error();
        if (Result<Done> added = files.add(picture.path, bytes.value()); !added)
            return added;
    }
    return files.putInPlace();
}

} // namespace autocuts
