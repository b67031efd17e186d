#include "model/plain/flippedtriangles.h"

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
    std::vector<double> islandArea(mesh.faceCount(), 0); // a mesh never has more islands than faces
    double total = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (islands[mesh.triangleFace[t]] < 0)
            continue;
        islandArea[islands[mesh.triangleFace[t]]] += signedUvArea(soupUv, t);
        total += std::abs(signedUvArea(soupUv, t));
    }
    std::vector<bool> flipped(mesh.triangleCount(), false);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (islands[mesh.triangleFace[t]] < 0)
            continue;
        const double area = signedUvArea(soupUv, t);
        const bool mirrored = islandArea[islands[mesh.triangleFace[t]]] < 0;
        flipped[t] = std::abs(area) >= smallestArea * total && (area < 0) != mirrored;
    }
    return flipped;
}

} // namespace autocuts
