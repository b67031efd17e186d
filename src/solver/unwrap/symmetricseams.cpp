#include "solver/unwrap/symmetricseams.h"

#include "model/plain/uvseams.h"
#include "solver/base/cutmesh.h"
#include "solver/preference/seampreference.h"
#include "solver/preference/surfacekind.h"

#include <algorithm>

namespace autocuts::unwrap {

bool isSymmetryOpen(const Snapshot &snapshot)
{
    const Steering &steering = *snapshot.steering;
    return snapshot.settings.symmetry == SymmetryMode::Auto && snapshot.settings.seams == SeamMode::Free &&
           !snapshot.placesIslands() && steering.straightLoops.empty() &&
           preference::alignedParts(snapshot.settings, *snapshot.mesh).empty() &&
           std::ranges::all_of(steering.pairState, [](PairState s) { return s == PairState::Free; }) &&
           // On hard surfaces, flat faces and alike parts decide.
           !preference::isMostlyHard(*snapshot.mesh, snapshot.settings.surface);
}

bool hasSymmetricSeams(const Snapshot &snapshot)
{
    const MeshData &mesh = *snapshot.mesh;
    if (!snapshot.uv)
        return false;
    const std::vector<bool> open = openCornerPairs(mesh, *snapshot.uv);
    CutFlags cut;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e)
        cut.push_back(open[2 * e] || open[2 * e + 1]);
    if (std::ranges::find(cut, true) == cut.end())
        return false;
    const auto symmetry = preference::findSymmetry(mesh, preference::Exactness::Exact);
    return symmetry && preference::symmetricShare(mesh, *symmetry, cut) == 1;
}

SymmetryMode settledSymmetry(const Snapshot &snapshot)
{
    if (snapshot.settings.symmetry != SymmetryMode::Auto)
        return snapshot.settings.symmetry;
    return isSymmetryOpen(snapshot) && hasSymmetricSeams(snapshot) ? SymmetryMode::On : SymmetryMode::Off;
}

std::optional<preference::MeshSymmetry> openSymmetry(const Snapshot &snapshot, const UnwrapOptions &options,
                                                     const JobContext &job)
{
    if (options.quality == UnwrapQuality::Draft || options.lambda ||
        snapshot.settings.start == StartMode::ExistingUv || !isSymmetryOpen(snapshot))
        return std::nullopt;
    return preference::findSymmetry(*snapshot.mesh, preference::Exactness::Exact, job);
}

} // namespace autocuts::unwrap
