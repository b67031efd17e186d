// Stops a part of a job after some time, or only then.
#pragma once

#include "model/plain/parallel.h"
#include "solver/base/jobcontext.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace autocuts {

//! When a TimeLimit stops its part of a job.
enum class LimitStops {
    StoppedOrLate, //!< when the job is stopped, or after the time
    StoppedAndLate //!< when the job is stopped, but not before the time
};

//! Stops a part of a job. What that part finds then depends on the machine.
class TimeLimit
{
public:
    TimeLimit(const JobContext &job, std::chrono::milliseconds time,
              LimitStops stops = LimitStops::StoppedOrLate)
        : mThreads(job.threads()),
          mWatch([this, job = job.quiet(), time, stops](const std::stop_token &ends) {
              constexpr auto look = std::chrono::milliseconds(5);
              const auto end = std::chrono::steady_clock::now() + time;
              std::unique_lock lock(mMutex);
              const auto isOver = [&] {
                  const bool late = std::chrono::steady_clock::now() >= end;
                  return stops == LimitStops::StoppedOrLate ? late || job.stopped() : late && job.stopped();
              };
              while (!ends.stop_requested() && !isOver())
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
    BackgroundThread mWatch; //!< the last member: it uses the others
};

} // namespace autocuts
