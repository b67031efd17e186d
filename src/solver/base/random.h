// Pseudo-random numbers that are the same on every machine.
#pragma once

#include <cstdint>

namespace autocuts {

//! The generator splitmix64 (Steele, Lea and Flood 2014).
class Random
{
public:
    explicit Random(std::uint64_t seed) : mState(seed) {}

    std::uint64_t bits()
    {
        mState += 0x9E3779B97F4A7C15ull;
        std::uint64_t z = mState;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    //! Uniform in [0, 1).
    double uniform() { return double(bits() >> 11) * 0x1.0p-53; }
    //! Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    //! Uniform in 0 .. count - 1. \pre count > 0
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }

private:
    std::uint64_t mState;
};

} // namespace autocuts
