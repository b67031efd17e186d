// The automatic cutter: from the mesh to short seams at a given distortion.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/search/seamgraph.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace autocuts::search {

//! How much is tried. All starts take part in the first round, its survivors in the second, and so on. Those
//! in the last round are taken to the bound, and the best wins.
struct OptimizeEffort
{
    struct Round
    {
        int moves = 0;     //!< large moves tried on each run
        int survivors = 1; //!< so many of the most promising go on
    };
    int seeds = 8; //!< different first cuts
    std::vector<Round> rounds{{100, 2}, {2000, 1}};
    int squeezes = 10; //!< times that what is left of the bound is spent
    //! Above the bound the worth of seams falls by this factor, time after time, with so many large moves
    //! each.
    double boundFall = 0.85;
    int boundMoves = 8;
};

struct OptimizeOptions
{
    double maxDistortion = 4.1; //!< bound on the mean energy
    std::optional<double> mu;   //!< instead of the bound: energy that one unit of seam is worth
    bool allowOverlaps = false;
    OptimizeEffort effort;
    std::vector<SeamedMap> given; //!< further maps to start from
    std::uint64_t seed = 1;
    JobContext job;                 //!< reports by `start` and `progress` only
    std::function<void(int)> start; //!< called once with the number of steps that the job has
    //! Called now and then from any thread with the number of steps done since, and the distortion and seam
    //! length of some map.
    std::function<void(int, double, double)> progress;
};

struct OptimizedMap
{
    SeamedMap map;
    double mu = 0;      //!< energy that one unit of seam was worth in the end
    int iterations = 0; //!< Newton steps of all runs, on patches of all sizes
};

//! Searches for the shortest seams within the bound. Deterministic unless stopped. \returns the best map
//! found, which may be above the bound when that cannot be met; nothing when no start without a fold was
//! found
[[nodiscard]] std::optional<OptimizedMap> optimizeSeams(const std::shared_ptr<const SeamGraph> &graph,
                                                        const OptimizeOptions &options);

} // namespace autocuts::search
