#include "views/actions/actiontree.h"

#include "views/actions/actionregistry.h"
#include "views/actions/menubuilder.h"

#include <QStyledItemDelegate>
#include <QTreeWidget>

#include <map>

namespace autocuts {

namespace {

constexpr int ActionRole = Qt::UserRole;

QString plainMenuTitle(const QString &path)
{
    return menuTitle(path).remove(QLatin1Char('&'));
}

//! Actions in submenus are preceded by the name of the submenu.
QString rowText(const ActionInfo &info)
{
    const QString path = QLatin1String(info.menu);
    return path.contains(QLatin1Char('/'))
               ? QStringLiteral("%1: %2").arg(plainMenuTitle(path), actionTitle(info))
               : actionTitle(info);
}

bool matches(const QTreeWidgetItem &item, int columns, const QString &text)
{
    for (int column = 0; column < columns; ++column) {
        if (item.text(column).contains(text, Qt::CaseInsensitive))
            return true;
    }
    return false;
}

//! Rows with some space between their texts.
class RoomyRows final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        return QStyledItemDelegate::sizeHint(option, index) + QSize(12, 6);
    }
};

} // namespace

void fillActionTree(QTreeWidget &tree, const ActionRegistry &actions,
                    const std::function<bool(const QAction &)> &accept)
{
    tree.clear();
    std::map<QString, QTreeWidgetItem *> branches;
    // An empty icon keeps texts aligned when an action has no icon.
    QPixmap empty(16, 16);
    empty.fill(Qt::transparent);
    const QIcon emptyIcon(empty);
    tree.setItemDelegate(new RoomyRows(&tree));
    for (QAction *action : actions.actions()) {
        if (accept && !accept(*action))
            continue;
        const ActionInfo &info = actions.info(action);
        const QString menu = QString(QLatin1String(info.menu)).section(QLatin1Char('/'), 0, 0);
        QTreeWidgetItem *&branch = branches[menu];
        if (!branch) {
            branch = new QTreeWidgetItem(&tree, {plainMenuTitle(menu)});
            QFont bold = tree.font();
            bold.setBold(true);
            branch->setFont(0, bold);
            branch->setFlags(Qt::ItemIsEnabled);
        }
        auto *item = new QTreeWidgetItem(branch, {rowText(info), keyText(*action)});
        item->setIcon(0, action->icon().isNull() ? emptyIcon : action->icon());
        item->setData(0, ActionRole, QVariant::fromValue(action));
    }
    tree.expandAll();
}

QAction *actionOfItem(const QTreeWidgetItem &item)
{
    return item.data(0, ActionRole).value<QAction *>();
}

void filterActionTree(QTreeWidget &tree, const QString &text)
{
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
        QTreeWidgetItem *const branch = tree.topLevelItem(i);
        bool any = false;
        for (int k = 0; k < branch->childCount(); ++k) {
            QTreeWidgetItem *const item = branch->child(k);
            const bool shown = text.isEmpty() || matches(*item, tree.columnCount(), text.trimmed());
            item->setHidden(!shown);
            any = any || shown;
        }
        branch->setHidden(!any);
    }
}

QString keyText(const QAction &action)
{
    QStringList texts;
    for (const QKeySequence &keys : action.shortcuts())
        texts << keys.toString(QKeySequence::NativeText);
    return texts.join(QStringLiteral(", "));
}

} // namespace autocuts
