#include "solver/unwrap/unwrap.h"

#include "model/plain/uvlayout.h"
#include "solver/base/timelimit.h"
#include "solver/definite/refinedmap.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/preference/seampreference.h"
#include "solver/preference/surfacekind.h"
#include "solver/straight/straightening.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/mapfinder.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/readyresult.h"
#include "solver/unwrap/rectanglefit.h"
#include "solver/unwrap/standingmap.h"
#include "solver/unwrap/unwrapplacing.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

//! Shares of the bound that the search may use where chosen lines are bent, one after the other: by hand.
constexpr std::array boundShares{1.0, 0.8, 0.5};
//! Time until maps are made ready for a stop, where nobody watches. Measured: they took a third of the CPU
//! time of drafts that end after two to three seconds. Drafts of 20,000 triangles end before.
constexpr std::chrono::milliseconds restBeforeFirstMap{1700};
// Time for straightening, chosen by hand: after a stop, and for a map that is shown while the search goes on.
constexpr auto timeAfterStop = std::chrono::milliseconds(100);
constexpr auto timeOfShownMap = std::chrono::milliseconds(400);

//! Makes the result of an unwrap from the map that was found.
class ResultMaker
{
public:
    ResultMaker(const Snapshot &snapshot, const FreePart &part, const straight::StraightPlan &plan,
                const UnwrapOptions &options)
        : mSnapshot(snapshot), mPart(part), mPlan(plan), mOptions(options),
          mPlacing(snapshot, part, plan, options)
    {}

    UnwrapResult resultOf(Candidate found, PackHurry hurry, const JobContext &job) const
    {
        UnwrapResult result;
        const std::shared_ptr<const Soup> soup = Soup::build(mPart.snapshot().mesh);
        result.straight = straighten(soup, found, hurry, job);
        if (mPlan.loops && hurry == PackHurry::WhenStopped)
            makeRoomForLines(soup, found, job);
        result.cut = mPart.wholeCut(found.map.cut);
        result.distortion = found.distortion;
        result.seamLength = found.seamLength + windingSeamLength(*soup->mesh);
        result.onlyPatches = found.onlyPatches;
        result.lambda = found.lambda;
        result.delta = found.delta;
        result.withinBound = mOptions.lambda || mSnapshot.settings.seams == SeamMode::Only ||
                             found.distortion <= mOptions.maxDistortion;
        if (mOptions.pack)
            fitToRectangles(mPart, soup, found.map, job);
        mPlacing.place(*soup, found.map, hurry, job, result);
        result.unmet = unmetSteering(mSnapshot, result.uv);
        return result;
    }

private:
    //! Makes straight what the settings ask for. Returns whether all of it was done; nothing when there is
    //! nothing to do.
    std::optional<bool> straighten(const std::shared_ptr<const Soup> &soup, Candidate &found, PackHurry hurry,
                                   const JobContext &job) const
    {
        if (mPlan.isEmpty() || found.onlyPatches)
            return std::nullopt;
        // With a given lambda the search decides how much distortion there is.
        const double bound = mOptions.lambda ? found.distortion : mOptions.maxDistortion;
        const auto within = [&](const JobContext &context) {
            const bool done =
                straight::straighten(soup, mPart.snapshot(), mPlan, bound, found.map, context.quiet());
            found.measure(*soup, mPart.snapshot());
            return done;
        };
        if (hurry == PackHurry::Always)
            return within(TimeLimit(job, timeOfShownMap).context());
        if (job.stopped())
            return within(TimeLimit(job.unstoppable(), timeAfterStop).context());
        return within(job);
    }

    //! Searches on from a map in which chosen lines are bent, for seams that leave more of the bound for
    //! them. The map stays when none are found.
    void makeRoomForLines(const std::shared_ptr<const Soup> &soup, Candidate &found,
                          const JobContext &job) const
    {
        const Snapshot &own = mPart.snapshot();
        const auto bent = [&](const SeamedMap &map) { return bentEdges(own, cornerUv(*soup, map)).size(); };
        std::size_t least = found.onlyPatches || mOptions.lambda ? 0 : bent(found.map);
        if (least == 0 || job.stopped())
            return;
        const Snapshot problem =
            preference::SeamPreference().applied(mPart.withoutRectangles(), job.threads());
        const auto graph = search::SeamGraph::build(soup, problem);
        for (const double share : boundShares) {
            const double bound = 4 + share * (mPlan.searchBound(mOptions.maxDistortion) - 4);
            Candidate next = found;
            next.map = definite::refineMap(graph, problem, {found.map, found.anchorFaults}, found.map.x,
                                           bound, job.quiet())
                           .map;
            const bool done =
                straight::straighten(soup, own, mPlan, mOptions.maxDistortion, next.map, job.quiet());
            next.measure(*soup, own);
            if (job.stopped() || !done || next.distortion > mOptions.maxDistortion)
                continue;
            if (const std::size_t rest = bent(next.map); rest < least) {
                least = rest;
                found = std::move(next);
            }
            if (least == 0)
                return;
        }
    }

    const Snapshot &mSnapshot;
    const FreePart &mPart;
    const straight::StraightPlan &mPlan;
    const UnwrapOptions &mOptions;
    const UnwrapPlacing mPlacing;
};

//! Where alike islands are stacked, stacks are made anew: those that there are may change.
Snapshot withFreeStacks(Snapshot snapshot)
{
    if (snapshot.settings.alike != AlikeMode::Stack || snapshot.steering->faceFlags.empty())
        return snapshot;
    std::vector<IslandFlags> &flags = snapshot.editSteering().faceFlags;
    for (std::size_t face = 0; face < flags.size(); ++face) {
        if (!snapshot.scope || snapshot.scope->faces[face])
            flags[face].stack = 0;
    }
    return snapshot;
}

//! The map before, where some of it stays, by locks, pins, stacks or hidden faces: beside that the rest is
//! not to become worse than it was. Nothing where that cannot be compared, when the map before has to change,
//! when faces were chosen to be mapped anew, and of a plain file.
class MapBesideTheRest
{
public:
    MapBesideTheRest(const Snapshot &snapshot, const FreePart &part, const straight::StraightPlan &plan,
                     const UnwrapOptions &options, const JobContext &job)
        : mPart(part)
    {
        if (part.isWhole() || isChosen(snapshot) || !snapshot.uv || !snapshot.keepTiles || !plan.isEmpty() ||
            options.lambda || !options.pack || snapshot.settings.seams == SeamMode::Only ||
            snapshot.settings.alike == AlikeMode::Stack ||
            !std::ranges::all_of(part.snapshot().steering->pins, &Pin::hard) ||
            !unmetSteering(snapshot, *snapshot.uv).onlyRectangles())
            return;
        mSoup = Soup::build(part.snapshot().mesh);
        mProblem = preference::SeamPreference().applied(part.withoutRectangles(), job.threads());
        mStanding = standingMap(snapshot, part, mSoup, mProblem, options.packing, job.quiet());
    }

    //! Takes it in place of a map that is not better. \returns true when it is also where it may stay
    bool stays(Candidate &found, double maxDistortion) const
    {
        if (!mStanding || beats(found.map, *mSoup, mProblem, mStanding->worth,
                                mPart.boundOf(maxDistortion, mStanding->worth.bounded)))
            return false;
        found = mStanding->worth;
        return mStanding->inPlace;
    }

private:
    static bool isChosen(const Snapshot &snapshot) { return snapshot.scope && snapshot.scope->chosen; }

    const FreePart &mPart;
    std::shared_ptr<const Soup> mSoup;
    Snapshot mProblem;
    std::optional<StandingMap> mStanding;
};

void checkOptions(const UnwrapOptions &options)
{
    if (!(options.maxDistortion > 4))
        throw std::invalid_argument("the distortion bound must be above 4, the value of an isometry");
    if (options.lambda && !(*options.lambda >= 0 && *options.lambda <= 1))
        throw std::invalid_argument("lambda must be between 0 and 1");
}

} // namespace

UnwrapResult unwrapMesh(const Snapshot &given, const UnwrapOptions &asked, const JobContext &caller)
{
    checkOptions(asked);
    const Snapshot snapshot = withFreeStacks(given);
    UnwrapResult result;
    const std::optional<FreePart> part = FreePart::of(snapshot);
    if (!part) {
        result.nothingFree = true;
        result.uv = snapshot.uv ? *snapshot.uv : emptyLayout(*snapshot.mesh);
        return result;
    }
    UnwrapOptions options = asked;
    options.maxDistortion = part->boundBeside(asked.maxDistortion);
    // The search knows nothing of seams that no map can close.
    const double alwaysOpen = windingSeamLength(*part->snapshot().mesh);
    const double ofRest = part->seamLengthOfRest();
    const JobContext::Sink withAll = [&](JobProgress progress) {
        if (progress.seamLength > 0)
            progress.seamLength = (progress.seamLength + alwaysOpen) / part->unit() + ofRest;
        caller.report(progress);
    };
    const JobContext job = caller.reports() ? caller.watchedBy(withAll) : caller;
    const Snapshot &problem = part->withoutRectangles();
    const straight::StraightPlan plan = straight::StraightPlan::of(part->snapshot());
    const MapBesideTheRest before(snapshot, *part, plan, options, caller);
    UnwrapOptions searched = options;
    searched.maxDistortion = plan.searchBound(options.maxDistortion);
    Ranking ranking(searched, job);
    const ResultMaker maker(snapshot, *part, plan, options);
    std::optional<ReadyResult> ready;
    if (options.better || suitsCoarseToFine(problem, options)) {
        ready.emplace(
            ranking,
            [&maker](Candidate map, const JobContext &own) {
                return maker.resultOf(std::move(map), PackHurry::Always, own);
            },
            [&problem](const JobContext &) { return patchesOf(problem); }, options.better,
            options.better ? std::chrono::milliseconds(0) : restBeforeFirstMap);
    }
    PrepareMap prepare;
    if (ready)
        prepare = [&ready](MakeMap make) { ready->prepare(std::move(make)); };
    FoundMap found = findMap(problem, searched, ranking, job, prepare);
    const bool stays = !found.onlyReady && before.stays(found.best, options.maxDistortion);
    // To place the islands takes long, too.
    if (stays) {
        result.uv = *snapshot.uv;
        result.cut = part->wholeCut(found.best.map.cut);
        result.distortion = found.best.distortion;
        result.seamLength = found.best.seamLength + alwaysOpen;
        result.withinBound =
            found.best.distortion <= part->boundOf(options.maxDistortion, found.best.bounded);
        result.packed = result.nothingGained = true;
        result.unmet = unmetSteering(snapshot, result.uv);
    } else if (found.onlyReady || (ready && job.stopped() && ready->isAsGoodAs(found.best))) {
        result = ready->take();
    } else {
        const JobContext::Sink report = [&](const JobProgress &done) {
            ranking.packing(Ranking::optimizingShare + (1 - Ranking::optimizingShare) * done.fraction);
        };
        ready.reset();
        result = maker.resultOf(std::move(found.best), PackHurry::WhenStopped, job.watchedBy(report));
    }
    if (!result.withinBound && !part->isWhole())
        result.withinBound =
            metrics::measureShapes(*snapshot.mesh, result.uv, snapshot.tileHeight).tileDirichlet <=
            asked.maxDistortion;
    result.iterations = found.iterations;
    result.hardShare = preference::surfaceParts(*part->snapshot().mesh, snapshot.settings.surface).hardShare;
    if (!stays) {
        result.symmetry = found.symmetry;
        result.symmetryMissed = found.symmetryMissed;
    }
    result.stopped = job.stopped();
    return result;
}

} // namespace autocuts::unwrap
