// Matrix types used everywhere. Plain: no Qt.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace autocuts {

//! One row per corner, columns u and v.
using UvMatrix = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
//! One row per vertex, columns x, y and z.
using PositionMatrix = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

//! Twice the signed area of the triangle a, b, c; positive when counter-clockwise.
inline double cross2(const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

} // namespace autocuts
