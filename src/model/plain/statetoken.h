// Which state of a document something was made from.
#pragma once

#include <cstdint>

namespace autocuts {

//! Names a state of a document. Whatever is made from a document for later use, on another thread above all,
//! carries the token of that state; whoever uses it compares the parts that matter with the document's. No
//! revision is ever given twice, neither to one document nor to two.
struct StateToken
{
    std::uint64_t topology = 0; //!< the mesh, the list of UV sets and which one is active
    std::uint64_t uv = 0;       //!< the UVs and their scale
    std::uint64_t steering = 0; //!< seams, pins, rectangles and the settings of the solver
    std::uint64_t layout = 0;   //!< island flags, tags, names of rectangles and the settings of the packer

    //! True when the map is the same in both states: what was made from one can replace that of the other.
    bool sameMap(const StateToken &other) const { return topology == other.topology && uv == other.uv; }

    bool operator==(const StateToken &) const = default;
};

} // namespace autocuts
