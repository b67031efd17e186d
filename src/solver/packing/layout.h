// A packing problem in the packer's own terms, and a layout that solves it. Plain: no Qt.
#pragma once

#include "model/plain/packingsettings.h"
#include "solver/packing/outline.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace autocuts::packing {

//! Where an outline is put: turned about its centre, then moved.
struct Pose
{
    double angle = 0;             //!< radians, counter-clockwise
    Vec2 position = Vec2::Zero(); //!< of the outline's centre, UV units
};

//! A rotation with a scale, precomputed for many points.
struct Turn
{
    double c, s;
    Turn(double angle, double scale) : c(scale * std::cos(angle)), s(scale * std::sin(angle)) {}
    Vec2 operator()(const Vec2 &p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
    //! Multiplies by the transposed matrix, which is scale squared times the inverse.
    Vec2 transposed(const Vec2 &p) const { return {c * p.x() + s * p.y(), c * p.y() - s * p.x()}; }
};

//! Where all islands are put.
struct Layout
{
    double scale = 0;        //!< of the islands that are not locked: UV units per unit of the outlines
    std::vector<Pose> poses; //!< per island
};

//! The input of the search: what stays the same while islands are moved.
struct PackProblem
{
    std::vector<Outline> outlines;
    std::vector<char> locked;                        //!< per island
    std::vector<Pose> given;                         //!< per island: its original pose
    double unit = 1;                                 //!< original scale: UV units per unit of the outlines
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< allowed range of points: the bin less its border
    double gutter = 0;                               //!< least distance between two islands, UV units
    PackRotation rotation = PackRotation::Free;
    std::vector<char> upright; //!< per island: it is not turned; empty: none
    std::vector<char> aligned; //!< per island: it is turned by right angles only; empty: none

    int count() const { return static_cast<int>(outlines.size()); }
    Vec2 size() const { return upper - lower; }
    //! Scale of an island in a layout of this scale: locked islands keep their original size.
    double scaleOf(int island, double scale) const { return locked[island] ? unit : scale; }
    //! How many directions an island may have, evenly spaced from its original one; 0: any. Islands that may
    //! have any and whose border is square have four, along the axes.
    int directions(int island) const
    {
        if (!upright.empty() && upright[island])
            return 1;
        if (!aligned.empty() && aligned[island])
            return directionsOf(rotation) % 4 == 0 ? 4 : directionsOf(rotation);
        return standsSquare(island) ? 4 : directionsOf(rotation);
    }
    bool turnsFreely(int island) const { return directions(island) == 0; }
    //! The angle of a direction. \pre !turnsFreely(island)
    double angleOf(int island, int direction) const
    {
        const bool isSquare = directions(island) == 4 && standsSquare(island);
        return (isSquare ? *outlines[island].squareAngle : 0) +
               2 * std::numbers::pi * direction / directions(island);
    }
    //! An allowed angle at which the box around the island is small, below a quarter turn where there are
    //! steps.
    double smallBoxAngle(int island) const;
    //! True when the rotation is free but the border is to be along the axes.
    bool standsSquare(int island) const
    {
        return rotation == PackRotation::Free && outlines[island].squareAngle;
    }
    //! False for locked islands and for islands without points.
    bool movable(int island) const { return !locked[island] && !outlines[island].points.empty(); }
};

//! True when the boxes are nearer to each other than `distance` along both axes.
inline bool areNear(const Eigen::AlignedBox2d &a, const Eigen::AlignedBox2d &b, double distance)
{
    return a.min().x() - distance < b.max().x() && b.min().x() - distance < a.max().x() &&
           a.min().y() - distance < b.max().y() && b.min().y() - distance < a.max().y();
}

//! Computes the points of an outline in a pose, UV units.
inline void placePoints(const Outline &outline, const Pose &pose, double scale, std::vector<Vec2> &result)
{
    const Turn turn(pose.angle, scale);
    result.resize(outline.points.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = turn(outline.points[i]) + pose.position;
}

} // namespace autocuts::packing
