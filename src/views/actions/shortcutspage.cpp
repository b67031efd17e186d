#include "views/actions/shortcutspage.h"

#include "views/actions/actionregistry.h"
#include "views/actions/actiontree.h"
#include "views/actions/keyfield.h"
#include "views/ui/preferences.h"
#include "views/ui/reasons.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace autocuts {

ShortcutsPage::ShortcutsPage(Preferences &preferences, ActionRegistry &actions, QWidget *parent)
    : QWidget(parent), mPreferences(preferences), mActions(actions), mSearch(new QLineEdit),
      mTree(new QTreeWidget), mName(new QLabel), mConflict(new QLabel), mKey(new KeyField),
      mClear(new QPushButton(tr("&Clear"))), mReset(new QPushButton(tr("&Reset"))),
      mResetAll(new QPushButton(tr("Reset &all"))), mTakeOver(new QPushButton(tr("&Take over")))
{
    build();
    connectAll();
    fillActionTree(*mTree, mActions);
    setCurrent(mActions.actions().front());
}

void ShortcutsPage::build()
{
    mSearch->setPlaceholderText(tr("Search actions and keys"));
    mSearch->setClearButtonEnabled(true);
    mTree->setHeaderLabels({tr("Action"), tr("Keys")});
    mTree->setAlternatingRowColors(true);
    mTree->setUniformRowHeights(true);
    mTree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    mTree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    mTree->header()->setStretchLastSection(false);
    mName->setMinimumWidth(200);
    mKey->setMinimumWidth(180);
    mConflict->setWordWrap(true);
    mClear->setToolTip(tr("No key for this action"));
    mReset->setToolTip(tr("The key that the action had at first"));
    mResetAll->setToolTip(tr("The keys that all actions had at first"));
    for (QPushButton *button : {mClear, mReset, mResetAll, mTakeOver})
        button->setAutoDefault(false);
    auto *edit = new QGridLayout;
    edit->addWidget(mName, 0, 0);
    edit->addWidget(mKey, 0, 1);
    edit->addWidget(mClear, 0, 2);
    edit->addWidget(mReset, 0, 3);
    edit->addWidget(mConflict, 1, 0, 1, 3);
    edit->addWidget(mTakeOver, 1, 3);
    edit->setColumnStretch(0, 1);
    // The row of the conflict always takes its space, so that the layout does not jump.
    edit->setRowMinimumHeight(1, mTakeOver->sizeHint().height());
    auto *top = new QHBoxLayout;
    top->addWidget(mSearch, 1);
    top->addWidget(mResetAll);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(mTree, 1);
    layout->addLayout(edit);
}

void ShortcutsPage::connectAll()
{
    connect(mSearch, &QLineEdit::textChanged, this,
            [this](const QString &text) { filterActionTree(*mTree, text); });
    connect(mTree, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::showCurrent);
    const auto record = [this] { mKey->startRecording(); };
    connect(mTree, &QTreeWidget::itemActivated, this, record);
    connect(mTree, &QTreeWidget::itemClicked, this, [record](const QTreeWidgetItem *item, int column) {
        if (column == 1 && actionOfItem(*item))
            record();
    });
    connect(mKey, &KeyField::recorded, this, &ShortcutsPage::assign);
    connect(mClear, &QPushButton::clicked, this, [this] { assign({}); });
    connect(mReset, &QPushButton::clicked, this, &ShortcutsPage::resetCurrent);
    connect(mResetAll, &QPushButton::clicked, this, &ShortcutsPage::resetAll);
    connect(mTakeOver, &QPushButton::clicked, this, &ShortcutsPage::takeOver);
    connect(&mPreferences, &Preferences::shortcutsChanged, this, &ShortcutsPage::showCurrent);
}

//! Updates the shortcuts of all rows and the field of the current action.
void ShortcutsPage::showCurrent()
{
    const QMap<QString, QKeySequence> changed = mPreferences.shortcuts();
    for (QTreeWidgetItemIterator it(mTree); *it; ++it) {
        const QAction *const action = actionOfItem(**it);
        if (!action)
            continue;
        QFont font = mTree->font();
        font.setBold(changed.contains(action->objectName()));
        (*it)->setText(1, keyText(*action));
        (*it)->setFont(1, font);
    }
    const QAction *const action = current();
    mKey->setEnabled(action);
    mName->setText(action ? actionTitle(mActions.info(action)) : QString());
    mKey->setKeys(action ? keyText(*action) : QString());
    const QString choose = tr("Choose an action first");
    enableOrSay(mClear, action && !action->shortcuts().isEmpty(), action ? tr("It has no shortcut") : choose);
    enableOrSay(mReset, action && changed.contains(action->objectName()),
                action ? tr("It has the shortcut that it came with") : choose);
    enableOrSay(mResetAll, !changed.isEmpty(), tr("No shortcut was changed"));
    mPending = {};
    mConflict->clear();
    mTakeOver->setVisible(false);
}

QAction *ShortcutsPage::current() const
{
    const QTreeWidgetItem *const item = mTree->currentItem();
    return item ? actionOfItem(*item) : nullptr;
}

void ShortcutsPage::setCurrent(const QAction *action)
{
    for (QTreeWidgetItemIterator it(mTree); *it; ++it) {
        if (actionOfItem(**it) == action)
            mTree->setCurrentItem(*it);
    }
}

QString ShortcutsPage::conflictText() const
{
    return mConflict->text();
}

void ShortcutsPage::assign(const QKeySequence &keys)
{
    const QAction *const action = current();
    if (!action)
        return;
    const QList<QAction *> others = mActions.conflicts(action, keys);
    if (others.isEmpty()) {
        store(action, {keys});
        return;
    }
    QStringList names;
    for (const QAction *other : others)
        names << actionTitle(mActions.info(other));
    mPending = keys;
    mConflict->setText(tr("%1 is the key of: %2")
                           .arg(keys.toString(QKeySequence::NativeText), names.join(QStringLiteral(", "))));
    mTakeOver->setVisible(true);
}

void ShortcutsPage::takeOver()
{
    const QAction *const action = current();
    if (!action || mPending.isEmpty())
        return;
    const QKeySequence keys = mPending;
    for (const QAction *other : mActions.conflicts(action, keys)) {
        QList<QKeySequence> rest = other->shortcuts();
        rest.removeAll(keys);
        store(other, rest);
    }
    store(action, {keys});
}

//! Only the first of several shortcuts is stored.
void ShortcutsPage::store(const QAction *action, const QList<QKeySequence> &keys)
{
    QMap<QString, QKeySequence> shortcuts = mPreferences.shortcuts();
    const QKeySequence first = keys.value(0);
    const QList<QKeySequence> defaults = defaultShortcuts(mActions.info(action));
    if (defaults == QList<QKeySequence>{first} || (defaults.isEmpty() && first.isEmpty()))
        shortcuts.remove(action->objectName());
    else
        shortcuts.insert(action->objectName(), first);
    mPreferences.setShortcuts(shortcuts);
}

void ShortcutsPage::resetCurrent()
{
    const QAction *const action = current();
    if (!action)
        return;
    // The default may belong to another action now.
    const QList<QKeySequence> defaults = defaultShortcuts(mActions.info(action));
    for (const QKeySequence &keys : defaults) {
        if (!mActions.conflicts(action, keys).isEmpty()) {
            assign(keys);
            return;
        }
    }
    QMap<QString, QKeySequence> shortcuts = mPreferences.shortcuts();
    shortcuts.remove(action->objectName());
    mPreferences.setShortcuts(shortcuts);
}

void ShortcutsPage::resetAll()
{
    mPreferences.setShortcuts({});
}

} // namespace autocuts
