// UDIM tiles: unit squares of the texture plane, ten in a row, the first is 1001. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! Lower left corner of a tile.
Vec2 udimCorner(int tile);

//! The tile in which each face's island lies, per face; 0 for faces without UVs. All 0 when the layout is not
//! made of tiles: an island crosses the border of its tile, or lies where no tile is.
std::vector<int> udimTiles(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
