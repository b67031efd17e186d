// What a pick means for the selection.
#pragma once

#include "model/document/selection.h"
#include "views/canvas/picking.h"

#include <QList>

namespace autocuts {

class ToolCanvas;
class Document;

//! How elements are joined to what is selected.
enum class Combine { Replace, Add, Subtract, Toggle };

//! The elements of the selection's mode that a pick stands for, in the lists of a selection. A vertex of the
//! model is all its corners; in the map only those in that place.
Selection pickedElements(const Document &document, const ToolCanvas &canvas, const PickResult &pick);
//! The same for a box. Islands are taken when one of their faces is in it.
Selection pickedElements(const Document &document, const BoxPick &box);
//! What a double click stands for: the loop of an edge, the island of a face, the connected part of an
//! island.
Selection pickedGroup(const Document &document, const ToolCanvas &canvas, const PickResult &pick);
//! The edges of the shortest way between two edges, both included; empty when there is none.
QList<int> pathBetweenEdges(const Document &document, int from, int to);
//! The corners of all vertices on the shortest way between those of two corners; empty when there is none.
QList<int> pathBetweenCorners(const Document &document, int from, int to);

//! \param elements in the list of current.mode. Replacing also empties the other lists.
Selection combined(const Selection &current, const Selection &elements, Combine combine);

} // namespace autocuts
