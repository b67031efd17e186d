// Ids of the commands. They are stored in journals: never change or reuse one.
#pragma once

namespace autocuts {

//! Each has a row in commandfactory.cpp.
enum class CommandId {
    SetSeamState = 1,
    SetSeamWeights = 2,
    EditRectangles = 3,
    EditPins = 4,
    SetUvs = 5,
    ChangeSettings = 6,
    ChooseUvSet = 7,
    AddUvSet = 8,
    RenameUvSet = 9,
    DeleteUvSet = 10,
    SetIslandFlags = 11,
    SetIslandTag = 12,
    Reset = 13,
    StackIslands = 14,
    EditMapSeams = 15,
    ReplaceModel = 16,
    KeepStraight = 17,
    SetTexelWeights = 18,
    HideFaces = 19,
    EditTextures = 20,
    MakeUnique = 21,
    End //!< no command: one more than the last id
};

} // namespace autocuts
