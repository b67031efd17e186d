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

//! Inverse of a symmetric positive definite 6 x 6 matrix, both as packed lower triangles.
void invert6(const std::array<double, 21> &a, std::array<double, 21> &inverse)
{
    double l[6][6];
    double r[6];    // 1 / diagonal of l
    int at = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = a[at++];
            for (int k = 0; k < j; ++k)
                sum -= l[i][k] * l[j][k];
            if (i == j) {
                l[i][i] = std::sqrt(std::max(sum, 1e-30));
                r[i] = 1 / l[i][i];
            } else {
                l[i][j] = sum * r[j];
            }
        }
    }
    double w[6][6];    // inverse of l
    for (int j = 0; j < 6; ++j) {
        w[j][j] = r[j];
        for (int i = j + 1; i < 6; ++i) {
            double sum = 0;
            for (int k = j; k < i; ++k)
                sum += l[i][k] * w[k][j];
            w[i][j] = -sum * r[i];
        }
    }
    at = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = 0;
            for (int k = i; k < 6; ++k)
                sum += w[k][i] * w[k][j];
            inverse[at++] = sum;
        }
    }
}

//! y = A x for a packed lower triangle.
inline void multiply6(const float *a, const float *x, float *y)
{
    y[0] = a[0] * x[0] + a[1] * x[1] + a[3] * x[2] + a[6] * x[3] + a[10] * x[4] + a[15] * x[5];
    y[1] = a[1] * x[0] + a[2] * x[1] + a[4] * x[2] + a[7] * x[3] + a[11] * x[4] + a[16] * x[5];
    y[2] = a[3] * x[0] + a[4] * x[1] + a[5] * x[2] + a[8] * x[3] + a[12] * x[4] + a[17] * x[5];
    y[3] = a[6] * x[0] + a[7] * x[1] + a[8] * x[2] + a[9] * x[3] + a[13] * x[4] + a[18] * x[5];
    y[4] = a[10] * x[0] + a[11] * x[1] + a[12] * x[2] + a[13] * x[3] + a[14] * x[4] + a[19] * x[5];
    y[5] = a[15] * x[0] + a[16] * x[1] + a[17] * x[2] + a[18] * x[3] + a[19] * x[4] + a[20] * x[5];
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
    }

    void invalidate() override { mFresh = false; }

    void compute(const HessianBlocks &blocks, std::span<const double> gradient,
                 std::span<double> direction) override
    {
        if (!mFresh || mExcess >= mExcessLimit)
            refresh(blocks);
        else
            prepareTriangles(blocks);
        int iterations = conjugateGradients(blocks, gradient, direction);
        if (iterations >= maxIterations && mExcess > 0) {
            refresh(blocks);
            iterations = conjugateGradients(blocks, gradient, direction);
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

    //! Groups of two or more corners that closed pairs tie together become hubs, numbered in elimination order.
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

    //! Springs of the corners, the matrices S^-1 in single precision, and the Hessian for the products.
    void prepareTriangles(const HessianBlocks &blocks)
    {
        mStar.assign(mCorners, 0.0f);
        mGround.assign(2 * static_cast<std::size_t>(mCorners), 0.0);
        std::copy(blocks.ground.begin(), blocks.ground.end(), mGround.begin());
        mPair.assign(blocks.pair.begin(), blocks.pair.end());
        for (std::size_t p = 0; p < mPair.size(); ++p) {
            const auto [a, b] = mSoup->pairCorners[p];
            const double w = blocks.pair[p];
            if (mHub[a] >= 0 && mHub[a] == mHub[b]) {
                mStar[a] += static_cast<float>(w);
                mStar[b] += static_cast<float>(w);
            } else if (mHub[a] < 0 || mHub[b] < 0) {
                for (int axis = 0; axis < 2; ++axis) {
                    mGround[2 * static_cast<std::size_t>(a) + axis] += w;
                    mGround[2 * static_cast<std::size_t>(b) + axis] += w;
                }
            }
        }
        const int count = mSoup->triangleCount();
        mBlock.resize(21 * static_cast<std::size_t>(count));
        mInverse.resize(21 * static_cast<std::size_t>(count));
        std::array<double, 21> s, inverse;
        for (int t = 0; t < count; ++t) {
            s = blocks.triangle[t];
            double trace = 0;
            for (const int d : diagonalEntry)
                trace += s[d];
            const double shift = 1e-4 * trace;
            for (int i = 0; i < 6; ++i) {
                const int corner = 3 * t + i / 2;
                double &d = s[diagonalEntry[i]];
                d += shift + mStar[corner] + mGround[6 * static_cast<std::size_t>(t) + i];
                if (!mHeld.empty() && mHeld[corner])
                    d += 1e6 * (trace + 1);
            }
            invert6(s, inverse);
            float *block = &mBlock[21 * static_cast<std::size_t>(t)];
            float *inv = &mInverse[21 * static_cast<std::size_t>(t)];
            for (int e = 0; e < 21; ++e) {
                block[e] = static_cast<float>(blocks.triangle[t][e]);
                inv[e] = static_cast<float>(inverse[e]);
            }
        }
        for (std::size_t i = 0; i < blocks.ground.size(); ++i)
            mGround[i] = blocks.ground[i];
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
        const float *inverse = &mInverse[21 * static_cast<std::size_t>(t)];
        int at = 0;
        for (int i = 0; i < 6; ++i) {
            const int ci = 3 * t + i / 2;
            for (int j = 0; j <= i; ++j, ++at) {
                const int cj = 3 * t + j / 2;
                if (mHub[ci] < 0 || mHub[cj] < 0)
                    continue;
                const int row = 2 * mHub[ci] + i % 2;
                const int column = 2 * mHub[cj] + j % 2;
                double value = -double(mStar[ci]) * inverse[at] * mStar[cj];
                if (i == j)
                    value += mStar[ci];
                else if (row == column)
                    value *= 2;
                entries.emplace_back(std::max(row, column), std::min(row, column), value);
            }
        }
    }

    //! z = M^-1 r.
    void precondition(const std::vector<float> &r, std::vector<float> &z)
    {
        mRightHand.setZero(2 * mHubCount);
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            const std::size_t at = 6 * static_cast<std::size_t>(t);
            multiply6(&mInverse[21 * static_cast<std::size_t>(t)], &r[at], &z[at]);
            for (int k = 0; k < 3; ++k) {
                const int hub = mHub[3 * t + k];
                if (hub < 0)
                    continue;
                mRightHand[2 * hub] += mStar[3 * t + k] * z[at + 2 * k];
                mRightHand[2 * hub + 1] += mStar[3 * t + k] * z[at + 2 * k + 1];
            }
        }
        if (mHubCount == 0)
            return;
        mSolver.solve(mRightHand, mHubSolution);
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            const std::size_t at = 6 * static_cast<std::size_t>(t);
            float pull[6], moved[6];
            for (int k = 0; k < 3; ++k) {
                const int hub = mHub[3 * t + k];
                const float star = mStar[3 * t + k];
                pull[2 * k] = hub < 0 ? 0 : star * static_cast<float>(mHubSolution[2 * hub]);
                pull[2 * k + 1] = hub < 0 ? 0 : star * static_cast<float>(mHubSolution[2 * hub + 1]);
            }
            multiply6(&mInverse[21 * static_cast<std::size_t>(t)], pull, moved);
            for (int i = 0; i < 6; ++i)
                z[at + i] += moved[i];
        }
    }

    //! q = H p.
    void multiply(const std::vector<float> &p, std::vector<float> &q) const
    {
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            const std::size_t at = 6 * static_cast<std::size_t>(t);
            multiply6(&mBlock[21 * static_cast<std::size_t>(t)], &p[at], &q[at]);
            for (int i = 0; i < 6; ++i)
                q[at + i] += static_cast<float>(mGround[at + i]) * p[at + i];
        }
        for (std::size_t i = 0; i < mPair.size(); ++i) {
            const std::size_t a = 2 * static_cast<std::size_t>(mSoup->pairCorners[i][0]);
            const std::size_t b = 2 * static_cast<std::size_t>(mSoup->pairCorners[i][1]);
            const float du = mPair[i] * (p[a] - p[b]);
            const float dv = mPair[i] * (p[a + 1] - p[b + 1]);
            q[a] += du;
            q[a + 1] += dv;
            q[b] -= du;
            q[b + 1] -= dv;
        }
        clearHeld(q);
    }

    void clearHeld(std::vector<float> &v) const
    {
        if (mHeld.empty())
            return;
        for (int c = 0; c < mCorners; ++c) {
            if (mHeld[c])
                v[2 * static_cast<std::size_t>(c)] = v[2 * static_cast<std::size_t>(c) + 1] = 0;
        }
    }

    static double dot(const std::vector<float> &a, const std::vector<float> &b)
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += double(a[i]) * b[i];
        return sum;
    }

    //! Returns the number of iterations.
    int conjugateGradients(const HessianBlocks &, std::span<const double> gradient,
                           std::span<double> direction)
    {
        const std::size_t n = gradient.size();
        std::vector<float> &r = mResidual, &z = mPreconditioned, &p = mSearch, &q = mProduct, &x = mSum;
        // Scaled to unit length, so that single precision serves gradients of any size.
        double norm = 0;
        for (const double g : gradient)
            norm += g * g;
        norm = std::sqrt(norm);
        if (norm == 0) {
            std::fill(direction.begin(), direction.end(), 0.0);
            return 0;
        }
        r.resize(n);
        for (std::size_t i = 0; i < n; ++i)
            r[i] = static_cast<float>(-gradient[i] / norm);
        clearHeld(r);
        z.resize(n);
        q.resize(n);
        x.assign(n, 0.0f);
        const double target = residualTolerance * std::sqrt(dot(r, r));
        precondition(r, z);
        clearHeld(z);
        p = z;
        double rz = dot(r, z);
        int iteration = 0;
        while (iteration < maxIterations && rz > 0) {
            multiply(p, q);
            const double curvature = dot(p, q);
            if (!(curvature > 0))
                break;
            const float alpha = static_cast<float>(rz / curvature);
            for (std::size_t i = 0; i < n; ++i) {
                x[i] += alpha * p[i];
                r[i] -= alpha * q[i];
            }
            ++iteration;
            if (std::sqrt(dot(r, r)) < target)
                break;
            precondition(r, z);
            clearHeld(z);
            const double next = dot(r, z);
            const float beta = static_cast<float>(next / rz);
            rz = next;
            for (std::size_t i = 0; i < n; ++i)
                p[i] = z[i] + beta * p[i];
        }
        for (std::size_t i = 0; i < n; ++i)
            direction[i] = norm * x[i];
        return iteration;
    }

    std::shared_ptr<const Soup> mSoup;
    std::vector<bool> mHeld;
    std::vector<int> mRank;
    int mCorners;

    bool mFresh = false;
    int mExcess = 0, mExcessLimit = 0, mBaseline = -1;
    int mHubCount = 0;
    std::vector<int> mHub;         //!< hub of each corner, -1 for a corner on its own
    std::vector<float> mStar;      //!< k_c: spring between a corner and its hub
    std::vector<float> mPair;      //!< spring constants of the corner pairs
    std::vector<double> mGround;   //!< per coordinate
    std::vector<float> mBlock, mInverse;    //!< per triangle, packed
    CholmodSolver mSolver;
    Eigen::VectorXd mRightHand, mHubSolution;
    std::vector<float> mResidual, mPreconditioned, mSearch, mProduct, mSum;
};

} // namespace

std::unique_ptr<NewtonDirection> makeHubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held)
{
    return std::make_unique<HubDirection>(std::move(soup), std::move(held));
}

} // namespace autocuts
