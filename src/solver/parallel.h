// Independent jobs on several threads.
#pragma once

#include <functional>

namespace autocuts {

//! Calls job(0) ... job(count - 1), each once, on at most `threads` threads including the calling one, and waits.
//! The jobs must not depend on each other. The first exception (by job number) is thrown again here.
void parallelFor(int count, int threads, const std::function<void(int)> &job);

} // namespace autocuts
