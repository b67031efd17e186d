#include "views/panels/panel.h"

#include "commands/changesettings.h"
#include "views/actions/actionregistry.h"
#include "views/control/workspace.h"
#include "views/panels/inputguard.h"

#include <QAbstractButton>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Null when the table has no such action.
QAction *findAction(const ActionRegistry &registry, const char *id)
{
    for (QAction *action : registry.actions()) {
        if (QLatin1StringView(registry.info(action).id) == QLatin1StringView(id))
            return action;
    }
    return nullptr;
}

void showAction(QAbstractButton *button, const QString &tip, const QAction &action)
{
    button->setIcon(action.icon());
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    button->setToolTip(key.isEmpty() ? tip : u"%1 (%2)"_s.arg(tip, key));
}

} // namespace

Panel::Panel(const StudioContext &context, const QString &emptyText, QWidget *parent)
    : QWidget(parent), mContext(context), mEmptyNote(new QLabel(emptyText)), mScrollArea(new QScrollArea),
      mContent(new QWidget)
{
    mEmptyNote->setWordWrap(true);
    mEmptyNote->setMargin(8);
    mEmptyNote->setObjectName("emptyNote"_L1);
    mScrollArea->setFrameShape(QFrame::NoFrame);
    mScrollArea->setWidgetResizable(true);
    mScrollArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    mScrollArea->setWidget(mContent);
    new InputGuard(mContent);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(mEmptyNote);
    layout->addWidget(mScrollArea, 1);

    mRefreshTimer.setSingleShot(true);
    connect(&mRefreshTimer, &QTimer::timeout, this, &Panel::refreshNow);
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        showWhetherEmpty();
        refreshSoon();
    });
    showWhetherEmpty();
}

Document *Panel::document() const
{
    return mContext.workspace.document();
}

void Panel::refreshSoon(int delayMs)
{
    mStale = true;
    const bool comesSoon = mRefreshTimer.isActive() && mRefreshTimer.interval() == 0;
    if (isVisible() && !comesSoon)
        mRefreshTimer.start(delayMs);
}

quint64 Panel::gestureFor(bool first)
{
    if (first && document())
        mGesture = document()->undoStack().newGesture();
    return mGesture;
}

void Panel::explain(QAbstractButton *button, const QString &tip, const char *actionId)
{
    button->setToolTip(tip);
    if (const QAction *action = findAction(mContext.actions, actionId)) {
        const auto show = [button, tip, action] { showAction(button, tip, *action); };
        connect(action, &QAction::changed, button, show);
        show();
    }
}

void Panel::showEvent(QShowEvent *event)
{
    if (mStale)
        refreshNow();
    // Rows can only now be measured with the right font: a scroll bar must not hide their ends.
    mScrollArea->setMinimumWidth(mContent->minimumSizeHint().width() +
                                 mScrollArea->verticalScrollBar()->sizeHint().width());
    QWidget::showEvent(event);
}

void Panel::showWhetherEmpty()
{
    mEmptyNote->setVisible(!document());
    mContent->setEnabled(document() != nullptr);
}

void Panel::refreshNow()
{
    mStale = false;
    refresh();
}

void Panel::pushSettings(const SolveSettings &solve, const PackingSettings &packing, quint64 gesture)
{
    auto command = std::make_unique<ChangeSettings>(*document(), solve, packing);
    command->setGesture(gesture);
    pushCommand(std::move(command));
    // A value that was not taken must not stay in the widget.
    refreshSoon();
}

} // namespace autocuts
