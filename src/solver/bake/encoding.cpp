#include "solver/bake/encoding.h"

#include <algorithm>

namespace autocuts::bake {

namespace {

//! The value of texels that show nothing.
std::array<float, 4> backgroundOf(const MapRequest &request, TextureKind kind, bool floats)
{
    const float middle = floats ? 0 : 0.5F;
    switch (request.kind) {
    case MapKind::Normal:
    case MapKind::BentNormal:
        return {0.5F, 0.5F, 1, 1};
    case MapKind::ObjectNormal:
        return {0.5F, 0.5F, 0.5F, 1};
    case MapKind::Occlusion:
        return {1, 1, 1, 1};
    case MapKind::Curvature:
    case MapKind::Height:
        return {middle, middle, middle, middle};
    case MapKind::Texture:
        if (kind == TextureKind::Normal || kind == TextureKind::NormalDirectX)
            return {0.5F, 0.5F, 1, 1};
        break;
    default:
        break;
    }
    return {0, 0, 0, 0};
}

void encodeTexel(std::span<float> texel, const MapRequest &request, TextureKind kind,
                 const Encoding &encoding)
{
    const auto each = [&](auto &&change) {
        for (std::size_t k = 0; k < std::min<std::size_t>(3, texel.size()); ++k)
            texel[k] = static_cast<float>(change(texel[k], k));
    };
    const bool isColor = request.kind == MapKind::Color || request.kind == MapKind::MaterialId;
    if (isDirection(request.kind)) {
        if (request.kind != MapKind::ObjectNormal && encoding.greenDown)
            texel[1] = -texel[1];
        each([](float value, std::size_t) { return 0.5F + 0.5F * value; });
    } else if (request.kind == MapKind::Texture && kind == TextureKind::Srgb) {
        each([](float value, std::size_t) { return srgbFromLinear(value); });
    } else if (encoding.floats) {
        return;
    } else if (isColor) {
        each([](float value, std::size_t) { return srgbFromLinear(value); });
    } else if (request.kind == MapKind::Curvature) {
        texel[0] = 0.5F + 0.5F * texel[0];
    } else if (request.kind == MapKind::Height) {
        texel[0] = static_cast<float>(0.5 + 0.5 * texel[0] / encoding.heightRange);
    } else if (request.kind == MapKind::Position) {
        each([&](float value, std::size_t k) {
            return (value - encoding.positionLow[static_cast<Eigen::Index>(k)]) / encoding.positionRange;
        });
    }
    if (!encoding.floats)
        each([](float value, std::size_t) { return std::clamp(value, 0.0F, 1.0F); });
}

} // namespace

void encode(Picture &picture, const MapRequest &request, TextureKind kind,
            const std::vector<std::uint8_t> &filled, const Encoding &encoding)
{
    const std::array<float, 4> background = backgroundOf(request, kind, encoding.floats);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::span<float> texel = picture.at(x, y);
            if (filled[std::size_t(y) * picture.width + x])
                encodeTexel(texel, request, kind, encoding);
            else
                std::copy_n(background.begin(), texel.size(), texel.begin());
        }
    }
}

} // namespace autocuts::bake
