// Marks of islands for packing and moving. Plain: no Qt.
#pragma once

#include <cstdint>
#include <vector>

namespace autocuts {

//! Marks of a face, and of an island through its faces.
struct IslandFlags
{
    std::int32_t locked = 0; //!< 0 or 1; locked islands are not moved by packing or by tools
    std::int32_t stack = 0;  //!< islands of one stack lie on top of each other; 0 for none
    std::int32_t group = 0;  //!< islands of one group move together; 0 for none

    bool operator==(const IslandFlags &) const = default;
};

//! True when every field is in its range.
bool isValid(const IslandFlags &flags);

//! The flags of the island that consists of these faces, by the rule above.
//! \param faceFlags one per face of the mesh
IslandFlags flagsOf(const std::vector<IslandFlags> &faceFlags, const std::vector<int> &faces);

} // namespace autocuts
