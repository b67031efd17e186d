// Fills the texels around islands with the values of the nearest texel of an island.
#pragma once

#include "model/plain/picture.h"
#include "solver/base/jobcontext.h"

#include <cstdint>
#include <vector>

namespace autocuts::bake {

//! Fills texels without a value from the nearest texel that has one, up to `margin` texels away. Texels with
//! a value never change, so no island grows into another one. \param filled per texel: 1 where it has a
//! value; becomes 1 where it gets one \param margin at least 0
void dilate(Picture &picture, std::vector<std::uint8_t> &filled, int margin, const JobContext &job);

} // namespace autocuts::bake
