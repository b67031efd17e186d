// Converts picks to selections.
#pragma once

#include "model/document/selection.h"
#include "views/canvas/picking.h"

#include <QList>

namespace autocuts {

class ToolCanvas;
class Document;

//! How elements are combined with the selection.
enum class Combine { Replace, Add, Subtract, Toggle };

//! The elements at a pick for the selection mode. A vertex stands for all its corners on the model, and for
//! the corners at the same position in the map.
Selection pickedElements(const Document &document, const ToolCanvas &canvas, const PickResult &pick);
//! The same for a box. An island is included when one of its faces is.
Selection pickedElements(const Document &document, const BoxPick &box);
//! The elements for a double click: the loop of an edge, the island of a face, the connected component of an
//! island.
Selection pickedGroup(const Document &document, const ToolCanvas &canvas, const PickResult &pick);
//! The edges of the shortest path between two edges, including both; empty when there is none.
QList<int> pathBetweenEdges(const Document &document, int from, int to);
//! The corners of all vertices on the shortest path between the vertices of two corners; empty when there is
//! none.
QList<int> pathBetweenCorners(const Document &document, int from, int to);

//! \param elements in the list of current.mode. Replacing also clears the other lists.
Selection combined(const Selection &current, const Selection &elements, Combine combine);

} // namespace autocuts
