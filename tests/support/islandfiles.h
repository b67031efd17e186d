// Meshes with UVs from OBJ files, for the packer's tests and benchmark.
#pragma once

#include "model/plain/meshdata.h"

#include <memory>
#include <string>
#include <vector>

namespace autocuts::test {

//! What v, vt and f lines say; everything else is ignored.
struct UvMesh
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv; //!< one row per corner
};

//! An empty pointer in mesh when the file cannot be read.
UvMesh readUvMesh(const std::string &path);
//! Writes v, vt (one per corner) and f lines with 17 digits.
bool writeUvMesh(const std::string &path, const UvMesh &data);
//! The OBJ files of ../shared/islands or $AUTOCUTS_ISLANDS, sorted; empty when the folder is absent.
std::vector<std::string> islandFiles();

} // namespace autocuts::test
