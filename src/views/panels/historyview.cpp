#include "views/panels/historyview.h"

#include "commands/documentcommand.h"
#include "views/ui/icons.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

QString iconName(int commandId)
{
    switch (CommandId(commandId)) {
    case CommandId::SetSeamState:
        return u"cut"_s;
    case CommandId::KeepStraight:
        return u"keep-straight"_s;
    case CommandId::EditMapSeams:
        return u"rip"_s;
    case CommandId::SetSeamWeights:
        return u"tool-paint"_s;
    case CommandId::SetTexelWeights:
        return u"brush-density"_s;
    case CommandId::EditRectangles:
        return u"tool-rectangle"_s;
    case CommandId::EditPins:
        return u"pin"_s;
    case CommandId::SetUvs:
        return u"view-uv"_s;
    case CommandId::ChooseUvSet:
    case CommandId::AddUvSet:
    case CommandId::RenameUvSet:
    case CommandId::DeleteUvSet:
        return u"texture"_s;
    case CommandId::SetIslandFlags:
    case CommandId::SetIslandTag:
    case CommandId::StackIslands:
    case CommandId::MakeUnique:
        return u"island"_s;
    case CommandId::ChangeSettings:
        return u"preferences"_s;
    case CommandId::HideFaces:
        return u"hide"_s;
    case CommandId::EditTextures:
        return u"texture"_s;
    case CommandId::ReplaceModel:
        return u"relink"_s;
    case CommandId::Reset:
    case CommandId::End:
        break;
    }
    return u"clear"_s;
}

//! Draws an icon for its kind before each entry, and "saved" after the saved one.
class HistoryDelegate final : public QStyledItemDelegate
{
public:
    explicit HistoryDelegate(QObject *parent) : QStyledItemDelegate(parent) {}

    void setStack(UndoStack *stack) { mStack = stack; }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        // Row 0 is the state after opening, which was not saved in this session.
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
        option->decorationSize = QSize(16, 16);
        option->icon = QIcon();
        if (!mStack)
            return;
        const int row = index.row();
        const bool released = row < mStack->releasedCount();
        const bool undone = row > mStack->index();
        if (row > 0 && row <= mStack->count())
            option->icon = icon(iconName(mStack->command(row - 1)->id()));
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
