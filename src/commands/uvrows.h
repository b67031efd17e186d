// Rows of UV matrices as elements of an XorDelta.
#pragma once

#include "commands/xordelta.h"
#include "model/document/document.h"

namespace autocuts {

inline constexpr int uvRowSize = 2 * sizeof(double);
//! Largest scale of a UV set, and largest coordinate, that a journal may hold.
inline constexpr double maxUvScale = 1e12;

//! From one layout to another. \pre both have the same number of rows
XorDelta uvDelta(const UvMatrix &from, const UvMatrix &to);
//! The other version's rows, for the delta's indices only.
UvMatrix toggledRows(const XorDelta &delta, const UvMatrix &current);
//! Reads a delta that is written in the order of the corners by vertex; fails when it would give coordinates
//! that no layout has, which shows that it belongs to another state.
XorDelta readUvDelta(CborReader &reader, const Document &document, const UvMatrix &current);

} // namespace autocuts
