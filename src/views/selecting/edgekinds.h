// Edges of one kind, for the Select menu. All results are strictly ascending.
#pragma once

#include <QList>

namespace autocuts {

class Document;

//! The edges at which the model is bent by more than an angle. \param degrees between the normals of the two
//! faces, in [0, 180]
QList<int> sharpEdges(const Document &document, double degrees);
//! The edges with one face only.
QList<int> borderEdges(const Document &document);
//! The edges at which two faces with UVs are apart in the map.
QList<int> seamEdges(const Document &document);
//! The edges with these faces on one side only. \param faces strictly ascending
QList<int> outlineEdges(const Document &document, const QList<int> &faces);

} // namespace autocuts
