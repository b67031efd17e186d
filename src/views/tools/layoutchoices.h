// Choices of the tool settings that the tools of islands and the layout panel offer.
#pragma once

#include "model/plain/packingsettings.h"
#include "views/canvas/tooloption.h"
#include "views/state/toolsettings.h"

namespace autocuts {

class ViewState;

//! What islands are turned and scaled about.
ToolOption pivotChoice(ViewState &view);
//! What moved islands snap to.
ToolOption snapChoice(ViewState &view);
//! The unit of lengths.
ToolOption unitChoice(ViewState &view);
//! What lengths in texture space are multiplied by, in u and v, to be in a unit.
Vec2 unitsPerLength(LengthUnit unit, const PackingSettings &packing);

} // namespace autocuts
