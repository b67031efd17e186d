// The rows of the action table for arranging islands. Included by actiontable.cpp only.
#pragma once

#include "views/actions/actioninfo.h"

#include <QtGlobal>

#include <array>

namespace autocuts {

inline constexpr int NeedsIdleMap = NeedsDocument | NeedsUvs | NeedsIdle;
inline constexpr int NeedsPieces = NeedsIdleMap | NeedsSelection;

//! Actions that arrange islands, in their own menus.
inline constexpr std::array layoutTable{
    ActionInfo{
        "uv.alignLeft", "UV/Layout/Align", QT_TRANSLATE_NOOP("Actions", "&Left sides"), "align-left",
        "Ctrl+Left",
        QT_TRANSLATE_NOOP(
            "Actions",
            "Align the left sides of the selected islands; one island alone goes to the side of its tile"),
        NeedsPieces},
    ActionInfo{
        "uv.alignCentreU", "UV/Layout/Align", QT_TRANSLATE_NOOP("Actions", "&Centres on a vertical line"),
        "align-centre-u", "",
        QT_TRANSLATE_NOOP("Actions", "Bring the centres of the selected islands onto one vertical line"),
        NeedsPieces},
    ActionInfo{"uv.alignRight", "UV/Layout/Align", QT_TRANSLATE_NOOP("Actions", "&Right sides"),
               "align-right", "Ctrl+Right",
               QT_TRANSLATE_NOOP("Actions", "Align the right sides of the selected islands"), NeedsPieces},
    ActionInfo{"uv.alignTop", "UV/Layout/Align", QT_TRANSLATE_NOOP("Actions", "&Top sides"), "align-top",
               "Ctrl+Up", QT_TRANSLATE_NOOP("Actions", "Align the top sides of the selected islands"),
               NeedsPieces},
    ActionInfo{
        "uv.alignCentreV", "UV/Layout/Align", QT_TRANSLATE_NOOP("Actions", "Centres on a &horizontal line"),
        "align-centre-v", "",
        QT_TRANSLATE_NOOP("Actions", "Bring the centres of the selected islands onto one horizontal line"),
        NeedsPieces},
    ActionInfo{"uv.alignBottom", "UV/Layout/Align", QT_TRANSLATE_NOOP("Actions", "&Bottom sides"),
               "align-bottom", "Ctrl+Down",
               QT_TRANSLATE_NOOP("Actions", "Align the bottom sides of the selected islands"), NeedsPieces},
    ActionInfo{
        "uv.distributeU", "UV/Layout/Distribute", QT_TRANSLATE_NOOP("Actions", "&Centres from left to right"),
        "distribute-u", "",
        QT_TRANSLATE_NOOP("Actions",
                          "Put the centres of the selected islands at equal distances from left to right"),
        NeedsPieces},
    ActionInfo{
        "uv.distributeV", "UV/Layout/Distribute", QT_TRANSLATE_NOOP("Actions", "Centres from top to &bottom"),
        "distribute-v", "",
        QT_TRANSLATE_NOOP("Actions",
                          "Put the centres of the selected islands at equal distances from top to bottom"),
        NeedsPieces},
    ActionInfo{
        "uv.distributeGapsU", "UV/Layout/Distribute",
        QT_TRANSLATE_NOOP("Actions", "&Gaps from left to right"), "distribute-gaps-u", "",
        QT_TRANSLATE_NOOP("Actions", "Make the gaps between the selected islands equal from left to right"),
        NeedsPieces, false, "", true},
    ActionInfo{
        "uv.distributeGapsV", "UV/Layout/Distribute",
        QT_TRANSLATE_NOOP("Actions", "Gaps from to&p to bottom"), "distribute-gaps-v", "",
        QT_TRANSLATE_NOOP("Actions", "Make the gaps between the selected islands equal from top to bottom"),
        NeedsPieces},
    ActionInfo{"uv.mirrorU", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Mirror from &left to right"),
               "mirror-u", "Ctrl+M",
               QT_TRANSLATE_NOOP("Actions", "Turn the selected islands over in place: their picture is "
                                            "mirrored, which is reported as mirrored and not as flipped"),
               NeedsPieces, false, "", true},
    ActionInfo{"uv.mirrorV", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Mirror from &top to bottom"),
               "mirror-v", "Ctrl+Shift+M",
               QT_TRANSLATE_NOOP("Actions", "Turn the selected islands over in place: their picture is "
                                            "mirrored, which is reported as mirrored and not as flipped"),
               NeedsPieces},
    ActionInfo{"uv.turnLeft", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Turn a quarter le&ft"), "turn-left",
               "Alt+Left",
               QT_TRANSLATE_NOOP("Actions", "Turn the selected islands by 90 degrees about the pivot"),
               NeedsPieces},
    ActionInfo{"uv.turnRight", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Turn a &quarter right"),
               "turn-right", "Alt+Right",
               QT_TRANSLATE_NOOP("Actions", "Turn the selected islands by 90 degrees about the pivot"),
               NeedsPieces},
    ActionInfo{"uv.fitTile", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Fit to t&he tile"), "fit-tile",
               "Shift+F",
               QT_TRANSLATE_NOOP("Actions",
                                 "Move and scale the selected islands together so that they fill their tile"),
               NeedsPieces},
    ActionInfo{
        "uv.toTexture", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Squeeze to the texture's shape"), "", "",
        QT_TRANSLATE_NOOP("Actions", "Scale V of the selected islands by height / width of the texture: "
                                     "for maps that were made for a texture of this shape, before it "
                                     "was set in the Packing panel"),
        NeedsPieces},
    ActionInfo{
        "uv.orientBox", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "&Orient to the smallest box"),
        "orient-box", "Ctrl+U",
        QT_TRANSLATE_NOOP("Actions",
                          "Turn each selected island so that the smallest box around it lies along the axes"),
        NeedsPieces, false, "", true},
    ActionInfo{"uv.orientEdges", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Orient to selected &edges"),
               "orient-edges", "Ctrl+Shift+U",
               QT_TRANSLATE_NOOP("Actions", "Turn the islands so that the selected edges lie along the axes"),
               NeedsIdleMap | NeedsSelectedEdges},
    ActionInfo{"uv.alignAxes", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Align to the axes"), "align-axes",
               "Ctrl+Alt+A",
               QT_TRANSLATE_NOOP("Actions",
                                 "Turn the selected islands to the axes and make straight what is straight "
                                 "on the model, with little distortion"),
               NeedsPieces},
    ActionInfo{
        "uv.straighten", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "&Straighten edges"), "straighten",
        "Shift+G",
        QT_TRANSLATE_NOOP(
            "Actions", "Make each chain of selected edges a straight line; the rest of its island follows"),
        NeedsIdleMap | NeedsSelectedEdges, false, "", true},
    ActionInfo{"uv.grid", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Straighten to a &grid"), "grid", "Alt+G",
               QT_TRANSLATE_NOOP("Actions",
                                 "Make the selected quads a rectangle of straight rows and columns, each as "
                                 "wide as on the model; the rest of their islands follows"),
               NeedsIdleMap | NeedsSelectedFaces},
    ActionInfo{
        "uv.relax", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Rela&x selected faces"), "relax", "Shift+R",
        QT_TRANSLATE_NOOP("Actions", "Make the distortion of the selected faces small while all others stay"),
        NeedsIdleMap | NeedsSelectedFaces},
    ActionInfo{"uv.stackCopies", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Stack &identical islands"),
               "stack", "Ctrl+Alt+K",
               QT_TRANSLATE_NOOP("Actions", "Lay copies exactly on top of each other and pack them as one; "
                                            "one island alone finds all its copies"),
               NeedsPieces, false, "", true},
    ActionInfo{"uv.unstackCopies", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Lay stac&ks apart"), "unstack",
               "Ctrl+Alt+Shift+K",
               QT_TRANSLATE_NOOP("Actions",
                                 "Take the selected islands out of their stacks and lay them beside the map"),
               NeedsPieces},
    ActionInfo{"uv.makeUnique", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "&Make meshes unique"), "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Give each object that shares a mesh with others in the file of the model "
                                 "a mesh and a map of its own"),
               NeedsDocument},
    ActionInfo{
        "uv.scatter", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "&Randomise..."), "scatter", "",
        QT_TRANSLATE_NOOP("Actions", "Move, turn and scale the selected islands at random, within limits"),
        NeedsPieces, false, "", true},
    ActionInfo{
        "uv.densitySet", "UV/Layout", QT_TRANSLATE_NOOP("Actions", "Set texel &density..."), "density", "",
        QT_TRANSLATE_NOOP("Actions",
                          "Scale the selected islands to a texel density in texels per unit of the model"),
        NeedsPieces},
};

} // namespace autocuts
