#include "solver/unwrap/unwrap.h"

#include "model/plain/uvlayout.h"
#include "solver/definite/seamopening.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/mapfinder.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/rectanglefit.h"

#include <algorithm>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

//! Moves and scales the map into the unit square.
void fitUnitSquare(UvMatrix &uv)
{
    const Eigen::RowVector2d low = uv.colwise().minCoeff();
    const Eigen::RowVector2d high = uv.colwise().maxCoeff();
    const double side = (high - low).maxCoeff();
    uv.rowwise() -= low;
    if (side > 0)
        uv /= side;
}

//! Places the islands of a new map. Sets result.uv and result.packed.
void place(const Snapshot &snapshot, const FreePart &part, const Soup &soup, const SeamedMap &map,
           const UnwrapOptions &options, const JobContext &job, Ranking &ranking, UnwrapResult &result)
{
    const Snapshot &own = part.snapshot();
    // True when some islands are where they belong. Otherwise packing finds the scale.
    const bool stays = !part.isWhole() || snapshot.placesIslands();
    UvMatrix uv = (stays ? own.uvScale : 1) * cornerUv(soup, map);
    definite::openCuts(own, uv);
    result.uv = part.wholeUv(uv);
    if (!options.pack) {
        if (!stays)
            fitUnitSquare(result.uv);
        return;
    }
    const ChartMap charts = part.wholeCharts(chartsOf(*own.mesh, CutMesh(*own.mesh, map.cut)));
    packing::PackOptions settings = options.packing;
    if (options.quality == UnwrapQuality::Draft)
        settings.effort = std::min(settings.effort, packing::hurriedEffort);
    PackJob pack = steeredPackJob(snapshot, settings);
    pack.keepScaleIfPossible = stays;
    pack.hurryWhenStopped = true;
    const JobContext::Sink report = [&](const JobProgress &done) {
        ranking.packing(Ranking::optimizingShare + (1 - Ranking::optimizingShare) * done.fraction);
    };
    result.packed = packCharts(*snapshot.mesh, charts, pack, result.uv, job.watchedBy(report));
    if (!result.packed && !stays)
        fitUnitSquare(result.uv);
}

void checkOptions(const UnwrapOptions &options)
{
    if (!(options.maxDistortion > 4))
        throw std::invalid_argument("the distortion bound must be above 4, the value of an isometry");
    if (options.lambda && !(*options.lambda >= 0 && *options.lambda <= 1))
        throw std::invalid_argument("lambda must be between 0 and 1");
}

} // namespace

UnwrapResult unwrapMesh(const Snapshot &snapshot, const UnwrapOptions &options, const JobContext &job)
{
    checkOptions(options);
    UnwrapResult result;
    const std::optional<FreePart> part = FreePart::of(snapshot);
    if (!part) {
        result.nothingFree = true;
        result.uv = snapshot.uv ? *snapshot.uv : emptyLayout(*snapshot.mesh);
        return result;
    }
    Ranking ranking(options, job);
    FoundMap found = findMap(part->withoutRectangles(), options, ranking, job);
    Candidate &best = found.best;
    result.iterations = found.iterations;
    result.symmetry = found.symmetry;
    result.cut = part->wholeCut(best.map.cut);
    result.distortion = best.distortion;
    result.seamLength = best.seamLength;
    result.onlyPatches = best.onlyPatches;
    result.lambda = best.lambda;
    result.delta = best.delta;
    result.withinBound = options.lambda || snapshot.settings.seams == SeamMode::Only ||
                         best.distortion <= options.maxDistortion;
    const std::shared_ptr<const Soup> soup = Soup::build(part->snapshot().mesh);
    if (options.pack)
        fitToRectangles(*part, soup, best.map);
    place(snapshot, *part, *soup, best.map, options, job, ranking, result);
    result.unmet = unmetSteering(snapshot, result.uv);
    result.stopped = job.stopped();
    return result;
}

} // namespace autocuts::unwrap
