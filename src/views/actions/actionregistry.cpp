// Makes actions from the table: texts, tooltips, groups, shortcuts.
#include "views/actions/actionregistry.h"

#include "views/ui/icons.h"
#include "views/ui/preferences.h"

#include <QActionGroup>
#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace autocuts {

namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("Actions", text);
}

//! What to do about a need that is not met. In the order in which they are said.
constexpr std::pair<int, const char *> reasons[] = {
    {NeedsDocument, QT_TRANSLATE_NOOP("Actions", "Open a model first")},
    {NeedsIdle, QT_TRANSLATE_NOOP("Actions", "A job is running: wait for its end, or cancel it")},
    {NeedsUvs, QT_TRANSLATE_NOOP("Actions", "There is no map yet: unwrap first")},
    {NeedsSelectedEdges, QT_TRANSLATE_NOOP("Actions", "Select edges first")},
    {NeedsSelectedFaces, QT_TRANSLATE_NOOP("Actions", "Select faces or islands first")},
    {NeedsEdgesOrFaces, QT_TRANSLATE_NOOP("Actions", "Select edges or faces first")},
    {NeedsSelection, QT_TRANSLATE_NOOP("Actions", "Select something first")},
    {NeedsUndo, QT_TRANSLATE_NOOP("Actions", "There is nothing to take back")},
    {NeedsRedo, QT_TRANSLATE_NOOP("Actions", "Nothing was taken back")},
    {NeedsJob, QT_TRANSLATE_NOOP("Actions", "No job is running")},
    {NeedsOverlaps, QT_TRANSLATE_NOOP("Actions", "No overlaps are known")},
    {NeedsHidden, QT_TRANSLATE_NOOP("Actions", "Nothing is hidden")},
    {NeedsFile, QT_TRANSLATE_NOOP("Actions", "The model is from no file: re-link it to one")},
    {NeedsSeveralSets, QT_TRANSLATE_NOOP("Actions", "There is only one UV set: make another one first")}};

QString toolTip(const ActionInfo &info, const QKeySequence &keys, const QString &why)
{
    QString text = actionTitle(info) + QLatin1Char('\n') + translated(info.tip);
    if (!keys.isEmpty())
        text += QStringLiteral(" [%1]").arg(keys.toString(QKeySequence::NativeText));
    return why.isEmpty() ? text : text + QLatin1Char('\n') + why;
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
        mUnmet.push_back(0);
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
        const int unmet = actionTable()[i].needs & ~met;
        if (std::exchange(mUnmet[i], unmet) != unmet)
            showToolTip(i);
        mActions[i]->setEnabled(unmet == 0);
    }
}

void ActionRegistry::showToolTip(std::size_t i)
{
    mActions[i]->setToolTip(toolTip(actionTable()[i], mActions[i]->shortcut(), whyDisabled(mActions[i])));
}

QString ActionRegistry::nameWithKeys(const char *id) const
{
    const QAction *own = action(id);
    const QString keys = own->shortcut().toString(QKeySequence::NativeText);
    return keys.isEmpty() ? own->iconText() : QStringLiteral("%1 (%2)").arg(own->iconText(), keys);
}

QString ActionRegistry::whyDisabled(const QAction *action) const
{
    const auto place =
        static_cast<std::size_t>(std::find(mActions.begin(), mActions.end(), action) - mActions.begin());
    if (place == mActions.size())
        return {};
    for (const auto &[need, text] : reasons) {
        if (mUnmet[place] & need)
            return translated(text);
    }
    return {};
}

QAction *ActionRegistry::disabledActionOf(const QKeySequence &keys) const
{
    QAction *found = nullptr;
    for (QAction *action : mActions) {
        if (!action->shortcuts().contains(keys))
            continue;
        if (action->isEnabled())
            return nullptr;
        found = found ? found : action;
    }
    return found;
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
        showToolTip(i);
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
