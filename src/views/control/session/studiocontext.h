// The objects shared by all parts of the window.
#pragma once

namespace autocuts {

class ActionRegistry;
class FileController;
class LiveBake;
class MapController;
class ModelPictures;
class Preferences;
class ShownMap;
class SolverController;
class ViewState;
class Workspace;

//! References to the objects that exist once per window. They outlive panels, views and dialogs.
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
    ModelPictures &pictures;
    LiveBake &liveBake;
};

} // namespace autocuts
