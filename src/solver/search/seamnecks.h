// Cuts through islands that let more of their border run along the axes.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/cutstate.h"

#include <vector>

namespace autocuts::search {

//! A path of edges through an island, between two points of its border.
struct Neck
{
    std::vector<int> edges; //!< edge pairs
    //! What is saved, in cost, when each part is turned by itself: the border that then runs along the axes,
    //! less the cost of the edges. That the edges become border too is not counted.
    double gain = 0;
};

//! The necks along a boundary loop that are worth their seam, best first, at most one for each point at which
//! the border turns inwards. Arms of vehicles and machines that unfold at odd angles have such necks.
//! \param loop triangle sides of the loop, in order
std::vector<Neck> necksOf(const CutState &state, const std::vector<int> &loop, const JobContext &job = {});

} // namespace autocuts::search
