// Makes a baked picture the same on both sides of each seam.
#pragma once

#include "solver/bake/seamplaces.h"
#include "solver/base/jobcontext.h"

#include <cstdint>

namespace autocuts::bake {

//! Changes the texels beside seams as little as it takes for both sides to show the same, in the sense of
//! least squares (Sylvan 2016, "Fixing texture seams with linear least-squares"): noise and filtering differ
//! on both sides, and the eye finds the line between them.
//! \param inTangentSpace the values are directions in tangent space, not encoded. They are compared in the
//! space of the model, for which `low` has tangents, and become unit again.
//! \param filled per texel: it has a value; others are not used
//! \pre the picture has one or three channels
void evenSeams(const ShadedSurface &low, const Eigen::AlignedBox2d &tile, bool inTangentSpace,
               const std::vector<std::uint8_t> &filled, Picture &picture, const JobContext &job);

} // namespace autocuts::bake
