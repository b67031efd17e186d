// Menus and tool bar from the table of actions.
#pragma once

#include <QString>

#include <map>

class QMenu;
class QMenuBar;
class QToolBar;

namespace autocuts {

class ActionRegistry;

//! Translated title of the menu at a path of the table, with its mnemonic; empty when it has none.
QString menuTitle(const QString &path);

//! The menus of the program, by their path in the table.
class MenuBuilder final
{
public:
    //! Fills the menu bar, which owns the menus.
    MenuBuilder(const ActionRegistry &actions, QMenuBar &bar);

    //! To add what the table does not know: "View/Panels". \pre the path is in the table
    QMenu *menu(const QString &path) const;
    const std::map<QString, QMenu *> &menus() const { return mMenus; }

private:
    QMenu *find(const QString &path, bool separatorBefore);

    QMenuBar &mBar;
    std::map<QString, QMenu *> mMenus;
};

//! The actions that are used all the time: files, history, solver, map, modes.
void fillToolBar(const ActionRegistry &actions, QToolBar &bar);

} // namespace autocuts
