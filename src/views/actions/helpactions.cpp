#include "views/actions/helpactions.h"

#include "views/actions/actionpalette.h"
#include "views/actions/actionregistry.h"
#include "views/actions/shortcutlistdialog.h"
#include "views/dialogs/aboutdialog.h"
#include "views/ui/questions.h"

#include <QDir>

namespace autocuts {

HelpActions::HelpActions(const StudioContext &context, Questions &questions, const QString &recoveryFolder,
                         QObject *parent)
    : QObject(parent)
{
    ActionRegistry &actions = context.actions;
    connect(actions.action("help.findAction"), &QAction::triggered, this, [&actions, &questions] {
        ActionPalette palette(actions, questions.window());
        if (questions.run(palette) == QDialog::Accepted && palette.chosen())
            palette.chosen()->trigger();
    });
    connect(actions.action("help.shortcuts"), &QAction::triggered, this, [&actions, &questions] {
        ShortcutListDialog dialog(actions, questions.window());
        questions.run(dialog);
    });
    connect(actions.action("help.about"), &QAction::triggered, this, [&questions] {
        AboutDialog dialog(questions.window());
        questions.run(dialog);
    });
    connect(actions.action("help.recovery"), &QAction::triggered, this, [&questions, recoveryFolder] {
        // The folder does not exist before the first session.
        QDir().mkpath(recoveryFolder);
        questions.showFolder(recoveryFolder);
    });
}

} // namespace autocuts
