// Work that is abandoned where it does not end soon after a stop, such as the reading of large models.
#pragma once

#include "model/plain/parallel.h"
#include "solver/base/jobcontext.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace autocuts::jobs {

//! Milliseconds that work may go on after a stop before it is abandoned.
inline constexpr int abandonAfter = 100;

//! How often work was abandoned. It may still run: then the program has to end without destroying what it
//! uses, by std::_Exit().
inline std::atomic<int> abandonedCount = 0;

//! Runs work on another thread and waits for it. Nothing when a stop came before the end. Exceptions are
//! passed on. \param work called with a stop flag of its own; must own all that it uses
template <class Work>
auto unlessStopped(const JobContext &context, Work work)
    -> std::optional<decltype(work(std::declval<const std::atomic<bool> &>()))>
{
    using Value = decltype(work(std::declval<const std::atomic<bool> &>()));
    constexpr std::chrono::milliseconds tick(5);
    auto own = std::make_shared<std::atomic<bool>>(false);
    std::future<Value> result = startDetached([own, work = std::move(work)] { return work(*own); });
    for (int waited = 0; result.wait_for(tick) != std::future_status::ready;) {
        if (!context.stopped())
            continue;
        *own = true;
        waited += static_cast<int>(tick.count());
        if (waited > abandonAfter) {
            ++abandonedCount;
            return std::nullopt;
        }
    }
    return result.get();
}

} // namespace autocuts::jobs
