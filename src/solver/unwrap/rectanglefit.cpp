#include "solver/unwrap/rectanglefit.h"

#include "solver/base/cornerat.h"
#include "solver/base/cutmesh.h"
#include "solver/search/anchoring.h"
#include "solver/search/trianglekernel.h"

namespace autocuts::unwrap {

namespace {

// Newton steps. Chosen by hand: of 30 about half the time goes into the last few percent; five take a quarter
// of a second for one chart of 20,000 triangles.
constexpr int fullSteps = 30;
constexpr int quickSteps = 5;
//! Most mean symmetric Dirichlet energy of a chart that was deformed: about a quarter longer here and shorter
//! there.
constexpr double mostDistortion = 4.5;

} // namespace

bool fitToRectangles(const FreePart &part, const std::shared_ptr<const Soup> &soup, SeamedMap &map,
                     const JobContext &job, FitEffort effort)
{
    const std::vector<UvRectangle> &rectangles = part.snapshot().steering->rectangles;
    if (rectangles.empty())
        return false;
    const CutMesh charts(*soup->mesh, map.cut);
    const std::vector<bool> pinned = heldCharts(part.withoutRectangles(), charts);
    std::vector<bool> fits(charts.chartCount, true);
    Snapshot boxed = part.withoutRectangles();
    Steering &steering = boxed.editSteering();
    steering.pins.clear();
    std::vector<UvRectangle> &boxes = steering.rectangles;
    for (const UvRectangle &rectangle : rectangles) {
        std::vector<std::vector<int>> cornersOf(charts.chartCount);
        for (const int corner : rectangle.soupCorners)
            cornersOf[charts.chart[corner / 3]].push_back(corner);
        for (int chart = 0; chart < charts.chartCount; ++chart) {
            if (cornersOf[chart].empty() || (!pinned.empty() && pinned[chart]) || !fits[chart] ||
                search::fitsInto(map.x, cornersOf[chart], rectangle.lower, rectangle.upper))
                continue;
            fits[chart] = false;
            boxes.push_back(rectangle);
            boxes.back().soupCorners = std::move(cornersOf[chart]);
        }
    }
    if (boxes.empty())
        return false;
    const std::optional<SeamedMap> fitted = search::fittedToBoxes(
        search::SeamGraph::build(soup, boxed), map, effort == FitEffort::Full ? fullSteps : quickSteps, job);
    if (!fitted)
        return true;
    std::vector<double> energy(charts.chartCount, 0), area(charts.chartCount, 0);
    for (int t = 0; t < soup->triangleCount(); ++t) {
        const int chart = charts.chart[t];
        energy[chart] +=
            soup->weight[t] * search::triangleEnergy(&fitted->x[6 * std::size_t(t)], soup->basis[t]);
        area[chart] += soup->weight[t];
    }
    for (int c = 0; c < 3 * soup->triangleCount(); ++c) {
        const int chart = charts.chart[c / 3];
        if (!fits[chart] && energy[chart] <= mostDistortion * area[chart])
            cornerAt(map.x, c) = cornerAt(fitted->x, c);
    }
    return true;
}

} // namespace autocuts::unwrap
