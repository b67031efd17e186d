// What the mesh doctor counts, as selections.
#pragma once

#include "model/document/selection.h"

namespace autocuts {

class Document;

enum class Finding {
    BoundaryEdges,
    NonManifoldEdges,     //!< with three faces or more
    WindingEdges,         //!< between faces that look to different sides
    TrianglesWithoutArea, //!< on the model
    PolygonsThatMeetThemselves,
    MostStretched, //!< the face of the triangle with the largest distortion
    FacesWithoutUv,
    CollapsedTriangles, //!< without area in the map
    MirroredIslands
};

//! The elements; empty when there are none.
Selection elementsOf(const Document &document, Finding finding);

} // namespace autocuts
