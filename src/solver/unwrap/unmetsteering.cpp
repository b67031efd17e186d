#include "solver/unwrap/unmetsteering.h"

#include "model/plain/uvseams.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! How far, in texture space, a corner may be from where it has to be. Far below a texel.
constexpr double tolerance = 1e-6;

bool isInScope(const Snapshot &snapshot, int face)
{
    return !snapshot.scope || snapshot.scope->faces[face];
}

} // namespace

UnmetSteering unmetSteering(const Snapshot &snapshot, const UvMatrix &uv)
{
    const MeshData &mesh = *snapshot.mesh;
    const Steering &steering = *snapshot.steering;
    const auto faceOf = [&](int soupCorner) { return mesh.triangleFace[soupCorner / 3]; };
    UnmetSteering unmet;
    for (const Pin &pin : steering.pins) {
        const int corner = mesh.cornerOfSoup(pin.soupCorner);
        const double distance = (Vec2(uv.row(corner)) - snapshot.uvScale * pin.target).norm();
        if (pin.hard && isInScope(snapshot, faceOf(pin.soupCorner)) && !(distance <= tolerance))
            unmet.pins.push_back(corner);
    }
    std::sort(unmet.pins.begin(), unmet.pins.end());
    unmet.pins.erase(std::unique(unmet.pins.begin(), unmet.pins.end()), unmet.pins.end());
    const bool only = snapshot.settings.seams == SeamMode::Only;
    const auto isCut = [&](std::size_t pair) {
        return !steering.pairState.empty() && steering.pairState[pair] == PairState::Cut;
    };
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        if ((!open[2 * e] && !open[2 * e + 1]) || !isInScope(snapshot, mesh.triangleFace[a]) ||
            !isInScope(snapshot, mesh.triangleFace[b]))
            continue;
        const bool given =
            isCut(2 * e) || isCut(2 * e + 1) || (!steering.givenSeams.empty() && steering.givenSeams[e]);
        if (snapshot.isJoined(e))
            unmet.joins.push_back(static_cast<int>(e));
        else if (only && !given)
            unmet.missingSeams.push_back(static_cast<int>(e));
    }
    for (std::size_t i = 0; i < steering.rectangles.size(); ++i) {
        const UvRectangle &box = steering.rectangles[i];
        const Eigen::AlignedBox2d place(Vec2(snapshot.uvScale * box.lower),
                                        Vec2(snapshot.uvScale * box.upper));
        const bool leaves = std::any_of(box.soupCorners.begin(), box.soupCorners.end(), [&](int corner) {
            return isInScope(snapshot, faceOf(corner)) &&
                   !(place.exteriorDistance(Vec2(uv.row(mesh.cornerOfSoup(corner)))) <= tolerance);
        });
        if (leaves)
            unmet.rectangles.push_back(static_cast<int>(i));
    }
    return unmet;
}

} // namespace autocuts::unwrap
