#include "views/tools/painttool.h"

#include "commands/setseamweights.h"
#include "views/gl/colormap.h"
#include "views/gl/viewcolors.h"
#include "views/tools/mirrorimages.h"

#include <QKeyEvent>

#include <cmath>

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

} // namespace

PaintTool::PaintTool(const StudioContext &context, QObject *parent)
    : WeightTool(context, QStringLiteral("paint"), Coloring::PaintWeights, parent)
{}

QString PaintTool::hint() const
{
    return tr("%1: 1-3 choose, Shift erases, Ctrl inverts; wheel with Shift size, Ctrl strength, Alt "
              "hardness; X symmetry")
        .arg(nameOf(mPaint));
}

void PaintTool::takeModifiers(Qt::KeyboardModifiers modifiers)
{
    mCurrent = mPaint;
    if (modifiers.testFlag(Qt::ShiftModifier))
        mCurrent = Paint::Erase;
    else if (modifiers.testFlag(Qt::ControlModifier) && mPaint != Paint::Erase)
        mCurrent = mPaint == Paint::KeepTogether ? Paint::AttractCuts : Paint::KeepTogether;
}

std::size_t PaintTool::beginStroke(const Document &document)
{
    mBase = document.seams().weights;
    return document.mesh().edgePairs.size();
}

std::vector<BrushTouch> PaintTool::touched(const ToolCanvas &canvas, const QPointF &middle,
                                           const PickResult &pick) const
{
    return edgesUnderBrush(canvas, middle, pick, brush().radius);
}

std::vector<int> PaintTool::mirrorImages(const MeshData &mesh) const
{
    return mirroredEdges(mesh);
}

std::unique_ptr<DocumentCommand> PaintTool::commandFor(Document &document,
                                                       const std::map<int, double> &shares) const
{
    IndexRanges pairs;
    std::vector<double> weights;
    for (const auto &[edgePair, share] : shares) {
        for (int pair : {2 * edgePair, 2 * edgePair + 1}) {
            const double from = positionOf(mBase[pair]);
            pairs.append(pair);
            weights.push_back(weightAt(from + share * (targetOf(mCurrent) - from)));
        }
    }
    return std::make_unique<SetSeamWeights>(document, pairs, weights);
}

bool PaintTool::wantsKey(const QKeyEvent &event) const
{
    return WeightTool::wantsKey(event) ||
           (event.modifiers() == Qt::NoModifier && event.key() >= Qt::Key_1 && event.key() <= Qt::Key_3);
}

bool PaintTool::keyPress(const QKeyEvent &event, ToolCanvas &canvas)
{
    if (!wantsKey(event) || event.key() == Qt::Key_X)
        return WeightTool::keyPress(event, canvas);
    setPaint(static_cast<Paint>(event.key() - Qt::Key_1));
    return true;
}

void PaintTool::setPaint(Paint paint)
{
    mPaint = paint;
    if (!isBusy())
        mCurrent = mPaint;
    tellSettings();
}

ToolOption PaintTool::effectOption()
{
    return ToolOption::choice(
        tr("Paint"), tr("What the brush does; keys 1 to 3, Shift erases, Ctrl reverses"), int(mPaint),
        {nameOf(Paint::KeepTogether), nameOf(Paint::AttractCuts), nameOf(Paint::Erase)},
        [this](double index) { setPaint(static_cast<Paint>(static_cast<int>(index))); });
}

QString PaintTool::effectText() const
{
    return nameOf(mCurrent);
}

QColor PaintTool::effectColor(const ViewColors &colors) const
{
    return mCurrent == Paint::KeepTogether  ? QColor(paintColor(strongest, colors.model.rgb()))
           : mCurrent == Paint::AttractCuts ? QColor(paintColor(0, colors.model.rgb()))
                                            : colors.text;
}

} // namespace autocuts
