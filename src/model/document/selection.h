// The selection. Changing it is not an edit: it adds no undo entry and does not modify the file.
#pragma once

#include "model/plain/meshdata.h"

#include <QList>
#include <QString>

#include <vector>

namespace autocuts {

//! The kind of element that a click selects.
enum class SelectionMode { Vertices, Edges, Faces, Islands };

//! The selected elements. The lists share their storage when copied. The three lists are independent: each
//! tool uses those that it works on. Islands are selected by their faces.
struct Selection
{
    SelectionMode mode = SelectionMode::Faces;
    QList<int> faces;   //!< strictly ascending
    QList<int> edges;   //!< edge numbers of MeshAdjacency, strictly ascending, no diagonals
    QList<int> corners; //!< polygon corners, strictly ascending; a vertex is selected by its corners

    bool isEmpty() const { return faces.isEmpty() && edges.isEmpty() && corners.isEmpty(); }
    //! Sorts the lists and removes duplicates, diagonals and elements that do not exist.
    void normalize(const MeshData &mesh);
    //! Removes hidden faces, their corners, and edges all faces of which are hidden.
    //! \param hidden per face; empty: none is hidden
    void removeHidden(const MeshData &mesh, const std::vector<bool> &hidden);
    //! Returns an empty string, or the first invariant that does not hold.
    QString validate(const MeshData &mesh) const;

    bool operator==(const Selection &) const = default;
};

} // namespace autocuts
