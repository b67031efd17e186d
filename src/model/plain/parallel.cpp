#include "model/plain/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace autocuts {

void parallelFor(int count, int threads, const std::function<void(int)> &job)
{
    std::vector<std::exception_ptr> errors(count);
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int i = next++; i < count; i = next++) {
            try {
                job(i);
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < std::min(threads, count); ++i)
            helpers.emplace_back(work);
        work();
    }
    for (const std::exception_ptr &error : errors) {
        if (error)
            std::rethrow_exception(error);
    }
}

void parallelRanges(int count, const std::function<void(int first, int end)> &job)
{
    constexpr int rangeSize = 16384; // some hundred microseconds, more than a thread costs; chosen by hand
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    parallelFor((count + rangeSize - 1) / rangeSize, cores,
                [&](int i) { job(i * rangeSize, std::min(count, (i + 1) * rangeSize)); });
}

namespace {

//! How often a waiting thread polls a value before it sleeps: about fifty microseconds. What a step does
//! between two of its loops seldom takes longer, and waking a thread does. Chosen by hand; no measurement of
//! its effect is recorded.
constexpr int glances = 40000;

template <class T>
void waitWhile(const std::atomic<T> &value, T old)
{
    for (int i = 0; i < glances; ++i) {
        if (value.load(std::memory_order_acquire) != old)
            return;
    }
    value.wait(old, std::memory_order_acquire);
}

} // namespace

ThreadTeam::ThreadTeam(int threads) : mShares(std::max(1, threads))
{
    for (int i = 1; i < threads; ++i)
        mHelpers.emplace_back([this, i] { help(i); });
}

ThreadTeam::~ThreadTeam()
{
    mQuit = true;
    ++mRound;
    mRound.notify_all();
    for (std::thread &helper : mHelpers)
        helper.join();
}

void ThreadTeam::share(int count, const std::function<void(int)> &job)
{
    mJob = &job;
    mErrorJob = count;
    for (int i = 0; i < threads(); ++i) {
        mShares[i].next = static_cast<int>(std::int64_t(count) * i / threads());
        mShares[i].end = static_cast<int>(std::int64_t(count) * (i + 1) / threads());
    }
    mOpen = true;
    ++mRound;
    mRound.notify_all();
    work(0);
    // All jobs are taken. A helper that got no processor so far comes too late and need not be waited for:
    // where other programs keep the processors busy that would take longer than the whole loop.
    mOpen = false;
    for (int inside = mInside; inside > 0; inside = mInside)
        waitWhile(mInside, inside);
    if (mError)
        std::rethrow_exception(std::exchange(mError, nullptr));
}

void ThreadTeam::work(int thread)
{
    for (int i = 0; i < threads(); ++i) {
        Share &share = mShares[(thread + i) % threads()];
        for (int job = share.next++; job < share.end; job = share.next++) {
            if (job > mErrorJob)
                continue;
            try {
                (*mJob)(job);
            } catch (...) {
                keepError(job);
            }
        }
    }
}

//! Keeps the exception being handled. No job of a higher number is started afterwards.
void ThreadTeam::keepError(int job)
{
    const std::lock_guard lock(mErrorMutex);
    if (job < mErrorJob) {
        mError = std::current_exception();
        mErrorJob = job;
    }
}

void ThreadTeam::help(int thread)
{
    for (unsigned round = 0;;) {
        waitWhile(mRound, round);
        round = mRound;
        if (mQuit)
            return;
        ++mInside; // before the look at mOpen, so that share() sees whoever found it open
        if (mOpen)
            work(thread);
        --mInside;
        mInside.notify_all();
    }
}

} // namespace autocuts
