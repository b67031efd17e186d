// The presets of unwrapping.
#pragma once

namespace autocuts::unwrap {

//! How much work is spent on short seams.
enum class UnwrapQuality { Draft, Standard, Best };

} // namespace autocuts::unwrap
