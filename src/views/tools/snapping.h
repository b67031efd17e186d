// Snapping of drags in the map.
#pragma once

#include "views/canvas/mapcamera.h"

#include <Eigen/Geometry>
#include <Qt>

namespace autocuts {

//! The lines to snap to: those of the visible grid, of every texel, or of every tile of the texture; or other
//! islands.
enum class SnapTo { Nothing, Grid, Texels, Tiles, Islands };

//! Ctrl: the grid; Ctrl+Shift: texels; Ctrl+Alt: tiles. Shift alone: islands.
SnapTo snapOf(Qt::KeyboardModifiers modifiers);
//! Distance between the lines in texture space; 0 when there are no lines. \param textureSize texels per tile
double snapStep(SnapTo snap, const MapCamera &camera, int textureSize);
//! The nearest crossing of two lines. \param step from snapStep()
Vec2 snappedPoint(const Vec2 &point, double step);
//! The nearest displacement that aligns, on each axis, one side of the box with a line.
Vec2 snappedMove(const Vec2 &move, const Eigen::AlignedBox2d &box, double step);

} // namespace autocuts
