// What is selected. Not an edit: changing it adds no undo entry and does not dirty the file.
#pragma once

#include "model/plain/meshdata.h"

#include <QList>
#include <QString>

namespace autocuts {

//! What a click selects.
enum class SelectionMode { Vertices, Edges, Faces, Islands };

//! Selected elements; the lists share their storage when copied. Islands are selected through their faces.
//! The three lists are independent: each tool fills and reads the ones that it works on.
struct Selection
{
    SelectionMode mode = SelectionMode::Faces;
    QList<int> faces;   //!< strictly rising
    QList<int> edges;   //!< edge numbers of MeshAdjacency, strictly rising, no diagonals
    QList<int> corners; //!< polygon corners, strictly rising; a vertex is selected through its corners

    bool isEmpty() const { return faces.isEmpty() && edges.isEmpty() && corners.isEmpty(); }
    //! Sorts the lists and drops what is there twice, does not exist or is a diagonal.
    void normalize(const MeshData &mesh);
    //! Empty when all invariants hold, else the first broken one.
    QString validate(const MeshData &mesh) const;

    bool operator==(const Selection &) const = default;
};

} // namespace autocuts
