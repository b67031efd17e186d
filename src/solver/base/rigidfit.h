// The rigid motion between two sets of points. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <vector>

namespace autocuts {

//! A rotation about the origin, then a translation; and the two points that were matched exactly.
struct RigidMotion
{
    double c = 1, s = 0;
    Vec2 shift = Vec2::Zero();
    Vec2 fixedCentre = Vec2::Zero(), movingCentre = Vec2::Zero(); //!< weighted means of the points

    Vec2 turned(const Vec2 &p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
    Vec2 operator()(const Vec2 &p) const { return turned(p) + shift; }
};

//! A point that moves, and where it should come to lie.
struct PointMatch
{
    Vec2 fixed, moving;
    double weight = 1;
};

//! The motion that brings the moving points onto the fixed ones with the least weighted sum of squares; no
//! rotation where none is better. \pre the weights have a positive sum
RigidMotion fitRigid(const std::vector<PointMatch> &matches);

} // namespace autocuts
