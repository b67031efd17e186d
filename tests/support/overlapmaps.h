// Maps that overlap, and the plainest way to find overlaps, for tests.
#pragma once

#include "solver/overlap/overlapfinder.h"
#include "support/meshbuilders.h"

#include <functional>
#include <vector>

namespace autocuts::test {

using namespace overlap;

//! All overlapping pairs, every two triangles compared. \param uv three rows per triangle
std::vector<OverlapPair> bruteForce(const UvMatrix &uv, double minArea);

//! Corner UVs of a mesh from a map of its positions.
UvMatrix mapped(const MeshData &mesh, const std::function<Vec2(const Vec3 &)> &map);
//! A strip of `across` by `along` quads (or triangles) over [0, 1] x [-1, 1], x running along.
MeshPtr strip(int along, int across, bool quads);
//! A strip laid along a curve, `width` to either side.
std::function<Vec2(const Vec3 &)> along(const std::function<Vec2(double)> &curve, double width);

struct OverlappingMap
{
    const char *name;
    MeshPtr mesh;
    UvMatrix uv;    //!< per polygon corner
    int mostCharts; //!< that the min-cut may leave
};

//! Strips that cover themselves in different ways.
std::vector<OverlappingMap> overlappingMaps();

} // namespace autocuts::test
