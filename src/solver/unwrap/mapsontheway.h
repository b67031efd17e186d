// Hands maps that are found on the way from the thread that searches to the one that makes them usable.
#pragma once

#include "solver/unwrap/candidates.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace autocuts::unwrap {

//! Holds the newest map only. For two threads.
class MapsOnTheWay
{
public:
    using Clock = std::chrono::steady_clock;

    //! Ends the hand-over when the finder leaves its work, also by an exception.
    class Finder
    {
    public:
        explicit Finder(MapsOnTheWay &maps) : mMaps(maps) {}
        ~Finder() { mMaps.end(); }
        Finder(const Finder &) = delete;
        Finder &operator=(const Finder &) = delete;

    private:
        MapsOnTheWay &mMaps;
    };

    void put(MakeMap make);
    void end();

    //! True when there is a map, or will be none.
    bool waitsOrEnds();
    //! Waits for a map. \returns nothing at the end
    MakeMap next();
    //! next() hands nothing out until then.
    void restUntil(Clock::time_point time);
    //! Stops what is being made at the end.
    JobContext making() const { return &mEnded; }

private:
    std::mutex mMutex; //!< for what follows
    std::condition_variable mChanged;
    MakeMap mNext; //!< empty: none
    Clock::time_point mRest;
    std::atomic<bool> mEnded = false;
};

} // namespace autocuts::unwrap
