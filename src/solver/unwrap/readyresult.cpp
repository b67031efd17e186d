#include "solver/unwrap/readyresult.h"

#include <algorithm>
#include <utility>

namespace autocuts::unwrap {

namespace {

//! The thread rests for this many times as long as it has worked: where somebody watches, and where results
//! are only for a stop. Chosen by hand.
constexpr int restWatched = 10, restForStop = 30;
//! Where the last map was made in less time than the first, the newest is made after a stop, in the second at
//! most. By hand.
constexpr auto moment = std::chrono::milliseconds(80), longestWait = std::chrono::milliseconds(150);
//! The same where nothing but patches is ready; a map that is being made is waited for then, too. The longest
//! wait is for machines under load.
constexpr auto momentForAny = std::chrono::milliseconds(200), longestForAny = std::chrono::milliseconds(500);
constexpr double rounding = 1e-9;

} // namespace

ReadyResult::ReadyResult(const Ranking &ranking, Place place, MakeMap first, Watch watch,
                         std::chrono::milliseconds firstRest)
    : mRanking(ranking), mPlace(std::move(place)), mWatch(std::move(watch)), mFirstRest(firstRest),
      mThread([this, first = std::move(first)](const std::stop_token &) { run(first); })
{}

ReadyResult::~ReadyResult()
{
    {
        const std::scoped_lock lock(mMutex);
        mEnds = true;
    }
    mChanged.notify_all();
}

void ReadyResult::prepare(MakeMap make)
{
    {
        const std::scoped_lock lock(mMutex);
        mNext = std::move(make);
    }
    mChanged.notify_all();
}

bool ReadyResult::isAsGoodAs(const Candidate &other)
{
    const std::scoped_lock lock(mMutex);
    return !isBetter(other);
}

UnwrapResult ReadyResult::take()
{
    std::unique_lock lock(mMutex);
    mChanged.wait(lock, [this] { return mResult || mFailure; });
    if (!mResult)
        std::rethrow_exception(mFailure);
    const bool isAny = mMeasures->onlyPatches;
    if ((mNext || (isAny && mMakes)) && mLastWork <= (isAny ? momentForAny : moment)) {
        mHurries = true;
        mChanged.notify_all();
        mChanged.wait_for(lock, isAny ? longestForAny : longestWait, [this] { return !mHurries; });
    }
    return *mResult;
}

void ReadyResult::run(const MakeMap &first)
{
    using Clock = std::chrono::steady_clock;
    MakeMap make = first;
    const int restShare = mWatch ? restWatched : restForStop;
    const auto start = Clock::now();
    while (true) {
        const auto begin = Clock::now();
        try {
            makeResult(make);
        } catch (...) {
            const std::scoped_lock lock(mMutex);
            mFailure = std::current_exception();
        }
        std::unique_lock lock(mMutex);
        const auto now = Clock::now();
        mLastWork = now - begin;
        mMakes = false;
        mHurries = mHurries && mNext;
        mChanged.notify_all();
        auto next = start + mFirstRest;
        // A map that is only flat patches is a fallback: it is replaced without a rest.
        if (!mMeasures || !mMeasures->onlyPatches)
            next = std::max(next, now + restShare * (now - begin));
        mChanged.wait_until(lock, next, [this] { return mEnds || mHurries; });
        mChanged.wait(lock, [this] { return mEnds || mNext; });
        if (mEnds)
            return;
        make = std::exchange(mNext, {});
        mMakes = true;
    }
}

//! True when the candidate is better than the present result. \pre the mutex is locked
bool ReadyResult::isBetter(const Candidate &candidate) const
{
    if (!mMeasures)
        return true;
    // A map that is only flat patches is a fallback, unless it is as good, as it is for loose triangles.
    if (mMeasures->onlyPatches && !candidate.onlyPatches)
        return candidate.seamCost < mMeasures->seamCost ||
               candidate.distortion < (1 - rounding) * mMeasures->distortion;
    if (candidate.onlyPatches && !mMeasures->onlyPatches)
        return false;
    return mRanking.better(candidate, *mMeasures);
}

void ReadyResult::makeResult(const MakeMap &make)
{
    const JobContext job(&mEnds);
    std::optional<Candidate> candidate = make(job);
    if (!candidate)
        return;
    Candidate measures = *candidate;
    measures.map = {};
    {
        const std::scoped_lock lock(mMutex);
        if (!isBetter(measures))
            return;
    }
    UnwrapResult result = mPlace(std::move(*candidate), job);
    if (mEnds)
        return;
    if (mWatch && !result.onlyPatches)
        mWatch(result);
    const std::scoped_lock lock(mMutex);
    mMeasures = std::move(measures);
    mResult = std::move(result);
}

} // namespace autocuts::unwrap
