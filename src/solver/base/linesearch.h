// Constants of the line searches along Newton steps.
#pragma once

namespace autocuts {

//! Share of the predicted decrease that a step must reach (Armijo): the usual value, not tuned.
inline constexpr double armijo = 1e-4;
//! Share of the way to the first flip that a step may go. Chosen by hand.
inline constexpr double flipMargin = 0.9;

//! Where steps must not make borders cross: halvings of a step because of that before the points at the
//! crossing are held, how often the step is solved again with more points held, and what is added to the
//! diagonal of unknowns so that they do not move. Chosen by hand.
inline constexpr int contactHalvings = 3;
inline constexpr int freezeRounds = 4;
inline constexpr double frozenPivot = 1e30;

} // namespace autocuts
