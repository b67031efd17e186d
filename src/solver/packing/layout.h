// A packing task in the packer's own terms, and a layout of it. Plain: no Qt.
#pragma once

#include "model/plain/packingsettings.h"
#include "solver/packing/outline.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts::packing {

//! A turn by an angle and a shift.
struct Pose
{
    double angle = 0;
    Vec2 position = Vec2::Zero(); //!< of the outline's centre, UV units
};

//! A rotation with its scale, applied many times.
struct Turn
{
    double c, s;
    Turn(double angle, double scale) : c(scale * std::cos(angle)), s(scale * std::sin(angle)) {}
    Vec2 operator()(const Vec2 &p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
    //! The transposed matrix: scale squared times the inverse.
    Vec2 transposed(const Vec2 &p) const { return {c * p.x() + s * p.y(), c * p.y() - s * p.x()}; }
};

struct Layout
{
    double scale = 0; //!< UV units per unit of the outlines
    std::vector<Pose> poses;
};

//! What does not change while islands are being moved.
struct PackProblem
{
    std::vector<Outline> outlines;
    std::vector<char> locked;
    std::vector<Pose> given;                         //!< where the islands were
    double unit = 1;                                 //!< UV units per unit of the outlines, as given
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< where points may be: the bin less its border
    double gutter = 0;                               //!< least distance between two islands, UV units
    PackRotation rotation = PackRotation::Free;

    int count() const { return static_cast<int>(outlines.size()); }
    Vec2 size() const { return upper - lower; }
    //! Locked islands keep the size they came with.
    double scaleOf(int island, double scale) const { return locked[island] ? unit : scale; }
    //! False for islands without a point: nothing can go wrong with those.
    bool movable(int island) const { return !locked[island] && !outlines[island].points.empty(); }
};

//! True when the boxes are nearer than distance in both directions.
inline bool areNear(const Eigen::AlignedBox2d &a, const Eigen::AlignedBox2d &b, double distance)
{
    return a.min().x() - distance < b.max().x() && b.min().x() - distance < a.max().x() &&
           a.min().y() - distance < b.max().y() && b.min().y() - distance < a.max().y();
}

//! The points of an outline where a layout puts them.
inline void placePoints(const Outline &outline, const Pose &pose, double scale, std::vector<Vec2> &result)
{
    const Turn turn(pose.angle, scale);
    result.resize(outline.points.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = turn(outline.points[i]) + pose.position;
}

} // namespace autocuts::packing
