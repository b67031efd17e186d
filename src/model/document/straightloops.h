// The edges that are kept straight, as loops.
#pragma once

#include "model/document/document.h"

#include <vector>

namespace autocuts {

//! The edges of Seams::straight as lists of edge pairs, one after the other. At a vertex an edge continues in
//! the one that lies opposite to it within the surface, however the surface is bent; at a corner of the
//! selection a list ends. Each edge is in one list.
std::vector<std::vector<int>> straightLoops(const Document &document);

} // namespace autocuts
