// Packs islands into several UDIM tiles: as many as their sizes need.
#pragma once

#include "solver/unwrap/packjob.h"

namespace autocuts::unwrap {

//! How islands are distributed over tiles.
struct TilePacking
{
    //! Texels per unit of the model that the islands get where the texel weight is 1; 0: they keep their
    //! sizes.
    double density = 0;
    int firstTile = PackingSettings::firstTile; //!< tiles are taken from this one on
    std::vector<int> tilesFirst{};              //!< these before all others, in this order
};

//! The map after packing, and the tiles that were used.
struct TilePackingResult
{
    enum class Outcome {
        Done,
        Stopped,
        NoRoom, //!< the margins alone need more room than a tile has
        TooMany //!< there are not enough UDIM tiles
    };
    Outcome outcome = Outcome::Done;
    UvMatrix uv;            //!< without rows unless it is done
    std::vector<int> tiles; //!< into which islands were packed, ascending
    int packed = 0;         //!< islands; a stack or a group counts as one
    int tooLarge = 0;       //!< of these, that are larger than a tile and are made smaller to fit
};

//! How the free room of the tiles in use is filled: those with islands that stay, then new ones behind them.
//! Unless sizes are kept, the islands get the density of those that stay.
TilePacking fillingTiles(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                         const UvMatrix &uv);

//! Packs the islands that may move. Those that stay are obstacles, also in the tiles; rectangles and the tile
//! that islands are in are ignored. The largest islands come first, and each tile takes as many as fit.
//! \param pack what may move, and the settings \param uv one row per corner, texture space
TilePackingResult packOverTiles(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                                const TilePacking &tiles, const UvMatrix &uv, const JobContext &job = {});

} // namespace autocuts::unwrap
