#include "solver/search/tutte.h"

#include "solver/base/cornerat.h"
#include "solver/linear/cholmodsolver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace autocuts::search {

namespace {

double sideLength(const Soup &soup, int side)
{
    const auto &s = soup.restShape[side / 3];
    const int a = side % 3, b = (side + 1) % 3;
    const Vec2 way = cornerAt(s, a) - cornerAt(s, b);
    return std::hypot(way.x(), way.y());
}

double loopLength(const Soup &soup, const std::vector<int> &loop)
{
    double sum = 0;
    for (const int side : loop)
        sum += sideLength(soup, side);
    return sum;
}

//! The linear system of an embedding. Its unknowns are the UV vertices off the outer loops, then one virtual
//! vertex per inner loop.
class Embedding
{
public:
    Embedding(const Soup &soup, const CutMesh &cut)
        : mSoup(soup), mCut(cut), mLoops(cut.boundaryLoops()), mOuter(cut.chartCount, -1),
          mPosition(cut.uvVertexCount, Vec2::Zero()), mUnknown(cut.uvVertexCount, 0)
    {}

    std::vector<double> run()
    {
        fixOuterLoops();
        for (int &unknown : mUnknown) {
            if (unknown == 0)
                unknown = mCount++;
        }
        mDiagonal.assign(mCount, 0.0);
        for (Eigen::VectorXd &right : mRight)
            right = Eigen::VectorXd::Zero(mCount + static_cast<int>(mLoops.size()));
        connectEdges();
        const int total = fillInnerLoops();
        for (int i = 0; i < mCount; ++i)
            mEntries.emplace_back(i, i, mDiagonal[i]);
        if (total > 0)
            solve(total);
        std::vector<double> x(mSoup.coordinateCount());
        for (int c = 0; c < mSoup.mesh->soupCornerCount(); ++c)
            cornerAt(x, c) = mPosition[mCut.uvVertex[c]];
        return x;
    }

private:
    static constexpr int fixed = -1;

    int chartOf(const std::vector<int> &loop) const { return mCut.chart[loop.front() / 3]; }
    double weightOf(int side) const
    {
        return 1 / std::max(sideLength(mSoup, side), 1e-3 * mSoup.meanEdgeLength);
    }

    //! Puts the longest loop of every chart on a circle.
    void fixOuterLoops()
    {
        std::vector<double> outerLength(mCut.chartCount, 0), chartArea(mCut.chartCount, 0);
        for (std::size_t i = 0; i < mLoops.size(); ++i) {
            const int chart = chartOf(mLoops[i]);
            const double length = loopLength(mSoup, mLoops[i]);
            if (mOuter[chart] < 0 || length > outerLength[chart]) {
                mOuter[chart] = static_cast<int>(i);
                outerLength[chart] = length;
            }
        }
        for (int t = 0; t < mSoup.triangleCount(); ++t)
            chartArea[mCut.chart[t]] += mSoup.targetWeight(t) * std::numbers::pi;
        for (int chart = 0; chart < mCut.chartCount; ++chart) {
            if (mOuter[chart] < 0)
                throw std::invalid_argument("a chart has no boundary");
            const double radius = std::sqrt(chartArea[chart] / std::numbers::pi);
            double walked = 0;
            for (const int side : mLoops[mOuter[chart]]) {
                const double angle = 2 * std::numbers::pi * walked / outerLength[chart];
                mPosition[mCut.uvVertex[side]] = radius * Vec2(std::cos(angle), std::sin(angle));
                mUnknown[mCut.uvVertex[side]] = fixed;
                walked += sideLength(mSoup, side);
            }
        }
    }

    //! Adds the spring from vertex a to vertex b to the equation of a.
    void pull(int a, int b, double w)
    {
        const int i = mUnknown[a];
        if (i == fixed)
            return;
        mDiagonal[i] += w;
        if (mUnknown[b] == fixed) {
            mRight[0][i] += w * mPosition[b].x();
            mRight[1][i] += w * mPosition[b].y();
        } else if (mUnknown[b] < i) {
            mEntries.emplace_back(i, mUnknown[b], -w);
        }
    }

    void connectEdges()
    {
        for (int side = 0; side < static_cast<int>(mCut.neighbour.size()); ++side) {
            if (mCut.neighbour[side] >= 0 && mCut.neighbour[side] < side)
                continue; // each edge once
            const int a = mCut.uvVertex[side];
            const int b = mCut.uvVertex[side / 3 * 3 + (side + 1) % 3];
            const double w = weightOf(side);
            pull(a, b, w);
            pull(b, a, w);
        }
    }

    //! Connects the virtual vertices. \returns the number of all unknowns
    int fillInnerLoops()
    {
        int total = mCount;
        for (std::size_t i = 0; i < mLoops.size(); ++i) {
            if (mOuter[chartOf(mLoops[i])] == static_cast<int>(i))
                continue;
            const int hub = total++;
            double sum = 0;
            for (const int side : mLoops[i]) {
                const double w = weightOf(side);
                const int v = mUnknown[mCut.uvVertex[side]];
                mDiagonal[v] += w;
                sum += w;
                mEntries.emplace_back(hub, v, -w);
            }
            mEntries.emplace_back(hub, hub, sum);
        }
        return total;
    }

    void solve(int total)
    {
        linear::LinearSolver::Matrix matrix(total, total);
        matrix.setFromTriplets(mEntries.begin(), mEntries.end());
        linear::CholmodSolver solver;
        solver.analyze(matrix, linear::LinearSolver::Order::FillReducing);
        if (!solver.factorize(matrix))
            throw std::runtime_error("a linear system could not be solved");
        Eigen::VectorXd solution[2];
        for (int axis = 0; axis < 2; ++axis) {
            mRight[axis].conservativeResize(total);
            solver.solve(mRight[axis], solution[axis]);
        }
        for (int v = 0; v < mCut.uvVertexCount; ++v) {
            if (mUnknown[v] != fixed)
                mPosition[v] = Vec2(solution[0][mUnknown[v]], solution[1][mUnknown[v]]);
        }
    }

    const Soup &mSoup;
    const CutMesh &mCut;
    std::vector<std::vector<int>> mLoops;
    std::vector<int> mOuter;     //!< per chart, its longest loop
    std::vector<Vec2> mPosition; //!< per UV vertex
    std::vector<int> mUnknown;   //!< per UV vertex, its unknown or `fixed`
    int mCount = 0;              //!< unknowns that are UV vertices
    std::vector<Eigen::Triplet<double>> mEntries;
    std::vector<double> mDiagonal;
    Eigen::VectorXd mRight[2];
};

} // namespace

std::vector<double> tutteEmbedding(const Soup &soup, const CutMesh &cut)
{
    return Embedding(soup, cut).run();
}

} // namespace autocuts::search
