// Samples pictures that are made anew, without making them softer than they must be. Plain: no Qt.
#pragma once

#include "model/plain/picture.h"

namespace autocuts {

//! The largest stretch of a sharp sample.
inline constexpr float mostStretch = 4;

//! The value at a UV by Lanczos' kernel over the 6 x 6 texels around (C. E. Duchon 1979, "Lanczos filtering
//! in one and two dimensions"): details stay as sharp as they are. The picture repeats outside of [0, 1).
//! Beside sharp borders values may lie a little beyond those around; colours are best left sRGB for it, since
//! in linear light dark details would get dark rings.
//! \param stretch side of a new texel in texels of the picture: the kernel gets wider by it, from 1 to
//! mostStretch, so that details that are too fine for the new texels go and do not turn into noise
//! \param out gets a value per channel
//! \pre the picture is not empty and the UV is finite
void sampleSharply(const Picture &picture, const Vec2 &uv, float stretch, std::span<float> out);

} // namespace autocuts
