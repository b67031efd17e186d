// The menu that a right click in a view opens.
#pragma once

class QMenu;

namespace autocuts {

class ToolCanvas;
struct PickResult;
struct StudioContext;

//! Selects what is under the mouse, unless it is selected already or there is nothing.
void selectUnderMouse(const StudioContext &context, const ToolCanvas &canvas, const PickResult &pick);
//! Fills a menu with those actions that fit the selection and are enabled.
void fillContextMenu(QMenu &menu, const StudioContext &context);

} // namespace autocuts
