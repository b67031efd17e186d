#include "solver/base/rigidfit.h"

#include <cmath>

namespace autocuts {

RigidMotion fitRigid(const std::vector<PointMatch> &matches)
{
    Vec2 a = Vec2::Zero(), b = Vec2::Zero();
    double sum = 0;
    for (const PointMatch &p : matches) {
        a += p.weight * p.fixed;
        b += p.weight * p.moving;
        sum += p.weight;
    }
    a /= sum;
    b /= sum;
    double dot = 0, cross = 0;
    for (const PointMatch &p : matches) {
        const Vec2 u = p.moving - b, v = p.fixed - a;
        dot += p.weight * u.dot(v);
        cross += p.weight * (u.x() * v.y() - u.y() * v.x());
    }
    const double length = std::hypot(dot, cross);
    RigidMotion motion;
    if (length > 0) {
        motion.c = dot / length;
        motion.s = cross / length;
    }
    motion.shift = a - motion.turned(b);
    motion.fixedCentre = a;
    motion.movingCentre = b;
    return motion;
}

} // namespace autocuts
