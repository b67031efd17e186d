// Selections as the Select menu makes them. Plain functions of the document; all results are strictly rising.
#pragma once

#include "model/document/selection.h"

#include <QList>

namespace autocuts {

class Document;

//! The faces of the selection: those selected, and those at selected edges and corners.
QList<int> facesOf(const Document &document, const Selection &selection);
//! The corners of the selection: those selected, all corners at the ends of selected edges, those of selected
//! faces.
QList<int> cornersOf(const Document &document, const Selection &selection);
//! These faces as a selection of the mode: faces themselves, their edges or their corners.
Selection selectionOf(const Document &document, const QList<int> &faces, SelectionMode mode);

Selection everything(const Document &document, SelectionMode mode);
//! What the mode selects and the selection has not.
Selection inverted(const Document &document, const Selection &selection);
//! The loops through the selected edges, as a selection of edges.
Selection loopsOf(const Document &document, const Selection &selection);
//! Faces of all islands that are copies of those with these faces.
QList<int> facesOfSimilarIslands(const Document &document, const QList<int> &faces);
//! Faces with a triangle that is turned over against the rest of its island.
QList<int> flippedFaces(const Document &document);

//! Edges to cut: those selected, or the outline of the selected faces.
QList<int> edgesToCut(const Document &document, const Selection &selection);
//! Edges to join: those selected, or those between selected faces.
QList<int> edgesToJoin(const Document &document, const Selection &selection);
//! Edges to leave to the solver: those selected, or all of the selected faces.
QList<int> edgesToClear(const Document &document, const Selection &selection);

} // namespace autocuts
