// How long a test waits for what must happen.
#pragma once

namespace autocuts::test {

//! Milliseconds. Much longer than it takes on a busy machine; sanitized code is many times slower.
#ifdef AUTOCUTS_SANITIZED
inline constexpr int patience = 1'800'000;
#else
inline constexpr int patience = 120'000;
#endif

} // namespace autocuts::test
