#include "views/actions/actionpalette.h"

#include "views/actions/actionregistry.h"
#include "views/actions/actiontree.h"
#include "views/actions/menubuilder.h"
#include "views/ui/dialogsize.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace autocuts {

namespace {

constexpr int actionRole = Qt::UserRole;

//! An action with the texts by which it is found.
struct Entry
{
    QAction *action;
    QString title;
    QString menu;
};

//! The menus that lead to an action, such as "UV > Layout > Align". \param menu path in the table
QString menuText(const QString &menu)
{
    QStringList titles;
    QString path;
    for (const QString &part : menu.split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        path += path.isEmpty() ? part : QLatin1Char('/') + part;
        titles << menuTitle(path).remove(QLatin1Char('&'));
    }
    return titles.join(QStringLiteral(" > "));
}

std::vector<Entry> entriesOf(const ActionRegistry &actions)
{
    std::vector<Entry> entries;
    for (QAction *action : actions.actions()) {
        const ActionInfo &info = actions.info(action);
        entries.push_back({action, actionTitle(info), menuText(QString::fromLatin1(info.menu))});
    }
    for (const ActionRegistry::Other &other : actions.others()) {
        if (other.action)
            entries.push_back(
                {other.action, other.action->text().remove(QLatin1Char('&')), menuText(other.menu)});
    }
    return entries;
}

//! In lower case, without what menus have beside words: the dots behind a name, the arrows of a path.
QStringList wordsOf(const QString &text)
{
    QStringList words;
    for (QString word : text.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        while (word.endsWith(QLatin1Char('.')) || word.endsWith(QChar(0x2026))) // one sign of three dots
            word.chop(1);
        if (!word.isEmpty() && word != QLatin1String(">"))
            words << word;
    }
    return words;
}

//! How well an action fits: 0 best, -1 not at all. \param words in lower case
int rankOf(const QString &title, const QString &menu, const QStringList &words)
{
    const QString name = title.toLower(), all = name + QLatin1Char(' ') + menu.toLower();
    for (const QString &word : words) {
        if (!all.contains(word))
            return -1;
    }
    if (words.isEmpty())
        return 0;
    return name.startsWith(words.front()) ? 0 : name.contains(words.front()) ? 1 : 2;
}

QAction *actionOf(const QListWidgetItem &item)
{
    return static_cast<QAction *>(item.data(actionRole).value<void *>());
}

} // namespace

ActionPalette::ActionPalette(const ActionRegistry &actions, QWidget *parent)
    : QDialog(parent), mActions(actions), mSearch(new QLineEdit), mFound(new QListWidget), mRemark(new QLabel)
{
    setWindowTitle(tr("Find action"));
    mSearch->setPlaceholderText(tr("Words of an action's name or menu"));
    mSearch->setClearButtonEnabled(true);
    mSearch->installEventFilter(this);
    mFound->setFocusPolicy(Qt::NoFocus);
    mFound->setAlternatingRowColors(true);
    mFound->setUniformItemSizes(true);
    QPixmap nothing(32, 32);
    nothing.fill(Qt::transparent);
    mNoIcon = nothing;
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(mSearch);
    layout->addWidget(mFound, 1);
    layout->addWidget(mRemark);
    mRemark->setObjectName(QStringLiteral("remark"));
    mRemark->setWordWrap(true);
    connect(mFound, &QListWidget::currentItemChanged, this, &ActionPalette::showRemark);
    connect(mSearch, &QLineEdit::textChanged, this, &ActionPalette::search);
    connect(mSearch, &QLineEdit::returnPressed, this, &ActionPalette::accept);
    connect(mFound, &QListWidget::itemClicked, this, &ActionPalette::accept);
    for (const Entry &entry : entriesOf(actions))
        connect(entry.action, &QAction::enabledChanged, this, &ActionPalette::showWhatRuns);
    search({});
    resizeOnScreen(*this, {520, 420});
}

QAction *ActionPalette::current() const
{
    const QListWidgetItem *item = mFound->currentItem();
    return item ? actionOf(*item) : nullptr;
}

QAction *ActionPalette::chosen() const
{
    QAction *action = current();
    return action && action->isEnabled() ? action : nullptr;
}

void ActionPalette::accept()
{
    if (chosen())
        QDialog::accept();
}

void ActionPalette::showRemark()
{
    const QAction *action = current();
    mRemark->setText(action ? mActions.whyDisabled(action)
                            : tr("No action has all of these words in its name or menu"));
}

bool ActionPalette::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == mSearch && event->type() == QEvent::KeyPress) {
        switch (static_cast<QKeyEvent *>(event)->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            QCoreApplication::sendEvent(mFound, event);
            return true;
        default:
            break;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void ActionPalette::search(const QString &text)
{
    const QStringList words = wordsOf(text);
    struct Match
    {
        int rank;
        Entry entry;
    };
    std::vector<Match> matches;
    for (Entry &entry : entriesOf(mActions)) {
        const int rank = rankOf(entry.title, entry.menu, words);
        if (rank >= 0)
            matches.push_back({rank, std::move(entry)});
    }
    // Those that can be run now come first.
    std::stable_sort(matches.begin(), matches.end(), [](const Match &a, const Match &b) {
        const bool aRuns = a.entry.action->isEnabled(), bRuns = b.entry.action->isEnabled();
        return aRuns != bRuns ? aRuns : a.rank < b.rank;
    });
    mFound->clear();
    for (const Match &match : matches) {
        QAction *const action = match.entry.action;
        const QString keys = keyText(*action);
        QString line = match.entry.title;
        if (!match.entry.menu.isEmpty())
            line += QStringLiteral("   %1").arg(match.entry.menu);
        if (!keys.isEmpty())
            line += QStringLiteral("   [%1]").arg(keys);
        auto *item = new QListWidgetItem(action->icon().isNull() ? mNoIcon : action->icon(), line, mFound);
        item->setData(actionRole, QVariant::fromValue(static_cast<void *>(action)));
        item->setToolTip(action->toolTip());
    }
    mFound->setCurrentRow(0);
    showWhatRuns();
}

//! A job may end while the palette is open.
void ActionPalette::showWhatRuns()
{
    for (int row = 0; row < mFound->count(); ++row) {
        QListWidgetItem *item = mFound->item(row);
        item->setFlags(item->flags().setFlag(Qt::ItemIsEnabled, actionOf(*item)->isEnabled()));
    }
    showRemark();
}

} // namespace autocuts
