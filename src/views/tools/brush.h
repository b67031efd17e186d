// The brush that paints seam weights.
#pragma once

#include "views/canvas/picking.h"

#include <QPointF>

#include <vector>

namespace autocuts {

class ToolCanvas;

//! Size and strength of a brush.
struct Brush
{
    static constexpr double minRadius = 4, maxRadius = 400;

    double radius = 32;    //!< logical pixels
    double strength = 0.7; //!< in the middle, in (0, 1]
    double hardness = 0.3; //!< part of the radius, in [0, 1], that gets the whole strength

    //! How much of the paint is laid at a distance from the middle, in [0, 1]; falls smoothly to 0 at the
    //! rim.
    double effectAt(double distance) const;
};

//! An edge pair that the brush touches.
struct BrushTouch
{
    int edgePair = 0;
    double distance = 0; //!< of its nearest point from the middle of the brush, logical pixels
};

//! What lies under a brush, in no particular order and without diagonals: what hangs together with the face
//! in the middle and is turned to the viewer like that one. So neither the back of the model is painted nor
//! what lies below others in the map, and there no gap is crossed. \param pick what is in the middle
std::vector<BrushTouch> edgesUnderBrush(const ToolCanvas &canvas, const QPointF &middle,
                                        const PickResult &pick, double radius);

} // namespace autocuts
