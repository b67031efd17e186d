// Bakes light into the map of a model.
#pragma once

#include "model/plain/picture.h"
#include "solver/bake/pathtracer.h"
#include "solver/bake/texels.h"
#include "solver/base/jobcontext.h"

#include <cstdint>
#include <functional>

namespace autocuts::bake {

//! What the values of a light map are.
enum class LightValue {
    Light,      //!< irradiance / pi: times the albedo, this is what is seen
    Irradiance, //!< light that arrives per area
    Lit         //!< radiance that leaves: albedo times Light, and what the surface shines itself
};

//! The settings of a light bake of one tile.
struct LightBakeSettings
{
    int width = 1024, height = 1024;
    Eigen::AlignedBox2d tile{Vec2::Zero(), Vec2::Ones()}; //!< of texture space
    int samples = 256;                                    //!< paths per texel
    int bounces = 4;                                      //!< how often light is reflected before it arrives
    bool direct = true, indirect = true;
    LightValue value = LightValue::Light;
    bool denoise = true;
    int margin = 8;         //!< texels around islands that are filled
    std::uint32_t seed = 0; //!< of the noise
};

//! The light map of one tile, with counts of its texels.
struct LightBakeResult
{
    bool stopped = false; //!< then it has fewer samples, and is coarse where there are none yet
    //! RGB, linear; black where nothing is near. Empty when it was stopped before there was anything.
    Picture picture;
    std::vector<std::uint8_t> filled; //!< per texel: it has a value
    long long texels = 0;             //!< inside of islands, or right beside them
    double noise = 0; //!< before denoising: standard error of the texels, as a share of their mean
};

//! Shows a map that is not finished, first coarse, then noisy. Called from one thread.
using LightPreview = std::function<void(const Picture &)>;

//! Bakes one tile. Results do not depend on the number of threads. \pre sizes and counts are positive
LightBakeResult bakeLight(const LitSurface &surface, const Lighting &lighting,
                          const LightBakeSettings &settings, const JobContext &job,
                          const LightPreview &preview = {});

} // namespace autocuts::bake
