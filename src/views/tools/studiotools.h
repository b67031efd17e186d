// All tools of the studio.
#pragma once

namespace autocuts {

class ToolManager;
struct StudioContext;

//! Adds the tools in the order of the tool bar. The first one becomes active.
void addStudioTools(ToolManager &tools, const StudioContext &context);

} // namespace autocuts
