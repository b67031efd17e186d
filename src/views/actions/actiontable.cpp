// The table of all actions, in the order of the menus.
#include "views/actions/actiontable.h"

#include "views/actions/kindtable.h"
#include "views/actions/layouttable.h"
#include "views/actions/viewtable.h"

#include <QtGlobal>

#include <array>

namespace autocuts {

namespace {

constexpr int NeedsIdleDocument = NeedsDocument | NeedsIdle;
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
    ActionInfo{"file.watch", "File", QT_TRANSLATE_NOOP("Actions", "&Watch the file"), "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Re-link the model whenever another program saves its file. The session "
                                 "remembers it"),
               NeedsDocument | NeedsFile, true},
    ActionInfo{"file.exportAgain", "File", QT_TRANSLATE_NOOP("Actions", "Export a&gain after each re-link"),
               "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Write the model with its UV map beside its file, as NAME_uv, after each "
                                 "re-link. The session remembers it"),
               NeedsDocument | NeedsFile, true},
    ActionInfo{"file.exportMesh", "File", QT_TRANSLATE_NOOP("Actions", "&Export mesh..."), "export-mesh",
               "Ctrl+E", QT_TRANSLATE_NOOP("Actions", "Write the model with its UV map"), NeedsIdleDocument,
               false, "", true},
    ActionInfo{"file.exportLayout", "File", QT_TRANSLATE_NOOP("Actions", "Export la&yout..."),
               "export-layout", "Ctrl+Shift+E", QT_TRANSLATE_NOOP("Actions", "Write a picture of the UV map"),
               NeedsIdleMap},
    ActionInfo{"file.exportReport", "File", QT_TRANSLATE_NOOP("Actions", "Export re&port..."), "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Write the figures of the map, of objects, materials and tiles as "
                                 "JSON, as the command line does"),
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
    ActionInfo{"select.tags", "Select", QT_TRANSLATE_NOOP("Actions", "Tags of islands..."), "", "",
               QT_TRANSLATE_NOOP("Actions", "Give the selected islands a tag, take it from them, or select "
                                            "the islands that have one"),
               NeedsUvs},
    ActionInfo{"select.overlapping", "Select", QT_TRANSLATE_NOOP("Actions", "O&verlapping faces"), "overlap",
               "", QT_TRANSLATE_NOOP("Actions", "Select the faces that overlap others in the map"),
               NeedsOverlaps},
    ActionInfo{"select.nextOverlap", "Select", QT_TRANSLATE_NOOP("Actions", "Ne&xt overlap"), "overlap", "]",
               QT_TRANSLATE_NOOP("Actions", "Select the next overlap in the map, and show it"),
               NeedsOverlaps},
    ActionInfo{"select.previousOverlap", "Select", QT_TRANSLATE_NOOP("Actions", "&Previous overlap"), "", "[",
               QT_TRANSLATE_NOOP("Actions", "Select the overlap before, and show it"), NeedsOverlaps},
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
    ActionInfo{"uv.runSelection", "UV", QT_TRANSLATE_NOOP("Actions", "Run on selection"), "run", "Ctrl+Space",
               QT_TRANSLATE_NOOP("Actions", "Let the solver change the selected faces only, until it pauses; "
                                            "the map stays continuous with the rest of their islands"),
               NeedsIdleMap | NeedsSelectedFaces},
    ActionInfo{"uv.step", "UV", QT_TRANSLATE_NOOP("Actions", "&One step"), "step", "Shift+Space",
               QT_TRANSLATE_NOOP("Actions", "Make one step of the solver"), NeedsIdleDocument},
    ActionInfo{"uv.restart", "UV", QT_TRANSLATE_NOOP("Actions", "R&estart"), "restart", "Ctrl+R",
               QT_TRANSLATE_NOOP("Actions", "Begin the solve again from its start"), NeedsIdleDocument},
    ActionInfo{"uv.lambdaLess", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "&Less weight on seams"),
               "lambda-down", "Left",
               QT_TRANSLATE_NOOP("Actions", "Lower lambda: less distortion, longer seams"), NeedsDocument,
               false, "", true},
    ActionInfo{"uv.lambdaMore", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "&More weight on seams"),
               "lambda-up", "Right",
               QT_TRANSLATE_NOOP("Actions", "Raise lambda: shorter seams, more distortion"), NeedsDocument},
    ActionInfo{"uv.deltaDouble", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "Softer seams (double delta)"), "",
               "Up", QT_TRANSLATE_NOOP("Actions", "Double delta: cuts become softer and may move"),
               NeedsDocument},
    ActionInfo{"uv.deltaHalve", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "S&harper seams (halve delta)"), "",
               "Down", QT_TRANSLATE_NOOP("Actions", "Halve delta: cuts become definite"), NeedsDocument},
    ActionInfo{"uv.budget", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "Distortion &budget"), "budget",
               "Ctrl+B",
               QT_TRANSLATE_NOOP("Actions", "Let the solver choose lambda and delta for a distortion bound"),
               0, true},
    ActionInfo{"uv.soup", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "Show the soup while solving"), "",
               "Shift+B",
               QT_TRANSLATE_NOOP("Actions",
                                 "While the solver runs, show the separate triangles that lambda and delta "
                                 "act on instead of the definite map"),
               0, true},
    ActionInfo{"uv.ghost", "UV/Solver", QT_TRANSLATE_NOOP("Actions", "Ghost while solving"), "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "While the solver runs, let the soup shine through the definite map, or the "
                                 "map through the soup"),
               0, true},
    ActionInfo{"uv.start.rigid", "UV/Solver/Start mode", QT_TRANSLATE_NOOP("Actions", "&Rigid triangles"), "",
               "", QT_TRANSLATE_NOOP("Actions", "Start from every triangle laid flat on its own"),
               NeedsDocument, true, "start"},
    ActionInfo{"uv.start.tutte", "UV/Solver/Start mode", QT_TRANSLATE_NOOP("Actions", "&Tutte embedding"), "",
               "", QT_TRANSLATE_NOOP("Actions", "Start from a Tutte embedding"), NeedsDocument, true,
               "start"},
    ActionInfo{"uv.start.random", "UV/Solver/Start mode", QT_TRANSLATE_NOOP("Actions", "Ra&ndom"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Start from triangles at random places"), NeedsDocument, true,
               "start"},
    ActionInfo{"uv.start.existing", "UV/Solver/Start mode", QT_TRANSLATE_NOOP("Actions", "&Existing UVs"), "",
               "", QT_TRANSLATE_NOOP("Actions", "Start from the UVs that there are"), NeedsDocument, true,
               "start"},
    ActionInfo{"uv.energy.symmetricDirichlet", "UV/Solver/Energy",
               QT_TRANSLATE_NOOP("Actions", "&Symmetric Dirichlet"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Keep lengths"), NeedsDocument, true, "energy"},
    ActionInfo{"uv.energy.amips", "UV/Solver/Energy", QT_TRANSLATE_NOOP("Actions", "&AMIPS"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Keep angles more than areas"), NeedsDocument, true, "energy"},
    ActionInfo{"uv.weighting.length", "UV/Solver/Seam weighting", QT_TRANSLATE_NOOP("Actions", "By &length"),
               "", "", QT_TRANSLATE_NOOP("Actions", "Make the total length of the seams small"),
               NeedsDocument, true, "weighting"},
    ActionInfo{"uv.weighting.count", "UV/Solver/Seam weighting", QT_TRANSLATE_NOOP("Actions", "By &count"),
               "", "", QT_TRANSLATE_NOOP("Actions", "Make the number of cut edges small"), NeedsDocument,
               true, "weighting"},
    ActionInfo{
        "uv.unwrap", "UV", QT_TRANSLATE_NOOP("Actions", "&Unwrap"), "unwrap", "U",
        QT_TRANSLATE_NOOP("Actions", "Make the whole map: solve, finish, take overlaps apart and pack"),
        NeedsIdleDocument, false, "", true},
    ActionInfo{
        "uv.unwrapSelection", "UV", QT_TRANSLATE_NOOP("Actions", "Unwrap selection"), "unwrap", "Shift+U",
        QT_TRANSLATE_NOOP("Actions", "Make the map of the selected faces anew; it stays continuous with "
                                     "the rest of their islands, and nothing else changes"),
        NeedsIdleMap | NeedsSelection},
    ActionInfo{"uv.unwrapSelectionFree", "UV", QT_TRANSLATE_NOOP("Actions", "Unwrap selection, cut free"),
               "unwrap", "Ctrl+Alt+U",
               QT_TRANSLATE_NOOP("Actions",
                                 "Cut the selected faces out of their islands and make their map anew; "
                                 "nothing else changes"),
               NeedsIdleMap | NeedsSelection},
    ActionInfo{"uv.finish", "UV", QT_TRANSLATE_NOOP("Actions", "&Finish"), "finish", "Ctrl+Return",
               QT_TRANSLATE_NOOP("Actions", "Make a final map with definite seams and no overlaps"),
               NeedsIdleMap},
    ActionInfo{"uv.finishSelection", "UV", QT_TRANSLATE_NOOP("Actions", "Finish selection"), "finish",
               "Ctrl+Shift+Return",
               QT_TRANSLATE_NOOP("Actions", "Finish the map of the selected faces; nothing else changes"),
               NeedsIdleMap | NeedsSelection},
    ActionInfo{"uv.pack", "UV", QT_TRANSLATE_NOOP("Actions", "&Pack"), "pack", "P",
               QT_TRANSLATE_NOOP("Actions", "Arrange all islands in the texture"), NeedsIdleMap},
    ActionInfo{"uv.packObjects", "UV/Pack into tiles",
               QT_TRANSLATE_NOOP("Actions", "Pack a tile for each &object"), "pack", "",
               QT_TRANSLATE_NOOP("Actions", "Give every object a UDIM tile of its own, in the order of the "
                                            "file; islands that are selected, or all of them"),
               NeedsIdleMap},
    ActionInfo{"uv.packMaterials", "UV/Pack into tiles",
               QT_TRANSLATE_NOOP("Actions", "Pack a tile for each &material"), "pack", "",
               QT_TRANSLATE_NOOP("Actions", "Give every material a UDIM tile of its own, in the order of the "
                                            "file; islands that are selected, or all of them"),
               NeedsIdleMap},
    ActionInfo{"uv.packTags", "UV/Pack into tiles", QT_TRANSLATE_NOOP("Actions", "Pack a tile for each &tag"),
               "pack", "",
               QT_TRANSLATE_NOOP("Actions", "Give the islands of every tag a UDIM tile of their own, those "
                                            "without a tag the last one; islands that are selected, or all "
                                            "of them"),
               NeedsIdleMap},
    ActionInfo{"uv.packDensity", "UV/Pack into tiles",
               QT_TRANSLATE_NOOP("Actions", "Pack at a texel &density..."), "pack", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Give islands a texel density and pack them into as many UDIM tiles as that "
                                 "needs; islands that are selected, or all of them"),
               NeedsIdleMap},
    ActionInfo{"uv.fillTiles", "UV/Pack into tiles", QT_TRANSLATE_NOOP("Actions", "&Fill the tiles in use"),
               "pack-selection", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Pack the selected islands into the free room of the tiles in which the "
                                 "others lie, at their texel density; what does not fit gets new tiles"),
               NeedsIdleMap | NeedsSelection},
    ActionInfo{
        "uv.sendToTile", "UV/Pack into tiles", QT_TRANSLATE_NOOP("Actions", "&Send to a tile..."), "", "",
        QT_TRANSLATE_NOOP("Actions", "Move the selected islands into a UDIM tile, to the same place in it"),
        NeedsIslands},
    ActionInfo{"uv.lockTile", "UV/Pack into tiles", QT_TRANSLATE_NOOP("Actions", "&Lock or unlock the tile"),
               "lock", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Lock all islands of the tiles of the selected islands, or unlock "
                                 "them when all are locked"),
               NeedsIslands},
    ActionInfo{"uv.packSelection", "UV", QT_TRANSLATE_NOOP("Actions", "Pack &selection"), "pack-selection",
               "Shift+P", QT_TRANSLATE_NOOP("Actions", "Arrange the selected islands around the others"),
               NeedsIdleMap | NeedsSelection},
    ActionInfo{"uv.separate", "UV", QT_TRANSLATE_NOOP("Actions", "Separate o&verlaps"), "separate", "O",
               QT_TRANSLATE_NOOP("Actions", "Cut islands that cover themselves, and pack"), NeedsIdleMap},
    ActionInfo{
        "uv.separateGreedy", "UV", QT_TRANSLATE_NOOP("Actions", "Separate overlaps greedily"), "separate", "",
        QT_TRANSLATE_NOOP("Actions", "Cut islands that cover themselves into regions that grow breadth "
                                     "first, and pack: more cuts, found at once"),
        NeedsIdleMap},
    ActionInfo{"uv.density", "UV/Texel density", QT_TRANSLATE_NOOP("Actions", "E&qualise texel density"),
               "density", "Shift+E", QT_TRANSLATE_NOOP("Actions", "Give every island the same texel density"),
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
    ActionInfo{"uv.rip", "UV", QT_TRANSLATE_NOOP("Actions", "Rip"), "rip", "V",
               QT_TRANSLATE_NOOP("Actions", "Cut the map apart along the selected edges, or around the "
                                            "selected faces, at once and without a solve"),
               NeedsIdleMap | NeedsEdgesOrFaces},
    ActionInfo{"uv.stitch", "UV", QT_TRANSLATE_NOOP("Actions", "Stitch"), "stitch", "Shift+V",
               QT_TRANSLATE_NOOP("Actions", "Bring the two sides of the selected seams together at once: the "
                                            "smaller island comes to the larger one"),
               NeedsIdleMap | NeedsEdgesOrFaces},
    ActionInfo{"uv.keepStraight", "UV", QT_TRANSLATE_NOOP("Actions", "&Keep straight"), "keep-straight",
               "Shift+S",
               QT_TRANSLATE_NOOP("Actions", "Unwrap, Finish and the live solve lay the selected edges on "
                                            "lines of the map"),
               NeedsSelectedEdges, false, "", true},
    ActionInfo{"uv.releaseStraight", "UV", QT_TRANSLATE_NOOP("Actions", "Release straight edges"),
               "release-straight", "Alt+Shift+S",
               QT_TRANSLATE_NOOP("Actions", "The selected edges need not be straight in the map"),
               NeedsSelectedEdges},
    ActionInfo{"uv.pin", "UV", QT_TRANSLATE_NOOP("Actions", "P&in"), "pin", "Ctrl+P",
               QT_TRANSLATE_NOOP("Actions", "Hold the selection where it is in the map"),
               NeedsSelection | NeedsUvs, false, "", true},
    ActionInfo{"uv.unpin", "UV", QT_TRANSLATE_NOOP("Actions", "Unpi&n"), "unpin", "Ctrl+Shift+P",
               QT_TRANSLATE_NOOP("Actions", "Remove the pins of the selection"), NeedsSelection},
    ActionInfo{"uv.texelWeight", "UV/Texel density", QT_TRANSLATE_NOOP("Actions", "&Weight of the faces..."),
               "brush-density", "",
               QT_TRANSLATE_NOOP("Actions", "Say how many times the texels per length the selected faces are "
                                            "to have"),
               NeedsDocument | NeedsSelectedFaces, false, "", true},
    ActionInfo{"uv.clearTexelWeight", "UV/Texel density", QT_TRANSLATE_NOOP("Actions", "&Clear the weight"),
               "clear", "",
               QT_TRANSLATE_NOOP("Actions", "Give the selected faces the usual texel density again"),
               NeedsDocument | NeedsSelectedFaces},
    ActionInfo{"uv.clearTexelWeights", "UV/Texel density", QT_TRANSLATE_NOOP("Actions", "Clear &all weights"),
               "", "", QT_TRANSLATE_NOOP("Actions", "Give all faces the usual texel density again"),
               NeedsDocument},
    ActionInfo{"uv.lock", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Lock"), "lock", "Ctrl+L",
               QT_TRANSLATE_NOOP("Actions", "Keep the selected islands where they are"), NeedsIslands},
    ActionInfo{"uv.unlock", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Unlock"), "unlock", "Ctrl+Shift+L",
               QT_TRANSLATE_NOOP("Actions", "Let the selected islands move again"), NeedsIslands},
    ActionInfo{"uv.keepOrientation", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "Keep &orientation"),
               "upright", "", QT_TRANSLATE_NOOP("Actions", "Packing does not turn the selected islands"),
               NeedsIslands},
    ActionInfo{"uv.freeOrientation", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Free orientation"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Packing may turn the selected islands again"), NeedsIslands},
    ActionInfo{"uv.stack", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "Treat as a &stack"), "stack", "Ctrl+K",
               QT_TRANSLATE_NOOP("Actions",
                                 "Pack the selected islands on top of each other, whether they are "
                                 "alike or not"),
               NeedsIslands, false, "", true},
    ActionInfo{"uv.unstack", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "U&nstack"), "", "Ctrl+Shift+K",
               QT_TRANSLATE_NOOP("Actions", "Pack the selected islands one by one"), NeedsIslands},
    ActionInfo{"uv.group", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "&Group"), "", "Ctrl+G",
               QT_TRANSLATE_NOOP("Actions", "Keep the arrangement of the selected islands"), NeedsIslands,
               false, "", true},
    ActionInfo{"uv.ungroup", "UV/Islands", QT_TRANSLATE_NOOP("Actions", "Ungrou&p"), "", "Ctrl+Shift+G",
               QT_TRANSLATE_NOOP("Actions", "Let the selected islands move on their own"), NeedsIslands},
};

constexpr std::array toolTable{
    ActionInfo{"tool.select", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Select"), "tool-select", "Q",
               QT_TRANSLATE_NOOP("Actions", "Select with the mouse"), NeedsDocument, true, "tool", true},
    ActionInfo{"tool.lasso", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Lasso"), "tool-lasso", "Shift+Q",
               QT_TRANSLATE_NOOP("Actions", "Select what a line drawn with the mouse encloses"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.selectBrush", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "Select &by brush"),
               "tool-select-paint", "B", QT_TRANSLATE_NOOP("Actions", "Select what a brush passes over"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.cut", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "C&ut edges"), "cut", "K",
               QT_TRANSLATE_NOOP("Actions", "Cut edges, ways and loops with the mouse"), NeedsDocument, true,
               "tool", true},
    ActionInfo{"tool.join", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Join edges"), "join", "Shift+J",
               QT_TRANSLATE_NOOP("Actions", "Keep edges, ways and loops together with the mouse"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.paint", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "Paint &weights"), "tool-paint", "W",
               QT_TRANSLATE_NOOP("Actions", "Paint where seams are welcome and where not"), NeedsDocument,
               true, "tool"},
    ActionInfo{"tool.texelWeight", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "Paint &texel density"),
               "brush-density", "Shift+W",
               QT_TRANSLATE_NOOP("Actions", "Paint which faces are to have more texels, and which fewer"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.region", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Overlap region"), "overlap",
               "Shift+O", QT_TRANSLATE_NOOP("Actions", "Select a part without overlaps and drag it away"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.move", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Move islands"), "tool-move", "G",
               QT_TRANSLATE_NOOP("Actions", "Move the selected islands in the map"), NeedsDocument, true,
               "tool", true},
    ActionInfo{"tool.rotate", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Rotate islands"), "tool-rotate", "R",
               QT_TRANSLATE_NOOP("Actions", "Rotate the selected islands in the map"), NeedsDocument, true,
               "tool"},
    ActionInfo{"tool.scale", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "S&cale islands"), "tool-scale", "S",
               QT_TRANSLATE_NOOP("Actions", "Scale the selected islands in the map"), NeedsDocument, true,
               "tool"},
    ActionInfo{"tool.drag", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Drag"), "tool-drag", "D",
               QT_TRANSLATE_NOOP("Actions", "Pull at the map: deform it, tear it, attach it"), NeedsDocument,
               true, "tool", true},
    ActionInfo{"tool.relaxBrush", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "Rela&x brush"), "brush-relax",
               "Alt+R", QT_TRANSLATE_NOOP("Actions", "Lower the distortion of the map under a brush"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.pinchBrush", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "Pinc&h brush"), "brush-pinch",
               "Alt+P", QT_TRANSLATE_NOOP("Actions", "Draw the map together, or apart, under a brush"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.grabBrush", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Grab brush"), "brush-grab",
               "Alt+D",
               QT_TRANSLATE_NOOP("Actions", "Move the part of an island under a brush; nothing overlaps"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.pin", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "&Pin"), "pin", "N",
               QT_TRANSLATE_NOOP("Actions", "Pin and unpin by clicks and boxes, drag pins"), NeedsDocument,
               true, "tool"},
    ActionInfo{"tool.rectangle", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "R&ectangles"), "tool-rectangle",
               "E", QT_TRANSLATE_NOOP("Actions", "Draw rectangles in the map and assign islands to them"),
               NeedsDocument, true, "tool"},
    ActionInfo{"tool.packBox", "UV/Tools", QT_TRANSLATE_NOOP("Actions", "Pack i&nto a box"), "tool-pack-box",
               "Ctrl+Alt+P",
               QT_TRANSLATE_NOOP("Actions", "Drag a box in the map and pack the selected islands into it"),
               NeedsDocument, true, "tool"},
    ActionInfo{"uvset.add", "UV/Sets", QT_TRANSLATE_NOOP("Actions", "&New UV set"), "set-add", "",
               QT_TRANSLATE_NOOP("Actions", "Add a UV set without UVs and choose it"),
               NeedsDocument | NeedsIdle},
    ActionInfo{"uvset.copy", "UV/Sets", QT_TRANSLATE_NOOP("Actions", "&Copy UV set"), "set-copy", "",
               QT_TRANSLATE_NOOP("Actions", "Add a copy of the chosen UV set and choose it"),
               NeedsDocument | NeedsIdle},
    ActionInfo{"uvset.lightmap", "UV/Sets", QT_TRANSLATE_NOOP("Actions", "New set for &lightmaps"),
               "lightmap", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Add a UV set in which every face has a place of its own: stacks are taken "
                                 "apart, overlaps are cut, the margin is that of the Packing panel"),
               NeedsDocument | NeedsIdle},
    ActionInfo{"uvset.delete", "UV/Sets", QT_TRANSLATE_NOOP("Actions", "&Delete UV set"), "cancel", "",
               QT_TRANSLATE_NOOP("Actions", "Delete the chosen UV set; the last one stays"),
               NeedsDocument | NeedsIdle | NeedsSeveralSets},
    ActionInfo{"uvset.next", "UV/Sets", QT_TRANSLATE_NOOP("Actions", "Choose the n&ext UV set"), "",
               "Ctrl+Alt+V",
               QT_TRANSLATE_NOOP("Actions", "Work on the next UV set, after the last one on the first"),
               NeedsDocument | NeedsIdle | NeedsSeveralSets},
    ActionInfo{"uv.transfer", "UV", QT_TRANSLATE_NOOP("Actions", "Transfer UVs from..."), "set-copy", "",
               QT_TRANSLATE_NOOP("Actions", "Bring the UVs of another file, UV set or object onto the model, "
                                            "also of another resolution"),
               NeedsDocument | NeedsIdle},
    ActionInfo{"uv.bake", "UV", QT_TRANSLATE_NOOP("Actions", "Bake..."), "texture", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Bake normals, occlusion and more into pictures for the map, from a "
                                 "detailed model or from this one"),
               NeedsDocument | NeedsIdle},
    ActionInfo{"uv.carryTextures", "UV", QT_TRANSLATE_NOOP("Actions", "Carry textures over..."), "texture",
               "",
               QT_TRANSLATE_NOOP(
                   "Actions", "Make the textures of all materials new for this map, as files, from the map "
                              "that they were made for"),
               NeedsDocument | NeedsIdle},
    ActionInfo{
        "uv.bakeLight", "UV", QT_TRANSLATE_NOOP("Actions", "Bake light..."), "texture", "",
        QT_TRANSLATE_NOOP(
            "Actions",
            "Bake the light of a sun, a sky, area lights and emissive materials into a picture for the map"),
        NeedsDocument | NeedsIdle},
    ActionInfo{"uv.cancel", "UV", QT_TRANSLATE_NOOP("Actions", "Cancel job"), "cancel", "Esc",
               QT_TRANSLATE_NOOP("Actions", "End the running job and keep what it has"), NeedsJob, false, "",
               true},
};

constexpr std::array helpTable{
    ActionInfo{"help.findAction", "Help", QT_TRANSLATE_NOOP("Actions", "&Find action..."), "", "F3",
               QT_TRANSLATE_NOOP("Actions", "Search all actions by name and run one")},
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

constexpr auto wholeTable = joined(fileTable, editTable, selectTable, kindTable, uvTable, layoutTable,
                                   toolTable, viewTable, helpTable);

} // namespace

std::span<const ActionInfo> actionTable()
{
    return wholeTable;
}

} // namespace autocuts
