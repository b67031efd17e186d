#include "solver/unwrap/mapbefore.h"

#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/search/anchoring.h"
#include "solver/search/resteering.h"

namespace autocuts::unwrap {

namespace {

std::optional<SeamedMap> mapOf(const Soup &soup, const Snapshot &snapshot, const CutFlags &alwaysCut)
{
    if (!snapshot.uv)
        return std::nullopt;
    return seamedMapOf(soup, *snapshot.uv / snapshot.uvScale, alwaysCut);
}

} // namespace

std::optional<SeamedMap> mapBefore(const Soup &soup, const Snapshot &snapshot, bool openJoins)
{
    const std::vector<PairState> &states = snapshot.steering->pairState;
    CutFlags always(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t e = 0; e < always.size() && !states.empty(); ++e)
        always[e] = states[2 * e] == PairState::Cut || states[2 * e + 1] == PairState::Cut;
    std::optional<SeamedMap> map = mapOf(soup, snapshot, always);
    for (std::size_t e = 0; map && !openJoins && e < always.size(); ++e) {
        if (map->cut[e] && snapshot.isJoined(e))
            return std::nullopt;
    }
    return map;
}

std::optional<search::CutState> steeredMapBefore(const std::shared_ptr<const search::SeamGraph> &graph,
                                                 const Snapshot &snapshot, const JobContext &job)
{
    const Soup &soup = *graph->soup;
    Snapshot unsteered = snapshot; // but for the pins, which hold charts that lie there already
    unsteered.editSteering() = {};
    unsteered.editSteering().pins = snapshot.steering->pins;
    std::optional<SeamedMap> map = mapOf(soup, unsteered, CutFlags(snapshot.mesh->edgePairs.size(), false));
    if (!map)
        return std::nullopt;
    if (definite::coversItself(soup, *map) &&
        (!definite::removeOverlaps(soup, unsteered, *map) || definite::coversItself(soup, *map)))
        return std::nullopt;
    // Islands that were scaled are not stretched: their scales are kept where they are placed.
    definite::equalizeDensity(soup, unsteered, *map);
    search::CutState state = search::CutState::from(graph->steeredBy(unsteered), *map, true);
    if (!graph->anchors.empty())
        search::placeAtAnchors(state);
    if (!state.isFreeOfOverlaps())
        return std::nullopt;
    return search::resteered(state, graph, job);
}

} // namespace autocuts::unwrap
