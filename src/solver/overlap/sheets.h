// The two layers of a chart that lie over each other.
#pragma once

#include "solver/overlap/unitgraph.h"

#include <utility>
#include <vector>

namespace autocuts::overlap {

//! Overlapping pairs of units that belong together: walking from one pair to the next moves to a neighbour
//! on one layer, on the other, or on both. All first units form one layer, all second units the other; no
//! unit is in both (where the layers run into each other, as in a spiral, several of these cover them).
using Sheets = std::vector<std::pair<int, int>>;

//! Finds all sheets among units of one label.
class SheetFinder
{
public:
    explicit SheetFinder(const UnitGraph &graph);

    //! \param part label of each unit
    //! \param members the units with the label
    std::vector<Sheets> find(const std::vector<int> &part, const std::vector<int> &members);

private:
    Sheets grow(const std::vector<int> &part, int first, int second);
    bool take(int first, int second);

    const UnitGraph &mGraph;
    std::vector<bool> mTaken;     //!< per entry of the conflict lists
    std::vector<int> mFirstLayer; //!< last sheets that each unit was in, as a first or as a second unit
    std::vector<int> mSecondLayer;
    int mCurrent = 0;
};

} // namespace autocuts::overlap
