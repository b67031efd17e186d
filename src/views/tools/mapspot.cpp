#include "views/tools/mapspot.h"

#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace autocuts {

namespace {

//! The map around a triangle as the 3D view shows it.
std::optional<MapSpot> spotOnModel(const ToolCanvas &canvas, const QPointF &pixel, int triangle)
{
    Eigen::Matrix2d seen, uv;
    const auto first = canvas.screenOf(3 * triangle);
    const Vec2 origin = canvas.content().uv().row(3 * triangle);
    for (int k = 1; k < 3; ++k) {
        const auto place = canvas.screenOf(3 * triangle + k);
        if (!first || !place)
            return std::nullopt;
        seen.col(k - 1) << place->x() - first->x(), place->y() - first->y();
        uv.col(k - 1) = canvas.content().uv().row(3 * triangle + k).transpose() - origin;
    }
    MapSpot spot;
    spot.triangle = triangle;
    spot.toUv = uv * seen.inverse();
    spot.uv = origin + spot.toUv * Vec2(pixel.x() - first->x(), pixel.y() - first->y());
    if (!spot.uv.allFinite() || !(spot.unitsPerPixel() > 0))
        return std::nullopt;
    return spot;
}

} // namespace

double MapSpot::unitsPerPixel() const
{
    return std::sqrt(std::abs(toUv.determinant()));
}

std::optional<MapSpot> mapSpotAt(const ToolCanvas &canvas, const QPointF &pixel, const PickResult &pick)
{
    if (pick.triangle < 0 || !canvas.content().mesh() ||
        !canvas.content().uv().middleRows(3 * pick.triangle, 3).allFinite())
        return std::nullopt;
    const MapCamera *camera = canvas.mapCamera();
    if (!camera)
        return spotOnModel(canvas, pixel, pick.triangle);
    MapSpot spot;
    spot.triangle = pick.triangle;
    spot.uv = camera->toUv(pixel);
    spot.toUv << 1 / camera->scale(), 0, 0, -1 / camera->scale();
    return spot;
}

std::optional<MapSpot> mapSpotUnder(const ToolCanvas &canvas, const QPointF &centre, const PickResult &pick,
                                    double radius)
{
    if (auto spot = mapSpotAt(canvas, centre, pick); spot || !canvas.mapCamera())
        return spot;
    for (const double share : {0.3, 0.6, 0.9}) {
        for (int i = 0; i < 8; ++i) {
            const double angle = i * std::numbers::pi / 4;
            PickResult beside;
            beside.triangle =
                canvas.pick(centre + share * radius * QPointF(std::cos(angle), std::sin(angle))).triangle;
            if (auto spot = mapSpotAt(canvas, centre, beside))
                return spot;
        }
    }
    return std::nullopt;
}

} // namespace autocuts
