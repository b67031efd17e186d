// UV position of a soup corner in the solver's flat coordinate vector. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <span>
#include <vector>

namespace autocuts {

//! View of x[2 * corner] and x[2 * corner + 1], the UV position of a soup corner in solver units; see Soup.
inline Eigen::Map<const Vec2> cornerAt(std::span<const double> x, int corner)
{
    return Eigen::Map<const Vec2>(x.data() + 2 * static_cast<std::size_t>(corner));
}

inline Eigen::Map<Vec2> cornerAt(std::vector<double> &x, int corner)
{
    return Eigen::Map<Vec2>(x.data() + 2 * static_cast<std::size_t>(corner));
}

} // namespace autocuts
