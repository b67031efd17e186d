// Takes the noise out of light maps.
#pragma once

#include "model/plain/picture.h"
#include "solver/bake/rayscene.h"
#include "solver/base/jobcontext.h"

#include <cstdint>

namespace autocuts::bake {

//! What is known of the texels of a light map without noise; all per texel.
struct TexelGuides
{
    std::vector<Vec3f> position, normal;
    std::vector<float> size;          //!< of a texel on the surface, in the unit of the positions
    std::vector<std::uint8_t> filled; //!< 0: the texel is not used
    std::vector<float> variance;      //!< of the luminance of the noisy value
};

//! Averages texels that lie beside each other on the surface, face the same way and differ by no more than
//! their noise (a wavelet filter with holes: Dammertz et al. 2010; bound by the variance: Schied et al.
//! 2017). Texels that are neighbours in the map alone, as at a seam, are far apart on the surface and left
//! out. The light is without the albedo of the surface, so that its pattern needs no guide. On a stop, the
//! picture is as after the last complete step.
void denoiseLight(Picture &light, TexelGuides guides, const JobContext &job);

} // namespace autocuts::bake
