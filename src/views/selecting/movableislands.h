// The islands that a tool or the layout panel moves, and the points about which they turn.
#pragma once

#include "views/state/toolsettings.h"

#include <Eigen/Geometry>

#include <map>
#include <vector>

namespace autocuts {

class Document;

//! The selected islands that are not locked.
struct MovableIslands
{
    std::vector<int> islands;  //!< indices in Document::islands(), ascending
    Eigen::AlignedBox2d box;   //!< around all of them, texture space; empty when there are none
    Vec2 pivot = Vec2::Zero(); //!< of all together; with Pivot::Individual the centre of the box
    std::map<int, Vec2> own;   //!< with Pivot::Individual: the pivot of each island

    bool isEmpty() const { return islands.empty(); }
    const Vec2 &pivotOf(int island) const
    {
        const auto found = own.find(island);
        return found == own.end() ? pivot : found->second;
    }
};

MovableIslands movableIslands(const Document &document, const ToolSettings &settings);

} // namespace autocuts
