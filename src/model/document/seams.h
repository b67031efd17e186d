// What the user decided about seams: a state and a painted weight for every corner pair.
#pragma once

#include "model/plain/snapshot.h"

#include <QString>

#include <vector>

namespace autocuts {

//! Painted factor of a corner pair that nobody painted.
inline constexpr double unpaintedWeight = 1;
//! Largest painted factor; keeps the energy within the range of doubles.
inline constexpr double maxPaintedWeight = 1e6;

//! State and weight of every corner pair, numbered as in MeshData (2 * edge pair + end). The diagonals inside
//! polygons always stay free and unpainted: a seam runs along whole sides of polygons only.
struct Seams
{
    std::vector<PairState> states;
    std::vector<double> weights; //!< factor on the separation energy, 0 attracts seams, > 1 repels them

    //! All free and unpainted.
    static Seams allFree(const MeshData &mesh);

    //! True when both ends of the edge pair have this state.
    bool edgeIs(int edgePair, PairState state) const
    {
        return states[2 * edgePair] == state && states[2 * edgePair + 1] == state;
    }

    //! Empty when all invariants hold, else the first broken one.
    QString validate(const MeshData &mesh) const;

    bool operator==(const Seams &) const = default;
};

} // namespace autocuts
