#include "views/tools/pintool.h"

#include "commands/setuvs.h"
#include "model/plain/uvlayout.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/tools/dragreach.h"
#include "views/tools/pinning.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <set>

namespace autocuts {

namespace {

const QColor draggedColor(0x3d8bff);

bool isLocked(const Document &document, int corner)
{
    const int face = document.adjacency().faceOfCorner(corner);
    const int island = document.islands().islandOfFace(face);
    return island >= 0 && document.marks().flagsOf(document.islands().faces(island)).locked != 0;
}

} // namespace

PinTool::PinTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("pin"), parent)
{
    // A drag is valid for one document, its active UV set and the shown map only.
    connect(&context.workspace, &Workspace::documentReplaced, this, &PinTool::reset);
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::UvSet)
            reset();
    });
    connect(&context.solver, &SolverController::stateChanged, this, [this] {
        if (mState == State::Drag)
            reset();
    });
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
}

QString PinTool::hint() const
{
    if (mMissed)
        return islandMode() ? tr("There is no island: click on one to pin it")
                            : tr("No vertex is near: click on one, or drag a box around several");
    if (islandMode())
        return tr(
            "Pin islands: click or drag a box to pin, Shift makes soft pins, Ctrl+box unpins, drag a pin "
            "to move all of its island");
    return tr(
        "Pin vertices: click or drag a box to pin, Shift makes soft pins, Ctrl+box unpins, drag a pin to "
        "move it");
}

bool PinTool::islandMode() const
{
    const Document *document = context().workspace.document();
    return document && document->selection().mode == SelectionMode::Islands;
}

void PinTool::press(const ToolEvent &event)
{
    if (event.button == Qt::RightButton && isBusy())
        cancel();
    if (event.button != Qt::LeftButton || isBusy())
        return;
    setMissed(false);
    mState = State::Pressed;
    mCanvas = &event.canvas;
    mStart = mEnd = event.position;
    mPick = event.pick;
    grab(event);
}

void PinTool::grab(const ToolEvent &event)
{
    mPins.clear();
    const Document &document = *context().workspace.document();
    if (event.canvas.kind() != ToolCanvas::Kind::Map || mPick.corner < 0)
        return;
    const UvPin *pin = document.constraints().pin(mPick.corner);
    // The pin may be at another corner in the same position.
    for (const UvPin &other : pinsOfVertex(document, event.canvas, mPick.soupCorner)) {
        if (!pin)
            pin = document.constraints().pin(other.corner);
    }
    if (!pin || isLocked(document, pin->corner))
        return;
    if (!islandMode()) {
        mPins = pinsWith(document, *pin);
        return;
    }
    const int face = document.adjacency().faceOfCorner(pin->corner);
    for (const UvPin &other : pinsOfIslands(document, context().shownMap, {face})) {
        if (const UvPin *own = document.constraints().pin(other.corner))
            mPins.push_back(*own);
    }
}

void PinTool::move(const ToolEvent &event)
{
    if (mState == State::Idle) {
        const int hovered = islandMode() ? -1 : event.pick.soupCorner;
        mCanvas = &event.canvas;
        if (std::exchange(mHovered, hovered) != hovered)
            Q_EMIT overlayChanged();
        return;
    }
    if (&event.canvas != mCanvas)
        return;
    mEnd = event.position;
    if (mState == State::Pressed && std::hypot((mEnd - mStart).x(), (mEnd - mStart).y()) >= dragDistance) {
        if (mPins.empty())
            mState = State::Box;
        else if (!context().solver.isPausing())
            beginDrag();
    }
    if (mState == State::Drag) {
        const MapCamera &camera = *event.canvas.mapCamera();
        dragTo(camera.toUv(mEnd) - camera.toUv(mStart));
    }
    if (mState == State::Box)
        Q_EMIT overlayChanged();
}

void PinTool::beginDrag()
{
    Document &document = *context().workspace.document();
    const MeshData &mesh = document.mesh();
    mState = State::Drag;
    mLive = context().solver.isRunning();
    mGesture = document.undoStack().newGesture();
    std::set<int> corners; // corners of the vertices, pinned or not
    for (const UvPin &pin : mPins) {
        corners.insert(pin.corner);
        for (int corner :
             document.adjacency().vertexCorners(mesh.vertexWeld[mesh.cornerVertex[pin.corner]])) {
            if ((document.uv().row(corner) - document.uv().row(pin.corner)).norm() < 1e-9)
                corners.insert(corner);
        }
    }
    mCorners.assign(corners.begin(), corners.end());
    mUv = document.uv()(mCorners, Eigen::all);
    mSoupUv = soupUv(mesh, document.uv());
}

//! The part of the displacement that flips no triangle.
Vec2 PinTool::wayWithoutFlips(const Vec2 &by) const
{
    const MeshData &mesh = context().workspace.document()->mesh();
    UvMatrix ways = UvMatrix::Zero(mSoupUv.rows(), 2);
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        if (std::binary_search(mCorners.begin(), mCorners.end(), mesh.cornerOfSoup(s)))
            ways.row(s) = by;
    }
    return shareWithoutFlips(mSoupUv, ways) * by;
}

void PinTool::dragTo(const Vec2 &by)
{
    Document &document = *context().workspace.document();
    mBy = mLive ? by : wayWithoutFlips(by);
    std::vector<UvPin> pins = mPins;
    for (UvPin &pin : pins)
        pin.position += mBy;
    std::unique_ptr<DocumentCommand> command;
    if (mLive) {
        command = std::make_unique<EditPins>(document, EditPins::Edit::Move, pins);
    } else {
        UvMatrix uv = document.uv();
        uv(mCorners, Eigen::all) = mUv.rowwise() + mBy.transpose();
        UvEditExtras extras;
        extras.count = static_cast<int>(mPins.size());
        extras.pins = std::move(pins);
        command = std::make_unique<SetUvs>(document, UvEdit::Drag, uv, extras);
    }
    command->setGesture(mGesture);
    pushCommand(std::move(command));
    Q_EMIT overlayChanged();
}

void PinTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle || &event.canvas != mCanvas)
        return;
    mEnd = event.position;
    const State state = mState;
    reset();
    if (state == State::Box)
        applyBox(event);
    if (state != State::Pressed)
        return;
    const std::vector<UvPin> pins = pinsUnder(event);
    setMissed(pins.empty());
    toggle(pins, event.modifiers.testFlag(Qt::ShiftModifier));
}

std::vector<UvPin> PinTool::pinsUnder(const ToolEvent &event) const
{
    const Document &document = *context().workspace.document();
    if (!islandMode())
        return mPick.soupCorner >= 0 ? pinsOfVertex(document, event.canvas, mPick.soupCorner)
                                     : std::vector<UvPin>();
    return mPick.triangle >= 0
               ? pinsOfIslands(document, context().shownMap, {document.mesh().triangleFace[mPick.triangle]})
               : std::vector<UvPin>();
}

void PinTool::toggle(const std::vector<UvPin> &pins, bool shift)
{
    Document &document = *context().workspace.document();
    std::vector<UvPin> missing, present;
    std::vector<int> corners;
    for (const UvPin &pin : pins) {
        const UvPin *own = document.constraints().pin(pin.corner);
        (own ? present : missing).push_back(own ? *own : pin);
        corners.push_back(pin.corner);
    }
    if (!missing.empty()) {
        for (UvPin &pin : missing)
            pin.hard = !shift;
        pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Pin, missing));
    } else if (shift && !present.empty()) {
        const bool anyHard =
            std::any_of(present.begin(), present.end(), [](const UvPin &p) { return p.hard; });
        for (UvPin &pin : present)
            pin.hard = !anyHard;
        pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Change, present));
    } else {
        pushCommand(EditPins::unpin(document, corners));
    }
}

void PinTool::applyBox(const ToolEvent &event)
{
    Document &document = *context().workspace.document();
    const BoxPick box = event.canvas.pickBox(QRectF(mStart, mEnd).normalized());
    const UvMatrix &uv = context().shownMap.uv();
    std::vector<UvPin> pins =
        islandMode() ? pinsOfIslands(document, context().shownMap, {box.faces.begin(), box.faces.end()})
                     : pinsAt(document.mesh(), uv, {box.corners.begin(), box.corners.end()});
    if (event.modifiers.testFlag(Qt::ControlModifier)) {
        std::vector<int> corners;
        for (const UvPin &pin : pins)
            corners.push_back(pin.corner);
        pushCommand(EditPins::unpin(document, corners));
        return;
    }
    std::erase_if(pins, [&](const UvPin &pin) { return document.constraints().pin(pin.corner) != nullptr; });
    for (UvPin &pin : pins)
        pin.hard = !event.modifiers.testFlag(Qt::ShiftModifier);
    pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Pin, pins));
}

void PinTool::reset()
{
    mState = State::Idle;
    mHovered = -1;
    Q_EMIT overlayChanged();
}

void PinTool::setMissed(bool missed)
{
    if (std::exchange(mMissed, missed) != missed)
        Q_EMIT hintChanged();
}

void PinTool::deactivate()
{
    mMissed = false;
    AbstractTool::deactivate();
}

void PinTool::cancel()
{
    if (mState == State::Drag)
        cancelGesture(*context().workspace.document(), mGesture);
    reset();
}

void PinTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mCanvas)
        return;
    const ViewColors &colors = canvas.content().colors();
    if (mState == State::Box) {
        QColor fill = colors.hardPin;
        fill.setAlphaF(0.12f);
        painter.setPen(QPen(colors.hardPin, 1, Qt::DashLine));
        painter.setBrush(fill);
        painter.drawRect(QRectF(mStart, mEnd).normalized());
    } else if (mState == State::Drag) {
        drawPins(painter, canvas);
    } else if (mHovered >= 0 && mHovered < canvas.content().uv().rows()) {
        if (const std::optional<QPointF> place = canvas.screenOf(mHovered)) {
            painter.setPen(QPen(colors.hover, 2));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(*place, 7, 7);
        }
    }
}

//! Draws pins in blue, as in the paper, with a line from their old positions.
void PinTool::drawPins(QPainter &painter, const ToolCanvas &view) const
{
    for (const UvPin &pin : mPins) {
        const QPointF from = view.mapCamera()->toScreen(pin.position),
                      to = view.mapCamera()->toScreen(pin.position + mBy);
        painter.setPen(QPen(draggedColor, 1, Qt::DashLine));
        painter.drawLine(from, to);
        painter.setPen(QPen(Qt::white, 1));
        painter.setBrush(draggedColor);
        painter.drawEllipse(to, 5.5, 5.5);
    }
}

} // namespace autocuts
