// Test support: a minimal OBJ parser (v, vt, f), for reading meshes with their UVs into tests.
#pragma once

#include "support/meshbuilders.h"

#include <string>

namespace autocuts::test {

//! A mesh and one UV per corner, non-finite where the file has none.
struct ObjUv
{
    MeshPtr mesh;
    UvMatrix uv;
};

//! Parses text; faces that are out of range or have fewer than three corners are dropped.
ObjUv parseObjUv(const std::string &text);
//! Reads a file; an unreadable one gives an empty mesh.
ObjUv readObjUv(const std::string &path);

//! True for the edge pairs whose UVs differ at one end or both by more than 1e-6 of the UV box.
std::vector<bool> seamsOf(const MeshData &mesh, const UvMatrix &soup);

} // namespace autocuts::test
