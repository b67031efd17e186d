// What the parts of the window are given to work with.
#pragma once

namespace autocuts {

class ActionRegistry;
class FileController;
class MapController;
class Preferences;
class ShownMap;
class SolverController;
class ViewState;
class Workspace;

//! References to what exists once per window; all of it outlives panels, views and dialogs.
struct StudioContext
{
    Workspace &workspace;
    ShownMap &shownMap;
    ViewState &view;
    Preferences &preferences;
    SolverController &solver;
    MapController &map;
    FileController &files;
    ActionRegistry &actions;
};

} // namespace autocuts
