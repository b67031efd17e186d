// The user's decisions about edges: seams, painted weights, and what is kept straight.
#pragma once

#include "model/plain/snapshot.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace autocuts {

//! Weight of a corner pair that was not painted.
inline constexpr double unpaintedWeight = 1;
//! Largest painted weight; keeps the energy within the range of doubles.
inline constexpr double maxPaintedWeight = 1e6;

//! The user's decisions on every corner pair, numbered as in MeshData (2 * edge pair + end). The diagonals
//! inside polygons always stay without decisions: seams run along polygon sides only.
struct Seams
{
    std::vector<PairState> states;
    //! Factor on the separation energy; values below 1 attract seams, values above 1 repel them.
    std::vector<double> weights;
    //! 1 where the edge is to lie on a line of the map, else 0; the same at both ends of an edge.
    std::vector<std::uint8_t> straight;

    //! All pairs free and unpainted, none kept straight.
    static Seams allFree(const MeshData &mesh);

    //! True when both corner pairs of the edge pair have this state.
    bool edgeIs(int edgePair, PairState state) const
    {
        return states[2 * edgePair] == state && states[2 * edgePair + 1] == state;
    }

    //! Returns an empty string, or the first invariant that does not hold.
    QString validate(const MeshData &mesh) const;

    bool operator==(const Seams &) const = default;
};

} // namespace autocuts
