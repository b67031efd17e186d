// Random numbers for light paths that are spread more evenly than random ones.
#pragma once

#include "solver/bake/sampling.h"

namespace autocuts::bake {

//! Points in the unit square, in independent sequences: the first two dimensions of Sobol's sequence, with
//! Owen's scrambling by hashes (Burley 2020, "Practical Hash-based Owen Scrambling"). The first 2^n points of
//! a sequence fill the square evenly, for each n. Depends on nothing but the seed.
class ScrambledPoints
{
public:
    explicit ScrambledPoints(std::uint32_t seed) : mSeed(scrambled(seed)) {}

    //! \param index of the point in its sequence \param sequence any number
    Eigen::Vector2f at(std::uint32_t index, std::uint32_t sequence) const
    {
        const std::uint32_t seed = scrambled(mSeed ^ (0x9E3779B9U * (sequence + 1)));
        const std::uint32_t shuffled = reversed(permuted(reversed(index), seed));
        std::uint32_t second = 0;
        std::uint32_t direction = 1U << 31;
        for (std::uint32_t bits = shuffled; bits != 0; bits >>= 1) {
            if (bits & 1)
                second ^= direction;
            direction ^= direction >> 1;
        }
        return {unit(reversed(permuted(shuffled, scrambled(seed ^ 1U)))),
                unit(reversed(permuted(reversed(second), scrambled(seed ^ 2U))))};
    }

private:
    static float unit(std::uint32_t value) { return static_cast<float>(value >> 8) * 0x1.0p-24F; }
    static std::uint32_t reversed(std::uint32_t value)
    {
        value = (value >> 16) | (value << 16);
        value = ((value & 0xFF00FF00U) >> 8) | ((value & 0x00FF00FFU) << 8);
        value = ((value & 0xF0F0F0F0U) >> 4) | ((value & 0x0F0F0F0FU) << 4);
        value = ((value & 0xCCCCCCCCU) >> 2) | ((value & 0x33333333U) << 2);
        return ((value & 0xAAAAAAAAU) >> 1) | ((value & 0x55555555U) << 1);
    }
    //! Owen's scrambling of a number whose bits are reversed: a bit changes the higher ones only (the hash of
    //! Laine and Karras with Vegdahl's constants).
    static std::uint32_t permuted(std::uint32_t value, std::uint32_t seed)
    {
        value ^= value * 0x3D20ADEAU;
        value += seed;
        value *= (seed >> 16) | 1U;
        value ^= value * 0x05526C56U;
        return value ^ (value * 0x53A22864U);
    }

    std::uint32_t mSeed;
};

} // namespace autocuts::bake
