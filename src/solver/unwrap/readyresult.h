// The result that an unwrap returns at once when it is stopped, and shows while it runs.
#pragma once

#include "model/plain/parallel.h"
#include "solver/unwrap/candidates.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>

namespace autocuts::unwrap {

//! Makes results from the maps that a search finds on its way, in a thread of its own, and keeps the best
//! one. Making one takes long on a large mesh: after a stop there would be no time for it. The thread rests
//! for most of the time, so that the search goes on. On a small mesh, the newest map is made after the stop.
class ReadyResult
{
public:
    //! Places the islands of a map.
    using Place = std::function<UnwrapResult(Candidate, const JobContext &)>;
    //! Sees every better result that is more than patches.
    using Watch = std::function<void(const UnwrapResult &)>;

    //! \param first makes a map at once, and always one
    //! \param firstRest from the start to the second map: a job that ends by then needs none for a stop
    ReadyResult(const Ranking &ranking, Place place, MakeMap first, Watch watch = {},
                std::chrono::milliseconds firstRest = {});
    //! Waits until the thread has left what it does.
    ~ReadyResult();

    //! Any thread may bring a map at any time. It is made unless a newer one comes before its turn.
    void prepare(MakeMap make);
    //! True when there is a result, and its map is no worse than this one.
    bool isAsGoodAs(const Candidate &other);
    //! The best result so far, or of the newest map where that is made in a moment. Waits for the first one;
    //! throws what prevented that.
    UnwrapResult take();

private:
    void run(const MakeMap &first);
    bool isBetter(const Candidate &candidate) const;
    void makeResult(const MakeMap &make);

    const Ranking &mRanking;
    const Place mPlace;
    const Watch mWatch;
    const std::chrono::milliseconds mFirstRest;
    std::atomic<bool> mEnds = false;
    std::mutex mMutex; //!< for what follows
    std::condition_variable mChanged;
    MakeMap mNext;                      //!< empty: none
    std::optional<Candidate> mMeasures; //!< of the result; without the map
    std::optional<UnwrapResult> mResult;
    std::exception_ptr mFailure;                     //!< there is no result because of this
    std::chrono::steady_clock::duration mLastWork{}; //!< how long the last map took to make
    bool mHurries = false;                           //!< somebody waits until mNext is made
    bool mMakes = true;                              //!< a map is being made
    BackgroundThread mThread;                        //!< the last member: it uses the others
};

} // namespace autocuts::unwrap
