#include "solver/definite/refinedmap.h"

#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/seamgaps.h"
#include "solver/search/seamoptimizer.h"

#include <algorithm>
#include <mutex>

namespace autocuts::definite {

namespace {

//! Moves of the seam search. Enough to close the seams that the live solve left half closed (on the sample
//! "character" the search reduced 86 islands to 10), few enough to keep the layout that the artist saw. No
//! measurement of other values is recorded.
constexpr int searchMoves = 300;

//! Rotates and moves every chart, without scaling, to fit the previous positions of its corners best.
void placeNear(const Soup &soup, SeamedMap &map, const std::vector<double> &before)
{
    const CutMesh charts(*soup.mesh, map.cut);
    const int corners = soup.mesh->soupCornerCount();
    std::vector<std::vector<PointMatch>> matches(charts.chartCount);
    for (int c = 0; c < corners; ++c)
        matches[charts.chart[c / 3]].push_back({cornerAt(before, c), cornerAt(map.x, c)});
    std::vector<RigidMotion> motions;
    for (const std::vector<PointMatch> &chart : matches)
        motions.push_back(fitRigid(chart));
    for (int c = 0; c < corners; ++c) {
        const RigidMotion &motion = motions[charts.chart[c / 3]];
        cornerAt(map.x, c) = motion.fixedCentre + motion.turned(cornerAt(map.x, c) - motion.movingCentre);
    }
}

} // namespace

std::optional<SeamedMap> makeRefinedMap(const homotopy::Solver &solver, const RefinedMapOptions &options,
                                        const JobContext &job)
{
    const Snapshot &snapshot = solver.snapshot();
    std::optional<DefiniteMap> made =
        makeDefiniteMap(solver, {.maxDistortion = options.maxDistortion}, job.quiet());
    if (!made)
        return std::nullopt;
    const Soup &soup = solver.soup();
    openSeams(soup, snapshot, made->map);
    if (snapshot.placesIslands())
        return std::move(made->map);
    search::OptimizeOptions search;
    search.maxDistortion = options.maxDistortion;
    search.effort = {0, {{searchMoves, 1}}};
    search.given.push_back(made->map);
    search.seed = snapshot.settings.seed;
    search.job = job;
    std::mutex mutex;
    int total = 1, done = 0;
    search.start = [&](int steps) { total = std::max(steps, 1); };
    search.progress = [&](int steps, double, double) {
        const std::lock_guard lock(mutex);
        done += steps;
        job.report(std::min(1.0, double(done) / total));
    };
    std::optional<search::OptimizedMap> found =
        search::optimizeSeams(search::SeamGraph::build(solver.sharedSoup(), snapshot), search);
    if (!found)
        return made->map;
    equalizeDensity(soup, found->map);
    const bool fits = found->map.distortion(soup) <= options.maxDistortion;
    const bool madeFits = made->map.distortion(soup) <= options.maxDistortion;
    const bool cheaper = found->map.seamCost(soup, snapshot) < made->map.seamCost(soup, snapshot);
    if (coversItself(soup, found->map) || (fits == madeFits ? !cheaper : madeFits))
        return made->map;
    placeNear(soup, found->map, solver.coordinates());
    openSeams(soup, snapshot, found->map);
    return std::move(found->map);
}

} // namespace autocuts::definite
