// All menus at work: what the main window needs to make of the actions.
#pragma once

#include "views/actions/actionstates.h"
#include "views/actions/editactions.h"
#include "views/actions/fileactions.h"
#include "views/actions/helpactions.h"
#include "views/actions/islandactions.h"
#include "views/actions/selectactions.h"
#include "views/actions/uvactions.h"
#include "views/actions/viewactions.h"

namespace autocuts {

//! Connects every action of the table. One per window.
class StudioActions final
{
public:
    //! \param questions asked over the window; outlives this
    StudioActions(const StudioContext &context, Questions &questions, const QString &recoveryFolder)
        : mFile(context, questions), mEdit(context, questions), mSelect(context), mUv(context),
          mIslands(context, questions), mView(context, questions), mHelp(context, questions, recoveryFolder),
          mStates(context)
    {}

    FileActions &file() { return mFile; }
    IslandActions &islands() { return mIslands; }
    ViewActions &view() { return mView; }

private:
    FileActions mFile;
    EditActions mEdit;
    SelectActions mSelect;
    UvActions mUv;
    IslandActions mIslands;
    ViewActions mView;
    HelpActions mHelp;
    ActionStates mStates;
};

} // namespace autocuts
