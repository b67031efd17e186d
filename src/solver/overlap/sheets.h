// Finds the two layers of a part that overlap each other.
#pragma once

#include "solver/overlap/unitgraph.h"

#include <utility>
#include <vector>

namespace autocuts::overlap {

//! A connected set of overlapping pairs of units: neighbouring pairs differ by a step to a neighbouring unit
//! on one layer or on both. All first units form one layer, all second units the other; no unit is in both.
//! Where two layers are connected to each other, as in a spiral, several Sheets are needed to hold all pairs.
using Sheets = std::vector<std::pair<int, int>>;

//! Finds all sheets among the units of one part.
class SheetFinder
{
public:
    explicit SheetFinder(const UnitGraph &graph);

    //! \param part the part of each unit
    //! \param members the units of one part
    std::vector<Sheets> find(const std::vector<int> &part, const std::vector<int> &members);

private:
    Sheets grow(const std::vector<int> &part, int first, int second);
    bool take(int first, int second);

    const UnitGraph &mGraph;
    std::vector<bool> mTaken;     //!< per entry of the conflict lists
    std::vector<int> mFirstLayer; //!< number of the last sheets with the unit in the first (second) layer
    std::vector<int> mSecondLayer;
    int mCurrent = 0;
};

} // namespace autocuts::overlap
