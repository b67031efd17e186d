#include "views/canvas/mapgrid.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

constexpr double minStepPixels = 48;

} // namespace

MapGrid MapGrid::of(const MapCamera &camera, int textureSize)
{
    const double wanted = minStepPixels / camera.scale();
    MapGrid grid;
    if (wanted > 1) { // whole tiles: 2, 5, 10, 20, ...
        const double decade = std::pow(10, std::floor(std::log10(wanted)));
        grid.step = decade * (wanted <= decade       ? 1
                              : wanted <= 2 * decade ? 2
                              : wanted <= 5 * decade ? 5
                                                     : 10);
        grid.divisions = 1;
        return grid;
    }
    // The texture is halved repeatedly, down to texels.
    const double finest = 1.0 / textureSize;
    grid.step = std::max(std::exp2(std::ceil(std::log2(wanted))), finest);
    const double pixels = grid.step * camera.scale();
    grid.divisions = 4;
    while (grid.divisions > 1 && grid.step / grid.divisions < 0.999 * finest)
        grid.divisions /= 2;
    grid.strength = std::clamp((pixels - minStepPixels) / minStepPixels * 0.6 + 0.4, 0.0, 1.0);
    return grid;
}

Vec2 usedTiles(const Eigen::AlignedBox2d &uvBox, double tileHeight)
{
    constexpr double columns = 10, rows = (PackingSettings::lastTile - PackingSettings::firstTile) / 10;
    if (uvBox.isEmpty())
        return Vec2::Ones();
    const Vec2 inTiles = uvBox.max().cwiseQuotient(Vec2(1, tileHeight));
    const Vec2 reached = (inTiles.array() - 0.02).ceil();
    return reached.cwiseMax(1).cwiseMin(Vec2(columns, rows));
}

PaperDrawing paperDrawing(const MapCamera &camera, double pixelRatio, const PackingSettings &packing)
{
    const MapGrid grid = MapGrid::of(camera, packing.textureSize);
    const Vec2 tileSize(1, packing.tileHeight());
    const double height = camera.viewSize().height();
    const auto onScreen = [&](const Vec2 &uv) {
        const QPointF pixel = camera.toScreen(uv);
        return QVector2D(static_cast<float>(pixelRatio * pixel.x()),
                         static_cast<float>(pixelRatio * (height - pixel.y())));
    };
    // Reference points near the view, so that single precision is sufficient.
    const Vec2 tile = camera.centre().cwiseQuotient(tileSize).array().round();
    const Vec2 line = (camera.centre() / grid.step).array().round() * grid.step;
    PaperDrawing paper;
    paper.tileOrigin = onScreen(tile.cwiseProduct(tileSize));
    paper.originTile = {static_cast<float>(tile.x()), static_cast<float>(tile.y())};
    paper.tilePixels = pixelRatio * camera.scale();
    paper.tileHeight = tileSize.y();
    paper.gridOrigin = onScreen(line);
    paper.gridPixels = pixelRatio * camera.scale() * grid.step;
    paper.minorDivisions = grid.divisions;
    paper.minorStrength = grid.strength;
    return paper;
}

} // namespace autocuts
