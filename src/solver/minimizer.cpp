#include "solver/minimizer.h"

#include "solver/energy/distortion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

constexpr double armijo = 1e-4;
//! Share of the step to the first flip that may be taken.
constexpr double flipMargin = 0.9;
constexpr int maxHalvings = 30;
constexpr double longestStep = 64;

} // namespace

Minimizer::Minimizer(std::shared_ptr<const Soup> soup, std::unique_ptr<NewtonDirection> direction)
    : mSoup(std::move(soup)), mDirection(std::move(direction))
{
}

void Minimizer::setTerms(std::vector<const EnergyTerm *> terms)
{
    mTerms = std::move(terms);
    invalidate();
}

void Minimizer::invalidate()
{
    mDirection->invalidate();
}

double Minimizer::energy(std::span<const double> x) const
{
    double sum = 0;
    for (const EnergyTerm *term : mTerms)
        sum += term->value(x);
    return sum;
}

Minimizer::Step Minimizer::step(std::vector<double> &x)
{
    Step result;
    result.before = result.after = energy(x);
    mBlocks.resize(mSoup->triangleCount(), static_cast<int>(mSoup->pairCorners.size()));
    mGradient.assign(x.size(), 0.0);
    for (const EnergyTerm *term : mTerms)
        term->addDerivatives(x, mGradient, mBlocks);
    mMove.resize(x.size());
    mDirection->compute(mBlocks, mGradient, mMove);

    double slope = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        slope += mGradient[i] * mMove[i];
    if (!(slope < 0))
        return result;
    const double bound = flipMargin * maxFlipFreeStep(*mSoup, x, mMove, longestStep / flipMargin);

    mTrial.resize(x.size());
    const auto tryStep = [&](double length) {
        for (std::size_t i = 0; i < x.size(); ++i)
            mTrial[i] = x[i] + length * mMove[i];
        return energy(mTrial);
    };
    double length = std::min(1.0, bound);
    double value = tryStep(length);
    int halvings = 0;
    while (!(value <= result.before + armijo * length * slope)) {
        if (++halvings > maxHalvings)
            return result;
        length *= 0.5;
        value = tryStep(length);
    }
    // The majorised Hessian makes steps too short: double while that pays.
    while (halvings == 0 && 2 * length <= bound) {
        const double longer = tryStep(2 * length);
        if (!(longer < value))
            break;
        value = longer;
        length *= 2;
    }
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += length * mMove[i];
    result.after = value;
    result.length = length;
    return result;
}

} // namespace autocuts
