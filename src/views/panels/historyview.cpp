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

//! \param faint for what was undone or cannot be undone any more
QIcon dot(QColor color, bool faint)
{
    constexpr int size = 12, density = 4; // four times as fine as shown: sharp on every screen
    QPixmap pixmap(size * density, size * density);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    color.setAlphaF(faint ? 0.4f : 1);
    painter.setBrush(color);
    painter.drawEllipse(QRectF(pixmap.rect()).adjusted(density, density, -density, -density));
    return QIcon(pixmap);
}

//! Puts the sign of its kind before each entry, and "saved" behind the saved one.
class HistoryDelegate final : public QStyledItemDelegate
{
public:
    explicit HistoryDelegate(QObject *parent) : QStyledItemDelegate(parent) {}

    void setStack(UndoStack *stack) { mStack = stack; }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        // Row 0 is the state as it was opened: not saved by anybody.
        if (!mStack || index.row() == 0 || index.row() != mStack->cleanIndex())
            return;
        const bool selected = option.state & QStyle::State_Selected;
        painter->setPen(
            option.palette.color(selected ? QPalette::HighlightedText : QPalette::PlaceholderText));
        painter->drawText(option.rect.adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter,
                          HistoryView::tr("saved"));
    }

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        return QStyledItemDelegate::sizeHint(option, index).grownBy({0, 3, 0, 3});
    }

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::HasDecoration;
        option->decorationSize = QSize(12, 12);
        option->icon = QIcon();
        if (!mStack)
            return;
        const int row = index.row();
        const bool released = row < mStack->releasedCount();
        const bool undone = row > mStack->index();
        if (row > 0 && row <= mStack->count())
            option->icon = dot(colorOf(mStack->command(row - 1)->id()), released || undone);
        if (released) {
            option->state &= ~QStyle::State_Enabled;
            option->palette.setCurrentColorGroup(QPalette::Disabled);
        } else if (undone) {
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
    setCleanIcon(QIcon());
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
