// Selecting along the rows of quads: edge rings, strips of faces, every second element, and growing and
// shrinking in the direction of a row only. All results are strictly ascending.
#pragma once

#include "model/document/selection.h"

namespace autocuts {

class Document;

//! The edge rings through the selected edges: from each edge to the opposite one of a quad, and so on.
Selection ringsOf(const Document &document, const Selection &selection);
//! The strips of quads through the selected faces: towards the selected neighbours of a face and away from
//! them; in both directions from a face without any.
Selection stripsOf(const Document &document, const Selection &selection);
//! Of each connected part of the selection, the elements that are an even number of steps from its first one:
//! a checkerboard of faces, every second edge of a loop or a ring, every second vertex. In the mode of
//! islands, every second island.
Selection everySecond(const Document &document, const Selection &selection);
//! Each row of selected elements with the next one at both ends: of faces in strips, of edges or vertices in
//! loops. Islands do not grow.
Selection grownAlong(const Document &document, const Selection &selection);
//! Each row of selected elements without those at its ends, in the sense of grownAlong().
Selection shrunkAlong(const Document &document, const Selection &selection);

} // namespace autocuts
