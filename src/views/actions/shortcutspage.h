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

//! Shows the keys of all actions and records others. Changes are in the preferences at once. A key that
//! another action has is taken over only after the user saw whose it is.
class ShortcutsPage final : public QWidget
{
    Q_OBJECT

public:
    ShortcutsPage(Preferences &preferences, ActionRegistry &actions, QWidget *parent = nullptr);

    //! Gives the current action a key, or shows the conflict.
    void assign(const QKeySequence &keys);
    //! Takes the key of the conflict that is shown away from the others.
    void takeOver();
    void resetCurrent();
    void resetAll();
    void setCurrent(const QAction *action);
    //! Text of the conflict that is shown; empty when there is none.
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
    QKeySequence mPending; //!< key of the conflict that is shown
};

} // namespace autocuts
