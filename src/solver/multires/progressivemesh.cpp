#include "solver/multires/progressivemesh.h"

#include "model/plain/texelweights.h"
#include "model/plain/unionfind.h"
#include "solver/multires/edgecollapses.h"

#include <tuple>

namespace autocuts::multires {

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
    for (int t = 0; t < mCount && !mesh.texelWeight.empty(); ++t)
        mTexelWeight.push_back(mesh.texelWeightOf(t));
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
    mPosition.resize(points);
    mLocked.assign(points, false);
    for (int c = 0; c < mesh.soupCornerCount(); ++c)
        mPosition[mPoint[c]] = mesh.cornerPosition(mesh.cornerOfSoup(c));
}

//! Writes the corners of a point to mRing, counter-clockwise, starting at a border if there is one.
void ProgressiveMesh::ringOf(int point)
{
    mRing.clear();
    const int corner = mCornerOf[point];
    int start = corner;
    while (mAcross[start] >= 0) { // the side that starts here; its other half ends at this point
        start = next(mAcross[start]);
        if (start == corner)
            break;
    }
    for (int c = start;;) {
        mRing.push_back(c);
        c = mAcross[previous(c)];
        if (c < 0 || c == start)
            return;
    }
}

void ProgressiveMesh::collapse(int removed, int kept)
{
    ringOf(removed);
    Collapse record{removed, kept, static_cast<int>(mFan.size()), 0, {-1, -1}};
    std::size_t first = 0;
    for (std::size_t i = 0; i < mRing.size(); ++i) {
        if (mPoint[next(mRing[i])] == kept)
            record.triangle[0] = mRing[i] / 3, first = i + 1;
        if (mPoint[previous(mRing[i])] == kept)
            record.triangle[1] = mRing[i] / 3;
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
            glue(firstCorner, mAcross[next(c)]); // triangle (removed, kept, r): the side from kept to r stays
        else if (c / 3 == record.triangle[1])
            glue(previous(lastCorner), mAcross[next(c)]); // triangle (removed, r, kept)
        else
            continue;
        mAlive[c / 3] = false;
        --mCount;
    }
    // The fan contains every remaining point of the removed triangles.
    for (int i = record.fanBegin; i < record.fanEnd; ++i) {
        for (const int c : {mFan[i], next(mFan[i]), previous(mFan[i])})
            mCornerOf[mPoint[c]] = c;
    }
    mCollapses.push_back(record);
}

void ProgressiveMesh::coarsen(int triangles, const JobContext &job)
{
    mCornerOf.assign(mPosition.size(), -1);
    for (int c = 0; c < static_cast<int>(mPoint.size()); ++c) {
        if (mAlive[c / 3])
            mCornerOf[mPoint[c]] = c;
    }
    for (const auto &[removed, kept] :
         edgeCollapses({mPosition, mPoint, mAcross, mAlive, mLocked}, triangles, job))
        collapse(removed, kept);
    mCornerOf.clear();
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
        // A removed triangle still knows its neighbours; they are linked to it again.
        for (int side = 3 * t; side < 3 * t + 3; ++side) {
            if (mAcross[side] >= 0)
                mAcross[mAcross[side]] = side;
        }
    }
    mFan.resize(record.fanBegin);
}

std::shared_ptr<const MeshData> ProgressiveMesh::extract(std::vector<int> &triangles) const
{
    std::vector<int> number(mPosition.size(), -1), alive, start{0}, corners, object;
    std::vector<double> weights;
    std::vector<Vec3> points;
    for (int t = 0; t < static_cast<int>(mAlive.size()); ++t) {
        if (!mAlive[t])
            continue;
        alive.push_back(t);
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
        weights.push_back(texelWeight(t));
    }
    PositionMatrix positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        positions.row(static_cast<Eigen::Index>(i)) = points[i];
    auto mesh =
        MeshData::build(std::move(positions), std::move(start), std::move(corners), std::move(object));
    triangles.clear();
    for (const int face : mesh->triangleFace)
        triangles.push_back(alive[face]);
    return withTexelWeights(mesh, storedTexelWeights(std::move(weights)));
}

} // namespace autocuts::multires
