// The search for the largest scale: constructive layouts, compaction and separation put together.
#pragma once

#include "solver/base/random.h"
#include "solver/packing/bottomleft.h"

#include <cstdint>
#include <optional>

namespace autocuts::packing {

class Separation;

//! One start of the search. Keeps the best layout that has passed the exact test.
class PackSearch
{
public:
    //! \param start a valid layout, or one of scale 0 when there is none
    //! \param ceiling no larger scale is tried; infinite when there is no limit
    PackSearch(const PackProblem &problem, Layout start, double ceiling, std::uint64_t seed);

    //! Looks for larger layouts until the effort (CPU seconds) is used up or the ceiling is reached.
    void run(WorkMeter &work, double effort);

    const Layout &best() const { return mBest; }

private:
    std::vector<int> randomOrder(double noise);
    //! A valid layout at this scale by the constructive step, or nothing.
    std::optional<Layout> construct(BottomLeft &packer, double scale, bool first, WorkMeter &work);
    void climbLadder(BottomLeft &packer, double guess, double budget, WorkMeter &work);
    //! Repairs a layout with shallow overlaps; it may give way down to the best scale so far.
    std::optional<Layout> pushApart(const Layout &layout, WorkMeter &work) const;
    //! Looks for a valid layout near this one, which may overlap.
    std::optional<Layout> separate(Separation &separation, const Layout &layout, WorkMeter &work);
    void separateAndGrow(WorkMeter &work);
    void accept(const Layout &layout);
    bool atCeiling() const { return mBest.scale >= mCeiling; }

    const PackProblem &mProblem;
    Layout mBest;
    double mCeiling;
    std::vector<int> mMovable;
    Random mRandom;
};

//! The scale at which the islands, grown by half the gutter, would cover this part of the bin.
double scaleForCover(const PackProblem &problem, double cover);

} // namespace autocuts::packing
