#include "model/plain/islandflags.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! The value that most faces have. Ties are decided by the rule in model/document/islands.h.
std::int32_t mostFrequent(const std::map<std::int32_t, int> &faceCount)
{
    std::int32_t best = 0;
    int bestCount = 0;
    for (const auto &[value, count] : faceCount) {
        const bool replacesNone = best == 0 && count == bestCount;
        if (count > bestCount || replacesNone) {
            best = value;
            bestCount = count;
        }
    }
    return best;
}

} // namespace

bool isValid(const IslandFlags &flags)
{
    return (flags.locked & ~1) == 0 && (flags.upright & ~1) == 0 && (flags.aligned & ~1) == 0 &&
           flags.stack >= 0 && flags.group >= 0;
}

IslandFlags flagsOf(const std::vector<IslandFlags> &faceFlags, const std::vector<int> &faces)
{
    IslandFlags flags;
    if (faceFlags.empty())
        return flags;
    std::map<std::int32_t, int> stacks, groups;
    for (int face : faces) {
        flags.locked = std::max(flags.locked, faceFlags[face].locked);
        flags.upright = std::max(flags.upright, faceFlags[face].upright);
        flags.aligned = std::max(flags.aligned, faceFlags[face].aligned);
        ++stacks[faceFlags[face].stack];
        ++groups[faceFlags[face].group];
    }
    flags.stack = mostFrequent(stacks);
    flags.group = mostFrequent(groups);
    return flags;
}

} // namespace autocuts
