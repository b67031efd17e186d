#include "views/panels/historypanel.h"

#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/panels/historyview.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

HistoryPanel::HistoryPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model: every edit will be listed here."), parent), mView(new HistoryView),
      mMemory(makeRemark())
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing);
    mView->setObjectName("history"_L1);
    mView->setEmptyLabel(tr("As opened"));
    mView->setMinimumHeight(80);
    mView->setAccessibleName(tr("History"));
    mView->setToolTip(tr("Click an entry to go back to it, or forward. Undo: Ctrl+Z, redo: Ctrl+Shift+Z"));
    layout->addWidget(mView, 1);
    mMemory->setObjectName("memory"_L1);
    layout->addWidget(mMemory);
    connect(&context.workspace, &Workspace::documentReplaced, this, &HistoryPanel::replaceStack);
    connect(&context.workspace, &Workspace::historyChanged, this, [this] { refreshSoon(); });
    // Merged commands do not change the index, only the memory used.
    connect(&context.workspace, &Workspace::changed, this, [this] { refreshSoon(); });
    replaceStack();
}

void HistoryPanel::replaceStack()
{
    // Updated at once, because the stack of a closed document no longer exists.
    mView->setHistory(document() ? &document()->undoStack() : nullptr);
}

void HistoryPanel::refresh()
{
    if (!document()) {
        mMemory->clear();
        return;
    }
    const UndoStack &stack = document()->undoStack();
    const QLocale locale;
    QString text =
        tr("%1 of %2 used")
            .arg(locale.formattedDataSize(stack.memoryUsed()), locale.formattedDataSize(stack.memoryLimit()));
    if (const int released = stack.releasedCount(); released > 0)
        text += u'\n' + tr("Too old to go back to: %1").arg(released);
    mMemory->setText(text);
    mView->viewport()->update();
}

} // namespace autocuts
