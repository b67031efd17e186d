// The definite map of a live solve: valid at every moment, and better all the time.
#pragma once

#include "solver/search/seamrun.h"
#include "solver/unwrap/bestlivemap.h"
#include "solver/unwrap/liveproblem.h"
#include "solver/unwrap/unwrapquality.h"

#include <memory>
#include <optional>

namespace autocuts::unwrap {

//! Finds a first map as fast as possible and improves it by the seam search, for as long as something is
//! gained. Other steering is taken up by a local change of the map. For use by one thread.
class LiveMap
{
public:
    explicit LiveMap(BestLiveMap::Sink sink) : mBest(mProblem, std::move(sink)) {}

    //! Begins with the map of the snapshot when that starts from existing UVs, else with none.
    void begin(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options);
    //! Takes other steering or settings for the same mesh.
    //! \param pulled the user drags the map: it follows, but seams are not searched
    //! \param back a map to return to first; null: none
    void steer(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options, bool pulled = false,
               std::shared_ptr<const LiveMapResult> back = nullptr);
    //! The same state of the document has another token.
    void setToken(const StateToken &token) { mBest.setToken(token); }
    //! Goes on. \returns true when nothing is left to gain, false when stopped
    //! \throws std::runtime_error when nothing may change
    bool work(const JobContext &job);

private:
    enum class Stage { Begin, Steer, Explore, Improve, Done };
    void takeOver(const LiveMapOptions &options);
    void updateProblem(const JobContext &job);
    bool startFromMap(const UvMatrix &uv, const JobContext &job, bool given = false);
    void steerMap(const JobContext &job);
    void findFirst(const JobContext &job);
    std::optional<search::CutState> makeQuickMap(const JobContext &job);
    void explore(const JobContext &job);
    void exploreSoup(const JobContext &job);
    void improve(const JobContext &job);
    void findStanding(const JobContext &job);
    bool hasAlikeParts(const JobContext &job);
    void findByUnwrap(UnwrapQuality quality, std::optional<search::CutState> quick, const JobContext &job);
    void take(const SeamedMap &map, const JobContext &job);
    void take(const search::CutState &state, const JobContext &job);
    search::OptimizeOptions searchOptions(const JobContext &job);

    std::shared_ptr<const Snapshot> mSnapshot; //!< the newest one
    LiveMapOptions mOptions;
    double mMaxDistortion = 0;                  //!< as given; that of mOptions is FreePart::boundBeside()
    std::shared_ptr<const LiveMapResult> mBack; //!< the map to return to
    bool mFromMap = false;                      //!< it began with the map of the snapshot
    bool mPulled = false;                       //!< the user drags the map
    bool mExplored = false;                     //!< many first cuts have been searched, or the user has a map
    Stage mStage = Stage::Done;
    std::uint64_t mSeed = 0;
    int mIdleRounds = 0; //!< rounds in a row without a noteworthy gain
    //! Other first cuts were tried because no search from the map met the bound.
    bool mBegunAnew = false;

    LiveProblem mProblem; //!< of mSnapshot, once a stage has begun
    BestLiveMap mBest;
};

} // namespace autocuts::unwrap
