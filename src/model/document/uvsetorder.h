// The order of UV sets.
#pragma once

#include "model/document/documentstate.h"

#include <algorithm>

namespace autocuts {

//! Moves a UV set to the front. The others keep their order.
inline void putFirst(std::vector<UvSet> &sets, int set)
{
    if (!sets.empty())
        std::rotate(sets.begin(), sets.begin() + set, sets.begin() + set + 1);
}

//! The state with its active UV set as the first one, as files have it.
inline DocumentState activeFirst(DocumentState state)
{
    putFirst(state.scene.uvSets, state.activeUvSet);
    return state;
}

} // namespace autocuts
