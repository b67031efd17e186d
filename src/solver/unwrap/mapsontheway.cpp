#include "solver/unwrap/mapsontheway.h"

#include <utility>

namespace autocuts::unwrap {

void MapsOnTheWay::put(MakeMap make)
{
    const std::lock_guard lock(mMutex);
    mNext = std::move(make);
    mChanged.notify_all();
}

void MapsOnTheWay::end()
{
    const std::lock_guard lock(mMutex);
    mEnded = true;
    mChanged.notify_all();
}

bool MapsOnTheWay::waitsOrEnds()
{
    const std::lock_guard lock(mMutex);
    return mNext || mEnded;
}

MakeMap MapsOnTheWay::next()
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

void MapsOnTheWay::restUntil(Clock::time_point time)
{
    const std::lock_guard lock(mMutex);
    mRest = time;
}

} // namespace autocuts::unwrap
