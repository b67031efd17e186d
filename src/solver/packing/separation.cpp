#include "solver/packing/separation.h"

#include <algorithm>
#include <numbers>

namespace autocuts {

namespace {

//! Points of the outline's edges: corners far enough apart, and points along edges longer than the spacing.
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

//! Orders points so that neighbours in the list are neighbours in the plane.
void sortInPlane(Vec2 *begin, Vec2 *end, int leaf)
{
    if (end - begin <= leaf)
        return;
    Box2 box;
    for (const Vec2 *p = begin; p != end; ++p)
        box.add(*p);
    const Vec2 size = box.upper - box.lower;
    const int axis = size.x() >= size.y() ? 0 : 1;
    Vec2 *middle = begin + ((end - begin) / 2 + leaf - 1) / leaf * leaf;
    std::sort(begin, end, [axis](const Vec2 &p, const Vec2 &q) {
        return p[axis] < q[axis] || (p[axis] == q[axis] && p[1 - axis] < q[1 - axis]);
    });
    sortInPlane(begin, middle, leaf);
    sortInPlane(middle, end, leaf);
}

constexpr int clusterSize = 8;

} // namespace

Separation::Separation(const PackProblem &problem, double scale, WorkMeter &work) : mProblem(problem)
{
    const double side = std::sqrt(problem.size().x() * problem.size().y());
    mBodies.reserve(problem.count());
    for (int i = 0; i < problem.count(); ++i) {
        const Outline &outline = problem.outlines[i];
        const double own = problem.scaleOf(i, scale);
        const double cell = side / 400 / own;
        // Room for the gutter at scales down to half of this one.
        Body body{DistanceField(outline, cell, 1.5 * problem.gutter / own + 2 * cell, work), {}, {}};
        body.samples = samplePoints(outline, side / 100 / own);
        sortInPlane(body.samples.data(), body.samples.data() + body.samples.size(), clusterSize);
        const int count = static_cast<int>(body.samples.size());
        for (int begin = 0; begin < count; begin += clusterSize) {
            Cluster cluster{Vec2::Zero(), 0, begin, std::min(begin + clusterSize, count)};
            Box2 box;
            for (int k = cluster.begin; k < cluster.end; ++k)
                box.add(body.samples[k]);
            cluster.centre = 0.5 * (box.lower + box.upper);
            for (int k = cluster.begin; k < cluster.end; ++k)
                cluster.radius = std::max(cluster.radius, (body.samples[k] - cluster.centre).norm());
            body.clusters.push_back(cluster);
        }
        work.add(100.0 * count);
        mBodies.push_back(std::move(body));
    }
}

Separation::Depth Separation::oneWay(int points, const Pose &pointsPose, int field, const Pose &fieldPose,
                                     double *operations, Evaluation *evaluation, double weight,
                                     bool fieldMoves) const
{
    const double pointScale = mProblem.scaleOf(points, mLayout.scale);
    const double fieldScale = mProblem.scaleOf(field, mLayout.scale);
    const double ratio = pointScale / fieldScale;
    const Turn relative(pointsPose.angle - fieldPose.angle, ratio);
    const Turn back(fieldPose.angle, 1 / fieldScale);
    const Vec2 shift = back.transposed(pointsPose.position - fieldPose.position);
    const double gutter = mProblem.gutter / fieldScale;
    const Body &p = mBodies[points];
    const DistanceField &distance = mBodies[field].field;
    Depth depth;
    const double reach = ratio * mProblem.outlines[points].radius + gutter;
    if (distance.lowerBoundAt(shift) >= reach) {
        *operations += 1;
        return depth;
    }
    for (const Cluster &cluster : p.clusters) {
        const Vec2 centre = relative(cluster.centre) + shift;
        *operations += 1;
        if (distance.lowerBoundAt(centre) >= ratio * cluster.radius + gutter)
            continue;
        *operations += cluster.end - cluster.begin;
        for (int k = cluster.begin; k < cluster.end; ++k) {
            const Vec2 q = relative(p.samples[k]) + shift;
            const double pen = (gutter - distance.at(q)) * fieldScale;
            if (pen <= 0)
                continue;
            depth.sum += pen;
            depth.deepest = std::max(depth.deepest, pen);
            if (evaluation) {
                const Turn turn(fieldPose.angle, 1);
                const Vec2 n = turn(distance.gradientAt(q)) * (fieldMoves ? -weight : weight);
                // The point's place relative to the centre of the body that moves.
                const Vec2 arm = fieldMoves ? turn(q) * fieldScale
                                            : turn(q - shift) * fieldScale;
                evaluation->byPosition -= n;
                evaluation->byAngle -= arm.x() * n.y() - arm.y() * n.x();
            }
        }
    }
    return depth;
}

Separation::Depth Separation::pairDepth(int i, const Pose &pose, int j, double *operations) const
{
    const Depth a = oneWay(i, pose, j, mLayout.poses[j], operations, nullptr, 1, false);
    const Depth b = oneWay(j, mLayout.poses[j], i, pose, operations, nullptr, 1, true);
    return {a.sum + b.sum, std::max(a.deepest, b.deepest)};
}

double Separation::cost(int body, const Pose &pose, double limit, WorkMeter &work) const
{
    double operations = 0, sum = 0;
    const double own = mProblem.scaleOf(body, mLayout.scale) * mProblem.outlines[body].radius + mProblem.gutter;
    for (int j = 0; j < mProblem.count() && sum < limit; ++j) {
        const double reach = own + mProblem.scaleOf(j, mLayout.scale) * mProblem.outlines[j].radius;
        if (j == body || (mLayout.poses[j].position - pose.position).squaredNorm() >= reach * reach)
            continue;
        operations += 8;
        sum += mWeights[index(body, j)] * pairDepth(body, pose, j, &operations).sum;
    }
    work.add(3 * operations + 1.2 * mProblem.count());
    return sum;
}

Separation::Evaluation Separation::evaluate(int body, const Pose &pose, WorkMeter &work) const
{
    double operations = 0;
    Evaluation result;
    const double own = mProblem.scaleOf(body, mLayout.scale) * mProblem.outlines[body].radius + mProblem.gutter;
    for (int j = 0; j < mProblem.count(); ++j) {
        const double reach = own + mProblem.scaleOf(j, mLayout.scale) * mProblem.outlines[j].radius;
        if (j == body || (mLayout.poses[j].position - pose.position).squaredNorm() >= reach * reach)
            continue;
        operations += 8;
        const double weight = mWeights[index(body, j)];
        const Depth a = oneWay(body, pose, j, mLayout.poses[j], &operations, &result, weight, false);
        const Depth b = oneWay(j, mLayout.poses[j], body, pose, &operations, &result, weight, true);
        result.cost += weight * (a.sum + b.sum);
    }
    work.add(4 * operations + 1.2 * mProblem.count());
    return result;
}

bool Separation::confine(int body, Pose &pose) const
{
    const Turn turn(pose.angle, mLayout.scale);
    Box2 box;
    for (const Vec2 &p : mProblem.outlines[body].hull)
        box.add(turn(p));
    const Vec2 low = mProblem.lower - box.lower, high = mProblem.upper - box.upper;
    if (low.x() > high.x() || low.y() > high.y())
        return false;
    pose.position = pose.position.cwiseMax(low).cwiseMin(high);
    return true;
}

Pose Separation::randomPose(int body, SplitMix &random) const
{
    Pose pose = mLayout.poses[body];
    if (mProblem.rotation == PackRotation::Free)
        pose.angle = mProblem.outlines[body].boxAngle + std::numbers::pi / 12 * random.below(24);
    else if (mProblem.rotation == PackRotation::Quarter)
        pose.angle = 0.5 * std::numbers::pi * random.below(4);
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
        const double turning = mProblem.rotation == PackRotation::Free ? e.byAngle / arm : 0;
        const double slope = e.byPosition.squaredNorm() + turning * turning;
        if (!(slope > 0) || e.cost == 0)
            break;
        // Polyak's step: the least cost is known, it is zero.
        const double step = 1.1 * e.cost / slope;
        now.position -= step * e.byPosition;
        now.angle -= std::clamp(step * turning / arm, -0.3, 0.3);
        if (!confine(body, now))
            break;
    }
    return cost;
}

void Separation::moveBody(int body, SplitMix &random, WorkMeter &work)
{
    constexpr int samples = 24;
    Pose best = mLayout.poses[body];
    confine(body, best);
    double least = cost(body, best, 1e300, work);
    const double before = least;
    least = descend(body, best, least, 8, work);
    std::array<std::pair<double, Pose>, 2> found{std::pair{least * 4 + 1e-9, best}, std::pair{least * 4 + 1e-9, best}};
    for (int k = 0; k < samples && least > 0; ++k) {
        Pose pose = randomPose(body, random);
        if (k % 3 == 0)
            pose.position = mLayout.poses[body].position +
                            Vec2(random.symmetric(), random.symmetric()) * mLayout.scale *
                                mProblem.outlines[body].radius;
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
        updateRow(body, work);
    }
}

void Separation::updateRow(int body, WorkMeter &work)
{
    double operations = 0;
    for (int j = 0; j < mProblem.count(); ++j) {
        if (j == body)
            continue;
        Depth depth;
        const double reach = mProblem.gutter + mProblem.scaleOf(body, mLayout.scale) * mProblem.outlines[body].radius +
                             mProblem.scaleOf(j, mLayout.scale) * mProblem.outlines[j].radius;
        if ((mLayout.poses[j].position - mLayout.poses[body].position).squaredNorm() < reach * reach &&
            !(mProblem.locked[body] && mProblem.locked[j]))
            depth = pairDepth(body, mLayout.poses[body], j, &operations);
        mOverlap[index(body, j)] = mOverlap[index(j, body)] = static_cast<float>(depth.sum);
        mDepth[index(body, j)] = mDepth[index(j, body)] = static_cast<float>(depth.deepest);
    }
    work.add(3 * operations + 4.0 * mProblem.count());
}

void Separation::updateTotals()
{
    mTotal = mDeepest = 0;
    for (const float o : mOverlap)
        mTotal += 0.5 * o;
    for (const float d : mDepth)
        mDeepest = std::max(mDeepest, static_cast<double>(d));
}

void Separation::start(const Layout &layout)
{
    mLayout = layout;
    const std::size_t pairs = static_cast<std::size_t>(mProblem.count()) * mProblem.count();
    mWeights.assign(pairs, 1);
    mOverlap.assign(pairs, 0);
    mDepth.assign(pairs, 0);
    WorkMeter free(0, nullptr);
    for (int i = 0; i < mProblem.count(); ++i)
        updateRow(i, free);
    updateTotals();
}

void Separation::pass(SplitMix &random, WorkMeter &work)
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
    const float largest = *std::max_element(mOverlap.begin(), mOverlap.end());
    for (std::size_t k = 0; k < mWeights.size(); ++k) {
        const float o = mOverlap[k];
        mWeights[k] = o > 0 ? mWeights[k] * (1.2F + 0.8F * o / largest) : std::max(1.0F, 0.95F * mWeights[k]);
    }
    work.add(3.0 * n * n);
}

} // namespace autocuts
