#include "solver/definite/refinedmap.h"

#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/rigidsettling.h"
#include "solver/definite/seamgaps.h"
#include "solver/search/anchoring.h"
#include "solver/search/seamoptimizer.h"

#include <algorithm>
#include <mutex>

namespace autocuts::definite {

namespace {

//! Moves of the seam search, as many as in the last round of an unwrap. Measured on the steered maps of
//! suzanne and the cow (bench_steering): seams over those of the free map and what the steering forces are
//! 1.298 and 1.216 in the worst cases with 300 moves, 1.077 and 1.107 with 1300, in up to twice the time.
constexpr int searchMoves = 1300;
constexpr int settleSteps = 20; // Newton steps before hard pins are reached; chosen by hand

//! Rotates and moves every chart that nothing holds, without scaling, to fit the previous positions of its
//! corners best.
void placeNear(const Soup &soup, const Snapshot &snapshot, SeamedMap &map, const std::vector<double> &before)
{
    const CutMesh charts(*soup.mesh, map.cut);
    const std::vector<bool> held = heldCharts(snapshot, charts);
    const int corners = soup.mesh->soupCornerCount();
    std::vector<std::vector<PointMatch>> matches(charts.chartCount);
    for (int c = 0; c < corners; ++c)
        matches[charts.chart[c / 3]].push_back({cornerAt(before, c), cornerAt(map.x, c)});
    std::vector<RigidMotion> motions;
    for (const std::vector<PointMatch> &chart : matches)
        motions.push_back(fitRigid(chart));
    for (int c = 0; c < corners; ++c) {
        const RigidMotion &motion = motions[charts.chart[c / 3]];
        if (!held.empty() && held[charts.chart[c / 3]])
            continue;
        cornerAt(map.x, c) = motion.fixedCentre + motion.turned(cornerAt(map.x, c) - motion.movingCentre);
    }
}

//! True when the searched map is worth more than the one it was made from.
bool isBetter(const Soup &soup, const Snapshot &snapshot, const SeamedMap &found, const SeamedMap &made,
              double maxDistortion)
{
    if (coversItself(soup, found))
        return false;
    const double distortion = found.distortion(soup), before = made.distortion(soup);
    const bool fits = distortion <= maxDistortion, madeFits = before <= maxDistortion;
    if (fits != madeFits)
        return fits;
    return fits ? found.seamCost(soup, snapshot) < made.seamCost(soup, snapshot) : distortion < before;
}

//! The map that the seam search makes of a definite map; nothing when it cannot start from there.
std::optional<RefinedMap> searched(const std::shared_ptr<const search::SeamGraph> &graph,
                                   const Snapshot &snapshot, const SeamedMap &made, double maxDistortion,
                                   const JobContext &job)
{
    search::OptimizeOptions search;
    search.maxDistortion = maxDistortion;
    search.effort = {0, {{searchMoves, 1}}};
    search.given.push_back(made);
    search.seed = snapshot.settings.seed;
    search.job = job;
    std::mutex mutex;
    int total = 1, done = 0;
    search.start = [&](int steps) { total = std::max(steps, 1); };
    search.progress = [&](int steps) {
        const std::lock_guard lock(mutex);
        done += steps;
        job.report(std::min(1.0, double(done) / total));
    };
    std::optional<search::OptimizedMap> found = search::optimizeSeams(graph, search);
    if (!found)
        return std::nullopt;
    const double distortion = found->map.distortion(*graph->soup);
    if (distortion > maxDistortion && !job.stopped()) {
        search.effort.boundMoves = search::thoroughBoundMoves;
        std::optional<search::OptimizedMap> more = search::optimizeSeams(graph, search);
        if (more && more->map.distortion(*graph->soup) < distortion)
            found = std::move(more);
    }
    equalizeDensity(*graph->soup, snapshot, found->map);
    return RefinedMap{std::move(found->map), found->anchorFaults};
}

//! The map with rigid regions that keep their shape, see settleRigidRegions().
SeamedMap withRigidRegions(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                           SeamedMap map, double maxDistortion, const JobContext &job)
{
    if (!snapshot.rigid || job.stopped())
        return map;
    search::OptimizeOptions search;
    search.maxDistortion = maxDistortion;
    search.seed = snapshot.settings.seed;
    search.job = job.quiet();
    map = settleRigidRegions(graph, snapshot, search, std::move(map));
    equalizeDensity(*graph->soup, snapshot, map);
    return map;
}

} // namespace

RefinedMap refineMap(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                     RefinedMap made, const std::vector<double> &places, double maxDistortion,
                     const JobContext &job)
{
    const Soup &soup = *graph->soup;
    std::optional<RefinedMap> found = searched(graph, snapshot, made.map, maxDistortion, job);
    if (found && (found->anchorFaults < made.anchorFaults ||
                  (found->anchorFaults == made.anchorFaults &&
                   isBetter(soup, snapshot, found->map, made.map, maxDistortion))))
        made = std::move(*found);
    made.map = withRigidRegions(graph, snapshot, std::move(made.map), maxDistortion, job);
    placeNear(soup, snapshot, made.map, places);
    openSeams(soup, snapshot, made.map);
    return made;
}

std::optional<RefinedMap> makeRefinedMap(const homotopy::Solver &solver, double maxDistortion,
                                         const JobContext &job)
{
    const Snapshot &snapshot = solver.snapshot();
    std::optional<DefiniteMap> definite =
        makeDefiniteMap(solver, {.maxDistortion = maxDistortion}, job.quiet());
    if (!definite)
        return std::nullopt;
    const auto graph = search::SeamGraph::build(solver.sharedSoup(), snapshot);
    RefinedMap made{std::move(definite->map)};
    if (!graph->anchors.empty())
        made.anchorFaults = search::settleAtAnchors(graph, made.map, settleSteps, true, job);
    openSeams(solver.soup(), snapshot, made.map);
    return refineMap(graph, snapshot, std::move(made), solver.coordinates(), maxDistortion, job);
}

} // namespace autocuts::definite
