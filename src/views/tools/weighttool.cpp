#include "views/tools/weighttool.h"

#include "commands/documentcommand.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/session/workspace.h"
#include "views/tools/tooldrawing.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace autocuts {

WeightTool::WeightTool(const StudioContext &context, const QString &id, Coloring coloring, QObject *parent)
    : AbstractTool(context, id, parent), mColoring(context.view, coloring)
{
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mGesture = 0;
        mMirror.clear();
    });
}

void WeightTool::activate()
{
    mColoring.show();
}

void WeightTool::deactivate()
{
    cancel();
    leave();
    mColoring.restore();
}

void WeightTool::showBrush(const ToolEvent &event)
{
    mCanvas = &event.canvas;
    mMouse = event.position;
    if (!isBusy())
        takeModifiers(event.modifiers);
    Q_EMIT overlayChanged();
}

void WeightTool::press(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || isBusy())
        return;
    showBrush(event);
    Document &document = *context().workspace.document();
    mGesture = document.undoStack().newGesture();
    mShares.assign(beginStroke(document), 0);
    lay(touched(event.canvas, event.position, event.pick));
}

void WeightTool::move(const ToolEvent &event)
{
    if (isBusy() && &event.canvas != mCanvas)
        return;
    if (isBusy())
        strokeTo(event);
    showBrush(event);
}

void WeightTool::strokeTo(const ToolEvent &event)
{
    std::vector<BrushTouch> touches;
    for (const QPointF &middle : dabsBetween(mMouse, event.position, mBrush.radius)) {
        const PickResult pick = middle == event.position ? event.pick : event.canvas.pick(middle);
        const std::vector<BrushTouch> dab = touched(event.canvas, middle, pick);
        touches.insert(touches.end(), dab.begin(), dab.end());
    }
    lay(touches);
}

int WeightTool::mirrored(int element)
{
    if (mMirror.empty())
        mMirror = mirrorImages(context().workspace.document()->mesh());
    return mMirror[element];
}

void WeightTool::lay(const std::vector<BrushTouch> &touches)
{
    std::map<int, double> painted;
    const auto add = [&](int element, double share) {
        if (element < 0 || share <= mShares[element])
            return;
        mShares[element] = share;
        painted[element] = share;
    };
    for (const BrushTouch &touch : touches) {
        const double share = mBrush.effectAt(touch.distance);
        add(touch.element, share);
        if (mSymmetric)
            add(mirrored(touch.element), share);
    }
    if (painted.empty())
        return;
    std::unique_ptr<DocumentCommand> command = commandFor(*context().workspace.document(), painted);
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void WeightTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || !isBusy() || &event.canvas != mCanvas)
        return;
    strokeTo(event);
    mGesture = 0;
    showBrush(event);
}

void WeightTool::leave()
{
    if (isBusy())
        return;
    mCanvas = nullptr;
    Q_EMIT overlayChanged();
}

void WeightTool::cancel()
{
    if (!isBusy())
        return;
    if (Document *document = context().workspace.document())
        cancelGesture(*document, mGesture);
    mGesture = 0;
    Q_EMIT overlayChanged();
}

bool WeightTool::wantsKey(const QKeyEvent &event) const
{
    return event.modifiers() == Qt::NoModifier && event.key() == Qt::Key_X;
}

bool WeightTool::keyPress(const QKeyEvent &event, ToolCanvas &canvas)
{
    if (!WeightTool::wantsKey(event))
        return AbstractTool::keyPress(event, canvas);
    setSymmetric(!mSymmetric);
    return true;
}

void WeightTool::setSymmetric(bool symmetric)
{
    mSymmetric = symmetric;
    tellSettings();
}

void WeightTool::tellSettings()
{
    Q_EMIT hintChanged();
    Q_EMIT overlayChanged();
}

std::vector<ToolOption> WeightTool::options()
{
    std::vector<ToolOption> options{effectOption()};
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

bool WeightTool::wheel(const QWheelEvent &event, ToolCanvas &)
{
    if (!mBrush.takeWheel(event))
        return false;
    tellSettings();
    return true;
}

void WeightTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (&canvas != mCanvas)
        return;
    drawBrush(painter, canvas, mMouse, mBrush, effectColor(canvas.content().colors()),
              0.25 * mBrush.strength);
    drawNote(painter, canvas,
             tr("%1, %2 %%3")
                 .arg(effectText())
                 .arg(std::lround(100 * mBrush.strength))
                 .arg(mSymmetric ? tr(", symmetric about X") : QString()));
}

} // namespace autocuts
