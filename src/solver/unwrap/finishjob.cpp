#include "solver/unwrap/finishjob.h"

#include "model/plain/uvlayout.h"
#include "solver/base/timelimit.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/refinedmap.h"
#include "solver/definite/seamopening.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/preference/seampreference.h"
#include "solver/straight/straightening.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/keptplaces.h"
#include "solver/unwrap/keptscale.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/mapsearch.h"
#include "solver/unwrap/oldplaces.h"
#include "solver/unwrap/rectanglefit.h"
#include "solver/unwrap/standingmap.h"
#include "solver/unwrap/symmetricseams.h"

#include <algorithm>
#include <chrono>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Delta of the separation energy for a given map, solver units squared: corners much nearer to each other
//! than its square root count as joined. Chosen by hand far above rounding and far below the edge lengths.
constexpr double touchingDelta = 1e-9;
//! Rough number of steps of a live solve. A guess that only the progress depends on.
constexpr double usualSteps = 1000;
//! Time for straightening after a stop.
constexpr auto timeAfterStop = std::chrono::milliseconds(100);
//! Share of the stretch above the bound that other seams may leave to be taken in place of those of the map.
constexpr double worthOtherSeams = 0.5;

void load(const FinishInput &input, const FreePart &part, int threads, homotopy::Solver &solver)
{
    Snapshot snapshot = part.snapshot();
    if (input.live) {
        snapshot.settings.lambda = input.live->lambda;
        snapshot.settings.delta = input.live->delta;
    } else {
        snapshot.settings.start = StartMode::ExistingUv;
        snapshot.settings.delta = touchingDelta;
        snapshot.startUv =
            std::make_shared<const UvMatrix>(soupUv(*snapshot.mesh, *snapshot.uv) / snapshot.uvScale);
    }
    solver.setThreads(threads);
    solver.load(preference::SeamPreference().applied(snapshot, threads));
    if (input.live) {
        const UvMatrix rows = part.unit() * part.partRows(rowsOf(input.live->coordinates));
        solver.setCoordinates({rows.data(), rows.data() + rows.size()});
    }
}

//! True for the map of a document, whose islands have the sizes that the user gave them. The islands of a map
//! in a plain file get one texel density.
bool keepsScales(const Snapshot &snapshot)
{
    return snapshot.uv && snapshot.keepTiles;
}

//! Per chart: true when pins or a rectangle say where it is.
std::vector<bool> heldPlaces(const FreePart &part, const CutMesh &charts)
{
    std::vector<bool> held = heldCharts(part.snapshot(), charts);
    held.resize(charts.chartCount);
    for (const UvRectangle &box : part.snapshot().steering->rectangles) {
        for (const int corner : box.soupCorners)
            held[charts.chart[corner / 3]] = true;
    }
    return held;
}

//! Packs the finished map where islands overlap or are not where they belong.
void place(const FinishInput &input, const FreePart &part, NewCharts map, const JobContext &job,
           FinishResult &result)
{
    const Snapshot &snapshot = input.snapshot;
    const MeshData &mesh = *snapshot.mesh;
    PackJob pack = steeredPackJob(snapshot, input.packing);
    pack.options.keepScale = false; // where there is no room, all islands become smaller
    const bool keeps = keepsScales(snapshot);
    pack.keepScaleIfPossible = !part.isWhole() || snapshot.placesIslands() || keeps;
    if (keeps)
        pack.density = packing::DensityBasis::Given;
    if (keeps && !input.live)
        pack.gap = keptGap(mesh, pack, *snapshot.uv);
    const JobContext packing = job.part(0, 1, JobStage::Packing);
    if (liesFree(mesh, map.charts, pack, map.uv, job)) {
        result.uv = std::move(map.uv);
    } else if (keeps && !input.live && keepPlaces(snapshot, part, pack, input.maxDistortion, map, packing)) {
        result.notReplaced = map.notReplaced;
        result.uv = std::move(map.uv);
    } else {
        const double size = layoutScale(mesh, map.uv);
        const bool packed = keeps ? packMisplaced(mesh, map.charts, pack, map.uv, packing)
                                  : packCharts(mesh, map.charts, pack, map.uv, packing);
        result.noRoom = !packed && !job.stopped();
        result.madeSmaller = keeps && !input.live && isSmaller(mesh, map.uv, size);
        result.uv = std::move(map.uv);
    }
}

//! True when each list is at least as long in the other one.
bool obeysAsMuch(const UnmetSteering &one, const UnmetSteering &other)
{
    return one.pins.size() <= other.pins.size() && one.joins.size() <= other.joins.size() &&
           one.rectangles.size() <= other.rectangles.size() &&
           one.missingSeams.size() <= other.missingSeams.size() && one.bent.size() <= other.bent.size();
}

//! The map before, and what a job has to beat of it: nothing after a live solve, and of a plain file.
class MapBefore
{
public:
    MapBefore(const FinishInput &input, const FreePart &part, std::shared_ptr<const Soup> soup,
              const JobContext &job)
        : mInput(input), mPart(part), mSoup(std::move(soup))
    {
        if (input.live)
            return;
        mUnmet = unmetSteering(input.snapshot, *input.snapshot.uv);
        if (!keepsScales(input.snapshot))
            return;
        mProblem = preference::SeamPreference().applied(part.withoutRectangles(), job.threads());
        mStanding = standingMap(input.snapshot, part, mSoup, mProblem, input.packing, job);
    }

    //! Takes the shapes of the map before where only its islands have to move and no better ones are known.
    void keepShapes(SeamedMap &map) const
    {
        if (!mStanding || mStanding->inPlace || !mUnmet.onlyRectangles())
            return;
        if (!beats(map, *mSoup, mProblem, mStanding->worth, bound()))
            map = mStanding->worth.map;
    }

    //! True when the map before may stay and is not beaten. Where a tile is full, some islands stay old and
    //! some are new: such a mixture may be worse than both.
    bool isAsGoodAs(const FinishResult &made) const
    {
        if (!mStanding || !mStanding->inPlace || !obeysAsMuch(mUnmet, made.unmet))
            return false;
        if (!made.noRoom && Wishes::of(mInput.snapshot, made.uv).isBetterThan(mStanding->wishes))
            return false;
        const std::optional<Candidate> after = worthOf(mPart, mSoup, mProblem, made.uv);
        return made.noRoom || !after || !beats(*after, mStanding->worth, bound());
    }

    const UnmetSteering &unmet() const { return mUnmet; }
    //! Of what may change, where it may stay.
    std::optional<double> distortion() const
    {
        return mStanding ? std::optional(mStanding->worth.distortion) : std::nullopt;
    }

private:
    double bound() const { return mPart.boundOf(mInput.maxDistortion, mStanding->worth.bounded); }

    const FinishInput &mInput;
    const FreePart &mPart;
    const std::shared_ptr<const Soup> mSoup;
    Snapshot mProblem;
    UnmetSteering mUnmet;
    std::optional<StandingMap> mStanding;
};

//! Takes the map before back when it obeys more joins, or nothing was gained.
void keepBetterMap(const FinishInput &input, const MapBefore &mapBefore, FinishResult &result)
{
    const Snapshot &snapshot = input.snapshot;
    const bool nothingGained = mapBefore.isAsGoodAs(result);
    const UnmetSteering &before = mapBefore.unmet();
    if (!nothingGained && before.joins.size() >= result.unmet.joins.size())
        return;
    const metrics::UvMetrics figures =
        metrics::measureShapes(*snapshot.mesh, *snapshot.uv, snapshot.tileHeight);
    if (!nothingGained && (figures.facesWithoutUv > 0 || figures.flipped > 0))
        return;
    result.uv = *snapshot.uv;
    result.distortion = figures.tileDirichlet;
    result.withinBound = mapBefore.distortion().value_or(result.distortion) <= input.maxDistortion;
    result.unmet = before;
    result.noRoom = result.madeSmaller = false;
    result.notReplaced = 0;
    result.nothingGained = nothingGained;
}

//! The map before, steered and improved; nothing when it cannot be steered.
std::optional<definite::RefinedMap> refinedMapBefore(const std::shared_ptr<const Soup> &soup,
                                                     const Snapshot &part, double maxDistortion,
                                                     const JobContext &job)
{
    const Snapshot problem = preference::SeamPreference().applied(part, job.threads());
    std::optional<preference::MeshSymmetry> symmetry;
    if (problem.settings.symmetry == SymmetryMode::On)
        symmetry = preference::findSymmetry(*problem.mesh, preference::Exactness::Loose, job);
    const auto graph = search::SeamGraph::build(soup, problem, symmetry ? &*symmetry : nullptr);
    const std::optional<search::CutState> state = steeredMapBefore(graph, problem, job);
    if (!state)
        return std::nullopt;
    const UvMatrix rows = soupUv(*part.mesh, *part.uv) / part.uvScale;
    const auto refined = [&](SeamedMap map, int anchorFaults) {
        return definite::refineMap(graph, problem, {std::move(map), anchorFaults},
                                   {rows.data(), rows.data() + rows.size()}, maxDistortion, job);
    };
    definite::RefinedMap made = refined(state->map(), state->anchorFaults());
    const double distortion = made.map.distortion(*soup);
    if (distortion <= maxDistortion || job.stopped() || isLargeMesh(*part.mesh))
        return made;
    // No search from the map meets the bound: one from other first cuts may.
    search::OptimizeOptions anew;
    anew.maxDistortion = maxDistortion;
    anew.effort = effortFor(UnwrapQuality::Standard, part.mesh->triangleCount());
    anew.seed = problem.settings.seed;
    anew.job = job.quiet();
    if (std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, anew)) {
        definite::RefinedMap other = refined(std::move(found->map), found->anchorFaults);
        const double excess = other.map.distortion(*soup) - maxDistortion;
        if (other.anchorFaults <= made.anchorFaults &&
            excess <= worthOtherSeams * (distortion - maxDistortion))
            return other;
    }
    return made;
}

//! The map of the soup: of a live solve, or of the map before as a soup that touches itself.
std::optional<definite::RefinedMap> refinedSoup(const FinishInput &input, const FreePart &part,
                                                double maxDistortion, const JobContext &job)
{
    homotopy::Solver solver;
    load(input, part, job.threads(), solver);
    double begun = 0;
    if (input.live && input.live->hasMoreToDo) {
        int steps = 0;
        const JobContext toTheEnd = job.part(0, 1, JobStage::SolvingToTheEnd);
        homotopy::runToTheEnd(solver, maxDistortion, job, [&] {
            ++steps;
            begun = 0.5 * steps / (steps + usualSteps); // the number of steps is not known beforehand
            toTheEnd.report(begun);
        });
    }
    Snapshot rest = solver.snapshot();
    if (!rest.steering->rectangles.empty()) {
        rest.editSteering().rectangles.clear();
        solver.update(rest);
    }
    return definite::makeRefinedMap(solver, maxDistortion, job.part(begun, 1));
}

//! Makes straight what the settings ask for. The islands stay at their places.
void straighten(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                const straight::StraightPlan &plan, double maxDistortion, SeamedMap &map,
                const JobContext &job, FinishResult &result)
{
    if (plan.isEmpty())
        return;
    const SeamedMap before = map;
    const JobContext goesOn = job.unstoppable();
    std::optional<TimeLimit> limit;
    if (job.stopped())
        limit.emplace(goesOn, timeAfterStop);
    result.straight = straight::straighten(soup, snapshot, plan, maxDistortion, map,
                                           limit ? limit->context() : job.quiet());
    straight::restoreCentres(*soup, snapshot, before, map);
}

} // namespace

FinishResult finishMap(const FinishInput &asked, const JobContext &job)
{
    FinishResult result;
    FinishInput input = asked;
    input.snapshot.settings.symmetry = settledSymmetry(asked.snapshot);
    const std::optional<FreePart> part = FreePart::of(input.snapshot);
    if (!part) {
        result.nothingFree = true;
        result.uv = asked.snapshot.uv ? *asked.snapshot.uv : emptyLayout(*asked.snapshot.mesh);
        return result;
    }
    input.maxDistortion = part->boundBeside(asked.maxDistortion);
    const Snapshot own = part->withoutRectangles();
    const std::shared_ptr<const Soup> soup = Soup::build(own.mesh);
    const auto plan = straight::StraightPlan::of(part->snapshot());
    const double bound = plan.searchBound(input.maxDistortion);
    std::optional<definite::RefinedMap> found;
    if (!input.live)
        found = refinedMapBefore(soup, own, bound, job);
    if (!found)
        found = refinedSoup(input, *part, bound, job);
    if (!found)
        return result;
    straighten(soup, part->snapshot(), plan, input.maxDistortion, found->map, job, result);
    const MapBefore before(input, *part, soup, job);
    before.keepShapes(found->map);
    if (keepsScales(input.snapshot))
        definite::equalizeDensity(*soup, own, found->map);
    fitToRectangles(*part, soup, found->map, job);
    result.withinBound = found->map.distortion(*soup) <= input.maxDistortion;
    UvMatrix uv = own.uvScale * cornerUv(*soup, found->map);
    definite::openCuts(own, uv);
    const CutMesh state(*own.mesh, found->map.cut);
    const ChartMap charts = chartsOf(*own.mesh, state);
    NewCharts map{part->wholeUv(uv), part->wholeCharts(charts)};
    if (keepsScales(input.snapshot)) {
        keepScales(input.snapshot, map.charts, steeredPackJob(input.snapshot, input.packing),
                   part->unit() * layoutScale(*own.mesh, uv), map.uv);
        if (!input.live)
            map.uv = part->wholeUv(atOldPlaces(
                *own.mesh, charts, heldPlaces(*part, state), {*own.uv, findCharts(*own.mesh, *own.uv)},
                plan.isEmpty() ? PackRotation::Free : PackRotation::Quarter, part->partUv(map.uv)));
    }
    place(input, *part, std::move(map), job, result);
    result.unmet = unmetSteering(input.snapshot, result.uv);
    result.distortion =
        metrics::measureShapes(*input.snapshot.mesh, result.uv, input.snapshot.tileHeight).tileDirichlet;
    if (!input.live)
        keepBetterMap(input, before, result);
    result.withinBound = result.withinBound || result.distortion <= asked.maxDistortion;
    const std::vector<PairState> &states = input.snapshot.steering->pairState;
    const bool joins = std::find(states.begin(), states.end(), PairState::Joined) != states.end();
    result.heldTogether = joins && !result.noRoom &&
                          !overlap::findOverlaps(soupUv(*input.snapshot.mesh, result.uv)).pairs.empty();
    return result;
}

} // namespace autocuts::unwrap
