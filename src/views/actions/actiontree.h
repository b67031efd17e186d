// A tree of actions by menu, for the shortcut editor and the list of shortcuts.
#pragma once

#include <QString>

#include <functional>

class QAction;
class QTreeWidget;
class QTreeWidgetItem;

namespace autocuts {

class ActionRegistry;

//! Fills a tree with one branch per menu; each action has its name in column 0 and its shortcuts in column 1.
//! \param accept true for the actions to show; all when empty
void fillActionTree(QTreeWidget &tree, const ActionRegistry &actions,
                    const std::function<bool(const QAction &)> &accept = {});
//! The action of an item; null for branches.
QAction *actionOfItem(const QTreeWidgetItem &item);
//! Hides the rows in which no column contains the text.
void filterActionTree(QTreeWidget &tree, const QString &text);
//! The shortcuts of an action as shown to the user.
QString keyText(const QAction &action);

} // namespace autocuts
