// Uses the rows of UV matrices as elements of an XorDelta.
#pragma once

#include "commands/xordelta.h"
#include "model/document/document.h"

namespace autocuts {

inline constexpr int uvRowSize = 2 * sizeof(double);
//! Largest scale of a UV set and largest coordinate that is accepted from a journal. Chosen by hand.
inline constexpr double maxUvScale = 1e12;

//! The delta from one layout to another. \pre both have the same number of rows
XorDelta uvDelta(const UvMatrix &from, const UvMatrix &to);
//! The rows of the other version, for the delta's indices only.
UvMatrix toggledRows(const XorDelta &delta, const UvMatrix &current);
//! Reads a delta stored in the order of MeshAdjacency::cornersByVertex(). Fails when the new coordinates
//! would exceed maxUvScale, which shows that the delta belongs to another state.
XorDelta readUvDelta(CborReader &reader, const Document &document, const UvMatrix &current);

} // namespace autocuts
