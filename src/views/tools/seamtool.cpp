#include "views/tools/seamtool.h"

#include "model/editing/selectiontools.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/tools/tooldrawing.h"

#include <QPainter>

#include <cmath>

namespace autocuts {

SeamTool::SeamTool(const StudioContext &context, Kind kind, QObject *parent)
    : AbstractTool(context, kind == Kind::Cut ? QStringLiteral("cut") : QStringLiteral("join"), parent),
      mKind(kind), mEdit(kind == Kind::Cut ? SetSeamState::Edit::Cut : SetSeamState::Edit::Join)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mAnchor = {};
        mGain.clear();
        leave();
    });
    connect(&context.solver, &SolverController::statusChanged, this, [this] {
        if (!mGain.text(this->context().solver).isEmpty())
            Q_EMIT overlayChanged();
    });
}

QString SeamTool::hint() const
{
    return mKind == Kind::Cut
               ? tr("Cut: click an edge, drag along a way, double-click a loop, Ctrl+click the way from the "
                    "last click, Shift clears")
               : tr("Join: click an edge, drag along a way, double-click a loop, Ctrl+click the way from the "
                    "last click, Shift clears");
}

void SeamTool::deactivate()
{
    cancel();
    mAnchor = {};
    mGain.clear();
}

void SeamTool::press(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState != State::Idle)
        return;
    mState = State::Pressed;
    mCanvas = &event.canvas;
    mStart = event.position;
    mFirst = pathEnd(*context().workspace.document(), event.pick);
    showUnder(event);
}

void SeamTool::move(const ToolEvent &event)
{
    if (mState != State::Idle && &event.canvas != mCanvas)
        return;
    const QPointF moved = event.position - mStart;
    if (mState == State::Pressed && std::hypot(moved.x(), moved.y()) < dragDistance)
        return;
    if (mState == State::Pressed)
        mState = State::Path;
    showUnder(event);
}

void SeamTool::showUnder(const ToolEvent &event)
{
    const SetSeamState::Edit own = mKind == Kind::Cut ? SetSeamState::Edit::Cut : SetSeamState::Edit::Join;
    mEdit = event.modifiers.testFlag(Qt::ShiftModifier) ? SetSeamState::Edit::Clear : own;
    const PathEnd end = pathEnd(*context().workspace.document(), event.pick);
    if (mState == State::Path)
        showPath(mFirst, end);
    else if (event.modifiers.testFlag(Qt::ControlModifier) && !mAnchor.isNone())
        showPath(mAnchor, end);
    else if (event.pick.edge >= 0)
        showEdges({event.pick.edge});
    else
        showEdges({});
}

void SeamTool::showPath(const PathEnd &from, const PathEnd &to)
{
    if (from == mPathFrom && to == mPathTo) {
        Q_EMIT overlayChanged();
        return;
    }
    showEdges(pathBetween(*context().workspace.document(), from, to));
    mPathFrom = from;
    mPathTo = to;
}

void SeamTool::showEdges(std::vector<int> edges)
{
    mPathFrom = mPathTo = {};
    const Document *document = context().workspace.document();
    // Boundaries of the model are open anyway.
    std::erase_if(edges, [document](int edge) { return document->adjacency().isBoundary(edge); });
    mPreview = std::move(edges);
    Q_EMIT overlayChanged();
}

void SeamTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle || &event.canvas != mCanvas)
        return;
    const Document &document = *context().workspace.document();
    if (mState == State::Path)
        showUnder(event); // otherwise the pressed edge stays shown
    else
        mClick = context().workspace.document()->undoStack().newGesture();
    const PathEnd end = mState == State::Path ? pathEnd(document, event.pick) : mFirst;
    commit(mState == State::Path ? 0 : mClick);
    mState = State::Idle;
    if (!end.isNone())
        mAnchor = end;
    showUnder(event);
}

void SeamTool::doubleClick(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton)
        return;
    cancel();
    const Document &document = *context().workspace.document();
    showUnder(event);
    if (event.pick.edge < 0)
        return;
    showEdges(edgeLoop(document.mesh(), document.adjacency(), event.pick.edge));
    commit(mClick);
}

void SeamTool::commit(quint64 gesture)
{
    if (mPreview.empty())
        return;
    Document &document = *context().workspace.document();
    auto command =
        std::make_unique<SetSeamState>(document, mEdit, cornerPairsOfEdges(document.mesh(), mPreview));
    command->setGesture(gesture);
    if (pushCommand(std::move(command)))
        mGain.begin(context().solver);
    Q_EMIT overlayChanged();
}

void SeamTool::leave()
{
    mPreview.clear();
    mPathFrom = mPathTo = {};
    Q_EMIT overlayChanged();
}

void SeamTool::cancel()
{
    mState = State::Idle;
    leave();
}

void SeamTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    const ViewColors &colors = canvas.content().colors();
    const auto colorOf = [&colors](SideStyle style) { return colors.sides[static_cast<int>(style)]; };
    const QColor color = mEdit == SetSeamState::Edit::Cut    ? colorOf(SideStyle::ForcedCut)
                         : mEdit == SetSeamState::Edit::Join ? colorOf(SideStyle::Joined)
                                                             : colors.text;
    drawEdges(painter, canvas, mPreview, color);
    if (const QString gain = mGain.text(context().solver); !gain.isEmpty())
        drawNote(painter, canvas, gain);
}

} // namespace autocuts
