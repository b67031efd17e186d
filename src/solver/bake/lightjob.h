// A light bake from its lights to pictures, for the window and the command line.
#pragma once

#include "model/plain/lightplan.h"
#include "solver/bake/lightbake.h"

#include <functional>
#include <vector>

namespace autocuts::bake {

//! The lights of a plan. \param facesShine there are materials that do: without a sky, it is dark
Lighting lightingOf(const LightPlan &plan, bool facesShine);

//! The inputs and the settings of a light bake of all tiles.
struct LightJob
{
    LitSurface surface;
    Lighting lighting;
    LightBakeSettings settings; //!< its tile is not used
    std::vector<int> tiles{1001};
    double tileHeight = 1;
};

//! The job for a surface: the tiles in which islands lie wholly, and the lights of the plan.
LightJob lightJobOf(LitSurface surface, const LightPlan &plan, const LightBakeSettings &settings,
                    double tileHeight);

//! Texel counts of a light bake, summed over all tiles.
struct LightFigures
{
    bool stopped = false;
    long long texels = 0; //!< inside of islands, or right beside them
};

//! Receives the map of a tile. Returns false to end the bake.
using LightSink = std::function<bool(int tile, LightBakeResult &result)>;
//! Shows the map of a tile that is not finished.
using LightTilePreview = std::function<void(int tile, const Picture &picture)>;

//! Bakes one tile after the other. After a stop the sink gets what is there of the tile, if anything is.
LightFigures runLightBake(const LightJob &job, const LightSink &sink, const LightTilePreview &preview,
                          const JobContext &context);

} // namespace autocuts::bake
