// Splits charts between overlapping layers along short seams.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/overlap/maxflow.h"
#include "solver/overlap/sheets.h"
#include "solver/overlap/unitgraph.h"

#include <cstdint>
#include <map>
#include <vector>

namespace autocuts::overlap {

//! Splits the units of one part until no two overlapping units are in the same part, each time along the
//! minimum cut between the two layers of an overlap.
class MinCutSplitter
{
public:
    //! \param capacity per link of the graph, cost of cutting it, at least 1
    //! \param part the part of each unit, changed by split()
    //! \param nextPart the first unused part
    MinCutSplitter(const UnitGraph &graph, const std::vector<std::int64_t> &capacity, std::vector<int> &part,
                   int &nextPart, const JobContext &job);

    //! \return parts that still hold overlaps: none, unless cancelled or the chart has so many separate
    //! overlaps that cutting them one by one would take too long
    std::vector<int> split(int label);

private:
    MaxFlow flowOf(int label);
    std::int64_t perimeterBound(const Sheets &sheets) const;
    void cutBetween(const Sheets &sheets, MaxFlow &flow, std::vector<int> &touched);
    void cutLabel(int label, const Sheets &sheets, MaxFlow &flow, std::vector<int> &touched);
    bool exhausted(const MaxFlow &flow) const;

    const UnitGraph &mGraph;
    const std::vector<std::int64_t> &mCapacity;
    std::vector<int> &mPart;
    int &mNextPart;
    JobContext mJob;
    SheetFinder mFinder;
    std::vector<int> mUnits;                  //!< of the part that split() was called with
    std::vector<int> mLocal;                  //!< index of each unit in that list
    std::map<int, std::vector<int>> mMembers; //!< units of each part being split
};

} // namespace autocuts::overlap
