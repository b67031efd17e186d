#include "solver/base/rigidfit.h"

namespace autocuts {

namespace {

//! Weighted means of the points, and the sums of which the best rotation and scale are made.
struct Moments
{
    Vec2 fixed = Vec2::Zero(), moving = Vec2::Zero();
    double dot = 0, cross = 0, squares = 0; //!< about the means; squares of the moving points

    explicit Moments(const std::vector<PointMatch> &matches)
    {
        double sum = 0;
        for (const PointMatch &p : matches) {
            fixed += p.weight * p.fixed;
            moving += p.weight * p.moving;
            sum += p.weight;
        }
        fixed /= sum;
        moving /= sum;
        for (const PointMatch &p : matches) {
            const Vec2 u = p.moving - moving, v = p.fixed - fixed;
            dot += p.weight * u.dot(v);
            cross += p.weight * (u.x() * v.y() - u.y() * v.x());
            squares += p.weight * u.squaredNorm();
        }
    }
};

} // namespace

RigidMotion fitRigid(const std::vector<PointMatch> &matches)
{
    const Moments moments(matches);
    const double length = std::hypot(moments.dot, moments.cross);
    RigidMotion motion;
    if (length > 0) {
        motion.c = moments.dot / length;
        motion.s = moments.cross / length;
    }
    motion.shift = moments.fixed - motion.turned(moments.moving);
    motion.fixedCentre = moments.fixed;
    motion.movingCentre = moments.moving;
    return motion;
}

SimilarMotion fitSimilar(const std::vector<PointMatch> &matches)
{
    const Moments moments(matches);
    SimilarMotion motion;
    if (moments.squares > 0) {
        motion.c = moments.dot / moments.squares;
        motion.s = moments.cross / moments.squares;
    }
    motion.shift = moments.fixed - motion(moments.moving);
    return motion;
}

} // namespace autocuts
