#include "views/tools/snapping.h"

#include "views/canvas/mapgrid.h"

#include <cmath>

namespace autocuts {

SnapTo snapOf(Qt::KeyboardModifiers modifiers, SnapTo otherwise)
{
    if (modifiers == Qt::NoModifier)
        return otherwise;
    if (!modifiers.testFlag(Qt::ControlModifier))
        return modifiers == Qt::ShiftModifier ? SnapTo::Islands : SnapTo::Nothing;
    if (modifiers.testFlag(Qt::AltModifier))
        return SnapTo::Tiles;
    return modifiers.testFlag(Qt::ShiftModifier) ? SnapTo::Texels : SnapTo::Grid;
}

Vec2 snapStep(SnapTo snap, const MapCamera &camera, const PackingSettings &packing)
{
    switch (snap) {
    case SnapTo::Nothing:
    case SnapTo::Islands:
        break;
    case SnapTo::Grid: {
        const MapGrid grid = MapGrid::of(camera, packing.textureSize);
        return Vec2::Constant(grid.step / grid.divisions);
    }
    case SnapTo::Texels:
        return Vec2::Constant(1.0 / packing.textureSize);
    case SnapTo::Tiles:
        return {1, packing.tileHeight()};
    }
    return Vec2::Zero();
}

Vec2 snappedPoint(const Vec2 &point, const Vec2 &step)
{
    return step.x() > 0 ? Vec2(point.cwiseQuotient(step).array().round() * step.array()) : point;
}

Vec2 snappedMove(const Vec2 &move, const Eigen::AlignedBox2d &box, const Vec2 &step)
{
    if (!(step.x() > 0) || box.isEmpty())
        return move;
    const Vec2 low = snappedPoint(box.min() + move, step) - box.min();
    const Vec2 high = snappedPoint(box.max() + move, step) - box.max();
    Vec2 result;
    for (int axis = 0; axis < 2; ++axis)
        result[axis] =
            std::abs(high[axis] - move[axis]) < std::abs(low[axis] - move[axis]) ? high[axis] : low[axis];
    return result;
}

} // namespace autocuts
