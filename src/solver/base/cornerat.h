// Places of corners in the solver's coordinates. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <span>
#include <vector>

namespace autocuts {

//! Where a soup corner lies: the view of x[2 * corner] and x[2 * corner + 1], see Soup.
inline Eigen::Map<const Vec2> cornerAt(std::span<const double> x, int corner)
{
    return Eigen::Map<const Vec2>(x.data() + 2 * static_cast<std::size_t>(corner));
}

inline Eigen::Map<Vec2> cornerAt(std::vector<double> &x, int corner)
{
    return Eigen::Map<Vec2>(x.data() + 2 * static_cast<std::size_t>(corner));
}

} // namespace autocuts
