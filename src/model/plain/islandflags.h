// Flags that users set on islands: locked, upright, stack and group. Plain: no Qt.
#pragma once

#include <cstdint>
#include <vector>

namespace autocuts {

//! The flags of one face. The flags of an island follow from those of its faces, see flagsOf(). Journals hold
//! the bytes: `locked`, `upright` and `aligned` are parts of what was one number, the lowest byte first.
struct IslandFlags
{
    std::int16_t locked = 0; //!< 0 or 1; locked islands are not moved by packing or by tools
    std::int8_t upright = 0; //!< 0 or 1; packing does not turn islands that keep their orientation
    //! 0 or 1; the island was aligned to the axes by the user and not turned since: packing turns it by right
    //! angles only
    std::int8_t aligned = 0;
    std::int32_t stack = 0; //!< number of a stack: its islands lie on top of each other; 0 for none
    std::int32_t group = 0; //!< number of a group: its islands move together; 0 for none

    bool operator==(const IslandFlags &) const = default;
};
static_assert(sizeof(IslandFlags) == 12);

//! True when every field is in its valid range.
bool isValid(const IslandFlags &flags);

//! The flags of an island made of the given faces. The rule is in model/document/islands.h.
//! \param faceFlags one entry per face of the mesh; empty: no island has any
IslandFlags flagsOf(const std::vector<IslandFlags> &faceFlags, const std::vector<int> &faces);

} // namespace autocuts
