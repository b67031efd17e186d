#include "views/panels/historyview.h"

#include "commands/documentcommand.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>

namespace autocuts {

namespace {

//! Kinds of edits by their hue, so that the eye finds "where I packed" in a long list.
QColor colorOf(int commandId)
{
    switch (CommandId(commandId)) {
    case CommandId::SetSeamState:
        return QColor(0xDB4A3A);
    case CommandId::SetSeamWeights:
        return QColor(0xB65FD0);
    case CommandId::EditRectangles:
        return QColor(0x4080FF);
    case CommandId::EditPins:
        return QColor(0x37B24D);
    case CommandId::SetUvs:
        return QColor(0xFF9A1F);
    case CommandId::ChooseUvSet:
    case CommandId::AddUvSet:
    case CommandId::RenameUvSet:
    case CommandId::DeleteUvSet:
        return QColor(0x1FA8B8);
    case CommandId::SetIslandFlags:
    case CommandId::SetIslandTag:
        return QColor(0xC9A400);
    case CommandId::ChangeSettings:
    case CommandId::Reset:
        break;
    }
    return QColor(0x8A8F98);
}

//! Puts the sign of its kind before each entry.
class HistoryDelegate final : public QStyledItemDelegate
{
public:
    explicit HistoryDelegate(QObject *parent) : QStyledItemDelegate(parent) {}

    void setStack(UndoStack *stack) { mStack = stack; }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        if (!mStack || index.row() == 0 || index.row() > mStack->count())
            return;
        QColor color = colorOf(mStack->command(index.row() - 1)->id());
        // What was undone, and what cannot be undone any more, stands back.
        if (index.row() > mStack->index() || index.row() <= mStack->releasedCount())
            color.setAlphaF(0.4f);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(color);
        const double radius = 4;
        painter->drawEllipse(QPointF(option.rect.left() + 10, option.rect.center().y() + 0.5), radius,
                             radius);
        painter->restore();
    }

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        // Room for the sign; the mark of the saved state moves behind the text.
        option->rect.setLeft(option->rect.left() + 16);
        option->decorationPosition = QStyleOptionViewItem::Right;
        if (!mStack)
            return;
        if (index.row() < mStack->releasedCount()) {
            option->state &= ~QStyle::State_Enabled;
            option->palette.setCurrentColorGroup(QPalette::Disabled);
        } else if (index.row() > mStack->index()) {
            option->font.setItalic(true);
            option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
        }
    }

private:
    QPointer<UndoStack> mStack;
};

} // namespace

HistoryView::HistoryView(QWidget *parent) : QUndoView(parent)
{
    setItemDelegate(new HistoryDelegate(this));
    setUniformItemSizes(true);
}

void HistoryView::setHistory(UndoStack *stack)
{
    mStack = stack;
    static_cast<HistoryDelegate *>(itemDelegate())->setStack(stack);
    setStack(stack);
}

bool HistoryView::isReachable(const QModelIndex &index) const
{
    return !index.isValid() || !mStack || index.row() >= mStack->releasedCount();
}

void HistoryView::mousePressEvent(QMouseEvent *event)
{
    if (isReachable(indexAt(event->pos())))
        QUndoView::mousePressEvent(event);
}

void HistoryView::mouseMoveEvent(QMouseEvent *event)
{
    if (isReachable(indexAt(event->pos())))
        QUndoView::mouseMoveEvent(event);
}

void HistoryView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (isReachable(indexAt(event->pos())))
        QUndoView::mouseDoubleClickEvent(event);
}

QModelIndex HistoryView::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers)
{
    const QModelIndex next = QUndoView::moveCursor(action, modifiers);
    return isReachable(next) ? next : model()->index(mStack->releasedCount(), 0);
}

} // namespace autocuts
