#include "solver/preference/creases.h"

#include "model/plain/edgeangles.h"
#include "solver/base/constant.h"

#include <algorithm>
#include <numbers>

namespace autocuts::preference {

namespace {

// Numbers in this file without another source were chosen by hand.

constexpr double degree = std::numbers::pi / 180;
//! What counts as smooth, and the largest share of rough edges around a crease, see creases().
constexpr double smoothAngle = 15 * degree;
constexpr double roughShare = 0.2; // of the edges around a crease
//! The cost factor falls between these angles.
AUTOCUTS_CONSTANT(double, rampBegin, 20 * degree);
AUTOCUTS_CONSTANT(double, rampEnd, 60 * degree);
constexpr double leastFactor = 1e-3; // a seam always costs something

//! Of rough surfaces, see isRough(). Measured on meshes of so many triangles: half of the edges (by length)
//! bend by at most 5.9 degrees on models made by hand, and by 8 to 69 on scans and generated models with
//! noise.
constexpr double roughBend = 7 * degree;
constexpr int roughTriangles = 4000;

} // namespace

std::vector<bool> creases(const MeshData &mesh, const std::vector<double> &angles)
{
    // Per vertex: length of all its edges, and of those that are neither smooth nor sharp.
    std::vector<double> all(mesh.vertexCount(), 0), rough(mesh.vertexCount(), 0);
    const auto isRough = [&](std::size_t e) { return angles[e] >= smoothAngle && angles[e] < sharpAngle; };
    for (std::size_t e = 0; e < angles.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        for (int end = 0; end < 2 && !pair.diagonal; ++end) {
            const int v = mesh.vertexOfSoup(pair.corner[end][0]);
            all[v] += pair.length;
            rough[v] += isRough(e) ? pair.length : 0;
        }
    }
    std::vector<bool> result(angles.size(), false);
    for (std::size_t e = 0; e < angles.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const int a = mesh.vertexOfSoup(pair.corner[0][0]), b = mesh.vertexOfSoup(pair.corner[1][0]);
        result[e] = angles[e] >= sharpAngle &&
                    rough[a] + rough[b] <= roughShare * (all[a] + all[b] - 2 * pair.length);
    }
    return result;
}

bool isRough(const MeshData &mesh, const std::vector<double> &angles)
{
    double all = 0, bent = 0;
    for (std::size_t e = 0; e < angles.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        all += pair.diagonal ? 0 : pair.length;
        bent += !pair.diagonal && angles[e] > roughBend ? pair.length : 0;
    }
    for (const BoundarySide &side : mesh.boundarySides) {
        if (side.reason != OpenSide::NonManifold)
            continue;
        const std::array<int, 3> &corner = mesh.triangles[side.triangle];
        const double length =
            (mesh.cornerPosition(corner[side.side]) - mesh.cornerPosition(corner[(side.side + 1) % 3]))
                .norm();
        all += length;
        bent += length;
    }
    return mesh.triangleCount() >= roughTriangles && bent > all / 2;
}

std::vector<double> creaseFactors(const MeshData &mesh, double strength)
{
    std::vector<double> factors = edgeAngles(mesh);
    for (double &factor : factors) {
        const double sharpness = std::clamp((factor - rampBegin) / (rampEnd - rampBegin), 0.0, 1.0);
        factor = std::max(leastFactor, 1 - strength * sharpness);
    }
    return factors;
}

} // namespace autocuts::preference
