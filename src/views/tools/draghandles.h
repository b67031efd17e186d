// Finds the soup corners that a drag in the map moves.
#pragma once

#include "views/canvas/picking.h"

#include <vector>

namespace autocuts {

class Document;
class ShownMap;
class ToolCanvas;

//! The soup corners that a drag moves, ascending, by the selection mode: a vertex with all its corners at
//! that position, both ends of an edge, a polygon or a whole island. When the element under the mouse is
//! selected, those of the whole selection. Empty when nothing is under the mouse.
std::vector<int> dragHandles(const Document &document, const ToolCanvas &view, const ShownMap &map,
                             const PickResult &pick);

} // namespace autocuts
