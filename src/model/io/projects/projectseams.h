// Stores seams in a form that does not depend on how polygons are triangulated.
#pragma once

#include "model/document/cborvalues.h"
#include "model/document/seams.h"

namespace autocuts {

//! Stores the edges that are cut, joined or painted, as "sides", "states" and "weights" with two numbers per
//! edge each.
QCborMap seamsToCbor(const Seams &seams, const MeshData &mesh);

//! Reads the seams; false when a value is out of range, and then the seams are unchanged.
//! \param[in,out] seams all free on entry
//! \param[out] lost number of edges that this mesh does not have
bool readSeams(CborReader &reader, const MeshData &mesh, Seams &seams, int &lost);

} // namespace autocuts
