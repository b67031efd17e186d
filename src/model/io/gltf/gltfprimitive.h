// The triangles and attributes of one primitive.
#pragma once

#include "model/io/gltf/gltfelements.h"

#include <vector>

namespace autocuts {

//! The attributes of a vertex, or of a morph target, by name ("POSITION", ...).
using GltfAttributes = std::map<std::string, GltfElements>;

//! A primitive that consists of triangles.
struct GltfPrimitive
{
    std::size_t vertexCount = 0;
    GltfAttributes attributes;
    std::vector<std::uint32_t> corners; //!< three vertices for each triangle, all below vertexCount
    //! Triangles that name vertices which are not there; they are not in corners.
    std::size_t brokenTriangles = 0;
};

//! True for triangles, strips and fans; false for points and lines.
bool hasTriangles(const Json &primitive);

//! The number of points or lines of a primitive without triangles. \throws GltfError
std::size_t countPointsAndLines(GltfData &data, const Json &primitive);

//! Reads a primitive. Triangles of strips and fans that name a vertex twice are left out: strips are joined
//! by them. \pre hasTriangles(primitive)
//! \throws GltfError, also when the attributes have different numbers of elements
GltfPrimitive readPrimitive(GltfData &data, const Json &primitive);

//! The number of a texture coordinate set, n of "TEXCOORD_n"; -1 for other names and numbers above 7.
int texcoordNumber(const std::string &attribute);

//! "TEXCOORD_n".
std::string texcoordName(int set);

} // namespace autocuts
