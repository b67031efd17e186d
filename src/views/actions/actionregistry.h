// All actions of the program by id: one QAction each, for menus, tool bars, shortcuts and tests.
#pragma once

#include "views/actions/actiontable.h"

#include <QAction>
#include <QObject>

#include <map>

namespace autocuts {

class Preferences;

//! Translated name without mnemonic and dots, for tooltips and lists.
QString actionTitle(const ActionInfo &info);
//! The keys that the table gives.
QList<QKeySequence> defaultShortcuts(const ActionInfo &info);

//! Makes the actions of actionTable() and keeps their shortcuts as the preferences say.
class ActionRegistry final : public QObject
{
    Q_OBJECT

public:
    explicit ActionRegistry(Preferences &preferences, QObject *parent = nullptr);

    //! \pre the id is in actionTable()
    QAction *action(const char *id) const;
    const std::vector<QAction *> &actions() const { return mActions; }
    const ActionInfo &info(const QAction *action) const;

    //! Other actions of the same shortcut, for the shortcut editor.
    QList<QAction *> conflicts(const QAction *action, const QKeySequence &keys) const;

    //! Enables the actions whose needs are all met. \param met mask of ActionNeed
    void setMet(int met);

private:
    void applyShortcuts();
    void applyIcons();

    Preferences &mPreferences;
    std::vector<QAction *> mActions; //!< in the order of the table
    std::map<QString, QAction *> mById;
};

} // namespace autocuts
