// UVs in the form in which FBX files hold them.
#pragma once

#include "model/plain/types.h"

namespace autocuts {

//! UVs and which of them each file corner has.
struct FbxUvData
{
    std::vector<double> uv; //!< u and v of each UV
    std::vector<int> index; //!< -1: none
};

//! Shares the UVs of equal bits at one control point. \param point of each corner, below pointCount
//! \param uv one row per corner
FbxUvData fbxUvData(const std::vector<int> &point, int pointCount, const UvMatrix &uv);

} // namespace autocuts
