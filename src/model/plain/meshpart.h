// A part of a mesh as a mesh of its own. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <memory>
#include <vector>

namespace autocuts {

//! Some faces of a mesh as a mesh of their own. Faces, triangles and edge pairs keep their order. An edge
//! that leads out of the part is on its border.
struct MeshPart
{
    std::shared_ptr<const MeshData> mesh;
    std::vector<int> face;     //!< per face of the part: the face of the whole mesh
    std::vector<int> corner;   //!< per corner
    std::vector<int> triangle; //!< per triangle; soup corners correspond too: 3 * triangle + k
    std::vector<int> edgePair; //!< per edge pair

    int soupCornerOf(int soupCorner) const { return 3 * triangle[soupCorner / 3] + soupCorner % 3; }
};

//! \param faces per face of the mesh: true when it belongs to the part \pre one at least
MeshPart partOf(const MeshData &mesh, const std::vector<bool> &faces);

} // namespace autocuts
