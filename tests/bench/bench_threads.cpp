// What it costs to share two jobs between two threads: parallelFor(), which starts a thread for each call,
// ThreadTeam, and parallel_for of oneTBB. docs/architecture.md has the figures, and why the program has
// threads of its own.
//
//   bench_threads [CALLS]
//
// Prints microseconds per call, median and 90th percentile: of empty jobs one call right after the other, of
// empty jobs after a rest of a millisecond, in which threads that wait fall asleep, and of jobs of 50
// microseconds, from which those 50 are taken off. Needs two processors that nothing else uses;
// `chrt -f 10` sees to that where others are at work.
#include "model/plain/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

using namespace autocuts;

namespace {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

constexpr int threads = 2;
constexpr auto longJob = std::chrono::microseconds(50);

void spin(Clock::duration length)
{
    for (const auto end = Clock::now() + length; Clock::now() < end;) {
    }
}

struct Times
{
    double median = 0, most = 0; //!< microseconds; of ten calls, nine take no longer than `most`
};

//! \param loop runs the jobs 0 and 1, each job(i)
template <class Loop>
Times timesOf(Loop loop, int calls, Clock::duration job, Clock::duration rest)
{
    const auto work = [job](int) {
        if (job > Clock::duration::zero())
            spin(job);
    };
    for (int i = 0; i < 100; ++i)
        loop(work);
    std::vector<double> taken;
    for (int i = 0; i < calls; ++i) {
        if (rest > Clock::duration::zero())
            std::this_thread::sleep_for(rest);
        const auto begin = Clock::now();
        loop(work);
        taken.push_back(Microseconds(Clock::now() - begin - job).count());
    }
    std::sort(taken.begin(), taken.end());
    return {taken[taken.size() / 2], taken[taken.size() * 9 / 10]};
}

template <class Loop>
void measure(const char *name, Loop loop, int calls)
{
    using namespace std::chrono_literals;
    const Times empty = timesOf(loop, calls, 0us, 0us), rested = timesOf(loop, calls / 10, 0us, 1ms),
                busy = timesOf(loop, calls, longJob, 0us);
    std::printf("%-18s %8.2f %8.2f   %8.2f %8.2f   %8.2f %8.2f\n", name, empty.median, empty.most,
                rested.median, rested.most, busy.median, busy.most);
}

} // namespace

int main(int argc, char **argv)
{
    const int calls = argc > 1 ? std::atoi(argv[1]) : 10000;
    if (calls < 100) {
        std::fputs("usage: bench_threads [CALLS, at least 100]\n", stderr);
        return 2;
    }
    std::printf(
        "%d processors; microseconds per call, median and 90th percentile\n%-18s %17s   %17s   %17s\n",
        static_cast<int>(std::thread::hardware_concurrency()), "", "empty jobs", "after a rest",
        "jobs of 50 us");
    measure(
        "parallelFor", [](const auto &work) { parallelFor(2, threads, work); }, calls);
    {
        ThreadTeam team(threads);
        measure(
            "ThreadTeam", [&](const auto &work) { team.run(2, work); }, calls);
    }
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    measure(
        "tbb::parallel_for", [](const auto &work) { tbb::parallel_for(0, 2, work); }, calls);
    return 0;
}
