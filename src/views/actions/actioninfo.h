// One row of the table of actions.
#pragma once

namespace autocuts {

//! Conditions for an action to be enabled.
enum ActionNeed {
    NeedsDocument = 1 << 0,
    NeedsUvs = 1 << 1, //!< the active set has UVs, or a solve has made some for it
    NeedsSelection = 1 << 2,
    NeedsSelectedEdges = 1 << 3,
    NeedsSelectedFaces = 1 << 4,
    NeedsUndo = 1 << 5,
    NeedsRedo = 1 << 6,
    NeedsIdle = 1 << 7,          //!< no job is running
    NeedsJob = 1 << 8,           //!< a job is running
    NeedsOverlaps = 1 << 9,      //!< the map was measured and has overlaps
    NeedsEdgesOrFaces = 1 << 10, //!< edges or faces are selected
    NeedsHidden = 1 << 11,       //!< faces are hidden
    NeedsFile = 1 << 12,         //!< the model came from a file
    NeedsSeveralSets = 1 << 13   //!< there are several UV sets
};

//! One action. Texts are English sources for tr() in the context "Actions".
struct ActionInfo
{
    const char *id;   //!< such as "file.open"; stored in the preferences file, never change it
    const char *menu; //!< path of the menu, such as "File" or "File/Open sample"; empty: in no menu
    const char *text; //!< text in the menu, with its mnemonic
    const char *icon; //!< name of an icon in resources/icons; empty: none
    const char *keys; //!< default shortcuts in portable text, separated by "; "; empty: none
    const char *tip;  //!< what it does, one sentence
    int needs = 0;    //!< mask of ActionNeed
    bool checkable = false;
    const char *group = ""; //!< checkable actions of one group exclude each other
    //! Put a separator before it, or before its submenu when it is the first action there.
    bool separatorBefore = false;
};

} // namespace autocuts
