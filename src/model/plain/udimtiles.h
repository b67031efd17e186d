// The tiles of the texture plane, which is proportional to texels: a tile is 1 wide and, where the texture is
// not square, higher or lower (PackingSettings::tileHeight()). As UDIM tiles they are numbered, ten in a row;
// the first is 1001. Plain: no Qt.
//
// One rule says to which tile an island belongs, findTiles(); whatever packs, solves, bakes, draws or exports
// by tiles goes by it. An island belongs to the tile that holds most of its area, also when it reaches over
// the border. That holds for layouts that are made of tiles: the islands that are at home in their tiles,
// each with two thirds of its area or more, have half of the area of all islands or more. Otherwise large
// islands lie over several tiles, as those of a wall on which a texture repeats: then an island that does not
// lie in one tile as a whole belongs to none.
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

//! The UDIM tile of each island of a layout.
struct TileLayout
{
    bool hasTiles = false;       //!< the layout is made of tiles; see above
    std::vector<int> tile;       //!< per chart: the number of its tile; 0: none
    std::vector<bool> sticksOut; //!< per chart: a part of it lies outside of its tile, or it has none

    //! The tile of each face's island, per face; 0 also for faces without UVs.
    std::vector<int> ofFaces(const ChartMap &charts) const;
};

//! The UDIM tile of each island of a layout. In a layout that is made of tiles, an island that lies where no
//! tile is belongs to the nearest one in which an island is at home. \param charts of the UVs
TileLayout findTiles(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv, double tileHeight);

//! TileLayout::ofFaces() of a layout. \param charts of the UVs
std::vector<int> islandTiles(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv,
                             double tileHeight);

//! The tiles with at least one island, ascending. \param tiles of islandTiles() \param faces per face: it
//! counts; empty: all do
std::vector<int> usedTiles(const std::vector<int> &tiles, const std::vector<bool> &faces = {});

//! The tile that each face's island stays in, per face; 0 for faces without UVs. All 0 when the layout is not
//! made of tiles.
std::vector<int> udimTiles(const MeshData &mesh, const UvMatrix &uv, double tileHeight);

//! The tiles that a bake fills.
struct BakedTiles
{
    std::vector<int> numbers; //!< ascending; 1001 when no island lies in a tile
    int facesOutside = 0;     //!< without UVs, or of islands of which a part lies outside of their tile
};
BakedTiles tilesToBake(const MeshData &mesh, const UvMatrix &uv, double tileHeight);

} // namespace autocuts
