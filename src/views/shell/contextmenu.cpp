#include "views/shell/contextmenu.h"

#include "views/actions/actionregistry.h"
#include "views/control/studiocontext.h"
#include "views/control/workspace.h"
#include "views/tools/pickedelements.h"

#include <QMenu>

#include <algorithm>

namespace autocuts {

namespace {

// nullptr is a separator.
constexpr const char *edgeIds[] = {
    "uv.cut", "uv.join",         "uv.clearSteering",   nullptr, "uv.rip",        "uv.stitch",
    nullptr,  "uv.keepStraight", "uv.releaseStraight", nullptr, "uv.straighten", "uv.orientEdges",
    nullptr,  "select.loop"};
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
                                   "uv.lock",
                                   "uv.unlock",
                                   "uv.keepOrientation",
                                   "uv.freeOrientation",
                                   "uv.group",
                                   "uv.ungroup",
                                   "uv.stack",
                                   "uv.unstack",
                                   "uv.stackCopies",
                                   "uv.unstackCopies",
                                   nullptr,
                                   "uv.texelWeight",
                                   "uv.clearTexelWeight",
                                   nullptr,
                                   "uv.cut",
                                   "uv.join",
                                   "uv.rip",
                                   nullptr,
                                   "select.island",
                                   "select.similar",
                                   "select.linked"};
constexpr const char *cornerIds[] = {"uv.pin", "uv.unpin", nullptr, "select.island", "select.linked"};
constexpr const char *mapIds[] = {"uv.unwrap", "uv.finish", "uv.pack", "uv.separate"};
constexpr const char *generalIds[] = {nullptr,           "select.all",    "select.none", "select.invert",
                                      "select.grow",     "select.shrink", nullptr,       "view.hide",
                                      "view.hideOthers", "view.showAll",  nullptr,       "view.frameSelected",
                                      "view.frameAll"};

template <std::size_t Count>
void addEnabled(QMenu &menu, const ActionRegistry &actions, const char *const (&ids)[Count])
{
    for (const char *id : ids) {
        if (!id)
            menu.addSeparator();
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
