// The best map of a live solve so far, and the giving out of every better one.
#pragma once

#include "solver/packing/packing.h"
#include "solver/search/cutstate.h"
#include "solver/straight/straightening.h"
#include "solver/unwrap/alikeparts.h"
#include "solver/unwrap/liveplacing.h"
#include "solver/unwrap/liveproblem.h"
#include "solver/unwrap/rectanglefit.h"
#include "solver/unwrap/standingmap.h"
#include "solver/unwrap/unmetsteering.h"

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace autocuts::unwrap {

struct LiveMapOptions
{
    double maxDistortion = 4.1; //!< bound on the mean symmetric Dirichlet energy, > 4
    packing::PackOptions packing;
    std::vector<int> dragged{}; //!< soup corners of islands that the user drags, see LivePlacing
};

//! A map without flipped triangles or overlaps (but for islands that the user holds in one place).
struct LiveMapResult
{
    StateToken token;      //!< of the snapshot that it obeys
    UvMatrix uv;           //!< per corner, texture space
    CutFlags cut;          //!< per edge pair
    double distortion = 0; //!< of the whole map: UvMetrics::tileDirichlet, 4 is isometric
    double seamLength = 0; //!< seam_norm, solver units
    int islands = 0;
    double hardShare = 0;     //!< as UnwrapResult::hardShare
    bool withinBound = false; //!< the whole map, or what may change
    bool hasRoom = true;      //!< false: there is no room for all islands, some may overlap
    //! Share of the area that has a mirror image, 0 where it is not symmetric. Set when symmetric seams are
    //! asked for.
    std::optional<double> mirroredArea;
    UnmetSteering unmet;
};

//! Keeps the better of all maps offered to it, and gives it out when nothing is wrong with it.
class BestLiveMap
{
public:
    //! Receives every new map, from any thread but one at a time.
    using Sink = std::function<void(std::shared_ptr<const LiveMapResult>)>;

    BestLiveMap(const LiveProblem &problem, Sink sink) : mProblem(problem), mSink(std::move(sink)) {}

    //! Forgets all maps.
    void reset();
    //! \param maxDistortion bound on the whole map; that of the options is for what may change
    void setOptions(const LiveMapOptions &options, double maxDistortion)
    {
        mOptions = options;
        mMaxDistortion = maxDistortion;
    }
    //! The document's state that the next maps obey.
    void setToken(const StateToken &token)
    {
        mToken = token;
        mAlikeIsKnown = false;
    }
    //! True: all islands of the next maps are packed; false: they stay in place as far as possible.
    void setPacksAfresh(bool on) { mPacksAfresh = on; }
    //! Forgets maps that were offered and not given out yet.
    void forgetWaiting();
    //! The document's map stays as long as no map beats it. \param map see standingMap(); nothing: any map is
    //! better
    void setStanding(std::optional<StandingMap> map)
    {
        const std::lock_guard lock(mMutex);
        mStanding = std::move(map);
    }
    //! Whatever map comes next counts as better than the one before.
    void forgetBest() { mBest.reset(); }
    //! The next map is placed in relation to this one. \param uv per corner of the part, texture space
    void returnTo(const UvMatrix &uv) { mPlacing.returnTo(mProblem.part(), uv); }

    //! Makes a map the best that was given out already.
    void setBest(const search::CutState &state);
    //! Gives a map out once more, as it is.
    void giveAgain(std::shared_ptr<const LiveMapResult> map);

    //! True when parts of the mesh are copies of others, which get the same islands.
    bool hasAlikeParts(const JobContext &job);
    //! The map that was given out last, or nothing when it was forgotten.
    const std::optional<search::CutState> &best() const { return mBest; }
    //! The best map is above the bound.
    bool misses() const { return mBestMerit.misses; }
    //! The last map that was given out, forgotten or not.
    const std::shared_ptr<const LiveMapResult> &given() const { return mGiven; }

    //! Any thread may offer maps at any time.
    void offer(const search::CutState &state);
    //! Gives out the best map that waits. \param atOnce even if the last one was given out a moment ago
    void giveWaiting(const JobContext &job, bool atOnce = false);
    //! Gives the best map out once more with all that the settings ask for made straight; until then islands
    //! are only turned.
    void giveStraight(const JobContext &job);
    //! Gives out the best map that waits at once, fitted to rectangles by a few steps; giveWaiting() fits it
    //! fully.
    void giveQuickly(const JobContext &job);

private:
    //! What decides between two maps; less is better.
    struct Merit
    {
        int anchorFaults = 0;
        bool misses = false; //!< it is above the bound
        double value = 0;    //!< seam cost; above the bound, the distortion

        auto operator<=>(const Merit &) const = default;
        //! True when only the value may differ.
        bool obeysAs(const Merit &other) const
        {
            return anchorFaults == other.anchorFaults && misses == other.misses;
        }
    };

    Merit makeMerit(int anchorFaults, double distortion, double cost) const;
    Merit meritOf(const search::CutState &state) const;
    SeamedMap settled(const search::CutState &state, const JobContext &job) const;
    std::optional<SeamedMap> settledAlike(const search::CutState &state, const JobContext &job);
    const std::optional<AlikeParts> &alikeParts(const JobContext &job);
    SeamedMap alike(SeamedMap map, const JobContext &job);
    bool isBeaten(const SeamedMap &map) const;
    void give(search::CutState state, FitEffort effort, const JobContext &job,
              straight::StraightEffort straightness = straight::StraightEffort::Turn);

    const LiveProblem &mProblem;
    const Sink mSink;
    LiveMapOptions mOptions;
    double mMaxDistortion = 0; //!< of the whole map
    StateToken mToken;
    bool mPacksAfresh = false;

    std::mutex mMutex; //!< for what follows
    LivePlacing mPlacing;
    std::optional<search::CutState> mBest;
    Merit mBestMerit;
    std::optional<StandingMap> mStanding;
    std::optional<AlikeParts> mAlike; //!< of the problem, once it is known
    bool mAlikeIsKnown = false;
    std::shared_ptr<const LiveMapResult> mGiven;
    std::optional<search::CutState> mWaiting;  //!< a better map that has not been given out yet
    std::optional<search::CutState> mUnfitted; //!< the map given out last, when it can be fitted better
    std::chrono::steady_clock::time_point mNextGiven;
};

} // namespace autocuts::unwrap
