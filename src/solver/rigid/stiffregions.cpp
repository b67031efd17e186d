#include "solver/rigid/stiffregions.h"

#include "solver/base/constant.h"
#include "solver/rigid/hinges.h"
#include "solver/rigid/rigidregions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::rigid {

namespace {

//! How much stiffer a region is than the rest. Where nothing else may stretch it leaves them an energy of
//! 4 + (bound - 4) / stiffness.
AUTOCUTS_CONSTANT(double, stiffness, 100);
//! Share of its area that a region adds to the stretch that the bound allows.
AUTOCUTS_CONSTANT(double, regionShare, 0.05);

//! Share of the usual bound that a curved region may use up where it is laid in the plane.
constexpr double boundShare = 0.3, usualRoom = 0.1;

//! Per region: with this stiffness, its least stretch uses up that share of the bound.
std::vector<double> stiffnessOfCurved(const Soup &soup, const RigidRegions &regions, const Unrolled &unrolled)
{
    std::vector<double> excess(regions.count, 0), area(regions.count, 0);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (const int r = regions.region[t]; r >= 0) {
            excess[r] += soup.weight[t] * unrolled.excess[t];
            area[r] += soup.weight[t];
        }
    }
    std::vector<double> most(regions.count, std::numeric_limits<double>::infinity());
    for (int r = 0; r < regions.count; ++r) {
        if (regions.curved[r] && excess[r] > 0)
            most[r] = boundShare * usualRoom * area[r] / excess[r];
    }
    return most;
}

//! Per triangle: true in curved regions that do not lie in the plane. Empty when all do.
std::vector<bool> inTornPanels(const RigidRegions &regions, const Unrolled &unrolled)
{
    std::vector<bool> torn;
    for (const int r : regions.region)
        torn.push_back(r >= 0 && regions.curved[r] && !unrolled.works[r]);
    if (std::find(torn.begin(), torn.end(), true) == torn.end())
        torn.clear();
    return torn;
}

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
    Unrolled unrolled = unroll(*soup, *regions);
    if (const std::vector<bool> torn = inTornPanels(*regions, unrolled); !torn.empty()) {
        // What seemed slightly curved may unroll in part.
        *regions = findRigidRegions(*mesh, creases, torn);
        unrolled = unroll(*soup, *regions);
    }
    // A region that tears or stretches when it is laid in the plane is none.
    for (int &r : regions->region)
        r = r >= 0 && unrolled.works[r] ? r : -1;
    const double share = rigidShare(*mesh, *regions);
    if (share == 0)
        return nullptr;
    regions->share = share;
    const double allowance = 1 - share + regionShare * share;
    const std::vector<double> most = stiffnessOfCurved(*soup, *regions, unrolled);
    for (const int r : regions->region)
        regions->stiffness.push_back(r >= 0 ? std::min(stiffness / allowance, most[r]) : 1 / allowance);
    const CutFlags none(mesh->edgePairs.size(), false);
    regions->apart = edgesApart(*soup, *regions, unrolled, findHinges(*soup, *regions, unrolled, none));
    return regions;
}

} // namespace autocuts::rigid
