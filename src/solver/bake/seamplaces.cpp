#include "solver/bake/seamplaces.h"

#include <algorithm>
#include <cmath>

namespace autocuts::bake {

namespace {

//! Shading normals whose angle has a smaller cosine make a hard edge.
constexpr float leastCosine = 0.9999F;

//! Not in step with the texels, nor with the places at which seams are evened.
constexpr double comparedPerTexel = 0.7;

//! The point of an edge pair's side, `t` of the way from its first end to the other.
SurfacePoint pointOf(const EdgePair &pair, int which, double t)
{
    std::array<float, 3> weights{};
    weights[pair.corner[0][which] % 3] = static_cast<float>(1 - t);
    weights[pair.corner[1][which] % 3] = static_cast<float>(t);
    return {pair.triangle[which], weights[1], weights[2]};
}

//! True for a seam that is not hard and lies in the tile on both sides.
bool isCompared(const ShadedSurface &low, const EdgePair &pair, const Eigen::AlignedBox2d &tile)
{
    bool isSeam = false;
    for (const std::array<int, 2> &end : pair.corner) {
        const int one = low.mesh->cornerOfSoup(end[0]), other = low.mesh->cornerOfSoup(end[1]);
        const Vec2 uvOfOne = low.uv.row(one), uvOfOther = low.uv.row(other);
        if (!tile.contains(uvOfOne) || !tile.contains(uvOfOther))
            return false;
        if (!(low.normals[one].dot(low.normals[other]) > leastCosine))
            return false;
        isSeam = isSeam || uvOfOne != uvOfOther;
    }
    return isSeam;
}

std::array<float, 4> drawn(const ShadedSurface &low, const SeamPlace &place, int which,
                           const Picture &picture, SeamValues values, bool greenDown)
{
    std::array<float, 4> value{};
    sampleRepeated(picture, place.uv[which], std::span(value).first(std::size_t(picture.channels)));
    if (values == SeamValues::TangentNormals) {
        Vec3f inMap{2 * value[0] - 1, 2 * value[1] - 1, 2 * value[2] - 1};
        if (greenDown)
            inMap.y() = -inMap.y();
        const Vec3f direction = (low.tangentFrame(place.side[which]) * inMap).stableNormalized();
        for (int k = 0; k < 3; ++k)
            value[k] = 0.5F + 0.5F * direction[k];
    }
    return value;
}

} // namespace

std::vector<SeamPlace> seamPlaces(const ShadedSurface &low, const Eigen::AlignedBox2d &tile,
                                  const Eigen::Array2i &size, double perTexel)
{
    const auto inPicture = [&](const SurfacePoint &point) -> Vec2 {
        return (low.uvAt(point) - tile.min()).cwiseQuotient(tile.sizes());
    };
    std::vector<SeamPlace> places;
    for (const EdgePair &pair : low.mesh->edgePairs) {
        if (!isCompared(low, pair, tile))
            continue;
        double texels = 0;
        for (int which = 0; which < 2; ++which) {
            const Vec2 side = inPicture(pointOf(pair, which, 1)) - inPicture(pointOf(pair, which, 0));
            texels = std::max(texels, (side.array() * size.cast<double>()).matrix().norm());
        }
        const int count = std::max(1, static_cast<int>(std::ceil(perTexel * texels)));
        for (int i = 0; i < count; ++i) {
            SeamPlace place;
            place.length = pair.length / count;
            for (int which = 0; which < 2; ++which) {
                place.side[which] = pointOf(pair, which, (i + 0.5) / count);
                place.uv[which] = inPicture(place.side[which]);
            }
            places.push_back(place);
        }
    }
    return places;
}

void compareSides(const ShadedSurface &low, const Eigen::AlignedBox2d &tile, const Picture &picture,
                  SeamValues values, bool greenDown, SeamDifference &difference)
{
    const Eigen::Array2i size(picture.width, picture.height);
    for (const SeamPlace &place : seamPlaces(low, tile, size, comparedPerTexel)) {
        const auto one = drawn(low, place, 0, picture, values, greenDown);
        const auto other = drawn(low, place, 1, picture, values, greenDown);
        double apart = 0;
        for (int k = 0; k < picture.channels; ++k)
            apart += std::abs(one[k] - other[k]);
        difference.sum += place.length * apart / picture.channels;
        difference.length += place.length;
    }
}

} // namespace autocuts::bake
