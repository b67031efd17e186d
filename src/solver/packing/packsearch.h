// The search for the largest scale: combines bottom-left packing, compaction and guided local search.
#pragma once

#include "solver/base/random.h"
#include "solver/packing/bottomleft.h"

#include <cstdint>
#include <optional>

namespace autocuts::packing {

class Separation;

//! One search from one seed. Keeps the best layout that has passed the exact test.
class PackSearch
{
public:
    //! \param start a valid layout; scale 0 when there is none
    //! \param ceiling largest scale that is tried; infinite: no limit
    PackSearch(const PackProblem &problem, Layout start, double ceiling, std::uint64_t seed);

    //! Searches for larger layouts until the effort (counted CPU seconds) is used up or the ceiling is
    //! reached.
    void run(WorkMeter &work, double effort);

    const Layout &best() const { return mBest; }

private:
    //! The movable islands, large ones first by a random measure of size. \param noise of the sizes; 0: none
    std::vector<int> randomOrder(double noise);
    //! A valid layout at this scale by bottom-left packing, or nothing. \param first the order without noise
    std::optional<Layout> construct(BottomLeft &packer, double scale, bool first, WorkMeter &work);
    //! Tries scales guess * ladderStep^k: brackets the largest one that works, then tries the next one with
    //! random orders. \param budget counted CPU seconds
    void climbLadder(BottomLeft &packer, double guess, double budget, WorkMeter &work);
    //! Resolves shallow overlaps by compaction, at a smaller scale if necessary, but above the best one so
    //! far.
    std::optional<Layout> pushApart(const Layout &layout, WorkMeter &work) const;
    //! Searches for a valid layout near one with overlaps: guided local search, then pushApart().
    std::optional<Layout> separate(Separation &separation, const Layout &layout, WorkMeter &work);
    //! Enlarges the best layout a little, separates its overlaps and compacts it, again and again.
    void separateAndGrow(WorkMeter &work);
    void accept(const Layout &layout);
    bool atCeiling() const { return mBest.scale >= mCeiling; }

    const PackProblem &mProblem;
    Layout mBest;
    double mCeiling;
    std::vector<int> mMovable;
    Random mRandom;
};

//! The scale at which the islands, grown by half the gutter, cover this share of the bin left by locked
//! islands.
double scaleForCover(const PackProblem &problem, double cover);

} // namespace autocuts::packing
