// A minimal OBJ reader for tests of the mesh itself: `v` and `f` lines only, everything in one object.
#pragma once

#include "support/meshbuilders.h"

#include <string>

namespace autocuts::test {

//! The mesh of an OBJ file; null when the file cannot be opened. \pre a well-formed file
MeshPtr readObjPolygons(const std::string &path);

} // namespace autocuts::test
