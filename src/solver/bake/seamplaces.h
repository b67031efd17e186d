// The seams of a map, from both of their sides.
#pragma once

#include "model/plain/shadedsurface.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace autocuts::bake {

//! A point of a seam, in both islands that meet there. A picture without visible seams has the same value in
//! both.
struct SeamPlace
{
    std::array<SurfacePoint, 2> side;
    std::array<Vec2, 2> uv; //!< of both sides, in the picture of the tile, which is 1 x 1
    double length = 0;      //!< of the seam here, in the units of the model
};

//! Places along the seams. Hard edges are left out, since what they show differs by right, and seams whose
//! sides do not both lie in the tile.
//! \param size of the tile's picture: width and height in texels
//! \param perTexel how many places for the length of a texel; each edge has at least one
std::vector<SeamPlace> seamPlaces(const ShadedSurface &low, const Eigen::AlignedBox2d &tile,
                                  const Eigen::Array2i &size, double perTexel);

//! How far a picture differs across seams.
struct SeamDifference
{
    double sum = 0;    //!< differences of the channels, in the mean, times length
    double length = 0; //!< of the seams compared, in the units of the model

    //! The mean difference. Nothing where no seam was compared.
    std::optional<double> mean() const { return length > 0 ? std::optional(sum / length) : std::nullopt; }
};

//! How the numbers of a picture are compared.
enum class SeamValues {
    Numbers,       //!< as they are
    TangentNormals //!< (direction + 1) / 2 in tangent space, compared in the space of the model
};

//! Draws the surface along each seam from both of its sides, as a renderer does with the texels beside it,
//! and adds up the differences. \pre low.tangents are there for TangentNormals \param greenDown normals are
//! DirectX's
void compareSides(const ShadedSurface &low, const Eigen::AlignedBox2d &tile, const Picture &picture,
                  SeamValues values, bool greenDown, SeamDifference &difference);

} // namespace autocuts::bake
