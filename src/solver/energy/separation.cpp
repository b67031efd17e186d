#include "solver/energy/separation.h"

namespace autocuts {

namespace {

//! Below this separation a pair counts as closed; anything from 0.5 to 0.9 serves equally well.
constexpr double closedSeparation = 0.7;

inline double squaredDistance(std::span<const double> x, const std::array<int, 2> &pair)
{
    const double *a = &x[2 * static_cast<std::size_t>(pair[0])];
    const double *b = &x[2 * static_cast<std::size_t>(pair[1])];
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

} // namespace

double SeparationTerm::value(std::span<const double> x) const
{
    double sum = 0;
    for (std::size_t p = 0; p < mWeights.size(); ++p) {
        const double t = squaredDistance(x, mSoup->pairCorners[p]);
        sum += mWeights[p] * (t / (t + mDelta));
    }
    return 0.5 * mFactor * sum;
}

void SeparationTerm::addDerivatives(std::span<const double> x, std::span<double> gradient,
                                    HessianBlocks &blocks) const
{
    for (std::size_t p = 0; p < mWeights.size(); ++p) {
        const std::size_t a = 2 * static_cast<std::size_t>(mSoup->pairCorners[p][0]);
        const std::size_t b = 2 * static_cast<std::size_t>(mSoup->pairCorners[p][1]);
        const double du = x[a] - x[b];
        const double dv = x[a + 1] - x[b + 1];
        const double sum = du * du + dv * dv + mDelta;
        const double w = mFactor * mWeights[p] * mDelta / (sum * sum);
        gradient[a] += w * du;
        gradient[a + 1] += w * dv;
        gradient[b] -= w * du;
        gradient[b + 1] -= w * dv;
        blocks.pair[p] += w;
        blocks.pairClosed[p] = w > 0 && sum - mDelta < closedSeparation * sum;
    }
}

double SeparationTerm::separation(std::span<const double> x, int pair) const
{
    const double t = squaredDistance(x, mSoup->pairCorners[pair]);
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
        if (!snapshot.pairWeight.empty())
            w *= snapshot.pairWeight[p];
        if (!snapshot.pairState.empty()) {
            if (snapshot.pairState[p] == PairState::Cut)
                w = 0;
            else if (snapshot.pairState[p] == PairState::Joined)
                w *= joinedWeight;
        }
        weights[p] = w;
    }
    return weights;
}

} // namespace autocuts
