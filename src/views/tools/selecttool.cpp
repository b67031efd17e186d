#include "views/tools/selecttool.h"

#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/session/workspace.h"

#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <set>

namespace autocuts {

namespace {

Combine combineOf(Qt::KeyboardModifiers modifiers, Combine withShift)
{
    if (modifiers.testFlag(Qt::ControlModifier))
        return Combine::Subtract;
    return modifiers.testFlag(Qt::ShiftModifier) ? withShift : Combine::Replace;
}

} // namespace

SelectTool::SelectTool(const StudioContext &context, const QString &id, SelectShape shape, QObject *parent)
    : AbstractTool(context, id, parent), mShape(shape)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mAnchorEdge = mAnchorCorner = -1;
        mLastClick.reset();
        mState = State::Idle; // a stroke must not be undone in another document
    });
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
}

//! The hint about how a drag selects.
QString SelectTool::gestureHint() const
{
    switch (mShape) {
    case SelectShape::Lasso:
        return tr("draw a lasso");
    case SelectShape::Brush:
        return tr("paint, Shift+wheel sizes");
    case SelectShape::Box:
        break;
    }
    return tr("drag a box");
}

QString SelectTool::hint() const
{
    const Document *document = context().workspace.document();
    const QString gesture = gestureHint();
    switch (document ? document->selection().mode : SelectionMode::Faces) {
    case SelectionMode::Vertices:
        return tr("Select vertices: click or %1, Shift adds, Ctrl+click takes the shortest way").arg(gesture);
    case SelectionMode::Edges:
        return tr("Select edges: click or %1, Shift adds, Ctrl+click takes the shortest way, "
                  "double-click a loop")
            .arg(gesture);
    case SelectionMode::Faces:
        return tr("Select faces: click or %1, Shift adds, Ctrl takes away, double-click an island")
            .arg(gesture);
    case SelectionMode::Islands:
        return tr("Select islands: click or %1, Shift adds, Ctrl takes away, double-click a "
                  "connected part")
            .arg(gesture);
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
    mLasso = QPolygonF({mStart});
}

void SelectTool::move(const ToolEvent &event)
{
    if (mShape == SelectShape::Brush && (mState == State::Idle || &event.canvas == mCanvas)) {
        mCanvas = &event.canvas;
        mBrush = event.position;
        Q_EMIT overlayChanged();
    }
    if (mState == State::Idle || &event.canvas != mCanvas)
        return;
    mEnd = event.position;
    const QPointF moved = mEnd - mStart;
    if (mState == State::Pressed && std::hypot(moved.x(), moved.y()) >= dragDistance) {
        mState = State::Dragging;
        context().view.setHover({});
        mBefore = context().workspace.document()->selection();
        mStroke = {};
        mStroke.mode = mBefore.mode;
    }
    if (mState != State::Dragging)
        return;
    if (mShape == SelectShape::Brush)
        paint(event);
    else
        mLasso << mEnd;
    Q_EMIT overlayChanged();
}

void SelectTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle || &event.canvas != mCanvas)
        return;
    const State state = mState;
    mEnd = event.position;
    mState = State::Idle;
    Q_EMIT overlayChanged();
    if (state == State::Pressed) {
        click(event);
        return;
    }
    if (mShape == SelectShape::Brush) {
        paint(event);
        return;
    }
    Document &document = *context().workspace.document();
    document.setSelection(combined(document.selection(),
                                   pickedElements(document, event.canvas.pickBox(region())),
                                   combineOf(event.modifiers, Combine::Add)));
}

PickRegion SelectTool::region() const
{
    if (mShape != SelectShape::Lasso)
        return QRectF(mStart, mEnd).normalized();
    return {mLasso.boundingRect(),
            [lasso = mLasso](const QPointF &p) { return lasso.containsPoint(p, Qt::OddEvenFill); }};
}

void SelectTool::paint(const ToolEvent &event)
{
    Document &document = *context().workspace.document();
    const QPointF centre = event.position, reach(mRadius, mRadius);
    const auto isNear = [centre, radius = mRadius](const QPointF &p) {
        return std::hypot(p.x() - centre.x(), p.y() - centre.y()) <= radius;
    };
    BoxPick picked = event.canvas.pickBox({QRectF(centre - reach, centre + reach), isNear});
    // The centre of a large face may be far from the brush although the brush is on the face.
    if (const int triangle = event.canvas.pick(centre).triangle; triangle >= 0)
        picked.faces.push_back(document.mesh().triangleFace[triangle]);
    Selection touched = pickedElements(document, picked);
    touched.normalize(document.mesh());
    mStroke = combined(mStroke, touched, Combine::Add);
    document.setSelection(combined(mBefore, mStroke, combineOf(event.modifiers, Combine::Add)));
}

std::vector<ToolOption> SelectTool::options()
{
    if (mShape != SelectShape::Brush)
        return {};
    return {ToolOption::number(tr("Size"), tr("Radius of the brush; Shift+wheel"), mRadius, smallestRadius,
                               largestRadius, tr(" px"), [this](double radius) {
                                   mRadius = radius;
                                   Q_EMIT overlayChanged();
                               })};
}

bool SelectTool::wheel(const QWheelEvent &event, ToolCanvas &)
{
    if (mShape != SelectShape::Brush || !event.modifiers().testFlag(Qt::ShiftModifier))
        return false;
    // Some platforms report horizontal scrolling while Shift is held.
    const int turned = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    mRadius = std::clamp(mRadius * std::pow(1.1, turned / 120.0), smallestRadius, largestRadius);
    Q_EMIT overlayChanged();
    return true;
}

void SelectTool::leave()
{
    mBrush.reset();
    Q_EMIT overlayChanged();
}

void SelectTool::click(const ToolEvent &event)
{
    Document &document = *context().workspace.document();
    const Selection &current = document.selection();
    PickResult pick = event.pick;
    pick.triangle = clickedTriangle(event);
    Selection picked = pickedElements(document, event.canvas, pick);
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

int SelectTool::clickedTriangle(const ToolEvent &event)
{
    const Document &document = *context().workspace.document();
    const SelectionMode mode = document.selection().mode;
    if (mode == SelectionMode::Vertices || mode == SelectionMode::Edges)
        return event.pick.triangle;
    std::vector<int> layers; // of which each shows another element
    std::set<int> seen;
    for (int triangle : event.canvas.trianglesAt(event.position)) {
        const int face = document.mesh().triangleFace[triangle];
        if (seen.insert(mode == SelectionMode::Islands ? document.islands().islandOfFace(face) : face).second)
            layers.push_back(triangle);
    }
    const QPointF way = event.position - mLastClick.value_or(QPointF(-1e6, -1e6));
    mLayer = std::hypot(way.x(), way.y()) < dragDistance ? mLayer + 1 : 0;
    mLastClick = event.position;
    return layers.empty() ? event.pick.triangle : layers[mLayer % layers.size()];
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
    // The first click has already changed the selection: the group replaces what it clicked.
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
    if (mState == State::Dragging && mShape == SelectShape::Brush && context().workspace.document())
        context().workspace.document()->setSelection(mBefore);
    mState = State::Idle;
    Q_EMIT overlayChanged();
}

void SelectTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mCanvas)
        return;
    const QColor color = canvas.content().colors().selection;
    QColor fill = color;
    fill.setAlphaF(0.12f);
    if (mShape == SelectShape::Brush) {
        if (!mBrush)
            return;
        painter.setPen(QPen(color, 1));
        painter.setBrush(mState == State::Dragging ? QBrush(fill) : QBrush());
        painter.drawEllipse(*mBrush, mRadius, mRadius);
        return;
    }
    if (mState != State::Dragging)
        return;
    painter.setPen(QPen(color, 1, Qt::DashLine));
    painter.setBrush(fill);
    if (mShape == SelectShape::Lasso)
        painter.drawPolygon(mLasso, Qt::OddEvenFill);
    else
        painter.drawRect(QRectF(mStart, mEnd).normalized());
}

} // namespace autocuts
