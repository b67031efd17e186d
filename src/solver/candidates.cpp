#include "solver/candidates.h"

#include <algorithm>

namespace autocuts {

bool Ranking::better(const Candidate &a, const Candidate &b) const
{
    if (mOptions.lambda) {
        const double mu = *mOptions.lambda / std::max(1 - *mOptions.lambda, 1e-9);
        return a.distortion + mu * a.seamLength < b.distortion + mu * b.seamLength;
    }
    const bool aFits = a.distortion <= mOptions.maxDistortion;
    const bool bFits = b.distortion <= mOptions.maxDistortion;
    if (aFits != bFits)
        return aFits;
    return aFits ? a.seamLength < b.seamLength : a.distortion < b.distortion;
}

void Ranking::setTotal(int steps)
{
    const std::scoped_lock lock(mMutex);
    mTotalSteps = std::max(steps, 1);
    mSteps = 0;
}

void Ranking::stepDone(int steps)
{
    if (!mReport)
        return;
    const std::scoped_lock lock(mMutex);
    mSteps += steps;
    mProgress.fraction =
        std::max(mProgress.fraction, optimizingShare * std::min(1.0, double(mSteps) / mTotalSteps));
    mReport(mProgress);
}

void Ranking::found(double distortion, double seamLength)
{
    const std::scoped_lock lock(mMutex);
    mHasAny = true;
    if (mProgress.distortion == 0 || seamLength < mProgress.seamLength) {
        mProgress.distortion = distortion;
        mProgress.seamLength = seamLength;
    }
}

void Ranking::stage(UnwrapStage stage, double fraction)
{
    if (!mReport)
        return;
    const std::scoped_lock lock(mMutex);
    mProgress.stage = stage;
    mProgress.fraction = fraction;
    mReport(mProgress);
}

} // namespace autocuts
