#include "solver/homotopy/budget.h"

#include <algorithm>
#include <cmath>

namespace autocuts::homotopy {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Symmetric Dirichlet energy of an isometry.
constexpr double isometric = 4;
//! Share of the allowed distortion above 4 that is aimed at. The results of runs scatter; aiming a little low
//! makes most of them end below the bound.
constexpr double aim = 0.97;
//! Range of lambda, and the largest factor by which one report changes it.
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
    double power = 0.9; // exponent of the distortion above 4 as a power of lambda: about 0.9 on many meshes
    if (mLastLambda > 0 && mLastLambda != mLambda) {
        const double seen = std::log(excess / mLastExcess) / std::log(mLambda / mLastLambda);
        if (std::isfinite(seen))
            // Two runs that are close together may give any exponent.
            power = std::clamp(seen, 0.5, 2.0);
    }
    mLastLambda = mLambda;
    mLastExcess = excess;
    const double change = std::pow(mTarget / excess, 1 / power);
    mLambda = std::clamp(mLambda * std::clamp(change, 1 / largestChange, largestChange), smallestLambda,
                         largestLambda);
}

} // namespace autocuts::homotopy
