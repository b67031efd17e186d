// All actions of the program by id: one QAction each, for menus, tool bars, shortcuts and tests.
#pragma once

#include "views/actions/actiontable.h"

#include <QAction>
#include <QObject>
#include <QPointer>

#include <map>

namespace autocuts {

class Preferences;

//! The translated name without mnemonic and ellipsis, for tooltips and lists.
QString actionTitle(const ActionInfo &info);
//! The shortcuts in the table.
QList<QKeySequence> defaultShortcuts(const ActionInfo &info);

//! Creates the actions of actionTable(), with the shortcuts from the preferences.
class ActionRegistry final : public QObject
{
    Q_OBJECT

public:
    explicit ActionRegistry(Preferences &preferences, QObject *parent = nullptr);

    //! \pre the id is in actionTable()
    QAction *action(const char *id) const;
    const std::vector<QAction *> &actions() const { return mActions; }
    //! The name with its shortcut, if there is one: "Unwrap (U)". \pre the id is in actionTable()
    QString nameWithKeys(const char *id) const;
    //! \pre the action is in actionTable()
    const ActionInfo &info(const QAction *action) const;

    //! An action outside of the table that is found by its name, too, such as that of a panel.
    struct Other
    {
        QPointer<QAction> action; //!< null when its owner is gone
        QString menu;             //!< path, such as "View/Panels"
    };
    void addOther(QAction *action, const QString &menu) { mOthers.push_back({action, menu}); }
    const std::vector<Other> &others() const { return mOthers; }

    //! Other actions with the same shortcut, for the shortcut editor.
    QList<QAction *> conflicts(const QAction *action, const QKeySequence &keys) const;

    //! Enables the actions whose conditions are all met; the tooltips of the others say what is missing.
    //! \param met mask of ActionNeed
    void setMet(int met);
    //! Why an action is disabled, one translated sentence; empty for enabled ones and those outside of the
    //! table.
    QString whyDisabled(const QAction *action) const;
    //! The disabled action that keys would trigger; null when there is none or an enabled one has them.
    QAction *disabledActionOf(const QKeySequence &keys) const;

private:
    void applyShortcuts();
    void showToolTip(std::size_t i);
    void applyIcons();

    Preferences &mPreferences;
    std::vector<QAction *> mActions; //!< in the order of the table
    std::vector<int> mUnmet;         //!< masks of ActionNeed, in the same order
    std::map<QString, QAction *> mById;
    std::vector<Other> mOthers;
};

} // namespace autocuts
