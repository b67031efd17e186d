// Finds the seams of a map from its UVs alone. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! UVs closer than this share of the diagonal of the map's bounding box are equal; part of the definition of
//! charts in the file format.
inline constexpr double uvTolerance = 1e-6;

//! True when two corners have the same UV. \param distance tolerance, in UV units
inline bool sameUv(const UvMatrix &uv, int a, int b, double distance)
{
    return (uv.row(a) - uv.row(b)).stableNorm() <= distance;
}

//! Returns, per corner pair, whether its two corners have different UVs or one of them has none. Pairs along
//! diagonals are never open.
//! \param uv one row per corner; a non-finite row means that the corner has no UV
std::vector<bool> openCornerPairs(const MeshData &mesh, const UvMatrix &uv);

//! A map as views draw it: triangle by triangle.
struct SoupMap
{
    UvMatrix uv;            //!< see soupUv()
    std::vector<bool> open; //!< see openCornerPairs()

    //! \param uv one row per corner
    static SoupMap of(const MeshData &mesh, const UvMatrix &uv);
};

} // namespace autocuts
