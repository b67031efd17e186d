#include "model/plain/cornercolors.h"

#include "model/plain/picture.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

std::uint16_t packed(double value)
{
    return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(value, 0.0, 1.0)));
}

} // namespace

CornerColor CornerColor::fromLinear(double red, double green, double blue)
{
    if (!std::isfinite(red) || !std::isfinite(green) || !std::isfinite(blue))
        return {};
    return {{packed(red), packed(green), packed(blue)}, true};
}

CornerColor CornerColor::fromSrgb(double red, double green, double blue)
{
    const auto part = [](double value) { return linearFromSrgb(static_cast<float>(value)); };
    return fromLinear(part(red), part(green), part(blue));
}

std::shared_ptr<const CornerColors> sharedColors(CornerColors colors, std::size_t corners)
{
    // Programs write white for models without colours; it would hide those of materials.
    const CornerColor white{{65535, 65535, 65535}, true};
    if (std::ranges::none_of(colors, [&](const CornerColor &color) { return color.known && color != white; }))
        return nullptr;
    colors.resize(corners);
    return std::make_shared<const CornerColors>(std::move(colors));
}

} // namespace autocuts
