#include "views/control/session/islandglide.h"

#include "solver/base/rigidfit.h"
#include "views/gl/soupbuffers.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! Islands that move less than this share of a texture are left where they are: they only change their shape.
constexpr double leastWay = 1e-4;

bool isOpen(const OpenedMap &map, std::size_t edgePair)
{
    return std::max(map.separation[2 * edgePair], map.separation[2 * edgePair + 1]) >= 0.5f;
}

Vec2 centreOf(const UvMatrix &uv, const std::vector<int> &triangles)
{
    Vec2 sum = Vec2::Zero();
    for (const int t : triangles)
        sum += uv.middleRows<3>(3 * t).colwise().sum();
    return sum / (3. * static_cast<double>(triangles.size()));
}

} // namespace

IslandGlide::IslandGlide(const MeshData &mesh, const OpenedMap &before, const OpenedMap &after)
    : mBefore(before.uv), mMotionOf(mesh.triangleCount(), -1)
{
    const std::vector<int> islands = liveIslands(mesh, after.separation);
    const auto islandOf = [&](int triangle) { return islands[mesh.triangleFace[triangle]]; };
    const int count = islands.empty() ? 0 : *std::ranges::max_element(islands) + 1;
    std::vector<bool> stayed(count, true);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (isOpen(before, e) == isOpen(after, e))
            continue;
        for (const int triangle : mesh.edgePairs[e].triangle)
            stayed[islandOf(triangle)] = false;
    }
    std::vector<std::vector<int>> trianglesOf(count);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (stayed[islandOf(t)])
            trianglesOf[islandOf(t)].push_back(t);
    }
    for (const std::vector<int> &triangles : trianglesOf) {
        if (triangles.empty())
            continue;
        std::vector<PointMatch> matches;
        for (const int t : triangles) {
            for (int s = 3 * t; s < 3 * t + 3; ++s)
                matches.push_back({after.uv.row(s), before.uv.row(s)});
        }
        const SimilarMotion motion = fitSimilar(matches);
        if (!(motion.scale() > 0))
            continue;
        const Motion way{centreOf(before.uv, triangles), centreOf(after.uv, triangles),
                         std::atan2(motion.s, motion.c), std::log(motion.scale())};
        if ((way.to - way.from).norm() < leastWay && std::abs(way.angle) < leastWay)
            continue;
        for (const int t : triangles)
            mMotionOf[t] = movingCount();
        mMotions.push_back(way);
    }
}

UvMatrix IslandGlide::at(double share) const
{
    std::vector<SimilarMotion> motions;
    for (const Motion &way : mMotions) {
        const double scale = std::exp(share * way.logScale);
        SimilarMotion motion{scale * std::cos(share * way.angle), scale * std::sin(share * way.angle)};
        motion.shift = way.from + share * (way.to - way.from) - motion(way.from);
        motions.push_back(motion);
    }
    UvMatrix uv = mBefore;
    for (Eigen::Index s = 0; s < uv.rows(); ++s) {
        if (const int motion = mMotionOf[static_cast<std::size_t>(s / 3)]; motion >= 0)
            uv.row(s) = motions[motion](uv.row(s));
    }
    return uv;
}

} // namespace autocuts
