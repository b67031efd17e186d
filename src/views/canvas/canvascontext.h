// What a canvas and its tools are given to work with.
#pragma once

namespace autocuts {

class MapController;
class Preferences;
class ShownMap;
class SolverController;
class ViewState;
class Workspace;

//! References that outlive the canvases.
struct CanvasContext
{
    Workspace &workspace;
    ShownMap &shownMap;
    ViewState &view;
    Preferences &preferences;
    MapController &map; //!< for the figures: flips and overlaps
    SolverController &solver;
};

} // namespace autocuts
