#include "solver/newton/minimizer.h"

#include "solver/base/linesearch.h"
#include "solver/energy/distortion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::newton {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Shortest and longest step of the line search.
constexpr int maxHalvings = 30;
constexpr double longestStep = 64;
//! A longer step is tried when the parabola through the first one has its minimum beyond this multiple of it.
//! By that parabola doubling pays from 1.5 on; 1.4 leaves a margin.
constexpr double promisingMinimum = 1.4;

} // namespace

Minimizer::Minimizer(std::shared_ptr<const Soup> soup, std::unique_ptr<NewtonDirection> direction,
                     ThreadTeam *team)
    : mSoup(std::move(soup)), mTeam(team), mDirection(std::move(direction))
{}

void Minimizer::setTerms(std::vector<const energy::EnergyTerm *> terms)
{
    mTerms = std::move(terms);
    mBlocks.pair.clear();
    mBlocks.pairClosed.clear();
    invalidate();
}

void Minimizer::invalidate()
{
    mDirection->invalidate();
}

double Minimizer::energy(std::span<const double> x) const
{
    double sum = 0;
    for (const energy::EnergyTerm *term : mTerms)
        sum += term->value(x);
    return sum;
}

double Minimizer::tryStep(const std::vector<double> &x, double length)
{
    mTrial.resize(x.size());
    runOn(mTeam, jobCount(mSoup->triangleCount()), [&](int job) {
        const std::size_t begin = 6 * static_cast<std::size_t>(job) * jobSize;
        const std::size_t end = std::min(x.size(), begin + 6 * static_cast<std::size_t>(jobSize));
        for (std::size_t i = begin; i < end; ++i)
            mTrial[i] = x[i] + length * mMove[i];
    });
    double sum = 0;
    mValues.clear();
    for (const energy::EnergyTerm *term : mTerms) {
        mValues.push_back(term->value(mTrial));
        sum += mValues.back();
        if (!std::isfinite(sum))
            break;
    }
    return sum;
}

Minimizer::Step Minimizer::step(std::vector<double> &x)
{
    Step result;
    mBlocks.resize(mSoup->triangleCount(), static_cast<int>(mSoup->pairCorners.size()),
                   mDirection->precision());
    mGradient.resize(x.size());
    runOn(mTeam, jobCount(static_cast<int>(x.size())), [&](int job) {
        const std::size_t begin = static_cast<std::size_t>(job) * jobSize;
        std::fill(mGradient.begin() + begin, mGradient.begin() + std::min(x.size(), begin + jobSize), 0.0);
    });
    for (const energy::EnergyTerm *term : mTerms) {
        result.values.push_back(term->addDerivatives(x, mGradient, mBlocks));
        result.before += result.values.back();
    }
    result.after = result.before;
    mMove.resize(x.size());
    mDirection->compute(mBlocks, mGradient, mMove);

    const double slope = sumInOrder(mTeam, mSoup->triangleCount(), [&](int first, int end) {
        double sum = 0;
        for (std::size_t i = 6 * static_cast<std::size_t>(first); i < 6 * static_cast<std::size_t>(end); ++i)
            sum += mGradient[i] * mMove[i];
        return sum;
    });
    if (!(slope < 0))
        return result;
    const double bound =
        flipMargin * energy::maxFlipFreeStep(*mSoup, x, mMove, longestStep / flipMargin, mTeam);
    double length = std::min(1.0, bound);
    double value = tryStep(x, length);
    int halvings = 0;
    while (!(value <= result.before + armijo * length * slope)) {
        if (++halvings > maxHalvings)
            return result;
        length *= 0.5;
        value = tryStep(x, length);
    }
    std::vector<double> accepted;
    result.values = mValues;
    // The majorised Hessian makes steps too short: double the step while the energy falls. On the first
    // meshes (docs/constants.md) this gave fewer iterations and shorter seams.
    const double bend = 2 * (value - result.before - length * slope) / (length * length);
    const bool promising = -slope > promisingMinimum * length * bend;
    while (halvings == 0 && promising && 2 * length <= bound) {
        accepted.swap(mTrial);
        const double longer = tryStep(x, 2 * length);
        if (!(longer < value)) {
            mTrial.swap(accepted);
            break;
        }
        value = longer;
        result.values = mValues;
        length *= 2;
    }
    x.swap(mTrial);
    result.after = value;
    result.length = length;
    return result;
}

} // namespace autocuts::newton
