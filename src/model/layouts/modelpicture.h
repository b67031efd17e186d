// Small pictures of models, drawn without a window: for file managers and reports.
#pragma once

#include "model/plain/meshdata.h"

#include <QImage>

namespace autocuts {

//! Draws a mesh as the studio first shows it: from the front, somewhat from the right and from above, y up,
//! on nothing. The same mesh gives the same picture. \param side pixels, at least 1 \param mesh with a face
QImage modelPicture(const MeshData &mesh, int side);

} // namespace autocuts
