// Choices of the tool settings that the tools of islands and the layout panel offer.
#pragma once

#include "views/canvas/tooloption.h"

namespace autocuts {

class ViewState;

//! What islands are turned and scaled about.
ToolOption pivotChoice(ViewState &view);
//! What moved islands snap to.
ToolOption snapChoice(ViewState &view);

} // namespace autocuts
