// Actions in a tree by menu, as the shortcut editor and the list of keys show them.
#pragma once

#include <QString>

#include <functional>

class QAction;
class QTreeWidget;
class QTreeWidgetItem;

namespace autocuts {

class ActionRegistry;

//! Fills a tree: one branch per menu, and per action its name in column 0 and its keys in column 1.
//! \param accept actions to show; all when empty
void fillActionTree(QTreeWidget &tree, const ActionRegistry &actions,
                    const std::function<bool(const QAction &)> &accept = {});
//! Null for the branches.
QAction *actionOfItem(const QTreeWidgetItem &item);
//! Hides the rows that have the text in no column.
void filterActionTree(QTreeWidget &tree, const QString &text);
//! The keys of an action as the user sees them.
QString keyText(const QAction &action);

} // namespace autocuts
