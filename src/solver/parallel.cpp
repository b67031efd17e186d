#include "solver/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
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

namespace {

//! Looks at a value this often before going to sleep: loops of a step follow each other within microseconds.
constexpr int glances = 2000;

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

ThreadTeam::ThreadTeam(int threads)
{
    for (int i = 1; i < threads; ++i)
        mHelpers.emplace_back([this] { help(); });
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
    mCount = count;
    mNext = 0;
    mBusy = static_cast<int>(mHelpers.size());
    ++mRound;
    mRound.notify_all();
    work();
    for (int busy = mBusy; busy > 0; busy = mBusy)
        waitWhile(mBusy, busy);
    if (mError)
        std::rethrow_exception(std::exchange(mError, nullptr));
}

void ThreadTeam::work()
{
    for (int i = mNext++; i < mCount; i = mNext++) {
        try {
            (*mJob)(i);
        } catch (...) {
            keepError(i);
        }
    }
}

//! Keeps the exception being handled; no further jobs are begun.
void ThreadTeam::keepError(int job)
{
    mNext = mCount;
    const std::lock_guard lock(mErrorMutex);
    if (!mError || job < mErrorJob) {
        mError = std::current_exception();
        mErrorJob = job;
    }
}

void ThreadTeam::help()
{
    for (unsigned round = 0;;) {
        waitWhile(mRound, round);
        round = mRound;
        if (mQuit)
            return;
        work();
        if (--mBusy == 0)
            mBusy.notify_all();
    }
}

} // namespace autocuts
