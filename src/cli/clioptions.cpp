#include "cli/clioptions.h"

#include "solver/packing/packmap.h"

namespace autocuts {

CliOptions::Baking::Baking()
{
    job.settings.maps = {{bake::MapKind::Normal, 0}, {bake::MapKind::Occlusion, 0}};
    job.settings.grid.perSide = 2;
}

void CliOptions::packIntoTile()
{
    const packing::PackOptions tile = packing::tileOptions(unwrap.packing);
    unwrap.packing.lower = tile.lower;
    unwrap.packing.upper = tile.upper;
}

} // namespace autocuts
