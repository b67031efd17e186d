// The triangles around one point of a map, and the best position of the point.
#pragma once

#include "model/plain/types.h"

#include <limits>
#include <vector>

namespace autocuts::multires {

constexpr double infinite = std::numeric_limits<double>::infinity();
//! Newton steps of one point. Chosen by hand.
constexpr int descentSteps = 6;

//! Triangles (point, a, b), each counter-clockwise; b of one is a of the next. Their 3D shapes define the
//! distortion of the map; triangles without area in 3D must not flip but have no distortion.
class PointFan
{
public:
    void clear() { mSpokes.clear(); }
    //! \param p,a3,b3 corners of the 3D triangle in units of the map; p is the point
    //! \param a,b their UVs
    void add(const Vec3 &p, const Vec3 &a3, const Vec3 &b3, const Vec2 &a, const Vec2 &b);

    //! Area in 3D.
    double area() const;
    //! Area times symmetric Dirichlet energy with the point at p; infinite when a triangle flips.
    double energy(const Vec2 &p, Vec2 *gradient = nullptr) const;
    //! True when p is inside one of the triangles with the point at `from`.
    bool covers(const Vec2 &from, const Vec2 &p) const;

    //! Moves p to lower energy.
    //! \param value energy(p), before and after
    void descend(Vec2 &p, double &value, int steps) const;
    //! A position for a point that separates from `kept`, a corner of the polygon around the point from which
    //! the whole polygon is visible.
    //! \param good false when none was found
    Vec2 placeInside(const Vec2 &kept, bool &good) const;
    //! The same for a point on the outline: on the side from `kept` to `end` where the polygon is visible
    //! from that side, else in a notch beside `kept`.
    //! \param hasFirst the first triangle begins at `kept` (else the last one ends there)
    Vec2 placeOnSide(const Vec2 &kept, const Vec2 &end, double share, bool hasFirst, bool &good) const;

private:
    struct Spoke
    {
        Vec2 a, b;
        double length, along,
            height; //!< at rest: a at (0, 0), b at (length, 0), the point at (along, height)
        double area;
    };

    double placeNear(const Vec2 &kept, bool hasFirst, Vec2 &place) const;

    std::vector<Spoke> mSpokes;
};

} // namespace autocuts::multires
