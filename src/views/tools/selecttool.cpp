#include "views/tools/selecttool.h"

#include "views/canvas/canvas.h"
#include "views/control/workspace.h"

#include <QPainter>

#include <algorithm>

namespace autocuts {

namespace {

Combine combineOf(Qt::KeyboardModifiers modifiers, Combine withShift)
{
    if (modifiers.testFlag(Qt::ControlModifier))
        return Combine::Subtract;
    return modifiers.testFlag(Qt::ShiftModifier) ? withShift : Combine::Replace;
}

} // namespace

SelectTool::SelectTool(const CanvasContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("select"), parent)
{
    connect(&context.workspace, &Workspace::documentReplaced, this,
            [this] { mAnchorEdge = mAnchorCorner = -1; });
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
}

QString SelectTool::hint() const
{
    const Document *document = context().workspace.document();
    switch (document ? document->selection().mode : SelectionMode::Faces) {
    case SelectionMode::Vertices:
        return tr("Select vertices: click or drag a box, Shift adds, Ctrl+click takes the shortest way");
    case SelectionMode::Edges:
        return tr("Select edges: click or drag a box, Shift adds, Ctrl+click takes the shortest way, "
                  "double-click a loop");
    case SelectionMode::Faces:
        return tr("Select faces: click or drag a box, Shift adds, Ctrl takes away, double-click an island");
    case SelectionMode::Islands:
        return tr("Select islands: click or drag a box, Shift adds, Ctrl takes away, double-click a "
                  "connected part");
    }
    return {};
}

void SelectTool::press(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState != State::Idle)
        return;
    mState = State::Pressed;
    mCanvas = &event.canvas;
    mStart = mEnd = event.position;
}

void SelectTool::move(const ToolEvent &event)
{
    if (mState == State::Idle || &event.canvas != mCanvas)
        return;
    mEnd = event.position;
    const QPointF moved = mEnd - mStart;
    if (mState == State::Pressed && std::hypot(moved.x(), moved.y()) >= dragDistance) {
        mState = State::Box;
        context().view.setHover({});
    }
    if (mState == State::Box)
        Q_EMIT overlayChanged();
}

void SelectTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle || &event.canvas != mCanvas)
        return;
    const State state = mState;
    cancel();
    if (state == State::Pressed) {
        click(event);
        return;
    }
    Document &document = *context().workspace.document();
    const BoxPick box = event.canvas.pickBox(QRectF(mStart, event.position).normalized());
    document.setSelection(combined(document.selection(), pickedElements(document, box),
                                   combineOf(event.modifiers, Combine::Add)));
}

void SelectTool::click(const ToolEvent &event)
{
    Document &document = *context().workspace.document();
    const Selection &current = document.selection();
    Selection picked = pickedElements(document, event.canvas, event.pick);
    Combine combine = combineOf(event.modifiers, Combine::Toggle);
    const bool path = combine == Combine::Subtract &&
                      (current.mode == SelectionMode::Edges || current.mode == SelectionMode::Vertices);
    if (path) {
        combine = Combine::Add;
        const Selection way = pathTo(event.pick);
        if (!way.isEmpty())
            picked = way;
    }
    if (picked.isEmpty() && combine != Combine::Replace)
        return;
    mAnchorEdge = event.pick.edge;
    mAnchorCorner = event.pick.corner;
    document.setSelection(combined(current, picked, combine));
}

Selection SelectTool::pathTo(const PickResult &pick) const
{
    const Document &document = *context().workspace.document();
    const Selection &current = document.selection();
    const auto isSelected = [](const QList<int> &list, int item) {
        return std::binary_search(list.begin(), list.end(), item);
    };
    Selection way;
    way.mode = current.mode;
    if (current.mode == SelectionMode::Edges && pick.edge >= 0 && isSelected(current.edges, mAnchorEdge))
        way.edges = pathBetweenEdges(document, mAnchorEdge, pick.edge);
    if (current.mode == SelectionMode::Vertices && pick.corner >= 0 &&
        isSelected(current.corners, mAnchorCorner))
        way.corners = pathBetweenCorners(document, mAnchorCorner, pick.corner);
    return way;
}

void SelectTool::doubleClick(const ToolEvent &event)
{
    // The first click has replaced or toggled already: the group takes the place of what it clicked.
    if (event.button != Qt::LeftButton)
        return;
    cancel();
    Document &document = *context().workspace.document();
    const Selection group = pickedGroup(document, event.canvas, event.pick);
    if (group.isEmpty())
        return;
    Combine combine = combineOf(event.modifiers, Combine::Add);
    document.setSelection(combined(document.selection(), group, combine));
}

void SelectTool::cancel()
{
    mState = State::Idle;
    Q_EMIT overlayChanged();
}

void SelectTool::drawOverlay(QPainter &painter, const Canvas &canvas)
{
    if (mState != State::Box || &canvas != mCanvas)
        return;
    const QColor color = canvas.content().colors().selection;
    QColor fill = color;
    fill.setAlphaF(0.12f);
    painter.setPen(QPen(color, 1, Qt::DashLine));
    painter.setBrush(fill);
    painter.drawRect(QRectF(mStart, mEnd).normalized());
}

} // namespace autocuts
