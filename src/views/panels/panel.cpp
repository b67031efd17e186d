#include "views/panels/panel.h"

#include "commands/changesettings.h"
#include "views/actions/actionregistry.h"
#include "views/control/session/workspace.h"
#include "views/ui/inputguard.h"
#include "views/ui/scrublabel.h"

#include <QAbstractButton>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The tip with the keys of the actions, and with the reason when one of them is disabled.
QString fullTip(const QString &tip, const std::vector<QAction *> &actions, const ActionRegistry &registry)
{
    QStringList keys;
    QString why;
    for (const QAction *action : actions) {
        if (!action->shortcut().isEmpty())
            keys << action->shortcut().toString(QKeySequence::NativeText);
        if (why.isEmpty())
            why = registry.whyDisabled(action);
    }
    const QString text = keys.isEmpty() ? tip : u"%1 (%2)"_s.arg(tip, keys.join(", "_L1));
    return why.isEmpty() ? text : text + u'\n' + why;
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
    // The views keep the focus when a button is clicked.
    mScrollArea->setFocusPolicy(Qt::NoFocus);
    mScrollArea->setWidgetResizable(true);
    mScrollArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    mScrollArea->setWidget(mContent);
    mContent->installEventFilter(this);
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

Panel::~Panel()
{
    // A field with the focus emits its value when it is destroyed; the panel must not receive that.
    for (QObject *child : findChildren<QObject *>())
        child->disconnect(this);
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

void Panel::explain(QWidget *widget, const QString &tip, std::initializer_list<const char *> actionIds)
{
    std::vector<QAction *> actions;
    for (const char *id : actionIds)
        actions.push_back(mContext.actions.action(id));
    const auto show = [widget, tip, actions, &registry = mContext.actions] {
        widget->setToolTip(fullTip(tip, actions, registry));
    };
    for (const QAction *action : actions)
        connect(action, &QAction::changed, widget, show);
    show();
    auto *button = qobject_cast<QAbstractButton *>(widget);
    if (!button)
        return;
    button->setIcon(actions.front()->icon());
    // makeButton() leaves room for the text alone.
    if (!button->icon().isNull() && button->minimumWidth() > 0)
        button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) +
                                button->iconSize().width() + 14);
}

void Panel::showEvent(QShowEvent *event)
{
    if (mStale)
        refreshNow();
    // Only now are the rows measured with the right font.
    mScrollArea->setMinimumWidth(neededWidth());
    QWidget::showEvent(event);
}

bool Panel::eventFilter(QObject *watched, QEvent *event)
{
    // Longer numbers, in rows inside rows, ask for more width only later.
    if (watched == mContent && event->type() == QEvent::LayoutRequest && isVisible())
        mScrollArea->setMinimumWidth(std::max(mScrollArea->minimumWidth(), neededWidth()));
    return QWidget::eventFilter(watched, event);
}

//! The scroll bar must not cover the ends of the rows.
int Panel::neededWidth() const
{
    return mContent->minimumSizeHint().width() + mScrollArea->verticalScrollBar()->sizeHint().width();
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
    // One undo entry for all steps of dragging a number.
    if (ScrubLabel::gesture() != 0 && gesture == 0)
        gesture = gestureFor(std::exchange(mScrub, ScrubLabel::gesture()) != ScrubLabel::gesture());
    auto command = std::make_unique<ChangeSettings>(*document(), solve, packing);
    command->setGesture(gesture);
    pushCommand(std::move(command));
    // A value that was rejected must not stay in the widget.
    refreshSoon();
}

} // namespace autocuts
