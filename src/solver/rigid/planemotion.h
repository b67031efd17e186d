// Rigid motion of the plane. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <cmath>

namespace autocuts::rigid {

//! A rotation about the origin, then a translation.
struct PlaneMotion
{
    double c = 1, s = 0;
    Vec2 shift = Vec2::Zero();

    //! Takes the segment a b onto the line of p q, midpoint on midpoint.
    static PlaneMotion between(const Vec2 &a, const Vec2 &b, const Vec2 &p, const Vec2 &q)
    {
        const Vec2 from = b - a, to = q - p;
        const double length = from.norm() * to.norm();
        PlaneMotion motion;
        if (length > 0) {
            motion.c = from.dot(to) / length;
            motion.s = (from.x() * to.y() - from.y() * to.x()) / length;
        }
        motion.shift = 0.5 * (p + q) - motion.turned(0.5 * (a + b));
        return motion;
    }

    Vec2 turned(const Vec2 &p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
    Vec2 operator()(const Vec2 &p) const { return turned(p) + shift; }
    //! First the other motion, then this one.
    PlaneMotion after(const PlaneMotion &first) const
    {
        return {c * first.c - s * first.s, s * first.c + c * first.s, (*this)(first.shift)};
    }
    PlaneMotion inverse() const
    {
        PlaneMotion back{c, -s};
        back.shift = -back.turned(shift);
        return back;
    }
};

} // namespace autocuts::rigid
