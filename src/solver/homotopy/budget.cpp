#include "solver/homotopy/budget.h"

#include <algorithm>
#include <cmath>

namespace autocuts::homotopy {

namespace {

constexpr double isometric = 4;
//! Runs scatter: aiming a little low makes most of them end below the bound.
constexpr double aim = 0.97;
constexpr double smallestLambda = 1e-6;
constexpr double largestLambda = 0.5;
constexpr double largestChange = 4;

} // namespace

DistortionBudget::DistortionBudget(double bound, double firstLambda)
    : mTarget(aim * std::max(bound - isometric, 1e-6)), mLambda(firstLambda)
{}

void DistortionBudget::report(double distortion)
{
    const double excess = std::max(distortion - isometric, 1e-9);
    double power = 0.9; // of the excess in lambda, as seen on many meshes
    if (mLastLambda > 0 && mLastLambda != mLambda) {
        const double seen = std::log(excess / mLastExcess) / std::log(mLambda / mLastLambda);
        if (std::isfinite(seen))
            power = std::clamp(seen, 0.5, 2.0);
    }
    mLastLambda = mLambda;
    mLastExcess = excess;
    const double change = std::pow(mTarget / excess, 1 / power);
    mLambda = std::clamp(mLambda * std::clamp(change, 1 / largestChange, largestChange), smallestLambda,
                         largestLambda);
}

} // namespace autocuts::homotopy
