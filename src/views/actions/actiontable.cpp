// The table of all actions, in the order of the menus.
#include "views/actions/actiontable.h"

#include <QtGlobal>

#include <array>

namespace autocuts {

namespace {

constexpr int NeedsIdleDocument = NeedsDocument | NeedsIdle;
constexpr int NeedsIdleMap = NeedsDocument | NeedsUvs | NeedsIdle;
constexpr int NeedsIslands = NeedsDocument | NeedsUvs | NeedsSelectedFaces;

constexpr std::array fileTable{
    ActionInfo{"file.open", "File", QT_TRANSLATE_NOOP("Actions", "&Open..."), "open", "Ctrl+O",
               QT_TRANSLATE_NOOP("Actions", "Open a mesh or a session"), NeedsIdle},
    ActionInfo{"file.sample.bumpycube", "File/Open sample", QT_TRANSLATE_NOOP("Actions", "&Bumpy cube"), "",
               "", QT_TRANSLATE_NOOP("Actions", "Open a cube with smooth bumps"), NeedsIdle},
    ActionInfo{"file.sample.character", "File/Open sample", QT_TRANSLATE_NOOP("Actions", "&Character"), "",
               "", QT_TRANSLATE_NOOP("Actions", "Open a figure of quads"), NeedsIdle},
    ActionInfo{"file.sample.torus", "File/Open sample", QT_TRANSLATE_NOOP("Actions", "&Torus with handles"),
               "", "", QT_TRANSLATE_NOOP("Actions", "Open a torus with three handles"), NeedsIdle},
    ActionInfo{"file.sample.machine", "File/Open sample", QT_TRANSLATE_NOOP("Actions", "&Machine"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Open a pump of many hard-surface parts"), NeedsIdle},
    ActionInfo{"file.clearRecent", "File/Open recent", QT_TRANSLATE_NOOP("Actions", "&Clear list"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Forget the recent files")},
    ActionInfo{"file.close", "File", QT_TRANSLATE_NOOP("Actions", "&Close"), "cancel", "Ctrl+W",
               QT_TRANSLATE_NOOP("Actions", "Close the session"), NeedsDocument},
    ActionInfo{"file.save", "File", QT_TRANSLATE_NOOP("Actions", "&Save"), "save", "Ctrl+S",
               QT_TRANSLATE_NOOP("Actions", "Save the session"), NeedsDocument, false, "", true},
    ActionInfo{"file.saveAs", "File", QT_TRANSLATE_NOOP("Actions", "Save &as..."), "save-as", "Ctrl+Shift+S",
               QT_TRANSLATE_NOOP("Actions", "Save the session under another name"), NeedsDocument},
    ActionInfo{
        "file.relink", "File", QT_TRANSLATE_NOOP("Actions", "Re-&link model..."), "relink", "",
        QT_TRANSLATE_NOOP("Actions",
                          "Replace the model by a changed version of it and keep seams, pins and rectangles"),
        NeedsIdleDocument},
    ActionInfo{"file.exportMesh", "File", QT_TRANSLATE_NOOP("Actions", "&Export mesh..."), "export-mesh",
               "Ctrl+E", QT_TRANSLATE_NOOP("Actions", "Write the model with its UV map"), NeedsIdleDocument,
               false, "", true},
    ActionInfo{"file.exportLayout", "File", QT_TRANSLATE_NOOP("Actions", "Export la&yout..."),
               "export-layout", "Ctrl+Shift+E", QT_TRANSLATE_NOOP("Actions", "Write a picture of the UV map"),
               NeedsIdleMap},
    ActionInfo{"file.quit", "File", QT_TRANSLATE_NOOP("Actions", "&Quit"), "", "Ctrl+Q",
               QT_TRANSLATE_NOOP("Actions", "Quit Autocuts"), 0, false, "", true},
};

constexpr std::array editTable{
    ActionInfo{"edit.undo", "Edit", QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo", "Ctrl+Z",
               QT_TRANSLATE_NOOP("Actions", "Take back the last edit"), NeedsUndo},
    ActionInfo{"edit.redo", "Edit", QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo", "Ctrl+Shift+Z; Ctrl+Y",
               QT_TRANSLATE_NOOP("Actions", "Do again what was undone"), NeedsRedo},
    ActionInfo{"edit.shortcuts", "Edit", QT_TRANSLATE_NOOP("Actions", "&Shortcuts..."), "shortcuts", "",
               QT_TRANSLATE_NOOP("Actions", "Choose the keys of all actions"), 0, false, "", true},
    ActionInfo{"edit.preferences", "Edit", QT_TRANSLATE_NOOP("Actions", "&Preferences..."), "preferences",
               "Ctrl+,", QT_TRANSLATE_NOOP("Actions", "Navigation, colours, defaults and autosave")},
};

constexpr std::array selectTable{
    ActionInfo{"select.all", "Select", QT_TRANSLATE_NOOP("Actions", "&All"), "select-all", "Ctrl+A",
               QT_TRANSLATE_NOOP("Actions", "Select everything"), NeedsDocument},
    ActionInfo{"select.none", "Select", QT_TRANSLATE_NOOP("Actions", "&None"), "select-none", "Ctrl+Shift+A",
               QT_TRANSLATE_NOOP("Actions", "Select nothing"), NeedsSelection},
    ActionInfo{"select.invert", "Select", QT_TRANSLATE_NOOP("Actions", "&Invert"), "select-invert", "Ctrl+I",
               QT_TRANSLATE_NOOP("Actions", "Select what is not selected"), NeedsDocument},
    ActionInfo{"select.grow", "Select", QT_TRANSLATE_NOOP("Actions", "&Grow"), "grow", "Ctrl++; Ctrl+=",
               QT_TRANSLATE_NOOP("Actions", "Select the neighbours too"), NeedsSelection, false, "", true},
    ActionInfo{"select.shrink", "Select", QT_TRANSLATE_NOOP("Actions", "S&hrink"), "shrink", "Ctrl+-",
               QT_TRANSLATE_NOOP("Actions", "Take away the rim of the selection"), NeedsSelection},
    ActionInfo{"select.linked", "Select", QT_TRANSLATE_NOOP("Actions", "&Linked"), "linked", "L",
               QT_TRANSLATE_NOOP("Actions", "Select the whole connected parts of the model"), NeedsSelection,
               false, "", true},
    ActionInfo{"select.island", "Select", QT_TRANSLATE_NOOP("Actions", "I&sland"), "island", "I",
               QT_TRANSLATE_NOOP("Actions", "Select the whole UV islands"), NeedsSelection | NeedsUvs},
    ActionInfo{"select.loop", "Select", QT_TRANSLATE_NOOP("Actions", "Edge l&oop"), "loop", "Shift+L",
               QT_TRANSLATE_NOOP("Actions", "Select the loops through the selected edges"),
               NeedsSelectedEdges},
    ActionInfo{"select.similar", "Select", QT_TRANSLATE_NOOP("Actions", "Si&milar islands"), "similar",
               "Shift+I",
               QT_TRANSLATE_NOOP("Actions", "Select the islands that are copies of the selected ones"),
               NeedsSelection | NeedsUvs},
    ActionInfo{"select.overlapping", "Select", QT_TRANSLATE_NOOP("Actions", "O&verlapping faces"), "overlap",
               "", QT_TRANSLATE_NOOP("Actions", "Select the faces that overlap others in the map"),
               NeedsOverlaps},
    ActionInfo{"select.flipped", "Select", QT_TRANSLATE_NOOP("Actions", "&Flipped faces"), "flipped", "",
               QT_TRANSLATE_NOOP("Actions", "Select the faces that are turned over in the map"), NeedsUvs},
    ActionInfo{"select.vertices", "Select", QT_TRANSLATE_NOOP("Actions", "Select ver&tices"), "mode-vertices",
               "1", QT_TRANSLATE_NOOP("Actions", "Clicks select vertices"), NeedsDocument, true, "mode",
               true},
    ActionInfo{"select.edges", "Select", QT_TRANSLATE_NOOP("Actions", "Select &edges"), "mode-edges", "2",
               QT_TRANSLATE_NOOP("Actions", "Clicks select edges"), NeedsDocument, true, "mode"},
    ActionInfo{"select.faces", "Select", QT_TRANSLATE_NOOP("Actions", "Select fa&ces"), "mode-faces", "3",
               QT_TRANSLATE_NOOP("Actions", "Clicks select faces"), NeedsDocument, true, "mode"},
    ActionInfo{"select.islands", "Select", QT_TRANSLATE_NOOP("Actions", "Select islan&ds"), "mode-islands",
               "4", QT_TRANSLATE_NOOP("Actions", "Clicks select islands"), NeedsDocument, true, "mode"},
};

constexpr std::array uvTable{
    ActionInfo{"uv.run", "UV", QT_TRANSLATE_NOOP("Actions", "&Run"), "run", "Space",
               QT_TRANSLATE_NOOP("Actions", "Let the solver run, or pause it and keep its map"),
               NeedsIdleDocument},
    ActionInfo{"uv.step", "UV", QT_TRANSLATE_NOOP("Actions", "&One step"), "step", "Shift+Space",
               QT_TRANSLATE_NOOP("Actions", "Make one step of the solver"), NeedsIdleDocument},
    ActionInfo{"uv.restart", "UV", QT_TRANSLATE_NOOP("Actions", "R&estart"), "restart", "Ctrl+R",
               QT_TRANSLATE_NOOP("Actions", "Begin the solve again from its start"), NeedsIdleDocument},
    ActionInfo{"uv.lambdaLess", "UV", QT_TRANSLATE_NOOP("Actions", "&Less weight on seams"), "lambda-down",
               "Left", QT_TRANSLATE_NOOP("Actions", "Lower lambda: less distortion, longer seams"),
               NeedsDocument, false, "", true},
    ActionInfo{"uv.lambdaMore", "UV", QT_TRANSLATE_NOOP("Actions", "&More weight on seams"), "lambda-up",
               "Right", QT_TRANSLATE_NOOP("Actions", "Raise lambda: shorter seams, more distortion"),
               NeedsDocument},
    ActionInfo{"uv.deltaDouble", "UV", QT_TRANSLATE_NOOP("Actions", "Softer seams (double delta)"), "", "Up",
               QT_TRANSLATE_NOOP("Actions", "Double delta: cuts become softer and may move"), NeedsDocument},
    ActionInfo{"uv.deltaHalve", "UV", QT_TRANSLATE_NOOP("Actions", "S&harper seams (halve delta)"), "",
               "Down", QT_TRANSLATE_NOOP("Actions", "Halve delta: cuts become definite"), NeedsDocument},
    ActionInfo{"uv.budget", "UV", QT_TRANSLATE_NOOP("Actions", "Distortion &budget"), "budget", "Ctrl+B",
               QT_TRANSLATE_NOOP("Actions", "Let the solver choose lambda and delta for a distortion bound"),
               0, true},
    ActionInfo{"uv.start.rigid", "UV/Start mode", QT_TRANSLATE_NOOP("Actions", "&Rigid triangles"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Start from every triangle laid flat on its own"), NeedsDocument,
               true, "start"},
    ActionInfo{"uv.start.tutte", "UV/Start mode", QT_TRANSLATE_NOOP("Actions", "&Tutte embedding"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Start from a Tutte embedding"), NeedsDocument, true, "start"},
    ActionInfo{"uv.start.random", "UV/Start mode", QT_TRANSLATE_NOOP("Actions", "Ra&ndom"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Start from triangles at random places"), NeedsDocument, true,
               "start"},
    ActionInfo{"uv.start.existing", "UV/Start mode", QT_TRANSLATE_NOOP("Actions", "&Existing UVs"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Start from the UVs that there are"), NeedsDocument, true,
               "start"},
    ActionInfo{"uv.energy.symmetricDirichlet", "UV/Energy",
               QT_TRANSLATE_NOOP("Actions", "&Symmetric Dirichlet"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Keep lengths"), NeedsDocument, true, "energy"},
    ActionInfo{"uv.energy.amips", "UV/Energy", QT_TRANSLATE_NOOP("Actions", "&AMIPS"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Keep angles more than areas"), NeedsDocument, true, "energy"},
    ActionInfo{"uv.weighting.length", "UV/Seam weighting", QT_TRANSLATE_NOOP("Actions", "By &length"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Make the total length of the seams small"), NeedsDocument, true,
               "weighting"},
    ActionInfo{"uv.weighting.count", "UV/Seam weighting", QT_TRANSLATE_NOOP("Actions", "By &count"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Make the number of cut edges small"), NeedsDocument, true,
               "weighting"},
    ActionInfo{
        "uv.unwrap", "UV", QT_TRANSLATE_NOOP("Actions", "&Unwrap"), "unwrap", "U",
        QT_TRANSLATE_NOOP("Actions", "Make the whole map: solve, finish, take overlaps apart and pack"),
        NeedsIdleDocument, false, "", true},
    ActionInfo{"uv.finish", "UV", QT_TRANSLATE_NOOP("Actions", "&Finish"), "finish", "Ctrl+Return",
               QT_TRANSLATE_NOOP("Actions", "Make a final map with definite seams and no overlaps"),
               NeedsIdleDocument},
    ActionInfo{"uv.pack", "UV", QT_TRANSLATE_NOOP("Actions", "&Pack"), "pack", "P",
               QT_TRANSLATE_NOOP("Actions", "Arrange all islands in the texture"), NeedsIdleMap},
    ActionInfo{"uv.packSelection", "UV", QT_TRANSLATE_NOOP("Actions", "Pack &selection"), "pack-selection",
               "Shift+P", QT_TRANSLATE_NOOP("Actions", "Arrange the selected islands around the others"),
               NeedsIdleMap | NeedsSelection},
    ActionInfo{"uv.separate", "UV", QT_TRANSLATE_NOOP("Actions", "Separate o&verlaps"), "separate", "O",
               QT_TRANSLATE_NOOP("Actions", "Cut islands that cover themselves, and pack"), NeedsIdleMap},
    ActionInfo{"uv.density", "UV", QT_TRANSLATE_NOOP("Actions", "E&qualise texel density"), "density",
               "Shift+E", QT_TRANSLATE_NOOP("Actions", "Give every island the same texel density"),
               NeedsIdleMap},
    ActionInfo{"uv.cut", "UV", QT_TRANSLATE_NOOP("Actions", "&Cut"), "cut", "C",
               QT_TRANSLATE_NOOP("Actions", "Cut along the selected edges, or around the selected faces"),
               NeedsEdgesOrFaces, false, "", true},
    ActionInfo{
        "uv.join", "UV", QT_TRANSLATE_NOOP("Actions", "&Join"), "join", "J",
        QT_TRANSLATE_NOOP("Actions", "Keep together along the selected edges, or inside the selected faces"),
        NeedsEdgesOrFaces},
    ActionInfo{"uv.clearSteering", "UV", QT_TRANSLATE_NOOP("Actions", "Cle&ar cuts and joins"), "clear",
               "Shift+C", QT_TRANSLATE_NOOP("Actions", "Leave the selected edges to the solver"),
               NeedsEdgesOrFaces},
    ActionInfo{"uv.pin", "UV", QT_TRANSLATE_NOOP("Actions", "P&in"), "pin", "Ctrl+P",
               QT_TRANSLATE_NOOP("Actions", "Hold the selection where it is in the map"),
               NeedsSelection | NeedsUvs, false, "", true},
    ActionInfo{"uv.unpin", "UV", QT_TRANSLATE_NOOP("Actions", "Unpi&n"), "unpin", "Ctrl+Shift+P",
               QT_TRANSLATE_NOOP("Actions", "Remove the pins of the selection"), NeedsSelection},
    ActionInfo{"uv.lock", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Lock"), "lock", "Ctrl+L",
               QT_TRANSLATE_NOOP("Actions", "Keep the selected islands where they are"), NeedsIslands},
    ActionInfo{"uv.unlock", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Unlock"), "unlock", "Ctrl+Shift+L",
               QT_TRANSLATE_NOOP("Actions", "Let the selected islands move again"), NeedsIslands},
    ActionInfo{"uv.stack", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Stack"), "stack", "Ctrl+K",
               QT_TRANSLATE_NOOP("Actions", "Pack the selected islands on top of each other"), NeedsIslands,
               false, "", true},
    ActionInfo{"uv.unstack", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "U&nstack"), "", "Ctrl+Shift+K",
               QT_TRANSLATE_NOOP("Actions", "Pack the selected islands one by one"), NeedsIslands},
    ActionInfo{"uv.group", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Group"), "", "Ctrl+G",
               QT_TRANSLATE_NOOP("Actions", "Keep the arrangement of the selected islands"), NeedsIslands,
               false, "", true},
    ActionInfo{"uv.ungroup", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "Ungrou&p"), "", "Ctrl+Shift+G",
               QT_TRANSLATE_NOOP("Actions", "Let the selected islands move on their own"), NeedsIslands},
    ActionInfo{"tool.select", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Select"), "tool-select", "Q",
               QT_TRANSLATE_NOOP("Actions", "Select with the mouse"), NeedsDocument, true, "tool", true},
    ActionInfo{"uv.cancel", "UV", QT_TRANSLATE_NOOP("Actions", "Cancel job"), "cancel", "Esc",
               QT_TRANSLATE_NOOP("Actions", "End the running job and keep what it has"), NeedsJob, false, "",
               true},
};

constexpr std::array viewTable{
    ActionInfo{"view.frameAll", "View", QT_TRANSLATE_NOOP("Actions", "Frame &all"), "frame-all", "Home; A",
               QT_TRANSLATE_NOOP("Actions", "Show everything"), NeedsDocument},
    ActionInfo{"view.frameSelected", "View", QT_TRANSLATE_NOOP("Actions", "Frame &selected"),
               "frame-selected", "F; Num+.", QT_TRANSLATE_NOOP("Actions", "Show the selection large"),
               NeedsDocument},
    ActionInfo{"view.maximize3d", "View", QT_TRANSLATE_NOOP("Actions", "&3D view only"), "view-3d", "Ctrl+1",
               QT_TRANSLATE_NOOP("Actions", "Give the 3D view all room"), 0, true, "maximize", true},
    ActionInfo{"view.maximizeUv", "View", QT_TRANSLATE_NOOP("Actions", "&UV view only"), "view-uv", "Ctrl+2",
               QT_TRANSLATE_NOOP("Actions", "Give the UV view all room"), 0, true, "maximize"},
    ActionInfo{"view.both", "View", QT_TRANSLATE_NOOP("Actions", "&Both views"), "view-both", "Ctrl+3",
               QT_TRANSLATE_NOOP("Actions", "Show both views side by side"), 0, true, "maximize"},
    ActionInfo{"view.fullScreen", "View", QT_TRANSLATE_NOOP("Actions", "&Full screen"), "", "F11",
               QT_TRANSLATE_NOOP("Actions", "Fill the screen"), 0, true},
    ActionInfo{"view.coloring.plain", "View/Coloring", QT_TRANSLATE_NOOP("Actions", "&Plain"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Faces in one colour"), 0, true, "coloring", true},
    ActionInfo{"view.coloring.islands", "View/Coloring", QT_TRANSLATE_NOOP("Actions", "&Islands"), "island",
               "", QT_TRANSLATE_NOOP("Actions", "Every island in a colour of its own"), 0, true, "coloring"},
    ActionInfo{"view.coloring.signedStretch", "View/Coloring",
               QT_TRANSLATE_NOOP("Actions", "&Signed stretch"), "heat-map", "",
               QT_TRANSLATE_NOOP("Actions", "Where the map is too small or too large"), 0, true, "coloring"},
    ActionInfo{"view.coloring.magnitude", "View/Coloring", QT_TRANSLATE_NOOP("Actions", "Stretch &magnitude"),
               "heat-map", "", QT_TRANSLATE_NOOP("Actions", "How much the map is distorted"), 0, true,
               "coloring"},
    ActionInfo{"view.coloring.paint", "View/Coloring", QT_TRANSLATE_NOOP("Actions", "Paint &weights"),
               "tool-paint", "", QT_TRANSLATE_NOOP("Actions", "Where seams are welcome and where not"), 0,
               true, "coloring"},
    ActionInfo{"view.heatMap", "View", QT_TRANSLATE_NOOP("Actions", "Next &heat-map"), "heat-map", "H",
               QT_TRANSLATE_NOOP("Actions", "Change between plain faces and the heat-maps")},
    ActionInfo{"view.pattern.none", "View/Pattern", QT_TRANSLATE_NOOP("Actions", "&None"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Nothing on the model"), 0, true, "pattern", true},
    ActionInfo{"view.pattern.checker", "View/Pattern", QT_TRANSLATE_NOOP("Actions", "&Checkerboard"),
               "checker", "", QT_TRANSLATE_NOOP("Actions", "A checkerboard on the model and behind the map"),
               0, true, "pattern"},
    ActionInfo{"view.pattern.texture", "View/Pattern", QT_TRANSLATE_NOOP("Actions", "&Texture"), "texture",
               "", QT_TRANSLATE_NOOP("Actions", "The texture on the model and behind the map"), 0, true,
               "pattern"},
    ActionInfo{"view.texture", "View", QT_TRANSLATE_NOOP("Actions", "Next pa&ttern"), "checker", "T",
               QT_TRANSLATE_NOOP("Actions", "Change between no pattern, the checkerboard and the texture")},
    ActionInfo{"view.loadTexture", "View", QT_TRANSLATE_NOOP("Actions", "&Load texture..."), "texture",
               "Ctrl+T", QT_TRANSLATE_NOOP("Actions", "Choose the picture to show on the model")},
    ActionInfo{"view.smoothShading", "View", QT_TRANSLATE_NOOP("Actions", "S&mooth shading"), "shading", "",
               QT_TRANSLATE_NOOP("Actions", "Shade the model smoothly, or every face flat"), 0, true, "",
               true},
    ActionInfo{"view.wireframe", "View", QT_TRANSLATE_NOOP("Actions", "&Wireframe"), "wireframe", "Shift+Z",
               QT_TRANSLATE_NOOP("Actions", "Show the edges of the polygons"), 0, true},
    ActionInfo{"view.seams", "View", QT_TRANSLATE_NOOP("Actions", "S&eams"), "seams", "",
               QT_TRANSLATE_NOOP("Actions", "Show the seams, or while solving where they begin to open"), 0,
               true},
    ActionInfo{"view.steering", "View", QT_TRANSLATE_NOOP("Actions", "Stee&ring"), "tool-rectangle", "",
               QT_TRANSLATE_NOOP("Actions", "Show forced cuts and joins, pins and rectangles"), 0, true},
    ActionInfo{"view.problems", "View", QT_TRANSLATE_NOOP("Actions", "Fli&ps and overlaps"), "overlap", "",
               QT_TRANSLATE_NOOP("Actions", "Mark flipped faces and hatch overlaps"), 0, true},
    ActionInfo{"view.fillIslands", "View", QT_TRANSLATE_NOOP("Actions", "F&ill islands"), "mode-islands", "",
               QT_TRANSLATE_NOOP("Actions", "Fill the islands in the UV view"), 0, true},
    ActionInfo{"view.grid", "View", QT_TRANSLATE_NOOP("Actions", "&Grid"), "grid", "",
               QT_TRANSLATE_NOOP("Actions", "Show the grid and the texture tiles"), 0, true},
    ActionInfo{"view.rulers", "View", QT_TRANSLATE_NOOP("Actions", "Rulers"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Show rulers in texels in the UV view"), 0, true},
    ActionInfo{"view.orthographic", "View", QT_TRANSLATE_NOOP("Actions", "&Orthographic"), "", "Num+5; 5",
               QT_TRANSLATE_NOOP("Actions", "Show the model without perspective"), 0, true},
    ActionInfo{"view.resetPanels", "View/Panels", QT_TRANSLATE_NOOP("Actions", "&Restore the arrangement"),
               "", "", QT_TRANSLATE_NOOP("Actions", "Put all panels where they were at first"), 0, false, "",
               true},
};

constexpr std::array helpTable{
    ActionInfo{"help.shortcuts", "Help", QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts"), "help", "F1",
               QT_TRANSLATE_NOOP("Actions", "List all keys")},
    ActionInfo{"help.recovery", "Help", QT_TRANSLATE_NOOP("Actions", "&Recovery folder"), "open", "",
               QT_TRANSLATE_NOOP("Actions", "Show the folder in which autosaves are kept")},
    ActionInfo{"help.about", "Help", QT_TRANSLATE_NOOP("Actions", "&About Autocuts"), "about", "",
               QT_TRANSLATE_NOOP("Actions", "Version, licence and libraries"), 0, false, "", true},
};

template <std::size_t... Sizes>
constexpr auto joined(const std::array<ActionInfo, Sizes> &...tables)
{
    std::array<ActionInfo, (Sizes + ...)> result{};
    std::size_t next = 0;
    const auto append = [&](const auto &table) {
        for (const ActionInfo &info : table)
            result[next++] = info;
    };
    (append(tables), ...);
    return result;
}

constexpr auto wholeTable = joined(fileTable, editTable, selectTable, uvTable, viewTable, helpTable);

} // namespace

std::span<const ActionInfo> actionTable()
{
    return wholeTable;
}

} // namespace autocuts
