#include "views/tools/texeltool.h"

#include "commands/settexelweights.h"
#include "model/plain/texelweights.h"
#include "views/gl/colormap.h"
#include "views/tools/mirrorimages.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

TexelTool::TexelTool(const StudioContext &context, QObject *parent)
    : WeightTool(context, QStringLiteral("texelWeight"), Coloring::TexelWeights, parent)
{}

QString TexelTool::hint() const
{
    return tr("Texel density %1 times: Shift goes back to 1, Ctrl inverts; wheel with Shift size, Ctrl "
              "strength, Alt hardness; X symmetry")
        .arg(QString::number(mWeight, 'g', 3));
}

void TexelTool::takeModifiers(Qt::KeyboardModifiers modifiers)
{
    mCurrent = modifiers.testFlag(Qt::ShiftModifier)     ? 1
               : modifiers.testFlag(Qt::ControlModifier) ? 1 / mWeight
                                                         : mWeight;
}

std::size_t TexelTool::beginStroke(const Document &document)
{
    mBase = document.texelWeights();
    return mBase.size();
}

std::vector<BrushTouch> TexelTool::touched(const ToolCanvas &canvas, const QPointF &middle,
                                           const PickResult &pick) const
{
    return facesUnderBrush(canvas, middle, pick, brush().radius);
}

std::vector<int> TexelTool::mirrorImages(const MeshData &mesh) const
{
    return mirroredFaces(mesh);
}

std::unique_ptr<DocumentCommand> TexelTool::commandFor(Document &document,
                                                       const std::map<int, double> &shares) const
{
    IndexRanges faces;
    std::vector<double> weights;
    for (const auto &[face, share] : shares) {
        const double from = std::log2(mBase[static_cast<std::size_t>(face)]);
        faces.append(face);
        weights.push_back(std::exp2(from + share * (std::log2(mCurrent) - from)));
    }
    return std::make_unique<SetTexelWeights>(document, faces, weights);
}

ToolOption TexelTool::effectOption()
{
    return ToolOption::number(
        tr("Texels"),
        tr("Texels per length, compared with unpainted faces; Shift goes back to them, Ctrl inverts"),
        std::round(100 * mWeight), std::floor(100 * minTexelWeight), 100 * maxTexelWeight, tr(" %"),
        [this](double percent) {
            mWeight = std::clamp(percent / 100, minTexelWeight, maxTexelWeight);
            if (!isBusy())
                mCurrent = mWeight;
            tellSettings();
        });
}

QString TexelTool::effectText() const
{
    return tr("%1 times the texels").arg(QString::number(mCurrent, 'g', 3));
}

QColor TexelTool::effectColor(const ViewColors &) const
{
    return QColor(texelWeightColor(mCurrent));
}

} // namespace autocuts
