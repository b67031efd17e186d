#include "views/shell/contextmenu.h"

#include "views/actions/actionregistry.h"
#include "views/actions/menubuilder.h"
#include "views/control/session/studiocontext.h"
#include "views/control/session/workspace.h"
#include "views/tools/pickedelements.h"

#include <QMenu>

#include <algorithm>
#include <memory>
#include <span>

namespace autocuts {

namespace {

// nullptr is a separator; what names a submenu is not the id of an action.
constexpr const char *edgeIds[] = {"uv.cut", "uv.join",         "uv.clearSteering",
                                   nullptr,  "uv.rip",          "uv.stitch",
                                   nullptr,  "uv.keepStraight", "uv.releaseStraight",
                                   nullptr,  "uv.straighten",   "uv.orientEdges",
                                   nullptr,  "select.loop",     nullptr};
constexpr const char *faceIds[] = {"uv.unwrapSelection",
                                   "uv.runSelection",
                                   "uv.finishSelection",
                                   "uv.relax",
                                   "uv.grid",
                                   nullptr,
                                   "uv.packSelection",
                                   "uv.alignAxes",
                                   "uv.orientBox",
                                   "uv.mirrorU",
                                   "uv.mirrorV",
                                   nullptr,
                                   "UV/Islands",
                                   "UV/Texel density",
                                   nullptr,
                                   "uv.cut",
                                   "uv.join",
                                   "uv.rip",
                                   nullptr};
constexpr const char *cornerIds[] = {"uv.pin", "uv.unpin", nullptr};
constexpr const char *mapIds[] = {"uv.unwrap", "uv.finish", "uv.pack", "uv.separate", nullptr};
constexpr const char *generalIds[] = {"Select",       nullptr, "view.hide",          "view.hideOthers",
                                      "view.showAll", nullptr, "view.frameSelected", "view.frameAll"};

constexpr const char *islandIds[] = {"uv.lock",  "uv.unlock",  "uv.keepOrientation", "uv.freeOrientation",
                                     nullptr,    "uv.group",   "uv.ungroup",         nullptr,
                                     "uv.stack", "uv.unstack", "uv.stackCopies",     "uv.unstackCopies"};
constexpr const char *densityIds[] = {"uv.texelWeight", "uv.clearTexelWeight"};
constexpr const char *selectIds[] = {"select.island", "select.similar", "select.linked",
                                     nullptr,         "select.all",     "select.none",
                                     "select.invert", "select.grow",    "select.shrink"};

struct Submenu
{
    const char *path;
    std::span<const char *const> ids;
};
constexpr Submenu submenus[] = {
    {"UV/Islands", islandIds}, {"UV/Texel density", densityIds}, {"Select", selectIds}};

void addEnabled(QMenu &menu, const ActionRegistry &actions, std::span<const char *const> ids);

//! Adds a submenu unless nothing in it is enabled. False when the id is none.
bool addSubmenu(QMenu &menu, const ActionRegistry &actions, const char *id)
{
    const auto *const found =
        std::find_if(std::begin(submenus), std::end(submenus),
                     [&](const Submenu &entry) { return QLatin1String(entry.path) == QLatin1String(id); });
    if (found == std::end(submenus))
        return false;
    auto made = std::make_unique<QMenu>(menuTitle(QLatin1String(id)), &menu);
    made->setToolTipsVisible(true);
    addEnabled(*made, actions, found->ids);
    if (!made->isEmpty())
        menu.addMenu(made.release());
    return true;
}

void addEnabled(QMenu &menu, const ActionRegistry &actions, std::span<const char *const> ids)
{
    for (const char *id : ids) {
        if (!id)
            menu.addSeparator();
        else if (addSubmenu(menu, actions, id))
            continue;
        else if (QAction *action = actions.action(id); action->isEnabled())
            menu.addAction(action);
    }
}

bool containsAll(const QList<int> &all, const QList<int> &some)
{
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

} // namespace

void selectUnderMouse(const StudioContext &context, const ToolCanvas &canvas, const PickResult &pick)
{
    Document *document = context.workspace.document();
    if (!document)
        return;
    const Selection now = document->selection();
    const Selection picked = pickedElements(*document, canvas, pick);
    const bool isSelected = containsAll(now.faces, picked.faces) && containsAll(now.edges, picked.edges) &&
                            containsAll(now.corners, picked.corners);
    if (!isSelected)
        document->setSelection(combined(now, picked, Combine::Replace));
}

void fillContextMenu(QMenu &menu, const StudioContext &context)
{
    const ActionRegistry &actions = context.actions;
    const Document *document = context.workspace.document();
    menu.setToolTipsVisible(true);
    if (!document) {
        menu.addAction(actions.action("file.open"));
        return;
    }
    const Selection &selection = document->selection();
    if (!selection.edges.isEmpty())
        addEnabled(menu, actions, edgeIds);
    else if (!selection.faces.isEmpty())
        addEnabled(menu, actions, faceIds);
    else if (!selection.corners.isEmpty())
        addEnabled(menu, actions, cornerIds);
    else
        addEnabled(menu, actions, mapIds);
    addEnabled(menu, actions, generalIds);
}

} // namespace autocuts
