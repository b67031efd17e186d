#include "solver/rigid/hinges.h"

#include "solver/base/cornerat.h"

#include <algorithm>
#include <map>
#include <utility>

namespace autocuts::rigid {

namespace {

//! Two edges are of one hinge when the motion of one brings the other's sides together up to this share of
//! its length.
constexpr double sameMotionShare = 0.02;
//! Beside a curved region also up to this share of the distance between the edges: its border is hardly ever
//! straight in the plane.
constexpr double gapPerDistance = 0.1;

//! Share of the area from which a region may be an island of its own, or half of its component: as for the
//! charts of the search (search::CutState). Smaller ones rather hang on by little.
constexpr double leastIsland = 0.005;

//! Where the second side of an edge has to go: its ends, and the ends of the first side.
struct Sides
{
    Vec2 first[2], second[2];
};

Sides sidesOf(const std::vector<double> &x, const MeshData &mesh, const RigidRegions &regions, int first,
              int edge)
{
    const EdgePair &pair = mesh.edgePairs[edge];
    const int firstIs = regions.region[pair.triangle[0]] == first ? 0 : 1;
    Sides sides;
    for (int end = 0; end < 2; ++end) {
        sides.first[end] = cornerAt(x, pair.corner[end][firstIs]);
        sides.second[end] = cornerAt(x, pair.corner[end][1 - firstIs]);
    }
    return sides;
}

Vec2 middle(const Vec2 (&side)[2])
{
    return 0.5 * (side[0] + side[1]);
}

template <typename Motion>
double gapAt(const Motion &motion, const Sides &sides)
{
    return std::max((motion(sides.second[0]) - sides.first[0]).norm(),
                    (motion(sides.second[1]) - sides.first[1]).norm());
}

//! The widest gap that the motion of a hinge leaves.
double gapOf(const std::vector<double> &x, const MeshData &mesh, const RigidRegions &regions,
             const Hinge &hinge)
{
    const RigidMotion motion = motionOf(x, mesh, regions, hinge);
    double gap = 0;
    for (const int e : hinge.edges)
        gap = std::max(gap, gapAt(motion, sidesOf(x, mesh, regions, hinge.first, e)));
    return gap;
}

} // namespace

std::vector<Hinge> findHinges(const Soup &soup, const RigidRegions &regions, const Unrolled &unrolled,
                              const CutFlags &alwaysCut)
{
    const MeshData &mesh = *soup.mesh;
    std::map<std::pair<int, int>, std::vector<int>> between;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const int a = regions.region[pair.triangle[0]], b = regions.region[pair.triangle[1]];
        if (a < 0 || b < 0 || a == b || alwaysCut[e] || !unrolled.works[a] || !unrolled.works[b])
            continue;
        between[std::minmax(a, b)].push_back(static_cast<int>(e));
    }
    std::vector<Hinge> hinges;
    for (auto &[pair, edges] : between) {
        // The longest edge of a hinge says best how it lies.
        std::stable_sort(edges.begin(), edges.end(),
                         [&](int e, int f) { return mesh.edgePairs[e].length > mesh.edgePairs[f].length; });
        const int first = pair.first;
        const bool isCurved = regions.curved[first] || regions.curved[pair.second];
        const std::size_t begin = hinges.size();
        for (const int e : edges) {
            const Sides sides = sidesOf(unrolled.x, mesh, regions, first, e);
            const auto isOf = [&](const Hinge &hinge) {
                const Sides longest = sidesOf(unrolled.x, mesh, regions, first, hinge.edges.front());
                return gapAt(hinge.motion, sides) <=
                       sameMotionShare * (sides.first[1] - sides.first[0]).norm() +
                           (isCurved ? gapPerDistance * (middle(sides.first) - middle(longest.first)).norm()
                                     : 0);
            };
            auto found =
                std::find_if(hinges.begin() + static_cast<std::ptrdiff_t>(begin), hinges.end(), isOf);
            if (found == hinges.end()) {
                hinges.push_back(
                    {first,
                     pair.second,
                     {},
                     0,
                     PlaneMotion::between(sides.second[0], sides.second[1], sides.first[0], sides.first[1]),
                     0});
                found = hinges.end() - 1;
            }
            found->edges.push_back(e);
            found->length += soup.pairLength[2 * static_cast<std::size_t>(e)];
        }
        for (std::size_t h = begin; h < hinges.size() && isCurved; ++h)
            hinges[h].gap = gapOf(unrolled.x, mesh, regions, hinges[h]);
    }
    return hinges;
}

RigidMotion motionOf(const std::vector<double> &x, const MeshData &mesh, const RigidRegions &regions,
                     const Hinge &hinge)
{
    std::vector<PointMatch> matches;
    for (const int e : hinge.edges) {
        const Sides sides = sidesOf(x, mesh, regions, hinge.first, e);
        for (int end = 0; end < 2; ++end)
            matches.push_back({sides.first[end], sides.second[end], mesh.edgePairs[e].length});
    }
    return fitRigid(matches);
}

std::vector<double> borderLengths(const Soup &soup, const RigidRegions &regions, const Unrolled &unrolled)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<double> border(regions.count, 0);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        for (const int t : mesh.edgePairs[e].triangle) {
            if (const int r = regions.region[t]; r >= 0 && unrolled.cut[e])
                border[r] += soup.pairLength[2 * e];
        }
    }
    for (const BoundarySide &open : mesh.boundarySides) {
        if (const int r = regions.region[open.triangle]; r >= 0) {
            const int a = 3 * open.triangle + open.side, b = 3 * open.triangle + (open.side + 1) % 3;
            border[r] += (cornerAt(unrolled.x, b) - cornerAt(unrolled.x, a)).norm();
        }
    }
    return border;
}

std::vector<bool> edgesApart(const Soup &soup, const RigidRegions &regions, const Unrolled &unrolled,
                             const std::vector<Hinge> &hinges)
{
    const std::vector<double> border = borderLengths(soup, regions, unrolled);
    std::vector<double> share(regions.count, 0), least(regions.count, leastIsland);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (const int r = regions.region[t]; r >= 0) {
            share[r] += soup.shareOfCopy(t);
            least[r] = std::min(least[r], 0.5 * soup.componentShare[soup.mesh->component[t]]);
        }
    }
    const auto isIsland = [&](int r) { return share[r] >= least[r]; };
    std::vector<bool> apart(soup.mesh->edgePairs.size(), false);
    for (const Hinge &hinge : hinges) {
        if (regions.curved[hinge.first] || regions.curved[hinge.second])
            continue;
        const double shorter = std::min(border[hinge.first], border[hinge.second]);
        for (const int e : hinge.edges)
            apart[e] = hinge.length < leastHinge * shorter && isIsland(hinge.first) && isIsland(hinge.second);
    }
    return apart;
}

} // namespace autocuts::rigid
