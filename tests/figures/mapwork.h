// What the figures of maps do in the studio, and what they measure.
#pragma once

#include "figures/picturesheet.h"
#include "figures/studiopictures.h"
#include "model/document/scene.h"

namespace autocuts::figures {

//! The scene with the map of the live solver alone, as it is stitched: islands may cover themselves.
Scene withSoupMap(Scene scene, double lambda);

//! The scene with the map of a quick search that may leave overlaps.
Scene withOverlaps(Scene scene);

//! Numbers of a map that the paper's text speaks of.
struct MapNumbers
{
    double distortion = 0, seamLength = 0;
    int islands = 0, singleTriangles = 0; //!< islands; those of one triangle
    qint64 overlaps = 0;                  //!< pairs of triangles
    //! Largest stretch or shrinking of a triangle in any direction, at the scale at which the mean distortion
    //! is least (Sorkine et al. 2002).
    double worstStretch = 0;
};

//! Of the document's map, which must be measured.
MapNumbers numbersOf(StudioPictures &studio);

//! The model above its map, and the numbers below.
Column columnOf(StudioPictures &studio, const QString &title, const Look &look, const QSize &size);

//! Clicks with the region tool on overlaps and drags what is found away, until nothing overlaps.
//! \returns how often; at most `most`
int dragRegionsAway(StudioPictures &studio, int most);

//! Paints all edges that a look shows, as a brush of full strength does: keeps them together.
void keepSeenTogether(Document &document, const Look &look);
//! Paints the edges near the plane through the middle at x = 0, as a brush does that attracts cuts.
void attractCutsToMiddle(Document &document);

//! Share of the length of the map's seams that runs along edges bent by more than 30 degrees.
double shareOnSharpEdges(const Document &document);

//! Parts of a mesh that no edge joins.
int componentsOf(const MeshData &mesh);

} // namespace autocuts::figures
