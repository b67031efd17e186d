// Maps of one island with more and less of its chains straight.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/straight/borderchains.h"
#include "solver/straight/linenewton.h"

namespace autocuts::straight {

//! A valid map of an island.
struct Level
{
    double energy = 0; //!< see Island::energy()
    double gain = 0;   //!< length of what is straight, on the model, solver units; more where users want it
    Positions position;
};

//! The maps of an island, the first one without any line, then with fewer and fewer of them. Chains near an
//! axis run along it, others are straight in their direction. The chains that cost the most energy for their
//! length are given up first. All maps are free of flips and overlaps.
//! \param most energy above that of the first map that is of use
//! \returns nothing when the island cannot be made symmetric, which the mirror asks for
std::vector<Level> islandLevels(const Island &island, const std::vector<Chain> &chains,
                                const MirrorPoints &mirror, double most, const JobContext &job = {});

} // namespace autocuts::straight
