// A list of all shortcuts.
#pragma once

#include <QDialog>

class QTreeWidget;

namespace autocuts {

class ActionRegistry;

//! Shows the actions that have a shortcut, by menu, with what they do.
class ShortcutListDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit ShortcutListDialog(const ActionRegistry &actions, QWidget *parent = nullptr);

private:
    void fill(const ActionRegistry &actions);

    QTreeWidget *mList;
};

} // namespace autocuts
