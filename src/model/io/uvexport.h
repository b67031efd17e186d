// Pictures of a UV layout: PNG to paint over, SVG to print or edit.
#pragma once

#include "model/document/result.h"
#include "model/plain/meshdata.h"

#include <QByteArray>
#include <QColor>

#include <optional>
#include <vector>

namespace autocuts {

enum class LayoutBackground { Transparent, Dark, Light };

//! How a layout is drawn. The unit square fills the picture, v up; what lies outside is not shown.
struct LayoutOptions
{
    int size = 2048;   //!< texture size: pixels along each side, 16 to 16384
    bool edges = true; //!< draw the edges inside the islands
    bool fill = true;  //!< fill the islands
    bool seams = true; //!< draw the outlines of the islands
    //! Pixels by which the fill of each island goes on beyond its outline, 0 to 256: for painting without a
    //! bare rim. Never covers another island.
    int bleed = 0;
    LayoutBackground background = LayoutBackground::Dark;
    std::optional<QColor> islandColor, edgeColor, seamColor; //!< none: chosen by the background
    std::vector<int> overlapping;                            //!< triangles of the mesh to hatch
};

//! The bytes of a PNG file; an error when the size is out of range or there is not enough memory. The same
//! input gives the same bytes. Needs no application object.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
Result<QByteArray> layoutPng(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options = {});

//! The bytes of an SVG file with one group each for islands, edges, seams and overlaps.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
Result<QByteArray> layoutSvg(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options = {});

} // namespace autocuts
