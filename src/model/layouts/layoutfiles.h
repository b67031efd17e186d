// The files with pictures of a UV layout: one for each UDIM tile in use.
#pragma once

#include "model/document/result.h"
#include "model/layouts/layoutoptions.h"
#include "model/plain/meshdata.h"

#include <QString>

#include <atomic>
#include <vector>

namespace autocuts {

//! A picture of one UDIM tile.
struct LayoutPicture
{
    int tile = 0;
    QString path; //!< .png or .svg
};

//! The pictures of a layout: of each tile in which an island lies as a whole. Several have the number of
//! their tile before the suffix: name.1001.png.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \param otherTile of which the picture is when no island lies in a tile
//! \param numbered a single one has its number, too
std::vector<LayoutPicture> layoutPictures(const QString &path, const MeshData &mesh, const UvMatrix &uv,
                                          double tileHeight, int otherTile, bool numbered = false);

//! Draws and writes the pictures; in each are all islands that reach into its tile. On an Error, and after a
//! stop, all files are as they were.
Result<Done> writeLayoutPictures(const std::vector<LayoutPicture> &pictures, const MeshData &mesh,
                                 const UvMatrix &uv, const LayoutOptions &options,
                                 const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
