// The rows of the action table for selecting what is alike or of one kind. Included by actiontable.cpp only.
#pragma once

#include "views/actions/actioninfo.h"

#include <QtGlobal>

#include <array>

namespace autocuts {

//! Actions in the submenus of the Select menu.
inline constexpr std::array kindTable{
    ActionInfo{"select.similarArea", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "Of the same &area"), "similar", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Select the faces with an area like that of a selected one, within a tenth"),
               NeedsSelection, false, "", true},
    ActionInfo{"select.similarNormal", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "Of the same &direction"), "similar", "",
               QT_TRANSLATE_NOOP(
                   "Actions", "Select the faces that look the same way as a selected one, within 10 degrees"),
               NeedsSelection},
    ActionInfo{"select.similarMaterial", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "Of the same &material"), "similar", "",
               QT_TRANSLATE_NOOP("Actions", "Select the faces that have the material of a selected one"),
               NeedsSelection},
    ActionInfo{"select.similarCorners", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "With as many &corners"), "similar", "",
               QT_TRANSLATE_NOOP("Actions", "Select the faces with as many corners as a selected one: all "
                                            "triangles, or all quads"),
               NeedsSelection},
    ActionInfo{"select.similarShape", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "Of the same &shape"), "similar", "",
               QT_TRANSLATE_NOOP("Actions", "Select the faces with sides and angles like those of a selected "
                                            "one, at any size, turned or mirrored"),
               NeedsSelection},
    ActionInfo{"select.similarAreaInMap", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "Of the same area in the ma&p"), "similar", "",
               QT_TRANSLATE_NOOP("Actions", "Select the faces that take as much of the texture as a selected "
                                            "one, within a tenth"),
               NeedsSelection | NeedsUvs},
    ActionInfo{"select.flat", "Select/Similar faces",
               QT_TRANSLATE_NOOP("Actions", "&Flat with the selection..."), "linked", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Select the connected faces between which the model is bent by no "
                                 "more than an angle"),
               NeedsSelection},
    ActionInfo{"select.similarLength", "Select/Similar edges",
               QT_TRANSLATE_NOOP("Actions", "Of the same &length"), "similar", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Select the edges that are as long on the model as a selected one, "
                                 "within a tenth"),
               NeedsSelectedEdges},
    ActionInfo{"select.similarLengthInMap", "Select/Similar edges",
               QT_TRANSLATE_NOOP("Actions", "Of the same length in the &map"), "similar", "",
               QT_TRANSLATE_NOOP("Actions", "Select the edges that are as long in the map as a selected one, "
                                            "within a tenth"),
               NeedsSelectedEdges | NeedsUvs},
    ActionInfo{"select.similarDirection", "Select/Similar edges",
               QT_TRANSLATE_NOOP("Actions", "Of the same &direction in the map"), "similar", "",
               QT_TRANSLATE_NOOP("Actions", "Select the edges that run in the map as a selected one does, "
                                            "within 10 degrees"),
               NeedsSelectedEdges | NeedsUvs},
    ActionInfo{"select.ring", "Select/Rows", QT_TRANSLATE_NOOP("Actions", "Edge &ring"), "loop", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Select the edges that lie across quads from the selected ones, and so on"),
               NeedsSelectedEdges},
    ActionInfo{"select.strip", "Select/Rows", QT_TRANSLATE_NOOP("Actions", "Strip of &faces"), "loop", "",
               QT_TRANSLATE_NOOP("Actions", "Select the rows of quads through the selected faces: in the "
                                            "direction of two neighbours, or in both"),
               NeedsSelectedFaces},
    ActionInfo{"select.everySecond", "Select/Rows", QT_TRANSLATE_NOOP("Actions", "&Every second one"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Keep every second element of the selection: a checkerboard of "
                                            "faces, every second edge of a loop"),
               NeedsSelection},
    ActionInfo{"select.growAlong", "Select/Rows", QT_TRANSLATE_NOOP("Actions", "&Grow along rows"), "grow",
               "", QT_TRANSLATE_NOOP("Actions", "Add one element at both ends of each row of selected ones"),
               NeedsSelection},
    ActionInfo{
        "select.shrinkAlong", "Select/Rows", QT_TRANSLATE_NOOP("Actions", "&Shrink along rows"), "shrink", "",
        QT_TRANSLATE_NOOP("Actions", "Take away the elements at both ends of each row of selected ones"),
        NeedsSelection},
    ActionInfo{
        "select.sharp", "Select/Edges", QT_TRANSLATE_NOOP("Actions", "&Sharp edges..."), "mode-edges",
        "Ctrl+Alt+S",
        QT_TRANSLATE_NOOP("Actions", "Select the edges at which the model is bent by more than an angle"),
        NeedsDocument},
    ActionInfo{"select.border", "Select/Edges", QT_TRANSLATE_NOOP("Actions", "&Border of the model"),
               "mode-edges", "",
               QT_TRANSLATE_NOOP("Actions", "Select the edges that have one face only: the rims of holes"),
               NeedsDocument},
    ActionInfo{"select.seams", "Select/Edges", QT_TRANSLATE_NOOP("Actions", "S&eams of the map"), "seams", "",
               QT_TRANSLATE_NOOP("Actions", "Select the edges at which the map is cut apart"),
               NeedsDocument | NeedsUvs},
    ActionInfo{"select.outline", "Select/Edges", QT_TRANSLATE_NOOP("Actions", "&Outline of the selection"),
               "mode-edges", "", QT_TRANSLATE_NOOP("Actions", "Select the edges around the selected faces"),
               NeedsSelectedFaces},
    ActionInfo{"select.stretched", "Select/Islands",
               QT_TRANSLATE_NOOP("Actions", "&Stretched above the bound"), "heat-map", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Select the islands that are distorted more than the stretch that "
                                 "the session allows"),
               NeedsDocument | NeedsUvs},
    ActionInfo{"select.small", "Select/Islands", QT_TRANSLATE_NOOP("Actions", "S&mall ones..."), "island", "",
               QT_TRANSLATE_NOOP("Actions", "Select the islands that are less than some texels long"),
               NeedsDocument | NeedsUvs},
    ActionInfo{
        "select.offDensity", "Select/Islands", QT_TRANSLATE_NOOP("Actions", "Texel density &outliers..."),
        "density", "",
        QT_TRANSLATE_NOOP("Actions", "Select the islands with more or fewer texels per unit than most"),
        NeedsDocument | NeedsUvs},
};

} // namespace autocuts
