// Small deterministic random generator, the same on every platform. Plain: no Qt.
#pragma once

#include <cstdint>

namespace autocuts {

//! SplitMix64 (Steele, Lea and Flood 2014).
class SplitMix
{
public:
    explicit SplitMix(std::uint64_t seed) : mState(seed) {}

    std::uint64_t next()
    {
        std::uint64_t z = (mState += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }

    //! In [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    //! In [-1, 1).
    double symmetric() { return 2 * uniform() - 1; }
    //! In 0 .. count - 1. \pre count > 0
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

private:
    std::uint64_t mState;
};

} // namespace autocuts
