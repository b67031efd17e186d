#include "views/actions/shortcutlistdialog.h"

#include "views/actions/actionregistry.h"
#include "views/actions/actiontree.h"
#include "views/ui/dialogsize.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace autocuts {

ShortcutListDialog::ShortcutListDialog(const ActionRegistry &actions, QWidget *parent)
    : QDialog(parent), mList(new QTreeWidget)
{
    setWindowTitle(tr("Keyboard shortcuts"));
    auto *search = new QLineEdit;
    search->setPlaceholderText(tr("Search actions and keys"));
    search->setClearButtonEnabled(true);
    mList->setHeaderLabels({tr("Action"), tr("Keys"), tr("What it does")});
    mList->setSelectionMode(QAbstractItemView::NoSelection);
    mList->setFocusPolicy(Qt::NoFocus);
    mList->setAlternatingRowColors(true);
    fill(actions);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &ShortcutListDialog::reject);
    connect(search, &QLineEdit::textChanged, this,
            [this](const QString &text) { filterActionTree(*mList, text); });
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(search);
    layout->addWidget(mList, 1);
    layout->addWidget(buttons);
    resizeOnScreen(*this, {960, 640});
}

void ShortcutListDialog::fill(const ActionRegistry &actions)
{
    fillActionTree(*mList, actions, [](const QAction &action) { return !action.shortcuts().isEmpty(); });
    for (QTreeWidgetItemIterator it(mList); *it; ++it) {
        if (const QAction *action = actionOfItem(**it))
            (*it)->setText(2, QCoreApplication::translate("Actions", actions.info(action).tip));
    }
    mList->resizeColumnToContents(0);
    mList->resizeColumnToContents(1);
}

} // namespace autocuts
