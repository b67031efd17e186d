#include "model/plain/picture.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

Picture::Picture(int columns, int rows, int channelCount, float value)
    : width(columns), height(rows), channels(channelCount),
      values(std::size_t(columns) * rows * channelCount, value)
{}

TexelBlend blendAt(int width, int height, const Vec2 &uv)
{
    const double x = (uv.x() - std::floor(uv.x())) * width - 0.5;
    const double y = (1 - (uv.y() - std::floor(uv.y()))) * height - 0.5;
    const auto left = std::floor(x), top = std::floor(y);
    const auto wrapped = [](int i, int size) {
        return static_cast<std::size_t>(i < 0 ? size - 1 : i >= size ? i - size : i);
    };
    const std::size_t x0 = wrapped(int(left), width), x1 = wrapped(int(left) + 1, width);
    const std::size_t y0 = wrapped(int(top), height) * width, y1 = wrapped(int(top) + 1, height) * width;
    return {{y0 + x0, y0 + x1, y1 + x0, y1 + x1}, static_cast<float>(x - left), static_cast<float>(y - top)};
}

void sampleRepeated(const Picture &picture, const Vec2 &uv, std::span<float> out)
{
    const TexelBlend blend = blendAt(picture.width, picture.height, uv);
    std::array<const float *, 4> at{};
    for (std::size_t i = 0; i < at.size(); ++i)
        at[i] = picture.values.data() + blend.texel[i] * picture.channels;
    for (int k = 0; k < picture.channels; ++k) {
        const float upper = at[0][k] + blend.right * (at[1][k] - at[0][k]);
        const float lower = at[2][k] + blend.right * (at[3][k] - at[2][k]);
        out[k] = upper + blend.down * (lower - upper);
    }
}

float linearFromSrgb(float value)
{
    if (value <= 0.04045F)
        return value / 12.92F;
    return std::pow((value + 0.055F) / 1.055F, 2.4F);
}

float srgbFromLinear(float value)
{
    if (value <= 0.0031308F)
        return value * 12.92F;
    return 1.055F * std::pow(value, 1 / 2.4F) - 0.055F;
}

} // namespace autocuts
