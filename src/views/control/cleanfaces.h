// Parts of the map that do not cover themselves, for the tools.
#pragma once

#include <QList>

namespace autocuts {

class Document;
class ShownMap;

//! The faces of the largest region around a triangle that nowhere covers itself in the map shown (paper,
//! figure 9), in rising order; empty when the triangle has no UVs.
QList<int> cleanFaces(const Document &document, const ShownMap &shownMap, int triangle);

} // namespace autocuts
