// From the soup to a map with definite seams: what is merged, what is cut, and the figures of the result.
#include "solver/definite/definitemap.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/solver.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>
#include <memory>

namespace tst_finish {

using namespace autocuts;
using namespace autocuts::definite;
using namespace autocuts::homotopy;
using namespace autocuts::metrics;

namespace {

void addMeshes()
{
    QTest::addColumn<int>("steps"); // per level of the homotopy; few steps leave more to repair
    for (const char *name : {"triangle", "cube", "quad cube", "sphere", "torus", "grid", "dirty"}) {
        for (const int steps : {1, 5, 20})
            QTest::addRow("%s %d", name, steps) << steps;
    }
}

test::MeshPtr currentMesh()
{
    const QString tag = QString::fromLatin1(QTest::currentDataTag());
    return test::meshNamed(tag.left(tag.lastIndexOf(QLatin1Char(' '))));
}

//! A solver after a run of the homotopy, short or long.
std::unique_ptr<Solver> annealed(const test::MeshPtr &mesh, int steps, std::vector<PairState> states = {})
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.delta = 1;
    snapshot.editSteering().pairState = std::move(states);
    auto solver = std::make_unique<Solver>();
    solver->load(snapshot);
    AnnealOptions options;
    options.stepsPerLevel = steps;
    annealSoup(*solver, options, nullptr);
    return solver;
}

int edgeBetween(const MeshData &mesh, int a, int b)
{
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const int v = mesh.vertexOfSoup(mesh.edgePairs[e].corner[0][0]);
        const int w = mesh.vertexOfSoup(mesh.edgePairs[e].corner[1][0]);
        if ((v == a && w == b) || (v == b && w == a))
            return static_cast<int>(e);
    }
    return -1;
}

std::vector<PairState> statesOf(const MeshData &mesh, const std::vector<int> &edges, PairState state)
{
    std::vector<PairState> states(mesh.cornerPairCount(), PairState::Free);
    for (const int e : edges)
        states[2 * e] = states[2 * e + 1] = state;
    return states;
}

//! True when the two sides of an edge pair coincide at both ends.
bool isClosed(const MeshData &mesh, const SeamedMap &map, int e)
{
    for (int end = 0; end < 2; ++end) {
        const auto [a, b] = mesh.edgePairs[e].corner[end];
        if (map.x[2 * a] != map.x[2 * b] || map.x[2 * a + 1] != map.x[2 * b + 1])
            return false;
    }
    return true;
}

} // namespace

class TestFinish : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void finishedMapsAreValid_data() { addMeshes(); }
    void finishedMapsAreValid()
    {
        QFETCH(int, steps);
        const auto solver = annealed(currentMesh(), steps);
        SeamedMap map = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates());
        QCOMPARE(map.validate(solver->soup()), std::string());
        relaxMap(solver->sharedSoup(), solver->snapshot(), map, 20);
        QCOMPARE(map.validate(solver->soup()), std::string());
    }

    void figuresAreTheMeasuredOnes_data() { addMeshes(); }
    void figuresAreTheMeasuredOnes()
    {
        QFETCH(int, steps);
        const auto solver = annealed(currentMesh(), steps);
        const SeamedMap map = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates());
        const MeshData &mesh = *solver->soup().mesh;
        const UvMetrics measured = measureUv(mesh, cornerUv(solver->soup(), map));
        QCOMPARE(measured.flipped, 0);
        const double distortion = map.distortion(solver->soup());
        QVERIFY2(std::abs(distortion - measured.symDirichlet) <= 1e-9 * distortion,
                 qPrintable(QStringLiteral("%1 %2").arg(distortion, 0, 'g', 15).arg(measured.symDirichlet)));
        // On a non-manifold edge the measure counts other sides; there the figures may differ.
        if (measured.nonManifoldEdges == 0 && mesh.report.windingEdges == 0) {
            const double seam = map.seamLength(solver->soup());
            QVERIFY2(std::abs(seam - measured.seamNorm) <= 1e-9 * (1 + seam),
                     qPrintable(QStringLiteral("%1 %2").arg(seam, 0, 'g', 15).arg(measured.seamNorm)));
        }
    }

    void relaxingNeverRaisesTheDistortion_data() { addMeshes(); }
    void relaxingNeverRaisesTheDistortion()
    {
        QFETCH(int, steps);
        const auto solver = annealed(currentMesh(), steps);
        SeamedMap map = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates());
        const CutFlags cut = map.cut;
        double before = map.distortion(solver->soup());
        for (int round = 0; round < 3; ++round) {
            relaxMap(solver->sharedSoup(), solver->snapshot(), map, 5);
            const double after = map.distortion(solver->soup());
            QVERIFY2(after <= before * (1 + 1e-6),
                     qPrintable(QStringLiteral("%1 -> %2").arg(before, 0, 'g', 15).arg(after, 0, 'g', 15)));
            before = after;
        }
        QVERIFY(map.cut == cut);
    }

    void joinedEdgesAreMerged()
    {
        // Two edges of a quad cube that share no vertex.
        const auto mesh = test::quadCube();
        const std::vector<int> edges{edgeBetween(*mesh, 0, 1), edgeBetween(*mesh, 6, 7)};
        for (const int steps : {1, 10}) {
            const auto solver = annealed(mesh, steps, statesOf(*mesh, edges, PairState::Joined));
            const SeamedMap map = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates());
            for (const int e : edges) {
                QVERIFY(!map.cut[e]);
                QVERIFY(isClosed(*mesh, map, e));
            }
        }
    }

    void aForcedRingIsCut()
    {
        // The border of the upper face (z = 1) of a quad cube.
        const auto mesh = test::quadCube();
        const std::vector<int> ring{edgeBetween(*mesh, 4, 5), edgeBetween(*mesh, 5, 6),
                                    edgeBetween(*mesh, 6, 7), edgeBetween(*mesh, 7, 4)};
        const auto solver = annealed(mesh, 10, statesOf(*mesh, ring, PairState::Cut));
        const SeamedMap map = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates());
        for (const int e : ring)
            QVERIFY(map.cut[e]);
        const CutMesh state(*mesh, map.cut);
        QVERIFY(state.chartCount >= 2);
    }

    void closingKeepsTheGivenCuts()
    {
        // A grid that is flat in the map already: closed along one line and cut along another.
        const auto mesh = test::grid(4);
        Snapshot snapshot;
        snapshot.mesh = mesh;
        const auto soup = Soup::build(mesh);
        CutFlags cut(mesh->edgePairs.size(), false);
        for (int row = 0; row < 4; ++row)
            cut[edgeBetween(*mesh, 5 * row + 2, 5 * row + 7)] = true; // column 2, from border to border
        std::vector<double> x(soup->coordinateCount());
        for (int c = 0; c < mesh->soupCornerCount(); ++c) {
            const Vec3 p = mesh->cornerPosition(mesh->cornerOfSoup(c)) * soup->scale;
            const double noise = 0.01 * std::sin(7.0 * c);
            x[2 * c] = p.x() + noise;
            x[2 * c + 1] = p.y() - noise;
        }
        const SeamedMap map = stitchTo(soup, snapshot, cut, x);
        QCOMPARE(map.validate(*soup), std::string());
        QVERIFY(map.cut == cut);
        QCOMPARE(CutMesh(*mesh, map.cut).chartCount, 2);
        QVERIFY(std::abs(map.seamLength(*soup) - soup->scale) < 1e-12); // the line is as long as the square
    }

    void whatCannotCloseStaysCut()
    {
        // A closed sphere has no map to the plane: something must stay apart.
        const auto mesh = test::sphere(6, 8);
        Snapshot snapshot;
        snapshot.mesh = mesh;
        const auto soup = Soup::build(mesh);
        std::vector<double> x;
        for (const auto &shape : soup->restShape)
            x.insert(x.end(), shape.begin(), shape.end());
        const SeamedMap map = stitchTo(soup, snapshot, CutFlags(mesh->edgePairs.size(), false), x);
        QCOMPARE(map.validate(*soup), std::string());
        QVERIFY(map.seamLength(*soup) > 0);
    }

    void brokenMapsAreFound()
    {
        const auto solver = annealed(test::quadCube(), 10);
        const SeamedMap good = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates());
        const Soup &soup = solver->soup();
        const auto &pairs = soup.mesh->edgePairs;
        QCOMPARE(good.validate(soup), std::string());

        SeamedMap map = good;
        map.x.pop_back();
        QCOMPARE(map.validate(soup), std::string("the map does not fit the mesh"));
        map = good;
        for (std::size_t e = 0; e < pairs.size(); ++e) {
            if (pairs[e].diagonal)
                map.cut[e] = true;
        }
        QCOMPARE(map.validate(soup), std::string("a polygon is split"));
        map = good;
        for (std::size_t e = 0; e < pairs.size(); ++e) {
            if (pairs[e].diagonal)
                map.x[2 * pairs[e].corner[0][0]] += 1e-9;
        }
        QCOMPARE(map.validate(soup), std::string("two corners of one UV vertex are apart"));
        map = good;
        for (std::size_t c = 0; c < map.x.size(); c += 2)
            map.x[c] = -map.x[c];
        QCOMPARE(map.validate(soup), std::string("a triangle is flipped or has no area"));
        map = good;
        map.x[0] = std::nan("");
        QVERIFY(!map.validate(soup).empty());
    }

    void cancellingStillGivesAValidMap()
    {
        const std::atomic<bool> cancel = true;
        const auto solver = annealed(test::torus(8, 6), 2);
        SeamedMap map = stitchSoup(solver->sharedSoup(), solver->snapshot(), solver->coordinates(), &cancel);
        QCOMPARE(map.validate(solver->soup()), std::string());
        QCOMPARE(relaxMap(solver->sharedSoup(), solver->snapshot(), map, 5, &cancel), 0);
    }
};

QTEST_APPLESS_MAIN(TestFinish)

} // namespace tst_finish

#include "tst_finish.moc"
