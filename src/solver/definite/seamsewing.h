// Closes seams of a definite map whose two sides lie near each other.
#pragma once

#include "model/plain/chart.h"
#include "solver/base/jobcontext.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::definite {

//! Whether a face may move when a seam is closed.
enum class FaceRole : std::uint8_t {
    Outside, //!< not in the islands at the seam
    Held,    //!< stays; the other side comes to it
    Yields,  //!< stays but for the seam, and gives way near it where that distorts less
    Moves
};

enum class SewOutcome {
    Sewn,
    Folds,  //!< a triangle would be flipped or lose its area
    Covers, //!< the island would overlap itself
    Held,   //!< the two sides are held in different places
    Stopped
};

//! The seams to close. All of them are between faces that are not Outside.
struct Sewing
{
    std::vector<int> edges;     //!< edge pairs
    std::vector<FaceRole> role; //!< per face
    std::vector<bool> pinned;   //!< per corner: it stays
    //! Only where the two sides fit as they are: nothing is relaxed, and the distortion hardly rises. Else
    //! Folds.
    bool asTheyFit = false;
};

//! Brings the two sides of each edge together, bit for bit: at the side that stays or in the middle, where
//! that distorts less. When a triangle would flip or an island would overlap itself, the faces around the
//! seam are relaxed. Overlaps that were there before are no hindrance. \param soup of the mesh \param before
//! the map whose islands these are, one row per corner, and its topology \param uv in: the map with the
//! islands put where they fit, all UV vertices as before; out: the result. Not changed unless Sewn
SewOutcome sewSeams(const Soup &soup, const UvTopology &topology, const UvMatrix &before,
                    const Sewing &sewing, UvMatrix &uv, const JobContext &job = {});

} // namespace autocuts::definite
