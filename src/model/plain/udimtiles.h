// The tiles of the texture plane, which is proportional to texels: a tile is 1 wide and, where the texture is
// not square, higher or lower (PackingSettings::tileHeight()). As UDIM tiles they are numbered, ten in a row;
// the first is 1001. Plain: no Qt.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshdata.h"

#include <Eigen/Geometry>

#include <vector>

namespace autocuts {

//! The tile of a number.
Eigen::AlignedBox2d udimTile(int tile, double tileHeight);

//! The tile that contains a point; also where tiles have no number.
Eigen::AlignedBox2d tileAt(const Vec2 &point, double tileHeight);

//! The tile in which each face's island lies, per face; 0 for faces without UVs, and where the island crosses
//! the border of its tile or lies where no tile is. \param charts of the UVs
std::vector<int> islandTiles(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                             double tileHeight);

//! The tiles with at least one island, ascending. \param tiles of islandTiles() \param faces per face: it
//! counts; empty: all do
std::vector<int> usedTiles(const std::vector<int> &tiles, const std::vector<bool> &faces = {});

//! The tile in which each face's island lies, per face; 0 for faces without UVs. All 0 when the layout is not
//! made of tiles: an island crosses the border of its tile, or lies where no tile is.
std::vector<int> udimTiles(const MeshData &mesh, const UvMatrix &uv, double tileHeight);

//! The tiles that a bake fills.
struct BakedTiles
{
    std::vector<int> numbers; //!< ascending; 1001 when no island lies in a tile
    int facesOutside = 0;     //!< without UVs, or of islands that cross the border of their tile
};
BakedTiles tilesToBake(const MeshData &mesh, const UvMatrix &uv, double tileHeight);

} // namespace autocuts
