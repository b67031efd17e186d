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
