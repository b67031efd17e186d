#include "views/tools/dragtool.h"

#include "commands/editmapseams.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/editing/tearing.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/tools/draghandles.h"
#include "views/tools/pickedelements.h"

#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <set>

namespace autocuts {

namespace {

constexpr double minRadius = 10, maxRadius = 2000;
//! Pixels: a dragged corner snaps to its partner within this distance, or within half of the gap when that is
//! less. Chosen by hand.
constexpr double snapDistance = 12;
//! Pixels: a drag of a live map that ends this close to its beginning counts as taken back. Chosen by hand.
constexpr double backDistance = 8;
//! Number of solver results in which joined gaps have to close; then the pulls are removed anyway. Chosen by
//! hand; its effect has not been measured.
constexpr int shuttingResults = 60;
const QColor dragColor(0x3d8bff), snapColor(0x2fbf71), strainColor(0xff8a1f);

} // namespace

DragTool::DragTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("drag"), parent)
{
    // A drag is valid for one document, its active UV set and the shown map only.
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mShutting.clear();
        reset();
    });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::UvSet)
            reset();
    });
    connect(&context.solver, &SolverController::stateChanged, this, [this] {
        if (mState == State::Drag)
            reset();
        mShutting.clear();
        Q_EMIT hintChanged();
    });
    connect(&context.solver, &SolverController::statusChanged, this, &DragTool::letGoWhenShut);
    connect(&context.solver, &SolverController::statusChanged, this, &DragTool::tearLive);
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
}

QString DragTool::hint() const
{
    const Document *document = context().workspace.document();
    const SelectionMode mode = document ? document->selection().mode : SelectionMode::Faces;
    const QString what = mode == SelectionMode::Vertices ? tr("vertices")
                         : mode == SelectionMode::Edges  ? tr("edges")
                         : mode == SelectionMode::Faces  ? tr("faces")
                                                         : tr("islands");
    if (mState == State::Drag && !mTorn.empty())
        return tr("Torn off: what was in the circle moves alone; Escape: cancel");
    if (mState == State::Drag && mStrained)
        return tr("Pull further: what is in the circle tears off; Shift+wheel: circle, Escape: cancel");
    return context().solver.isRunning()
               ? tr("Drag %1 in the UV view: the map follows, tears and joins; Shift+wheel: circle, Escape: "
                    "cancel")
                     .arg(what)
               : tr("Drag %1 in the UV view: what is in the circle follows; Shift+wheel: circle, Escape: "
                    "cancel")
                     .arg(what);
}

//! Islands, and what is torn off, are moved as a whole, without the circle.
bool DragTool::reachesAround() const
{
    if (!mTorn.empty())
        return false;
    const Document *document = context().workspace.document();
    return document && document->selection().mode != SelectionMode::Islands;
}

void DragTool::press(const ToolEvent &event)
{
    if (event.button == Qt::RightButton && isBusy())
        cancel();
    auto *view = asMap(&event.canvas);
    if (event.button != Qt::LeftButton || isBusy() || !view)
        return;
    mState = State::Pressed;
    mView = view;
    mStart = mMouse = event.position;
    mPick = event.pick;
}

void DragTool::move(const ToolEvent &event)
{
    if (mState == State::Idle) {
        mView = asMap(&event.canvas);
        mMouse = event.position;
        Q_EMIT overlayChanged();
        return;
    }
    if (&event.canvas != mView)
        return;
    mMouse = event.position;
    if (mState == State::Pressed && std::hypot((mMouse - mStart).x(), (mMouse - mStart).y()) >= dragDistance)
        begin();
    if (mState == State::Drag)
        apply();
}

void DragTool::begin()
{
    Document &document = *context().workspace.document();
    mHandles = dragHandles(document, *mView, context().shownMap, mPick);
    if (mHandles.empty() || context().solver.isPausing()) {
        reset();
        return;
    }
    mLive = context().solver.isRunning();
    mUv = context().shownMap.uv();
    mCornerUv = document.uv();
    mSeparation = context().shownMap.separation();
    mGesture = document.undoStack().newGesture();
    mWay.setZero();
    mShutting.clear(); // replaced by the new pulls
    mState = State::Drag;
    updateReach();
    findGaps();
}

void DragTool::updateReach()
{
    const Document &document = *context().workspace.document();
    const MeshData &mesh = document.mesh();
    const double radius = reachesAround() ? mRadius / mView->mapCamera()->scale() : 0;
    mReach = dragReach(mesh, mUv, mSeparation, mHandles, radius);
    if (mLive)
        return;
    const Islands &islands = document.islands();
    std::vector<bool> locked(islands.count());
    for (int island = 0; island < islands.count(); ++island)
        locked[island] = document.marks().flagsOf(islands.faces(island)).locked != 0;
    for (int corner : mReach.corners) {
        const int island = islands.islandOfFace(mesh.triangleFace[corner / 3]);
        const bool pinned =
            mReach.weight[corner] < 1 && document.constraints().pin(mesh.cornerOfSoup(corner));
        if (pinned || (island >= 0 && locked[island]))
            mReach.weight[corner] = 0;
    }
}

void DragTool::findGaps()
{
    const MeshData &mesh = context().workspace.document()->mesh();
    const double scale = mView->mapCamera()->scale();
    mGaps.clear();
    mClosed.clear();
    for (int pair = 0; pair < mesh.cornerPairCount(); ++pair) {
        const EdgePair &edge = mesh.edgePairs[pair / 2];
        if (edge.diagonal || mSeparation[pair] < 0.5f)
            continue;
        for (int side : {0, 1}) {
            const int corner = edge.corner[pair % 2][side], partner = edge.corner[pair % 2][1 - side];
            const double width = scale * (mUv.row(corner) - mUv.row(partner)).norm();
            if (mReach.weight[corner] == 1 && mReach.weight[partner] < 1 && std::isfinite(width))
                mGaps.push_back({pair, corner, partner, width});
        }
    }
}

void DragTool::apply()
{
    const MapCamera &camera = *mView->mapCamera();
    Vec2 way = camera.toUv(mMouse) - camera.toUv(mStart);
    mClosed = snap(way);
    mWay = way;
    if (mLive)
        pull(way);
    else
        moveCorners(way);
    Q_EMIT overlayChanged();
}

//! The partner may be inside the circle as well, and then follows to some extent.
Vec2 DragTool::wayThatCloses(const Gap &gap) const
{
    if (mLive)
        return context().shownMap.uv().row(gap.partner) - mUv.row(gap.corner);
    return (mUv.row(gap.partner) - mUv.row(gap.corner)) / (1 - mReach.weight[gap.partner]);
}

std::vector<DragTool::Gap> DragTool::snap(Vec2 &way) const
{
    const double scale = mView->mapCamera()->scale();
    const auto isNear = [&](const Gap &gap) {
        const double left = scale * (wayThatCloses(gap) - way).norm() * (1 - mReach.weight[gap.partner]);
        return left < std::min(snapDistance, 0.5 * gap.width);
    };
    const Gap *nearest = nullptr;
    for (const Gap &gap : mGaps) {
        if (isNear(gap) &&
            (!nearest || (wayThatCloses(gap) - way).norm() < (wayThatCloses(*nearest) - way).norm()))
            nearest = &gap;
    }
    std::vector<Gap> closed;
    if (!nearest)
        return closed;
    way = wayThatCloses(*nearest);
    std::copy_if(mGaps.begin(), mGaps.end(), std::back_inserter(closed), isNear);
    return closed;
}

//! Corrects the displacements so that the corners of closed gaps end exactly at their partners.
void DragTool::closeGaps(UvMatrix &ways) const
{
    const MeshData &mesh = context().workspace.document()->mesh();
    for (const Gap &gap : mClosed) {
        const Eigen::RowVector2d end = mUv.row(gap.partner) + ways.row(gap.partner);
        const double tolerance = 1e-9 * (1 + end.cwiseAbs().maxCoeff());
        for (int handle : mHandles) {
            if (mesh.vertexOfSoup(handle) == mesh.vertexOfSoup(gap.corner) &&
                (mUv.row(handle) - mUv.row(gap.corner)).cwiseAbs().maxCoeff() <= tolerance)
                ways.row(handle) = end - mUv.row(handle);
        }
    }
}

void DragTool::moveCorners(const Vec2 &way)
{
    Document &document = *context().workspace.document();
    const MeshData &mesh = document.mesh();
    UvMatrix ways = UvMatrix::Zero(mUv.rows(), 2);
    for (int corner : mReach.corners)
        ways.row(corner) = mReach.weight[corner] * way.transpose();
    closeGaps(ways);
    const double share = shareWithoutFlips(mUv, ways);
    if (share < 1)
        mClosed.clear();
    if (tearsAt(strainOf(mUv, mUv + share * ways, mReach.corners),
                (1 - share) * way.norm() * mView->mapCamera()->scale()) &&
        tear())
        return moveCorners(way);
    mWay = share * way;
    UvMatrix uv = mCornerUv;
    UvEditExtras extras;
    std::set<int> vertices;
    for (int handle : mHandles)
        vertices.insert(mesh.vertexOfSoup(handle));
    extras.count = static_cast<int>(vertices.size());
    std::vector<bool> moved(mesh.cornerCount());
    for (int soup : mReach.corners) {
        const int corner = mesh.cornerOfSoup(soup);
        if (mReach.weight[soup] == 0 || moved[corner])
            continue;
        moved[corner] = true;
        uv.row(corner) += share * ways.row(soup);
        const UvPin *pin = document.constraints().pin(corner);
        if (pin) {
            extras.pins.push_back(*pin);
            extras.pins.back().position = uv.row(corner);
        }
    }
    pushUvs(uv, extras);
}

void DragTool::pushUvs(const UvMatrix &uv, const UvEditExtras &extras)
{
    Document &document = *context().workspace.document();
    std::unique_ptr<DocumentCommand> command;
    if (mTorn.empty())
        command = std::make_unique<SetUvs>(document, UvEdit::Drag, uv, extras);
    else
        command = EditMapSeams::make(document, EditMapSeams::Edit::Tear, uv, mTorn);
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void DragTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle || &event.canvas != mView)
        return;
    mMouse = event.position;
    if (mState == State::Pressed) {
        select(event);
    } else if ((mLive || !mTorn.empty()) && mClosed.empty() &&
               std::hypot((mMouse - mStart).x(), (mMouse - mStart).y()) < backDistance) {
        cancel(); // the map returns, too: nothing was meant to tear
        return;
    } else {
        apply();
        if (mLive) {
            keepSeams();
            mPatience = shuttingResults;
            if (mShutting.empty())
                letGo();
        }
    }
    reset();
}

void DragTool::select(const ToolEvent &event)
{
    Document &document = *context().workspace.document();
    const Selection picked = pickedElements(document, event.canvas, mPick);
    const bool add = event.modifiers.testFlag(Qt::ShiftModifier);
    if (add && picked.isEmpty())
        return;
    document.setSelection(combined(document.selection(), picked, add ? Combine::Toggle : Combine::Replace));
}

void DragTool::leave()
{
    if (isBusy())
        return;
    mView = nullptr;
    Q_EMIT overlayChanged();
}

bool DragTool::wheel(const QWheelEvent &event, ToolCanvas &)
{
    if (event.modifiers() != Qt::ShiftModifier)
        return false;
    // Some platforms report horizontal scrolling while Shift is held.
    const QPoint angle = event.angleDelta();
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    setRadius(mRadius * std::pow(1.15, notches));
    return true;
}

void DragTool::setRadius(double radius)
{
    mRadius = std::clamp(radius, minRadius, maxRadius);
    if (mState == State::Drag) {
        updateReach();
        findGaps();
        apply();
    }
    Q_EMIT overlayChanged();
}

std::vector<ToolOption> DragTool::options()
{
    return {ToolOption::number(tr("Circle"), tr("Radius of what follows the drag; Shift+wheel"), mRadius,
                               minRadius, maxRadius, tr(" px"),
                               [this](double radius) { setRadius(radius); })};
}

void DragTool::reset()
{
    mState = State::Idle;
    mHandles.clear();
    mReach = {};
    mGaps.clear();
    mClosed.clear();
    mTorn.clear();
    mStrained = false;
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
}

void DragTool::cancel()
{
    if (mState == State::Drag && (!mLive || !mTorn.empty()))
        cancelGesture(*context().workspace.document(), mGesture);
    if (mState == State::Drag && mLive)
        context().solver.cancelPulls();
    reset();
}

void DragTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mView)
        return;
    const ViewColors &colors = canvas.content().colors();
    painter.setBrush(Qt::NoBrush);
    if (reachesAround()) {
        const QPointF middle = mState == State::Drag ? mStart : mMouse;
        painter.setPen(QPen(colors.dark ? Qt::black : Qt::white, 3)); // visible on any background
        painter.drawEllipse(middle, mRadius, mRadius);
        painter.setPen(QPen(dragColor, 1.2, mState == State::Drag ? Qt::DashLine : Qt::SolidLine));
        painter.drawEllipse(middle, mRadius, mRadius);
    }
    if (mState == State::Drag)
        drawDrag(painter, *mView);
}

//! Draws the displacement of the dragged corners, and rings around the corners that snapped.
void DragTool::drawDrag(QPainter &painter, const ToolCanvas &view) const
{
    const double scale = view.mapCamera()->scale();
    const QPointF end = mStart + QPointF(scale * mWay.x(), -scale * mWay.y());
    const QColor color = mStrained ? strainColor : dragColor;
    painter.setPen(QPen(color, mStrained ? 2.5 : 1.2, Qt::DashLine));
    painter.drawLine(mStart, mStrained ? mMouse : end);
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(color);
    painter.drawEllipse(end, 5, 5);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(snapColor, 2.5));
    for (const Gap &gap : mClosed)
        painter.drawEllipse(view.mapCamera()->toScreen(mUv.row(gap.corner).transpose() + mWay), 9, 9);
}

} // namespace autocuts
