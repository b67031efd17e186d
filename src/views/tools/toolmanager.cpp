#include "views/tools/toolmanager.h"

#include "views/canvas/canvas.h"
#include "views/control/workspace.h"
#include "views/tools/dragtool.h"
#include "views/tools/islandtool.h"
#include "views/tools/packboxtool.h"
#include "views/tools/painttool.h"
#include "views/tools/pintool.h"
#include "views/tools/rectangletool.h"
#include "views/tools/regiontool.h"
#include "views/tools/seamtool.h"
#include "views/tools/selecttool.h"

#include <algorithm>

namespace autocuts {

ToolManager::ToolManager(const CanvasContext &context, QObject *parent) : QObject(parent)
{
    add(std::make_unique<SelectTool>(context, QStringLiteral("select"), SelectShape::Box));
    add(std::make_unique<SelectTool>(context, QStringLiteral("lasso"), SelectShape::Lasso));
    add(std::make_unique<SelectTool>(context, QStringLiteral("selectBrush"), SelectShape::Brush));
    add(std::make_unique<SeamTool>(context, SeamTool::Kind::Cut));
    add(std::make_unique<SeamTool>(context, SeamTool::Kind::Join));
    add(std::make_unique<PaintTool>(context));
    add(std::make_unique<RegionTool>(context));
    add(std::make_unique<IslandTool>(context, QStringLiteral("move"), UvEdit::Move));
    add(std::make_unique<IslandTool>(context, QStringLiteral("rotate"), UvEdit::Rotate));
    add(std::make_unique<IslandTool>(context, QStringLiteral("scale"), UvEdit::Scale));
    add(std::make_unique<DragTool>(context));
    add(std::make_unique<PinTool>(context));
    add(std::make_unique<RectangleTool>(context));
    add(std::make_unique<PackBoxTool>(context));
    mActive = mTools.front().get();
    mActive->activate();
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] { mActive->cancel(); });
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
}

void ToolManager::setTool(const QString &id)
{
    const auto found =
        std::find_if(mTools.begin(), mTools.end(), [&id](const auto &tool) { return tool->id() == id; });
    if (found == mTools.end() || found->get() == mActive)
        return;
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
    if (mMouseCanvas && mActive->id() == id && mMouseCanvas->content().mesh())
        mActive->chosen(*mMouseCanvas, mMouse);
}

void ToolManager::setMouse(Canvas *canvas, const QPointF &position)
{
    mMouseCanvas = canvas;
    mMouse = position;
}

} // namespace autocuts
