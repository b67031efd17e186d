#include "solver/unwrap/lightmapjob.h"

namespace autocuts::unwrap {

SeparateResult makeLightmap(const Snapshot &snapshot, const packing::PackOptions &options,
                            const JobContext &job)
{
    using Outcome = SeparateResult::Outcome;
    Snapshot map;
    map.mesh = snapshot.mesh;
    map.uv = snapshot.uv;
    map.uvScale = snapshot.uvScale;
    const PackJob pack = steeredPackJob(map, options);
    SeparateResult result = separateMap(map, pack, job);
    if (result.outcome != Outcome::NoOverlaps)
        return result;
    // The gutters may be too narrow, and the sizes differ.
    const bool packed = packCharts(*map.mesh, findCharts(*map.mesh, result.uv), pack, result.uv,
                                   job.part(0, 1, JobStage::Packing));
    result.outcome = packed ? Outcome::Done : job.stopped() ? Outcome::Stopped : Outcome::NoRoom;
    return result;
}

} // namespace autocuts::unwrap
