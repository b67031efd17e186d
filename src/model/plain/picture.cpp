#include "model/plain/picture.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

Picture::Picture(int columns, int rows, int channelCount, float value)
    : width(columns), height(rows), channels(channelCount),
      values(std::size_t(columns) * rows * channelCount, value)
{}

void sampleRepeated(const Picture &picture, const Vec2 &uv, std::span<float> out)
{
    const double x = (uv.x() - std::floor(uv.x())) * picture.width - 0.5;
    const double y = (1 - (uv.y() - std::floor(uv.y()))) * picture.height - 0.5;
    const auto left = std::floor(x), top = std::floor(y);
    const auto right = static_cast<float>(x - left), down = static_cast<float>(y - top);
    const auto wrapped = [](int i, int size) { return i < 0 ? size - 1 : i >= size ? i - size : i; };
    const int x0 = wrapped(int(left), picture.width), x1 = wrapped(int(left) + 1, picture.width);
    const int y0 = wrapped(int(top), picture.height), y1 = wrapped(int(top) + 1, picture.height);
    const auto a = picture.at(x0, y0), b = picture.at(x1, y0);
    const auto c = picture.at(x0, y1), d = picture.at(x1, y1);
    for (int k = 0; k < picture.channels; ++k) {
        const float upper = a[k] + right * (b[k] - a[k]);
        const float lower = c[k] + right * (d[k] - c[k]);
        out[k] = upper + down * (lower - upper);
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
