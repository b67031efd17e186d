#include "solver/rigid/stiffregions.h"

#include "solver/rigid/hinges.h"
#include "solver/rigid/rigidregions.h"

#include <cmath>

namespace autocuts::rigid {

namespace {

//! How much stiffer a region is than the rest. Where nothing else may stretch it leaves them an energy of
//! 4 + (bound - 4) / stiffness.
constexpr double stiffness = 100;
//! Share of its area that a region adds to the stretch that the bound allows.
constexpr double regionShare = 0.05;

} // namespace

std::shared_ptr<const RigidRegions> rigidRegions(const std::shared_ptr<const MeshData> &mesh,
                                                 const std::vector<bool> &creases)
{
    if (!(mesh->area > 0) || !std::isfinite(mesh->area))
        return nullptr;
    auto regions = std::make_shared<RigidRegions>(findRigidRegions(*mesh, creases));
    if (regions->count == 0)
        return nullptr;
    const std::shared_ptr<const Soup> soup = Soup::build(mesh);
    const Unrolled unrolled = unroll(*soup, *regions);
    // A region that tears or stretches when it is laid in the plane is none.
    for (int &r : regions->region)
        r = r >= 0 && unrolled.works[r] ? r : -1;
    const double share = rigidShare(*mesh, *regions);
    if (share == 0)
        return nullptr;
    regions->share = share;
    const double allowance = 1 - share + regionShare * share;
    for (const int r : regions->region)
        regions->stiffness.push_back((r >= 0 ? stiffness : 1) / allowance);
    const CutFlags none(mesh->edgePairs.size(), false);
    regions->apart = edgesApart(*soup, *regions, unrolled, findHinges(*soup, *regions, unrolled, none));
    return regions;
}

} // namespace autocuts::rigid
