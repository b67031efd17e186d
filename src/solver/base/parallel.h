// Independent jobs on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace autocuts {

//! Calls job(0) ... job(count - 1), each once, on at most `threads` threads including the calling one, and
//! waits. The jobs must not depend on each other. The first exception (by job number) is thrown again here.
void parallelFor(int count, int threads, const std::function<void(int)> &job);

//! Threads that stay and wait between the many short loops of a solver step.
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
    //! depend on each other. Loops of as many jobs give each thread the same ones, as far as that keeps all
    //! busy: what a job of one loop leaves in the caches of a processor the next one finds there. When some
    //! throw, the exception of the first of them (by number) is thrown again here; those of higher numbers
    //! may not have been called. Not to be called from two threads at a time.
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

    //! The jobs that are meant for one thread; others take of them when they have none left.
    struct alignas(64) Share
    {
        std::atomic<int> next = 0;
        int end = 0;
    };

    const std::function<void(int)> *mJob = nullptr;
    std::vector<Share> mShares; //!< per thread, the calling one first
    std::atomic<int> mBusy = 0;
    std::atomic<unsigned> mRound = 0;
    std::atomic<bool> mQuit = false;
    std::mutex mErrorMutex;
    std::exception_ptr mError; //!< of job mErrorJob
    std::atomic<int> mErrorJob = 0;
    std::vector<std::thread> mHelpers;
};

//! On the team, or on the calling thread alone when there is none.
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

//! Elements that one job of a step takes: sums are formed per such a part and then added in order, so that
//! they do not depend on the number of threads.
constexpr int jobSize = 1024;

constexpr int jobCount(int elements)
{
    return (elements + jobSize - 1) / jobSize;
}

//! Sum over all elements of what sum(first, end) gives for parts of them.
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
