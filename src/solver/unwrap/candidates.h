// Comparison of the maps that an unwrap finds, and its progress.
#pragma once

#include "solver/base/seamedmap.h"
#include "solver/unwrap/unwrapoptions.h"

#include <functional>
#include <mutex>
#include <optional>

namespace autocuts::unwrap {

//! A map with its measures, and the parameters that it was found with.
struct Candidate
{
    SeamedMap map;
    double distortion = 0, seamLength = 0, seamCost = 0, lambda = 0, delta = 0;
    double bounded = 0;   //!< see boundedDistortion()
    int smallCharts = 0;  //!< below CutState::smallestChart() and not whole connected components of the mesh
    int anchorFaults = 0; //!< see search::CutState
    int openJoins = 0;    //!< joined edges that are seams
    bool onlyPatches = false; //!< see flatPatches()
    bool symmetric = false;   //!< found among symmetric cuts

    //! Sets distortion, bounded, seamLength, seamCost, smallCharts and openJoins from the map.
    void measure(const Soup &soup, const Snapshot &snapshot);
};

//! The distortion that the bound is for: where a rigid region has lost its shape, with the stiffness of the
//! regions.
[[nodiscard]] double boundedDistortion(const Soup &soup, const Snapshot &snapshot, const SeamedMap &map);

//! Makes a usable map; nothing when that fails or the job is stopped. May be kept, and called by any thread.
using MakeMap = std::function<std::optional<Candidate>(const JobContext &)>;
//! Takes what makes a usable map of what was found so far: a newer one replaces it. Empty: they are not
//! needed.
using PrepareMap = std::function<void(MakeMap)>;

//! Compares candidates, keeps the best one and reports the progress of an unwrap. May be used by several
//! threads at once.
class Ranking
{
public:
    Ranking(const UnwrapOptions &options, const JobContext &job) : mOptions(options), mJob(job) {}

    //! True when a is better than b. Fewer faults at the anchors win, then fewer open joins; a map within the
    //! bound is better than one above it. Within the bound cheaper seams win, small charts being counted as
    //! some seam; above it lower distortion wins. With a given lambda, the lower objective wins.
    bool better(const Candidate &a, const Candidate &b) const;

    //! The searches that begin are a part of all, from one share to another.
    void setPart(double begin, double end)
    {
        mBegin = begin;
        mEnd = end;
    }
    //! Sets the number of steps of the search that begins; the reported progress never goes back.
    void setTotal(int steps);
    //! Reports that so many further steps are done.
    void stepDone(int steps);
    //! Keeps the map when it is the best so far, for a job that is stopped. Stores its measures for the next
    //! report. \param measures its map is not looked at \param mapOf returns the map
    template <typename MapOf>
    void offer(Candidate measures, MapOf mapOf)
    {
        const std::scoped_lock lock(mMutex);
        if (mBest && !better(measures, *mBest))
            return;
        measures.map = mapOf();
        mBest = std::move(measures);
        noteFound(mBest->distortion, mReported ? mReported(*mBest) : mBest->seamLength);
        if (mWatcher)
            mWatcher(*mBest);
    }
    //! Also shows every map that is the best so far to the callback, one at a time.
    void setWatcher(std::function<void(const Candidate &)> watcher) { mWatcher = std::move(watcher); }
    //! The seam length to report of the best map, where that stands for a larger one.
    void setReported(std::function<double(const Candidate &)> seamLength)
    {
        mReported = std::move(seamLength);
    }
    //! The best map that was offered; nothing when there was none.
    std::optional<Candidate> best() const
    {
        const std::scoped_lock lock(mMutex);
        return mBest;
    }
    //! Reports progress while the islands are packed. \param fraction of the whole job
    void packing(double fraction);

    //! Share of the progress that is for finding the map; the rest is for packing. A guess that only the
    //! progress depends on.
    static constexpr double optimizingShare = 0.9;

private:
    void noteFound(double distortion, double seamLength);

    const UnwrapOptions &mOptions;
    const JobContext &mJob;
    mutable std::mutex mMutex;
    std::function<void(const Candidate &)> mWatcher;
    std::function<double(const Candidate &)> mReported;
    std::optional<Candidate> mBest;
    int mTotalSteps = 1, mSteps = 0;
    double mBegin = 0, mEnd = 1; //!< shares of all searches
    JobProgress mProgress;
};

} // namespace autocuts::unwrap
