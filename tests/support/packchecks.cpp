#include "support/packchecks.h"

#include "solver/base/random.h"
#include "solver/base/segmentcrossing.h"
#include "solver/packing/segmentgrid.h"

#include <algorithm>
#include <numbers>

namespace autocuts::test {

using namespace packing;

namespace {

std::vector<std::array<Vec2, 2>> placedBoundary(const PackIsland &island, const PackResult &result, int index)
{
    const double scale = island.locked ? 1 : result.scale;
    const Turn turn(result.placements[index].angle, scale);
    std::vector<std::array<Vec2, 2>> edges;
    for (const auto &e : island.boundary)
        edges.push_back({turn(island.points[e[0]]) + result.placements[index].translation,
                         turn(island.points[e[1]]) + result.placements[index].translation});
    return edges;
}

double distance(const std::array<Vec2, 2> &p, const std::array<Vec2, 2> &q)
{
    if (segmentsCross(p[0], p[1], q[0], q[1]))
        return 0;
    return std::sqrt(
        std::min({pointSegmentSquared(p[0], q[0], q[1]), pointSegmentSquared(p[1], q[0], q[1]),
                  pointSegmentSquared(q[0], p[0], p[1]), pointSegmentSquared(q[1], p[0], p[1])}));
}

bool isInside(const Vec2 &p, const std::vector<std::array<Vec2, 2>> &edges)
{
    bool inside = false;
    for (const auto &[a, b] : edges) {
        if ((a.y() <= p.y()) != (b.y() <= p.y()) &&
            a.x() + (p.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y()) > p.x())
            inside = !inside;
    }
    return inside;
}

} // namespace

PackIsland polygon(std::vector<Vec2> points)
{
    PackIsland island;
    const int n = static_cast<int>(points.size());
    for (int i = 1; i + 1 < n; ++i)
        island.triangles.push_back({0, i, i + 1});
    for (int i = 0; i < n; ++i)
        island.boundary.push_back({i, (i + 1) % n});
    island.points = std::move(points);
    return island;
}

PackIsland box(double x, double y, double width, double height)
{
    return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

PackIsland shiftedBy(PackIsland island, const Vec2 &shift)
{
    for (Vec2 &p : island.points)
        p += shift;
    return island;
}

PackIsland ring(double outer, double inner)
{
    PackIsland island;
    for (const double half : {0.5 * outer, 0.5 * inner}) {
        for (const Vec2 &corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
            island.points.push_back(half * corner);
    }
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        island.triangles.push_back({i, j, 4 + j});
        island.triangles.push_back({i, 4 + j, 4 + i});
        island.boundary.push_back({i, j});
        island.boundary.push_back({4 + j, 4 + i});
    }
    return island;
}

std::vector<PackIsland> randomStars(int count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<PackIsland> islands;
    for (int i = 0; i < count; ++i) {
        const int corners = 5 + random.below(9);
        const double size = 0.02 + 0.2 * random.uniform() * random.uniform();
        std::vector<Vec2> points{Vec2::Zero()};
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners;
            points.push_back(size * (0.2 + random.uniform()) * Vec2(std::cos(angle), std::sin(angle)));
        }
        PackIsland island;
        for (int k = 1; k <= corners; ++k) {
            const int next = k % corners + 1;
            island.triangles.push_back({0, k, next});
            island.boundary.push_back({k, next});
        }
        island.points = points;
        islands.push_back(island);
    }
    return islands;
}

QString brokenRule(const std::vector<PackIsland> &islands, const PackOptions &settings,
                   const PackResult &result)
{
    const double texel = 1.0 / settings.textureSize;
    const double border = (settings.border >= 0 ? settings.border : 0.5 * settings.margin) * texel;
    std::vector<std::vector<std::array<Vec2, 2>>> edges;
    for (int i = 0; i < static_cast<int>(islands.size()); ++i) {
        edges.push_back(placedBoundary(islands[i], result, i));
        for (const auto &edge : edges.back()) {
            for (const Vec2 &p : edge) {
                const bool in = (p.array() >= settings.lower.array() + border).all() &&
                                (p.array() <= settings.upper.array() - border).all();
                if (!in && !islands[i].locked)
                    return QStringLiteral("island %1 is outside").arg(i);
            }
        }
        for (int j = 0; j < i; ++j) {
            if (islands[i].locked && islands[j].locked)
                continue;
            for (const auto &p : edges[i]) {
                for (const auto &q : edges[j]) {
                    if (distance(p, q) < settings.margin * texel)
                        return QStringLiteral("islands %1 and %2 are too near: %3")
                            .arg(i)
                            .arg(j)
                            .arg(distance(p, q) / texel);
                }
            }
            // An island that lost points has no closed boundary.
            if (edges[i].size() >= 3 && edges[j].size() >= 3 &&
                (isInside(edges[i][0][0], edges[j]) || isInside(edges[j][0][0], edges[i])))
                return QStringLiteral("islands %1 and %2 overlap").arg(i).arg(j);
        }
    }
    return {};
}

bool isFinite(const PackResult &result)
{
    bool finite = std::isfinite(result.scale) && std::isfinite(result.efficiency);
    for (const PackPlacement &p : result.placements)
        finite = finite && std::isfinite(p.angle) && p.translation.allFinite();
    return finite;
}

bool sameBits(const PackResult &a, const PackResult &b)
{
    bool same = a.scale == b.scale && a.placements.size() == b.placements.size();
    for (std::size_t i = 0; same && i < a.placements.size(); ++i)
        same = a.placements[i].angle == b.placements[i].angle &&
               a.placements[i].translation == b.placements[i].translation;
    return same;
}

} // namespace autocuts::test
