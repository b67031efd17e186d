// The definite map of a live solve: valid at every moment, and better all the time.
#pragma once

#include "solver/preference/seampreference.h"
#include "solver/search/seamrun.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/liveplacing.h"
#include "solver/unwrap/unmetsteering.h"
#include "solver/unwrap/unwrapquality.h"

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
};

//! A map without flipped triangles or overlaps (but for islands that the user holds in one place).
struct LiveMapResult
{
    StateToken token;      //!< of the snapshot that it obeys
    UvMatrix uv;           //!< per corner, texture space
    CutFlags cut;          //!< per edge pair
    double distortion = 0; //!< mean symmetric Dirichlet energy, 4 is isometric
    double seamLength = 0; //!< seam_norm, solver units
    int islands = 0;
    bool withinBound = false; //!< of what may change
    bool hasRoom = true;      //!< false: there is no room for all islands, some may overlap
    UnmetSteering unmet;
};

//! Finds a first map as fast as possible and improves it by the seam search, for as long as something is
//! gained. Other steering is taken up by a local change of the map. For use by one thread.
class LiveMap
{
public:
    //! Receives every new map, from any thread but one at a time.
    using Sink = std::function<void(std::shared_ptr<const LiveMapResult>)>;

    explicit LiveMap(Sink sink) : mSink(std::move(sink)) {}

    //! Begins with the map of the snapshot when that starts from existing UVs, else with none.
    void begin(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options);
    //! Takes other steering or settings for the same mesh.
    //! \param pulled the user drags the map: it follows, but seams are not searched
    //! \param back a map to return to first; null: none
    void steer(std::shared_ptr<const Snapshot> snapshot, const LiveMapOptions &options, bool pulled = false,
               std::shared_ptr<const LiveMapResult> back = nullptr);
    //! The same state of the document has another token.
    void setToken(const StateToken &token) { mToken = token; }
    //! Goes on. \returns true when nothing is left to gain, false when stopped
    //! \throws std::runtime_error when nothing may change
    bool work(const JobContext &job);

private:
    enum class Stage { Begin, Steer, Explore, Improve, Done };
    //! What decides between two maps; less is better.
    struct Merit
    {
        int anchorFaults = 0;
        bool misses = false; //!< it is above the bound
        double value = 0;    //!< seam cost; above the bound, the distortion

        auto operator<=>(const Merit &) const = default;
    };

    void takeSnapshot(const JobContext &job);
    bool startFromMap(const UvMatrix &uv);
    void steerMap(const JobContext &job);
    void findFirst(const JobContext &job);
    std::optional<search::CutState> makeQuickMap(const JobContext &job);
    void carryFromCoarse(UnwrapQuality quality, std::optional<search::CutState> quick, const JobContext &job);
    bool exploresCoarsely() const;
    void explore(const JobContext &job);
    void improve(const JobContext &job);
    void take(const SeamedMap &map);
    void take(const search::CutState &state);
    search::OptimizeOptions searchOptions(const JobContext &job);
    Merit meritOf(const search::CutState &state) const;
    void offer(const search::CutState &state);
    void publishWaiting(bool atOnce = false);
    bool publish(search::CutState state);

    const Sink mSink;
    std::shared_ptr<const Snapshot> mSnapshot;
    StateToken mToken;
    LiveMapOptions mOptions;
    std::shared_ptr<const LiveMapResult> mBack;
    bool mFromMap = false; //!< it began with the map of the snapshot
    bool mPulled = false;
    bool mExplored = false; //!< many first cuts have been searched, or the user has a map
    Stage mStage = Stage::Done;

    preference::SeamPreference mPreference;
    std::optional<preference::MeshSymmetry> mSymmetry;
    std::optional<FreePart> mPart;
    Snapshot mProblem; //!< of the part, with the seam preferences in its weights
    std::shared_ptr<const Soup> mSoup;
    std::shared_ptr<const search::SeamGraph> mGraph;
    LivePlacing mPlacing;
    std::uint64_t mSeed = 0;
    int mIdleRounds = 0; //!< rounds in a row without a noteworthy gain

    std::mutex mMutex;                     //!< for what follows: the searches of several threads offer maps
    std::optional<search::CutState> mBest; //!< the map that was given out last
    Merit mBestMerit;
    std::shared_ptr<const LiveMapResult> mGiven;
    std::optional<search::CutState> mWaiting; //!< a better map that has not been given out yet
    std::chrono::steady_clock::time_point mNextGiven;
};

} // namespace autocuts::unwrap
