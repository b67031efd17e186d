#include "solver/packing/guidedsearch.h"

#include "solver/base/constant.h"

#include <algorithm>
#include <numbers>

namespace autocuts::packing {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Sample points on the outline: hull corners, then points along the edges, at least 0.3 spacings apart.
std::vector<Vec2> samplePoints(const Outline &outline, double spacing)
{
    std::vector<Vec2> samples;
    const double least = 0.3 * spacing;
    const auto offer = [&](const Vec2 &p) {
        for (const Vec2 &q : samples) {
            if ((p - q).squaredNorm() < least * least)
                return;
        }
        samples.push_back(p);
    };
    for (const Vec2 &p : outline.hull)
        offer(p);
    for (const Outline::Edge &e : outline.edges) {
        const Vec2 &a = outline.points[e.a], &b = outline.points[e.b];
        const int parts = static_cast<int>((b - a).norm() / spacing) + 1;
        for (int k = 0; k <= parts; ++k)
            offer(a + (b - a) * (static_cast<double>(k) / parts));
    }
    return samples;
}

//! Sorts points by recursive bisection, so that groups of `leaf` consecutive points are compact.
void sortInPlane(Vec2 *begin, Vec2 *end, int leaf)
{
    if (end - begin <= leaf)
        return;
    Eigen::AlignedBox2d box;
    for (const Vec2 *p = begin; p != end; ++p)
        box.extend(*p);
    const Vec2 size = box.sizes();
    const int axis = size.x() >= size.y() ? 0 : 1;
    Vec2 *middle = begin + ((end - begin) / 2 + leaf - 1) / leaf * leaf;
    std::sort(begin, end, [axis](const Vec2 &p, const Vec2 &q) {
        return p[axis] < q[axis] || (p[axis] == q[axis] && p[1 - axis] < q[1 - axis]);
    });
    sortInPlane(begin, middle, leaf);
    sortInPlane(middle, end, leaf);
}

//! Gutters between two sample points. Tuned on four island sets together with the raster's safety, see
//! README.md; 1.5 before.
AUTOCUTS_CONSTANT(double, sampleSpacing, 2.5);
AUTOCUTS_CONSTANT(int, randomPoses, 24); // that are tried for an island in each pass
constexpr int clusterSize = 8;           // sample points that are rejected together

} // namespace

Separation::Separation(const PackProblem &problem, double scale, WorkMeter &work) : mProblem(problem)
{
    const double side = std::sqrt(problem.size().x() * problem.size().y());
    mBodies.reserve(problem.count());
    for (int i = 0; i < problem.count(); ++i) {
        const Outline &outline = problem.outlines[i];
        const double own = problem.scaleOf(i, scale);
        const double cell = side / 400 / own;
        // The grid reaches far enough for the gutter at scales down to two thirds of this one.
        Body body{DistanceField(outline, cell, 1.5 * problem.gutter / own + 2 * cell, work), {}, {}};
        body.samples = samplePoints(outline, std::max(sampleSpacing * problem.gutter, side / 250) / own);
        sortInPlane(body.samples.data(), body.samples.data() + body.samples.size(), clusterSize);
        const int count = static_cast<int>(body.samples.size());
        for (int begin = 0; begin < count; begin += clusterSize) {
            Cluster cluster{Vec2::Zero(), 0, begin, std::min(begin + clusterSize, count)};
            Eigen::AlignedBox2d box;
            for (int k = cluster.begin; k < cluster.end; ++k)
                box.extend(body.samples[k]);
            cluster.centre = 0.5 * (box.min() + box.max());
            for (int k = cluster.begin; k < cluster.end; ++k)
                cluster.radius = std::max(cluster.radius, (body.samples[k] - cluster.centre).norm());
            body.clusters.push_back(cluster);
        }
        work.add(100.0 * count);
        mBodies.push_back(std::move(body));
    }
}

Separation::Frame Separation::frameOf(int body, const Pose &pose) const
{
    return {std::cos(pose.angle),
            std::sin(pose.angle),
            pose.position.x(),
            pose.position.y(),
            mProblem.scaleOf(body, mLayout.scale),
            pose.angle};
}

//! Calls visit(x, y, depth) for every sample of island `points` that lies inside island `field` grown by the
//! gutter; x and y are in the coordinates of the field's outline, the depth in UV units.
template <class Visit>
void Separation::visitDeepPoints(int points, const Frame &from, int field, const Frame &to,
                                 double &operations, Visit visit) const
{
    const double inverse = 1 / to.scale, ratio = from.scale * inverse;
    const double c = ratio * (from.c * to.c + from.s * to.s), s = ratio * (from.s * to.c - from.c * to.s);
    const double dx = (from.x - to.x) * inverse, dy = (from.y - to.y) * inverse;
    const double shiftX = to.c * dx + to.s * dy, shiftY = to.c * dy - to.s * dx;
    const double gutter = mProblem.gutter * inverse;
    const DistanceField &distance = mBodies[field].field;
    operations += 2;
    if (distance.isFartherThan(shiftX, shiftY, ratio * mProblem.outlines[points].radius + gutter))
        return;
    const Body &p = mBodies[points];
    const bool several = p.clusters.size() > 1;
    for (const Cluster &cluster : p.clusters) {
        operations += several;
        if (several && distance.isFartherThan(c * cluster.centre.x() - s * cluster.centre.y() + shiftX,
                                              s * cluster.centre.x() + c * cluster.centre.y() + shiftY,
                                              ratio * cluster.radius + gutter))
            continue;
        operations += cluster.end - cluster.begin;
        for (int k = cluster.begin; k < cluster.end; ++k) {
            const double x = c * p.samples[k].x() - s * p.samples[k].y() + shiftX;
            const double y = s * p.samples[k].x() + c * p.samples[k].y() + shiftY;
            const double depth = gutter - distance.at(x, y);
            if (depth > 0)
                visit(x, y, depth * to.scale);
        }
    }
}

Separation::Depth Separation::pairDepth(int i, const Frame &frame, int j, double &operations) const
{
    Depth depth;
    const auto add = [&](double, double, double d) {
        depth.sum += d;
        depth.deepest = std::max(depth.deepest, d);
    };
    visitDeepPoints(i, frame, j, mFrames[j], operations, add);
    visitDeepPoints(j, mFrames[j], i, frame, operations, add);
    return depth;
}

//! Calls visit(j) for the islands whose circles come within the gutter of the body's; stops when it returns
//! false.
template <class Visit>
void Separation::visitNeighbours(int body, const Frame &frame, Visit visit) const
{
    const double own = mRadius[body] + mProblem.gutter;
    for (int j = 0; j < mProblem.count(); ++j) {
        const double reach = own + mRadius[j];
        const double dx = mFrames[j].x - frame.x, dy = mFrames[j].y - frame.y;
        if (dx * dx + dy * dy < reach * reach && j != body && !visit(j))
            return;
    }
}

double Separation::cost(int body, const Pose &pose, double limit, WorkMeter &work) const
{
    double operations = 0, sum = 0;
    const Frame frame = frameOf(body, pose);
    visitNeighbours(body, frame, [&](int j) {
        sum += mWeights[index(body, j)] * pairDepth(body, frame, j, operations).sum;
        return sum < limit;
    });
    work.add(4.9 * operations + 1.5 * mProblem.count());
    return sum;
}

Separation::Evaluation Separation::evaluate(int body, const Pose &pose, WorkMeter &work) const
{
    double operations = 0;
    Evaluation result;
    const Frame frame = frameOf(body, pose);
    visitNeighbours(body, frame, [&](int j) {
        const double weight = mWeights[index(body, j)];
        // The depth of a point falls when it moves along the gradient of the distance. The sign is 1 when the
        // moving body has the point and -1 when it has the field.
        const auto add = [&](const Frame &field, const DistanceField &distance, double sign, double x,
                             double y, double depth) {
            const Vec2 g = distance.gradientAt({x, y});
            const double nx = sign * weight * (field.c * g.x() - field.s * g.y());
            const double ny = sign * weight * (field.s * g.x() + field.c * g.y());
            const double armX = field.scale * (field.c * x - field.s * y) + field.x - frame.x;
            const double armY = field.scale * (field.s * x + field.c * y) + field.y - frame.y;
            result.cost += weight * depth;
            result.byPosition -= Vec2(nx, ny);
            result.byAngle -= armX * ny - armY * nx;
            operations += 2;
        };
        visitDeepPoints(body, frame, j, mFrames[j], operations, [&](double x, double y, double depth) {
            add(mFrames[j], mBodies[j].field, 1, x, y, depth);
        });
        visitDeepPoints(j, mFrames[j], body, frame, operations, [&](double x, double y, double depth) {
            add(frame, mBodies[body].field, -1, x, y, depth);
        });
        return true;
    });
    work.add(4.9 * operations + 1.5 * mProblem.count());
    return result;
}

bool Separation::confine(int body, Pose &pose) const
{
    const Turn turn(pose.angle, mLayout.scale);
    Eigen::AlignedBox2d box;
    for (const Vec2 &p : mProblem.outlines[body].hull)
        box.extend(turn(p));
    const Vec2 low = mProblem.lower - box.min(), high = mProblem.upper - box.max();
    if (low.x() > high.x() || low.y() > high.y())
        return false;
    pose.position = pose.position.cwiseMax(low).cwiseMin(high);
    return true;
}

bool Separation::confineByTurning(int body, Pose &pose, double largestTurn) const
{
    if (confine(body, pose))
        return true;
    if (!mProblem.turnsFreely(body))
        return false;
    constexpr double step = std::numbers::pi / 360;
    for (double turn = step; turn <= largestTurn; turn += step) {
        for (const double sign : {1.0, -1.0}) {
            Pose turned{pose.angle + sign * turn, pose.position};
            if (confine(body, turned)) {
                pose = turned;
                return true;
            }
        }
    }
    return false;
}

Pose Separation::randomPose(int body, Random &random) const
{
    Pose pose = mLayout.poses[body];
    const int directions = mProblem.directions(body);
    if (directions == 0)
        pose.angle = mProblem.outlines[body].boxAngle + std::numbers::pi / 12 * random.below(24);
    else if (directions > 1)
        pose.angle = mProblem.angleOf(body, random.below(directions));
    const Vec2 size = mProblem.size();
    pose.position = mProblem.lower + Vec2(size.x() * random.uniform(), size.y() * random.uniform());
    return pose;
}

double Separation::descend(int body, Pose &pose, double cost, int steps, WorkMeter &work) const
{
    const double arm = std::max(0.6 * mLayout.scale * mProblem.outlines[body].radius, mProblem.gutter);
    Pose now = pose;
    for (int k = 0; k < steps && cost > 0; ++k) {
        const Evaluation e = evaluate(body, now, work);
        if (e.cost < cost) {
            cost = e.cost;
            pose = now;
        }
        const double turning = mProblem.turnsFreely(body) ? e.byAngle / arm : 0;
        const double slope = e.byPosition.squaredNorm() + turning * turning;
        if (!(slope > 0) || e.cost == 0)
            break;
        // Polyak's step length, with the known minimum of zero; 1.1 times it.
        const double step = 1.1 * e.cost / slope;
        now.position -= step * e.byPosition;
        now.angle -= std::clamp(step * turning / arm, -0.3, 0.3);
        if (!confineByTurning(body, now, 0.1))
            break;
    }
    return cost;
}

void Separation::moveBody(int body, Random &random, WorkMeter &work)
{
    Pose best = mLayout.poses[body];
    double least = cost(body, best, 1e300, work);
    const double before = least;
    least = descend(body, best, least, 8, work);
    std::array<std::pair<double, Pose>, 2> found{std::pair{least * 4 + 1e-9, best},
                                                 std::pair{least * 4 + 1e-9, best}};
    for (int k = 0; k < randomPoses && least > 0; ++k) {
        Pose pose = randomPose(body, random);
        if (k % 3 == 0)
            pose.position =
                mLayout.poses[body].position + Vec2(random.uniform(-1, 1), random.uniform(-1, 1)) *
                                                   mLayout.scale * mProblem.outlines[body].radius;
        if (!confine(body, pose))
            continue;
        const double value = cost(body, pose, found[1].first, work);
        if (value >= found[1].first)
            continue;
        found[1] = {value, pose};
        if (found[1].first < found[0].first)
            std::swap(found[0], found[1]);
    }
    for (auto &[value, pose] : found) {
        if (least == 0)
            break;
        const double refined = descend(body, pose, value, 6, work);
        if (refined < least) {
            least = refined;
            best = pose;
        }
    }
    if (least < before) {
        mLayout.poses[body] = best;
        mFrames[body] = frameOf(body, best);
        updateRow(body, work);
    }
}

void Separation::setPair(int i, int j, const Depth &depth)
{
    mOverlap[index(i, j)] = mOverlap[index(j, i)] = static_cast<float>(depth.sum);
    mDepth[index(i, j)] = mDepth[index(j, i)] = static_cast<float>(depth.deepest);
}

void Separation::updateRow(int body, WorkMeter &work)
{
    double operations = 0;
    for (int j = 0; j < mProblem.count(); ++j)
        setPair(body, j, {});
    visitNeighbours(body, mFrames[body], [&](int j) {
        if (!(mProblem.locked[body] && mProblem.locked[j]))
            setPair(body, j, pairDepth(body, mFrames[body], j, operations));
        return true;
    });
    work.add(4.9 * operations + 4.0 * mProblem.count());
}

void Separation::updateTotals()
{
    mTotal = mDeepest = 0;
    for (const float o : mOverlap)
        mTotal += 0.5 * o;
    for (const float d : mDepth)
        mDeepest = std::max(mDeepest, static_cast<double>(d));
}

bool Separation::start(const Layout &layout, WorkMeter &work)
{
    mLayout = layout;
    work.add(2000 + 500.0 * mProblem.count());
    for (int i = 0; i < mProblem.count(); ++i) {
        if (mProblem.movable(i) && !confineByTurning(i, mLayout.poses[i], std::numbers::pi))
            return false;
    }
    mFrames.clear();
    mRadius.clear();
    for (int i = 0; i < mProblem.count(); ++i) {
        mFrames.push_back(frameOf(i, mLayout.poses[i]));
        mRadius.push_back(mFrames[i].scale * mProblem.outlines[i].radius);
    }
    const std::size_t pairs = static_cast<std::size_t>(mProblem.count()) * mProblem.count();
    mWeights.assign(pairs, 1);
    mOverlap.assign(pairs, 0);
    mDepth.assign(pairs, 0);
    for (int i = 0; i < mProblem.count(); ++i)
        updateRow(i, work);
    updateTotals();
    return true;
}

void Separation::pass(Random &random, WorkMeter &work)
{
    const int n = mProblem.count();
    std::vector<int> order;
    for (int i = 0; i < n; ++i) {
        if (!mProblem.movable(i))
            continue;
        for (int j = 0; j < n; ++j) {
            if (mOverlap[index(i, j)] > 0) {
                order.push_back(i);
                break;
            }
        }
    }
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[random.below(static_cast<int>(k))]);
    for (const int i : order) {
        if (work.stop())
            break;
        moveBody(i, random, work);
    }
    updateTotals();
    // Weights of overlapping pairs grow by 1.2 to 2 times, all others fall back towards 1 by 5 % per pass.
    const float largest = *std::max_element(mOverlap.begin(), mOverlap.end());
    for (std::size_t k = 0; k < mWeights.size(); ++k) {
        const float o = mOverlap[k];
        mWeights[k] = o > 0 ? mWeights[k] * (1.2F + 0.8F * o / largest) : std::max(1.0F, 0.95F * mWeights[k]);
    }
    work.add(500 + 3.0 * n * n);
}

} // namespace autocuts::packing
