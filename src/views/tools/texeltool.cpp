#include "views/tools/texeltool.h"

#include "commands/settexelweights.h"
#include "model/plain/texelweights.h"
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

TexelTool::TexelTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("texelWeight"), parent),
      mColoring(context.view, Coloring::TexelWeights)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mGesture = 0;
        mMirror.clear();
    });
}

QString TexelTool::hint() const
{
    return tr("Texel density %1 times: Shift goes back to 1, Ctrl inverts; wheel with Shift size, Ctrl "
              "strength, "
              "Alt hardness; X symmetry")
        .arg(QString::number(mWeight, 'g', 3));
}

void TexelTool::activate()
{
    mColoring.show();
}

void TexelTool::deactivate()
{
    cancel();
    leave();
    mColoring.restore();
}

double TexelTool::weightFor(Qt::KeyboardModifiers modifiers) const
{
    if (modifiers.testFlag(Qt::ShiftModifier))
        return 1;
    return modifiers.testFlag(Qt::ControlModifier) ? 1 / mWeight : mWeight;
}

void TexelTool::showBrush(const ToolEvent &event)
{
    mCanvas = &event.canvas;
    mMouse = event.position;
    mShown = mGesture != 0 ? mStroke : weightFor(event.modifiers);
    Q_EMIT overlayChanged();
}

void TexelTool::press(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mGesture != 0)
        return;
    Document &document = *context().workspace.document();
    mGesture = document.undoStack().newGesture();
    mStroke = weightFor(event.modifiers);
    mBase = document.texelWeights();
    mEffect.assign(mBase.size(), 0);
    showBrush(event);
    lay(facesUnderBrush(event.canvas, event.position, event.pick, mBrush.radius));
}

void TexelTool::move(const ToolEvent &event)
{
    if (mGesture == 0) {
        showBrush(event);
    } else if (&event.canvas == mCanvas) {
        strokeTo(event);
        showBrush(event);
    }
}

void TexelTool::strokeTo(const ToolEvent &event)
{
    std::vector<FaceTouch> touches;
    for (const QPointF &middle : dabsBetween(mMouse, event.position, mBrush.radius)) {
        const PickResult pick = middle == event.position ? event.pick : event.canvas.pick(middle);
        const std::vector<FaceTouch> dab = facesUnderBrush(event.canvas, middle, pick, mBrush.radius);
        touches.insert(touches.end(), dab.begin(), dab.end());
    }
    lay(touches);
}

int TexelTool::mirrored(int face)
{
    if (mMirror.empty())
        mMirror = mirroredFaces(context().workspace.document()->mesh());
    return mMirror[face];
}

void TexelTool::lay(const std::vector<FaceTouch> &touches)
{
    std::map<int, double> painted; // new paint by face
    const auto add = [&](int face, double effect) {
        if (face < 0 || effect <= mEffect[face])
            return;
        mEffect[face] = effect;
        painted[face] = effect;
    };
    for (const FaceTouch &touch : touches) {
        const double effect = mBrush.effectAt(touch.distance);
        add(touch.face, effect);
        if (mSymmetric)
            add(mirrored(touch.face), effect);
    }
    if (painted.empty())
        return;
    IndexRanges faces;
    std::vector<double> weights;
    for (const auto &[face, effect] : painted) {
        const double from = std::log2(mBase[static_cast<std::size_t>(face)]);
        faces.append(face);
        weights.push_back(std::exp2(from + effect * (std::log2(mStroke) - from)));
    }
    auto command = std::make_unique<SetTexelWeights>(*context().workspace.document(), faces, weights);
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void TexelTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mGesture == 0 || &event.canvas != mCanvas)
        return;
    strokeTo(event);
    mGesture = 0;
    showBrush(event);
}

void TexelTool::leave()
{
    if (mGesture != 0)
        return;
    mCanvas = nullptr;
    Q_EMIT overlayChanged();
}

void TexelTool::cancel()
{
    if (mGesture == 0)
        return;
    if (Document *document = context().workspace.document())
        cancelGesture(*document, mGesture);
    mGesture = 0;
    Q_EMIT overlayChanged();
}

bool TexelTool::wantsKey(const QKeyEvent &event) const
{
    return event.modifiers() == Qt::NoModifier && event.key() == Qt::Key_X;
}

bool TexelTool::keyPress(const QKeyEvent &event, ToolCanvas &canvas)
{
    if (!wantsKey(event))
        return AbstractTool::keyPress(event, canvas);
    setSymmetric(!mSymmetric);
    return true;
}

void TexelTool::setSymmetric(bool symmetric)
{
    mSymmetric = symmetric;
    tellSettings();
}

void TexelTool::tellSettings()
{
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
}

std::vector<ToolOption> TexelTool::options()
{
    std::vector<ToolOption> options{ToolOption::number(
        tr("Texels"),
        tr("Texels per length, compared with unpainted faces; Shift goes back to them, Ctrl inverts"),
        std::round(100 * mWeight), std::floor(100 * minTexelWeight), 100 * maxTexelWeight, tr(" %"),
        [this](double percent) {
            mWeight = std::clamp(percent / 100, minTexelWeight, maxTexelWeight);
            mShown = mGesture != 0 ? mShown : mWeight;
            tellSettings();
        })};
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

bool TexelTool::wheel(const QWheelEvent &event, ToolCanvas &)
{
    if (!mBrush.takeWheel(event))
        return false;
    tellSettings();
    return true;
}

void TexelTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mCanvas)
        return;
    drawBrush(painter, canvas, mMouse, mBrush, QColor(texelWeightColor(mShown)), 0.25 * mBrush.strength);
    drawNote(painter, canvas,
             tr("%1 times the texels, %2 %%3")
                 .arg(QString::number(mShown, 'g', 3))
                 .arg(std::lround(100 * mBrush.strength))
                 .arg(mSymmetric ? tr(", symmetric about X") : QString()));
}

} // namespace autocuts
