#include "views/gl/meshframe.h"

#include <Eigen/Geometry>

namespace autocuts {

MeshFrame MeshFrame::of(const MeshData &mesh)
{
    Eigen::AlignedBox3d box;
    for (int vertex : mesh.cornerVertex)
        box.extend(Vec3(mesh.positions.row(vertex)));
    MeshFrame frame;
    if (box.isEmpty())
        return frame;
    frame.centre = 0.5 * box.min() + 0.5 * box.max();
    frame.radius = (0.5 * box.max() - 0.5 * box.min()).stableNorm();
    if (!(frame.radius > 0))
        frame.radius = 1;
    frame.lower = frame.toFrame(box.min());
    frame.upper = frame.toFrame(box.max());
    return frame;
}

} // namespace autocuts
