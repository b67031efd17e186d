#include "solver/unwrap/coarsemaps.h"

#include <utility>

namespace autocuts::unwrap {

void CoarseMaps::put(MakeCarriedMap make, bool atOnce)
{
    const std::lock_guard lock(mMutex);
    mNext = std::move(make);
    if (atOnce)
        mRest = {};
    mChanged.notify_all();
}

void CoarseMaps::end()
{
    const std::lock_guard lock(mMutex);
    mEnded = true;
    mChanged.notify_all();
}

bool CoarseMaps::waitsOrEnds()
{
    const std::lock_guard lock(mMutex);
    return mNext || mEnded;
}

MakeCarriedMap CoarseMaps::next()
{
    std::unique_lock lock(mMutex);
    while (!mEnded) {
        if (!mNext)
            mChanged.wait(lock);
        else if (Clock::now() < mRest)
            mChanged.wait_until(lock, mRest);
        else
            return std::exchange(mNext, nullptr);
    }
    return nullptr;
}

void CoarseMaps::restUntil(Clock::time_point time)
{
    const std::lock_guard lock(mMutex);
    mRest = time;
}

} // namespace autocuts::unwrap
