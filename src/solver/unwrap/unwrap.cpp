#include "solver/unwrap/unwrap.h"

#include "model/plain/uvlayout.h"
#include "solver/definite/seamopening.h"
#include "solver/unwrap/coarsetofine.h"
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
           const UnwrapOptions &options, const JobContext &job, UnwrapResult &result)
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
    result.packed = packCharts(*snapshot.mesh, charts, pack, result.uv, job);
    if (!result.packed && !stays)
        fitUnitSquare(result.uv);
}

//! The result of an unwrap whose map was found.
UnwrapResult resultOf(const Snapshot &snapshot, const FreePart &part, Candidate found,
                      const UnwrapOptions &options, const JobContext &job)
{
    UnwrapResult result;
    result.cut = part.wholeCut(found.map.cut);
    result.distortion = found.distortion;
    result.seamLength = found.seamLength;
    result.onlyPatches = found.onlyPatches;
    result.lambda = found.lambda;
    result.delta = found.delta;
    result.withinBound = options.lambda || snapshot.settings.seams == SeamMode::Only ||
                         found.distortion <= options.maxDistortion;
    const std::shared_ptr<const Soup> soup = Soup::build(part.snapshot().mesh);
    if (options.pack)
        fitToRectangles(part, soup, found.map);
    place(snapshot, part, *soup, found.map, options, job, result);
    result.unmet = unmetSteering(snapshot, result.uv);
    return result;
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
    const Snapshot &problem = part->withoutRectangles();
    Ranking ranking(options, job);
    std::optional<ReadyResult> ready;
    if (suitsCoarseToFine(problem)) {
        UnwrapOptions hurried = options;
        hurried.packing.effort = std::min(hurried.packing.effort, packing::hurriedEffort);
        ready.emplace(
            ranking,
            [&snapshot, &part, hurried](Candidate found, const JobContext &own) {
                return resultOf(snapshot, *part, std::move(found), hurried, own);
            },
            [&problem](const JobContext &) { return patchesOf(problem); });
    }
    FoundMap found = findMap(problem, options, ranking, job, ready ? &*ready : nullptr);
    if (found.onlyReady) {
        result = ready->take();
    } else {
        const JobContext::Sink report = [&](const JobProgress &done) {
            ranking.packing(Ranking::optimizingShare + (1 - Ranking::optimizingShare) * done.fraction);
        };
        ready.reset();
        result = resultOf(snapshot, *part, std::move(found.best), options, job.watchedBy(report));
    }
    result.iterations = found.iterations;
    result.symmetry = found.symmetry;
    result.stopped = job.stopped();
    return result;
}

} // namespace autocuts::unwrap
