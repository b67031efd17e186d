#include "views/actions/bakeactions.h"

#include "views/actions/actionregistry.h"
#include "views/actions/fileactions.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/session/proposedfolder.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/bakedialog.h"
#include "views/dialogs/carrydialog.h"
#include "views/dialogs/lightbakedialog.h"
#include "views/state/viewstate.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>

#include <utility>

namespace autocuts {

BakeActions::BakeActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions),
      mPictures(context.workspace, context.solver, context.map)
{
    connect(context.actions.action("uv.bake"), &QAction::triggered, this, [this] {
        if (const Document *document = mContext.workspace.document())
            ask(*document);
    });
    connect(context.actions.action("uv.carryTextures"), &QAction::triggered, this, [this] {
        if (const Document *document = mContext.workspace.document())
            askCarrying(*document);
    });
    connect(context.actions.action("uv.bakeLight"), &QAction::triggered, this, [this] {
        if (const Document *document = mContext.workspace.document())
            askLight(*document);
    });
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] { mHasLight = false; });
    connect(&context.map, &MapController::picturesBaked, this, [this] { show(Pattern::Physical); });
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] {
        if (!mContext.map.jobs().isBusy())
            noteBaked();
    });
    for (const auto signal : {&LiveBake::failed, &LiveBake::noticed})
        connect(&context.liveBake, signal, &context.map,
                [map = &context.map](const QString &message) { Q_EMIT map->failed(message); });
    connect(&context.view, &ViewState::optionsChanged, this, [this] {
        if (mContext.view.options().pattern != Pattern::Baked)
            mContext.liveBake.stop();
    });
}

//! Notes the files of the bake that has ended, as they are now.
void BakeActions::noteBaked()
{
    for (const QString &file : std::exchange(mBaking, {}))
        mBaked[file] = QFileInfo(file).lastModified();
}

void BakeActions::setLight(const jobs::LightChoice &light)
{
    mLight = light;
    mHasLight = true;
}

void BakeActions::ask(const Document &document)
{
    jobs::BakeChoice first = mChoice;
    // Sessions remember a folder, and may have been moved since.
    if (!isFolder(first.folder))
        first.folder = proposedFolder(mContext.workspace, mContext.preferences);
    BakeDialog dialog(document, first, openFilters(), mQuestions);
    QStringList replaceable;
    for (auto file = mBaked.cbegin(); file != mBaked.cend(); ++file) {
        if (QFileInfo(file.key()).lastModified() == file.value())
            replaceable << file.key();
    }
    dialog.setReplaceable(replaceable);
    const int answer = mQuestions.run(dialog);
    if (answer == QDialog::Rejected)
        return;
    mChoice = dialog.choice();
    if (answer == BakeDialog::Live) {
        showLive();
        return;
    }
    mBaking = dialog.files();
    mPictures.bake(mChoice);
}

void BakeActions::askCarrying(const Document &document)
{
    CarryDialog dialog(document, mCarryChoice, proposedFolder(mContext.workspace, mContext.preferences),
                       openFilters(), mQuestions);
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    const jobs::CarryChoice choice = dialog.choice();
    mCarryChoice = jobs::CarryChoice();
    mCarryChoice.format = choice.format;
    mCarryChoice.size = choice.size;
    mCarryChoice.margin = choice.margin;
    mPictures.carryTextures(choice);
}

void BakeActions::showLive()
{
    mContext.liveBake.start(mChoice, mChoice.maps.first());
    show(Pattern::Baked);
}

void BakeActions::show(Pattern pattern)
{
    ViewOptions options = mContext.view.options();
    options.pattern = pattern;
    mContext.view.setOptions(options);
}

void BakeActions::askLight(const Document &document)
{
    const QString folder = proposedFolder(mContext.workspace, mContext.preferences);
    const jobs::LightChoice first = LightBakeDialog::firstChoice(document, folder);
    if (!mHasLight)
        mLight = first;
    if (const QFileInfo file(mLight.path); !isFolder(file.path()))
        mLight.path = QDir(folder).filePath(file.fileName());
    // The set that was made last time, or one in place of a set that is gone.
    if (mLight.uvSet == jobs::LightChoice::newSet || mLight.uvSet >= std::ssize(document.uvSets()))
        mLight.uvSet = first.uvSet;
    LightBakeDialog dialog(document, mLight, mQuestions);
    if (mQuestions.run(dialog) == QDialog::Rejected)
        return;
    mLight = dialog.choice();
    mHasLight = true;
    LiveBake::Receiver shown = mContext.liveBake.receive();
    show(Pattern::Baked);
    mPictures.bakeLight(mLight, shown);
}

} // namespace autocuts
