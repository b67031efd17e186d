#include "views/tools/painttool.h"

#include "commands/setseamweights.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/workspace.h"
#include "views/gl/colormap.h"
#include "views/tools/mirrorimages.h"
#include "views/tools/tooldrawing.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts {

namespace {

//! Weight of the strongest "Keep together", the same as for joined edges.
constexpr double strongest = 100;

//! Position of a weight between -1 (attract cuts), 0 (unpainted) and 1 (keep together).
double positionOf(double weight)
{
    return weight >= 1 ? std::log(weight) / std::log(strongest) : weight - 1;
}

double weightAt(double position)
{
    return position >= 0 ? std::pow(strongest, position) : 1 + position;
}

double targetOf(Paint paint)
{
    return paint == Paint::KeepTogether ? 1 : paint == Paint::AttractCuts ? -1 : 0;
}

QString nameOf(Paint paint)
{
    return paint == Paint::KeepTogether  ? PaintTool::tr("Keep together")
           : paint == Paint::AttractCuts ? PaintTool::tr("Attract cuts")
                                         : PaintTool::tr("Erase");
}

QColor colorOf(Paint paint, const ViewColors &colors)
{
    return paint == Paint::KeepTogether  ? QColor(paintColor(strongest, colors.model.rgb()))
           : paint == Paint::AttractCuts ? QColor(paintColor(0, colors.model.rgb()))
                                         : colors.text;
}

} // namespace

PaintTool::PaintTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("paint"), parent), mColoring(context.view, Coloring::PaintWeights)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mGesture = 0;
        mMirror.clear();
    });
}

QString PaintTool::hint() const
{
    return tr("%1: 1-3 choose, Shift erases, Ctrl inverts; wheel with Shift size, Ctrl strength, Alt "
              "hardness; "
              "X symmetry")
        .arg(nameOf(mPaint));
}

void PaintTool::activate()
{
    mColoring.show();
}

void PaintTool::deactivate()
{
    cancel();
    leave();
    mColoring.restore();
}

Paint PaintTool::paintFor(Qt::KeyboardModifiers modifiers) const
{
    if (modifiers.testFlag(Qt::ShiftModifier))
        return Paint::Erase;
    if (!modifiers.testFlag(Qt::ControlModifier) || mPaint == Paint::Erase)
        return mPaint;
    return mPaint == Paint::KeepTogether ? Paint::AttractCuts : Paint::KeepTogether;
}

void PaintTool::showBrush(const ToolEvent &event)
{
    mCanvas = &event.canvas;
    mMouse = event.position;
    mShown = mGesture != 0 ? mStroke : paintFor(event.modifiers);
    Q_EMIT overlayChanged();
}

void PaintTool::press(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mGesture != 0)
        return;
    Document &document = *context().workspace.document();
    mGesture = document.undoStack().newGesture();
    mStroke = paintFor(event.modifiers);
    mBase = document.seams().weights;
    mEffect.assign(document.mesh().edgePairs.size(), 0);
    showBrush(event);
    lay(edgesUnderBrush(event.canvas, event.position, event.pick, mBrush.radius));
}

void PaintTool::move(const ToolEvent &event)
{
    if (mGesture == 0) {
        showBrush(event);
    } else if (&event.canvas == mCanvas) {
        strokeTo(event);
        showBrush(event);
    }
}

void PaintTool::strokeTo(const ToolEvent &event)
{
    std::vector<BrushTouch> touches;
    for (const QPointF &middle : dabsBetween(mMouse, event.position, mBrush.radius)) {
        const PickResult pick = middle == event.position ? event.pick : event.canvas.pick(middle);
        const std::vector<BrushTouch> dab = edgesUnderBrush(event.canvas, middle, pick, mBrush.radius);
        touches.insert(touches.end(), dab.begin(), dab.end());
    }
    lay(touches);
}

int PaintTool::mirrored(int edgePair)
{
    if (mMirror.empty())
        mMirror = mirroredEdges(context().workspace.document()->mesh());
    return mMirror[edgePair];
}

void PaintTool::lay(const std::vector<BrushTouch> &touches)
{
    std::map<int, double> painted; // new paint by edge pair
    const auto add = [&](int edgePair, double effect) {
        if (edgePair < 0 || effect <= mEffect[edgePair])
            return;
        mEffect[edgePair] = effect;
        painted[edgePair] = effect;
    };
    for (const BrushTouch &touch : touches) {
        const double effect = mBrush.effectAt(touch.distance);
        add(touch.edgePair, effect);
        if (mSymmetric)
            add(mirrored(touch.edgePair), effect);
    }
    if (painted.empty())
        return;
    IndexRanges pairs;
    std::vector<double> weights;
    for (const auto &[edgePair, effect] : painted) {
        for (int pair : {2 * edgePair, 2 * edgePair + 1}) {
            const double from = positionOf(mBase[pair]);
            pairs.append(pair);
            weights.push_back(weightAt(from + effect * (targetOf(mStroke) - from)));
        }
    }
    Document &document = *context().workspace.document();
    auto command = std::make_unique<SetSeamWeights>(document, pairs, weights);
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void PaintTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mGesture == 0 || &event.canvas != mCanvas)
        return;
    strokeTo(event);
    mGesture = 0;
    showBrush(event);
}

void PaintTool::leave()
{
    if (mGesture != 0)
        return;
    mCanvas = nullptr;
    Q_EMIT overlayChanged();
}

void PaintTool::cancel()
{
    if (mGesture == 0)
        return;
    if (Document *document = context().workspace.document())
        cancelGesture(*document, mGesture);
    mGesture = 0;
    Q_EMIT overlayChanged();
}

bool PaintTool::wantsKey(const QKeyEvent &event) const
{
    return event.modifiers() == Qt::NoModifier &&
           ((event.key() >= Qt::Key_1 && event.key() <= Qt::Key_3) || event.key() == Qt::Key_X);
}

bool PaintTool::keyPress(const QKeyEvent &event, ToolCanvas &canvas)
{
    if (!wantsKey(event))
        return AbstractTool::keyPress(event, canvas);
    if (event.key() == Qt::Key_X)
        setSymmetric(!mSymmetric);
    else
        setPaint(static_cast<Paint>(event.key() - Qt::Key_1));
    return true;
}

void PaintTool::setPaint(Paint paint)
{
    mPaint = paint;
    if (mGesture == 0)
        mShown = mPaint;
    tellSettings();
}

void PaintTool::setSymmetric(bool symmetric)
{
    mSymmetric = symmetric;
    tellSettings();
}

void PaintTool::tellSettings()
{
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
}

std::vector<ToolOption> PaintTool::options()
{
    std::vector<ToolOption> options{ToolOption::choice(
        tr("Paint"), tr("What the brush does; keys 1 to 3, Shift erases, Ctrl reverses"), int(mPaint),
        {nameOf(Paint::KeepTogether), nameOf(Paint::AttractCuts), nameOf(Paint::Erase)},
        [this](double index) { setPaint(static_cast<Paint>(static_cast<int>(index))); })};
    const std::vector<ToolOption> brush = brushOptions(mBrush, [this](const Brush &changed) {
        mBrush = changed;
        tellSettings();
    });
    options.insert(options.end(), brush.begin(), brush.end());
    options.push_back(ToolOption::toggle(tr("Symmetric"),
                                         tr("Paint the mirror image, in the plane x = 0, too; X"), mSymmetric,
                                         [this](double on) { setSymmetric(on != 0); }));
    return options;
}

bool PaintTool::wheel(const QWheelEvent &event, ToolCanvas &)
{
    if (!mBrush.takeWheel(event))
        return false;
    tellSettings();
    return true;
}

void PaintTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mCanvas)
        return;
    const ViewColors &colors = canvas.content().colors();
    drawBrush(painter, canvas, mMouse, mBrush, colorOf(mShown, colors), 0.25 * mBrush.strength);
    drawNote(painter, canvas,
             tr("%1, %2 %%3")
                 .arg(nameOf(mShown))
                 .arg(std::lround(100 * mBrush.strength))
                 .arg(mSymmetric ? tr(", symmetric about X") : QString()));
}

} // namespace autocuts
