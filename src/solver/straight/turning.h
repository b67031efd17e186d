// Turns islands so that they run along the axes.
#pragma once

#include "solver/straight/borderchains.h"

namespace autocuts::straight {

//! The angle by which an island has to be turned so that most of its straight chains run along the axes,
//! radians in [-pi / 4, pi / 4]. Without chains its whole border counts.
double angleToAxes(const Island &island, const std::vector<Chain> &chains);

//! The angle by which an island has to be turned so that a direction of the model is up in the map, radians.
//! In an island that lies across that direction, up is what is up for a viewer who looks down on it: -z where
//! y is up, y where z is up. 0 where no direction is up.
double angleToUp(const Soup &soup, const Island &island, const Positions &positions, WorldUp up);

//! Turns positions about the origin, counter-clockwise.
void turn(Positions &positions, double angle);

//! The same by right angles, exactly.
void turnQuarters(Positions &positions, int quarters);

} // namespace autocuts::straight
