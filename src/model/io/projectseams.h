// Seams in a form that does not depend on how polygons are triangulated.
#pragma once

#include "model/document/cborvalues.h"
#include "model/document/seams.h"

namespace autocuts {

//! The edges that are not free and unpainted: "sides", "states" and "weights", two numbers per edge each.
QCborMap seamsToCbor(const Seams &seams, const MeshData &mesh);

//! False, with the seams unchanged, when a value is out of range.
//! \param[in,out] seams all free
//! \param[out] lost edges that this mesh does not have
bool readSeams(CborReader &reader, const MeshData &mesh, Seams &seams, int &lost);

} // namespace autocuts
