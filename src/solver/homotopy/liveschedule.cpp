#include "solver/homotopy/liveschedule.h"

#include "solver/homotopy/anneal.h"

namespace autocuts::homotopy {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Found on the first meshes (docs/constants.md). With 15 exact steps per level and lambda 0.05, reheating to
//! 0.01 shortened the seams of the mesh "cow" from 11.7 to 6.9. 40 to 60 fast steps per level kept improving
//! the result.
constexpr double firstLambda = 0.05;
constexpr double reheatDelta = 0.01;
constexpr int stepsPerLevel = 40;
//! A round is good enough when it uses this share of the distortion above 4 that the bound allows.
constexpr double usedEnough = 0.85;
//! Least and most rounds of the search for lambda.
constexpr int fewestRounds = 2;
constexpr int mostRounds = 8;
//! How many rounds may follow when the best one does not keep the bound again (eight rounds alone left the
//! sample "bumpy cube" at 4.17 for a bound of 4.1), and the factor on lambda in each.
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
    mLevel = levels().size() - 1; // keeps the last delta
    return false;
}

//! Chooses lambda for the next round.
//! \returns false when the round that ended with this distortion was the last
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
