#include "solver/unwrap/readyresult.h"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace autocuts::unwrap {

namespace {

//! The thread rests for this many times as long as it has worked. Chosen by hand.
constexpr int restShare = 3;

} // namespace

ReadyResult::ReadyResult(const Ranking &ranking, Place place, MakeMap first)
    : mRanking(ranking), mPlace(std::move(place)), mThread([this, first = std::move(first)] { run(first); })
{}

ReadyResult::~ReadyResult()
{
    {
        const std::scoped_lock lock(mMutex);
        mEnds = true;
    }
    mChanged.notify_all();
    mThread.join();
}

void ReadyResult::prepare(MakeMap make)
{
    {
        const std::scoped_lock lock(mMutex);
        mNext = std::move(make);
    }
    mChanged.notify_all();
}

UnwrapResult ReadyResult::take()
{
    std::unique_lock lock(mMutex);
    mChanged.wait(lock, [this] { return mResult || mFailure; });
    if (!mResult)
        std::rethrow_exception(mFailure);
    return *mResult;
}

void ReadyResult::run(const MakeMap &first)
{
    using Clock = std::chrono::steady_clock;
    MakeMap make = first;
    while (true) {
        const auto begin = Clock::now();
        try {
            makeResult(make);
        } catch (...) {
            const std::scoped_lock lock(mMutex);
            mFailure = std::current_exception();
        }
        std::unique_lock lock(mMutex);
        mChanged.notify_all();
        // Patches are for want of anything else.
        if (!mMeasures || !mMeasures->onlyPatches)
            mChanged.wait_until(lock, Clock::now() + restShare * (Clock::now() - begin),
                                [this] { return mEnds.load(); });
        mChanged.wait(lock, [this] { return mEnds || mNext; });
        if (mEnds)
            return;
        make = std::exchange(mNext, {});
    }
}

void ReadyResult::makeResult(const MakeMap &make)
{
    const JobContext job(&mEnds);
    std::optional<Candidate> candidate = make(job);
    if (!candidate)
        return;
    Candidate measures = *candidate;
    measures.map = {};
    const auto isBetter = [&] {
        if (!mMeasures)
            return true;
        if (mMeasures->onlyPatches != measures.onlyPatches)
            return mMeasures->onlyPatches;
        return mRanking.better(measures, *mMeasures);
    };
    {
        const std::scoped_lock lock(mMutex);
        if (!isBetter())
            return;
    }
    UnwrapResult result = mPlace(std::move(*candidate), job);
    if (mEnds)
        return;
    const std::scoped_lock lock(mMutex);
    mMeasures = std::move(measures);
    mResult = std::move(result);
}

} // namespace autocuts::unwrap
