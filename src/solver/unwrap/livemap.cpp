#include "solver/unwrap/livemap.h"

#include "solver/base/parallel.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/search/anchoring.h"
#include "solver/search/resteering.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/mapfinder.h"

#include <algorithm>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

using Clock = std::chrono::steady_clock;

// Chosen by hand; their effect has not been measured.
constexpr int movesPerRound = 120;      // large moves on each map between two squeezes
constexpr double roundHeat = 0.5;       // see SeamRun::search()
constexpr double noteworthy = 1e-3;     // share of the seam cost that a round has to gain
constexpr int idleRoundsToRest = 6;     // rounds without a noteworthy gain after which the search ends
constexpr int pulledSteps = 4;          // Newton steps on a map that is dragged
constexpr int quickSteps = 4;           // Newton steps on the first map
constexpr double quickTolerance = 1e-2; // energy gained below which the first map counts as relaxed
//! Meshes of more triangles than this get a draft by way of a coarser mesh. Twice the size of that mesh.
constexpr int sizeForCoarseDraft = 12'000;
constexpr double givingShare = 0.2;                         // of the time that giving out maps may take
constexpr auto leastPause = std::chrono::milliseconds(100); // between two maps given out

} // namespace

void LiveMap::begin(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options)
{
    mSnapshot = std::move(snapshot);
    mOptions = options;
    mToken = mSnapshot->token;
    mBack = nullptr;
    mFromMap = mSnapshot->settings.start == StartMode::ExistingUv;
    mPulled = mExplored = false;
    mPart.reset();
    mSymmetry.reset();
    mPlacing.reset();
    mBest.reset();
    mWaiting.reset();
    mGiven = nullptr;
    mSeed = 0;
    mStage = Stage::Begin;
}

void LiveMap::steer(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options, bool pulled,
                    std::shared_ptr<const LiveMapResult> back)
{
    if (!mSnapshot)
        return;
    mSnapshot = std::move(snapshot);
    mOptions = options;
    mToken = mSnapshot->token;
    mPulled = pulled;
    if (back)
        mBack = std::move(back);
    if (mStage != Stage::Begin || mBest)
        mStage = Stage::Steer;
}

bool LiveMap::work(const JobContext &job)
{
    while (mSnapshot && !job.stopped() && mStage != Stage::Done) {
        switch (mStage) {
        case Stage::Begin:
            findFirst(job);
            break;
        case Stage::Steer:
            steerMap(job);
            break;
        case Stage::Explore:
            explore(job);
            break;
        case Stage::Improve:
            improve(job);
            break;
        case Stage::Done:
            break;
        }
        publishWaiting(mStage == Stage::Done);
    }
    return !job.stopped();
}

//! Takes the snapshot's problem. A map of the same faces stays.
void LiveMap::takeSnapshot(const JobContext &job)
{
    std::optional<FreePart> part = FreePart::of(*mSnapshot, mPart ? &*mPart : nullptr);
    if (!part)
        throw std::runtime_error("nothing may change: all islands are locked, stacked or grouped");
    const bool same = mPart && part->sameFaces(*mPart);
    mPart = std::move(part);
    mProblem = mPreference.applied(mPart->snapshot(), job.threads());
    if (!same) {
        mSoup = Soup::build(mProblem.mesh);
        mGraph = nullptr;
        mBest.reset();
        mSymmetry.reset();
    }
    if (mProblem.settings.symmetry && !mSymmetry)
        mSymmetry = preference::findSymmetry(*mProblem.mesh);
    const preference::MeshSymmetry *symmetry =
        mProblem.settings.symmetry && mSymmetry ? &*mSymmetry : nullptr;
    mGraph =
        mGraph ? mGraph->steeredBy(mProblem, symmetry) : search::SeamGraph::build(mSoup, mProblem, symmetry);
    mWaiting.reset();
    mIdleRounds = 0;
    mNextGiven = {};
}

//! Makes a map of the part the one to improve, if it can be used. Overlaps are cut apart first.
//! \param uv per corner of the part, texture space
bool LiveMap::startFromMap(const UvMatrix &uv)
{
    Snapshot before = mProblem;
    before.uv = std::make_shared<const UvMatrix>(uv);
    std::optional<SeamedMap> map = mapBefore(*mSoup, before);
    if (!map)
        return false;
    if (definite::coversItself(*mSoup, *map) &&
        (!definite::removeOverlaps(*mSoup, mProblem, *map) || definite::coversItself(*mSoup, *map)))
        return false;
    search::CutState state = search::CutState::from(mGraph, *map, true);
    if (!mGraph->anchors.empty()) {
        search::placeAtAnchors(state);
        search::SeamTrial trial(state);
        search::reachPins(trial, true);
    }
    take(state);
    return mBest.has_value();
}

//! Makes a map that was found elsewhere, and lies at its anchors, the one to improve.
void LiveMap::take(const SeamedMap &map)
{
    if (!map.validate(*mSoup).empty())
        return;
    search::CutState state = search::CutState::from(mGraph, map, true);
    if (!mGraph->anchors.empty()) {
        search::SeamTrial trial(state);
        search::reachPins(trial, true);
    }
    take(state);
}

void LiveMap::take(const search::CutState &state)
{
    if (state.loopsAreInOrder() && !state.boundariesOverlap())
        offer(state);
    publishWaiting(true);
}

//! A first map: the one of the document, or few cuts.
void LiveMap::findFirst(const JobContext &job)
{
    takeSnapshot(job);
    if (mProblem.settings.seams == SeamMode::Only) {
        UnwrapOptions options;
        options.maxDistortion = mOptions.maxDistortion;
        options.quality = UnwrapQuality::Draft;
        Ranking ranking(options, job);
        FoundMap found = findMap(mProblem, options, ranking, job);
        take(found.best.map);
        mStage = Stage::Done;
        return;
    }
    if (mFromMap && mProblem.uv && startFromMap(*mProblem.uv)) {
        mExplored = true; // its seams are what the user has
        mStage = Stage::Improve;
        return;
    }
    std::optional<search::CutState> quick = makeQuickMap(job);
    if (mProblem.mesh->triangleCount() > sizeForCoarseDraft && !mSymmetry)
        carryFromCoarse(UnwrapQuality::Draft, std::move(quick), job);
    if (!job.stopped())
        mStage = Stage::Explore;
}

//! True when the mesh is so large that a coarser one is searched in its place.
bool LiveMap::exploresCoarsely() const
{
    Snapshot problem = mProblem;
    problem.settings.start = StartMode::Tutte; // there is no map that it could start from
    return suitsCoarseToFine(problem) && !mSymmetry;
}

//! Changes the map to obey the snapshot; begins anew where that is not possible.
void LiveMap::steerMap(const JobContext &job)
{
    takeSnapshot(job);
    // Coarsening does not stop at once: whoever steers a large mesh gets local searches, which do.
    mExplored = mExplored || exploresCoarsely();
    if (mProblem.settings.seams == SeamMode::Only || (!mBest && !mGiven)) {
        mStage = Stage::Begin;
        return;
    }
    if (mBack || !mBest) {
        if (mBack)
            mPlacing.returnTo(*mPart, mPart->partUv(mBack->uv));
        const std::shared_ptr<const LiveMapResult> from = mBack ? std::exchange(mBack, nullptr) : mGiven;
        mBest.reset();
        if (!startFromMap(mPart->partUv(from->uv)) && !(mProblem.uv && startFromMap(*mProblem.uv))) {
            mStage = Stage::Explore;
            return;
        }
    } else {
        std::optional<search::CutState> state = search::resteered(*mBest, mGraph, job);
        if (job.stopped())
            return;
        if (!state) {
            mBest.reset();
            mStage = Stage::Explore;
            return;
        }
        if (mPulled) {
            search::SeamTrial trial(*state);
            trial.relaxAll(pulledSteps, true);
        }
        // The snapshot has other costs: whatever obeys it is better than the old map.
        mBest.reset();
        offer(*state);
        publishWaiting(true);
    }
    if (!mBest)
        mStage = Stage::Explore;
    else
        mStage = mPulled ? Stage::Done : mExplored ? Stage::Improve : Stage::Explore;
}

//! Few cuts, hardly relaxed.
std::optional<search::CutState> LiveMap::makeQuickMap(const JobContext &job)
{
    search::OptimizeOptions options = searchOptions(job);
    options.effort.seeds = 1;
    std::optional<search::CutState> state = search::firstMap(mGraph, options, 0);
    if (!state)
        return std::nullopt;
    search::SeamTrial trial(*state);
    trial.relaxAll(quickSteps, true, job);
    if (!mGraph->anchors.empty()) {
        search::placeAtAnchors(*state);
        trial.reset();
        search::reachPins(trial, true);
    }
    offer(*state);
    publishWaiting(true);
    return state;
}

//! The map of a coarser mesh, carried over. Meanwhile the quick map is relaxed.
void LiveMap::carryFromCoarse(UnwrapQuality quality, std::optional<search::CutState> quick,
                              const JobContext &job)
{
    UnwrapOptions options;
    options.maxDistortion = mOptions.maxDistortion;
    options.quality = quality;
    std::atomic<bool> carriedOver = false;
    parallelFor(quick ? 2 : 1, job.threads(), [&](int i) {
        if (i == 0) {
            const std::optional<CarriedMap> carried = mapByCoarse(
                mSoup, mPart->snapshot(), options,
                [&](const Snapshot &coarse, const UnwrapOptions &coarseOptions) {
                    Ranking ranking(coarseOptions, job);
                    FoundMap found = findMap(coarse, coarseOptions, ranking, job);
                    return CarriedMap{std::move(found.best.map), found.iterations, 0, 0,
                                      found.best.anchorFaults};
                },
                job.quiet());
            if (carried)
                take(carried->map);
            carriedOver = true;
        } else {
            search::SeamTrial trial(*quick);
            while (!carriedOver && !job.stopped() && trial.relaxAll(quickSteps, true, job) > quickTolerance) {
                offer(*quick);
                publishWaiting();
            }
        }
    });
}

//! Searches from many first cuts, as an unwrap does; for a large mesh on a coarser one.
void LiveMap::explore(const JobContext &job)
{
    if (exploresCoarsely()) {
        carryFromCoarse(UnwrapQuality::Standard, std::nullopt, job);
        if (job.stopped())
            return;
        if (mBest) {
            mExplored = true;
            mStage = Stage::Improve;
            return;
        }
    }
    for (const UnwrapQuality quality : {UnwrapQuality::Draft, UnwrapQuality::Standard}) {
        search::OptimizeOptions options = searchOptions(job);
        if (quality == UnwrapQuality::Draft && mBest && !mBestMerit.misses)
            continue;
        options.effort = effortFor(quality, mProblem.mesh->triangleCount());
        if (mBest)
            options.given.push_back(mBest->map());
        if (quality == UnwrapQuality::Draft && mBest)
            options.effort.seeds = 0; // the quick map has the first cuts of a draft
        const std::optional<search::OptimizedMap> found = search::optimizeSeams(mGraph, options);
        if (job.stopped())
            return;
        if (found)
            take(found->map);
    }
    if (!mBest) { // the search alone finds no map
        UnwrapOptions unwrap;
        unwrap.maxDistortion = mOptions.maxDistortion;
        unwrap.quality = UnwrapQuality::Draft;
        Ranking ranking(unwrap, job);
        FoundMap other = findMap(mProblem, unwrap, ranking, job);
        if (!job.stopped())
            take(other.best.map);
    }
    mExplored = true;
    mStage = mBest ? Stage::Improve : Stage::Done;
}

//! One round: several searches on the map, side by side.
void LiveMap::improve(const JobContext &job)
{
    const search::OptimizeOptions options = searchOptions(job);
    const double before = mBest->cost;
    const bool missed = mBestMerit.misses;
    const int count = job.threads();
    const search::CutState start = *mBest;
    parallelFor(count, count, [&](int i) {
        search::SeamRun run(options, start, options.seed * 1000 + i);
        // A map above the bound first has to meet it.
        if (!missed)
            run.search(movesPerRound, roundHeat);
        run.takeToBound();
    });
    if (job.stopped())
        return;
    publishWaiting(true);
    const bool gained = mBestMerit.misses != missed || mBest->cost < (1 - noteworthy) * before;
    mIdleRounds = gained ? 0 : mIdleRounds + 1;
    if (mIdleRounds >= idleRoundsToRest)
        mStage = Stage::Done;
}

search::OptimizeOptions LiveMap::searchOptions(const JobContext &job)
{
    search::OptimizeOptions options;
    options.maxDistortion = mOptions.maxDistortion;
    options.seed = mProblem.settings.seed + mSeed++;
    options.job = job.quiet();
    options.improved = [this](const search::CutState &state) { offer(state); };
    options.progress = [this](int, double, double) { publishWaiting(); };
    return options;
}

LiveMap::Merit LiveMap::meritOf(const search::CutState &state) const
{
    Merit merit;
    merit.anchorFaults = state.anchorFaults();
    merit.misses = state.distortion > mOptions.maxDistortion;
    merit.value = merit.misses ? state.distortion : state.cost;
    return merit;
}

void LiveMap::offer(const search::CutState &state)
{
    const std::lock_guard lock(mMutex);
    const Merit merit = meritOf(state);
    if ((mWaiting && !(merit < meritOf(*mWaiting))) || (mBest && !(merit < mBestMerit)))
        return;
    mWaiting = state;
}

//! Gives out the best map that waits. \param atOnce even if the last one was given out a moment ago
void LiveMap::publishWaiting(bool atOnce)
{
    std::unique_lock lock(mMutex, std::defer_lock);
    if (atOnce)
        lock.lock();
    else if (!lock.try_lock())
        return; // another thread does it
    if (!mWaiting || (!atOnce && Clock::now() < mNextGiven))
        return;
    const Clock::time_point begun = Clock::now();
    publish(*std::exchange(mWaiting, std::nullopt));
    const Clock::time_point done = Clock::now();
    mNextGiven = done + std::max<Clock::duration>(leastPause, std::chrono::duration_cast<Clock::duration>(
                                                                  (done - begun) / givingShare));
}

//! \returns false when the map is not given out because it is not better or overlaps itself after all
bool LiveMap::publish(search::CutState state)
{
    // Where it does not meet the faces around the scope, it cannot be attached to them.
    if (mPart->isAttached() && state.anchorFaults() > state.chartsMayMeet)
        return false;
    SeamedMap map = state.map();
    definite::equalizeDensity(*mSoup, mProblem, map);
    if (definite::coversItself(*mSoup, map))
        return false;
    auto result = std::make_shared<LiveMapResult>();
    result->distortion = map.distortion(*mSoup);
    result->withinBound = result->distortion <= mOptions.maxDistortion;
    Merit merit = meritOf(state);
    merit.misses = !result->withinBound;
    if (mBest && !result->withinBound && !mBestMerit.misses)
        return false;
    result->token = mToken;
    result->seamLength = map.seamLength(*mSoup);
    result->islands = state.chartCount();
    result->cut = mPart->wholeCut(map.cut);
    const bool explores = !mFromMap && (mStage == Stage::Begin || mStage == Stage::Explore);
    result->uv = mPlacing.place(*mSnapshot, *mPart, *mSoup, map, mOptions.packing, explores);
    result->hasRoom = mPlacing.hadRoom();
    result->unmet = unmetSteering(*mSnapshot, result->uv);
    if (!mPart->isWhole()) {
        metrics::UvMetricsOptions figures;
        figures.overlaps = figures.gutter = false;
        const metrics::UvMetrics whole = metrics::measureUv(*mSnapshot->mesh, result->uv, figures);
        result->distortion = whole.symDirichlet;
        result->seamLength = whole.seamNorm;
        result->islands = whole.charts;
    }
    mBest = std::move(state);
    mBestMerit = merit;
    mGiven = result;
    mSink(std::move(result));
    return true;
}

} // namespace autocuts::unwrap
