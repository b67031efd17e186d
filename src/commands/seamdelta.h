// Stores changes of seams in journals, independently of how the mesh numbers its edges.
#pragma once

#include "commands/xordelta.h"
#include "model/document/document.h"

namespace autocuts {

//! Writes a delta over corner pairs as "sides": a delta over polygon sides. The corner at which a side starts
//! names it, and with it the face and the number of the side in the face.
//! \pre the delta has no diagonals
void writeSeamDelta(QCborMap &map, const XorDelta &delta, const MeshData &mesh);

//! Reads a delta over corner pairs. Version 1 of the project files stored the numbers of corner pairs instead
//! of sides; that is read where the mesh still has the same numbers, and fails elsewhere.
XorDelta readSeamDelta(CborReader &reader, int elementSize, const Document &document);

} // namespace autocuts
