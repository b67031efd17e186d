// Faces that are like the selected ones, for the Select menu.
#pragma once

#include <QList>

namespace autocuts {

class Document;

//! In what faces may be alike.
enum class FaceLikeness {
    Area,     //!< 3D areas that differ by at most a tenth
    Normal,   //!< normals that differ by at most 10 degrees
    Material, //!< the same material, or none
    Corners,  //!< the same number of corners
    Shape, //!< sides and angles, at any size, turned or mirrored, that differ by at most a tenth, 10 degrees
    AreaInMap //!< areas in the map that differ by at most a tenth
};

//! The faces that are like at least one of the given faces, and the given faces; strictly ascending.
//! \param faces strictly ascending
QList<int> similarFaces(const Document &document, const QList<int> &faces, FaceLikeness likeness);

} // namespace autocuts
