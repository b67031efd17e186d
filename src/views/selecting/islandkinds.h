// Islands with figures out of the ordinary, for the Select menu. All results are strictly ascending faces.
#pragma once

#include <QList>

namespace autocuts {

class Document;

//! The faces of the islands whose mean distortion is above a bound, each at the scale that suits it.
QList<int> facesOfStretchedIslands(const Document &document, double bound);
//! The faces of the islands whose boxes have no side as long as this. \param texels at the texture size of
//! the document
QList<int> facesOfSmallIslands(const Document &document, double texels);
//! The faces of the islands whose texel density is off the median by more than a share of it. Half of the
//! area of the model has at most the median density. \param share 0.2 is a fifth less or more
QList<int> facesOffDensity(const Document &document, double share);

} // namespace autocuts
