#include "solver/search/seamrun.h"

#include "solver/base/constant.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

// Mu is the energy that one unit of seam cost is worth. On the first meshes (docs/constants.md) its value at
// a bound of 4.1 ended between 0.05 and 0.25. Numbers in this file without another source were chosen by
// hand.

AUTOCUTS_CONSTANT(double, firstMu, 0.1);
AUTOCUTS_CONSTANT(double, smallestMu, 0.005);
constexpr double largestMu = 1;
//! Typical mu near the bound, to compare maps at different distortion: usualMu converts energy below the
//! bound into seam cost, excessMu energy above it.
AUTOCUTS_CONSTANT(double, usualMu, 0.15);
AUTOCUTS_CONSTANT(double, excessMu, 0.07);
//! Stretch allowed, above 4, that these are for. With less, seams take less stretch away: on a map of suzanne
//! one unit of seam cost takes .017 near 4.08 and .005 near 4.02.
constexpr double usualRoom = 0.1;
constexpr double leastMu = 1e-5;
AUTOCUTS_CONSTANT(int, adaptingInterval, 20);    // large moves after which mu is adapted
constexpr int boundRounds = 50;                  // in which mu falls until the bound holds, at most
AUTOCUTS_CONSTANT(int, squeezeMoves, 20);        // large moves per squeeze
AUTOCUTS_CONSTANT(double, startTolerance, 1e-2); // energy gained in ten steps below which the relaxation ends
AUTOCUTS_CONSTANT(int, firstPolishes, 4);
//! While a polish lowers the energy above the bound by more than this share, mu stays. Without this rule,
//! round shapes that start from one path ended with 5 to 10 % longer seams.
AUTOCUTS_CONSTANT(double, fastFall, 0.25);
//! Share of the stretch above the bound that a round must take away once mu cannot fall any more.
AUTOCUTS_CONSTANT(double, slowFall, 0.05);
//! Seam cost that a fault at the anchors counts as: far more than the seams of any map.
constexpr double anchorFaultCost = 1000;
//! From this multiple of the stretch allowed on, clusters are given up: on noisy shapes with three times as
//! much the bound was never met, in half of the time of a draft.
AUTOCUTS_CONSTANT(double, hopeless, 2);
//! Share of (bound - 4) that is kept free in maps of several charts, because giving the charts one texel
//! density afterwards costs some distortion.
AUTOCUTS_CONSTANT(double, densityReserve, 0.01);

} // namespace

SeamRun::SeamRun(const OptimizeOptions &options, CutState state, std::uint64_t seed)
    : mOptions(options), mState(std::move(state)),
      mSearch(mState, seed, {options.mu.value_or(firstMu), !options.allowOverlaps, options.job}),
      mBest(mState), mBalance(firstMu)
{
    mBestScore = score();
}

double SeamRun::score() const
{
    if (mOptions.mu)
        return mState.objective(*mOptions.mu) + anchorFaultCost * mState.anchorFaults();
    return mState.cost + std::max(0.0, mState.distortion - bound()) / (excessMu * tightness()) +
           steeringCost();
}

double SeamRun::expectedCost() const
{
    if (mOptions.mu)
        return score();
    const double over = mState.distortion - bound();
    return mState.cost + over / ((over > 0 ? excessMu : usualMu) * tightness()) + steeringCost();
}

//! What a typical mu is multiplied by where little stretch is allowed.
double SeamRun::tightness() const
{
    return std::min(1.0, (mOptions.maxDistortion - 4) / usualRoom);
}

bool SeamRun::fits(const CutState &state) const
{
    return mOptions.mu || state.distortion <= bound();
}

void SeamRun::relax()
{
    // What lies on its pins already must not be pulled off them.
    if (mState.anchored)
        mSearch.anchor();
    tell(mState);
    for (int i = 0; i < firstRelaxation / 10; ++i) {
        // The first steps turn a badly distorted map into a usable one.
        const double gained =
            mSearch.relaxAll(10, i == 0 ? SeamTrial::MapSink([this](const CutState &map) { tell(map); })
                                        : SeamTrial::MapSink());
        mBest = mState;
        tell(mBest);
        if (gained < startTolerance || mSearch.stopped())
            break;
    }
}

void SeamRun::start()
{
    mSearch.anchor();
    const bool hadMany = hasManySmallCharts();
    if (!hadMany)
        mSearch.absorbSmallCharts();
    if (mOptions.clusters || hadMany)
        mSearch.joinCharts();
    if (hadMany && !hasManySmallCharts())
        mSearch.absorbSmallCharts();
    mBest = mState;
    mBestScore = score();
    for (int i = 0; i < firstPolishes && !mSearch.stopped(); ++i) {
        const double before = mState.distortion;
        mSearch.polish(1);
        mSearch.relaxAll(3);
        // Lowering mu while the energy still falls fast would open needless seams.
        if (before - mState.distortion < fastFall * (mState.distortion - bound()) ||
            mState.distortion < bound())
            adaptMu(0.4);
        report(0);
    }
    mSearch.cutNecks();
    keepBest();
    report(0);
}

void SeamRun::search(int moves, double heat)
{
    mSearch.setHeat(heat, moves);
    for (int i = 0; i < moves && !mSearch.stopped(); ++i) {
        mSearch.tryLargeMove(std::min(moves - 1 - i, adaptingInterval - 1 - i % adaptingInterval));
        report(1);
        if (i % adaptingInterval == adaptingInterval - 1) {
            adaptMu(0.2);
            if (i % (5 * adaptingInterval) == 5 * adaptingInterval - 1) {
                mSearch.relaxAll(2);
                mSearch.polish(1);
                mSearch.cutNecks();
                mSearch.updateEnergy();
            }
            keepBest();
        }
    }
    mSearch.anchor();
    keepBest();
}

void SeamRun::takeToBound(double mostCost)
{
    if (mOptions.mu || mSearch.stopped()) {
        restoreBest();
        return;
    }
    if (!hasManySmallCharts())
        mSearch.absorbSmallCharts();
    if (!mOptions.clusters || mState.distortion - 4 < hopeless * (bound() - 4))
        meetBound(mostCost);
    mSearch.anchor();
    keepBest();
    restoreBest();
    mSearch.relaxAll(mOptions.effort.lastSteps);
    if (mState.distortion > bound())
        return;
    mSearch.cutNecks();
    // Spend what is left of the bound: rising mu removes the seams that raise the energy least per length.
    mSearch.setCeiling(bound());
    mSearch.setHeat(0);
    for (int i = 0; i < mOptions.effort.squeezes && !mSearch.stopped(); ++i) {
        mSearch.setMu(mSearch.mu() * std::pow(4.0, 1.0 / mOptions.effort.squeezes));
        mSearch.polish(1);
        for (int k = 0; k < squeezeMoves; ++k)
            mSearch.tryLargeMove(squeezeMoves - 1 - k);
        if (mSearch.relaxAll(2) > 0)
            keepBest();
        report(0);
    }
    keepBest();
    restoreBest();
}

//! Lowers mu step by step until the bound holds.
void SeamRun::meetBound(double mostCost)
{
    double mu = mSearch.mu();
    mSearch.setHeat(0);
    for (int i = 0; i < boundRounds && mState.distortion > bound() && !mSearch.stopped(); ++i) {
        if (mState.cost > mostCost)
            return;
        const bool isLeast = mu == leastMu;
        const double before = mState.distortion;
        mu = std::max(leastMu, mu * mOptions.effort.boundFall);
        mSearch.setMu(mu);
        mSearch.polish(1);
        for (int k = 0; k < mOptions.effort.boundMoves && mState.distortion > bound(); ++k)
            mSearch.tryLargeMove(mOptions.effort.boundMoves - 1 - k);
        mSearch.relaxAll(mOptions.effort.boundSteps);
        report(0);
        if (isLeast && before - mState.distortion < slowFall * (mState.distortion - bound()))
            return;
    }
}

void SeamRun::report(int steps) const
{
    if (mOptions.progress)
        mOptions.progress(steps);
}

//! What pins cost, in seam cost.
double SeamRun::steeringCost() const
{
    return (mState.energy - mState.distortion) / usualMu + anchorFaultCost * mState.anchorFaults();
}

//! Bound on the energy less a small reserve.
double SeamRun::bound() const
{
    const double reserve = mState.chartCount() > 1 ? densityReserve : 1e-4;
    return mOptions.maxDistortion - reserve * (mOptions.maxDistortion - 4);
}

//! Adapts mu to the distance from the bound: mu falls at once when the energy is above the bound and rises
//! when it is below, while the balance that it is derived from follows slowly.
//! \param power how fast the balance follows
void SeamRun::adaptMu(double power)
{
    if (mOptions.mu)
        return;
    const double room = mOptions.maxDistortion - 4;
    const double over = (mState.distortion - bound()) / room;
    mBalance *= std::exp(-power * std::clamp(over, -0.5, 0.5));
    mBalance = std::clamp(mBalance, smallestMu, largestMu);
    mSearch.setMu(mBalance / (1 + std::clamp(2 * over, -0.6, 5.0)));
}

void SeamRun::keepBest()
{
    const double now = score();
    const int nowFaults = mState.anchorFaults(), bestFaults = mBest.anchorFaults();
    const bool nowFits = fits(mState), bestFits = fits(mBest);
    if (nowFaults != bestFaults ? nowFaults < bestFaults : nowFits != bestFits ? nowFits : now < mBestScore) {
        mBest = mState;
        mBestScore = now;
        tell(mBest);
    }
}

void SeamRun::tell(const CutState &map) const
{
    if (mOptions.improved && (map.anchored || map.graph->anchors.empty()))
        mOptions.improved(map);
}

} // namespace autocuts::search
