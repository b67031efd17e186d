// What each seam of a map is worth: the distortion without it, and the length that it costs.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"

#include <optional>
#include <vector>

namespace autocuts::unwrap {

//! A seam of the map or a proposed one: a chain of edges between two places where seams end or meet.
struct SeamPrice
{
    std::vector<int> edges; //!< edge pairs
    double length = 0;      //!< what the seams get shorter without it, or longer with it; solver units
    //! Mean symmetric Dirichlet energy of the map without it, or with a proposed one. Nothing: it cannot be
    //! closed, because a chart would not be a disk, or would turn triangles over or lie on itself, or only in
    //! exchange for longer seams elsewhere.
    std::optional<double> distortion;
};

struct SeamPrices
{
    double distortion = 0; //!< of the map as it is
    //! Where the user gives seams (SeamMode), these; else all. The cheapest to drop comes first: the least
    //! distortion per length.
    std::vector<SeamPrice> seams;
    std::optional<SeamPrice> proposal; //!< the best new seam that was found
    bool hasMap = true;                //!< false: there is no map without flipped triangles
};

//! Prices the seams of the snapshot's map. Every price is measured: the seam is closed and the map relaxed.
//! When stopped, the prices so far. \pre the snapshot has a map
[[nodiscard]] SeamPrices priceSeams(const Snapshot &snapshot, const JobContext &job = {});

} // namespace autocuts::unwrap
