#include "solver/unwrap/packjob.h"

#include "model/plain/rigidpieces.h"
#include "solver/packing/packmap.h"

#include <algorithm>

namespace autocuts::unwrap {

bool packCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                const JobContext &job)
{
    std::vector<IslandFlags> flags = pack.faceFlags;
    flags.resize(mesh.faceCount());
    const RigidPieces rigid = rigidPieces(charts, flags, pack.movable);
    if (packing::packMap(mesh, rigid.pieces, rigid.locked, pack.options, uv, job).complete)
        return true;
    if (!job.stopped() || !pack.hurryWhenStopped)
        return false;
    packing::PackOptions hurried = pack.options;
    hurried.effort = std::min(hurried.effort, packing::hurriedEffort);
    return packing::packMap(mesh, rigid.pieces, rigid.locked, hurried, uv, job.unstoppable()).complete;
}

} // namespace autocuts::unwrap
