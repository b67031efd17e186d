// Names the edges of a mesh by their two vertices, as modelling programs do.
#pragma once

#include "model/plain/meshdata.h"

#include <array>
#include <vector>

namespace autocuts::link {

//! The two vertices of an edge, the lower number first.
using VertexPair = std::array<int, 2>;

//! The edges between two polygons. Vertices have the numbers of MeshData::positions, without welding: an edge
//! whose sides have different vertices in one place has two names. Sorting takes a moment: not for the GUI
//! thread.
class VertexPairs
{
public:
    explicit VertexPairs(const MeshData &mesh);

    //! The edge pairs with these names, ascending. Names of other edges are left out.
    //! \param names ascending
    std::vector<int> edgePairs(const std::vector<VertexPair> &names) const;
    //! The names of edges, ascending. \param chosen per edge pair
    std::vector<VertexPair> names(const std::vector<bool> &chosen) const;

private:
    struct Entry
    {
        VertexPair name;
        int edgePair;

        auto operator<=>(const Entry &) const = default;
    };
    std::vector<Entry> mEntries; //!< ascending
};

} // namespace autocuts::link
