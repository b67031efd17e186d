// A picture of numbers: a texture, or what a bake makes. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <array>
#include <span>
#include <vector>

namespace autocuts {

//! A picture. Rows run from the top: the first one is at v = 1 of its tile. Channels: 1 grey, 3 RGB, 4 RGB
//! and alpha (not multiplied in). The values have no fixed range: whole numbers of files become 0 to 1.
struct Picture
{
    Picture() = default;
    //! All values are `value`.
    Picture(int columns, int rows, int channelCount, float value = 0);

    int width = 0, height = 0, channels = 0;
    std::vector<float> values; //!< height x width x channels

    bool isEmpty() const { return values.empty(); }
    std::span<float> at(int x, int y) { return {values.data() + offset(x, y), std::size_t(channels)}; }
    std::span<const float> at(int x, int y) const
    {
        return {values.data() + offset(x, y), std::size_t(channels)};
    }

private:
    std::size_t offset(int x, int y) const { return (std::size_t(y) * width + x) * channels; }
};

//! The four texels whose centres surround a place, and how far it is from the upper left one.
struct TexelBlend
{
    std::array<std::size_t, 4> texel{}; //!< upper left, upper right, lower left, lower right; row by row
    float right = 0, down = 0;          //!< in texels, in [0, 1)

    std::array<float, 4> weights() const
    {
        return {(1 - right) * (1 - down), right * (1 - down), (1 - right) * down, right * down};
    }
};

//! The texels around a finite UV of a picture that repeats outside of [0, 1).
TexelBlend blendAt(int width, int height, const Vec2 &uv);

//! The value at a UV, interpolated between the centres of the four texels around it. The picture repeats
//! outside of [0, 1). \param out gets a value per channel
//! \pre the picture is not empty and the UV is finite
void sampleRepeated(const Picture &picture, const Vec2 &uv, std::span<float> out);

//! The transfer function of sRGB (IEC 61966-2-1) and its inverse. Values outside of [0, 1] go on by the same
//! formula.
float linearFromSrgb(float value);
float srgbFromLinear(float value);

} // namespace autocuts
