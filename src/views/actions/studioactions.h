// All menus and their actions, as the main window needs them.
#pragma once

#include "views/actions/actionstates.h"
#include "views/actions/bakeactions.h"
#include "views/actions/editactions.h"
#include "views/actions/fileactions.h"
#include "views/actions/helpactions.h"
#include "views/actions/hideactions.h"
#include "views/actions/islandactions.h"
#include "views/actions/selectactions.h"
#include "views/actions/texelweightactions.h"
#include "views/actions/transferactions.h"
#include "views/actions/uvactions.h"
#include "views/actions/uvsetactions.h"
#include "views/actions/viewactions.h"

namespace autocuts {

//! Connects every action of the table. One per window.
class StudioActions final
{
public:
    //! \param questions asks over the window; must outlive this object
    StudioActions(const StudioContext &context, Questions &questions, ToolManager &tools,
                  const QString &recoveryFolder)
        : mFile(context, questions), mEdit(context, questions, tools), mSelect(context, questions),
          mHide(context), mUv(context), mUvSets(context), mIslands(context, questions),
          mTexelWeights(context, questions), mTransfer(context, questions), mBake(context, questions),
          mView(context, questions), mHelp(context, questions, recoveryFolder), mStates(context)
    {}

    FileActions &file() { return mFile; }
    IslandActions &islands() { return mIslands; }
    ViewActions &view() { return mView; }
    BakeActions &bake() { return mBake; }

private:
    FileActions mFile;
    EditActions mEdit;
    SelectActions mSelect;
    HideActions mHide;
    UvActions mUv;
    UvSetActions mUvSets;
    IslandActions mIslands;
    TexelWeightActions mTexelWeights;
    TransferActions mTransfer;
    BakeActions mBake;
    ViewActions mView;
    HelpActions mHelp;
    ActionStates mStates;
};

} // namespace autocuts
