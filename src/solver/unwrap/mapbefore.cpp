#include "solver/unwrap/mapbefore.h"

namespace autocuts::unwrap {

std::optional<SeamedMap> mapBefore(const Soup &soup, const Snapshot &snapshot)
{
    if (!snapshot.uv)
        return std::nullopt;
    const Steering &steering = *snapshot.steering;
    const SeamMode mode = snapshot.settings.seams;
    CutFlags always(snapshot.mesh->edgePairs.size(), false);
    for (std::size_t e = 0; e < always.size(); ++e) {
        if (!steering.pairState.empty())
            always[e] = steering.pairState[2 * e] == PairState::Cut ||
                        steering.pairState[2 * e + 1] == PairState::Cut;
        if (mode != SeamMode::Free && !steering.givenSeams.empty())
            always[e] = always[e] || steering.givenSeams[e];
    }
    std::optional<SeamedMap> map = seamedMapOf(soup, *snapshot.uv / snapshot.uvScale, always);
    for (std::size_t e = 0; map && e < always.size(); ++e) {
        if (map->cut[e] && (snapshot.isJoined(e) || (mode == SeamMode::Only && !always[e])))
            return std::nullopt;
    }
    return map;
}

} // namespace autocuts::unwrap
