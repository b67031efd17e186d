// Matches the faces of two versions of a model. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts {

//! For the faces and corners of the old mesh, their counterparts in the new one; -1 for none. No face of the
//! new mesh is the counterpart of two faces.
struct FaceMatch
{
    bool sameTopology = false; //!< the faces have the same vertex numbers in the same order
    std::vector<int> face, corner;

    static FaceMatch none(const MeshData &before);
    //! The number of faces that have counterparts.
    int count() const;
};

//! Positions closer than this share of the largest coordinate are equal: text files often have six digits.
inline constexpr double equalPositions = 2e-6;

//! Finds counterparts: faces with the same corners in the same winding at the same positions, whatever their
//! numbers.
FaceMatch matchFacesInPlace(const MeshData &before, const MeshData &after, double tolerance = equalPositions);
//! Finds the counterparts by numbers where all faces have the same vertices, else in place.
//! \param tolerance as equalPositions
FaceMatch matchFaces(const MeshData &before, const MeshData &after, double tolerance = equalPositions);
//! Finds counterparts wherever they lie: faces with the same vertex numbers in the same winding.
FaceMatch matchFacesByNumbers(const MeshData &before, const MeshData &after);

} // namespace autocuts
