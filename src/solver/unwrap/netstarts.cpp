#include "solver/unwrap/netstarts.h"

#include "solver/base/constant.h"
#include "solver/rigid/nets.h"
#include "solver/search/firstclusters.h"
#include "solver/search/seamseeds.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <iterator>

namespace autocuts::unwrap {

namespace {

//! Share of the area in rigid regions from which nets are better first maps than few cuts. Chosen by hand.
AUTOCUTS_CONSTANT(double, mostlyRigid, 0.95);

//! The graph with seams at the borders of all rigid regions.
std::shared_ptr<const search::SeamGraph> separated(const search::SeamGraph &graph, const Snapshot &snapshot)
{
    Snapshot apart = snapshot;
    std::vector<PairState> &states = apart.editSteering().pairState;
    states.resize(snapshot.mesh->cornerPairCount(), PairState::Free);
    for (std::size_t e = 0; e < snapshot.mesh->edgePairs.size(); ++e) {
        const auto [a, b] = snapshot.mesh->edgePairs[e].triangle;
        for (std::size_t p = 2 * e; p < 2 * e + 2; ++p) {
            if (snapshot.rigid->region[a] != snapshot.rigid->region[b] && states[p] == PairState::Free)
                states[p] = PairState::Cut;
        }
    }
    return graph.steeredBy(apart);
}

//! Maps in which the rigid regions of a problem are joined to nets without stretch. The rest of the surface
//! is cut off them and has first cuts of the seam search. \param count how many; fewer when stopped, none
//! when the problem has no rigid regions
std::vector<SeamedMap> netStarts(const std::shared_ptr<const search::SeamGraph> &graph,
                                 const Snapshot &snapshot, int count, const JobContext &job)
{
    std::vector<SeamedMap> starts;
    if (!snapshot.rigid)
        return starts;
    const rigid::Nets nets(graph->soup, snapshot);
    const auto apart = separated(*graph, snapshot);
    for (int i = 0; i < count && !job.stopped(); ++i) {
        search::SeedOptions seed;
        seed.joinBorders = true;
        seed.seed = static_cast<std::uint64_t>(i) + 1;
        seed.job = job;
        const std::vector<char> cut = search::fewCuts(*apart, seed);
        if (job.stopped())
            break;
        SeamedMap map;
        map.cut.assign(cut.begin(), cut.end());
        map.x = search::tutteEmbedding(*graph->soup, CutMesh(*snapshot.mesh, map.cut));
        map = nets.joined(i, std::move(map), job);
        if (!job.stopped() && map.validate(*graph->soup).empty())
            starts.push_back(std::move(map));
    }
    return starts;
}

} // namespace

bool startsFromNets(const Snapshot &snapshot)
{
    return snapshot.rigid && snapshot.rigid->share >= mostlyRigid;
}

bool startFromClusterNets(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                          search::OptimizeOptions &search)
{
    const std::optional<search::CutState> clusters =
        search::firstClusters(separated(*graph, snapshot), search, snapshot.rigid.get());
    if (!clusters)
        return false;
    SeamedMap map = clusters->map();
    map = rigid::Nets(graph->soup, snapshot).withCharts(map, snapshot).joined(0, map, search.job);
    if (search.job.stopped() || !map.validate(*graph->soup).empty())
        return false;
    search.given = {std::move(map)};
    search.effort.seeds = 0;
    return true;
}

void addNetStarts(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                  const JobContext &job, search::OptimizeOptions &search)
{
    const int seeds = search.effort.seeds;
    std::vector<SeamedMap> nets = netStarts(graph, snapshot, std::clamp(seeds, 1, 6), job);
    search.given.insert(search.given.end(), std::make_move_iterator(nets.begin()),
                        std::make_move_iterator(nets.end()));
    if (startsFromNets(snapshot) && !search.given.empty())
        search.effort.seeds = seeds / 4;
}

} // namespace autocuts::unwrap
