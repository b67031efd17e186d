// Numbers of steered and painted edges of a document.
#pragma once

#include "model/document/document.h"

namespace autocuts {

//! How many edges the user has decided about; diagonals never count.
struct SeamCounts
{
    int cut = 0;                          //!< both ends
    int halfCut = 0;                      //!< one end only
    int joined = 0;                       //!< at least one end
    int keptTogether = 0, attracting = 0; //!< painted with a weight above and below 1

    bool operator==(const SeamCounts &) const = default;
};

SeamCounts countSeams(const MeshData &mesh, const Seams &seams);

//! The edge pairs around the given faces, in rising order, without boundary sides. \param faces rising
std::vector<int> edgesOfFaces(const Document &document, const QList<int> &faces);

//! The painted weight for a strength in (0, 1]: "Keep together" goes from 1 to 100, "Attract cuts" from 1 to
//! 0.
double keepTogetherWeight(double strength);
double attractCutsWeight(double strength);

} // namespace autocuts
