#include "solver/finalmap.h"

#include "solver/overlapfree.h"
#include "solver/search/seamoptimizer.h"

#include <algorithm>
#include <mutex>

namespace autocuts {

namespace {

//! Enough to mend what the live solve left over, few enough to keep what the artist saw.
constexpr int searchMoves = 300;

} // namespace

std::optional<SeamedMap> makeFinalMap(const Solver &solver, const FinalMapOptions &options,
                                      const std::atomic<bool> *stop,
                                      const std::function<void(double)> &progress)
{
    const Snapshot &snapshot = solver.snapshot();
    std::optional<MadeMap> made = makeMap(solver, {.maxDistortion = options.maxDistortion}, stop);
    if (!made || !snapshot.pins.empty() || !snapshot.rectangles.empty())
        return made ? std::optional(std::move(made->map)) : std::nullopt;
    const Soup &soup = solver.soup();
    OptimizeOptions search;
    search.maxDistortion = options.maxDistortion;
    search.effort = {0, 0, 1, searchMoves};
    search.given.push_back(made->map);
    search.seed = snapshot.settings.seed;
    search.threads = options.threads;
    search.stop = stop;
    std::mutex mutex;
    int total = 1, done = 0;
    search.start = [&](int steps) { total = std::max(steps, 1); };
    search.progress = [&](int steps, double, double) {
        const std::lock_guard lock(mutex);
        done += steps;
        if (progress)
            progress(std::min(1.0, double(done) / total));
    };
    std::optional<OptimizedMap> found =
        optimizeSeams(SeamGraph::build(solver.sharedSoup(), snapshot), search);
    if (!found)
        return made->map;
    equalizeDensity(soup, found->map);
    const bool fits = found->map.distortion(soup) <= options.maxDistortion;
    const bool madeFits = made->map.distortion(soup) <= options.maxDistortion;
    const bool shorter = found->map.seamLength(soup) < made->map.seamLength(soup);
    if (coversItself(soup, found->map) || (fits == madeFits ? !shorter : madeFits))
        return made->map;
    return std::move(found->map);
}

} // namespace autocuts
