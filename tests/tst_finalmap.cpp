// The final map of a live solve: within the bound, without folds and overlaps, and what the user decided
// holds.
#include "solver/definite/refinedmap.h"
#include "solver/definite/relaxing.h"
#include "solver/definite/seamgaps.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/liveschedule.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tst_finalmap {

using namespace autocuts;
using namespace autocuts::definite;
using namespace autocuts::homotopy;

namespace {

//! A live solve that has gone some way.
struct Solved : Solver
{
    explicit Solved(const Snapshot &given)
    {
        load(given);
        annealSoup(*this, {.lambda = 0.05, .stepsPerLevel = 15}, nullptr);
    }
};

Snapshot snapshotOf(const test::MeshPtr &mesh)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    return snapshot;
}

} // namespace

class TestFinalMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSearchImprovesWhatTheSolveLeft_data()
    {
        QTest::addColumn<test::MeshPtr>("mesh");
        QTest::newRow("sphere") << test::sphere(14, 18);
        QTest::newRow("quads") << test::quadCube();
        QTest::newRow("torus") << test::torus(16, 10);
        QTest::newRow("dirty") << test::dirty();
    }
    void theSearchImprovesWhatTheSolveLeft()
    {
        QFETCH(test::MeshPtr, mesh);
        const Solved solver(snapshotOf(mesh));
        const double bound = 4.2;
        const std::optional<DefiniteMap> made = makeDefiniteMap(solver, {.maxDistortion = bound});
        double progress = 0;
        const std::optional<RefinedMap> found =
            makeRefinedMap(solver, bound, {nullptr, 1, [&](const JobProgress &done) {
                                               QVERIFY(done.fraction >= progress && done.fraction <= 1);
                                               progress = done.fraction;
                                           }});
        QVERIFY(made && found);
        const SeamedMap *map = &found->map;
        QCOMPARE(map->validate(solver.soup()), std::string());
        QVERIFY(!coversItself(solver.soup(), *map));
        const bool madeFits = made->map.distortion(solver.soup()) <= bound;
        QVERIFY(!madeFits || map->distortion(solver.soup()) <= bound);
        if (madeFits)
            QVERIFY(map->seamLength(solver.soup()) <= made->map.seamLength(solver.soup()));
    }

    void chartsStayWhereTheyWere()
    {
        const Snapshot snapshot = snapshotOf(test::sphere(12, 16));
        Solved solver(snapshot);
        const auto middle = [](const std::vector<double> &x) {
            Vec2 sum = Vec2::Zero();
            for (std::size_t i = 0; i < x.size(); i += 2)
                sum += Vec2(x[i], x[i + 1]);
            return Vec2(2.0 / double(x.size()) * sum);
        };
        std::vector<double> moved = solver.coordinates();
        for (std::size_t i = 0; i < moved.size(); i += 2)
            moved[i] += 50;
        solver.setCoordinates(moved);
        const auto map = makeRefinedMap(solver, {});
        QVERIFY(map);
        QVERIFY((middle(map->map.x) - middle(moved)).norm() < 1e-6);
    }

    //! Two triangles of one size; pins want twice the area for the second one.
    void pinsDecideHowLargeIslandsAre()
    {
        Snapshot snapshot = snapshotOf(test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}));
        const std::array<Vec2, 3> places{Vec2(5, 0), Vec2(7.5, 0), Vec2(5, 2.5)};
        for (int k = 0; k < 3; ++k)
            snapshot.editSteering().pins.push_back({3 + k, places[k], true});
        const Solved solver(snapshot);
        const auto map = makeRefinedMap(solver, 5);
        QVERIFY(map);
        for (int k = 0; k < 3; ++k) {
            const Vec2 at(map->map.x[6 + 2 * static_cast<std::size_t>(k)],
                          map->map.x[7 + 2 * static_cast<std::size_t>(k)]);
            QVERIFY2((at - places[k]).norm() < 1e-12, qPrintable(QString::number((at - places[k]).norm())));
        }
    }

    void itDoesNotDependOnTheThreads()
    {
        const Solved solver(snapshotOf(test::sphere(8, 12)));
        const auto one = makeRefinedMap(solver, {}, {nullptr, 1});
        const auto two = makeRefinedMap(solver, {}, {nullptr, 2});
        QVERIFY(one && two);
        QVERIFY(one->map.cut == two->map.cut);
        QVERIFY(one->map.x == two->map.x);
    }

    void forcedCutsAndJoinsHold()
    {
        Snapshot snapshot = snapshotOf(test::sphere(12, 16));
        const MeshData &mesh = *snapshot.mesh;
        Steering &steering = snapshot.editSteering();
        steering.pairState.assign(mesh.cornerPairCount(), PairState::Free);
        const std::vector<int> cut{20, 21}, joined{100, 140};
        for (const int edge : cut)
            steering.pairState[2 * edge] = steering.pairState[2 * edge + 1] = PairState::Cut;
        for (const int edge : joined)
            steering.pairState[2 * edge] = steering.pairState[2 * edge + 1] = PairState::Joined;
        const Solved solver(snapshot);
        const auto map = makeRefinedMap(solver, 4.3);
        QVERIFY(map);
        for (const int edge : cut)
            QVERIFY(map->map.cut[edge]);
        for (const int edge : joined)
            QVERIFY(!map->map.cut[edge]);
    }

    void aPausedSolveIsTakenToItsEnd()
    {
        Snapshot snapshot = snapshotOf(test::sphere(12, 16));
        snapshot.settings.lambda = 0.05;
        snapshot.settings.delta = 0.25;
        Solver solver;
        solver.load(snapshot);
        for (int i = 0; i < 5; ++i)
            solver.step();
        const double bound = 4.2;
        int steps = 0;
        const std::atomic<bool> stop = true;
        QVERIFY(!runToTheEnd(solver, bound, &stop));
        QVERIFY(runToTheEnd(solver, bound, nullptr, [&] { ++steps; }));
        QVERIFY(steps > 50);
        QVERIFY(solver.snapshot().settings.lambda != 0.05);
        QCOMPARE(solver.snapshot().settings.delta, finalDelta(solver.soup()));
        const auto made = makeDefiniteMap(solver, {.maxDistortion = bound});
        QVERIFY(made && made->seedDistortion < bound + 0.1);
    }

    void joinedPolygonsThatCoverThemselvesAreUnfolded()
    {
        // Two squares side by side, spread so far about the corner that they share that their ends overlap.
        Snapshot snapshot =
            snapshotOf(test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}, {1, -1, 0}},
                                         {{0, 1, 2, 3}, {0, 4, 5, 1}}));
        const MeshData &mesh = *snapshot.mesh;
        snapshot.editSteering().pairState.assign(mesh.cornerPairCount(), PairState::Joined);
        const auto soup = Soup::build(snapshot.mesh);
        const double degrees[] = {0, 0, 100, 200, -200, -100};
        SeamedMap map;
        map.cut.assign(mesh.edgePairs.size(), false);
        for (int c = 0; c < mesh.soupCornerCount(); ++c) {
            const int vertex = mesh.cornerVertex[mesh.cornerOfSoup(c)];
            const double angle = degrees[vertex] * std::numbers::pi / 180;
            map.x.push_back(vertex == 0 ? 0 : std::cos(angle));
            map.x.push_back(vertex == 0 ? 0 : std::sin(angle));
        }
        QCOMPARE(map.validate(*soup), std::string());
        QVERIFY(coversItself(*soup, map));
        QVERIFY(removeOverlaps(*soup, snapshot, map, nullptr));
        QCOMPARE(map.validate(*soup), std::string());
        QVERIFY(!coversItself(*soup, map));
        QVERIFY(std::find(map.cut.begin(), map.cut.end(), true) == map.cut.end());
        QVERIFY(map.distortion(*soup) < 4.001);
    }

    //! A flat grid in one piece, cut into columns of 1, 2 and 3 quads that stay where they are.
    void seamsInOnePlaceAreOpened_data()
    {
        QTest::addColumn<bool>("pinned");
        QTest::newRow("the largest stays") << false;
        QTest::newRow("the pinned one stays") << true;
    }
    void seamsInOnePlaceAreOpened()
    {
        QFETCH(bool, pinned);
        Snapshot snapshot = snapshotOf(test::grid(6));
        const MeshData &mesh = *snapshot.mesh;
        const auto soup = Soup::build(snapshot.mesh);
        SeamedMap map;
        for (int c = 0; c < mesh.soupCornerCount(); ++c) {
            const auto place = mesh.positions.row(mesh.cornerVertex[mesh.cornerOfSoup(c)]);
            map.x.insert(map.x.end(), {place.x(), place.y()});
        }
        map.cut.assign(mesh.edgePairs.size(), false);
        const auto column = [&](int triangle) {
            const int x = mesh.triangleFace[triangle] % 6;
            return x < 1 ? 0 : x < 3 ? 1 : 2;
        };
        for (std::size_t e = 0; e < map.cut.size(); ++e)
            map.cut[e] = column(mesh.edgePairs[e].triangle[0]) != column(mesh.edgePairs[e].triangle[1]);
        QCOMPARE(findCharts(mesh, cornerUv(*soup, map)).count, 1);
        const int staying = pinned ? 0 : 2;
        if (pinned)
            snapshot.editSteering().pins.push_back({0, {map.x[0], map.x[1]}, true});
        SeamedMap opened = map;
        openSeams(*soup, snapshot, opened);
        QCOMPARE(findCharts(mesh, cornerUv(*soup, opened)).count, 3);
        QCOMPARE(opened.validate(*soup), std::string());
        for (int c = 0; c < mesh.soupCornerCount(); ++c) {
            const double moved =
                opened.x[2 * static_cast<std::size_t>(c)] - map.x[2 * static_cast<std::size_t>(c)];
            QVERIFY(moved >= 0 && moved < 0.01 * soup->meanEdgeLength);
            if (column(c / 3) == staying)
                QCOMPARE(moved, 0.);
        }
        const SeamedMap once = opened;
        openSeams(*soup, snapshot, opened);
        QVERIFY(opened.x == once.x);
    }

    void aHardPinIsReachedExactly()
    {
        Snapshot snapshot = snapshotOf(test::sphere(10, 12));
        const Vec2 place(7.3, -2.2);
        snapshot.editSteering().pins.push_back({0, place, true});
        const auto map = makeRefinedMap(Solved(snapshot), {});
        QVERIFY(map);
        QVERIFY(map->anchorFaults == 0);
        QCOMPARE(map->map.x[0], place.x());
        QCOMPARE(map->map.x[1], place.y());
        QCOMPARE(map->map.validate(*Soup::build(snapshot.mesh)), std::string());
    }

    void stoppedBeforeThereIsAMap()
    {
        const Solved solver(snapshotOf(test::sphere(10, 12)));
        const std::atomic<bool> stop = true;
        QVERIFY(!makeRefinedMap(solver, {}, &stop));
    }
};

QTEST_GUILESS_MAIN(TestFinalMap)

} // namespace tst_finalmap

#include "tst_finalmap.moc"
