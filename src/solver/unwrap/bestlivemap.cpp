#include "solver/unwrap/bestlivemap.h"

#include "solver/base/timelimit.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/rigidsettling.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/candidates.h"
#include "solver/unwrap/rectanglefit.h"

#include <algorithm>

namespace autocuts::unwrap {

namespace {

using Clock = std::chrono::steady_clock;

// Chosen by hand.
constexpr double givingShare = 0.2; // of the time that giving out maps may take
constexpr auto timeAfterPause = std::chrono::milliseconds(100);
constexpr auto leastPause = std::chrono::milliseconds(100); // between two maps given out

} // namespace

void BestLiveMap::reset()
{
    mPlacing.reset();
    mBest.reset();
    mStanding.reset();
    mGiven = nullptr;
    forgetWaiting();
}

void BestLiveMap::forgetWaiting()
{
    mWaiting.reset();
    mUnfitted.reset();
    mNextGiven = {};
}

BestLiveMap::Merit BestLiveMap::makeMerit(int anchorFaults, double distortion, double cost) const
{
    Merit merit{.anchorFaults = anchorFaults, .misses = distortion > mOptions.maxDistortion};
    merit.value = merit.misses ? distortion : cost;
    return merit;
}

BestLiveMap::Merit BestLiveMap::meritOf(const search::CutState &state) const
{
    const Snapshot &problem = mProblem.problem();
    const bool mayKeepShape = problem.rigid && state.distortion > mOptions.maxDistortion;
    const double distortion =
        mayKeepShape ? boundedDistortion(*mProblem.soup(), problem, state.map()) : state.distortion;
    return makeMerit(state.anchorFaults(), distortion, state.cost);
}

void BestLiveMap::offer(const search::CutState &state)
{
    const std::lock_guard lock(mMutex);
    const Merit merit = meritOf(state);
    if ((mWaiting && !(merit < meritOf(*mWaiting))) || (mBest && !(merit < mBestMerit)))
        return;
    mWaiting = state;
}

void BestLiveMap::setBest(const search::CutState &state)
{
    const std::lock_guard lock(mMutex);
    mBest = state;
    mBestMerit = meritOf(state);
}

void BestLiveMap::giveAgain(std::shared_ptr<const LiveMapResult> map)
{
    const std::lock_guard lock(mMutex);
    mGiven = map;
    mSink(std::move(map));
}

void BestLiveMap::giveWaiting(const JobContext &job, bool atOnce)
{
    std::unique_lock lock(mMutex, std::defer_lock);
    if (atOnce)
        lock.lock();
    else if (!lock.try_lock())
        return; // another thread does it
    if ((!mWaiting && !mUnfitted) || (!atOnce && Clock::now() < mNextGiven))
        return;
    const Clock::time_point begun = Clock::now();
    search::CutState state = std::move(mWaiting ? *mWaiting : *mUnfitted);
    mWaiting.reset();
    mUnfitted.reset();
    give(std::move(state), FitEffort::Full, job);
    const Clock::time_point done = Clock::now();
    mNextGiven = done + std::max<Clock::duration>(leastPause, std::chrono::duration_cast<Clock::duration>(
                                                                  (done - begun) / givingShare));
}

void BestLiveMap::giveQuickly(const JobContext &job)
{
    const std::lock_guard lock(mMutex);
    if (mWaiting)
        give(*std::exchange(mWaiting, std::nullopt), FitEffort::Quick, job);
}

void BestLiveMap::giveStraight(const JobContext &job)
{
    const std::lock_guard lock(mMutex);
    if (mBest && (mProblem.plan().deforms() || mProblem.problem().rigid) && !job.stopped())
        give(*mBest, FitEffort::Full, job, straight::StraightEffort::Full);
}

//! The map of a state, with rigid regions that keep their shape.
SeamedMap BestLiveMap::settled(const search::CutState &state, const JobContext &job) const
{
    search::OptimizeOptions search;
    search.maxDistortion = mOptions.maxDistortion;
    search.effort.squeezes = 0; // the searches that go on do that
    search.job = job.quiet();
    return definite::settleRigidRegions(mProblem.graph(), mProblem.problem(), search, state.map());
}

bool BestLiveMap::hasAlikeParts(const JobContext &job)
{
    const std::lock_guard lock(mMutex);
    return alikeParts(job).has_value();
}

const std::optional<AlikeParts> &BestLiveMap::alikeParts(const JobContext &job)
{
    if (!mAlikeIsKnown && !mProblem.isSymmetric()) {
        Snapshot parts = mProblem.part().withoutRectangles();
        // Copies of a map that a solve starts from are looked for as well.
        parts.settings.start = SolveSettings().start;
        mAlike = AlikeParts::of(parts, job);
        mAlikeIsKnown = !job.stopped();
    }
    return mAlike;
}

//! The map in which parts that are copies have the same islands.
SeamedMap BestLiveMap::alike(SeamedMap map, const JobContext &job)
{
    if (mProblem.isSymmetric())
        return map;
    const std::optional<AlikeParts> &parts = alikeParts(job);
    return parts ? parts->unified(map, mProblem.problem(), definite::usualMu, mOptions.maxDistortion, job)
                 : map;
}

//! The map of a state as it is given out. Nothing when a pause leaves no time for that, and there is a map
//! that obeys already.
std::optional<SeamedMap> BestLiveMap::settledAlike(const search::CutState &state, const JobContext &job)
{
    std::optional<TimeLimit> limit;
    if (job.stopped())
        limit.emplace(job.unstoppable(), timeAfterPause);
    const JobContext own = limit ? limit->context() : job;
    SeamedMap map = alike(settled(state, own), own);
    if (own.stopped() && mGiven && mGiven->token == mToken)
        return std::nullopt;
    return map;
}

//! True when the document's map, if it may stay, is worse than this one.
bool BestLiveMap::isBeaten(const SeamedMap &map) const
{
    if (!mStanding || beats(map, *mProblem.soup(), mProblem.problem(), mStanding->worth,
                            mProblem.part().boundOf(mOptions.maxDistortion, mStanding->worth.bounded)))
        return true;
    const FreePart &part = mProblem.part();
    const UvMatrix uv = part.wholeUv(mProblem.problem().uvScale * cornerUv(*mProblem.soup(), map));
    return Wishes::of(mProblem.whole(), uv).isBetterThan(mStanding->wishes);
}

//! Gives the map out, unless it is not better or overlaps itself after all.
void BestLiveMap::give(search::CutState state, FitEffort effort, const JobContext &job,
                       straight::StraightEffort straightness)
{
    const FreePart &part = mProblem.part();
    const Snapshot &whole = mProblem.whole();
    const Soup &soup = *mProblem.soup();
    // Where it does not meet the faces around the scope, it cannot be attached to them.
    if (part.isAttached() && state.anchorFaults() > state.chartsMayMeet)
        return;
    Merit merit = meritOf(state);
    std::optional<SeamedMap> made = merit.misses ? state.map() : settledAlike(state, job);
    if (!made) {
        mWaiting = std::move(state);
        return;
    }
    SeamedMap map = std::move(*made);
    definite::equalizeDensity(soup, mProblem.problem(), map);
    merit.misses = boundedDistortion(soup, mProblem.problem(), map) > mOptions.maxDistortion;
    if (mBest && merit.misses && !mBestMerit.misses)
        return;
    straight::straighten(mProblem.soup(), mProblem.problem(), mProblem.plan(), mOptions.maxDistortion, map,
                         job.quiet(), straightness);
    if (job.stopped() && straightness == straight::StraightEffort::Full)
        return;
    if (mStanding && !mStanding->inPlace) { // its shapes stay, not their places
        if (isBeaten(map))
            mStanding.reset();
        else
            map = mStanding->worth.map;
    }
    const bool deformed = fitToRectangles(part, mProblem.soup(), map, job, effort);
    if (deformed && job.stopped()) {
        mUnfitted = std::move(state);
        return;
    }
    if (definite::coversItself(soup, map))
        return;
    auto result = std::make_shared<LiveMapResult>();
    const bool stands = mStanding && mStanding->inPlace;
    bool placed = !stands || isBeaten(map);
    if (placed) {
        const LivePlacing before = mPlacing;
        result->uv = mPlacing.place(whole, part, soup, map, mOptions.packing, mPacksAfresh, mOptions.dragged,
                                    mProblem.plan().rotation(PackRotation::Free));
        // Shorter seams are not worth a lower texel density.
        const bool obeyedBefore = stands || (mBest && mBestMerit.obeysAs(merit));
        if (mPlacing.shrank() && obeyedBefore) {
            mPlacing = before;
            if (!stands)
                return;
            placed = false;
            const Candidate &worth = mStanding->worth;
            merit = makeMerit(worth.anchorFaults, worth.bounded, worth.seamCost); // a better one may fit
        }
    }
    if (placed && stands)
        mStanding.reset();
    if (!placed) {
        map = mStanding->worth.map;
        result->uv = *whole.uv;
    }
    result->token = mToken;
    result->hardShare = mProblem.hardShare();
    result->cut = part.wholeCut(map.cut);
    result->hasRoom = !placed || mPlacing.hadRoom();
    result->mirroredArea = mProblem.mirroredArea();
    result->unmet = unmetSteering(whole, result->uv);
    const metrics::UvMetrics all = metrics::measureShapes(*whole.mesh, result->uv, whole.tileHeight);
    result->seamLength = all.seamNorm;
    result->islands = all.charts;
    result->distortion = all.tileDirichlet;
    result->withinBound =
        map.distortion(soup) <= mOptions.maxDistortion || all.tileDirichlet <= mMaxDistortion;
    if (deformed && effort == FitEffort::Quick)
        mUnfitted = state;
    mBest = std::move(state);
    mBestMerit = merit;
    mGiven = result;
    mSink(std::move(result));
}

} // namespace autocuts::unwrap
