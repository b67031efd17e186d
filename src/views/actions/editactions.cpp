#include "views/actions/editactions.h"

#include "views/actions/actionregistry.h"
#include "views/actions/preferencesdialog.h"
#include "views/canvas/toolmanager.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/ui/questions.h"

namespace autocuts {

EditActions::EditActions(const StudioContext &context, Questions &questions, ToolManager &tools,
                         QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions), mTools(tools)
{
    ActionRegistry &actions = context.actions;
    connect(actions.action("edit.undo"), &QAction::triggered, this, &EditActions::undo);
    connect(actions.action("edit.redo"), &QAction::triggered, this, &EditActions::redo);
    connect(actions.action("edit.shortcuts"), &QAction::triggered, this, [this] { showPreferences(true); });
    connect(actions.action("edit.preferences"), &QAction::triggered, this,
            [this] { showPreferences(false); });
    connect(&context.workspace, &Workspace::historyChanged, this, &EditActions::showTexts);
}

//! Takes back the gesture that is under way. A running solve becomes an entry first, which is then undone.
void EditActions::undo()
{
    if (AbstractTool *tool = mTools.tool(); tool && tool->isBusy())
        return tool->cancel();
    mContext.solver.whenPaused([this] {
        Document *document = mContext.workspace.document();
        if (document && document->undoStack().canUndoFurther())
            document->undoStack().undo();
    });
}

void EditActions::redo()
{
    mContext.solver.whenPaused([this] {
        if (Document *document = mContext.workspace.document())
            document->undoStack().redo();
    });
}

void EditActions::showTexts()
{
    const Document *document = mContext.workspace.document();
    const QString undone = document ? document->undoStack().undoText() : QString();
    const QString redone = document ? document->undoStack().redoText() : QString();
    mContext.actions.action("edit.undo")
        ->setText(undone.isEmpty() ? tr("&Undo") : tr("&Undo %1").arg(undone));
    mContext.actions.action("edit.redo")
        ->setText(redone.isEmpty() ? tr("&Redo") : tr("&Redo %1").arg(redone));
}

void EditActions::showPreferences(bool shortcuts)
{
    PreferencesDialog dialog(mContext.preferences, mContext.actions, mQuestions.window());
    dialog.showPage(shortcuts ? PreferencesDialog::Page::Shortcuts : PreferencesDialog::Page::General);
    mQuestions.run(dialog);
}

} // namespace autocuts
