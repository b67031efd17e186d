// The brush of the tools that paint weights and shape the map.
#pragma once

#include "views/canvas/picking.h"
#include "views/canvas/tooloption.h"

#include <QPointF>

#include <functional>
#include <vector>

class QWheelEvent;

namespace autocuts {

class ToolCanvas;

//! Size and strength of a brush. The defaults were chosen by hand.
struct Brush
{
    static constexpr double minRadius = 4, maxRadius = 400;

    double radius = 32;    //!< logical pixels
    double strength = 0.7; //!< strength at the centre, in (0, 1]
    double hardness = 0.3; //!< share of the radius, in [0, 1], with full strength

    //! Share of the strength, in [0, 1], at a distance from the centre; decreases smoothly to 0 at the rim.
    double effectAt(double distance) const;
    //! Changes the size by Shift and wheel, the strength by Ctrl, the hardness by Alt. \returns false for
    //! other events
    bool takeWheel(const QWheelEvent &event);
};

//! Size, strength and hardness for the bar of tool options. \param set receives the changed brush
std::vector<ToolOption> brushOptions(const Brush &brush, const std::function<void(const Brush &)> &set);

//! An element under the brush.
struct BrushTouch
{
    int element = 0;     //!< an edge pair or a face
    double distance = 0; //!< distance of its nearest point from the centre of the brush, in logical pixels
};

//! The edges under a brush, in no particular order and without diagonals. They belong to faces that are
//! connected with the face at the centre and face the viewer in the same way. This leaves out the back of the
//! model and, in the map, islands below others; in the map the brush does not cross gaps.
//! \param pick the elements at the centre
std::vector<BrushTouch> edgesUnderBrush(const ToolCanvas &canvas, const QPointF &middle,
                                        const PickResult &pick, double radius);

//! The centres of the dabs of a stroke from one place of the mouse to another, which is the last one: so
//! dense that fast strokes have no gaps, and so few that the brush keeps up with the mouse.
std::vector<QPointF> dabsBetween(const QPointF &from, const QPointF &to, double radius);

//! The faces under a brush; the same as those of edgesUnderBrush(). The face at the centre has distance 0.
std::vector<BrushTouch> facesUnderBrush(const ToolCanvas &canvas, const QPointF &middle,
                                        const PickResult &pick, double radius);

} // namespace autocuts
