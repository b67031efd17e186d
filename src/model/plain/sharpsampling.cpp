#include "model/plain/sharpsampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace autocuts {

namespace {

//! Texels on each side.
constexpr int reach = 3;
constexpr std::size_t mostTaps = 2 * reach * static_cast<std::size_t>(mostStretch);

//! Places per texel at which the kernel is known; between them it is a straight line.
constexpr int steps = 1024;

//! Lanczos' kernel: the sinc under the middle of a wider one.
float lanczos(float t)
{
    constexpr auto pi = std::numbers::pi_v<float>;
    if (t <= 0)
        return 1;
    if (t >= reach)
        return 0;
    return reach * std::sin(pi * t) * std::sin(pi * t / reach) / (pi * pi * t * t);
}

using Kernel = std::array<float, std::size_t(reach) * steps + 2>;

const Kernel &kernel()
{
    static const Kernel values = [] {
        Kernel result{};
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = lanczos(static_cast<float>(i) / steps);
        return result;
    }();
    return values;
}

float valueAt(const Kernel &values, float x)
{
    const float place = std::min(std::abs(x), float(reach)) * steps;
    const auto i = static_cast<std::size_t>(place);
    return values[i] + (place - static_cast<float>(i)) * (values[i + 1] - values[i]);
}

//! The texels along one direction that a sample sees, and their shares.
struct Taps
{
    std::array<int, mostTaps> texels;
    std::array<float, mostTaps> weights;
    std::size_t count = 0;

    Taps(double at, int size, float stretch)
    {
        const Kernel &values = kernel();
        const int half = static_cast<int>(std::ceil(reach * stretch));
        const int first = static_cast<int>(std::floor(at)) + 1 - half;
        float sum = 0;
        for (int i = first; i < first + 2 * half; ++i) {
            texels[count] = (i % size + size) % size;
            weights[count] = valueAt(values, static_cast<float>(at - i) / stretch);
            sum += weights[count++];
        }
        for (std::size_t i = 0; i < count; ++i)
            weights[i] /= sum;
    }
};

} // namespace

void sampleSharply(const Picture &picture, const Vec2 &uv, float stretch, std::span<float> out)
{
    const float wide = std::clamp(stretch, 1.0F, mostStretch);
    const Taps across((uv.x() - std::floor(uv.x())) * picture.width - 0.5, picture.width, wide);
    const Taps down((1 - (uv.y() - std::floor(uv.y()))) * picture.height - 0.5, picture.height, wide);
    std::array<float, 4> sums{};
    for (std::size_t j = 0; j < down.count; ++j) {
        const float *row = picture.at(0, down.texels[j]).data();
        for (std::size_t i = 0; i < across.count; ++i) {
            const float weight = across.weights[i] * down.weights[j];
            const float *texel = row + std::ptrdiff_t(across.texels[i]) * picture.channels;
            for (int k = 0; k < picture.channels; ++k)
                sums[std::size_t(k)] += weight * texel[k];
        }
    }
    std::copy_n(sums.begin(), picture.channels, out.begin());
}

} // namespace autocuts
