// Makes actions from the table: texts, tooltips, groups, shortcuts.
#include "views/actions/actionregistry.h"

#include "views/ui/icons.h"
#include "views/ui/preferences.h"

#include <QActionGroup>
#include <QCoreApplication>

namespace autocuts {

namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("Actions", text);
}

QString toolTip(const ActionInfo &info, const QKeySequence &keys)
{
    QString text = actionTitle(info) + QLatin1Char('\n') + translated(info.tip);
    if (!keys.isEmpty())
        text += QStringLiteral(" [%1]").arg(keys.toString(QKeySequence::NativeText));
    return text;
}

} // namespace

QString actionTitle(const ActionInfo &info)
{
    QString text = translated(info.text);
    text.remove(QLatin1Char('&'));
    if (text.endsWith(QStringLiteral("...")))
        text.chop(3);
    return text;
}

QList<QKeySequence> defaultShortcuts(const ActionInfo &info)
{
    QList<QKeySequence> keys =
        QKeySequence::listFromString(QLatin1String(info.keys), QKeySequence::PortableText);
    keys.removeAll(QKeySequence());
    return keys;
}

ActionRegistry::ActionRegistry(Preferences &preferences, QObject *parent)
    : QObject(parent), mPreferences(preferences)
{
    std::map<QString, QActionGroup *> groups;
    for (const ActionInfo &info : actionTable()) {
        const QString id = QLatin1String(info.id);
        auto *action = new QAction(this);
        action->setObjectName(id);
        action->setText(translated(info.text));
        action->setIconText(actionTitle(info));
        action->setCheckable(info.checkable);
        // Menus show the check mark instead of the icon.
        action->setIconVisibleInMenu(!info.checkable);
        // Without a role: other platforms would move actions with roles to other menus.
        action->setMenuRole(QAction::NoRole);
        if (const QString group = QLatin1String(info.group); !group.isEmpty()) {
            if (!groups.contains(group))
                groups[group] = new QActionGroup(this);
            groups[group]->addAction(action);
        }
        mActions.push_back(action);
        mById[id] = action;
    }
    applyIcons();
    applyShortcuts();
    setMet(0);
    connect(&preferences, &Preferences::shortcutsChanged, this, &ActionRegistry::applyShortcuts);
}

QAction *ActionRegistry::action(const char *id) const
{
    const auto found = mById.find(QLatin1String(id));
    Q_ASSERT(found != mById.end());
    return found->second;
}

const ActionInfo &ActionRegistry::info(const QAction *action) const
{
    const auto found = std::find(mActions.begin(), mActions.end(), action);
    Q_ASSERT(found != mActions.end());
    return actionTable()[found - mActions.begin()];
}

QList<QAction *> ActionRegistry::conflicts(const QAction *action, const QKeySequence &keys) const
{
    QList<QAction *> result;
    for (QAction *other : mActions) {
        if (other != action && !keys.isEmpty() && other->shortcuts().contains(keys))
            result.append(other);
    }
    return result;
}

void ActionRegistry::setMet(int met)
{
    for (std::size_t i = 0; i < mActions.size(); ++i) {
        const int needs = actionTable()[i].needs;
        mActions[i]->setEnabled((needs & met) == needs);
    }
}

void ActionRegistry::applyShortcuts()
{
    const QMap<QString, QKeySequence> changed = mPreferences.shortcuts();
    for (std::size_t i = 0; i < mActions.size(); ++i) {
        const ActionInfo &info = actionTable()[i];
        const auto own = changed.find(QLatin1String(info.id));
        QList<QKeySequence> keys = defaultShortcuts(info);
        if (own != changed.end())
            keys = own->isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{*own};
        mActions[i]->setShortcuts(keys);
        mActions[i]->setToolTip(toolTip(info, mActions[i]->shortcut()));
    }
}

void ActionRegistry::applyIcons()
{
    for (std::size_t i = 0; i < mActions.size(); ++i) {
        const char *const name = actionTable()[i].icon;
        if (*name)
            mActions[i]->setIcon(icon(QLatin1String(name)));
    }
}

} // namespace autocuts
