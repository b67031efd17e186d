// Charts and boundary of a map after a small change of its seams.
#pragma once

#include "solver/search/cutstate.h"

#include <span>
#include <vector>

namespace autocuts::search {

//! Does what CutState::updateTopology() does, at a cost that grows with the change, and with the smaller of
//! the pieces that a chart falls into or that are joined, instead of with the mesh. Sums of lengths and areas
//! are updated, so that they may differ from those by rounding errors. Buffers are reused; use one per
//! thread.
class TopologyUpdate
{
public:
    //! \pre the flags of the state are set as after the change; all else is as before it
    //! \param opened,closed edge pairs whose flags differ from those before
    void update(CutState &state, std::span<const int> opened, std::span<const int> closed);
    //! True when the last update divided a chart.
    bool hasSplit() const { return mHasSplit; }

private:
    //! A part of a chart that is being searched.
    struct Front
    {
        std::vector<int> triangles; //!< reached so far
        std::size_t next = 0;       //!< the first one whose neighbours have not been looked at
        bool isDone() const { return next == triangles.size(); }
    };

    void updateBoundary(CutState &state, std::span<const int> opened, std::span<const int> closed);
    void splitCharts(CutState &state, std::span<const int> opened);
    void splitChart(CutState &state, std::span<const int> seeds);
    void joinCharts(CutState &state, int a, int b);
    void numberCharts(CutState &state);
    int addFront(int triangle);
    int frontOf(int triangle);
    void advance(const CutState &state, int front);
    void merge(int a, int b);
    void beginSearch();

    std::vector<int> mSides, mMerged; //!< scratch
    std::vector<Front> mFronts;
    std::vector<int> mParent;           //!< per front: one that it has been merged into; itself
    std::vector<int> mSearch, mReached; //!< per triangle: the last search that reached it, and its front
    int mSearches = 0;
    int mFrontsLeft = 0; //!< that have not been merged into others
    bool mChartsChanged = false, mHasSplit = false;
};

} // namespace autocuts::search
