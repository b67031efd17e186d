// Work that a stop leaves to itself where it does not end soon, such as the reading of large models.
#pragma once

#include "solver/base/jobcontext.h"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace autocuts::jobs {

//! Milliseconds that work may go on after a stop before it is left to itself.
inline constexpr int letGoPatience = 100;

//! How often work was left to itself. It may still run: then the program has to end without destroying what
//! it uses, by std::_Exit().
inline std::atomic<int> letGoCount = 0;

//! Runs work on another thread and waits for it. Nothing when a stop came before the end. Exceptions are
//! passed on. \param work called with a stop flag of its own; must own all that it uses
template <class Work>
auto unlessStopped(const JobContext &context, Work work)
    -> std::optional<decltype(work(std::declval<const std::atomic<bool> &>()))>
{
    using Value = decltype(work(std::declval<const std::atomic<bool> &>()));
    constexpr std::chrono::milliseconds tick(5);
    auto own = std::make_shared<std::atomic<bool>>(false);
    std::packaged_task<Value()> task([own, work = std::move(work)] { return work(*own); });
    std::future<Value> result = task.get_future();
    std::thread(std::move(task)).detach();
    for (int waited = 0; result.wait_for(tick) != std::future_status::ready;) {
        if (!context.stopped())
            continue;
        *own = true;
        waited += static_cast<int>(tick.count());
        if (waited > letGoPatience) {
            ++letGoCount;
            return std::nullopt;
        }
    }
    return result.get();
}

} // namespace autocuts::jobs
