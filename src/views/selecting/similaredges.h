// Edges that are like the selected ones, and faces that are flat together, for the Select menu. All results
// are strictly ascending.
#pragma once

#include <QList>

namespace autocuts {

class Document;

//! In what edges may be alike.
enum class EdgeLikeness {
    Length,        //!< lengths on the model that differ by at most a tenth
    LengthInMap,   //!< the same in the map; at a seam the length of either side counts
    DirectionInMap //!< directions in the map that differ by at most 10 degrees
};

//! The edges that are like at least one of the given edges, and the given edges. \param edges strictly
//! ascending
QList<int> similarEdges(const Document &document, const QList<int> &edges, EdgeLikeness likeness);

//! The faces that can be reached from the given faces over edges at which the model is bent by no more than
//! an angle. \param degrees between the normals of the two faces
QList<int> flatFaces(const Document &document, const QList<int> &faces, double degrees);

} // namespace autocuts
