// Which faces of two versions of a model are the same. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! The counterparts in the new mesh of the old one's faces and corners, -1 for none. At most one old face has
//! a given counterpart.
struct FaceMatch
{
    bool sameTopology = false; //!< the faces have the same vertex numbers in the same order
    std::vector<int> face, corner;
};

//! \see relinkDocument()
FaceMatch matchFaces(const MeshData &before, const MeshData &after);

} // namespace autocuts
