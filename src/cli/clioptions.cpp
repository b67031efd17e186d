#include "cli/clioptions.h"

#include "solver/packing/packmap.h"

namespace autocuts {

void CliOptions::packIntoTile()
{
    const packing::PackOptions tile = packing::tileOptions(unwrap.packing);
    unwrap.packing.lower = tile.lower;
    unwrap.packing.upper = tile.upper;
}

} // namespace autocuts
