// The coordinates that a model is drawn in: about its own centre and of size 1.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! Drawing works in single precision; relative to the mesh's own centre and size it stays exact for meshes of
//! any scale and far from the origin.
struct MeshFrame
{
    Vec3 centre = Vec3::Zero();
    double radius = 1; //!< of a ball around the centre that holds all faces, units of the mesh
    Vec3 lower = -Vec3::Ones(), upper = Vec3::Ones(); //!< box of the faces, in the frame

    static MeshFrame of(const MeshData &mesh);

    //! From the units of the mesh into the frame.
    Vec3 toFrame(const Vec3 &position) const { return (position - centre) / radius; }
};

} // namespace autocuts
