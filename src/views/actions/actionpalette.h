// Searches the actions of the program and runs one.
#pragma once

#include <QDialog>
#include <QIcon>

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;

namespace autocuts {

class ActionRegistry;

//! A field for words of an action's name or menu, and the actions that have all of them, best first. Enter
//! accepts the chosen one; the arrow keys choose while the field keeps the focus.
class ActionPalette final : public QDialog
{
    Q_OBJECT

public:
    explicit ActionPalette(const ActionRegistry &actions, QWidget *parent = nullptr);

    //! The action to run after the dialog was accepted; null when none is found, or when it is disabled.
    QAction *chosen() const;

    bool eventFilter(QObject *watched, QEvent *event) override;
    //! Stays open when nothing can be run, and says why.
    void accept() override;

private:
    QAction *current() const;
    void search(const QString &text);
    void showWhatRuns();
    void showRemark();

    const ActionRegistry &mActions;
    QLineEdit *mSearch;
    QListWidget *mFound;
    QLabel *mRemark; //!< why nothing can be run
    QIcon mNoIcon;   //!< of actions without one, so that all names begin in one column
};

} // namespace autocuts
