// Segments in the plane: whether they cross, and how far a point is from one. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <algorithm>

namespace autocuts {

//! True when the segments a b and c d cross at an inner point of both. Segments that only touch or lie on one
//! line do not cross.
inline bool segmentsCross(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &d)
{
    const auto opposite = [](double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
    return opposite(cross2(a, b, c), cross2(a, b, d)) && opposite(cross2(c, d, a), cross2(c, d, b));
}

//! Squared distance of p to the segment a, b.
inline double pointSegmentSquared(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 d = b - a, q = p - a;
    const double length = d.squaredNorm();
    const double t = length > 0 ? std::min(1.0, std::max(0.0, q.dot(d) / length)) : 0;
    return (q - t * d).squaredNorm();
}

} // namespace autocuts
