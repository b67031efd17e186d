// Colours for values: heat-maps and painted weights.
#pragma once

#include <QColor>
#include <QGradient>

namespace autocuts {

//! The figure that a heat-map shows.
enum class HeatMap { SignedStretch, Magnitude, Density };

//! The colour of a value. SignedStretch and Density: from -1 brown (too small in the map) over 0 white to 1
//! teal (too large). Magnitude: from 0 blue to 1 red, or for colour-blind people from dark violet to yellow.
//! Values outside the range are clamped.
QRgb heatColor(HeatMap map, bool colorBlind, double value);
//! The colour of triangles without a figure.
QRgb heatColorOfNothing();
//! Gradient stops of the whole range, for a legend, from 0 to 1.
QGradientStops heatStops(HeatMap map, bool colorBlind);

//! The colour of a painted weight: green above 1 ("Keep together"), as joined edges,
//! blue below 1 ("Attract cuts"), as edges that are cut.
//! \param neutral colour of unpainted faces
QRgb paintColor(double weight, QRgb neutral);

//! With a tolerance, densities get one of three colours. \param ratio of the density to the right one
//! \param tolerance share of the right density \returns the value for heatColor()
double bandedDensity(double ratio, double tolerance);
//! The gradient stops of these three colours.
QGradientStops bandedDensityStops();

//! The colour of a texel weight, in those of the density: brown below 1, teal above.
QRgb texelWeightColor(double weight);

//! Mixes two colours linearly; amount 0 gives the first.
QRgb mixColors(QRgb from, QRgb to, double amount);

} // namespace autocuts
