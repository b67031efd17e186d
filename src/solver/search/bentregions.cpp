#include "solver/search/bentregions.h"

#include "solver/base/constant.h"
#include "solver/search/trianglekernel.h"

namespace autocuts::search {

namespace {

//! Mean energy above that of an isometry. Chosen by hand.
AUTOCUTS_CONSTANT(double, lostShape, 2e-3);

} // namespace

std::vector<bool> bentRegions(const Soup &soup, const RigidRegions &regions, const std::vector<double> &x)
{
    std::vector<double> energy(regions.count, 0), area(regions.count, 0);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (const int r = regions.region[t]; r >= 0) {
            energy[r] +=
                soup.weight[t] * (triangleEnergy(&x[6 * static_cast<std::size_t>(t)], soup.basis[t]) - 4);
            area[r] += soup.weight[t];
        }
    }
    std::vector<bool> bent(regions.count);
    for (int r = 0; r < regions.count; ++r)
        bent[r] = energy[r] > lostShape * area[r];
    return bent;
}

} // namespace autocuts::search
