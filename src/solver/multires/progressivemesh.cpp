#include "solver/multires/progressivemesh.h"

#include "model/unionfind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace autocuts {

namespace {

//! A collapse may not turn a triangle by more than this (cosine).
constexpr double smallestTurn = 0.3;
//! Nor make one thinner than this (area over longest edge squared; a regular one has 0.43).
constexpr double thinnest = 0.02;
//! Most triangles around a point.
constexpr int largestFan = 14;
//! Weight of squared edge lengths beside the distances to planes: keeps triangles even on flat ground.
constexpr double evenness = 2e-3;
//! Weight of the planes that hold borders in place.
constexpr double borderWeight = 3;

} // namespace

bool ProgressiveMesh::Candidate::operator<(const Candidate &o) const
{
    return std::tie(cost, removed, kept) > std::tie(o.cost, o.removed, o.kept);
}

ProgressiveMesh::ProgressiveMesh(const MeshData &mesh, const std::vector<bool> &locked)
    : mAlive(mesh.triangleCount(), true), mCount(mesh.triangleCount())
{
    findPoints(mesh);
    for (std::size_t e = 0; e < locked.size(); ++e) {
        if (!locked[e])
            continue;
        for (int end = 0; end < 2; ++end)
            mLocked[mPoint[mesh.edgePairs[e].corner[end][0]]] = true;
    }
    for (int t = 0; t < mCount; ++t)
        mObject.push_back(mesh.faceObject[mesh.triangleFace[t]]);
    mMeanArea = mesh.area / std::max(1, mCount);
}

void ProgressiveMesh::findPoints(const MeshData &mesh)
{
    UnionFind corners(mesh.soupCornerCount());
    mAcross.assign(mesh.soupCornerCount(), -1);
    for (const EdgePair &pair : mesh.edgePairs) {
        corners.unite(pair.corner[0][0], pair.corner[0][1]);
        corners.unite(pair.corner[1][0], pair.corner[1][1]);
        const int a = 3 * pair.triangle[0] + pair.side(0), b = 3 * pair.triangle[1] + pair.side(1);
        mAcross[a] = b;
        mAcross[b] = a;
    }
    int points = 0;
    std::tie(mPoint, points) = corners.labels();
    mCornerOf.assign(points, -1);
    mPosition.resize(points);
    mLocked.assign(points, false);
    mGone.assign(points, false);
    mStamp.assign(points, 0);
    mMark.assign(points, 0);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        mCornerOf[mPoint[c]] = c;
        mPosition[mPoint[c]] = mesh.cornerPosition(mesh.cornerOfSoup(c));
    }
}

//! Corners of one point counter-clockwise; from the border's side on when there is a border. False when they
//! do not make a plain fan.
bool ProgressiveMesh::fanOf(int corner, std::vector<int> &corners) const
{
    corners.clear();
    int start = corner;
    for (int steps = 0;; ++steps) {
        const int back = mAcross[start]; // the side that starts here; its other half ends at this point
        if (back < 0)
            break;
        start = next(back);
        if (start == corner)
            break;
        if (steps > 1000)
            return false;
    }
    for (int c = start;;) {
        corners.push_back(c);
        c = mAcross[previous(c)];
        if (c < 0 || c == start)
            return true;
        if (corners.size() > 1000)
            return false;
    }
}

bool ProgressiveMesh::ringOf(int point, std::vector<int> &corners) const
{
    return fanOf(mCornerOf[point], corners);
}

double ProgressiveMesh::errorOf(const Quadric &q, const Vec3 &p) const
{
    return q[0] * p.x() * p.x() + 2 * q[1] * p.x() * p.y() + 2 * q[2] * p.x() * p.z() + 2 * q[3] * p.x() +
           q[4] * p.y() * p.y() + 2 * q[5] * p.y() * p.z() + 2 * q[6] * p.y() + q[7] * p.z() * p.z() +
           2 * q[8] * p.z() + q[9];
}

void ProgressiveMesh::addQuadrics()
{
    mQuadric.assign(mPosition.size(), {});
    // Around the middle of the mesh, so that a mesh far away keeps its digits.
    Vec3 middle = Vec3::Zero();
    for (const Vec3 &p : mPosition)
        middle += p / double(mPosition.size());
    for (Vec3 &p : mPosition)
        p -= middle;
    const auto add = [&](int point, const Vec3 &n, double d, double weight) {
        Quadric &q = mQuadric[point];
        const double v[4] = {n.x(), n.y(), n.z(), d};
        for (int i = 0, at = 0; i < 4; ++i) {
            for (int j = i; j < 4; ++j)
                q[at++] += weight * v[i] * v[j];
        }
    };
    for (int t = 0; t < static_cast<int>(mAlive.size()); ++t) {
        const Vec3 &a = position(3 * t), &b = position(3 * t + 1), &c = position(3 * t + 2);
        const Vec3 cross = (b - a).cross(c - a);
        const double area = cross.norm();
        if (area <= 0)
            continue;
        const Vec3 n = cross / area;
        for (int k = 0; k < 3; ++k) {
            add(mPoint[3 * t + k], n, -n.dot(a), area);
            if (mAcross[3 * t + k] >= 0)
                continue;
            const Vec3 &from = position(3 * t + k), &to = position(next(3 * t + k));
            const Vec3 side = (to - from).cross(n);
            const double length = side.norm();
            if (length <= 0)
                continue;
            for (const int corner : {3 * t + k, next(3 * t + k)})
                add(mPoint[corner], side / length, -side.dot(from) / length, borderWeight * length * length);
        }
    }
}

//! Whether a point may move onto a neighbour, and what that costs.
bool ProgressiveMesh::allowed(int removed, int kept, double &cost)
{
    // mRing holds the corners around `removed`.
    const bool border = mAcross[mRing.front()] < 0;
    const int round = ++mMarkRound;
    const Vec3 &to = mPosition[kept];
    int shared = 0;
    bool alongBorder = false;
    for (const int c : mRing) {
        const int a = mPoint[next(c)], b = mPoint[previous(c)];
        if (a == kept || b == kept) {
            ++shared;
            alongBorder |= (a == kept && mAcross[c] < 0) || (b == kept && mAcross[previous(c)] < 0);
            const int apex = a == kept ? b : a;
            if (mMark[apex] == -round)
                return false;
            mMark[apex] = -round; // a common neighbour that is all right
            continue;
        }
        const Vec3 &p = mPosition[a], &q = mPosition[b];
        const Vec3 before = (p - mPosition[removed]).cross(q - mPosition[removed]);
        const Vec3 after = (p - to).cross(q - to);
        const double longest =
            std::max({(p - to).squaredNorm(), (q - to).squaredNorm(), (p - q).squaredNorm()});
        const double size = before.norm() * after.norm();
        if (!(after.norm() > 2 * thinnest * longest) || before.dot(after) < smallestTurn * size)
            return false;
    }
    if (shared != (alongBorder ? 1 : 2) || (border && !alongBorder) ||
        static_cast<int>(mRing.size()) - shared < 1)
        return false;
    // No other common neighbours, or the surface would be pinched.
    for (const int c : mRing) {
        for (const int p : {mPoint[next(c)], mPoint[previous(c)]}) {
            if (p != kept && mMark[p] != -round)
                mMark[p] = round;
        }
    }
    if (!ringOf(kept, mOtherRing) ||
        static_cast<int>(mOtherRing.size() + mRing.size()) - 2 * shared > largestFan)
        return false;
    for (const int c : mOtherRing) {
        for (const int p : {mPoint[next(c)], mPoint[previous(c)]}) {
            if (mMark[p] == round)
                return false;
        }
    }
    Quadric sum = mQuadric[removed];
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += mQuadric[kept][i];
    cost = std::max(0.0, errorOf(sum, to)) +
           evenness * mMeanArea * double(mRing.size()) * (to - mPosition[removed]).squaredNorm();
    return true;
}

void ProgressiveMesh::propose(int point)
{
    ++mStamp[point];
    if (mLocked[point] || mGone[point] || !ringOf(point, mRing) ||
        static_cast<int>(mRing.size()) > largestFan)
        return;
    const std::vector<int> ring = mRing;
    Candidate best{0, point, -1, mStamp[point]};
    const auto consider = [&](int kept) {
        double cost = 0;
        if (allowed(point, kept, cost) && (best.kept < 0 || cost < best.cost)) {
            best.cost = cost;
            best.kept = kept;
        }
    };
    for (const int c : ring)
        consider(mPoint[next(c)]);
    if (mAcross[previous(ring.back())] < 0)
        consider(mPoint[previous(ring.back())]);
    if (best.kept >= 0) {
        mQueue.push_back(best);
        std::push_heap(mQueue.begin(), mQueue.end());
    }
}

bool ProgressiveMesh::collapse(int removed, int kept)
{
    double cost = 0;
    if (!ringOf(removed, mRing) || !allowed(removed, kept, cost))
        return false;
    // The points around the ends of the removed triangles must keep three triangles, borders one.
    Collapse record{removed, kept, static_cast<int>(mFan.size()), 0, {-1, -1}};
    std::size_t first = 0;
    for (std::size_t i = 0; i < mRing.size(); ++i) {
        if (mPoint[next(mRing[i])] == kept)
            record.triangle[0] = mRing[i] / 3, first = i + 1;
        if (mPoint[previous(mRing[i])] == kept)
            record.triangle[1] = mRing[i] / 3;
    }
    for (const int c : mRing) {
        const int apex = mPoint[next(c)] == kept       ? mPoint[previous(c)]
                         : mPoint[previous(c)] == kept ? mPoint[next(c)]
                                                       : -1;
        if (apex < 0)
            continue;
        if (!ringOf(apex, mOtherRing) || mOtherRing.size() < (mAcross[mOtherRing.front()] < 0 ? 2u : 4u))
            return false;
    }
    for (std::size_t i = 0; i < mRing.size(); ++i) {
        const int c = mRing[(first + i) % mRing.size()];
        if (c / 3 != record.triangle[0] && c / 3 != record.triangle[1])
            mFan.push_back(c);
    }
    record.fanEnd = static_cast<int>(mFan.size());

    const auto glue = [&](int side, int other) {
        mAcross[side] = other;
        if (other >= 0)
            mAcross[other] = side;
    };
    const int firstCorner = mFan[record.fanBegin], lastCorner = mFan.back();
    for (int i = record.fanBegin; i < record.fanEnd; ++i)
        mPoint[mFan[i]] = kept;
    for (const int c : mRing) {
        if (c / 3 == record.triangle[0])
            glue(firstCorner, mAcross[next(c)]); // removed, kept, r: the side kept to r goes on outside
        else if (c / 3 == record.triangle[1])
            glue(previous(lastCorner), mAcross[next(c)]); // removed, r, kept
        else
            continue;
        mAlive[c / 3] = false;
        --mCount;
        // Corners that stood for their points.
        for (int k = 0; k < 3; ++k) {
            const int p = mPoint[c / 3 * 3 + k];
            if (mCornerOf[p] / 3 == c / 3)
                mCornerOf[p] = -1;
        }
    }
    for (int i = record.fanBegin; i < record.fanEnd; ++i) {
        for (const int c : {mFan[i], next(mFan[i]), previous(mFan[i])})
            mCornerOf[mPoint[c]] = c;
    }
    mGone[removed] = true;
    for (std::size_t i = 0; i < mQuadric[kept].size(); ++i)
        mQuadric[kept][i] += mQuadric[removed][i];
    mCollapses.push_back(record);
    return true;
}

void ProgressiveMesh::coarsen(int triangles)
{
    addQuadrics();
    for (int p = 0; p < static_cast<int>(mPosition.size()); ++p)
        propose(p);
    std::vector<int> around;
    while (mCount > triangles && !mQueue.empty()) {
        std::pop_heap(mQueue.begin(), mQueue.end());
        const Candidate best = mQueue.back();
        mQueue.pop_back();
        if (best.stamp != mStamp[best.removed] || mGone[best.removed] || !collapse(best.removed, best.kept))
            continue;
        if (!ringOf(best.kept, mRing))
            continue;
        around.assign(1, best.kept);
        for (const int c : mRing)
            around.insert(around.end(), {mPoint[next(c)], mPoint[previous(c)]});
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        for (const int p : around)
            propose(p);
    }
    mQueue.clear();
}

void ProgressiveMesh::refine()
{
    const Collapse record = mCollapses.back();
    mCollapses.pop_back();
    for (int i = record.fanBegin; i < record.fanEnd; ++i)
        mPoint[mFan[i]] = record.removed;
    for (const int t : record.triangle) {
        if (t < 0)
            continue;
        mAlive[t] = true;
        ++mCount;
        // A triangle that went kept its own neighbours in mind; these get it back.
        for (int side = 3 * t; side < 3 * t + 3; ++side) {
            if (mAcross[side] >= 0)
                mAcross[mAcross[side]] = side;
        }
    }
    mGone[record.removed] = false;
    mFan.resize(record.fanBegin);
}

std::shared_ptr<const MeshData> ProgressiveMesh::extract(std::vector<int> &triangles) const
{
    triangles.clear();
    std::vector<int> number(mPosition.size(), -1), start{0}, corners, object;
    std::vector<Vec3> points;
    for (int t = 0; t < static_cast<int>(mAlive.size()); ++t) {
        if (!mAlive[t])
            continue;
        triangles.push_back(t);
        for (int k = 0; k < 3; ++k) {
            int &n = number[mPoint[3 * t + k]];
            if (n < 0) {
                n = static_cast<int>(points.size());
                points.push_back(position(3 * t + k));
            }
            corners.push_back(n);
        }
        start.push_back(start.back() + 3);
        object.push_back(mObject[t]);
    }
    PositionMatrix positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        positions.row(static_cast<Eigen::Index>(i)) = points[i];
    return MeshData::build(std::move(positions), std::move(start), std::move(corners), std::move(object));
}

} // namespace autocuts
