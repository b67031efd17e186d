// Numbers of the commands. They stand in journals: never change one or use it again.
#pragma once

namespace autocuts {

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
    StackIslands = 14
};

} // namespace autocuts
