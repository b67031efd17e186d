// The search for the largest scale: constructive layouts, compaction and separation put together.
#pragma once

#include "solver/packing/bottomleft.h"
#include "solver/packing/splitmix.h"

#include <cstdint>
#include <optional>

namespace autocuts {

class Separation;

//! One start of the search. Keeps the best layout that has passed the exact test.
class PackSearch
{
public:
    //! \param start a valid layout, or one of scale 0 when there is none
    PackSearch(const PackProblem &problem, Layout start, std::uint64_t seed);

    //! Looks for larger layouts until the work is used up.
    void maximizeScale(WorkMeter &work, double effort);
    //! Looks for one valid layout at this scale.
    void fitScale(double scale, WorkMeter &work, double effort);

    const Layout &best() const { return mBest; }

private:
    std::vector<int> randomOrder(double noise);
    //! A valid layout at this scale by the constructive step, or nothing.
    std::optional<Layout> construct(BottomLeft &packer, double scale, bool first, WorkMeter &work);
    void climbLadder(BottomLeft &packer, double guess, double budget, WorkMeter &work);
    //! Looks for a valid layout near this one, which may overlap.
    std::optional<Layout> separate(Separation &separation, const Layout &layout, int passes, WorkMeter &work);
    void separateAndGrow(WorkMeter &work);
    bool accept(const Layout &layout);

    const PackProblem &mProblem;
    Layout mBest;
    std::vector<int> mMovable;
    SplitMix mRandom;
};

//! The scale at which the islands, grown by half the gutter, would cover this part of the bin.
double scaleForCover(const PackProblem &problem, double cover);

} // namespace autocuts
