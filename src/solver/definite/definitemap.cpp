#include "solver/definite/definitemap.h"

#include "solver/base/cornerat.h"
#include "solver/definite/chartjoining.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/unfolding.h"
#include "solver/overlap/uvseparation.h"
#include "solver/packing/islandgeometry.h"

#include <algorithm>
#include <vector>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

constexpr double densityReserve = 0.01; // share of the distortion above 4
constexpr int joinWork = 500'000;       // tries times triangles

//! Relaxes a map. Unless overlaps are allowed, the map stays as it was when every relaxation makes a chart
//! overlap itself.
void relaxAsAllowed(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                    const DefiniteMapOptions &options, SeamedMap &map, const JobContext &job)
{
    SeamedMap relaxed = map;
    relaxMap(soup, snapshot, relaxed, options.relaxSteps, job);
    if (!options.allowOverlaps && coversItself(*soup, relaxed)) {
        // Relaxing freely made a chart overlap itself; the barrier prevents that but is slower.
        relaxed = map;
        relaxWithoutOverlaps(soup, snapshot, relaxed, options.relaxSteps, job);
        if (coversItself(*soup, relaxed))
            return;
    }
    map = std::move(relaxed);
}

//! Joins charts and zips seams as long as the bound allows it.
void shortenSeams(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                  const DefiniteMapOptions &options, SeamedMap &map, const JobContext &job)
{
    JoinOptions joining;
    // Giving all charts the same texel density at the end costs a little distortion.
    joining.maxDistortion = options.maxDistortion - densityReserve * (options.maxDistortion - 4);
    joining.costPerLength = options.costPerLength;
    joining.allowOverlaps = options.allowOverlaps;
    // The time of a try is proportional to the size of the mesh.
    joining.tries = std::clamp(joinWork / soup->triangleCount(), 10, 300);
    joining.job = job;
    for (int round = 0; round < options.joinRounds && !job.stopped(); ++round) {
        const int closed = joinCharts(soup, snapshot, map, joining) + zipSeams(soup, snapshot, map, joining);
        if (closed == 0)
            break;
        relaxAsAllowed(soup, snapshot, options, map, job);
    }
}

} // namespace

std::optional<DefiniteMap> makeDefiniteMap(const homotopy::Solver &solver, const DefiniteMapOptions &options,
                                           const JobContext &job)
{
    const std::shared_ptr<const Soup> soup = solver.sharedSoup();
    const Snapshot &snapshot = solver.snapshot();
    DefiniteMap result;
    result.map = stitchSoup(soup, snapshot, solver.coordinates(), job);
    relaxMap(soup, snapshot, result.map, options.relaxSteps, job);
    if (!options.allowOverlaps) {
        if (!removeOverlaps(*soup, snapshot, result.map, job))
            return std::nullopt;
        relaxAsAllowed(soup, snapshot, options, result.map, job);
    }
    result.seedDistortion = result.map.distortion(*soup);
    shortenSeams(soup, snapshot, options, result.map, job);
    equalizeDensity(*soup, snapshot, result.map);
    if (job.stopped())
        return std::nullopt;
    return result;
}

void equalizeDensity(const Soup &soup, const Snapshot &snapshot, SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    UvMatrix uv = cornerUv(soup, map);
    const CutMesh state(mesh, map.cut);
    packing::equalizeTexelDensity(mesh, chartsOf(mesh, state), uv, heldCharts(snapshot, state),
                                  packing::DensityBasis::FlatParts);
    for (int c = 0; c < mesh.soupCornerCount(); ++c)
        cornerAt(map.x, c) = uv.row(mesh.cornerOfSoup(c)).transpose();
}

bool removeOverlaps(const Soup &soup, const Snapshot &snapshot, SeamedMap &map, const JobContext &job)
{
    overlap::SeparationResult result = overlap::separateSteered(snapshot, rowsOf(map.x), map.cut, job);
    if (!result.complete)
        return false;
    map.cut = std::move(result.cut);
    if (result.unresolvedPairs > 0)
        unfoldUnits(soup, snapshot, map, job);
    return true;
}

} // namespace autocuts::definite
