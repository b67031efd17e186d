#include "views/tools/rectangletool.h"

#include "model/document/islandcolor.h"
#include "model/editing/selectiontools.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/selecting/selecting.h"
#include "views/tools/rectanglebar.h"
#include "views/tools/snapping.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

bool isDrag(const QPointF &way)
{
    return std::hypot(way.x(), way.y()) >= dragDistance;
}

} // namespace

RectangleTool::RectangleTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("rectangle"), parent)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        reset();
        setActive(0);
    });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type != ChangeEvent::Type::Rectangle)
            return;
        if (mActive != 0 && !this->context().workspace.document()->constraints().rectangle(mActive))
            setActive(0);
        Q_EMIT overlayChanged();
    });
}

RectangleTool::~RectangleTool() = default;

QString RectangleTool::hint() const
{
    if (mState == State::Assign)
        return tr("Drop into a rectangle to assign the island, outside to let it go");
    if (mActive != 0)
        return tr(
            "Drag handles to resize, the outline to move, islands into it to assign them; double-click: "
            "rename, Delete: remove, Ctrl: snap");
    return tr("Rectangles: drag over empty space, or with Shift anywhere, to draw one; drag islands into it");
}

void RectangleTool::activate()
{
    setActive(mActive);
}

void RectangleTool::deactivate()
{
    cancel();
    if (mBar)
        mBar->setRectangle(0);
}

const std::vector<LayoutRectangle> &RectangleTool::rectangles() const
{
    return context().workspace.document()->constraints().rectangles;
}

void RectangleTool::setActive(int id)
{
    mActive = id;
    if (!mBar && mView && id != 0) {
        mBar = new RectangleBar(context().workspace, mView);
        connect(mBar, &RectangleBar::packRequested, this, &RectangleTool::pack);
    }
    if (mBar)
        mBar->setRectangle(id);
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
}

void RectangleTool::press(const ToolEvent &event)
{
    if (event.button == Qt::RightButton && isBusy()) {
        cancel();
        return;
    }
    auto *view = asMap(&event.canvas);
    if (event.button != Qt::LeftButton || isBusy() || !view)
        return;
    mView = view;
    mState = State::Pressed;
    mStart = mEnd = event.position;
    mGrip = gripAt(rectangles(), mActive, *view->mapCamera(), mStart);
    mIntent = Intent::Change;
    if (mGrip.id != 0 && !event.modifiers.testFlag(Qt::ShiftModifier))
        return;
    mIntent = Intent::Draw;
    if (event.modifiers.testFlag(Qt::ShiftModifier))
        return;
    if (event.pick.triangle >= 0) {
        mIntent = Intent::Assign;
        mFaces = facesDragged(context().workspace.document()->mesh().triangleFace[event.pick.triangle]);
    } else if (const int around = rectangleAround(rectangles(), view->mapCamera()->toUv(mStart))) {
        mIntent = Intent::Change;
        mGrip = {around, 0, 0};
    }
}

QList<int> RectangleTool::facesDragged(int face) const
{
    const Document &document = *context().workspace.document();
    const Islands &islands = document.islands();
    const int island = islands.islandOfFace(face);
    if (island < 0) // there are no islands before the first map
        return linkedFaces(document.mesh(), {face});
    std::vector<int> dragged = islands.islandsOf(facesOf(document, document.selection()));
    if (!std::binary_search(dragged.begin(), dragged.end(), island))
        dragged = {island};
    QList<int> faces;
    for (int each : dragged) {
        const std::vector<int> &own = islands.faces(each);
        if (document.marks().flagsOf(own).locked == 0)
            faces.append(QList<int>(own.begin(), own.end()));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

void RectangleTool::move(const ToolEvent &event)
{
    if (mState == State::Idle || &event.canvas != mView)
        return;
    mEnd = event.position;
    if (mState == State::Pressed && isDrag(mEnd - mStart))
        beginDrag();
    if (mState == State::Edit)
        dragTo(event);
    else if (mState == State::Assign)
        Q_EMIT overlayChanged();
}

void RectangleTool::beginDrag()
{
    Document &document = *context().workspace.document();
    mGesture = document.undoStack().newGesture();
    if (mIntent == Intent::Assign) {
        mState = State::Assign;
        Q_EMIT hintChanged();
        return;
    }
    mState = State::Edit;
    if (mIntent == Intent::Draw)
        addRectangle();
    const LayoutRectangle *before = document.constraints().rectangle(mGrip.id);
    if (!before) {
        reset();
        return;
    }
    mBefore = *before;
    setActive(mGrip.id);
}

void RectangleTool::addRectangle()
{
    Document &document = *context().workspace.document();
    LayoutRectangle rectangle;
    rectangle.id = document.constraints().nextRectangleId();
    rectangle.name = tr("Rectangle %1").arg(rectangle.id);
    rectangle.color = islandColor(rectangle.id);
    rectangle.lower = rectangle.upper = mView->mapCamera()->toUv(mStart);
    mGrip = {rectangle.id, 1, 1};
    auto command = EditRectangles::add(document, rectangle);
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void RectangleTool::dragTo(const ToolEvent &event)
{
    Document &document = *context().workspace.document();
    const MapCamera &camera = *mView->mapCamera();
    const Vec2 step =
        snapStep(snapOf(event.modifiers, context().view.tools().snap), camera, document.packingSettings());
    LayoutRectangle start = mBefore;
    if (mIntent == Intent::Draw && step.x() > 0)
        start.lower = snappedPoint(start.lower, step);
    const LayoutRectangle after = dragged(start, mGrip, camera.toUv(mEnd) - camera.toUv(mStart), step);
    auto command = std::make_unique<EditRectangles>(
        document, mGrip.isHandle() ? EditRectangles::Edit::Resize : EditRectangles::Edit::Move,
        std::vector<LayoutRectangle>{after});
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void RectangleTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle)
        return;
    const State state = mState;
    if (state == State::Pressed) {
        reset();
        setActive(mGrip.id != 0 ? mGrip.id : rectangleAround(rectangles(), mView->mapCamera()->toUv(mStart)));
    } else if (state == State::Assign) {
        reset();
        assignAt(event.position);
    } else {
        const LayoutRectangle *made = context().workspace.document()->constraints().rectangle(mGrip.id);
        const QSizeF size = made ? screenBox(*made, *mView->mapCamera()).size() : QSizeF();
        if (mIntent == Intent::Draw && std::min(size.width(), size.height()) < 1)
            cancel(); // nothing to drag
        else
            reset();
    }
}

void RectangleTool::assignAt(const QPointF &position)
{
    Document &document = *context().workspace.document();
    const int id = rectangleAround(rectangles(), mView->mapCamera()->toUv(position));
    pushCommand(assignFaces(document, id, mFaces));
    if (id != 0)
        setActive(id);
}

void RectangleTool::doubleClick(const ToolEvent &event)
{
    auto *view = asMap(&event.canvas);
    if (event.button != Qt::LeftButton || !view)
        return;
    cancel();
    mView = view;
    const int grip = gripAt(rectangles(), mActive, *view->mapCamera(), event.position).id;
    setActive(grip != 0 ? grip : rectangleAround(rectangles(), view->mapCamera()->toUv(event.position)));
    if (mBar && mActive != 0)
        mBar->editName();
}

bool RectangleTool::wantsKey(const QKeyEvent &event) const
{
    const bool removes = event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
    return mActive != 0 && !isBusy() && removes && event.modifiers() == Qt::NoModifier;
}

bool RectangleTool::keyPress(const QKeyEvent &event, ToolCanvas &canvas)
{
    if (!wantsKey(event))
        return AbstractTool::keyPress(event, canvas);
    pushCommand(EditRectangles::remove(*context().workspace.document(), {{mActive}}));
    return true;
}

void RectangleTool::reset()
{
    mState = State::Idle;
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
}

void RectangleTool::cancel()
{
    if (mState == State::Edit)
        cancelGesture(*context().workspace.document(), mGesture);
    reset();
}

void RectangleTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mView)
        return;
    if (mActive != 0)
        drawActive(painter);
    if (mState == State::Assign)
        drawAssignment(painter);
}

void RectangleTool::drawActive(QPainter &painter) const
{
    const Document &document = *context().workspace.document();
    const LayoutRectangle &rectangle = *document.constraints().rectangle(mActive);
    const MapCamera &camera = *mView->mapCamera();
    const QRectF box = screenBox(rectangle, camera);
    const QColor color = QColor::fromRgb(rectangle.color);
    if (!context().shownMap.isLive()) {
        QColor line = color;
        line.setAlphaF(0.6f);
        painter.setPen(QPen(line, 1.2, Qt::DotLine));
        for (int island : document.islands().islandsOf(rectangle.faces)) {
            const QPointF centre = camera.toScreen(document.islands().box(island).center());
            painter.drawLine(box.center(), centre);
            painter.drawEllipse(centre, 3, 3);
        }
    }
    painter.setPen(QPen(color, 2.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
    painter.setPen(QPen(color, 1.5));
    painter.setBrush(Qt::white);
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            if (x != 0 || y != 0)
                painter.drawRect(QRectF(handleOf(box, x, y) - QPointF(4, 4), QSizeF(8, 8)));
        }
    }
}

//! Draws a line from the island to the mouse, and the rectangle to which it would be assigned.
void RectangleTool::drawAssignment(QPainter &painter) const
{
    const MapCamera &camera = *mView->mapCamera();
    QColor color = mView->content().colors().selection;
    const int id = rectangleAround(rectangles(), camera.toUv(mEnd));
    if (const LayoutRectangle *target = context().workspace.document()->constraints().rectangle(id)) {
        color = QColor::fromRgb(target->color);
        QColor fill = color;
        fill.setAlphaF(0.25f);
        painter.setPen(QPen(color, 3));
        painter.setBrush(fill);
        painter.drawRect(screenBox(*target, camera));
    }
    painter.setPen(QPen(color, 2, Qt::DashLine));
    painter.drawLine(mStart, mEnd);
    painter.setBrush(color);
    painter.drawEllipse(mEnd, 5, 5);
}

void RectangleTool::pack(int id)
{
    const Document *document = context().workspace.document();
    const LayoutRectangle *rectangle = document ? document->constraints().rectangle(id) : nullptr;
    if (rectangle)
        context().map.packInto({rectangle->lower, rectangle->upper}, rectangle->faces);
}

} // namespace autocuts
