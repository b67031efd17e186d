// The axes in the corner of the 3D view; a click looks along one of them.
#pragma once

#include "views/canvas/orbitcamera.h"

#include <array>
#include <optional>

class QPainter;
class QRect;

namespace autocuts {

struct ViewColors;

//! One end of an axis on the screen.
struct AxisEnd
{
    ViewSide side = ViewSide::Front;
    QPointF centre;   //!< logical pixels
    double depth = 0; //!< -1 towards the viewer, 1 away

    //! The side to look from after a click: the opposite one when the end points at the viewer already.
    ViewSide clicked() const { return depth < -0.9999 ? opposite(side) : side; }
};

//! All ends, the farthest first.
std::array<AxisEnd, 6> axisEnds(const QRect &view, const OrbitCamera &camera);
//! The end at a pixel, the nearest if there are several.
std::optional<AxisEnd> axisEndAt(const QRect &view, const OrbitCamera &camera, const QPointF &pixel);
//! \param hovered the end under the mouse, which is marked
void drawAxisGizmo(QPainter &painter, const QRect &view, const ViewColors &colors, const OrbitCamera &camera,
                   std::optional<ViewSide> hovered);

} // namespace autocuts
