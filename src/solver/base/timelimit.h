// Stops a part of a job after some time.
#pragma once

#include "solver/base/jobcontext.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace autocuts {

//! Stops a part of a job when the job is stopped, or after some time. What that part finds then depends on
//! the machine.
class TimeLimit
{
public:
    TimeLimit(const JobContext &job, std::chrono::milliseconds time)
        : mThreads(job.threads()), mWatch([this, job = job.quiet(), time](const std::stop_token &ends) {
              constexpr auto look = std::chrono::milliseconds(5);
              const auto end = std::chrono::steady_clock::now() + time;
              std::unique_lock lock(mMutex);
              while (!ends.stop_requested() && !job.stopped() && std::chrono::steady_clock::now() < end)
                  mEnded.wait_for(lock, ends, look, [] { return false; });
              mStop = true;
          })
    {}

    //! The context of the part, without progress.
    JobContext context() const { return {&mStop, mThreads}; }

private:
    int mThreads;
    std::atomic<bool> mStop = false;
    std::mutex mMutex;
    std::condition_variable_any mEnded;
    std::jthread mWatch; //!< the last member: it uses the others
};

} // namespace autocuts
