// Where a UV map is cut, told from its UVs alone. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! The rule of the file format: UVs no farther apart than this part of the diagonal of the map's box are one.
inline constexpr double uvTolerance = 1e-6;

//! True when two corners have the same UV. \param distance how far apart they may be, in UV units
inline bool sameUv(const UvMatrix &uv, int a, int b, double distance)
{
    return (uv.row(a) - uv.row(b)).stableNorm() <= distance;
}

//! Per corner pair, true where its corners have different UVs or one has none. Pairs along diagonals are
//! never open. \param uv one row per corner; a non-finite row means that the corner has no UV
std::vector<bool> openCornerPairs(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
