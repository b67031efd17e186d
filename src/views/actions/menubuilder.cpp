// Submenus appear where the table first names them.
#include "views/actions/menubuilder.h"

#include "views/actions/actionregistry.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include <array>

namespace autocuts {

namespace {

struct MenuTitle
{
    const char *path;
    const char *title;
};

constexpr std::array menuTitles{
    MenuTitle{"File", QT_TRANSLATE_NOOP("Menus", "&File")},
    MenuTitle{"File/Open sample", QT_TRANSLATE_NOOP("Menus", "Open sa&mple")},
    MenuTitle{"File/Open recent", QT_TRANSLATE_NOOP("Menus", "Open &recent")},
    MenuTitle{"Edit", QT_TRANSLATE_NOOP("Menus", "&Edit")},
    MenuTitle{"Select", QT_TRANSLATE_NOOP("Menus", "&Select")},
    MenuTitle{"Select/Similar faces", QT_TRANSLATE_NOOP("Menus", "Simila&r faces")},
    MenuTitle{"Select/Similar edges", QT_TRANSLATE_NOOP("Menus", "Similar edges")},
    MenuTitle{"Select/Rows", QT_TRANSLATE_NOOP("Menus", "Rows")},
    MenuTitle{"Select/Edges", QT_TRANSLATE_NOOP("Menus", "Edges &by kind")},
    MenuTitle{"Select/Islands", QT_TRANSLATE_NOOP("Menus", "Islands b&y figures")},
    MenuTitle{"UV", QT_TRANSLATE_NOOP("Menus", "&UV")},
    MenuTitle{"UV/Solver", QT_TRANSLATE_NOOP("Menus", "So&lver")},
    MenuTitle{"UV/Solver/Start mode", QT_TRANSLATE_NOOP("Menus", "S&tart mode")},
    MenuTitle{"UV/Solver/Energy", QT_TRANSLATE_NOOP("Menus", "Ener&gy")},
    MenuTitle{"UV/Solver/Seam weighting", QT_TRANSLATE_NOOP("Menus", "Seam &weighting")},
    MenuTitle{"UV/Sets", QT_TRANSLATE_NOOP("Menus", "UV sets")},
    MenuTitle{"UV/Tools", QT_TRANSLATE_NOOP("Menus", "Tools")},
    MenuTitle{"UV/Pack into tiles", QT_TRANSLATE_NOOP("Menus", "Pack into tiles")},
    MenuTitle{"UV/Islands", QT_TRANSLATE_NOOP("Menus", "Islan&ds")},
    MenuTitle{"UV/Texel density", QT_TRANSLATE_NOOP("Menus", "Texel density")},
    MenuTitle{"UV/Layout", QT_TRANSLATE_NOOP("Menus", "La&yout")},
    MenuTitle{"UV/Layout/Align", QT_TRANSLATE_NOOP("Menus", "&Align")},
    MenuTitle{"UV/Layout/Distribute", QT_TRANSLATE_NOOP("Menus", "Distri&bute")},
    MenuTitle{"View", QT_TRANSLATE_NOOP("Menus", "&View")},
    MenuTitle{"View/Coloring", QT_TRANSLATE_NOOP("Menus", "&Colouring")},
    MenuTitle{"View/Pattern", QT_TRANSLATE_NOOP("Menus", "Patter&n")},
    MenuTitle{"View/From", QT_TRANSLATE_NOOP("Menus", "Look from")},
    MenuTitle{"View/Panels", QT_TRANSLATE_NOOP("Menus", "Panels")},
    MenuTitle{"Help", QT_TRANSLATE_NOOP("Menus", "He&lp")},
};

//! The actions of the tool bar; nullptr is a separator.
constexpr const char *toolBarIds[] = {
    "file.open", "file.save",       nullptr,        "edit.undo",    "edit.redo",     nullptr,   "uv.run",
    "uv.step",   "uv.restart",      nullptr,        "uv.unwrap",    "uv.finish",     "uv.pack", "uv.separate",
    nullptr,     "select.vertices", "select.edges", "select.faces", "select.islands"};

} // namespace

QString menuTitle(const QString &path)
{
    for (const MenuTitle &entry : menuTitles) {
        if (path == QLatin1String(entry.path))
            return QCoreApplication::translate("Menus", entry.title);
    }
    return {};
}

MenuBuilder::MenuBuilder(const ActionRegistry &actions, QMenuBar &bar) : mBar(bar)
{
    for (QAction *action : actions.actions()) {
        const ActionInfo &info = actions.info(action);
        const QString path = QLatin1String(info.menu);
        if (path.isEmpty())
            continue;
        const bool first = !mMenus.contains(path);
        QMenu *const target = find(path, info.separatorBefore);
        if (info.separatorBefore && !first)
            target->addSeparator();
        target->addAction(action);
    }
}

QMenu *MenuBuilder::menu(const QString &path) const
{
    const auto found = mMenus.find(path);
    Q_ASSERT(found != mMenus.end());
    return found->second;
}

QMenu *MenuBuilder::find(const QString &path, bool separatorBefore)
{
    if (const auto found = mMenus.find(path); found != mMenus.end())
        return found->second;
    QMenu *made = nullptr;
    if (const qsizetype slash = path.lastIndexOf(QLatin1Char('/')); slash < 0) {
        made = mBar.addMenu(menuTitle(path));
    } else {
        QMenu *const parent = find(path.left(slash), false);
        if (separatorBefore)
            parent->addSeparator();
        made = parent->addMenu(menuTitle(path));
    }
    made->setObjectName(path);
    made->setToolTipsVisible(true);
    return mMenus[path] = made;
}

void fillToolBar(const ActionRegistry &actions, QToolBar &bar)
{
    for (const char *id : toolBarIds) {
        if (id)
            bar.addAction(actions.action(id));
        else
            bar.addSeparator();
    }
}

} // namespace autocuts
