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

double snapStep(SnapTo snap, const MapCamera &camera, int textureSize)
{
    switch (snap) {
    case SnapTo::Nothing:
    case SnapTo::Islands:
        break;
    case SnapTo::Grid: {
        const MapGrid grid = MapGrid::of(camera, textureSize);
        return grid.step / grid.divisions;
    }
    case SnapTo::Texels:
        return 1.0 / textureSize;
    case SnapTo::Tiles:
        return 1;
    }
    return 0;
}

Vec2 snappedPoint(const Vec2 &point, double step)
{
    return step > 0 ? Vec2((point / step).array().round() * step) : point;
}

Vec2 snappedMove(const Vec2 &move, const Eigen::AlignedBox2d &box, double step)
{
    if (!(step > 0) || box.isEmpty())
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
