#include "model/plain/flippedtriangles.h"

#include "model/plain/parallel.h"

#include <cmath>

namespace autocuts {

namespace {

//! Triangles whose area is a smaller share of the whole UV area count as having no area. The same value as in
//! UvMetrics; chosen by hand.
constexpr double smallestArea = 1e-14;

//! Twice the signed area of a triangle in UV space.
double signedUvArea(const UvMatrix &uv, int t)
{
    return cross2(uv.row(3 * t), uv.row(3 * t + 1), uv.row(3 * t + 2));
}

} // namespace

std::vector<bool> flippedTriangles(const MeshData &mesh, const UvMatrix &soupUv, std::span<const int> islands)
{
    const int count = mesh.triangleCount();
    std::vector<double> area(count, 0);
    parallelRanges(count, [&](int first, int end) {
        for (int t = first; t < end; ++t) {
            if (islands[mesh.triangleFace[t]] >= 0)
                area[t] = signedUvArea(soupUv, t);
        }
    });
    std::vector<double> islandArea(mesh.faceCount(), 0); // a mesh never has more islands than faces
    double total = 0;
    for (int t = 0; t < count; ++t) {
        if (const int island = islands[mesh.triangleFace[t]]; island >= 0) {
            islandArea[island] += area[t];
            total += std::abs(area[t]);
        }
    }
    std::vector<bool> flipped(count, false);
    for (int t = 0; t < count; ++t) {
        if (const int island = islands[mesh.triangleFace[t]]; island >= 0)
            flipped[t] =
                std::abs(area[t]) >= smallestArea * total && (area[t] < 0) != (islandArea[island] < 0);
    }
    return flipped;
}

} // namespace autocuts
