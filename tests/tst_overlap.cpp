// Overlaps: exact orientation, the finder against brute force, clean regions, and separation.
#include "model/unionfind.h"
#include "solver/overlap/cleanregion.h"
#include "solver/overlap/maxflow.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/overlap/predicates.h"
#include "support/meshbuilders.h"
#include "support/objuv.h"

#include <QDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>

using namespace autocuts;

namespace {

//! splitmix64.
class Random
{
public:
    explicit Random(std::uint64_t seed) : mState(seed) {}
    std::uint64_t bits()
    {
        std::uint64_t z = mState += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

private:
    std::uint64_t mState;
};

std::array<Vec2, 3> turnedUp(const UvMatrix &uv, int t)
{
    std::array<Vec2, 3> p{uv.row(3 * t), uv.row(3 * t + 1), uv.row(3 * t + 2)};
    if (orientation(p[0], p[1], p[2]) < 0)
        std::swap(p[1], p[2]);
    return p;
}

//! All pairs tested against each other.
std::vector<OverlapPair> bruteForce(const UvMatrix &uv, double minArea)
{
    std::vector<OverlapPair> pairs;
    const int count = static_cast<int>(uv.rows()) / 3;
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            const auto p = turnedUp(uv, a), q = turnedUp(uv, b);
            if (orientation(p[0], p[1], p[2]) == 0 || orientation(q[0], q[1], q[2]) == 0)
                continue;
            const double area = intersectionArea(p, q);
            if (area > minArea)
                pairs.push_back({a, b, area});
        }
    }
    return pairs;
}

bool samePairs(const std::vector<OverlapPair> &a, const std::vector<OverlapPair> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const OverlapPair &p, const OverlapPair &q) {
        return p.first == q.first && p.second == q.second &&
               std::abs(p.area - q.area) <= 1e-13 + 1e-12 * q.area;
    });
}

UvMatrix triangles(const std::vector<std::array<Vec2, 3>> &list)
{
    UvMatrix uv(3 * static_cast<Eigen::Index>(list.size()), 2);
    for (std::size_t i = 0; i < list.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            uv.row(3 * static_cast<Eigen::Index>(i) + k) = list[i][k].transpose();
    }
    return uv;
}

//! Corner UVs of a mesh from a map of its positions.
UvMatrix mapped(const MeshData &mesh, const std::function<Vec2(const Vec3 &)> &map)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = map(mesh.cornerPosition(c)).transpose();
    return uv;
}

//! A strip of `across` by `along` quads (or triangles) over [0, 1] x [-1, 1], x running along.
test::MeshPtr strip(int along, int across, bool quads)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int x = 0; x <= along; ++x) {
        for (int y = 0; y <= across; ++y)
            points.emplace_back(double(x) / along, 2.0 * y / across - 1, 0);
    }
    for (int x = 0; x < along; ++x) {
        for (int y = 0; y < across; ++y) {
            const int a = x * (across + 1) + y;
            const int b = a + across + 1;
            if (quads) {
                faces.push_back({a, b, b + 1, a + 1});
            } else {
                faces.push_back({a, b, b + 1});
                faces.push_back({a, b + 1, a + 1});
            }
        }
    }
    return test::polygonMesh(points, faces);
}

//! A strip laid along a curve, `width` to either side.
std::function<Vec2(const Vec3 &)> along(const std::function<Vec2(double)> &curve, double width)
{
    return [=](const Vec3 &p) -> Vec2 {
        const double step = 1e-6;
        const Vec2 tangent = (curve(p.x() + step) - curve(p.x() - step)).normalized();
        return curve(p.x()) + width * p.y() * Vec2(-tangent.y(), tangent.x());
    };
}

struct Map
{
    const char *name;
    test::MeshPtr mesh;
    UvMatrix uv;    //!< per polygon corner
    int mostCharts; //!< that the min-cut may leave
};

std::vector<Map> overlappingMaps()
{
    const double pi = std::numbers::pi;
    const auto polar = [](double radius, double angle) {
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    std::vector<Map> maps;
    const auto add = [&](const char *name, const test::MeshPtr &mesh,
                         const std::function<Vec2(const Vec3 &)> &map, int mostCharts) {
        maps.push_back({name, mesh, mapped(*mesh, map), mostCharts});
    };
    add("spiral", strip(120, 3, false), along([=](double s) { return polar(1 + 0.6 * s, 6 * pi * s); }, 0.3),
        6);
    add("spiral of quads", strip(120, 3, true),
        along([=](double s) { return polar(1 + 0.6 * s, 6 * pi * s); }, 0.3), 6);
    add("crossing loop", strip(80, 2, false),
        along([=](double s) { return Vec2(std::sin(1.9 * pi * s + 0.3), std::sin(3.8 * pi * s + 0.6)); },
              0.08),
        3);
    add("folded back", strip(40, 2, true),
        along([=](double s) { return polar(1 + 0.1 * s, 2.4 * pi * s); }, 0.2), 3);
    add("stacked layers", strip(96, 2, true), along([=](double s) { return polar(1, 8 * pi * s); }, 0.3), 5);
    add("lid over itself", strip(30, 6, false),
        along([=](double s) { return polar(1, 1.97 * pi * s); }, 0.999), 1);
    // The end of the strip lies inside its beginning, chart-in-chart.
    add(
        "tail in the head", strip(60, 4, false),
        [=](const Vec3 &p) {
            const double width = p.x() < 0.3 ? 0.5 : 0.1;
            return Vec2(along([=](double s) { return polar(1, 2.2 * pi * s); }, width)(p));
        },
        3);
    return maps;
}

//! Overlapping pairs left inside the charts of a cut, by brute force.
int overlapsInCharts(const MeshData &mesh, const UvMatrix &soup, const std::vector<bool> &cut, double ratio)
{
    UnionFind sets(mesh.triangleCount());
    for (std::size_t p = 0; p < cut.size(); ++p) {
        if (!cut[p])
            sets.unite(mesh.edgePairs[p].triangle[0], mesh.edgePairs[p].triangle[1]);
    }
    int count = 0;
    for (const OverlapPair &pair : bruteForce(soup, ratio * totalUvArea(soup)))
        count += sets.find(pair.first) == sets.find(pair.second);
    return count;
}

int chartCount(const MeshData &mesh, const std::vector<bool> &cut)
{
    UnionFind sets(mesh.triangleCount());
    for (std::size_t p = 0; p < cut.size(); ++p) {
        if (!cut[p])
            sets.unite(mesh.edgePairs[p].triangle[0], mesh.edgePairs[p].triangle[1]);
    }
    return sets.labels().second;
}

} // namespace

class TestOverlap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void orientationIsExact()
    {
        // Points on a fine lattice, many of them in one line: integers say what is true.
        Random random(7);
        int zero = 0;
        for (int i = 0; i < 20000; ++i) {
            std::int64_t x[3], y[3];
            const std::int64_t dx = random.below(1000) - 500, dy = random.below(1000) - 500;
            const std::int64_t startX = (std::int64_t(1) << 50) + random.below(1 << 30);
            const std::int64_t startY = (std::int64_t(1) << 50) + random.below(1 << 30);
            for (int k = 0; k < 3; ++k) {
                const std::int64_t step = random.below(100000);
                x[k] = startX + step * dx + (random.below(4) == 0);
                y[k] = startY + step * dy + (random.below(4) == 0);
            }
            const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
            const int expected = area > 0 ? 1 : area < 0 ? -1 : 0;
            std::array<Vec2, 3> point;
            for (int k = 0; k < 3; ++k)
                point[k] = 0x1p-51 * Vec2(static_cast<double>(x[k]), static_cast<double>(y[k]));
            const auto &[a, b, c] = point;
            QCOMPARE(orientation(a, b, c), expected);
            QCOMPARE(orientation(b, a, c), -expected);
            QCOMPARE(orientation(c, a, b), expected);
            zero += expected == 0;
        }
        QVERIFY(zero > 1000);
        QCOMPARE(orientation({1e-20, 0}, {1, 1e-20}, {2, 2e-20}), -1);
    }

    void finderAgreesWithBruteForce_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("size");
        for (int seed = 1; seed <= 8; ++seed)
            QTest::addRow("seed %d", seed) << seed << (seed % 2 ? 0.1 : 0.4);
    }

    void finderAgreesWithBruteForce()
    {
        QFETCH(int, seed);
        QFETCH(double, size);
        Random random(static_cast<std::uint64_t>(seed));
        std::vector<std::array<Vec2, 3>> list;
        for (int i = 0; i < 300; ++i) {
            std::array<Vec2, 3> t;
            const Vec2 place(random.unit(), random.unit());
            // On a coarse lattice every third time, so that shared corners and collinear sides come up.
            for (Vec2 &p : t) {
                p = place + size * Vec2(random.unit(), random.unit());
                if (i % 3 == 0)
                    p = Vec2(std::round(16 * p.x()) / 16, std::round(16 * p.y()) / 16);
            }
            switch (random.below(12)) {
            case 0:
                if (!list.empty())
                    t = list[random.below(static_cast<int>(list.size()))];
                break;
            case 1:
                if (!list.empty()) {
                    t = list[random.below(static_cast<int>(list.size()))];
                    std::swap(t[0], t[1]);
                }
                break;
            case 2:
                t[2] = t[0];
                break;
            case 3:
                t[2] = 0.5 * (t[0] + t[1]);
                break;
            case 4:
                t[1] = Vec2(std::numeric_limits<double>::quiet_NaN(), 0);
                break;
            default:
                break;
            }
            list.push_back(t);
        }
        const UvMatrix uv = triangles(list);
        std::vector<std::array<Vec2, 3>> finite = list;
        for (auto &t : finite) {
            if (!t[1].allFinite())
                t = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
        }
        OverlapOptions options;
        const OverlapList found = findOverlaps(uv, options);
        QVERIFY(found.complete);
        const auto expected = bruteForce(triangles(finite), options.minAreaRatio * totalUvArea(uv));
        QVERIFY(expected.size() > 20);
        QVERIFY(samePairs(found.pairs, expected));
    }

    void intersectionAreaIsRight()
    {
        const std::array<Vec2, 3> a{Vec2(0, 0), Vec2(2, 0), Vec2(0, 2)};
        QCOMPARE(intersectionArea(a, a), 2.0);
        QCOMPARE(intersectionArea(a, {Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)}), 0.0);
        QCOMPARE(intersectionArea(a, {Vec2(1, 0), Vec2(2, 0), Vec2(1, 1)}), 0.5);
        QCOMPARE(intersectionArea(a, {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1)}), 0.5);
        // Far from the origin no digits are lost in the area.
        std::array<Vec2, 3> b = a;
        for (Vec2 &p : b)
            p += Vec2(1 << 20, 1 << 20);
        QCOMPARE(intersectionArea(b, b), 2.0);
    }

    void touchingTrianglesNeverCount()
    {
        // A jittered grid: neighbours share sides and corners only.
        const auto mesh = test::grid(40);
        Random random(3);
        UvMatrix corner(mesh->cornerCount(), 2);
        std::vector<Vec2> place(mesh->vertexCount());
        for (int v = 0; v < mesh->vertexCount(); ++v)
            place[v] = mesh->positions.row(v).head<2>().transpose() * 0.7 +
                       Vec2(random.unit(), random.unit()) * 0.005;
        for (int c = 0; c < mesh->cornerCount(); ++c)
            corner.row(c) = place[mesh->cornerVertex[c]].transpose();
        OverlapOptions options;
        options.minAreaRatio = 0;
        QCOMPARE(findOverlaps(test::soupUv(*mesh, corner), options).pairs.size(), std::size_t(0));
    }

    void turnedRegularGridHasNone()
    {
        // Many exactly and nearly collinear points.
        const auto mesh = test::grid(30);
        const UvMatrix corner = mapped(*mesh, [](const Vec3 &p) {
            return Vec2(0.6 * p.x() - 0.3 * p.y() + 0.1, 0.3 * p.x() + 0.6 * p.y());
        });
        QCOMPARE(findOverlaps(test::soupUv(*mesh, corner)).pairs.size(), std::size_t(0));
    }

    void nearlyTouching_data()
    {
        QTest::addColumn<double>("depth");
        QTest::addColumn<int>("pairs");
        QTest::newRow("apart") << -1e-9 << 0;
        QTest::newRow("touching") << 0.0 << 0;
        QTest::newRow("an ulp deep") << 1e-16 << 0;
        QTest::newRow("below the threshold") << 5e-11 << 0;
        QTest::newRow("above the threshold") << 1e-9 << 1;
        QTest::newRow("deep") << 1e-3 << 1;
    }

    void nearlyTouching()
    {
        QFETCH(double, depth);
        QFETCH(int, pairs);
        const UvMatrix uv = triangles(
            {{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, {Vec2(1, depth), Vec2(0, depth), Vec2(0.5, -1)}});
        QCOMPARE(findOverlaps(uv).pairs.size(), std::size_t(pairs));
    }

    void stackedTurnedMirroredAndNested()
    {
        const std::array<Vec2, 3> t{Vec2(0, 0), Vec2(3, 0), Vec2(0, 3)};
        const UvMatrix uv = triangles({t,
                                       t,                                            // the same again
                                       {t[1], t[2], t[0]},                           // turned
                                       {t[0], t[2], t[1]},                           // mirrored
                                       {Vec2(0.5, 0.5), Vec2(1, 0.5), Vec2(0.5, 1)}, // inside
                                       {Vec2(10, 10), Vec2(11, 10), Vec2(10, 11)}}); // elsewhere
        const OverlapList list = findOverlaps(uv);
        QCOMPARE(list.pairs.size(), std::size_t(10));
        for (const OverlapPair &pair : list.pairs)
            QCOMPARE(pair.area, pair.second == 4 ? 0.125 : 4.5);
        const std::vector<int> some{1, 4, 5};
        QCOMPARE(findOverlapsAmong(uv, some).pairs, (std::vector<OverlapPair>{{1, 4, 0.125}}));
    }

    void stopsWhenAsked()
    {
        const UvMatrix uv =
            triangles(std::vector<std::array<Vec2, 3>>(100, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}));
        OverlapOptions options;
        options.maxPairs = 10;
        QCOMPARE(findOverlaps(uv, options).complete, false);
        QCOMPARE(findOverlaps(uv, options).pairs.size(), std::size_t(10));
        const std::atomic<bool> cancel{true};
        options = {};
        options.cancel = &cancel;
        QCOMPARE(findOverlaps(uv, options).complete, false);
        QVERIFY(findOverlaps(UvMatrix(0, 2)).pairs.empty());
    }

    void maxFlowFindsTheSmallestCut()
    {
        // Random graphs small enough to try every cut.
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            Random random(seed);
            const int n = 9;
            std::vector<std::array<int, 3>> edges;
            MaxFlow flow(n);
            for (int i = 0; i < 20; ++i) {
                const int a = random.below(n), b = random.below(n), capacity = 1 + random.below(9);
                if (a == b)
                    continue;
                edges.push_back({a, b, capacity});
                flow.addEdge(a, b, capacity);
            }
            flow.setSource(0);
            flow.setSource(1);
            flow.setSink(7);
            flow.setSink(8);
            int best = std::numeric_limits<int>::max();
            for (int mask = 0; mask < 32; ++mask) {
                const int side = 3 | mask << 2;
                int cost = 0;
                for (const auto &[a, b, capacity] : edges)
                    cost += ((side >> a ^ side >> b) & 1) * capacity;
                best = std::min(best, cost);
            }
            QCOMPARE(flow.run(), std::int64_t(best));
            int cost = 0;
            for (const auto &[a, b, capacity] : edges)
                cost += flow.sourceSide()[a] != flow.sourceSide()[b] ? capacity : 0;
            QCOMPARE(cost, best);
            QVERIFY(flow.sourceSide()[0] && flow.sourceSide()[1] && !flow.sourceSide()[7] &&
                    !flow.sourceSide()[8]);
        }
    }

    void cleanRegionIsMaximal_data() { mapNames(); }

    void cleanRegionIsMaximal()
    {
        QFETCH(int, index);
        const Map map = overlappingMaps()[index];
        const MeshData &mesh = *map.mesh;
        const UvMatrix soup = test::soupUv(mesh, map.uv);
        const std::vector<bool> cut(mesh.edgePairs.size(), false);
        const int seed = mesh.triangleCount() / 2;
        const std::vector<int> region = cleanRegion(mesh, soup, cut, seed);
        QVERIFY(std::binary_search(region.begin(), region.end(), seed));
        OverlapOptions options;
        options.totalArea = totalUvArea(soup);
        QCOMPARE(findOverlapsAmong(soup, region, options).pairs.size(), std::size_t(0));
        // No neighbouring polygon fits in.
        const auto inside = [&](int t) { return std::binary_search(region.begin(), region.end(), t); };
        for (const EdgePair &pair : mesh.edgePairs) {
            QVERIFY(!pair.diagonal || inside(pair.triangle[0]) == inside(pair.triangle[1]));
            if (inside(pair.triangle[0]) == inside(pair.triangle[1]))
                continue;
            std::vector<int> larger = region;
            const int face =
                mesh.triangleFace[inside(pair.triangle[0]) ? pair.triangle[1] : pair.triangle[0]];
            for (int t = 0; t < mesh.triangleCount(); ++t) {
                if (mesh.triangleFace[t] == face)
                    larger.push_back(t);
            }
            QVERIFY(!findOverlapsAmong(soup, larger, options).pairs.empty());
        }
    }

    void cleanRegionChecksItsInput()
    {
        const auto mesh = test::cube();
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, cleanRegion(*mesh, UvMatrix(1, 2), {}, 0));
    }

    void separationLeavesNoOverlap_data() { mapNames(); }

    void separationLeavesNoOverlap()
    {
        QFETCH(int, index);
        const Map map = overlappingMaps()[index];
        const MeshData &mesh = *map.mesh;
        const UvMatrix soup = test::soupUv(mesh, map.uv);
        const std::vector<bool> before(mesh.edgePairs.size(), false);
        for (const auto method : {SeparationMethod::MinCut, SeparationMethod::Greedy}) {
            SeparationOptions options;
            options.method = method;
            const SeparationResult result = separateOverlaps(mesh, soup, before, {}, options);
            QVERIFY(result.complete);
            QCOMPARE(result.unresolvedPairs, 0);
            QCOMPARE(result.overlapPairs,
                     std::int64_t(overlapsInCharts(mesh, soup, before, options.minAreaRatio)));
            QCOMPARE(overlapsInCharts(mesh, soup, result.cut, options.minAreaRatio), 0);
            double length = 0;
            for (std::size_t p = 0; p < result.cut.size(); ++p) {
                QVERIFY(!(result.cut[p] && mesh.edgePairs[p].diagonal));
                length += result.cut[p] ? mesh.edgePairs[p].length : 0;
            }
            QVERIFY(std::abs(length - result.newSeamLength) < 1e-9);
            if (method == SeparationMethod::MinCut) {
                const int charts = chartCount(mesh, result.cut);
                QVERIFY2(charts <= map.mostCharts, qPrintable(QString::number(charts)));
            }
            QCOMPARE(separateOverlaps(mesh, soup, before, {}, options).cut, result.cut);
        }
    }

    void layersAreCutOnce()
    {
        // Two and a half turns over a band two quads wide: one straight cut per turn is enough.
        const auto mesh = strip(60, 2, true);
        const UvMatrix uv = mapped(*mesh, along(
                                              [](double s) {
                                                  return Vec2(std::cos(5 * std::numbers::pi * s),
                                                              std::sin(5 * std::numbers::pi * s));
                                              },
                                              0.3));
        const SeparationResult result = separateOverlaps(
            *mesh, test::soupUv(*mesh, uv), std::vector<bool>(mesh->edgePairs.size(), false), {});
        QCOMPARE(chartCount(*mesh, result.cut), 3);
        QCOMPARE(result.newSeams, 4);
        QVERIFY(std::abs(result.newSeamLength - 4) < 1e-12);
    }

    void paintedEdgesAreAvoided()
    {
        // Two turns: a straight cut anywhere near the middle will do; only one place is cheap.
        const auto mesh = strip(48, 2, true);
        const UvMatrix uv = mapped(*mesh, along(
                                              [](double s) {
                                                  return Vec2(std::cos(3 * std::numbers::pi * s),
                                                              std::sin(3 * std::numbers::pi * s));
                                              },
                                              0.3));
        SeparationOptions options;
        options.pairWeight.assign(mesh->edgePairs.size(), 1.0);
        const double place = 22.0 / 48;
        std::set<std::size_t> cheap;
        for (std::size_t p = 0; p < mesh->edgePairs.size(); ++p) {
            const EdgePair &pair = mesh->edgePairs[p];
            const double a = mesh->cornerPosition(mesh->cornerOfSoup(pair.corner[0][0])).x();
            const double b = mesh->cornerPosition(mesh->cornerOfSoup(pair.corner[1][0])).x();
            if (std::abs(a - place) < 1e-9 && std::abs(b - place) < 1e-9) {
                options.pairWeight[p] = 0.5;
                cheap.insert(p);
            }
        }
        QCOMPARE(cheap.size(), std::size_t(2));
        const SeparationResult result = separateOverlaps(
            *mesh, test::soupUv(*mesh, uv), std::vector<bool>(mesh->edgePairs.size(), false), {}, options);
        QCOMPARE(result.newSeams, 2);
        for (std::size_t p : cheap)
            QVERIFY(result.cut[p]);
    }

    void protectedPairsAreNeverCut()
    {
        const Map map = overlappingMaps()[0];
        const MeshData &mesh = *map.mesh;
        const UvMatrix soup = test::soupUv(mesh, map.uv);
        const std::vector<bool> cut(mesh.edgePairs.size(), false);
        Random random(5);
        std::vector<bool> joined(mesh.edgePairs.size());
        for (std::size_t p = 0; p < joined.size(); ++p)
            joined[p] = random.below(3) == 0;
        for (const auto method : {SeparationMethod::MinCut, SeparationMethod::Greedy}) {
            SeparationOptions options;
            options.method = method;
            const SeparationResult result = separateOverlaps(mesh, soup, cut, joined, options);
            for (std::size_t p = 0; p < joined.size(); ++p)
                QVERIFY(!(joined[p] && result.cut[p]));
            QCOMPARE(overlapsInCharts(mesh, soup, result.cut, 1e-10), result.unresolvedPairs);
        }
        // All joined: nothing can be done, and that is said.
        joined.assign(joined.size(), true);
        const SeparationResult stuck = separateOverlaps(mesh, soup, cut, joined);
        QCOMPARE(stuck.newSeams, 0);
        QCOMPARE(std::int64_t(stuck.unresolvedPairs), stuck.overlapPairs);
        QVERIFY(stuck.unresolvedPairs > 0);
    }

    void cleanMapsAndStackedIslandsStay()
    {
        // Two separate squares with the same UVs overlap, but they are different charts already.
        const auto two = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 0}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}});
        const UvMatrix uv =
            mapped(*two, [](const Vec3 &p) { return Vec2(p.x() > 2 ? p.x() - 3 : p.x(), p.y()); });
        const UvMatrix soup = test::soupUv(*two, uv);
        QCOMPARE(findOverlaps(soup).pairs.size(), std::size_t(2));
        const std::vector<bool> cut(two->edgePairs.size(), false);
        const SeparationResult result = separateOverlaps(*two, soup, cut, {});
        QCOMPARE(result.cut, cut);
        QCOMPARE(result.overlapPairs, std::int64_t(0));
    }

    void cancelledSeparationCutsNothing()
    {
        const Map map = overlappingMaps()[0];
        const std::vector<bool> cut(map.mesh->edgePairs.size(), false);
        const std::atomic<bool> cancel{true};
        SeparationOptions options;
        options.cancel = &cancel;
        const SeparationResult result =
            separateOverlaps(*map.mesh, test::soupUv(*map.mesh, map.uv), cut, {}, options);
        QVERIFY(!result.complete);
        QCOMPARE(result.cut, cut);
    }

    void realMeshFlattenedIsSeparated_data()
    {
        QTest::addColumn<QString>("file");
        for (const char *file : {"organic/cathead.obj", "polygons/suzanne.obj", "polygons/horse_quad.obj",
                                 "irregular/beetle.obj", "broken/zero_area_48.obj"})
            QTest::newRow(file) << QString::fromLatin1(file);
    }

    void realMeshFlattenedIsSeparated()
    {
        // Projected onto a plane: the far side lies under the near side, mirrored, everywhere.
        QFETCH(QString, file);
        const std::string folder = test::meshFolder();
        if (folder.empty())
            QSKIP("no meshes: set AUTOCUTS_MESHES");
        const test::ObjUv obj = test::readObjUv(folder + "/" + file.toStdString());
        const MeshData &mesh = *obj.mesh;
        const UvMatrix uv =
            mapped(mesh, [](const Vec3 &p) { return Vec2(p.x() + 0.1 * p.z(), p.y() - 0.07 * p.z()); });
        const UvMatrix soup = test::soupUv(mesh, uv);
        for (const auto method : {SeparationMethod::MinCut, SeparationMethod::Greedy}) {
            SeparationOptions options;
            options.method = method;
            const SeparationResult result =
                separateOverlaps(mesh, soup, std::vector<bool>(mesh.edgePairs.size(), false), {}, options);
            UnionFind sets(mesh.triangleCount());
            for (std::size_t p = 0; p < result.cut.size(); ++p) {
                QVERIFY(!(result.cut[p] && mesh.edgePairs[p].diagonal));
                if (!result.cut[p])
                    sets.unite(mesh.edgePairs[p].triangle[0], mesh.edgePairs[p].triangle[1]);
            }
            int left = 0;
            for (const OverlapPair &pair : findOverlaps(soup).pairs)
                left += sets.find(pair.first) == sets.find(pair.second);
            QCOMPARE(left, result.unresolvedPairs);
            QVERIFY(result.overlapPairs > 0);
        }
    }

private:
    static void mapNames()
    {
        QTest::addColumn<int>("index");
        const auto maps = overlappingMaps();
        for (int i = 0; i < static_cast<int>(maps.size()); ++i)
            QTest::newRow(maps[i].name) << i;
    }
};

QTEST_APPLESS_MAIN(TestOverlap)
#include "tst_overlap.moc"
