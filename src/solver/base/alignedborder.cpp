#include "solver/base/alignedborder.h"

#include "solver/base/cornerat.h"

namespace autocuts {

double crookedBorder(const Soup &soup, const std::vector<bool> &aligned, const std::vector<int> &sides,
                     const std::vector<int> &chart, int chartCount, const std::vector<double> &x)
{
    std::vector<AlignedBorder> border(chartCount);
    for (const int side : sides) {
        const int t = side / 3, k = side % 3, next = (k + 1) % 3;
        if (!aligned[soup.mesh->component[t]])
            continue;
        const std::array<double, 6> &shape = soup.restShape[t];
        const double length =
            std::hypot(shape[2 * next] - shape[2 * k], shape[2 * next + 1] - shape[2 * k + 1]);
        border[chart[t]].add(cornerAt(x, 3 * t + next) - cornerAt(x, side),
                             soup.perCopy * soup.mesh->copiesOf(t) * length);
    }
    double crooked = 0;
    for (const AlignedBorder &own : border)
        crooked += own.length() - own.most();
    return crooked;
}

double crookedCost(const Soup &soup, const SeamedMap &map, const CutMesh &charts, const Snapshot &snapshot)
{
    if (!snapshot.aligned)
        return 0;
    std::vector<int> sides;
    for (int side = 0; side < soup.mesh->soupCornerCount(); ++side) {
        if (charts.neighbour[side] < 0)
            sides.push_back(side);
    }
    return alignmentCost *
           crookedBorder(soup, *snapshot.aligned, sides, charts.chart, charts.chartCount, map.x);
}

} // namespace autocuts
