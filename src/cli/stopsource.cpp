#include "cli/stopsource.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace autocuts {

StopTimer::StopTimer(double seconds, StopSource &stop)
{
    if (!(seconds > 0))
        return;
    mThread.emplace([seconds, &stop](const std::stop_token &token) {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any wake;
        const bool ended = wake.wait_for(lock, token, std::chrono::duration<double>(seconds),
                                         [&token] { return token.stop_requested(); });
        if (!ended)
            stop.request(StopReason::TimeLimit);
    });
}

} // namespace autocuts
