#include "model/layouts/layoutstyle.h"

#include "model/document/islandcolor.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

double meanEdgePixels(const LayoutPaths &paths, int size)
{
    double sum = 0;
    for (const auto &[a, b] : paths.innerEdges)
        sum += (b - a).norm();
    return paths.innerEdges.empty() ? size : sum * size / static_cast<double>(paths.innerEdges.size());
}

} // namespace

LayoutStyle::LayoutStyle(const LayoutPaths &paths, const LayoutOptions &options)
    : seam(options.seamColor.value_or(QColor(0xDB, 0x25, 0x12))), mBackground(options.background),
      mIslandColor(options.islandColor)
{
    const double unit = options.size / 1024.0;
    const bool light = mBackground == LayoutBackground::Light;
    background = options.background == LayoutBackground::Transparent ? QColor(0, 0, 0, 0)
                 : light                                             ? QColor(0xF3, 0xF3, 0xF0)
                                                                     : QColor(0x22, 0x25, 0x2A);
    frame = light ? QColor(0xB4, 0xB4, 0xAE) : QColor(0x6A, 0x70, 0x7A);
    const double density = std::clamp(meanEdgePixels(paths, options.width()) / 14, 0.18, 1.0);
    edge = QColor(0x14, 0x1A, 0x22, static_cast<int>(std::lround(150 * density)));
    if (options.edgeColor)
        edge = *options.edgeColor;
    overlap = QColor(0xFF, 0x2F, 0xB3);
    overlapTint = QColor(0xFF, 0x2F, 0xB3, 70);
    edgeWidth = std::max(0.6, 0.75 * unit * std::sqrt(density));
    seamWidth = std::max(1.2, 1.7 * unit);
    frameWidth = std::max(1.0, std::round(unit));
    hatchSpacing = std::max(6.0, std::round(9 * unit));
    hatchWidth = std::max(1.2, 1.6 * unit);
}

QColor LayoutStyle::islandColor(int chart) const
{
    if (mIslandColor)
        return *mIslandColor;
    QColor color(autocuts::islandColor(chart));
    // Without a background, the fill is translucent so that whatever lies below the picture stays visible.
    if (mBackground == LayoutBackground::Transparent)
        color.setAlpha(120);
    return color;
}

QString layoutOptionsProblem(const LayoutOptions &options)
{
    if (options.size < 16 || options.size > 16384)
        return QStringLiteral("a layout picture of %1 pixels cannot be drawn").arg(options.size);
    if (options.bleed < 0 || options.bleed > 256)
        return QStringLiteral("islands cannot be drawn with a bleed of %1 pixels").arg(options.bleed);
    return {};
}

} // namespace autocuts
