// Builds the menus and the tool bar from the table of actions.
#pragma once

#include <QString>

#include <map>

class QMenu;
class QMenuBar;
class QToolBar;

namespace autocuts {

class ActionRegistry;

//! The translated title, with its mnemonic, of the menu at a path of the table; empty when it has none.
QString menuTitle(const QString &path);

//! The menus of the program, by their path in the table.
class MenuBuilder final
{
public:
    //! Fills the menu bar, which owns the menus.
    MenuBuilder(const ActionRegistry &actions, QMenuBar &bar);

    //! A menu to which actions outside of the table are added, such as "View/Panels". \pre the path is in the
    //! table
    QMenu *menu(const QString &path) const;
    const std::map<QString, QMenu *> &menus() const { return mMenus; }

private:
    QMenu *find(const QString &path, bool separatorBefore);

    QMenuBar &mBar;
    std::map<QString, QMenu *> mMenus;
};

//! Adds the most frequently used actions: files, history, solver, map, selection modes.
void fillToolBar(const ActionRegistry &actions, QToolBar &bar);

} // namespace autocuts
