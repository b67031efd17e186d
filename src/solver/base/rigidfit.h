// Rigid motion or similarity that fits one set of points to another. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <cmath>
#include <vector>

namespace autocuts {

//! A rotation about the origin followed by a translation, and the centres of the two sets of points, which it
//! maps onto each other.
struct RigidMotion
{
    double c = 1, s = 0;
    Vec2 shift = Vec2::Zero();
    Vec2 fixedCentre = Vec2::Zero(), movingCentre = Vec2::Zero(); //!< weighted means of the points

    Vec2 turned(const Vec2 &p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
    Vec2 operator()(const Vec2 &p) const { return turned(p) + shift; }
};

//! A moving point and its target.
struct PointMatch
{
    Vec2 fixed, moving;
    double weight = 1;
};

//! The motion that takes the moving points to the fixed ones with the least weighted sum of squared
//! distances; without rotation when no rotation is better than another.
//! \pre the weights have a positive sum
RigidMotion fitRigid(const std::vector<PointMatch> &matches);

//! A rotation and a scale about the origin followed by a translation.
struct SimilarMotion
{
    double c = 1, s = 0; //!< scale times cosine and sine
    Vec2 shift = Vec2::Zero();

    double scale() const { return std::hypot(c, s); }
    Vec2 operator()(const Vec2 &p) const
    {
        return Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + shift;
    }
};

//! The same with a scale. The scale is 1 when the moving points coincide, and 0 when no rotation is better
//! than another. \pre the weights have a positive sum
SimilarMotion fitSimilar(const std::vector<PointMatch> &matches);

} // namespace autocuts
