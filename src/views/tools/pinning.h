// Which corners a pin tool means, and pins for them.
#pragma once

#include "model/document/constraints.h"
#include "views/canvas/picking.h"

namespace autocuts {

class ToolCanvas;
class Document;

//! Hard pins for corners at their places in the map; the first soup corner of each counts. Corners without
//! UVs are left out. \param soupUv ShownMap::uv()
std::vector<UvPin> pinsAt(const MeshData &mesh, const UvMatrix &soupUv, const QList<int> &corners);
//! Pins for the vertex at a soup corner: in the 3D view for all its corners, in the map for those in that
//! place. While triangles are apart those that are nearly there are brought there.
std::vector<UvPin> pinsOfVertex(const Document &document, const ToolCanvas &canvas, int soupCorner);
//! Pins for all corners of the islands that these faces belong to.
std::vector<UvPin> pinsOfIslands(const Document &document, const UvMatrix &soupUv, const QList<int> &faces);
//! The pins that are dragged together with one: those of the same vertex in the same place.
std::vector<UvPin> pinsWith(const Document &document, const UvPin &pin);

} // namespace autocuts
