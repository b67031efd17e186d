// Tangent space for normal maps. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

namespace autocuts {

//! The tangent at a corner. The bitangent is sign * cross(normal, direction).
struct Tangent
{
    Eigen::Vector3f direction =
        Eigen::Vector3f::UnitX(); //!< of growing u, unit, at right angles to the normal
    float sign = -1;              //!< 1, or -1 where the map is mirrored
};

//! The tangents of MikkTSpace (Morten Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008), which
//! normal maps of most programs are made for. Triangles and quads count as such, larger polygons as the
//! triangles of the mesh. Corners are the same where object, position, normal and UV are the same in single
//! precision. What is left open there is decided as in Blender: a corner gets the default of Tangent where
//! nothing defines a tangent, as on triangles without area in the map that touch no others; that one need not
//! be at right angles to the normal.
//! \param uv one row per polygon corner; polygons with a UV that is not finite have no area in the map
//! \param normals unit vectors, one per polygon corner, as of shadingNormals()
//! \returns one per soup corner
std::vector<Tangent> mikkTangents(const MeshData &mesh, const UvMatrix &uv,
                                  const std::vector<Eigen::Vector3f> &normals);

} // namespace autocuts
