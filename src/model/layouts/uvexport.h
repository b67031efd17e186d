// Pictures of UV layouts: PNG to paint over, SVG to print or edit.
#pragma once

#include "model/document/result.h"
#include "model/layouts/layoutoptions.h"
#include "model/plain/meshdata.h"

#include <QByteArray>

#include <atomic>

namespace autocuts {

//! The layout of some faces alone, for a picture of a part: the rows of all others are not finite.
//! \param faces per face: it is kept; empty: all are
UvMatrix withoutOtherFaces(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &faces);

//! The bytes of a PNG file; an error when the size is out of range or memory is short. The same input gives
//! the same bytes. Needs no application object.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
//! \param stop ends it soon, with an unfinished picture; null: nothing does
Result<QByteArray> layoutPng(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options = {},
                             const std::atomic<bool> *stop = nullptr);

//! The bytes of an SVG file with one group each for islands, edges, seams and overlaps.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
Result<QByteArray> layoutSvg(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options = {});

} // namespace autocuts
