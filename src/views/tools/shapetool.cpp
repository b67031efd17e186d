#include "views/tools/shapetool.h"

#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/editing/brushstroke.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/tools/tooldrawing.h"

#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! Share of the way to the centre that a dab of the pinch at full strength goes. Chosen by hand.
constexpr double pinchPerDab = 0.2;
//! Milliseconds between two dabs of a brush that is held still. Chosen by hand.
constexpr int stillInterval = 80;

UvEdit editOf(ShapeBrush kind)
{
    return kind == ShapeBrush::Grab    ? UvEdit::BrushGrab
           : kind == ShapeBrush::Pinch ? UvEdit::BrushPinch
                                       : UvEdit::BrushRelax;
}

QString nameOf(ShapeBrush kind)
{
    return kind == ShapeBrush::Grab    ? ShapeTool::tr("Grab")
           : kind == ShapeBrush::Pinch ? ShapeTool::tr("Pinch")
                                       : ShapeTool::tr("Relax");
}

} // namespace

ShapeTool::ShapeTool(const StudioContext &context, const QString &id, ShapeBrush kind, QObject *parent)
    : AbstractTool(context, id, parent), mKind(kind)
{
    if (kind == ShapeBrush::Grab)
        mBrush.strength = 1; // what is in the middle follows the mouse
    mStill.setInterval(stillInterval);
    connect(&mStill, &QTimer::timeout, this, &ShapeTool::workOn);
    // A stroke is valid for one document and its active UV set, and while nothing else changes the map.
    connect(&context.workspace, &Workspace::documentReplaced, this, &ShapeTool::finish);
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::UvSet || (event.type == ChangeEvent::Type::Uv && !mPushing))
            finish();
    });
    connect(&context.solver, &SolverController::stateChanged, this, [this] {
        if (mState == State::Active)
            finish();
    });
}

ShapeTool::~ShapeTool() = default;

QString ShapeTool::hint() const
{
    if (mLocked)
        return tr("This island is locked");
    const QString what = mKind == ShapeBrush::Relax ? tr("Relax: stroke over what is distorted")
                         : mKind == ShapeBrush::Pinch
                             ? tr("Pinch: stroke to draw the map together, Ctrl apart, Shift relaxes")
                             : tr("Grab: drag what is under the brush, Shift relaxes");
    return tr("%1; wheel with Shift size, Ctrl strength, Alt hardness").arg(what);
}

void ShapeTool::deactivate()
{
    cancel();
    mLocked = false;
    leave();
}

void ShapeTool::press(const ToolEvent &event)
{
    if (event.button == Qt::RightButton && isBusy()) {
        cancel();
        return;
    }
    if (event.button != Qt::LeftButton || isBusy())
        return;
    mLocked = false;
    mCanvas = &event.canvas;
    mStart = mMouse = event.position;
    mStroke = event.modifiers.testFlag(Qt::ShiftModifier) ? ShapeBrush::Relax : mKind;
    mApart = event.modifiers.testFlag(Qt::ControlModifier);
    mState = State::Waiting;
    const int number = ++mNumber;
    context().solver.whenPaused([self = QPointer(this), number] {
        if (self && self->mState == State::Waiting && self->mNumber == number)
            self->start();
    });
    Q_EMIT overlayChanged();
}

void ShapeTool::start()
{
    mState = State::Idle;
    Document &document = *context().workspace.document();
    if (!mCanvas || !(document.mesh().area > 0))
        return;
    const auto spot = mapSpotUnder(*mCanvas, mStart, mCanvas->pick(mStart), mBrush.radius);
    if (!spot)
        return;
    const int island = document.islands().islandOfFace(document.mesh().triangleFace[spot->triangle]);
    mLocked = island >= 0 && document.marks().flagsOf(document.islands().faces(island)).locked != 0;
    Q_EMIT hintChanged();
    if (mLocked)
        return;
    mWork = std::make_unique<BrushStroke>(document, editOf(mStroke));
    mState = State::Active;
    mGrabbed = *spot;
    if (dab(*spot))
        push();
    if (mMouse != mStart)
        strokeTo(mMouse, mCanvas->pick(mMouse));
    if (mStroke != ShapeBrush::Grab && mState == State::Active)
        mStill.start();
}

void ShapeTool::workOn()
{
    if (mState != State::Active || !mCanvas)
        return;
    const auto spot = mapSpotUnder(*mCanvas, mMouse, mCanvas->pick(mMouse), mBrush.radius);
    if (spot && dab(*spot))
        push();
}

void ShapeTool::move(const ToolEvent &event)
{
    if (mState != State::Idle && &event.canvas != mCanvas)
        return;
    if (mState == State::Active)
        strokeTo(event.position, event.pick);
    mCanvas = &event.canvas;
    mMouse = event.position;
    Q_EMIT overlayChanged();
}

void ShapeTool::strokeTo(const QPointF &place, const PickResult &pick)
{
    bool changed = false;
    if (mStroke == ShapeBrush::Grab) {
        const QPointF way = place - mStart;
        changed = mWork->brush().pull(mGrabbed.toUv * Vec2(way.x(), way.y()));
    } else {
        // Dabs are added between mouse events so that fast strokes have no gaps; chosen by hand.
        constexpr int mostDabs = 4;
        const QPointF way = place - mMouse;
        const int dabs = std::clamp(
            static_cast<int>(std::ceil(std::hypot(way.x(), way.y()) / (0.3 * mBrush.radius))), 1, mostDabs);
        for (int i = 1; i <= dabs; ++i) {
            const QPointF middle = mMouse + way * i / dabs;
            const PickResult under = i == dabs ? pick : mCanvas->pick(middle);
            if (const auto spot = mapSpotUnder(*mCanvas, middle, under, mBrush.radius))
                changed = dab(*spot) || changed;
        }
        mStill.start(); // the time counts from the last dab
    }
    if (changed)
        push();
}

bool ShapeTool::dab(const MapSpot &spot)
{
    const double units = spot.unitsPerPixel();
    const definite::BrushSpot place{
        spot.triangle, spot.uv, units * mBrush.radius,
        [brush = mBrush, units](double distance) { return brush.effectAt(distance / units); }};
    switch (mStroke) {
    case ShapeBrush::Relax:
        return mWork->brush().relax(place);
    case ShapeBrush::Pinch:
        return mWork->brush().pinch(place, mApart ? -pinchPerDab : pinchPerDab);
    case ShapeBrush::Grab:
        mWork->brush().grab(place);
    }
    return false;
}

void ShapeTool::push()
{
    mPushing = true;
    pushCommand(mWork->command());
    mPushing = false;
}

void ShapeTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || !isBusy() || &event.canvas != mCanvas)
        return;
    move(event);
    if (mState == State::Active)
        finish();
    else
        mState = State::Idle; // the solver was still at work
}

void ShapeTool::finish()
{
    mStill.stop();
    mWork.reset();
    mState = State::Idle;
    Q_EMIT overlayChanged();
    Q_EMIT hintChanged();
}

void ShapeTool::leave()
{
    if (isBusy())
        return;
    mCanvas = nullptr;
    Q_EMIT overlayChanged();
}

void ShapeTool::cancel()
{
    if (mState == State::Active && context().workspace.document())
        cancelGesture(*context().workspace.document(), mWork->gesture());
    finish();
}

std::vector<ToolOption> ShapeTool::options()
{
    return brushOptions(mBrush, [this](const Brush &changed) {
        mBrush = changed;
        Q_EMIT hintChanged();
        Q_EMIT overlayChanged();
    });
}

bool ShapeTool::wheel(const QWheelEvent &event, ToolCanvas &)
{
    if (!mBrush.takeWheel(event))
        return false;
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
    return true;
}

void ShapeTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mCanvas)
        return;
    // Its inside stays clear: that is what one looks at.
    drawBrush(painter, canvas, mMouse, mBrush, canvas.content().colors().selection, 0);
    drawNote(painter, canvas,
             tr("%1, %2 %").arg(nameOf(isBusy() ? mStroke : mKind)).arg(std::lround(100 * mBrush.strength)));
}

} // namespace autocuts
