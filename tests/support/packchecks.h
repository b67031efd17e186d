// Islands built in code, and the packer's rules checked by brute force.
#pragma once

#include "solver/packing/packing.h"

#include <QString>

#include <cstdint>

namespace autocuts::test {

using namespace packing;

//! A fan of triangles over a polygon that is star-shaped from its first point.
PackIsland polygon(std::vector<Vec2> points);
//! An upright rectangle with its lower left corner at (x, y).
PackIsland box(double x, double y, double width, double height);
PackIsland shiftedBy(PackIsland island, const Vec2 &shift);
//! A square ring around the origin with a square hole.
PackIsland ring(double outer, double inner);
//! Spiky random stars of random size.
std::vector<PackIsland> randomStars(int count, std::uint64_t seed);

//! Every rule of a layout by brute force; empty when all are kept.
QString brokenRule(const std::vector<PackIsland> &islands, const PackOptions &settings,
                   const PackResult &result);
//! True when no number of the result is infinite or NaN.
bool isFinite(const PackResult &result);
//! True when scale and placements are the same to the last bit.
bool sameBits(const PackResult &a, const PackResult &b);

} // namespace autocuts::test
