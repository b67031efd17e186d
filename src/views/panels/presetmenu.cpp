#include "views/panels/presetmenu.h"

#include "commands/changesettings.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/presetdialog.h"
#include "views/ui/questions.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

PresetMenu::PresetMenu(const StudioContext &context, Questions &questions, QWidget *parent)
    : QMenu(parent), mContext(context), mQuestions(questions)
{
    fill({});
    connect(this, &QMenu::aboutToShow, this, &PresetMenu::list);
    list();
}

void PresetMenu::list()
{
    if (!mChanging.isRunning()) // that lists, too
        afterwardsList(mListing, [] { return Done{}; });
}

void PresetMenu::change(const std::function<Result<Done>()> &work)
{
    mListing.drop();
    afterwardsList(mChanging, work);
}

void PresetMenu::afterwardsList(Task &task, const std::function<Result<Done>()> &work)
{
    task.start(
        [work](const std::atomic<bool> &) {
            const Result<Done> done = work();
            return std::pair(done, Names{presetNames(), ownPresetNames()});
        },
        [this](const std::pair<Result<Done>, Names> &made) {
            if (!made.first)
                mQuestions.showError(made.first.error());
            if (made.second != mNames)
                fill(made.second);
            Q_EMIT listed();
        },
        [this](const QString &message) { showProblem(message); });
}

void PresetMenu::showProblem(const QString &message)
{
    mQuestions.showError({message, {}, 0, {}});
}

void PresetMenu::fill(const Names &names)
{
    mNames = names;
    clear();
    delete mRemove; // clear() leaves menus
    const auto shown = [](QString name) { return name.replace('&'_L1, "&&"_L1); };
    for (const QString &name : names.all)
        connect(addAction(shown(name)), &QAction::triggered, this, [this, name] { choose(name); });
    addSeparator();
    QAction *save = addAction(tr("&Save settings as preset..."));
    save->setObjectName("save"_L1);
    connect(save, &QAction::triggered, this, &PresetMenu::askAndSave);
    mRemove = addMenu(tr("&Delete preset"));
    mRemove->setObjectName("remove"_L1);
    mRemove->setEnabled(!names.own.isEmpty());
    for (const QString &name : names.own)
        connect(mRemove->addAction(shown(name)), &QAction::triggered, this,
                [this, name] { askAndRemove(name); });
}

void PresetMenu::choose(const QString &name)
{
    mReading.start([name](const std::atomic<bool> &) { return readPreset(name); },
                   [this, name](const Result<Preset> &preset) { apply(name, preset); },
                   [this](const QString &message) { showProblem(message); });
}

jobs::MapSettings PresetMenu::settings() const
{
    const Document *document = mContext.workspace.document();
    if (!document)
        return {};
    return {document->solveSettings(), document->packingSettings(), mContext.map.quality()};
}

void PresetMenu::apply(const QString &name, const Result<Preset> &preset)
{
    Document *document = mContext.workspace.document();
    if (!preset)
        return mQuestions.showError(preset.error());
    if (!document)
        return;
    const Result<jobs::PresetSettings> made = jobs::settingsOf(preset.value(), settings());
    if (!made)
        return mQuestions.showError(made.error());
    pushCommand(std::make_unique<ChangeSettings>(*document, made->settings.solve, made->settings.packing));
    mContext.map.setQuality(made->settings.quality);
    Q_EMIT applied(made->others.isEmpty() ? tr("Settings of the preset %1").arg(name)
                                          : tr("Settings of the preset %1. For the command line only: %2")
                                                .arg(name, made->others.join(u", "_s)));
}

void PresetMenu::askAndSave()
{
    PresetDialog dialog(mNames.own, mQuestions.window());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    const QString name = dialog.name();
    if (mNames.own.contains(name) &&
        !mQuestions.confirm(tr("Replace the preset %1?").arg(name), {}, tr("Replace")))
        return;
    change([name, text = jobs::presetText(settings())] { return savePreset(name, text); });
}

void PresetMenu::askAndRemove(const QString &name)
{
    if (mQuestions.confirm(tr("Delete the preset %1?").arg(name), tr("Its file is removed."), tr("Delete")))
        change([name] { return removePreset(name); });
}

} // namespace autocuts
