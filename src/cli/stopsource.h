// Stops a running job after a signal or a time limit.
#pragma once

#include "model/plain/parallel.h"

#include <atomic>
#include <optional>

namespace autocuts {

//! Why a job was told to stop.
enum class StopReason { None, Interrupted, TimeLimit };

//! Shared by a job and those that may stop it (a signal handler, a timer). Lock-free.
struct StopSource
{
    std::atomic<bool> stop = false;
    std::atomic<StopReason> reason = StopReason::None;
    //! See JobStage::Preparing.
    std::atomic<bool> isPreparing = false;
    //! Called when a stop comes while a job prepares, also by signal handlers; ends the program. Null: the
    //! job stops as at other times.
    void (*endProgram)(StopReason why) = nullptr;

    //! Requests a stop; only the first reason counts.
    void request(StopReason why)
    {
        StopReason none = StopReason::None;
        reason.compare_exchange_strong(none, why);
        stop = true;
        if (isPreparing && endProgram)
            endProgram(why);
    }
};

//! Requests a stop after a time. The request is cancelled when the timer is destroyed.
class StopTimer final
{
public:
    //! \param seconds wall time; 0 or less: never
    StopTimer(double seconds, StopSource &stop);

private:
    std::optional<BackgroundThread> mThread;
};

} // namespace autocuts
