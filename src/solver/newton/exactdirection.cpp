// Exact Newton directions by sparse Cholesky.
#include "solver/linear/cholmodsolver.h"
#include "solver/newton/newtondirection.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace autocuts::newton {

UnknownMap UnknownMap::identity(int soupCorners)
{
    UnknownMap map;
    map.unknown.resize(soupCorners);
    std::iota(map.unknown.begin(), map.unknown.end(), 0);
    map.count = soupCorners;
    return map;
}

namespace {

class ExactDirection final : public NewtonDirection
{
public:
    ExactDirection(std::shared_ptr<const Soup> soup, UnknownMap map)
        : mSoup(std::move(soup)), mMap(std::move(map))
    {
        buildPattern();
    }

    void compute(energy::HessianBlocks &blocks, std::span<const double> gradient,
                 std::span<double> direction) override
    {
        if (mMap.count == 0) {
            std::fill(direction.begin(), direction.end(), 0.0);
            return;
        }
        fill(blocks);
        factorize();
        Eigen::VectorXd rhs = Eigen::VectorXd::Zero(2 * mMap.count);
        for (std::size_t c = 0; c < mMap.unknown.size(); ++c) {
            const int u = mMap.unknown[c];
            if (u < 0)
                continue;
            rhs[2 * u] -= gradient[2 * c];
            rhs[2 * u + 1] -= gradient[2 * c + 1];
        }
        Eigen::VectorXd solution;
        mSolver.solve(rhs, solution);
        for (std::size_t c = 0; c < mMap.unknown.size(); ++c) {
            const int u = mMap.unknown[c];
            direction[2 * c] = u < 0 ? 0 : solution[2 * u];
            direction[2 * c + 1] = u < 0 ? 0 : solution[2 * u + 1];
        }
    }

private:
    //! Row and column of the matrix, lower triangle; -1 for a held coordinate.
    int coordinate(int soupCorner, int axis) const
    {
        const int u = mMap.unknown[soupCorner];
        return u < 0 ? -1 : 2 * u + axis;
    }

    template <class Visit>
    void forEachEntry(Visit &&visit) const
    {
        // Visits the entries in a fixed order, so that the n-th call always means the same entry.
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            int entry = 0;
            for (int i = 0; i < 6; ++i) {
                for (int j = 0; j <= i; ++j, ++entry)
                    visit(coordinate(3 * t + i / 2, i % 2), coordinate(3 * t + j / 2, j % 2), 0, t, entry);
            }
        }
        for (int p = 0; p < static_cast<int>(mSoup->pairCorners.size()); ++p) {
            const auto [a, b] = mSoup->pairCorners[p];
            if (mMap.unknown[a] == mMap.unknown[b])
                continue;
            for (int axis = 0; axis < 2; ++axis) {
                visit(coordinate(a, axis), coordinate(a, axis), 1, p, 0);
                visit(coordinate(b, axis), coordinate(b, axis), 1, p, 0);
                visit(coordinate(a, axis), coordinate(b, axis), 2, p, 0);
            }
        }
    }

    void buildPattern()
    {
        std::vector<Eigen::Triplet<double>> triplets;
        forEachEntry([&](int row, int column, int, int, int) {
            if (row >= 0 && column >= 0)
                triplets.emplace_back(std::max(row, column), std::min(row, column), 0.0);
        });
        for (int i = 0; i < 2 * mMap.count; ++i)
            triplets.emplace_back(i, i, 0.0);
        mMatrix.resize(2 * mMap.count, 2 * mMap.count);
        mMatrix.setFromTriplets(triplets.begin(), triplets.end());
        mMatrix.makeCompressed();
        forEachEntry([&](int row, int column, int, int, int) {
            mSlot.push_back(row < 0 || column < 0 ? -1 : slot(std::max(row, column), std::min(row, column)));
        });
        mDiagonal.resize(2 * mMap.count);
        for (int i = 0; i < 2 * mMap.count; ++i)
            mDiagonal[i] = slot(i, i);
        if (mMap.count > 0)
            mSolver.analyze(mMatrix, linear::LinearSolver::Order::FillReducing);
    }

    int slot(int row, int column) const
    {
        const int *begin = mMatrix.innerIndexPtr() + mMatrix.outerIndexPtr()[column];
        const int *end = mMatrix.innerIndexPtr() + mMatrix.outerIndexPtr()[column + 1];
        return static_cast<int>(std::lower_bound(begin, end, row) - mMatrix.innerIndexPtr());
    }

    void fill(const energy::HessianBlocks &blocks)
    {
        double *values = mMatrix.valuePtr();
        std::fill(values, values + mMatrix.nonZeros(), 0.0);
        std::size_t n = 0;
        forEachEntry([&](int row, int column, int kind, int index, int entry) {
            const int at = mSlot[n++];
            if (at < 0)
                return;
            if (kind == 0) {
                // Two corners of one triangle may share an unknown: then both symmetric halves add to one
                // entry.
                const double twice = row == column && entryOffDiagonal(entry) ? 2 : 1;
                values[at] += twice * blocks.triangle[index][entry];
            } else {
                values[at] += kind == 1 ? blocks.pair[index] : -blocks.pair[index];
            }
        });
        for (std::size_t c = 0; !blocks.ground.empty() && c < mMap.unknown.size(); ++c) {
            const int u = mMap.unknown[c];
            if (u < 0)
                continue;
            values[mDiagonal[2 * u]] += blocks.ground[2 * c];
            values[mDiagonal[2 * u + 1]] += blocks.ground[2 * c + 1];
        }
    }

    static bool entryOffDiagonal(int entry)
    {
        return entry != 0 && entry != 2 && entry != 5 && entry != 9 && entry != 14 && entry != 20;
    }

    //! Factorises with a small shift added to the diagonal: the energy does not change when all corners move
    //! alike, so the Hessian alone may be singular.
    void factorize()
    {
        double *values = mMatrix.valuePtr();
        double sum = 0;
        for (const int d : mDiagonal)
            sum += values[d];
        // Relative to the mean diagonal entry. Chosen by hand.
        double shift = 1e-9 * sum / double(mDiagonal.size());
        for (int attempt = 0; attempt < 8; ++attempt, shift *= 100) {
            for (const int d : mDiagonal)
                values[d] += shift;
            if (mSolver.factorize(mMatrix))
                return;
        }
        throw std::runtime_error(
            "the solver found no step: the mesh may mix very large and very small triangles");
    }

    std::shared_ptr<const Soup> mSoup;
    UnknownMap mMap;
    linear::CholmodSolver mSolver;
    linear::LinearSolver::Matrix mMatrix;
    std::vector<int> mSlot, mDiagonal;
};

} // namespace

std::unique_ptr<NewtonDirection> makeExactDirection(std::shared_ptr<const Soup> soup, UnknownMap map)
{
    return std::make_unique<ExactDirection>(std::move(soup), std::move(map));
}

} // namespace autocuts::newton
