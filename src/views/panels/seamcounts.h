// Counts cut, joined and painted edges.
#pragma once

#include "model/document/document.h"

namespace autocuts {

//! Numbers of edges with decisions by the user; diagonals are not counted.
struct SeamCounts
{
    int cut = 0;                          //!< both ends are cut
    int halfCut = 0;                      //!< only one end is cut
    int joined = 0;                       //!< at least one end is joined
    int keptTogether = 0, attracting = 0; //!< painted with a weight above 1, and below 1
    int straight = 0;                     //!< kept straight

    bool operator==(const SeamCounts &) const = default;
};

SeamCounts countSeams(const MeshData &mesh, const Seams &seams);

//! The edge pairs of the given faces in ascending order; boundary sides have none. \param faces ascending
std::vector<int> edgesOfFaces(const Document &document, const QList<int> &faces);

//! The painted weight for a strength in (0, 1]: from 1 to 100 for "Keep together", from 1 to 0 for "Attract
//! cuts".
double keepTogetherWeight(double strength);
double attractCutsWeight(double strength);

} // namespace autocuts
