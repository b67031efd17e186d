#include "solver/unwrap/separatejob.h"

#include "solver/metrics/uvoverlaps.h"
#include "solver/overlap/uvseparation.h"
#include "solver/unwrap/freepart.h"

namespace autocuts::unwrap {

namespace {

//! Share of the progress that is for finding the cuts. A guess that only the progress depends on.
constexpr double cuttingShare = 0.1;

bool hasOverlaps(const Snapshot &snapshot)
{
    metrics::UvOverlapOptions options;
    options.faceFlags = snapshot.steering->faceFlags;
    options.maxPairs = 1;
    return !metrics::findUvOverlaps(*snapshot.mesh, *snapshot.uv, options).pairs.empty();
}

} // namespace

SeparateResult separateMap(const Snapshot &snapshot, const PackJob &pack, const JobContext &job,
                           overlap::SeparationMethod method)
{
    const MeshData &mesh = *snapshot.mesh;
    SeparateResult result;
    result.uv = *snapshot.uv;
    const std::optional<FreePart> part = FreePart::of(snapshot);
    if (!part) {
        result.outcome = SeparateResult::Outcome::NothingFree;
        return result;
    }
    const overlap::Separated separated =
        overlap::separateUv(part->snapshot(), *part->snapshot().uv, job.quiet(), method);
    result.newSeams = separated.newSeams;
    result.unresolvedPairs = separated.unresolvedPairs;
    if (!separated.complete)
        result.outcome = SeparateResult::Outcome::Stopped;
    else if (separated.newSeams == 0 && !hasOverlaps(snapshot))
        result.outcome = SeparateResult::Outcome::NoOverlaps;
    else {
        // The map may be of any kind: what is flat in it by chance is not to decide.
        PackJob own = pack;
        own.density = packing::DensityBasis::Area;
        if (!packCharts(mesh, part->wholeCharts(separated.charts), own, result.uv,
                        job.part(cuttingShare, 1, JobStage::Packing)))
            result.outcome =
                job.stopped() ? SeparateResult::Outcome::Stopped : SeparateResult::Outcome::NoRoom;
    }
    return result;
}

} // namespace autocuts::unwrap
