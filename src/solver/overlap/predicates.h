// Orientation test whose sign is always correct.
#pragma once

#include "model/plain/types.h"

namespace autocuts::overlap {

//! Sign of the signed area of the triangle a, b, c: 1 counter-clockwise, -1 clockwise, 0 exactly collinear.
//! Exact for all finite inputs whose products neither overflow nor underflow.
int orientation(const Vec2 &a, const Vec2 &b, const Vec2 &c);

} // namespace autocuts::overlap
