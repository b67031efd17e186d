// Snapping of drags in the map.
#pragma once

#include "model/plain/packingsettings.h"
#include "views/canvas/mapcamera.h"
#include "views/state/toolsettings.h"

#include <Eigen/Geometry>
#include <Qt>

namespace autocuts {

//! What the keys ask for. Ctrl: the visible grid; Ctrl+Shift: texels; Ctrl+Alt: tiles; Shift alone: islands;
//! Alt alone: nothing. \param otherwise without keys
SnapTo snapOf(Qt::KeyboardModifiers modifiers, SnapTo otherwise);
//! Distances between the lines in u and v, texture space; 0 when there are no lines.
Vec2 snapStep(SnapTo snap, const MapCamera &camera, const PackingSettings &packing);
//! The nearest crossing of two lines. \param step from snapStep()
Vec2 snappedPoint(const Vec2 &point, const Vec2 &step);
//! The nearest displacement that aligns, on each axis, one side of the box with a line.
Vec2 snappedMove(const Vec2 &move, const Eigen::AlignedBox2d &box, const Vec2 &step);

} // namespace autocuts
