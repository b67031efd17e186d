// Selections for the Select menu and edges for the UV menu, as functions of the document. All results are
// strictly ascending.
#pragma once

#include "model/document/selection.h"

#include <QList>

namespace autocuts {

class Document;

//! The selected faces, and the faces of selected edges and corners.
QList<int> facesOf(const Document &document, const Selection &selection);
//! The selected corners, the corners at the ends of selected edges, and the corners of selected faces.
QList<int> cornersOf(const Document &document, const Selection &selection);
//! The given faces as a selection of the mode: the faces themselves, their edges or their corners.
Selection selectionOf(const Document &document, const QList<int> &faces, SelectionMode mode);

Selection everything(const Document &document, SelectionMode mode);
//! All elements of the current mode that are not selected.
Selection inverted(const Document &document, const Selection &selection);
//! The edge loops through the selected edges.
Selection loopsOf(const Document &document, const Selection &selection);
//! The faces of all islands that are copies of the islands of these faces.
QList<int> facesOfSimilarIslands(const Document &document, const QList<int> &faces);
//! The faces with a triangle that is flipped relative to its island.
QList<int> flippedFaces(const Document &document);

//! The edges to cut: the selected edges, or the outline of the selected faces.
QList<int> edgesToCut(const Document &document, const Selection &selection);
//! The edges to join: the selected edges, or the edges between selected faces.
QList<int> edgesToJoin(const Document &document, const Selection &selection);
//! The edges to free: the selected edges, or all edges of the selected faces.
QList<int> edgesToClear(const Document &document, const Selection &selection);

} // namespace autocuts
