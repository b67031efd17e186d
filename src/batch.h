// What the command line program does, without the command line: for scripts, farms and tests.
#pragma once

#include "clioptions.h"

#include <QTextStream>

#include <atomic>

namespace autocuts {

//! Why a job was told to stop.
enum class StopReason { None, Interrupted, TimeLimit };

//! Shared between a job and whoever may stop it (a signal handler, a timer).
struct StopSource
{
    std::atomic<bool> stop = false;
    std::atomic<StopReason> reason = StopReason::None;

    void request(StopReason why)
    {
        StopReason none = StopReason::None;
        reason.compare_exchange_strong(none, why);
        stop = true;
    }
};

//! Runs one command. Results go to `out`, progress and messages to `err`.
//! \param showProgress false when err is not a terminal
//! \returns the exit code: 0 done (also at a time limit), 1 failed, 130 interrupted
int runCommand(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out,
               QTextStream &err);

} // namespace autocuts
