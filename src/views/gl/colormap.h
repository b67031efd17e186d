// Colours that stand for numbers: heat-maps, islands, painted weights.
#pragma once

#include <QColor>
#include <QGradient>

namespace autocuts {

//! Which figures a heat-map shows.
enum class HeatMap { SignedStretch, Magnitude };

//! Colour of a value. SignedStretch: -1 blue, 0 white, 1 red, or for colour-blind eyes purple to orange.
//! Magnitude: 0 blue to 1 red, or dark violet to yellow. Values outside are clamped.
QRgb heatColor(HeatMap map, bool colorBlind, double value);
//! Of triangles without a figure.
QRgb heatColorOfNothing();
//! Stops of the whole range, for a legend, in the direction from 0 to 1.
QGradientStops heatStops(HeatMap map, bool colorBlind);

//! A colour for an island. Numbers give hues in steps of the golden angle, so that those near each other
//! differ, and the same number always has the same colour.
QRgb islandColor(int number);

//! Colour of a painted factor: above 1 red ("Keep together"), below blue ("Attract cuts").
//! \param neutral of what is unpainted
QRgb paintColor(double weight, QRgb neutral);

//! Linear between two colours, at 0 the first.
QRgb mixColors(QRgb from, QRgb to, double amount);

} // namespace autocuts
