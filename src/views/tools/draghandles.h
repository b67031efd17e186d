// What a drag in the map takes hold of.
#pragma once

#include "views/canvas/picking.h"

#include <vector>

namespace autocuts {

class Document;
class ShownMap;
class ToolCanvas;

//! The soup corners that a drag from a pick moves, by the mode of the selection, rising: the vertex at the
//! place with all its corners there, both ends of an edge, a polygon or a whole piece of the map. When what
//! is under the mouse is selected, everything that is selected. Empty when nothing is there.
std::vector<int> dragHandles(const Document &document, const ToolCanvas &view, const ShownMap &map,
                             const PickResult &pick);

} // namespace autocuts
