#include "solver/unwrap/livemap.h"

#include "model/plain/parallel.h"
#include "solver/base/timelimit.h"
#include "solver/search/anchoring.h"
#include "solver/search/resteering.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/mapfinder.h"
#include "solver/unwrap/mapsearch.h"
#include "solver/unwrap/mapsontheway.h"
#include "solver/unwrap/netstarts.h"

#include <utility>

namespace autocuts::unwrap {

namespace {

// Chosen by hand.
constexpr int movesPerRound = 120;      // large moves on each map between two squeezes
constexpr double roundHeat = 0.5;       // see SeamRun::search()
constexpr double noteworthy = 1e-3;     // share of the seam cost that a round has to gain
constexpr int idleRoundsToRest = 6;     // rounds without a noteworthy gain after which the search ends
constexpr int pulledSteps = 4;          // Newton steps on a map that is dragged
constexpr int resizingSteps = 12;       // Newton steps on a map whose texel weights changed
constexpr int quickSteps = 4;           // Newton steps on the first map
constexpr double quickTolerance = 1e-2; // energy gained below which the first map counts as relaxed
//! How long a dragged map is followed although the next move stops that.
constexpr auto timeOfDrag = std::chrono::milliseconds(150);
//! Meshes of more triangles than this get a draft first, as an unwrap makes it: a search with one thread
//! takes longer to the first map within the bound.
constexpr int sizeForDraft = 12'000;
constexpr int restShare = 3; // rest after a map was carried over on the way, times what that took

} // namespace

void LiveMap::begin(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options)
{
    mSnapshot = std::move(snapshot);
    takeOver(options);
    mBack = nullptr;
    mFromMap = mSnapshot->settings.start == StartMode::ExistingUv;
    mPulled = mExplored = false;
    mProblem.reset();
    mBest.reset();
    mSeed = 0;
    mStage = Stage::Begin;
}

void LiveMap::steer(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options, bool pulled,
                    std::shared_ptr<const LiveMapResult> back)
{
    if (!mSnapshot)
        return;
    mSnapshot = std::move(snapshot);
    mBest.setStanding(std::nullopt);
    takeOver(options);
    mPulled = pulled;
    if (back)
        mBack = std::move(back);
    if (mStage != Stage::Begin || mBest.best())
        mStage = Stage::Steer;
}

void LiveMap::takeOver(const LiveMapOptions &options)
{
    mOptions = options;
    mMaxDistortion = options.maxDistortion;
    mBest.setOptions(options, mMaxDistortion);
    mBest.setToken(mSnapshot->token);
}

bool LiveMap::work(const JobContext &job)
{
    while (mSnapshot && !job.stopped() && mStage != Stage::Done) {
        mBest.setPacksAfresh(!mFromMap && (mStage == Stage::Begin || mStage == Stage::Explore));
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
        mBest.giveWaiting(job, mStage == Stage::Done);
        if (mStage == Stage::Done && !mPulled)
            mBest.giveStraight(job);
    }
    return !job.stopped();
}

//! Takes the snapshot's problem. A map of the same faces stays.
void LiveMap::updateProblem(const JobContext &job)
{
    if (!mProblem.update(mSnapshot, job.threads()))
        mBest.forgetBest();
    mOptions.maxDistortion = mProblem.part().boundBeside(mMaxDistortion);
    mBest.setOptions(mOptions, mMaxDistortion);
    mBest.forgetWaiting();
    mIdleRounds = 0;
    mBegunAnew = false;
}

//! Makes a map of the part, as far as it can be steered, the one to improve.
//! \param uv per corner of the part, texture space \param given it was given out already, as it is
bool LiveMap::startFromMap(const UvMatrix &uv, const JobContext &job, bool given)
{
    Snapshot before = mProblem.problem();
    before.uv = std::make_shared<const UvMatrix>(uv);
    if (const std::optional<search::CutState> state = steeredMapBefore(mProblem.graph(), before, job))
        given ? mBest.setBest(*state) : take(*state, job);
    return mBest.best().has_value();
}

//! Makes a map that was found elsewhere, and lies at its anchors, the one to improve.
void LiveMap::take(const SeamedMap &map, const JobContext &job)
{
    if (!map.validate(*mProblem.soup()).empty())
        return;
    search::CutState state = search::CutState::from(mProblem.graph(), map, true);
    if (!mProblem.graph()->anchors.empty()) {
        search::SeamTrial trial(state);
        search::reachPins(trial, true);
    }
    take(state, job);
}

void LiveMap::take(const search::CutState &state, const JobContext &job)
{
    if (state.isFreeOfOverlaps())
        mBest.offer(state);
    mBest.giveWaiting(job, true);
}

//! A first map: the one of the document, or few cuts.
void LiveMap::findFirst(const JobContext &job)
{
    updateProblem(job);
    if (mProblem.problem().settings.seams == SeamMode::Only) {
        findByUnwrap(UnwrapQuality::Draft, {}, job);
        if (!job.stopped())
            mStage = Stage::Done;
        return;
    }
    if (mFromMap)
        findStanding(job);
    if (mFromMap && mProblem.problem().uv && startFromMap(*mProblem.problem().uv, job)) {
        mExplored = true; // its seams are what the user has
        mStage = Stage::Improve;
        return;
    }
    std::optional<search::CutState> quick = makeQuickMap(job);
    // Measured: on truck, plate and chain, a search that began otherwise was behind such a draft after 20 s.
    if (!mProblem.isSymmetric() && (mProblem.problem().mesh->triangleCount() > sizeForDraft ||
                                    startsFromClusterNets(mProblem.problem()) || hasAlikeParts(job)))
        findByUnwrap(UnwrapQuality::Draft, std::move(quick), job);
    if (!job.stopped())
        mStage = Stage::Explore;
}

//! The document's map, as what has to be beaten.
void LiveMap::findStanding(const JobContext &job)
{
    if (!mSnapshot->uv)
        return;
    if (unmetSteering(*mSnapshot, *mSnapshot->uv).onlyRectangles())
        mBest.setStanding(standingMap(*mSnapshot, mProblem.part(), mProblem.soup(), mProblem.problem(),
                                      mOptions.packing, job));
}

//! True when an unwrap solves one part of each kind, in less time than the search here takes for all.
bool LiveMap::hasAlikeParts(const JobContext &job)
{
    return !mFromMap && !mProblem.isSymmetric() && mBest.hasAlikeParts(job);
}

//! Changes the map to obey the snapshot; begins anew where that is not possible.
void LiveMap::steerMap(const JobContext &job)
{
    updateProblem(job);
    // Coarsening does not stop at once: whoever steers a large mesh gets local searches, which do.
    mExplored = mExplored || isLargeMesh(*mProblem.problem().mesh);
    const bool returns = mBack && mBack->token == mSnapshot->token;
    if (returns)
        mBest.giveAgain(mBack);
    // The document has the map that was given, and its islands have the sizes that are wanted.
    if (!mProblem.hasNewSizes() && mBest.given() && mSnapshot->uv && *mSnapshot->uv == mBest.given()->uv)
        findStanding(job);
    if (mProblem.problem().settings.seams == SeamMode::Only || (!mBest.best() && !mBest.given())) {
        mBack = nullptr;
        if (returns)
            mBest.forgetBest(); // it was dragged
        mStage = returns ? Stage::Done : Stage::Begin;
        return;
    }
    if (mBack || !mBest.best()) {
        const UvMatrix uv = mProblem.part().partUv(mBack ? mBack->uv : mBest.given()->uv);
        if (mBack)
            mBest.returnTo(uv);
        mBest.forgetBest();
        const bool started = startFromMap(uv, job, returns) ||
                             (mProblem.problem().uv && startFromMap(*mProblem.problem().uv, job));
        if (job.stopped())
            return; // the next time is like this one
        mBack = nullptr;
        if (!started) {
            mStage = Stage::Explore;
            return;
        }
    } else {
        // Drags come faster than maps: each is followed for a while before the next one stops it.
        std::optional<TimeLimit> limit;
        if (mPulled)
            limit.emplace(job, timeOfDrag, LimitStops::StoppedAndLate);
        const JobContext own = limit ? limit->context() : job;
        std::optional<search::CutState> state = search::resteered(*mBest.best(), mProblem.graph(), own);
        if (own.stopped())
            return;
        if (!state) {
            mBest.forgetBest();
            mStage = Stage::Explore;
            return;
        }
        if (mPulled || mProblem.hasNewSizes()) {
            search::SeamTrial trial(*state);
            trial.relaxAll(mPulled ? pulledSteps : resizingSteps, true, own);
            if (!mPulled && job.stopped())
                return;
        }
        // The snapshot has other costs: whatever obeys it is better than the old map.
        mBest.forgetBest();
        mBest.offer(*state);
        mBest.giveQuickly(own);
    }
    if (!mBest.best())
        mStage = Stage::Explore;
    else
        mStage = mPulled ? Stage::Done : mExplored ? Stage::Improve : Stage::Explore;
}

//! Few cuts, hardly relaxed.
std::optional<search::CutState> LiveMap::makeQuickMap(const JobContext &job)
{
    search::OptimizeOptions options = searchOptions(job);
    options.effort.seeds = 1;
    std::optional<search::CutState> state = search::firstMap(mProblem.graph(), options, 0);
    if (!state)
        return std::nullopt;
    search::SeamTrial trial(*state);
    trial.relaxAll(quickSteps, true, job);
    if (!mProblem.graph()->anchors.empty()) {
        search::placeAtAnchors(*state);
        trial.reset();
        search::reachPins(trial, true);
    }
    mBest.offer(*state);
    mBest.giveWaiting(job, true);
    return state;
}

//! Finds a map as an unwrap does. Meanwhile the quick map is relaxed, and maps that are found on the way are
//! made usable.
void LiveMap::findByUnwrap(UnwrapQuality quality, std::optional<search::CutState> quick,
                           const JobContext &job)
{
    UnwrapOptions options;
    options.maxDistortion = mProblem.plan().searchBound(mOptions.maxDistortion);
    options.quality = quality;
    Snapshot problem = mProblem.part().withoutRectangles();
    if (mProblem.isForCoarse())
        problem.settings.start = StartMode::Rigid; // a given map was of no use
    MapsOnTheWay onTheWay;
    parallelFor(2, job.threads(), [&](int i) {
        if (i == 0) {
            const MapsOnTheWay::Finder finder(onTheWay);
            Ranking ranking(options, job);
            const FoundMap found = findMap(problem, options, ranking, job.quiet(),
                                           [&](MakeMap make) { onTheWay.put(std::move(make)); });
            onTheWay.end(); // the other thread has nothing to do any more, while the map is taken
            if (!job.stopped() && !found.onlyReady)
                take(found.best.map, job);
            return;
        }
        while (quick && !onTheWay.waitsOrEnds() && !job.stopped()) {
            search::SeamTrial trial(*quick);
            if (!(trial.relaxAll(quickSteps, true, job) > quickTolerance))
                break;
            mBest.offer(*quick);
            mBest.giveWaiting(job);
        }
        while (const MakeMap make = onTheWay.next()) {
            const MapsOnTheWay::Clock::time_point begun = MapsOnTheWay::Clock::now();
            if (const std::optional<Candidate> made = make(onTheWay.making()); made && !made->onlyPatches)
                take(made->map, job);
            const MapsOnTheWay::Clock::time_point now = MapsOnTheWay::Clock::now();
            onTheWay.restUntil(now + restShare * (now - begun));
        }
    });
}

//! Searches from many first cuts, as an unwrap does.
void LiveMap::explore(const JobContext &job)
{
    if (mProblem.isForCoarse()) {
        findByUnwrap(UnwrapQuality::Standard, mBest.best(), job);
        if (job.stopped())
            return;
        if (mBest.best()) {
            mExplored = true;
            mStage = Stage::Improve;
            return;
        }
    }
    for (const UnwrapQuality quality : {UnwrapQuality::Draft, UnwrapQuality::Standard}) {
        search::OptimizeOptions options = searchOptions(job);
        if (quality == UnwrapQuality::Draft && mBest.best() && !mBest.misses())
            continue;
        options.effort = effortFor(quality, mProblem.problem().mesh->triangleCount());
        if (mBest.best())
            options.given.push_back(mBest.best()->map());
        if (quality == UnwrapQuality::Draft && mBest.best())
            options.effort.seeds = 0; // the quick map has the first cuts of a draft
        if (!mProblem.isSymmetric())
            addNetStarts(mProblem.graph(), mProblem.problem(), job.quiet(), options);
        const std::optional<search::OptimizedMap> found = search::optimizeSeams(mProblem.graph(), options);
        if (job.stopped())
            return;
        if (found)
            take(found->map, job);
    }
    exploreSoup(job);
    if (job.stopped())
        return;
    if (!mBest.best()) // the search alone finds no map
        findByUnwrap(UnwrapQuality::Draft, {}, job);
    mExplored = true;
    mStage = mBest.best() ? Stage::Improve : Stage::Done;
}

//! Searches from a map of the soup as well, where an unwrap does.
void LiveMap::exploreSoup(const JobContext &job)
{
    if (mProblem.isSymmetric())
        return;
    UnwrapOptions soup;
    soup.maxDistortion = mProblem.plan().searchBound(mOptions.maxDistortion);
    std::optional<SeamedMap> start = soupStart(mProblem.problem(), soup, job.quiet());
    if (!start || job.stopped())
        return;
    search::OptimizeOptions options = searchOptions(job);
    options.effort = effortFor(UnwrapQuality::Standard, mProblem.problem().mesh->triangleCount());
    options.effort.seeds = 0;
    options.given.push_back(std::move(*start));
    const std::optional<search::OptimizedMap> found = search::optimizeSeams(mProblem.graph(), options);
    if (found && !job.stopped())
        take(found->map, job);
}

//! One round: several searches on the map, side by side.
void LiveMap::improve(const JobContext &job)
{
    search::OptimizeOptions options = searchOptions(job);
    const double before = mBest.best()->cost;
    const bool missed = mBest.misses();
    if (missed)
        options.effort.boundMoves = search::thoroughBoundMoves;
    const int count = job.threads();
    const search::CutState start = *mBest.best();
    parallelFor(count, count, [&](int i) {
        search::SeamRun run(options, start, options.seed * 1000 + i);
        // A map above the bound first has to meet it.
        if (!missed)
            run.search(movesPerRound, roundHeat);
        run.takeToBound();
    });
    if (job.stopped())
        return;
    mBest.giveWaiting(job, true);
    const bool gained = mBest.misses() != missed || mBest.best()->cost < (1 - noteworthy) * before;
    mIdleRounds = gained ? 0 : mIdleRounds + 1;
    if (mIdleRounds >= idleRoundsToRest)
        mStage = mBest.misses() && !std::exchange(mBegunAnew, true) ? Stage::Explore : Stage::Done;
}

search::OptimizeOptions LiveMap::searchOptions(const JobContext &job)
{
    search::OptimizeOptions options;
    options.maxDistortion = mProblem.plan().searchBound(mOptions.maxDistortion);
    options.seed = mProblem.problem().settings.seed + mSeed++;
    options.job = job.quiet();
    options.improved = [this](const search::CutState &state) { mBest.offer(state); };
    options.progress = [this, quiet = job.quiet()](int) { mBest.giveWaiting(quiet); };
    return options;
}

} // namespace autocuts::unwrap
