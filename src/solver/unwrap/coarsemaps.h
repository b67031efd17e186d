// Hands maps of a coarse mesh from the thread that finds them to the one that carries them over.
#pragma once

#include "solver/unwrap/coarsetofine.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace autocuts::unwrap {

//! Holds the newest map only. For two threads.
class CoarseMaps
{
public:
    using Clock = std::chrono::steady_clock;

    //! Ends the hand-over when the finder leaves its work, also by an exception.
    class Finder
    {
    public:
        explicit Finder(CoarseMaps &maps) : mMaps(maps) {}
        ~Finder() { mMaps.end(); }
        Finder(const Finder &) = delete;
        Finder &operator=(const Finder &) = delete;

    private:
        CoarseMaps &mMaps;
    };

    //! \param atOnce the carrier's rest is over
    void put(MakeCarriedMap make, bool atOnce);
    void end();

    //! True when there is a map, or will be none.
    bool waitsOrEnds();
    //! Waits for a map. \returns nothing at the end
    MakeCarriedMap next();
    //! The carrier rests: next() hands nothing out until then.
    void restUntil(Clock::time_point time);
    //! Stops carrying at the end.
    JobContext carrying() const { return &mEnded; }

private:
    std::mutex mMutex; //!< for what follows
    std::condition_variable mChanged;
    MakeCarriedMap mNext; //!< empty: none
    Clock::time_point mRest;
    std::atomic<bool> mEnded = false;
};

} // namespace autocuts::unwrap
