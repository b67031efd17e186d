// Makes pins for corners, vertices and islands.
#pragma once

#include "model/document/constraints.h"
#include "views/canvas/picking.h"

namespace autocuts {

class ToolCanvas;
class Document;
class ShownMap;

//! Hard pins for corners at their positions in the map, taken from the first soup corner of each. Corners
//! without UVs are left out. \param soupUv ShownMap::uv()
std::vector<UvPin> pinsAt(const MeshData &mesh, const UvMatrix &soupUv, const QList<int> &corners);
//! Pins for the vertex of a soup corner: in the 3D view for all its corners, in the map for those at the same
//! position. While triangles are separate, corners that are nearly there are included and moved there.
std::vector<UvPin> pinsOfVertex(const Document &document, const ToolCanvas &canvas, int soupCorner);
//! Pins for all corners of the islands of the shown map with these faces.
std::vector<UvPin> pinsOfIslands(const Document &document, const ShownMap &shown, const QList<int> &faces);
//! The pins that are dragged together with one: those of the same vertex at the same position.
std::vector<UvPin> pinsWith(const Document &document, const UvPin &pin);

} // namespace autocuts
