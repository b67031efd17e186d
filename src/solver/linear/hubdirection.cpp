// Truncated Newton directions: conjugate gradients with the hub preconditioner.
//
// Near a solution most corners of one mesh vertex sit (almost) on one point, tied by a ring of stiff springs.
// The preconditioner ties each such group to one auxiliary point, its hub, by a spring k_c per corner:
//
//     M = [ S  -D ]    S = per triangle, 6 x 6: distortion + diag(k + ground),   D = diag(k)
//         [ -D  B ]    B = diagonal of the hubs (sum of k) + springs between hubs
//
// Eliminating the corners leaves the hub matrix A = B - sum over triangles of D S^-1 D with two unknowns per
// hub, six times fewer than the soup has. z = M^-1 r is: y = S^-1 r; A u = sum of k y; z = y + S^-1 D u.
// S is refreshed at every call. A and the grouping are kept until the iterations get slow: any symmetric
// positive definite A gives a valid preconditioner.
#include "model/unionfind.h"
#include "solver/linear/cholmodsolver.h"
#include "solver/linear/lanes.h"
#include "solver/linear/newtondirection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace autocuts {

namespace {

constexpr double residualTolerance = 0.3;
constexpr int maxIterations = 60;
//! Refactor the hub matrix after this many iterations more than a fresh one would have needed.
constexpr int excessBeforeRefresh = 18;
constexpr int excessBeforeRefreshLarge = 12;
constexpr int largeTriangleCount = 40000;

//! Place of each welded mesh vertex in an order that keeps the fill of the hub matrix low.
std::vector<int> vertexRanks(const MeshData &mesh)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * static_cast<std::size_t>(mesh.triangleCount()) + mesh.vertexCount());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.vertexOfSoup(3 * t + k);
            const int b = mesh.vertexOfSoup(3 * t + (k + 1) % 3);
            entries.emplace_back(std::max(a, b), std::min(a, b), 1.0);
        }
    }
    for (int v = 0; v < mesh.vertexCount(); ++v)
        entries.emplace_back(v, v, 1.0);
    LinearSolver::Matrix graph(mesh.vertexCount(), mesh.vertexCount());
    graph.setFromTriplets(entries.begin(), entries.end());
    return eliminationRanks(graph);
}

constexpr std::array<int, 6> diagonalEntry{0, 2, 5, 9, 14, 20};

class HubDirection final : public NewtonDirection
{
public:
    HubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held)
        : mSoup(std::move(soup)), mHeld(std::move(held)), mRank(vertexRanks(*mSoup->mesh)),
          mCorners(mSoup->mesh->soupCornerCount())
    {
        mExcessLimit =
            mSoup->triangleCount() > largeTriangleCount ? excessBeforeRefreshLarge : excessBeforeRefresh;
        mBlocks = (static_cast<std::size_t>(mSoup->triangleCount()) + laneCount - 1) / laneCount;
        mSlot.resize(mCorners);
        for (int c = 0; c < mCorners; ++c) {
            const int t = c / 3;
            mSlot[c] = (t / laneCount * 6 + 2 * (c % 3)) * laneCount + t % laneCount;
        }
        mHessian.resize(mBlocks);
        mInverse.resize(mBlocks);
        for (auto *vector : {&mGround, &mResidual, &mPreconditioned, &mSearch, &mProduct, &mSum, &mPull})
            vector->assign(6 * mBlocks, Lanes{});
    }

    void invalidate() override { mFresh = false; }

    void compute(const HessianBlocks &blocks, std::span<const double> gradient,
                 std::span<double> direction) override
    {
        if (!mFresh || mExcess >= mExcessLimit)
            refresh(blocks);
        else
            prepareTriangles(blocks);
        int iterations = conjugateGradients(gradient, direction);
        if (iterations >= maxIterations && mExcess > 0) {
            refresh(blocks);
            iterations = conjugateGradients(gradient, direction);
        }
        if (mBaseline < 0)
            mBaseline = iterations;
        mExcess += std::max(0, iterations - mBaseline);
    }

private:
    void refresh(const HessianBlocks &blocks)
    {
        groupCorners(blocks);
        prepareTriangles(blocks);
        buildHubMatrix(blocks);
        mFresh = true;
        mExcess = 0;
        mBaseline = -1;
    }

    //! Groups of two or more corners that closed pairs tie together become hubs, numbered in elimination
    //! order.
    void groupCorners(const HessianBlocks &blocks)
    {
        UnionFind sets(mCorners);
        for (std::size_t p = 0; p < mSoup->pairCorners.size(); ++p) {
            if (blocks.pairClosed[p])
                sets.unite(mSoup->pairCorners[p][0], mSoup->pairCorners[p][1]);
        }
        std::vector<int> size(mCorners, 0);
        for (int c = 0; c < mCorners; ++c)
            ++size[sets.find(c)];
        std::vector<int> roots;
        for (int c = 0; c < mCorners; ++c) {
            if (size[c] > 1)
                roots.push_back(c);
        }
        const MeshData &mesh = *mSoup->mesh;
        std::vector<std::pair<int, int>> order;
        order.reserve(roots.size());
        for (const int root : roots)
            order.emplace_back(mRank[mesh.vertexOfSoup(root)], root);
        std::sort(order.begin(), order.end());
        std::vector<int> number(mCorners, -1);
        for (std::size_t i = 0; i < order.size(); ++i)
            number[order[i].second] = static_cast<int>(i);
        mHubCount = static_cast<int>(order.size());
        mHub.resize(mCorners);
        for (int c = 0; c < mCorners; ++c)
            mHub[c] = number[sets.find(c)];
    }

    //! Springs of the corners, the matrices S^-1, and the Hessian for the products.
    void prepareTriangles(const HessianBlocks &blocks)
    {
        mStar.assign(mCorners, 0.0f);
        mPair.assign(blocks.pair.begin(), blocks.pair.end());
        // What holds a corner beside its triangle and its hub.
        mHold.assign(blocks.ground.begin(), blocks.ground.end());
        for (std::size_t p = 0; p < mPair.size(); ++p) {
            const auto [a, b] = mSoup->pairCorners[p];
            if (mHub[a] >= 0 && mHub[a] == mHub[b]) {
                mStar[a] += mPair[p];
                mStar[b] += mPair[p];
            } else if (mHub[a] < 0 || mHub[b] < 0) {
                for (int axis = 0; axis < 2; ++axis) {
                    mHold[2 * static_cast<std::size_t>(a) + axis] += mPair[p];
                    mHold[2 * static_cast<std::size_t>(b) + axis] += mPair[p];
                }
            }
        }
        std::fill(mGround.begin(), mGround.end(), Lanes{});
        float *ground = flat(mGround);
        for (int c = 0; c < mCorners; ++c) {
            for (int axis = 0; axis < 2; ++axis)
                ground[mSlot[c] + axis * laneCount] =
                    static_cast<float>(blocks.ground[2 * static_cast<std::size_t>(c) + axis]);
        }
        for (std::size_t block = 0; block < mBlocks; ++block)
            prepareBlock(blocks, block);
    }

    void prepareBlock(const HessianBlocks &blocks, std::size_t block)
    {
        LaneMatrix &hessian = mHessian[block];
        LaneMatrix s{};
        for (int lane = 0; lane < laneCount; ++lane) {
            const int t = static_cast<int>(block) * laneCount + lane;
            if (t >= mSoup->triangleCount()) {
                for (int e = 0; e < 21; ++e)
                    hessian[e][lane] = 0;
                for (const int d : diagonalEntry)
                    s[d][lane] = 1;
                continue;
            }
            const std::array<double, 21> &source = blocks.triangle[t];
            float trace = 0;
            for (int e = 0; e < 21; ++e)
                hessian[e][lane] = s[e][lane] = static_cast<float>(source[e]);
            for (const int d : diagonalEntry)
                trace += hessian[d][lane];
            for (int i = 0; i < 6; ++i) {
                const int corner = 3 * t + i / 2;
                float add = 1e-4f * trace + mStar[corner] + mHold[6 * static_cast<std::size_t>(t) + i];
                if (!mHeld.empty() && mHeld[corner])
                    add += 1e6f * (trace + 1);
                s[diagonalEntry[i]][lane] += add;
            }
        }
        invertLanes(s, mInverse[block]);
    }

    void buildHubMatrix(const HessianBlocks &blocks)
    {
        if (mHubCount == 0)
            return;
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(24 * static_cast<std::size_t>(mSoup->triangleCount()));
        for (int t = 0; t < mSoup->triangleCount(); ++t)
            addTriangleToHubs(t, entries);
        for (std::size_t p = 0; p < mPair.size(); ++p) {
            const auto [a, b] = mSoup->pairCorners[p];
            const int i = mHub[a], j = mHub[b];
            if (i < 0 || j < 0 || i == j || blocks.pair[p] == 0)
                continue;
            for (int axis = 0; axis < 2; ++axis) {
                entries.emplace_back(2 * i + axis, 2 * i + axis, blocks.pair[p]);
                entries.emplace_back(2 * j + axis, 2 * j + axis, blocks.pair[p]);
                entries.emplace_back(2 * std::max(i, j) + axis, 2 * std::min(i, j) + axis, -blocks.pair[p]);
            }
        }
        LinearSolver::Matrix matrix(2 * mHubCount, 2 * mHubCount);
        matrix.setFromTriplets(entries.begin(), entries.end());
        mSolver.analyze(matrix, LinearSolver::Order::Natural);
        double shift = 1e-7 * matrix.diagonal().mean();
        for (int attempt = 0;; ++attempt, shift *= 100) {
            for (int i = 0; i < 2 * mHubCount; ++i)
                matrix.coeffRef(i, i) += shift;
            if (mSolver.factorize(matrix))
                return;
            if (attempt == 8)
                throw std::runtime_error("HubDirection: the hub matrix could not be factorised");
        }
    }

    void addTriangleToHubs(int t, std::vector<Eigen::Triplet<double>> &entries) const
    {
        const LaneMatrix &inverse = mInverse[t / laneCount];
        const int lane = t % laneCount;
        int at = 0;
        for (int i = 0; i < 6; ++i) {
            const int ci = 3 * t + i / 2;
            for (int j = 0; j <= i; ++j, ++at) {
                const int cj = 3 * t + j / 2;
                if (mHub[ci] < 0 || mHub[cj] < 0)
                    continue;
                const int row = 2 * mHub[ci] + i % 2;
                const int column = 2 * mHub[cj] + j % 2;
                double value = -double(mStar[ci]) * inverse[at][lane] * mStar[cj];
                if (i == j)
                    value += mStar[ci];
                else if (row == column)
                    value *= 2;
                entries.emplace_back(std::max(row, column), std::min(row, column), value);
            }
        }
    }

    static float *flat(std::vector<Lanes> &v) { return reinterpret_cast<float *>(v.data()); }

    //! z = M^-1 r.
    void precondition(std::vector<Lanes> &r, std::vector<Lanes> &z)
    {
        for (std::size_t block = 0; block < mBlocks; ++block)
            multiplyLanes(mInverse[block], &r[6 * block], &z[6 * block]);
        if (mHubCount == 0) {
            clearHeld(z);
            return;
        }
        mRightHand.setZero(2 * mHubCount);
        const float *zFlat = flat(z);
        for (int c = 0; c < mCorners; ++c) {
            const int hub = mHub[c];
            if (hub < 0)
                continue;
            mRightHand[2 * hub] += mStar[c] * zFlat[mSlot[c]];
            mRightHand[2 * hub + 1] += mStar[c] * zFlat[mSlot[c] + laneCount];
        }
        mSolver.solve(mRightHand, mHubSolution);
        float *pull = flat(mPull);
        for (int c = 0; c < mCorners; ++c) {
            const int hub = mHub[c];
            pull[mSlot[c]] = hub < 0 ? 0 : mStar[c] * static_cast<float>(mHubSolution[2 * hub]);
            pull[mSlot[c] + laneCount] =
                hub < 0 ? 0 : mStar[c] * static_cast<float>(mHubSolution[2 * hub + 1]);
        }
        for (std::size_t block = 0; block < mBlocks; ++block) {
            Lanes moved[6];
            multiplyLanes(mInverse[block], &mPull[6 * block], moved);
            for (int i = 0; i < 6; ++i)
                z[6 * block + i] += moved[i];
        }
        clearHeld(z);
    }

    //! q = H p.
    void multiply(std::vector<Lanes> &p, std::vector<Lanes> &q)
    {
        for (std::size_t block = 0; block < mBlocks; ++block) {
            multiplyLanes(mHessian[block], &p[6 * block], &q[6 * block]);
            for (int i = 0; i < 6; ++i)
                q[6 * block + i] += mGround[6 * block + i] * p[6 * block + i];
        }
        const float *pFlat = flat(p);
        float *qFlat = flat(q);
        for (std::size_t i = 0; i < mPair.size(); ++i) {
            const int a = mSlot[mSoup->pairCorners[i][0]];
            const int b = mSlot[mSoup->pairCorners[i][1]];
            const float du = mPair[i] * (pFlat[a] - pFlat[b]);
            const float dv = mPair[i] * (pFlat[a + laneCount] - pFlat[b + laneCount]);
            qFlat[a] += du;
            qFlat[a + laneCount] += dv;
            qFlat[b] -= du;
            qFlat[b + laneCount] -= dv;
        }
        clearHeld(q);
    }

    void clearHeld(std::vector<Lanes> &v) const
    {
        if (mHeld.empty())
            return;
        float *values = flat(v);
        for (int c = 0; c < mCorners; ++c) {
            if (mHeld[c])
                values[mSlot[c]] = values[mSlot[c] + laneCount] = 0;
        }
    }

    //! Sums within blocks in single precision, over blocks in double.
    static double dot(const std::vector<Lanes> &a, const std::vector<Lanes> &b)
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); i += 6) {
            Lanes part = a[i] * b[i];
            for (std::size_t k = i + 1; k < i + 6; ++k)
                part += a[k] * b[k];
            for (int lane = 0; lane < laneCount; ++lane)
                sum += part[lane];
        }
        return sum;
    }

    //! Returns the number of iterations.
    int conjugateGradients(std::span<const double> gradient, std::span<double> direction)
    {
        std::vector<Lanes> &r = mResidual, &z = mPreconditioned, &p = mSearch, &q = mProduct, &x = mSum;
        // Scaled to unit length, so that single precision serves gradients of any size.
        double norm = 0;
        for (const double g : gradient)
            norm += g * g;
        norm = std::sqrt(norm);
        if (norm == 0) {
            std::fill(direction.begin(), direction.end(), 0.0);
            return 0;
        }
        std::fill(r.begin(), r.end(), Lanes{});
        std::fill(x.begin(), x.end(), Lanes{});
        float *rFlat = flat(r);
        for (int c = 0; c < mCorners; ++c) {
            for (int axis = 0; axis < 2; ++axis)
                rFlat[mSlot[c] + axis * laneCount] =
                    static_cast<float>(-gradient[2 * static_cast<std::size_t>(c) + axis] / norm);
        }
        clearHeld(r);
        const double target = residualTolerance * std::sqrt(dot(r, r));
        precondition(r, z);
        p = z;
        double rz = dot(r, z);
        int iteration = 0;
        while (iteration < maxIterations && rz > 0) {
            multiply(p, q);
            const double curvature = dot(p, q);
            if (!(curvature > 0))
                break;
            const float alpha = static_cast<float>(rz / curvature);
            for (std::size_t i = 0; i < x.size(); ++i) {
                x[i] += alpha * p[i];
                r[i] -= alpha * q[i];
            }
            ++iteration;
            if (std::sqrt(dot(r, r)) < target)
                break;
            precondition(r, z);
            const double next = dot(r, z);
            const float beta = static_cast<float>(next / rz);
            rz = next;
            for (std::size_t i = 0; i < p.size(); ++i)
                p[i] = z[i] + beta * p[i];
        }
        const float *xFlat = flat(x);
        for (int c = 0; c < mCorners; ++c) {
            for (int axis = 0; axis < 2; ++axis)
                direction[2 * static_cast<std::size_t>(c) + axis] = norm * xFlat[mSlot[c] + axis * laneCount];
        }
        return iteration;
    }

    std::shared_ptr<const Soup> mSoup;
    std::vector<bool> mHeld;
    std::vector<int> mRank;
    int mCorners;

    bool mFresh = false;
    int mExcess = 0, mExcessLimit = 0, mBaseline = -1;
    int mHubCount = 0;
    std::vector<int> mHub;    //!< hub of each corner, -1 for a corner on its own
    std::vector<float> mStar; //!< k_c: spring between a corner and its hub
    std::vector<float> mPair; //!< spring constants of the corner pairs
    std::vector<float> mHold; //!< per coordinate

    // Triangles lie eight to a block; coordinate i of a block's triangles is one Lanes, number 6 * block + i.
    std::size_t mBlocks = 0;
    std::vector<int>
        mSlot; //!< place of a corner's u in the flat view of such a vector; v is laneCount further
    std::vector<LaneMatrix> mHessian, mInverse;
    std::vector<Lanes> mGround;
    CholmodSolver mSolver;
    Eigen::VectorXd mRightHand, mHubSolution;
    std::vector<Lanes> mResidual, mPreconditioned, mSearch, mProduct, mSum, mPull;
};

} // namespace

std::unique_ptr<NewtonDirection> makeHubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held)
{
    return std::make_unique<HubDirection>(std::move(soup), std::move(held));
}

} // namespace autocuts
