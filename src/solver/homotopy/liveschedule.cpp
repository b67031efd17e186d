#include "solver/homotopy/liveschedule.h"

#include "solver/homotopy/anneal.h"

namespace autocuts::homotopy {

namespace {

constexpr double firstLambda = 0.05;
constexpr double reheatDelta = 0.01;
constexpr int stepsPerLevel = 40;
//! The bound is met when at least this part of what it allows is used.
constexpr double usedEnough = 0.85;
constexpr int fewestRounds = 2;
constexpr int mostRounds = 8;
//! Rounds that may follow when the last of those did not keep the bound, and what lambda is multiplied by.
constexpr int mostRetries = 12;
constexpr double retryFactor = 0.6;

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

void LiveSchedule::resume(double lambda, double delta)
{
    mBudget = DistortionBudget(mBound, lambda);
    mRound = mStep = 0;
    mKeptLambda = mKeptDistortion = 0;
    mLevel = 0;
    while (mLevel + 1 < mLevels.size() && mLevels[mLevel] > delta)
        ++mLevel;
}

void LiveSchedule::reheat()
{
    mRound = 1;
    mKeptLambda = mKeptDistortion = 0;
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
    ++mRound;
    if (chooseLambda(step.distortion)) {
        mLevel = 0;
        return true;
    }
    mLevel = levels().size() - 1; // stays cold
    return false;
}

//! For the next round. \returns false when the one that ended with this distortion was the last
bool LiveSchedule::chooseLambda(double distortion)
{
    const double lambda = mBudget.lambda();
    const bool kept = distortion <= mBound;
    if (kept && distortion > mKeptDistortion) {
        mKeptLambda = lambda;
        mKeptDistortion = distortion;
    }
    mBudget.report(distortion);
    if (mRound < mostRounds)
        return mRound < fewestRounds || !kept || distortion - 4 < usedEnough * (mBound - 4);
    if (mRound == mostRounds + mostRetries || (kept && (mRound > mostRounds || lambda == mKeptLambda)))
        return false;
    const bool bestAgain = mRound == mostRounds && mKeptLambda > 0;
    mBudget = DistortionBudget(mBound, bestAgain ? mKeptLambda : retryFactor * lambda);
    return true;
}

bool runToTheEnd(Solver &solver, double maxDistortion, const JobContext &job,
                 const std::function<void()> &onStep)
{
    Snapshot snapshot = solver.snapshot();
    LiveSchedule schedule(solver.soup(), maxDistortion);
    schedule.resume(snapshot.settings.lambda, snapshot.settings.delta);
    do {
        if (job.stopped())
            return false;
        SolveSettings settings = snapshot.settings;
        schedule.apply(settings);
        if (settings != snapshot.settings) {
            snapshot.settings = settings;
            solver.update(snapshot);
        }
        if (onStep)
            onStep();
    } while (schedule.report(solver.step()));
    return true;
}

} // namespace autocuts::homotopy
