// Clean regions, and maps cut apart until nothing overlaps.
#include "model/plain/unionfind.h"
#include "model/plain/uvlayout.h"
#include "solver/base/random.h"
#include "solver/overlap/cleanhalf.h"
#include "solver/overlap/cleanregion.h"
#include "solver/overlap/maxflow.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/overlap/uvseparation.h"
#include "support/objuv.h"
#include "support/overlapmaps.h"

#include <QDir>
#include <QTest>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace tst_separation {

using namespace autocuts;
using namespace autocuts::overlap;

namespace {

//! Overlapping pairs left inside the charts of a cut, by brute force.
int overlapsInCharts(const MeshData &mesh, const UvMatrix &soup, const std::vector<bool> &cut, double ratio)
{
    UnionFind sets(mesh.triangleCount());
    for (std::size_t p = 0; p < cut.size(); ++p) {
        if (!cut[p])
            sets.unite(mesh.edgePairs[p].triangle[0], mesh.edgePairs[p].triangle[1]);
    }
    int count = 0;
    for (const OverlapPair &pair : test::bruteForce(soup, ratio * totalUvArea(soup)))
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

//! A map that overlaps itself, without cuts, and a triangle to begin at.
struct UncutMap
{
    explicit UncutMap(int index)
        : mesh(test::overlappingMaps()[index].mesh), soup(soupUv(*mesh, test::overlappingMaps()[index].uv)),
          cut(mesh->edgePairs.size(), false), seed(mesh->triangleCount() / 2)
    {}
    test::MeshPtr mesh;
    UvMatrix soup;
    std::vector<bool> cut;
    int seed;
};

//! Capacity of the edges with one end among the nodes of `side`.
int costOf(const std::vector<std::array<int, 3>> &edges, unsigned side)
{
    int cost = 0;
    for (const auto &[a, b, capacity] : edges)
        cost += ((side >> a ^ side >> b) & 1) != 0 ? capacity : 0;
    return cost;
}

} // namespace

class TestSeparation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void maxFlowFindsTheSmallestCut_data()
    {
        QTest::addColumn<bool>("quickest");
        QTest::newRow("fewest at the sources") << false;
        QTest::newRow("quickest") << true;
    }

    void maxFlowFindsTheSmallestCut()
    {
        QFETCH(bool, quickest);
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
            // The second cut is made in what the first one leaves.
            for (const std::array<int, 4> ends : {std::array{0, 1, 7, 8}, std::array{2, 5, 6, 0}}) {
                const unsigned sources = 1u << ends[0] | 1u << ends[1];
                const unsigned sinks = 1u << ends[2] | 1u << ends[3];
                int best = std::numeric_limits<int>::max(), fewest = n;
                for (unsigned side = 0; side < 1u << n; ++side) {
                    if ((side & sources) != sources || (side & sinks) != 0)
                        continue;
                    const int cost = costOf(edges, side);
                    if (cost < best || (cost == best && std::popcount(side) < fewest))
                        fewest = std::popcount(side);
                    best = std::min(best, cost);
                }
                flow.setSource(ends[0]);
                flow.setSource(ends[1]);
                flow.setSink(ends[2]);
                flow.setSink(ends[3]);
                const auto found =
                    flow.run(quickest ? MaxFlow::Tie::Quickest : MaxFlow::Tie::FewestAtSources);
                QCOMPARE(found, std::int64_t(best));
                unsigned side = 0;
                for (int node = 0; node < n; ++node)
                    side |= flow.sourceSide()[node] ? 1u << node : 0;
                QVERIFY((side & sources) == sources && (side & sinks) == 0);
                QCOMPARE(costOf(edges, side), best);
                if (!quickest)
                    QCOMPARE(std::popcount(side), fewest);
                flow.removeCut();
                std::erase_if(
                    edges, [&](const auto &edge) { return ((side >> edge[0] ^ side >> edge[1]) & 1) != 0; });
            }
        }
    }

    //! The work depends on where the sources and sinks are, not on the size of the graph.
    void maxFlowStaysNearItsEnds()
    {
        const auto visits = [](int size) {
            MaxFlow flow(size * size);
            for (int y = 0; y < size; ++y) {
                for (int x = 0; x < size; ++x) {
                    if (x > 0)
                        flow.addEdge(size * y + x - 1, size * y + x, 4);
                    if (y > 0)
                        flow.addEdge(size * (y - 1) + x, size * y + x, 4);
                }
            }
            flow.setSource(size * (size / 2) + size / 2);
            flow.setSink(size * (size / 2) + size / 2 + 3);
            flow.run(MaxFlow::Tie::Quickest);
            return flow.visits();
        };
        QVERIFY(visits(20) > 20);
        QCOMPARE(visits(200), visits(20));
    }

    void cleanRegionIsMaximal_data() { mapNames(); }

    void cleanRegionIsMaximal()
    {
        QFETCH(int, index);
        const UncutMap map(index);
        const MeshData &mesh = *map.mesh;
        const std::vector<int> region = cleanRegion(mesh, map.soup, map.cut, map.seed);
        QVERIFY(std::binary_search(region.begin(), region.end(), map.seed));
        OverlapOptions options;
        options.totalArea = totalUvArea(map.soup);
        QCOMPARE(findOverlapsAmong(map.soup, region, options).pairs.size(), std::size_t(0));
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
            QVERIFY(!findOverlapsAmong(map.soup, larger, options).pairs.empty());
        }
    }

    void cleanHalfLeavesTheRestClean_data() { mapNames(); }

    void cleanHalfLeavesTheRestClean()
    {
        QFETCH(int, index);
        const UncutMap map(index);
        const MeshData &mesh = *map.mesh;
        const std::vector<int> half = cleanHalf(mesh, map.soup, map.cut, map.seed);
        OverlapOptions options;
        options.totalArea = totalUvArea(map.soup);
        QCOMPARE(half.empty(), !twoLayersSuffice(mesh, findOverlaps(map.soup, options).pairs));
        if (half.empty())
            return;
        QVERIFY(std::binary_search(half.begin(), half.end(), map.seed));
        std::vector<int> rest;
        for (int t = 0; t < mesh.triangleCount(); ++t) {
            if (!std::binary_search(half.begin(), half.end(), t))
                rest.push_back(t);
        }
        QCOMPARE(findOverlapsAmong(map.soup, half, options).pairs.size(), std::size_t(0));
        QCOMPARE(findOverlapsAmong(map.soup, rest, options).pairs.size(), std::size_t(0));
        const auto inside = [&](int t) { return std::binary_search(half.begin(), half.end(), t); };
        for (const EdgePair &pair : mesh.edgePairs)
            QVERIFY(!pair.diagonal || inside(pair.triangle[0]) == inside(pair.triangle[1]));
        const std::atomic<bool> cancel = true;
        options.job = &cancel;
        QVERIFY(cleanHalf(mesh, map.soup, map.cut, map.seed, options).empty());
    }

    void cleanHalfOfACleanChartIsAllOfIt()
    {
        const auto mesh = test::grid(4);
        const UvMatrix soup =
            soupUv(*mesh, test::mapped(*mesh, [](const Vec3 &p) { return Vec2(p.x(), p.y()); }));
        const std::vector<bool> cut(mesh->edgePairs.size(), false);
        QCOMPARE(cleanHalf(*mesh, soup, cut, 5).size(), std::size_t(mesh->triangleCount()));
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, cleanHalf(*mesh, UvMatrix(1, 2), {}, 0));
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
        const test::OverlappingMap map = test::overlappingMaps()[index];
        const MeshData &mesh = *map.mesh;
        const UvMatrix soup = soupUv(mesh, map.uv);
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
        const auto mesh = test::strip(60, 2, true);
        const UvMatrix uv = test::mapped(*mesh, test::along(
                                                    [](double s) {
                                                        return Vec2(std::cos(5 * std::numbers::pi * s),
                                                                    std::sin(5 * std::numbers::pi * s));
                                                    },
                                                    0.3));
        const SeparationResult result =
            separateOverlaps(*mesh, soupUv(*mesh, uv), std::vector<bool>(mesh->edgePairs.size(), false), {});
        QCOMPARE(chartCount(*mesh, result.cut), 3);
        QCOMPARE(result.newSeams, 4);
        QVERIFY(std::abs(result.newSeamLength - 4) < 1e-12);
    }

    void paintedEdgesAreAvoided()
    {
        // Two turns: a straight cut anywhere near the middle will do; only one place is cheap.
        const auto mesh = test::strip(48, 2, true);
        const UvMatrix uv = test::mapped(*mesh, test::along(
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
            *mesh, soupUv(*mesh, uv), std::vector<bool>(mesh->edgePairs.size(), false), {}, options);
        QCOMPARE(result.newSeams, 2);
        for (std::size_t p : cheap)
            QVERIFY(result.cut[p]);
    }

    void protectedPairsAreNeverCut()
    {
        const test::OverlappingMap map = test::overlappingMaps()[0];
        const MeshData &mesh = *map.mesh;
        const UvMatrix soup = soupUv(mesh, map.uv);
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

    void steeringHoldsWhereAMapIsSeparated()
    {
        // Two turns: a straight cut in many places will do.
        Snapshot snapshot;
        snapshot.mesh = test::strip(48, 2, true);
        const MeshData &mesh = *snapshot.mesh;
        const UvMatrix uv = test::mapped(mesh, test::along(
                                                   [](double s) {
                                                       return Vec2(std::cos(3 * std::numbers::pi * s),
                                                                   std::sin(3 * std::numbers::pi * s));
                                                   },
                                                   0.3));
        const std::set<int> plain = cutPairs(mesh, separateUv(snapshot, uv).charts);
        QCOMPARE(plain.size(), std::size_t(2));

        // The edges that would be cut are joined: another place it is. One side of an edge is enough.
        snapshot.editSteering().pairState.assign(2 * mesh.edgePairs.size(), PairState::Free);
        for (int pair : plain)
            snapshot.editSteering().pairState[2 * pair + 1] = PairState::Joined;
        const Separated elsewhere = separateUv(snapshot, uv);
        const std::set<int> other = cutPairs(mesh, elsewhere.charts);
        QCOMPARE(elsewhere.newSeams, 2);
        QCOMPARE(elsewhere.unresolvedPairs, 0);
        for (int pair : plain)
            QVERIFY(!other.contains(pair));

        // That place painted as cheap draws the cut without any joined edges.
        snapshot.editSteering().pairState.clear();
        snapshot.editSteering().pairWeight.assign(2 * mesh.edgePairs.size(), 1);
        for (int pair : other)
            snapshot.editSteering().pairWeight[2 * pair] = snapshot.editSteering().pairWeight[2 * pair + 1] =
                0.5;
        QCOMPARE(cutPairs(mesh, separateUv(snapshot, uv).charts), other);

        // All joined: nothing is cut, and the overlaps that stay are counted.
        snapshot.editSteering().pairState.assign(2 * mesh.edgePairs.size(), PairState::Joined);
        const Separated stuck = separateUv(snapshot, uv);
        QCOMPARE(stuck.newSeams, 0);
        QVERIFY(stuck.unresolvedPairs > 0);
    }

    void cleanMapsAndStackedIslandsStay()
    {
        // Two separate squares with the same UVs overlap, but they are different charts already.
        const auto two = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 0}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}});
        const UvMatrix uv =
            test::mapped(*two, [](const Vec3 &p) { return Vec2(p.x() > 2 ? p.x() - 3 : p.x(), p.y()); });
        const UvMatrix soup = soupUv(*two, uv);
        QCOMPARE(findOverlaps(soup).pairs.size(), std::size_t(2));
        const std::vector<bool> cut(two->edgePairs.size(), false);
        const SeparationResult result = separateOverlaps(*two, soup, cut, {});
        QCOMPARE(result.cut, cut);
        QCOMPARE(result.overlapPairs, std::int64_t(0));
    }

    void cancelledSeparationCutsNothing()
    {
        const test::OverlappingMap map = test::overlappingMaps()[0];
        const std::vector<bool> cut(map.mesh->edgePairs.size(), false);
        const std::atomic<bool> cancel{true};
        SeparationOptions options;
        options.job = &cancel;
        const SeparationResult result =
            separateOverlaps(*map.mesh, soupUv(*map.mesh, map.uv), cut, {}, options);
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
            QSKIP(test::noMeshes);
        const test::ObjUv obj = test::readObjUv(folder + "/" + file.toStdString());
        const MeshData &mesh = *obj.mesh;
        const UvMatrix uv =
            test::mapped(mesh, [](const Vec3 &p) { return Vec2(p.x() + 0.1 * p.z(), p.y() - 0.07 * p.z()); });
        const UvMatrix soup = soupUv(mesh, uv);
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
    //! Whether the polygons of a mesh can be told apart in two sets without overlaps.
    static bool twoLayersSuffice(const MeshData &mesh, const std::vector<OverlapPair> &overlaps)
    {
        // Every polygon once in either set: none may hang together with itself in the other.
        const int count = mesh.faceCount();
        UnionFind sets(2 * count);
        for (const OverlapPair &pair : overlaps) {
            const int a = mesh.triangleFace[pair.first], b = mesh.triangleFace[pair.second];
            if (a == b)
                continue;
            sets.unite(a, count + b);
            sets.unite(b, count + a);
        }
        for (int face = 0; face < count; ++face) {
            if (sets.find(face) == sets.find(count + face))
                return false;
        }
        return true;
    }

    //! The edge pairs between two charts.
    static std::set<int> cutPairs(const MeshData &mesh, const ChartMap &charts)
    {
        const auto chart = [&](int triangle) { return charts.faceChart[mesh.triangleFace[triangle]]; };
        std::set<int> result;
        for (std::size_t p = 0; p < mesh.edgePairs.size(); ++p) {
            const EdgePair &pair = mesh.edgePairs[p];
            if (chart(pair.triangle[0]) != chart(pair.triangle[1]))
                result.insert(static_cast<int>(p));
        }
        return result;
    }

    static void mapNames()
    {
        QTest::addColumn<int>("index");
        const auto maps = test::overlappingMaps();
        for (int i = 0; i < static_cast<int>(maps.size()); ++i)
            QTest::newRow(maps[i].name) << i;
    }
};

QTEST_APPLESS_MAIN(TestSeparation)

} // namespace tst_separation

#include "tst_separation.moc"
