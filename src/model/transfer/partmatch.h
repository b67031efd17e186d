// Matches whole parts of two versions of a model, wherever they lie. Plain: no Qt.
#pragma once

#include "model/transfer/facematch.h"

namespace autocuts {

//! Adds counterparts for the connected components of which less than half has one: components of the new
//! mesh, not matched either, that have the same polygons in the same order, whatever their vertex numbers and
//! their place. Among several, the first one of the same shape in another size or direction is taken. Without
//! such a one, the part may have been deformed: the one whose shape differs least is taken, but only for
//! parts of at least `facesToRecognise` faces, as many models have small parts with equal polygons.
void matchParts(const MeshData &before, const MeshData &after, FaceMatch &match);

inline constexpr int facesToRecognise = 12;

} // namespace autocuts
