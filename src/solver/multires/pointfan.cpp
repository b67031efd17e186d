#include "solver/multires/pointfan.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::multires {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Mean symmetric Dirichlet energy above which a point had better not stay on the side.
constexpr double flat = 100;
//! How often a distance is halved in search of a valid position.
constexpr int halvings = 40;

} // namespace

double PointFan::area() const
{
    double sum = 0;
    for (const Spoke &s : mSpokes)
        sum += s.area;
    return sum;
}

bool PointFan::covers(const Vec2 &from, const Vec2 &p) const
{
    return std::any_of(mSpokes.begin(), mSpokes.end(), [&](const Spoke &s) {
        return cross2(from, s.a, p) >= 0 && cross2(s.a, s.b, p) >= 0 && cross2(s.b, from, p) >= 0;
    });
}

void PointFan::add(const Vec3 &p, const Vec3 &a3, const Vec3 &b3, const Vec2 &a, const Vec2 &b)
{
    // At rest: a at the origin, b on the x axis, p above it.
    const Vec3 base = b3 - a3, side = p - a3;
    const double length = base.norm();
    Spoke spoke;
    spoke.a = a;
    spoke.b = b;
    const double height = length > 0 ? base.cross(side).norm() / length : 0;
    // Triangles without area must not flip but have no distortion.
    if (!(height > 1e-6 * length)) {
        spoke.length = 1;
        spoke.along = 0.5;
        spoke.height = 1;
        spoke.area = 0;
    } else {
        spoke.length = length;
        spoke.along = base.dot(side) / length;
        spoke.height = height;
        spoke.area = 0.5 * length * height;
    }
    mSpokes.push_back(spoke);
}

double PointFan::energy(const Vec2 &p, Vec2 *gradient) const
{
    double sum = 0;
    if (gradient)
        gradient->setZero();
    for (const Spoke &s : mSpokes) {
        // Columns of the Jacobian: along the base, and across it.
        const Vec2 first = (s.b - s.a) / s.length;
        const Vec2 second = (p - s.a - first * s.along) / s.height;
        const double det = first.x() * second.y() - first.y() * second.x();
        if (!(det > 0))
            return infinite;
        const double squares = first.squaredNorm() + second.squaredNorm(), inverse = 1 / (det * det);
        sum += s.area * (squares + squares * inverse);
        if (gradient) {
            const Vec2 turned(-first.y(), first.x()); // derivative of the determinant by `second`
            *gradient +=
                s.area / s.height * (2 * (1 + inverse) * second - 2 * squares * inverse / det * turned);
        }
    }
    return sum;
}

//! Newton steps whose Hessian comes from differences of gradients.
void PointFan::descend(Vec2 &p, double &value, int steps) const
{
    for (int step = 0; step < steps; ++step) {
        Vec2 g, gu, gv;
        energy(p, &g);
        // Step of the differences, relative to the size of the triangles.
        const double h = 1e-4 * std::sqrt((mSpokes[0].a - p).squaredNorm());
        if (!(energy(p + Vec2(h, 0), &gu) < infinite) || !(energy(p + Vec2(0, h), &gv) < infinite))
            return;
        Eigen::Matrix2d hessian;
        hessian.col(0) = (gu - g) / h;
        hessian.col(1) = (gv - g) / h;
        const double mixed = 0.5 * (hessian(0, 1) + hessian(1, 0));
        hessian(0, 1) = hessian(1, 0) = mixed;
        const double det = hessian.determinant(), trace = hessian.trace();
        Vec2 move = -g / std::max(std::abs(trace), 1e-30);
        if (det > 1e-6 * trace * trace && trace > 0)
            move = Vec2(-(hessian(1, 1) * g.x() - mixed * g.y()) / det,
                        -(hessian(0, 0) * g.y() - mixed * g.x()) / det);
        double length = 1;
        bool moved = false;
        for (int i = 0; i < 8 && !moved; ++i, length *= 0.4) {
            const double next = energy(p + length * move);
            if (next < value) {
                moved = value - next > 1e-6 * value;
                p += length * move;
                value = next;
                break;
            }
        }
        if (!moved)
            return;
    }
}

//! Looks for a position near the kept point, on the bisector of the polygon's angle there, from where the
//! whole polygon is visible.
//! \return the energy; infinite when none was found
double PointFan::placeNear(const Vec2 &kept, bool hasFirst, Vec2 &place) const
{
    const Vec2 from = (hasFirst ? mSpokes.front().b : mSpokes.front().a) - kept;
    double angle = 0;
    for (const Spoke &s : mSpokes) {
        const Vec2 u = s.a - kept, v = s.b - kept;
        if (u.squaredNorm() > 0 && v.squaredNorm() > 0)
            angle += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    }
    const Vec2 direction = Eigen::Rotation2Dd(0.5 * angle) * from;
    double length = 0.5, value = infinite;
    for (int i = 0; i < halvings && !(value < infinite); ++i, length *= 0.5) {
        place = kept + length * direction;
        value = energy(place);
    }
    return value;
}

Vec2 PointFan::placeInside(const Vec2 &kept, bool &good) const
{
    // The triangles run around the point: a of each is b of the one before.
    Vec2 mean = Vec2::Zero();
    for (const Spoke &s : mSpokes)
        mean += s.a / double(mSpokes.size());
    Vec2 best = mean;
    double value = energy(mean);
    for (double share = 0.5; !(value < infinite) && share > 0.01; share *= 0.5) {
        best = kept + share * (mean - kept);
        value = energy(best);
    }
    if (!(value < infinite))
        value = placeNear(kept, true, best);
    good = value < infinite;
    if (good)
        descend(best, value, descentSteps);
    return best;
}

Vec2 PointFan::placeOnSide(const Vec2 &kept, const Vec2 &end, double share, bool hasFirst, bool &good) const
{
    Vec2 best = kept + share * (end - kept);
    double value = infinite;
    for (int i = 0; i < halvings; ++i, share *= 0.5) {
        const Vec2 p = kept + share * (end - kept);
        const double here = energy(p);
        if (here < value) {
            best = p;
            value = here;
        } else if (value < infinite) {
            break;
        }
    }
    // Where the polygon's angle is 180 degrees or more, the triangles at the ends of the side would be flat:
    // use a notch.
    if (!(value < flat * area())) {
        Vec2 notch;
        double other = placeNear(kept, hasFirst, notch);
        if (other < infinite)
            descend(notch, other, descentSteps);
        if (other < value) {
            value = other;
            best = notch;
        }
    }
    good = value < infinite;
    return best;
}

} // namespace autocuts::multires
