// How tools and the layout panel work on islands; kept while the program runs.
#pragma once

#include "model/plain/types.h"

namespace autocuts {

//! The point about which islands are turned and scaled.
enum class Pivot {
    Centre,    //!< centre of the box around the selected islands
    Corner,    //!< lower left corner of that box
    Cursor,    //!< the 2D cursor
    Individual //!< each island, group or stack has the centre of its own box
};

//! What a move snaps to while no key asks for something else.
enum class SnapTo { Nothing, Islands, Grid, Texels, Tiles };

//! The unit of lengths that are typed and shown.
enum class LengthUnit {
    Uv,    //!< those of the model's file, in which a tile is 1 wide and high
    Texels //!< of the texture
};

struct ToolSettings
{
    Pivot pivot = Pivot::Centre;
    Vec2 cursor = Vec2::Constant(0.5); //!< the 2D cursor, texture space
    SnapTo snap = SnapTo::Nothing;
    LengthUnit unit = LengthUnit::Texels;

    bool operator==(const ToolSettings &) const = default;
};

} // namespace autocuts
