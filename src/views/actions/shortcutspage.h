// The shortcut editor.
#pragma once

#include <QKeySequence>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace autocuts {

class ActionRegistry;
class KeyField;
class Preferences;

//! Shows the shortcuts of all actions and records new ones. Changes are written to the preferences at once. A
//! shortcut of another action is reassigned only after the user was shown which action that is.
class ShortcutsPage final : public QWidget
{
    Q_OBJECT

public:
    ShortcutsPage(Preferences &preferences, ActionRegistry &actions, QWidget *parent = nullptr);

    //! Assigns a shortcut to the current action, or shows the conflict.
    void assign(const QKeySequence &keys);
    //! Removes the shown conflicting shortcut from the other actions and assigns it.
    void takeOver();
    void resetCurrent();
    void resetAll();
    void setCurrent(const QAction *action);
    //! Text of the shown conflict; empty when there is none.
    QString conflictText() const;

private:
    void build();
    void connectAll();
    void showCurrent();
    QAction *current() const;
    void store(const QAction *action, const QList<QKeySequence> &keys);

    Preferences &mPreferences;
    ActionRegistry &mActions;
    QLineEdit *mSearch;
    QTreeWidget *mTree;
    QLabel *mName, *mConflict;
    KeyField *mKey;
    QPushButton *mClear, *mReset, *mResetAll, *mTakeOver;
    QKeySequence mPending; //!< shortcut of the shown conflict
};

} // namespace autocuts
