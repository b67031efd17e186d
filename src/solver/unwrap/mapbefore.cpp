#include "solver/unwrap/mapbefore.h"

namespace autocuts::unwrap {

std::optional<SeamedMap> mapBefore(const Soup &soup, const Snapshot &snapshot)
{
    if (!snapshot.uv)
        return std::nullopt;
    const std::vector<PairState> &states = snapshot.steering->pairState;
    CutFlags always(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t e = 0; e < always.size() && !states.empty(); ++e)
        always[e] = states[2 * e] == PairState::Cut || states[2 * e + 1] == PairState::Cut;
    std::optional<SeamedMap> map = seamedMapOf(soup, *snapshot.uv / snapshot.uvScale, always);
    for (std::size_t e = 0; map && e < always.size(); ++e) {
        if (map->cut[e] && snapshot.isJoined(e))
            return std::nullopt;
    }
    return map;
}

} // namespace autocuts::unwrap
