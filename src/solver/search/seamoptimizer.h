// The automatic cutter: finds short seams within a bound on the distortion.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/search/seamgraph.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace autocuts::search {

//! How much work the search does. Every first map is searched in the first round, the survivors in the
//! second, and so on. The maps of the last round are taken to the bound, and the best one is the result. The
//! plans of the unwrap and their origin are in unwrap/unwrap.cpp.
struct OptimizeEffort
{
    struct Round
    {
        int moves = 0;     //!< large moves tried on each map
        int survivors = 1; //!< number of the most promising maps that enter the next round
    };
    int seeds = 8; //!< number of different first cuts
    std::vector<Round> rounds{{100, 2}, {2000, 1}};
    //! Number of passes at the end in which mu rises to four times its value, to spend what is left of the
    //! bound on shorter seams.
    int squeezes = 10;
    //! While a map is above the bound at the end, mu is multiplied by boundFall again and again, each time
    //! followed by boundMoves large moves. Drafts use 0.5 and 16 because these rounds took most of their
    //! time.
    double boundFall = 0.85;
    int boundMoves = 8;
};

struct OptimizeOptions
{
    double maxDistortion = 4.1; //!< bound on the mean symmetric Dirichlet energy, > 4
    std::optional<double> mu;   //!< instead of the bound: energy that one unit of seam cost is worth
    bool allowOverlaps = false;
    OptimizeEffort effort;
    //! Further maps to start from. Where there are pins or rectangles, they lie in their places.
    std::vector<SeamedMap> given;
    std::uint64_t seed = 1;         //!< of all random numbers
    JobContext job;                 //!< for stopping and threads; progress goes to `start` and `progress`
    std::function<void(int)> start; //!< called once with the number of large moves of the whole job
    //! Called repeatedly from any thread with the number of large moves since the last call, and the
    //! distortion and seam length of the best map of one run.
    std::function<void(int, double, double)> progress;
};

struct OptimizedMap
{
    SeamedMap map;
    double mu = 0;        //!< energy that one unit of seam cost was worth at the end
    int iterations = 0;   //!< Newton steps of all runs, on patches of all sizes
    int anchorFaults = 0; //!< see CutState
};

//! Searches for the shortest seams within the bound. The same arguments give the same bits unless the job is
//! stopped. \returns the best map found, above the bound when no map met it; nothing when no first map
//! without flipped triangles (or without overlaps, where these are not allowed) was found
[[nodiscard]] std::optional<OptimizedMap> optimizeSeams(const std::shared_ptr<const SeamGraph> &graph,
                                                        const OptimizeOptions &options);

} // namespace autocuts::search
