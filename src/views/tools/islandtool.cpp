#include "views/tools/islandtool.h"

#include "model/editing/selectiontools.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/selecting/selecting.h"
#include "views/state/viewstate.h"
#include "views/tools/layoutchoices.h"
#include "views/tools/pickedelements.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace autocuts {

IslandTool::IslandTool(const StudioContext &context, const QString &id, UvEdit edit, QObject *parent)
    : AbstractTool(context, id, parent), mEdit(edit)
{
    // A transform is valid for one document and its active UV set only.
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mGoOn = false;
        finish();
    });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::UvSet)
            finish();
    });
    connect(&context.solver, &SolverController::stateChanged, this, [this] {
        if (mState == State::Active)
            finish();
    });
    // A solve that failed never pauses.
    connect(
        &context.solver, &SolverController::stateChanged, this,
        [this] {
            const SolverController &solver = this->context().solver;
            if (mState == State::Waiting && !solver.isRunning() && !solver.isPausing()) {
                mGoOn = false;
                finish();
            }
        },
        Qt::QueuedConnection);
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::overlayChanged);
    connect(&context.view, &ViewState::toolsChanged, this, &AbstractTool::overlayChanged);
}

QString IslandTool::hint() const
{
    if (mState == State::Active)
        return tr("%1   X or Y: one axis, digits: exact, Ctrl or Shift: snap, Enter: done, Escape: cancel")
            .arg(mDrag.text());
    if (mAllLocked)
        return tr("The selected islands are locked");
    switch (mEdit) {
    case UvEdit::Rotate:
        return tr("Rotate islands: drag an island or the ring, Ctrl turns by 15 degrees, with Alt by 90");
    case UvEdit::Scale:
        return tr("Scale islands: drag an island or a handle, Ctrl scales by tenths");
    default:
        return tr("Move islands: drag an island or an arrow, Shift snaps to other islands, Ctrl to the grid, "
                  "Ctrl+Shift to texels, Ctrl+Alt to tiles");
    }
}

std::vector<ToolOption> IslandTool::options()
{
    if (mEdit == UvEdit::Move)
        return {snapChoice(context().view)};
    return {pivotChoice(context().view), snapChoice(context().view)};
}

void IslandTool::deactivate()
{
    cancel();
    mAllLocked = false;
    mHovered.reset();
}

void IslandTool::chosen(ToolCanvas &canvas, const QPointF &position)
{
    auto *view = asMap(&canvas);
    if (!view || isBusy() || selectedIslands().empty())
        return;
    mByKey = true;
    begin(*view, position, DragAxis::Both);
}

void IslandTool::press(const ToolEvent &event)
{
    if (event.button == Qt::RightButton && isBusy()) {
        cancel();
        return;
    }
    if (event.button != Qt::LeftButton)
        return;
    if (isBusy()) {
        if (mByKey && mState == State::Waiting)
            mConfirmed = true;
        else if (mByKey)
            finish();
        return;
    }
    mAllLocked = false;
    mByKey = mConfirmed = false;
    mHovered = partAt(event);
    mStart = event.position;
    mView = asMap(&event.canvas);
    mState = State::Pressed;
    mSelectOnRelease = false;
    if (!mHovered)
        select(event, true);
}

//! A press on an unselected island selects it, so that it can be dragged at once. Other selecting clicks act
//! on release.
void IslandTool::select(const ToolEvent &event, bool pressed)
{
    Document &document = *context().workspace.document();
    const QList<int> face = event.pick.triangle >= 0
                                ? QList<int>{document.mesh().triangleFace[event.pick.triangle]}
                                : QList<int>();
    const bool add = event.modifiers.testFlag(Qt::ShiftModifier);
    const bool isNew = !face.isEmpty() && !isSelected(face.front());
    if (pressed && !isNew) {
        mSelectOnRelease = true;
        return;
    }
    const Selection &current = document.selection();
    const Selection picked = selectionOf(document, facesOfIslands(document.islands(), face), current.mode);
    if (add && picked.isEmpty())
        return;
    document.setSelection(combined(current, picked, add ? Combine::Toggle : Combine::Replace));
}

void IslandTool::move(const ToolEvent &event)
{
    if (mState == State::Idle) {
        const std::optional<DragAxis> part = partAt(event);
        if (part != mHovered) {
            mHovered = part;
            Q_EMIT overlayChanged();
        }
        return;
    }
    if (&event.canvas != mView)
        return;
    const QPointF moved = event.position - mStart;
    if (mState == State::Pressed) {
        if (std::hypot(moved.x(), moved.y()) < dragDistance)
            return;
        begin(*mView, mStart, mHovered.value_or(DragAxis::Both));
    }
    if (mConfirmed || mState == State::Idle)
        return;
    const MapCamera &camera = *mView->mapCamera();
    mDrag.current = camera.toUv(event.position);
    mDrag.snap = snapOf(event.modifiers, context().view.tools().snap);
    mDrag.snapStep = snapStep(mDrag.snap, camera, context().workspace.document()->packingSettings());
    snapToIslands();
    if (mState == State::Active)
        apply();
}

void IslandTool::snapToIslands()
{
    mSnapped = {};
    mDrag.islandShift = Vec2::Zero();
    if (mState != State::Active || mEdit != UvEdit::Move || mDrag.snap != SnapTo::Islands)
        return;
    if (!mSnap) {
        mSnap = std::make_unique<IslandSnap>(*context().workspace.document(), mMoved.islands, mDrag.box);
    }
    mSnapped = mSnap->snapped(mDrag.mouseMove(), pickRadius * mDrag.pixel);
    mDrag.islandShift = mSnapped.move - mDrag.mouseMove();
}

void IslandTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mByKey)
        return;
    switch (mState) {
    case State::Idle:
        break;
    case State::Pressed:
        finish();
        if (mSelectOnRelease)
            select(event, false);
        break;
    case State::Waiting:
        mConfirmed = true;
        break;
    case State::Active:
        finish();
        break;
    }
}

void IslandTool::begin(ToolCanvas &view, const QPointF &position, DragAxis axis)
{
    mView = &view;
    mConfirmed = false;
    mState = State::Waiting;
    mGoOn = context().solver.isRunning();
    const MapCamera &camera = *view.mapCamera();
    mDrag = {};
    mDrag.edit = mEdit;
    mDrag.start = mDrag.current = camera.toUv(position);
    mDrag.axis = axis;
    mDrag.pixel = 1 / camera.scale();
    const LengthUnit unit = context().view.tools().unit;
    mDrag.unit = unitsPerLength(unit, context().workspace.document()->packingSettings());
    mDrag.inTexels = unit == LengthUnit::Texels;
    const int gesture = ++mGesture;
    context().solver.whenPaused([self = QPointer(this), gesture] {
        if (self && self->mState == State::Waiting && self->mGesture == gesture)
            self->start();
    });
}

void IslandTool::start()
{
    Document &document = *context().workspace.document();
    auto transform = std::make_unique<IslandTransform>(document, mEdit, selectedIslands());
    if (!transform->canMove()) {
        mAllLocked = !selectedIslands().empty();
        finish();
        return;
    }
    mAllLocked = false;
    mMoved = movable();
    mDrag.box = mMoved.box;
    mDrag.pivot = mMoved.pivot;
    mTransform = std::move(transform);
    mState = State::Active;
    apply();
    if (mConfirmed)
        finish();
}

void IslandTool::apply()
{
    pushCommand(mTransform->command([this](int island) { return mDrag.transform(mMoved.pivotOf(island)); }));
    Q_EMIT overlayChanged();
    Q_EMIT hintChanged();
}

void IslandTool::finish()
{
    mTransform.reset();
    mSnap.reset();
    mSnapped = {};
    mState = State::Idle;
    if (std::exchange(mGoOn, false))
        context().solver.run();
    Q_EMIT overlayChanged();
    Q_EMIT hintChanged();
}

void IslandTool::cancel()
{
    if (mState == State::Active)
        cancelGesture(*context().workspace.document(), mTransform->gesture());
    finish();
}

//! Shortcuts would change what the gesture works on.
bool IslandTool::wantsKey(const QKeyEvent &event) const
{
    return (mState == State::Waiting || mState == State::Active) &&
           !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

bool IslandTool::keyPress(const QKeyEvent &event, ToolCanvas &canvas)
{
    if (AbstractTool::keyPress(event, canvas))
        return true;
    if (!wantsKey(event))
        return false;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        if (mState == State::Active)
            finish();
        mConfirmed = true;
    } else if (mDrag.takeKey(event) && mState == State::Active) {
        apply();
    }
    return true;
}

bool IslandTool::isSelected(int face) const
{
    const std::vector<int> islands = selectedIslands();
    return std::binary_search(islands.begin(), islands.end(),
                              context().workspace.document()->islands().islandOfFace(face));
}

std::vector<int> IslandTool::selectedIslands() const
{
    const Document &document = *context().workspace.document();
    return document.islands().islandsOf(facesOf(document, document.selection()));
}

MovableIslands IslandTool::movable() const
{
    return movableIslands(*context().workspace.document(), context().view.tools());
}

std::optional<Vec2> IslandTool::gizmoPlace() const
{
    const MovableIslands moved = movable();
    if (moved.isEmpty())
        return std::nullopt;
    return mEdit == UvEdit::Move ? Vec2(moved.box.center()) : moved.pivot;
}

std::optional<DragAxis> IslandTool::partAt(const ToolEvent &event) const
{
    const auto *view = asMap(&event.canvas);
    if (!view || context().shownMap.isLive())
        return std::nullopt;
    const std::optional<Vec2> place = gizmoPlace();
    if (!place)
        return std::nullopt;
    return gizmoPartAt(mEdit, view->mapCamera()->toScreen(*place), event.position);
}

void IslandTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    const auto *view = asMap(&canvas);
    if (!view || context().shownMap.isLive())
        return;
    const bool active = mState == State::Active;
    if (active && view != mView)
        return;
    // What is moved takes the handles along.
    const std::optional<Vec2> place = !active ? gizmoPlace()
                                      : mEdit == UvEdit::Move
                                          ? Vec2(mDrag.transform() * Vec2(mDrag.box.center()))
                                          : mDrag.pivot;
    if (!place)
        return;
    const QPointF centre = view->mapCamera()->toScreen(*place);
    if (active) {
        drawSnapped(painter, *view);
        drawGuide(painter, *view, centre);
    }
    drawIslandGizmo(painter, mEdit, centre, active ? std::optional(mDrag.axis) : mHovered,
                    canvas.content().colors());
}

//! Draws the sides and corners of other islands to which the move has snapped.
void IslandTool::drawSnapped(QPainter &painter, const ToolCanvas &view) const
{
    const MapCamera &camera = *view.mapCamera();
    painter.setPen(QPen(view.content().colors().selection, 1));
    if (mSnapped.u) {
        const double x = camera.toScreen({*mSnapped.u, 0}).x();
        painter.drawLine(QPointF(x, 0), QPointF(x, view.height()));
    }
    if (mSnapped.v) {
        const double y = camera.toScreen({0, *mSnapped.v}).y();
        painter.drawLine(QPointF(0, y), QPointF(view.width(), y));
    }
    if (mSnapped.corner) {
        painter.setPen(QPen(view.content().colors().selection, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(camera.toScreen(*mSnapped.corner), 6, 6);
    }
}

//! Draws the axis of the gesture, and its effect so far.
void IslandTool::drawGuide(QPainter &painter, const ToolCanvas &view, const QPointF &centre) const
{
    const ViewColors &colors = view.content().colors();
    if (mDrag.axis != DragAxis::Both && mEdit != UvEdit::Rotate) {
        const bool x = mDrag.axis == DragAxis::X;
        painter.setPen(QPen(colors.axes[x ? 0 : 1], 1, Qt::DashLine));
        if (x)
            painter.drawLine(QPointF(0, centre.y()), QPointF(view.width(), centre.y()));
        else
            painter.drawLine(QPointF(centre.x(), 0), QPointF(centre.x(), view.height()));
    }
    const QString text = mDrag.text();
    const QFontMetrics metrics = painter.fontMetrics();
    QRectF panel(centre + QPointF(18, gizmoLength / 2),
                 QSizeF(metrics.horizontalAdvance(text) + 16, metrics.height() + 8));
    const QRectF room = QRectF(view.rect()).adjusted(4, 4, -4, -4);
    panel.moveLeft(
        std::clamp(panel.left(), room.left(), std::max(room.left(), room.right() - panel.width())));
    panel.moveTop(std::clamp(panel.top(), room.top(), std::max(room.top(), room.bottom() - panel.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.panel);
    painter.drawRoundedRect(panel, 4, 4);
    painter.setPen(colors.text);
    painter.drawText(panel, Qt::AlignCenter, text);
}

} // namespace autocuts
