// Snapping of drags in the map.
#pragma once

#include "views/canvas/mapcamera.h"
#include "views/state/toolsettings.h"

#include <Eigen/Geometry>
#include <Qt>

namespace autocuts {

//! What the keys ask for. Ctrl: the visible grid; Ctrl+Shift: texels; Ctrl+Alt: tiles; Shift alone: islands;
//! Alt alone: nothing. \param otherwise without keys
SnapTo snapOf(Qt::KeyboardModifiers modifiers, SnapTo otherwise);
//! Distance between the lines in texture space; 0 when there are no lines. \param textureSize texels per tile
double snapStep(SnapTo snap, const MapCamera &camera, int textureSize);
//! The nearest crossing of two lines. \param step from snapStep()
Vec2 snappedPoint(const Vec2 &point, double step);
//! The nearest displacement that aligns, on each axis, one side of the box with a line.
Vec2 snappedMove(const Vec2 &move, const Eigen::AlignedBox2d &box, double step);

} // namespace autocuts
