// Telling a running job to stop: by a signal or by a time limit.
#pragma once

#include <atomic>
#include <thread>

namespace autocuts {

//! Why a job was told to stop.
enum class StopReason { None, Interrupted, TimeLimit };

//! Shared between a job and whoever may stop it (a signal handler, a timer). Lock-free.
struct StopSource
{
    std::atomic<bool> stop = false;
    std::atomic<StopReason> reason = StopReason::None;

    //! The first reason stays.
    void request(StopReason why)
    {
        StopReason none = StopReason::None;
        reason.compare_exchange_strong(none, why);
        stop = true;
    }
};

//! Requests a stop after a time, unless it is destroyed before.
class StopTimer final
{
public:
    //! \param seconds wall time; 0 or less: never
    StopTimer(double seconds, StopSource &stop);

private:
    std::jthread mThread;
};

} // namespace autocuts
