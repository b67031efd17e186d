// The maps that the ways of cutting find, compared; and the progress they make.
#pragma once

#include "solver/base/seamedmap.h"
#include "solver/unwrap/unwrapoptions.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>

namespace autocuts::unwrap {

//! A map and where it came from.
struct Candidate
{
    SeamedMap map;
    double distortion = 0, seamLength = 0, seamCost = 0, lambda = 0, delta = 0;
    int smallCharts = 0; //!< below CutState::smallestChart and not whole pieces of the mesh

    //! Sets distortion, length, cost and the number of small charts.
    void measure(const Soup &soup, const Snapshot &snapshot);
};

//! Compares candidates and reports progress; shared between threads.
class Ranking
{
public:
    Ranking(const UnwrapOptions &options, const JobContext &job) : mOptions(options), mJob(job) {}

    //! Among those within the bound fewer small charts win, then cheaper seams; lower distortion outside of
    //! it.
    bool better(const Candidate &a, const Candidate &b) const;

    //! Sets how many steps the whole job has.
    void setTotal(int steps);
    void stepDone(int steps);
    //! True when some map has been found.
    bool hasAny() const { return mHasAny; }
    void found(double distortion, double seamLength);
    //! The map is found, and islands are being packed.
    void packing(double fraction);

    //! Share of the progress bar that is for finding the map; the rest is for packing.
    static constexpr double optimizingShare = 0.9;

private:
    const UnwrapOptions &mOptions;
    const JobContext &mJob;
    std::mutex mMutex;
    std::atomic<bool> mHasAny = false;
    int mTotalSteps = 1, mSteps = 0;
    JobProgress mProgress;
};

} // namespace autocuts::unwrap
