#include "solver/search/patch.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

//! Share of the way from a point to the mean centroid of its triangles. Chosen by hand.
constexpr double partingShare = 0.01;

} // namespace

Patch::Patch(std::shared_ptr<const SeamGraph> graph)
    : mGraph(std::move(graph)), mLocal(mGraph->triangleCount(), -1)
{}

void Patch::select(const CutState &state, std::span<const int> seeds, int size)
{
    for (const int t : mTriangles)
        mLocal[t] = -1;
    mTriangles.clear();
    for (const int t : seeds) {
        if (mLocal[t] < 0) {
            mLocal[t] = static_cast<int>(mTriangles.size());
            mTriangles.push_back(t);
        }
    }
    mCoversCharts = size == 0;
    for (std::size_t i = 0; i < mTriangles.size() && static_cast<int>(mTriangles.size()) < size; ++i) {
        for (int k = 0; k < 3; ++k) {
            const int side = 3 * mTriangles[i] + k;
            if (state.isCutSide(side))
                continue;
            const int t = mGraph->across[side] / 3;
            if (mLocal[t] < 0) {
                mLocal[t] = static_cast<int>(mTriangles.size());
                mTriangles.push_back(t);
            }
        }
    }
    loadBlocks();
}

void Patch::loadBlocks()
{
    const Soup &soup = *mGraph->soup;
    const std::size_t count = mTriangles.size();
    mBlocks.resize((count + triangleLanes - 1) / triangleLanes);
    for (std::size_t i = 0; i < triangleLanes * mBlocks.size(); ++i) {
        TriangleBlock &block = mBlocks[i / triangleLanes];
        const std::size_t lane = i % triangleLanes;
        const int t = mTriangles[std::min(i, count - 1)];
        for (int k = 0; k < 6; ++k)
            block.basis[k][lane] = soup.basis[t][k];
        block.weight[lane] = soup.weight[t];
        block.stiffness[lane] = mGraph->stiffness(t);
    }
}

void Patch::findAcross(const CutState &state)
{
    const int corners = 3 * static_cast<int>(mTriangles.size());
    mAcross.resize(corners);
    for (int c = 0; c < corners; ++c) {
        const int side = 3 * mTriangles[c / 3] + c % 3;
        mAcross[c] = apart;
        if (state.isCutSide(side))
            continue;
        const int other = mGraph->across[side];
        const int there = mLocal[other / 3];
        if (there < 0)
            mAcross[c] = outside;
        else if (there != c / 3)
            mAcross[c] = 3 * there + other % 3;
    }
}

//! Numbers the points: corners that are connected over uncut edges form one point. They lie around it in a
//! fan, which is walked from one of them to both ends.
void Patch::mergeCorners()
{
    const int corners = static_cast<int>(mAcross.size());
    mPoint.assign(corners, -1);
    mPointVertex.clear();
    for (int first = 0; first < corners; ++first) {
        if (mPoint[first] >= 0)
            continue;
        const int point = static_cast<int>(mPointVertex.size());
        mPointVertex.push_back(mGraph->vertex[3 * mTriangles[first / 3] + first % 3]);
        mPoint[first] = point;
        for (int side = first; mAcross[side] >= 0;) {
            side = nextSide(mAcross[side]);
            if (mPoint[side] >= 0)
                break; // around it
            mPoint[side] = point;
        }
        for (int side = sideBefore(first); mAcross[side] >= 0;) {
            const int c = mAcross[side];
            if (mPoint[c] >= 0)
                break;
            mPoint[c] = point;
            side = sideBefore(c);
        }
    }
}

bool Patch::join(const CutState &state, const std::vector<double> &x)
{
    mState = &state;
    mSegmentsKnown = false;
    mSprings.clear();
    mStiffness = 0;
    const int corners = 3 * static_cast<int>(mTriangles.size());
    findAcross(state);
    mergeCorners();
    const int points = static_cast<int>(mPointVertex.size());
    mPosition.assign(2 * points, 0.0);
    // Until numberUnknowns(), mUnknown is -1 for held points and counts the corners seen so far for others.
    mNumbered = false;
    mUnknown.assign(points, 0);
    const auto hold = [&](int c) {
        const int p = mPoint[c];
        const double *at = &x[6 * static_cast<std::size_t>(mTriangles[c / 3]) + 2 * (c % 3)];
        if (mUnknown[p] < 0)
            return mPosition[2 * p] == at[0] && mPosition[2 * p + 1] == at[1];
        mUnknown[p] = -1;
        mPosition[2 * p] = at[0];
        mPosition[2 * p + 1] = at[1];
        return true;
    };
    for (int c = 0; c < corners; ++c) {
        if (mAcross[c] == outside && (!hold(c) || !hold(nextSide(c))))
            return false;
    }
    for (int c = 0; c < corners && state.anchored; ++c) {
        for (const int i : mGraph->anchors.at(3 * mTriangles[c / 3] + c % 3)) {
            if (state.pinReached[i] && !hold(c))
                return false;
        }
    }
    for (int c = 0; c < corners; ++c) {
        const int p = mPoint[c];
        if (mUnknown[p] < 0)
            continue;
        const double *at = &x[6 * static_cast<std::size_t>(mTriangles[c / 3]) + 2 * (c % 3)];
        // A running mean keeps equal coordinates bitwise equal.
        const double share = 1.0 / ++mUnknown[p];
        mPosition[2 * p] += share * (at[0] - mPosition[2 * p]);
        mPosition[2 * p + 1] += share * (at[1] - mPosition[2 * p + 1]);
    }
    return true;
}

void Patch::partSides(const std::vector<int> &edges)
{
    const MeshData &mesh = *mGraph->soup->mesh;
    std::vector<int> points;
    for (const int e : edges) {
        const EdgePair &pair = mesh.edgePairs[e];
        for (int which = 0; which < 2; ++which) {
            for (int end = 0; end < 2; ++end) {
                const int p = mPoint[3 * mLocal[pair.triangle[which]] + pair.corner[end][which] % 3];
                if (mUnknown[p] >= 0 && std::find(points.begin(), points.end(), p) == points.end())
                    points.push_back(p);
            }
        }
    }
    std::vector<Vec2> sum(points.size(), Vec2::Zero());
    std::vector<int> count(points.size(), 0);
    for (std::size_t c = 0; c < mPoint.size(); ++c) {
        const auto found = std::find(points.begin(), points.end(), mPoint[c]);
        if (found == points.end())
            continue;
        for (int k = 0; k < 3; ++k) {
            const int q = mPoint[c / 3 * 3 + k];
            sum[found - points.begin()] += Vec2(mPosition[2 * q], mPosition[2 * q + 1]) / 3;
        }
        ++count[found - points.begin()];
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int axis = 0; axis < 2; ++axis) {
            double &at = mPosition[2 * points[i] + axis];
            at += partingShare * (sum[i][axis] / count[i] - at);
        }
    }
}

void Patch::addSprings(const std::vector<int> &edges)
{
    mSprings.clear();
    const MeshData &mesh = *mGraph->soup->mesh;
    for (const int e : edges) {
        const EdgePair &pair = mesh.edgePairs[e];
        for (int end = 0; end < 2; ++end) {
            const int a = mPoint[3 * mLocal[pair.triangle[0]] + pair.corner[end][0] % 3];
            const int b = mPoint[3 * mLocal[pair.triangle[1]] + pair.corner[end][1] % 3];
            if (a != b && (mUnknown[a] >= 0 || mUnknown[b] >= 0))
                mSprings.push_back({a, b, -1, mGraph->length[e]});
        }
    }
    mNumbered = false;
}

//! Many trials end before anything is minimised, so this is done when it is needed.
void Patch::numberUnknowns()
{
    if (mNumbered)
        return;
    mNumbered = true;
    // The points are eliminated in the order that SeamGraph::rank gives for the whole mesh.
    std::vector<std::pair<int, int>> &order = mLower;
    order.clear();
    for (int p = 0; p < static_cast<int>(mUnknown.size()); ++p) {
        if (mUnknown[p] >= 0)
            order.emplace_back(mGraph->rank[mPointVertex[p]], p);
    }
    std::sort(order.begin(), order.end());
    const int count = static_cast<int>(order.size());
    for (int i = 0; i < count; ++i)
        mUnknown[order[i].second] = i;
    mLower.clear();
    const auto link = [&](int p, int q) {
        const int a = mUnknown[p], b = mUnknown[q];
        if (a >= 0 && b >= 0 && a != b)
            mLower.emplace_back(std::max(a, b), std::min(a, b));
    };
    // Both sides of an uncut edge have the same points.
    const int corners = static_cast<int>(mPoint.size());
    const auto isSecondSide = [this](int c) { return mAcross[c] >= 0 && mAcross[c] < c; };
    for (int c = 0; c < corners; ++c) {
        if (!isSecondSide(c))
            link(mPoint[c], mPoint[nextSide(c)]);
    }
    for (const Spring &s : mSprings)
        link(s.a, s.b);
    mSystem.analyze(count, mLower);
    const auto place = [&](int p, int q) {
        const int a = mUnknown[p], b = mUnknown[q];
        return a >= 0 && b >= 0 && a != b ? mSystem.place(std::max(a, b), std::min(a, b)) : -1;
    };
    mPlace.resize(corners);
    for (int c = 0; c < corners; ++c)
        mPlace[c] = isSecondSide(c) ? mPlace[mAcross[c]] : place(mPoint[c], mPoint[nextSide(c)]);
    for (Spring &s : mSprings)
        s.place = place(s.a, s.b);
    mFrozen.assign(count, 0);
}

bool Patch::crossesItself()
{
    if (!mSegmentsKnown) {
        mSegmentsKnown = true;
        mSegments.clear();
        for (int c = 0; c < 3 * static_cast<int>(mTriangles.size()); ++c) {
            const int from = mPoint[c], to = mPoint[nextSide(c)];
            if (!mState->isCutSide(3 * mTriangles[c / 3] + c % 3))
                continue;
            if (mUnknown[from] >= 0 || mUnknown[to] >= 0)
                mSegments.addMoving(from, to);
            else
                mSegments.addFixed(mPosition[2 * from], mPosition[2 * from + 1], mPosition[2 * to],
                                   mPosition[2 * to + 1]);
        }
        addSidesAround();
        addObstacles();
    }
    return !mSegments.empty() && mSegments.cross(mPosition);
}

//! Adds the boundary sides outside of the patch. Those of other charts count only where these are not kept
//! apart.
void Patch::addSidesAround()
{
    const bool ownOnly = mState->chartsMayMeet || mState->chartsAreAlone();
    if (ownOnly && mCoversCharts)
        return;
    std::vector<char> counts(mState->chartCount(), !ownOnly);
    for (const int t : mTriangles)
        counts[mState->chart[t]] = 1;
    for (const int side : mState->boundary) {
        if (!counts[mState->chart[side / 3]] || mLocal[side / 3] >= 0)
            continue;
        const Vec2 a = mState->at(side), b = mState->at(side / 3 * 3 + (side + 1) % 3);
        mSegments.addFixed(a.x(), a.y(), b.x(), b.y());
    }
}

//! Adds the open sides of obstacles around the patch. Those further away are left to the final test.
void Patch::addObstacles()
{
    if (mState->chartsMayMeet || !mGraph->obstacles)
        return;
    Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
    for (std::size_t p = 0; p < mPosition.size(); p += 2) {
        low = low.cwiseMin(Vec2(mPosition[p], mPosition[p + 1]));
        high = high.cwiseMax(Vec2(mPosition[p], mPosition[p + 1]));
    }
    const Vec2 reach = high - low;
    for (const Obstacle *obstacle : mState->obstaclesAt(low - reach, high + reach)) {
        for (int k = 0; k < 3; ++k) {
            const Vec2 &a = obstacle->corner[k], &b = obstacle->corner[(k + 1) % 3];
            if (obstacle->isOpen[k])
                mSegments.addFixed(a.x(), a.y(), b.x(), b.y());
        }
    }
}

void Patch::store(std::vector<double> &x) const
{
    for (std::size_t c = 0; c < mPoint.size(); ++c) {
        double *to = &x[6 * static_cast<std::size_t>(mTriangles[c / 3]) + 2 * (c % 3)];
        to[0] = mPosition[2 * mPoint[c]];
        to[1] = mPosition[2 * mPoint[c] + 1];
    }
}

void Patch::commit(CutState &state) const
{
    const double before = distortionOf(state);
    store(state.x);
    for (const int t : mTriangles) {
        const double value = state.energyOf(t, &state.x[6 * static_cast<std::size_t>(t)]);
        state.energy += value - state.triangleEnergy[t];
        state.triangleEnergy[t] = value;
    }
    state.distortion =
        mGraph->hasPlainEnergy() ? state.energy : state.distortion + distortionOf(state) - before;
}

double Patch::distortionOf(const CutState &state) const
{
    double sum = 0;
    for (const int t : mTriangles)
        sum +=
            mGraph->hasPlainEnergy() ? 0 : state.distortionOf(t, &state.x[6 * static_cast<std::size_t>(t)]);
    return sum;
}

} // namespace autocuts::search
