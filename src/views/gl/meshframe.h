// The mesh frame: coordinates in which the model has its centre at the origin and size 1.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! Drawing uses single precision. In the mesh frame that is accurate for meshes of any size and position.
struct MeshFrame
{
    Vec3 centre = Vec3::Zero();
    //! In units of the mesh; a sphere of this radius around the centre contains all faces.
    double radius = 1;
    Vec3 lower = -Vec3::Ones(), upper = Vec3::Ones(); //!< bounding box of the faces, in the mesh frame

    static MeshFrame of(const MeshData &mesh);

    //! Converts a position from units of the mesh to the mesh frame.
    Vec3 toFrame(const Vec3 &position) const { return (position - centre) / radius; }
};

} // namespace autocuts
