#include "solver/search/firstclusters.h"

#include "solver/base/constant.h"
#include "solver/search/seamseeds.h"
#include "solver/search/seamtrial.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

// Chosen by hand. With 0.3 for badChart, drafts of beetle, plane_holes and a noisy shape have seams that are
// 49, 57 and 14 % longer.

//! Spread of the normals in the first clusters, see clusterSeams(), in solver units: spheres stay whole up to
//! a twentieth of the size of the mesh.
AUTOCUTS_CONSTANT(double, firstSpread, 0.05);
AUTOCUTS_CONSTANT(double, narrower, 3); // divisor of the spread where a chart is bad
constexpr int mostRounds = 8;           // in which bad charts are divided
AUTOCUTS_CONSTANT(int, relaxSteps, 20); // Newton steps after which a chart is judged
AUTOCUTS_CONSTANT(double, badChart, 5); // energy of a chart per area, above that of an isometry

//! Relaxes the charts that have a map. \returns per chart: energy per area above that of an isometry; not
//! finite where it has no map
std::vector<double> relaxValid(CutState &state, const OptimizeOptions &options)
{
    const Soup &soup = *state.graph->soup;
    const auto excess = [&](int t) {
        return triangleEnergy(&state.x[6 * static_cast<std::size_t>(t)], soup.basis[t]) - 4;
    };
    std::vector<char> valid(state.chartCount(), 1);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (!std::isfinite(excess(t)))
            valid[state.chart[t]] = 0;
    }
    SeamTrial trial(state);
    trial.relaxCharts(valid, relaxSteps, !options.allowOverlaps, options.job.quiet());
    options.job.addWork(trial.patch().work());
    std::vector<double> energy(state.chartCount(), 0), area(state.chartCount(), 0);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        energy[state.chart[t]] += soup.weight[t] * excess(t);
        area[state.chart[t]] += soup.weight[t];
    }
    for (int c = 0; c < state.chartCount(); ++c)
        energy[c] = area[c] > 0 ? energy[c] / area[c] : 0;
    return energy;
}

bool isUsable(const CutState &state, const OptimizeOptions &options)
{
    return state.map().validate(*state.graph->soup).empty() &&
           (options.allowOverlaps || state.isFreeOfOverlaps({}, options.job));
}

} // namespace

std::optional<CutState> firstClusters(const std::shared_ptr<const SeamGraph> &graph,
                                      const OptimizeOptions &options, const RigidRegions *whole)
{
    SeedOptions seed;
    seed.paths = 0;
    seed.seed = options.seed * 1000;
    seed.job = options.job;
    seed.mostSpread.assign(graph->triangleCount(), firstSpread);
    std::optional<CutState> best;
    for (int round = 0; round < mostRounds; ++round) {
        const std::vector<char> cut = fewCuts(*graph, seed);
        SeamedMap map;
        map.cut.assign(cut.begin(), cut.end());
        map.x = tutteEmbedding(*graph->soup, CutMesh(*graph->soup->mesh, map.cut));
        CutState state = CutState::from(graph, map);
        const std::vector<double> excess = relaxValid(state, options);
        if (options.job.stopped())
            return std::nullopt;
        bool divides = false;
        for (int t = 0; t < graph->triangleCount(); ++t) {
            if (!(excess[state.chart[t]] <= badChart) && !(whole && whole->region[t] >= 0)) {
                seed.mostSpread[t] /= narrower;
                divides = true;
            }
        }
        if (isUsable(state, options) && (!best || state.distortion < best->distortion))
            best = std::move(state);
        if (!divides)
            break;
    }
    return best;
}

} // namespace autocuts::search
