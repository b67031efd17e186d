// Finds triangles of a transferred map that are much worse than the source's, and moves their corners. Plain:
// no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <functional>
#include <vector>

namespace autocuts::transfer {

//! What the source's map does at a face.
struct SourceShape
{
    double areaRatio = 0; //!< UV area per area, negative where the face is to be mirrored; 0: unknown
    double energy = 4;    //!< symmetric Dirichlet energy where the area is kept; 4 is an isometry
};

//! A map while it is transferred. Lengths on the model are those of `positions`.
struct TransferredMap
{
    const MeshData &mesh;
    const PositionMatrix &positions;  //!< per vertex
    const std::vector<bool> &placed;  //!< per face: its corners may be moved
    std::vector<SourceShape> shape;   //!< per face
    UvMatrix uv, continued;           //!< per corner, see FacePlacing
    std::vector<int> root;            //!< per corner: the first of those that are one with it in the map
    std::vector<std::vector<int>> at; //!< per root: these corners

    Vec3 position(int corner) const { return positions.row(mesh.cornerVertex[corner]); }
    int faceOf(int corner) const;
};

enum class Fault { None, Collapsed, TurnedOver };

//! Compares a triangle with the source. Collapsed: it has hardly any area though the source has.
Fault faultOf(const TransferredMap &map, int triangle);

//! Moves the corners of triangles that are turned over or far more distorted than the source: past the border
//! of the source's map, towards their neighbours or a little aside, where that lowers the distortion around
//! them. \param stopped asked often; may be empty
void mendMap(TransferredMap &map, const std::function<bool()> &stopped);

} // namespace autocuts::transfer
