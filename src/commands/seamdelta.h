// Changes of seams in journals, in a form that does not depend on the numbering of the mesh.
#pragma once

#include "commands/xordelta.h"
#include "model/document/document.h"

namespace autocuts {

//! Writes a delta over corner pairs as "sides": a delta over polygon sides, each named by the corner at which
//! it starts, that is by its face and its number in the face. \pre it touches no diagonals
void writeSeamDelta(QCborMap &map, const XorDelta &delta, const MeshData &mesh);

//! The delta over corner pairs. What version 1 of the project files wrote, a delta over the numbers of corner
//! pairs, is read as well where the mesh still has those numbers, and fails elsewhere.
XorDelta readSeamDelta(CborReader &reader, int elementSize, const Document &document);

} // namespace autocuts
