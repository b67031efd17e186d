// Threads: all that the program starts are started here, but for those with an event loop of Qt.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace autocuts {

//! A thread beside the calling one. Its end asks the work to end, and waits for it.
class BackgroundThread
{
public:
    //! \param work throws no exception
    explicit BackgroundThread(std::function<void(const std::stop_token &)> work) : mThread(std::move(work)) {}

    //! Asks the work to end.
    void requestStop() { mThread.request_stop(); }
    //! Waits until the work has ended.
    void join() { mThread.join(); }

private:
    std::jthread mThread;
};

//! Calls job(0) ... job(count - 1), each once, on at most `threads` threads including the calling one, and
//! waits. The jobs must not depend on each other. Of the exceptions thrown by jobs, the one of the lowest job
//! number is thrown again here.
void parallelFor(int count, int threads, const std::function<void(int)> &job);

//! Calls job(first, end) for ranges that together hold 0 ... count - 1, on all cores of the machine if there
//! is much to do, and waits. For loops of which a step takes some ten nanoseconds, where somebody waits for
//! the window. The steps must not depend on each other.
void parallelRanges(int count, const std::function<void(int first, int end)> &job);

//! Threads that are started once and wait between the many short loops of a solver step.
class ThreadTeam
{
public:
    //! \param threads including the calling one
    explicit ThreadTeam(int threads = 1);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam &) = delete;
    ThreadTeam &operator=(const ThreadTeam &) = delete;

    int threads() const { return static_cast<int>(mShares.size()); }

    //! Calls job(0) ... job(count - 1), in any order and on any of the threads, and waits. The jobs must not
    //! depend on each other. Two loops with the same number of jobs assign the same jobs to each thread, as
    //! far as all threads stay busy, so that the data of a job is still in the cache of its processor. Of the
    //! exceptions thrown by jobs, the one of the lowest job number is thrown again here; jobs of higher
    //! numbers may not have been called. Must not be called from two threads at a time.
    template <class Job>
    void run(int count, Job &&job)
    {
        if (mHelpers.empty() || count < 2) {
            for (int i = 0; i < count; ++i)
                job(i);
        } else {
            share(count, job);
        }
    }

private:
    void share(int count, const std::function<void(int)> &job);
    void help(int thread);
    void work(int thread);
    void keepError(int job);

    //! Jobs assigned to one thread. A thread that has finished its own takes jobs of others.
    struct alignas(64) Share
    {
        std::atomic<int> next = 0;
        int end = 0;
    };

    const std::function<void(int)> *mJob = nullptr;
    std::vector<Share> mShares;   //!< per thread, the calling one first
    std::atomic<int> mInside = 0; //!< helpers that may be at a job
    std::atomic<unsigned> mRound = 0;
    std::atomic<bool> mQuit = false;
    std::atomic<bool> mOpen = false; //!< helpers may take jobs
    std::mutex mErrorMutex;
    std::exception_ptr mError; //!< of job mErrorJob
    std::atomic<int> mErrorJob = 0;
    std::vector<std::thread> mHelpers;
};

//! Runs the jobs on the team, or on the calling thread alone when `team` is null.
template <class Job>
void runOn(ThreadTeam *team, int count, Job &&job)
{
    if (team) {
        team->run(count, job);
    } else {
        for (int i = 0; i < count; ++i)
            job(i);
    }
}

//! Number of elements (triangles, corners, pairs) in one job of a solver step. Sums are formed per job and
//! then added in the order of the jobs, so that they do not depend on the number of threads. Chosen by hand;
//! no measurement of its effect is recorded.
constexpr int jobSize = 1024;

constexpr int jobCount(int elements)
{
    return (elements + jobSize - 1) / jobSize;
}

//! Sum of sum(first, end) over consecutive ranges that together hold all elements.
template <class Sum>
double sumInOrder(ThreadTeam *team, int elements, Sum &&sum)
{
    std::vector<double> parts(jobCount(elements));
    runOn(team, static_cast<int>(parts.size()),
          [&](int i) { parts[i] = sum(i * jobSize, std::min(elements, (i + 1) * jobSize)); });
    double total = 0;
    for (const double part : parts)
        total += part;
    return total;
}

} // namespace autocuts
