// Numbers in the bytes of binary FBX files.
#pragma once

#include <QtEndian>

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace autocuts {

//! Reads a number that need not be aligned.
template <typename T>
T fbxNumber(const char *data, bool bigEndian)
{
    using Bits = std::conditional_t<
        sizeof(T) == 8, std::uint64_t,
        std::conditional_t<sizeof(T) == 4, std::uint32_t,
                           std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
    Bits bits;
    std::memcpy(&bits, data, sizeof bits);
    return std::bit_cast<T>(bigEndian ? qFromBigEndian(bits) : qFromLittleEndian(bits));
}

//! Writes what fbxNumber() reads.
template <typename T>
void putFbxNumber(char *data, T value, bool bigEndian)
{
    using Bits = std::conditional_t<
        sizeof(T) == 8, std::uint64_t,
        std::conditional_t<sizeof(T) == 4, std::uint32_t,
                           std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
    Bits bits = std::bit_cast<Bits>(value);
    bits = bigEndian ? qToBigEndian(bits) : qToLittleEndian(bits);
    std::memcpy(data, &bits, sizeof bits);
}

} // namespace autocuts
