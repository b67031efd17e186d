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

//! The menus that lead to an action, such as "UV > Layout > Align".
QString menuText(const ActionInfo &info)
{
    QStringList titles;
    QString path;
    for (const QString &part : QString::fromLatin1(info.menu).split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        path += path.isEmpty() ? part : QLatin1Char('/') + part;
        titles << menuTitle(path).remove(QLatin1Char('&'));
    }
    return titles.join(QStringLiteral(" > "));
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
    search({});
    resizeOnScreen(*this, {520, 420});
}

QAction *ActionPalette::current() const
{
    const QListWidgetItem *item = mFound->currentItem();
    return item ? static_cast<QAction *>(item->data(actionRole).value<void *>()) : nullptr;
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
    const QStringList words = text.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    struct Match
    {
        int rank;
        QAction *action;
    };
    std::vector<Match> matches;
    for (QAction *action : mActions.actions()) {
        const ActionInfo &info = mActions.info(action);
        const int rank = rankOf(actionTitle(info), menuText(info), words);
        if (rank >= 0)
            matches.push_back({rank, action});
    }
    // Those that can be run now come first.
    std::stable_sort(matches.begin(), matches.end(), [](const Match &a, const Match &b) {
        const bool aRuns = a.action->isEnabled(), bRuns = b.action->isEnabled();
        return aRuns != bRuns ? aRuns : a.rank < b.rank;
    });
    mFound->clear();
    for (const Match &match : matches) {
        const ActionInfo &info = mActions.info(match.action);
        const QString menu = menuText(info), keys = keyText(*match.action);
        QString line = actionTitle(info);
        if (!menu.isEmpty())
            line += QStringLiteral("   %1").arg(menu);
        if (!keys.isEmpty())
            line += QStringLiteral("   [%1]").arg(keys);
        auto *item =
            new QListWidgetItem(match.action->icon().isNull() ? mNoIcon : match.action->icon(), line, mFound);
        item->setData(actionRole, QVariant::fromValue(static_cast<void *>(match.action)));
        item->setToolTip(match.action->toolTip());
        if (!match.action->isEnabled())
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    mFound->setCurrentRow(0);
    showRemark();
}

} // namespace autocuts
