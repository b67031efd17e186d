// Newton's method on a patch.
#include "solver/search/patch.h"

#include "solver/base/linesearch.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

constexpr int maxHalvings = 12; // of the step length; chosen by hand

} // namespace

double Patch::energyAt(const std::vector<double> &position) const
{
    double sum = 0;
    if (mGraph->hasPlainEnergy()) {
        mEnergies.resize(triangleLanes * mBlocks.size());
        blockEnergies(mBlocks, mPoint, position, mGraph->rigid != nullptr, mEnergies);
        for (std::size_t i = 0; i < mTriangles.size(); ++i)
            sum += mEnergies[i];
        return sum;
    }
    for (std::size_t i = 0; i < mTriangles.size(); ++i) {
        double p[6];
        for (int k = 0; k < 3; ++k) {
            const double *q = &position[2 * mPoint[3 * i + k]];
            p[2 * k] = q[0];
            p[2 * k + 1] = q[1];
        }
        sum += mState->energyOf(mTriangles[i], p);
    }
    return sum;
}

double Patch::springEnergy(const std::vector<double> &position) const
{
    double sum = 0;
    for (const Spring &s : mSprings) {
        const double u = position[2 * s.a] - position[2 * s.b];
        const double v = position[2 * s.a + 1] - position[2 * s.b + 1];
        sum += s.weight * (u * u + v * v);
    }
    return mStiffness * sum;
}

double Patch::smallestDeterminant() const
{
    const Soup &soup = *mGraph->soup;
    double smallest = 1e300;
    for (std::size_t i = 0; i < mTriangles.size(); ++i) {
        const Soup::Basis &b = soup.basis[mTriangles[i]];
        const double *p = &mPosition[2 * mPoint[3 * i]], *q = &mPosition[2 * mPoint[3 * i + 1]],
                     *r = &mPosition[2 * mPoint[3 * i + 2]];
        const double factor = b[2] * b[5] - b[3] * b[4];
        smallest =
            std::min(smallest, ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) * factor);
    }
    return smallest;
}

void Patch::assemble()
{
    mSystem.clear();
    mGradient.assign(2 * mSystem.count(), 0.0);
    assembleTriangles();
    assembleSprings();
    for (int u = 0; u < mSystem.count(); ++u) {
        BlockCholesky::Block &d = mSystem.diagonal(u);
        const double lift = mFrozen[u] ? frozenPivot : 1e-9 * (d[0] + d[3]);
        d[0] += lift;
        d[3] += lift;
        if (mFrozen[u])
            mGradient[2 * u] = mGradient[2 * u + 1] = 0;
    }
}

void Patch::assembleTriangles()
{
    if (mGraph->hasPlainEnergy()) {
        BlockDerivatives derivatives;
        const auto *gradient = reinterpret_cast<const double *>(derivatives.gradient);
        const auto *hessian = reinterpret_cast<const double *>(derivatives.hessian);
        for (std::size_t block = 0; block < mBlocks.size(); ++block) {
            blockDerivatives(mBlocks, block, mPoint, mPosition, derivatives);
            const std::size_t first = triangleLanes * block;
            for (std::size_t i = first; i < std::min(first + triangleLanes, mTriangles.size()); ++i)
                assembleTriangle<triangleLanes>(i, gradient + (i - first), hessian + (i - first));
        }
        return;
    }
    double gradient[6], hessian[21];
    for (std::size_t i = 0; i < mTriangles.size(); ++i) {
        double p[6];
        for (int k = 0; k < 3; ++k) {
            const double *q = &mPosition[2 * mPoint[3 * i + k]];
            p[2 * k] = q[0];
            p[2 * k + 1] = q[1];
        }
        mState->derivativesOf(mTriangles[i], p, gradient, hessian);
        assembleTriangle<1>(i, gradient, hessian);
    }
}

//! Adds the derivatives of a triangle to the system. \param g,h see dirichletDerivatives(), every stride-th
//! number
template <int stride>
void Patch::assembleTriangle(std::size_t i, const double *g, const double *h)
{
    const int unknown[3] = {mUnknown[mPoint[3 * i]], mUnknown[mPoint[3 * i + 1]],
                            mUnknown[mPoint[3 * i + 2]]};
    // Per corner: where the two rows of its diagonal block start in the packed lower triangle h.
    static constexpr int first[3][2] = {{0, 1}, {5, 8}, {14, 19}};
    for (int k = 0; k < 3; ++k) {
        if (unknown[k] < 0)
            continue;
        mGradient[2 * unknown[k]] += g[stride * (2 * k)];
        mGradient[2 * unknown[k] + 1] += g[stride * (2 * k + 1)];
        BlockCholesky::Block &d = mSystem.diagonal(unknown[k]);
        d[0] += h[stride * first[k][0]];
        d[2] += h[stride * first[k][1]];
        d[3] += h[stride * (first[k][1] + 1)];
    }
    // Per side: corners k and l, then where the rows 2k and 2k + 1 of its block start at column 2l in h.
    static constexpr int pairs[3][4] = {{1, 0, 3, 6}, {2, 1, 12, 17}, {2, 0, 10, 15}};
    for (int n = 0; n < 3; ++n) {
        const int place = mPlace[3 * i + n];
        if (place < 0)
            continue;
        const int k = pairs[n][0], l = pairs[n][1], top = pairs[n][2], low = pairs[n][3];
        BlockCholesky::Block &d = mSystem.offDiagonal(place);
        d[0] += h[stride * top];
        d[3] += h[stride * (low + 1)];
        if (unknown[k] > unknown[l]) {
            d[1] += h[stride * (top + 1)];
            d[2] += h[stride * low];
        } else {
            d[1] += h[stride * low];
            d[2] += h[stride * (top + 1)];
        }
    }
}

void Patch::assembleSprings()
{
    for (const Spring &s : mSprings) {
        const double w = 2 * mStiffness * s.weight;
        for (int sign = 1; sign >= -1; sign -= 2) {
            const int u = mUnknown[sign > 0 ? s.a : s.b];
            if (u < 0)
                continue;
            for (int axis = 0; axis < 2; ++axis)
                mGradient[2 * u + axis] += sign * w * (mPosition[2 * s.a + axis] - mPosition[2 * s.b + axis]);
            mSystem.diagonal(u)[0] += w;
            mSystem.diagonal(u)[3] += w;
        }
        if (s.place >= 0) {
            mSystem.offDiagonal(s.place)[0] -= w;
            mSystem.offDiagonal(s.place)[3] -= w;
        }
    }
}

bool Patch::solve(const JobContext &job)
{
    if (!mSystem.factorize(job))
        return false;
    mDirection.resize(mGradient.size());
    for (std::size_t i = 0; i < mGradient.size(); ++i)
        mDirection[i] = -mGradient[i];
    mSystem.solve(mDirection.data());
    return true;
}

double Patch::flipFreeStep(double limit) const
{
    double step = limit;
    const auto move = [this](int point, int axis) {
        const int u = mUnknown[point];
        return u < 0 ? 0.0 : mDirection[2 * u + axis];
    };
    for (std::size_t i = 0; i < mTriangles.size(); ++i) {
        const int p = mPoint[3 * i], q = mPoint[3 * i + 1], r = mPoint[3 * i + 2];
        step = flipFreeTriangleStep(
            {mPosition[2 * q] - mPosition[2 * p], mPosition[2 * q + 1] - mPosition[2 * p + 1],
             mPosition[2 * r] - mPosition[2 * p], mPosition[2 * r + 1] - mPosition[2 * p + 1]},
            {move(q, 0) - move(p, 0), move(q, 1) - move(p, 1), move(r, 0) - move(p, 0),
             move(r, 1) - move(p, 1)},
            step);
    }
    return step;
}

bool Patch::lineSearch(double before, const PatchLimits &limits, double slope, double &after)
{
    double length = std::min(1.0, flipMargin * flipFreeStep(1 / flipMargin));
    mTrial.resize(mPosition.size());
    int contacts = 0;
    for (int halving = 0; halving <= maxHalvings; ++halving, length *= 0.5) {
        for (std::size_t p = 0; p < mUnknown.size(); ++p) {
            const int u = mUnknown[p];
            for (std::size_t axis = 0; axis < 2; ++axis)
                mTrial[2 * p + axis] =
                    mPosition[2 * p + axis] + (u < 0 ? 0 : length * mDirection[2 * u + axis]);
        }
        after = energyAt(mTrial) + springEnergy(mTrial);
        if (!(after <= before + armijo * length * slope))
            continue;
        if (limits.guarded && mSegments.cross(mTrial)) {
            if (++contacts > contactHalvings)
                return false;
            continue;
        }
        mPosition.swap(mTrial);
        return true;
    }
    return false;
}

int Patch::minimize(const PatchLimits &limits)
{
    numberUnknowns();
    if (limits.guarded)
        crossesItself(); // fills mSegments
    double value = energy() + springEnergy(mPosition);
    std::vector<int> touched;
    for (int step = 0; step < limits.steps; ++step) {
        if (limits.job.stopped())
            return step;
        bool moved = false;
        std::fill(mFrozen.begin(), mFrozen.end(), 0);
        for (int round = 0; round < (limits.guarded ? freezeRounds : 1); ++round) {
            ++mSteps;
            mWork += static_cast<long long>(mTriangles.size());
            assemble();
            if (!solve(limits.job))
                return step;
            double slope = 0;
            for (std::size_t i = 0; i < mGradient.size(); ++i)
                slope += mGradient[i] * mDirection[i];
            if (!(-slope > limits.tolerance) || value + slope > limits.hopeless)
                return step;
            double after = value;
            if (lineSearch(value, limits, slope, after)) {
                value = after;
                moved = true;
                break;
            }
            if (!limits.guarded)
                return step;
            // Freeze the points whose boundary sides cross after the last, shortest trial step, and solve
            // again for the others.
            touched.clear();
            if (!mSegments.cross(mTrial, &touched))
                return step;
            for (const int p : touched) {
                if (mUnknown[p] >= 0)
                    mFrozen[mUnknown[p]] = 1;
            }
        }
        if (!moved)
            return step;
        if (limits.stepped)
            limits.stepped();
    }
    return limits.steps;
}

} // namespace autocuts::search
