// What the command line says about a light bake.
#pragma once

#include "model/io/litscene.h"
#include "model/plain/lightplan.h"
#include "solver/bake/lightbake.h"

#include <optional>

namespace autocuts {

//! The options of the command that bakes light.
struct LightBaking
{
    bake::LightBakeSettings settings; //!< without the size
    LightPlan lights;
    LitSceneOptions surface;
    std::optional<int> bits; //!< of the numbers in the file
};

} // namespace autocuts
