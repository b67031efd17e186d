#include "solver/liveschedule.h"

#include "solver/anneal.h"

namespace autocuts {

namespace {

constexpr double firstLambda = 0.05;
constexpr double reheatDelta = 0.01;
constexpr int stepsPerLevel = 40;
//! The bound is met when at least this part of what it allows is used.
constexpr double usedEnough = 0.85;
constexpr int fewestRounds = 2;
constexpr int mostRounds = 8;

} // namespace

LiveSchedule::LiveSchedule(const Soup &soup, double maxDistortion)
    : mBudget(maxDistortion, firstLambda), mBound(maxDistortion), mLevels(deltaLevels(soup, 1)),
      mReheatLevels(deltaLevels(soup, reheatDelta))
{}

void LiveSchedule::apply(SolveSettings &settings) const
{
    settings.lambda = mBudget.lambda();
    settings.delta = levels()[mLevel];
}

void LiveSchedule::reheat()
{
    mRound = 1;
    mLevel = 0;
    mStep = 0;
}

bool LiveSchedule::report(const StepResult &step)
{
    const bool levelDone = ++mStep >= stepsPerLevel || hasStalled(mStep > 1 ? mEnergy : 0, step);
    mEnergy = step.energy;
    if (!levelDone)
        return true;
    mStep = 0;
    if (++mLevel < levels().size())
        return true;
    const bool met = step.distortion <= mBound && step.distortion - 4 >= usedEnough * (mBound - 4);
    mBudget.report(step.distortion);
    ++mRound;
    if (mRound >= mostRounds || (met && mRound >= fewestRounds)) {
        mLevel = levels().size() - 1; // stays cold
        return false;
    }
    mLevel = 0;
    return true;
}

} // namespace autocuts
