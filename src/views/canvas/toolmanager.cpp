#include "views/canvas/toolmanager.h"

#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"

#include <algorithm>

namespace autocuts {

ToolManager::ToolManager(const StudioContext &context, QObject *parent) : QObject(parent), mMap(context.map)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        if (mActive)
            mActive->cancel();
    });
}

ToolManager::~ToolManager() = default;

void ToolManager::add(std::unique_ptr<AbstractTool> tool)
{
    AbstractTool *added = mTools.emplace_back(std::move(tool)).get();
    connect(added, &AbstractTool::hintChanged, this, [this, added] {
        if (added == mActive)
            Q_EMIT hintChanged(added->hint());
    });
    connect(added, &AbstractTool::overlayChanged, this, &ToolManager::overlayChanged);
    if (!mActive) {
        mActive = added;
        mActive->activate();
    }
}

void ToolManager::setTool(const QString &id)
{
    const auto found =
        std::find_if(mTools.begin(), mTools.end(), [&id](const auto &tool) { return tool->id() == id; });
    if (found == mTools.end() || found->get() == mActive)
        return;
    if (mActive)
        mActive->deactivate();
    mActive = found->get();
    mActive->activate();
    Q_EMIT toolChanged();
    Q_EMIT hintChanged(mActive->hint());
    Q_EMIT overlayChanged();
}

void ToolManager::choose(const QString &id)
{
    setTool(id);
    if (mMouseCanvas && mayBegin() && mActive->id() == id && mMouseCanvas->content().mesh())
        mActive->chosen(*mMouseCanvas, mMouse);
}

bool ToolManager::mayBegin() const
{
    return mActive && !(mActive->movesMap() && mMap.isPreviewing());
}

void ToolManager::setMouse(ToolCanvas *canvas, const QPointF &position)
{
    mMouseCanvas = canvas;
    mMouse = position;
}

} // namespace autocuts
