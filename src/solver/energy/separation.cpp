#include "solver/energy/separation.h"

#include "solver/base/simd.h"

namespace autocuts::energy {

namespace {

//! Below this separation a pair counts as closed, so that the preconditioner may group its corners. Measured
//! on the first meshes (docs/constants.md): anything from 0.5 to 0.9 serves equally well.
constexpr double closedSeparation = 0.7;

inline double squaredDistance(const double *x, const std::array<int, 2> &pair)
{
    const double *a = x + 2 * static_cast<std::ptrdiff_t>(pair[0]);
    const double *b = x + 2 * static_cast<std::ptrdiff_t>(pair[1]);
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

AUTOCUTS_CLONES
double separationSum(const double *x, const std::array<int, 2> *pairs, const double *weights, double delta,
                     int first, int end)
{
    double sum = 0;
    for (int p = first; p < end; ++p) {
        const double t = squaredDistance(x, pairs[p]);
        sum += weights[p] * (t / (t + delta));
    }
    return sum;
}

//! The same sum. Also writes the spring constants and marks the closed pairs.
// Many parameters: a loop over plain arrays, which the compiler can vectorise for each processor.
AUTOCUTS_CLONES
double separationSprings(const double *x, const std::array<int, 2> *pairs, const double *weights,
                         double factor, double delta, int first, int end, double *spring,
                         std::uint8_t *closed)
{
    double sum = 0;
    for (int p = first; p < end; ++p) {
        const double t = squaredDistance(x, pairs[p]);
        const double inverse = 1 / (t + delta);
        const double w = factor * weights[p] * delta * inverse * inverse;
        sum += weights[p] * (t / (t + delta));
        spring[p] = w;
        closed[p] = w > 0 && t < closedSeparation * (t + delta);
    }
    return sum;
}

} // namespace

double SeparationTerm::value(std::span<const double> x) const
{
    const auto sum = [&](int first, int end) {
        return separationSum(x.data(), mSoup->pairCorners.data(), mWeights.data(), mDelta, first, end);
    };
    return 0.5 * mFactor * sumInOrder(mTeam, static_cast<int>(mWeights.size()), sum);
}

double SeparationTerm::addDerivatives(std::span<const double> x, std::span<double> gradient,
                                      HessianBlocks &blocks) const
{
    const auto springs = [&](int first, int end) {
        return separationSprings(x.data(), mSoup->pairCorners.data(), mWeights.data(), mFactor, mDelta, first,
                                 end, blocks.pair.data(), blocks.pairClosed.data());
    };
    const double sum = sumInOrder(mTeam, static_cast<int>(mWeights.size()), springs);
    // By corner, not by pair, so that no two threads write to the same place.
    const std::vector<CornerPartners> &partners = mSoup->partners;
    runOn(mTeam, jobCount(static_cast<int>(partners.size())), [&](int job) {
        const int end = std::min(static_cast<int>(partners.size()), (job + 1) * jobSize);
        for (int c = job * jobSize; c < end; ++c) {
            double *own = &gradient[2 * static_cast<std::size_t>(c)];
            const double u = x[2 * static_cast<std::size_t>(c)], v = x[2 * static_cast<std::size_t>(c) + 1];
            for (int i = 0; i < 2; ++i) {
                const int pair = partners[c].pair[i];
                if (pair < 0)
                    continue;
                const double *other = &x[2 * static_cast<std::size_t>(partners[c].corner[i])];
                own[0] += blocks.pair[pair] * (u - other[0]);
                own[1] += blocks.pair[pair] * (v - other[1]);
            }
        }
    });
    return 0.5 * mFactor * sum;
}

double SeparationTerm::separation(std::span<const double> x, int pair) const
{
    const double t = squaredDistance(x.data(), mSoup->pairCorners[pair]);
    return t / (t + mDelta);
}

std::vector<double> pairWeights(const Soup &soup, const Snapshot &snapshot)
{
    std::vector<double> weights(soup.pairLength.size());
    const bool byLength = snapshot.settings.weighting == SeamWeighting::Length;
    for (std::size_t p = 0; p < weights.size(); ++p) {
        double w = byLength ? soup.pairLength[p] : soup.meanEdgeLength;
        if (soup.mesh->edgePairs[p / 2].diagonal) {
            weights[p] = w * diagonalWeight;
            continue;
        }
        if (!snapshot.steering->pairWeight.empty())
            w *= snapshot.steering->pairWeight[p];
        if (!snapshot.steering->pairState.empty()) {
            if (snapshot.steering->pairState[p] == PairState::Cut)
                w = 0;
            else if (snapshot.steering->pairState[p] == PairState::Joined)
                w *= joinedWeight;
        }
        weights[p] = w;
    }
    return weights;
}

} // namespace autocuts::energy
