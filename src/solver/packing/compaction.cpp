#include "solver/packing/compaction.h"

#include "solver/base/constant.h"
#include "solver/base/segmentcrossing.h"

#include <algorithm>

namespace autocuts::packing {

namespace {

//! Share by which compactLayout() lets the scale grow at first, and the share at which it ends; in between
//! the share is halved when islands meet.
AUTOCUTS_CONSTANT(double, firstStep, 3e-3);
constexpr double smallestStep = 2e-4;
constexpr int sweeps = 60; // over the contacts of islands in each step

} // namespace

Compaction::Compaction(const PackProblem &problem, Layout layout)
    : mProblem(&problem), mLayout(std::move(layout)), mBodies(problem.count())
{
    const double side = std::sqrt(problem.size().x() * problem.size().y());
    mTarget = 1.002 * problem.gutter + 1e-6 * side;
    mReach = mTarget + std::max(0.5 * problem.gutter, 0.002 * side);
    for (int i = 0; i < problem.count(); ++i)
        refresh(i);
}

void Compaction::refresh(int body)
{
    const Outline &outline = mProblem->outlines[body];
    const double scale = mProblem->scaleOf(body, mLayout.scale);
    Body &b = mBodies[body];
    b.c = scale * std::cos(mLayout.poses[body].angle);
    b.s = scale * std::sin(mLayout.poses[body].angle);
    b.reach = scale * outline.radius;
    b.inverseMass = b.inverseInertia = 0;
    if (mProblem->movable(body)) {
        const double size = std::max(b.reach, mTarget);
        b.inverseMass = 1 / (size * size);
        if (mProblem->turnsFreely(body))
            b.inverseInertia = b.inverseMass / (0.4 * size * size);
    }
}

void Compaction::setScale(double scale)
{
    mLayout.scale = scale;
    for (int i = 0; i < mProblem->count(); ++i)
        refresh(i);
}

void Compaction::collectContacts(WorkMeter &work)
{
    mContacts.clear();
    const std::vector<PlacedEdge> edges = placedEdges(*mProblem, mLayout);
    const SegmentGrid grid(edges, mProblem->lower, mProblem->upper, mReach);
    std::vector<int> firstEdge(mProblem->count() + 1, 0);
    for (int i = 0; i < mProblem->count(); ++i)
        firstEdge[i + 1] = firstEdge[i] + static_cast<int>(mProblem->outlines[i].edges.size());
    const double limit = mReach * mReach;
    std::vector<Vec2> points;
    double tests = 0;
    for (int i = 0; i < mProblem->count(); ++i) {
        placePoints(mProblem->outlines[i], mLayout.poses[i], mProblem->scaleOf(i, mLayout.scale), points);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const int cell = grid.cellOf(points[k]);
            for (const int *e = grid.begin(cell); e != grid.end(cell); ++e) {
                const PlacedEdge &edge = edges[*e];
                if (edge.island == i || (mProblem->locked[i] && mProblem->locked[edge.island]) ||
                    pointSegmentSquared(points[k], edge.a, edge.b) >= limit)
                    continue;
                const Outline &other = mProblem->outlines[edge.island];
                const Outline::Edge &local = other.edges[*e - firstEdge[edge.island]];
                mContacts.push_back({i, edge.island, mProblem->outlines[i].points[k], other.points[local.a],
                                     other.points[local.b]});
            }
            tests += static_cast<double>(grid.end(cell) - grid.begin(cell));
        }
        refresh(i);
    }
    mCollected = mLayout;
    work.add(60 * static_cast<double>(edges.size()) + 15.0 * grid.entryCount() + 8 * tests +
             grid.cellCount());
}

void Compaction::move(int body, const Vec2 &arm, const Vec2 &impulse)
{
    Body &b = mBodies[body];
    Pose &pose = mLayout.poses[body];
    pose.position += b.inverseMass * impulse;
    const double turn =
        std::clamp(b.inverseInertia * (arm.x() * impulse.y() - arm.y() * impulse.x()), -0.1, 0.1);
    if (turn != 0) {
        const double inverse = 1 / std::sqrt(1 + turn * turn);
        const double c = (b.c - turn * b.s) * inverse;
        b.s = (b.s + turn * b.c) * inverse;
        b.c = c;
        pose.angle += std::atan(turn);
    }
}

bool Compaction::contactsAreStale() const
{
    if (mCollected.poses.empty())
        return true;
    const double growth = std::abs(mLayout.scale - mCollected.scale);
    for (int i = 0; i < mProblem->count(); ++i) {
        const Pose &now = mLayout.poses[i], &then = mCollected.poses[i];
        const double moved = (now.position - then.position).norm() +
                             mBodies[i].reach * std::abs(now.angle - then.angle) +
                             growth * mProblem->outlines[i].radius;
        if (2 * moved > mReach - mTarget)
            return true;
    }
    return false;
}

bool Compaction::push(const Contact &contact)
{
    const Body &p = mBodies[contact.pointBody], &q = mBodies[contact.edgeBody];
    const auto apply = [](const Body &b, const Vec2 &v) {
        return Vec2(b.c * v.x() - b.s * v.y(), b.s * v.x() + b.c * v.y());
    };
    const Vec2 &origin = mLayout.poses[contact.edgeBody].position;
    const Vec2 armP = apply(p, contact.point);
    const Vec2 a = apply(q, contact.a), d = apply(q, contact.b) - a;
    const Vec2 offset = mLayout.poses[contact.pointBody].position - origin + armP - a;
    const double length = d.squaredNorm();
    const double t = length > 0 ? std::clamp(offset.dot(d) / length, 0.0, 1.0) : 0;
    const Vec2 gap = offset - t * d;
    const double squared = gap.squaredNorm();
    if (squared >= mTarget * mTarget || squared == 0)
        return false;
    const double distance = std::sqrt(squared);
    const Vec2 n = gap / distance;
    const Vec2 armQ = a + t * d;
    const double turnP = armP.x() * n.y() - armP.y() * n.x(), turnQ = armQ.x() * n.y() - armQ.y() * n.x();
    const double give =
        p.inverseMass + q.inverseMass + p.inverseInertia * turnP * turnP + q.inverseInertia * turnQ * turnQ;
    if (!(give > 0))
        return false;
    const Vec2 impulse = n * ((mTarget - distance) / give);
    move(contact.pointBody, armP, impulse);
    move(contact.edgeBody, armQ, -impulse);
    // A contact nearer to the target than to the gutter does not ask for another sweep.
    return distance < 0.5 * (mTarget + mProblem->gutter);
}

bool Compaction::pushFromWalls(int body)
{
    const Vec2 position = mLayout.poses[body].position;
    const double reach = mBodies[body].reach;
    bool pushed = false;
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const double wall = sign > 0 ? mProblem->lower[axis] : mProblem->upper[axis];
            if (sign * (position[axis] - wall) >= reach)
                continue;
            const Body &b = mBodies[body];
            // Pushed a little farther than the wall, for the same reason as mTarget.
            const double inset = 0.5 * (mTarget - mProblem->gutter);
            double deepest = -inset;
            Vec2 arm = Vec2::Zero();
            for (const Vec2 &p : mProblem->outlines[body].hull) {
                const Vec2 q(b.c * p.x() - b.s * p.y(), b.s * p.x() + b.c * p.y());
                const double depth = -sign * (mLayout.poses[body].position[axis] + q[axis] - wall);
                if (depth > deepest) {
                    deepest = depth;
                    arm = q;
                }
            }
            if (deepest <= -inset)
                continue;
            Vec2 n = Vec2::Zero();
            n[axis] = sign;
            const double turn = arm.x() * n.y() - arm.y() * n.x();
            const double give = b.inverseMass + b.inverseInertia * turn * turn;
            move(body, arm, n * ((deepest + inset) / give));
            pushed = pushed || deepest > 0;
        }
    }
    return pushed;
}

bool Compaction::resolve(int sweeps, WorkMeter &work)
{
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        if (work.cancelled())
            return false;
        bool pushed = false;
        for (int i = 0; i < mProblem->count(); ++i) {
            if (mProblem->movable(i))
                pushed = pushFromWalls(i) || pushed;
        }
        if (contactsAreStale())
            collectContacts(work);
        // The order alternates, so that pushes travel through the islands in both directions.
        const std::size_t count = mContacts.size();
        for (std::size_t k = 0; k < count; ++k)
            pushed = push(mContacts[sweep % 2 == 0 ? k : count - 1 - k]) || pushed;
        work.add(9 * static_cast<double>(count) + 6.0 * mProblem->count());
        if (!pushed && !contactsAreStale())
            return true;
    }
    return false;
}

Layout compactLayout(const PackProblem &problem, const Layout &layout, double ceiling, WorkMeter &work)
{
    Layout best = layout;
    Compaction bodies(problem, best);
    for (double step = firstStep; step > smallestStep && best.scale < ceiling && !work.stop();) {
        bodies.setScale(std::min(ceiling, (1 + step) * best.scale));
        if (bodies.resolve(sweeps, work) && isValidLayout(problem, bodies.layout(), work)) {
            best = bodies.layout();
        } else {
            step *= 0.5;
            bodies = Compaction(problem, best);
        }
    }
    return best;
}

} // namespace autocuts::packing
