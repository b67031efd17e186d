// One row of the table of actions.
#pragma once

namespace autocuts {

//! What must be there for an action to be possible.
enum ActionNeed {
    NeedsDocument = 1 << 0,
    NeedsUvs = 1 << 1, //!< the active set has UVs, or the solver a map for it
    NeedsSelection = 1 << 2,
    NeedsSelectedEdges = 1 << 3,
    NeedsSelectedFaces = 1 << 4,
    NeedsUndo = 1 << 5,
    NeedsRedo = 1 << 6,
    NeedsIdle = 1 << 7,         //!< no job is running
    NeedsJob = 1 << 8,          //!< a job is running
    NeedsOverlaps = 1 << 9,     //!< the map was measured and has overlaps
    NeedsEdgesOrFaces = 1 << 10 //!< some are selected
};

//! One action. Texts are English sources for tr() in the context "Actions".
struct ActionInfo
{
    const char *id;   //!< "file.open"; part of the preferences file, never changed
    const char *menu; //!< "File", "File/Open sample", ...: path of the menu; empty: in no menu
    const char *text; //!< as in the menu, with its mnemonic
    const char *icon; //!< name of an icon in resources/icons; empty: none
    const char *keys; //!< default shortcuts, portable text, "; " between them; empty: none
    const char *tip;  //!< what it does, one sentence
    int needs = 0;    //!< mask of ActionNeed
    bool checkable = false;
    const char *group = "";       //!< checkable actions of one group exclude each other
    bool separatorBefore = false; //!< in its menu; of the first action of a submenu: before the submenu
};

} // namespace autocuts
