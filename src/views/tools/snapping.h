// What drags in the map snap to.
#pragma once

#include "views/canvas/mapcamera.h"

#include <Eigen/Geometry>
#include <Qt>

namespace autocuts {

//! Lines to snap to: those of the grid as it is drawn, every texel, every tile of the texture; or other
//! islands.
enum class SnapTo { Nothing, Grid, Texels, Tiles, Islands };

//! Ctrl: the grid; with Shift: texels; with Alt: tiles. Shift alone: islands.
SnapTo snapOf(Qt::KeyboardModifiers modifiers);
//! Distance between the lines in texture space; 0: does not snap to lines. \param textureSize texels per tile
double snapStep(SnapTo snap, const MapCamera &camera, int textureSize);
//! The nearest crossing of lines. \param step of snapStep()
Vec2 snappedPoint(const Vec2 &point, double step);
//! The nearest displacement that brings, for each axis, one side of the box onto a line.
Vec2 snappedMove(const Vec2 &move, const Eigen::AlignedBox2d &box, double step);

} // namespace autocuts
