// Identifies the state of a document from which a snapshot, a job or a result was made.
#pragma once

#include <cstdint>

namespace autocuts {

//! Identifies a state of a document. Whatever is made from a document for later use, on another thread in
//! particular, carries the token of that state. Before a result is used, the revisions that matter for it are
//! compared with those of the document. Revisions are unique among all documents of the process.
struct StateToken
{
    std::uint64_t topology = 0; //!< the mesh, the list of UV sets and which one is active
    std::uint64_t uv = 0;       //!< the UVs and their scale
    std::uint64_t steering = 0; //!< seams, pins, rectangles, texel weights and the settings of the solver
    std::uint64_t layout = 0;   //!< island flags, tags, names of rectangles and the settings of the packer

    //! True when the UV map is the same in both states, so that a result made from one may replace the map of
    //! the other.
    bool sameMap(const StateToken &other) const { return topology == other.topology && uv == other.uv; }

    bool operator==(const StateToken &) const = default;
};

} // namespace autocuts
