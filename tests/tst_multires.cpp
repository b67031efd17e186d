// Coarse meshes and the way back: collapses and their undoing, maps carried from a coarse mesh to the fine
// one.
#include "solver/base/cornerat.h"
#include "solver/base/random.h"
#include "solver/definite/relaxing.h"
#include "solver/multires/edgecollapses.h"
#include "solver/multires/maprefiner.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace tst_multires {

using namespace autocuts;
using namespace autocuts::definite;
using namespace autocuts::multires;
using namespace autocuts::unwrap;

namespace {

test::MeshPtr meshCalled(const QString &name)
{
    if (name == QLatin1String("sphere"))
        return test::sphere(24, 30);
    if (name == QLatin1String("torus"))
        return test::torus(30, 16);
    if (name == QLatin1String("large sphere"))
        return test::sphere(80, 90);
    if (name == QLatin1String("grid"))
        return test::grid(20, 0.4);
    if (name == QLatin1String("dirty"))
        return test::dirty();
    return test::cube();
}

//! The mesh with each triangle as a face of its own.
test::MeshPtr triangulated(const MeshData &mesh)
{
    std::vector<int> start{0}, vertex;
    for (const std::array<int, 3> &triangle : mesh.triangles) {
        for (const int corner : triangle)
            vertex.push_back(mesh.cornerVertex[corner]);
        start.push_back(static_cast<int>(vertex.size()));
    }
    return MeshData::build(mesh.positions, start, vertex, std::vector<int>(mesh.triangleCount(), 0));
}

void addMeshes()
{
    QTest::addColumn<QString>("mesh");
    for (const char *name : {"sphere", "torus", "grid", "dirty", "cube"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

//! Everything that tells two states of a progressive mesh apart.
std::vector<int> stateOf(const ProgressiveMesh &mesh, int triangles)
{
    std::vector<int> state;
    for (int t = 0; t < triangles; ++t) {
        state.push_back(mesh.isAlive(t));
        for (int side = 3 * t; mesh.isAlive(t) && side < 3 * t + 3; ++side)
            state.insert(state.end(), {mesh.point(side), mesh.across(side)});
    }
    return state;
}

//! Whether neighbours know each other and share the ends of the side between them.
bool isWhole(const ProgressiveMesh &mesh, int triangles)
{
    const auto ends = [&](int side) -> std::pair<int, int> {
        return std::minmax(mesh.point(side), mesh.point(ProgressiveMesh::next(side)));
    };
    for (int side = 0; side < 3 * triangles; ++side) {
        const int other = mesh.isAlive(side / 3) ? mesh.across(side) : -1;
        if (other >= 0 &&
            (!mesh.isAlive(other / 3) || mesh.across(other) != side || ends(other) != ends(side)))
            return false;
    }
    return true;
}

//! A flat hexagon around point 6. Nothing but point 6 may be collapsed.
struct Hexagon
{
    std::vector<Vec3> position;
    std::vector<int> point, across;
    std::vector<bool> alive, locked;

    Hexagon()
    {
        for (int i = 0; i < 6; ++i) {
            position.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0);
            add(6, i, (i + 1) % 6);
            across[3 * i] = 3 * ((i + 5) % 6) + 2;
            across[3 * i + 2] = 3 * ((i + 1) % 6);
        }
        position.emplace_back(0.1, 0, 0);
        locked.assign(7, true);
        locked[6] = false;
    }
    void add(int a, int b, int c)
    {
        point.insert(point.end(), {a, b, c});
        across.insert(across.end(), 3, -1);
        alive.push_back(true);
    }
    std::vector<HalfEdgeCollapse> collapses() const
    {
        return edgeCollapses({position, point, across, alive, locked}, 1);
    }
};

CoarseSearch draft(int coarseTriangles)
{
    CoarseSearch search;
    search.triangles = coarseTriangles;
    search.find = [](const Snapshot &snapshot, const UnwrapOptions &options, const PrepareMap &) {
        const UnwrapResult result = unwrapMesh(snapshot, options);
        Candidate found;
        found.map = seamedMapOf(*Soup::build(snapshot.mesh), result.uv, result.cut).value();
        found.lambda = result.lambda;
        found.delta = result.delta;
        return std::optional(found);
    };
    return search;
}

std::optional<Candidate> carried(const Snapshot &snapshot, const std::shared_ptr<const Soup> &soup,
                                 int coarseTriangles = 400)
{
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    return mapByCoarse(soup, snapshot, options, draft(coarseTriangles), {});
}

} // namespace

class TestMultires : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void collapsesCanBeTakenBack_data() { addMeshes(); }
    void collapsesCanBeTakenBack()
    {
        QFETCH(QString, mesh);
        const auto data = meshCalled(mesh);
        ProgressiveMesh progressive(*data, {});
        std::vector<std::vector<int>> states{stateOf(progressive, data->triangleCount())};
        const int full = progressive.triangleCount();
        for (int goal = full - 1; goal > 4; goal = goal * 2 / 3) {
            progressive.coarsen(goal);
            QVERIFY(isWhole(progressive, full));
            if (progressive.triangleCount() > goal)
                break;
        }
        while (!progressive.collapses().empty())
            progressive.refine();
        QCOMPARE(progressive.triangleCount(), full);
        QCOMPARE(stateOf(progressive, full), states[0]);
    }

    void coarseMeshesKeepTheTopology_data()
    {
        QTest::addColumn<QString>("mesh");
        for (const char *name : {"sphere", "torus", "grid"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void coarseMeshesKeepTheTopology()
    {
        QFETCH(QString, mesh);
        const auto fine = meshCalled(mesh);
        ProgressiveMesh progressive(*fine, {});
        const int goal = fine->triangleCount() / 4;
        progressive.coarsen(goal);
        QVERIFY(progressive.triangleCount() <= goal);
        QVERIFY(progressive.triangleCount() >= goal - 2);
        std::vector<int> triangles;
        const auto coarse = progressive.extract(triangles);
        QCOMPARE(coarse->validate(), std::string());
        QCOMPARE(coarse->triangleCount(), static_cast<int>(triangles.size()));
        QCOMPARE(coarse->componentCount, fine->componentCount);
        const auto euler = [](const MeshData &m) {
            const int sides = static_cast<int>(m.edgePairs.size() + m.boundarySides.size());
            return CutMesh(m, CutFlags(m.edgePairs.size())).uvVertexCount - sides + m.triangleCount();
        };
        QCOMPARE(euler(*coarse), euler(*fine));
        QVERIFY(std::abs(coarse->area / fine->area - 1) < 0.06);
        QCOMPARE(coarse->boundarySides.empty(), fine->boundarySides.empty());
        // The sides that the coarse mesh pairs are those that the progressive mesh has next to each other.
        for (const EdgePair &pair : coarse->edgePairs) {
            const int a = 3 * triangles[pair.triangle[0]] + pair.side(0);
            QCOMPARE(progressive.across(a), 3 * triangles[pair.triangle[1]] + pair.side(1));
        }
    }

    void pointsInsideAreCollapsed()
    {
        const auto collapses = Hexagon().collapses();
        QCOMPARE(collapses.size(), std::size_t(1));
        QCOMPARE(collapses[0].removed, 6);
        QCOMPARE(collapses[0].kept, 0); // the nearest
    }

    void whatIsNoHalfEdgeMeshStays_data()
    {
        QTest::addColumn<QString>("fault");
        for (const char *fault : {"degenerate", "doubled", "turned over", "torn"})
            QTest::newRow(fault) << QString::fromLatin1(fault);
    }
    void whatIsNoHalfEdgeMeshStays()
    {
        QFETCH(QString, fault);
        Hexagon hexagon;
        if (fault == QLatin1String("degenerate"))
            hexagon.add(6, 6, 2);
        else if (fault == QLatin1String("doubled"))
            hexagon.add(6, 2, 3);
        else if (fault == QLatin1String("turned over"))
            std::swap(hexagon.point[7], hexagon.point[8]);
        else
            hexagon.across[0] = hexagon.across[17] = -1; // at the same place, yet not next to each other
        QVERIFY(hexagon.collapses().empty());
    }

    void lockedEdgesStay()
    {
        const auto fine = test::sphere(16, 20);
        std::vector<bool> locked(fine->edgePairs.size(), false);
        for (std::size_t e = 0; e < locked.size(); e += 97)
            locked[e] = true;
        ProgressiveMesh progressive(*fine, locked);
        std::set<std::pair<int, int>> wanted, found;
        for (std::size_t e = 0; e < locked.size(); e += 97)
            wanted.insert(std::minmax(progressive.point(fine->edgePairs[e].corner[0][0]),
                                      progressive.point(fine->edgePairs[e].corner[1][0])));
        progressive.coarsen(120);
        for (int side = 0; side < fine->soupCornerCount(); ++side) {
            if (progressive.isAlive(side / 3))
                found.insert(
                    std::minmax(progressive.point(side), progressive.point(ProgressiveMesh::next(side))));
        }
        for (const auto &edge : wanted)
            QVERIFY(found.contains(edge));
    }

    void mapsAreCarriedToTheFineMesh_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<int>("coarseTriangles");
        for (const char *name : {"sphere", "torus", "grid"})
            QTest::newRow(name) << QString::fromLatin1(name) << 400;
        // So large that its triangles have another order than its faces.
        QTest::newRow("large sphere") << QStringLiteral("large sphere") << 5000;
    }
    void mapsAreCarriedToTheFineMesh()
    {
        QFETCH(QString, mesh);
        QFETCH(int, coarseTriangles);
        Snapshot snapshot;
        snapshot.mesh = meshCalled(mesh);
        const auto soup = Soup::build(snapshot.mesh);
        const auto map = carried(snapshot, soup, coarseTriangles);
        QVERIFY(map);
        QCOMPARE(map->map.validate(*soup), std::string());
        QVERIFY(!coversItself(*soup, map->map));
        const double distortion = map->map.distortion(*soup);
        QVERIFY2(distortion <= 4.1, qPrintable(QString::number(distortion)));
        const auto again = carried(snapshot, soup, coarseTriangles);
        QVERIFY(again->map.x == map->map.x);
        QVERIFY(again->map.cut == map->map.cut);
    }

    void theBoundIsMetOnNoisySurfaces()
    {
        // The coarse version of such a surface is smoother: its map misses the bound on the fine mesh.
        Random random(5);
        const auto ball = test::sphere(50, 70);
        PositionMatrix positions = ball->positions;
        for (Eigen::Index v = 0; v < positions.rows(); ++v)
            positions.row(v) *= 1 + 0.08 * random.uniform();
        Snapshot snapshot;
        snapshot.mesh = MeshData::build(positions, ball->faceStart, ball->cornerVertex, ball->faceObject);
        const auto soup = Soup::build(snapshot.mesh);
        const auto map = carried(snapshot, soup, 1000);
        QVERIFY(map);
        QCOMPARE(map->map.validate(*soup), std::string());
        QVERIFY(!coversItself(*soup, map->map));
        const double distortion = map->map.distortion(*soup);
        QVERIFY2(distortion <= 4.1, qPrintable(QString::number(distortion)));
    }

    //! Seams in standard, and what is prepared on the way.
    void seamsAreSearchedOnTheFineMesh()
    {
        Snapshot snapshot;
        snapshot.mesh = meshCalled(QStringLiteral("torus"));
        const auto soup = Soup::build(snapshot.mesh);
        UnwrapOptions options;
        CoarseSearch search = draft(400);
        const auto find = search.find;
        search.find = [&](const Snapshot &coarse, UnwrapOptions how, const PrepareMap &prepare) {
            how.quality = UnwrapQuality::Draft;
            std::optional<Candidate> found = find(coarse, how, prepare);
            found->measure(*Soup::build(coarse.mesh), coarse);
            prepare([found](const JobContext &) { return found; });
            return found;
        };
        std::vector<MakeMap> prepared;
        const auto standard = mapByCoarse(soup, snapshot, options, search,
                                          [&](MakeMap make) { prepared.push_back(std::move(make)); });
        QVERIFY(standard);
        options.quality = UnwrapQuality::Draft;
        const auto carried = mapByCoarse(soup, snapshot, options, search, [](const MakeMap &) {});
        QVERIFY(carried);
        const auto measured = [&](Candidate found) {
            found.measure(*soup, snapshot);
            return found;
        };
        const Candidate best = measured(*standard), hurried = measured(*carried);
        QVERIFY2(best.seamLength < 0.95 * hurried.seamLength,
                 qPrintable(QString::number(best.seamLength / hurried.seamLength)));
        QVERIFY2(best.distortion > 4.098 && best.distortion <= 4.1,
                 qPrintable(QString::number(best.distortion)));
        // Of the coarse mesh, while its map is relaxed, and of the search on the fine mesh.
        QVERIFY2(prepared.size() > 5, qPrintable(QString::number(prepared.size())));
        double last = 0;
        for (const MakeMap &make : prepared) {
            const std::optional<Candidate> made = make({});
            QVERIFY(made);
            QCOMPARE(made->map.validate(*soup), std::string());
            QVERIFY(!coversItself(*soup, made->map));
            last = made->seamLength;
        }
        QVERIFY(last < hurried.seamLength);
    }

    void stretchThatIsLeftOverIsSpent()
    {
        Snapshot snapshot;
        snapshot.mesh = meshCalled(QStringLiteral("sphere"));
        const auto soup = Soup::build(snapshot.mesh);
        CoarseSearch search = draft(400);
        const auto find = search.find;
        search.find = [&](const Snapshot &coarse, UnwrapOptions options, const PrepareMap &prepare) {
            options.maxDistortion = 4.02;
            return find(coarse, options, prepare);
        };
        UnwrapOptions options;
        options.quality = UnwrapQuality::Draft;
        const auto map = mapByCoarse(soup, snapshot, options, search, {});
        QVERIFY(map);
        const double distortion = map->map.distortion(*soup);
        QVERIFY2(distortion > 4.06 && distortion <= 4.1, qPrintable(QString::number(distortion)));
    }

    void trianglesWithoutAPlaceBecomeCharts()
    {
        Snapshot snapshot;
        snapshot.mesh = triangulated(*meshCalled(QStringLiteral("grid")));
        const auto soup = Soup::build(snapshot.mesh);
        CoarseSearch search = draft(400);
        search.find = [find = search.find](const Snapshot &coarse, const UnwrapOptions &options,
                                           const PrepareMap &prepare) {
            std::optional<Candidate> map = find(coarse, options, prepare);
            // Presses a triangle flat: moves the corners at one of its points onto the opposite side, all
            // but.
            const int triangles = coarse.mesh->triangleCount();
            for (int t = 0; t < triangles; ++t) {
                SeamedMap pressed = map->map;
                const Vec2 tip = cornerAt(pressed.x, 3 * t);
                const Vec2 foot = 0.5 * (cornerAt(pressed.x, 3 * t + 1) + cornerAt(pressed.x, 3 * t + 2));
                for (int c = 0; c < 3 * triangles; ++c) {
                    if (cornerAt(pressed.x, c) == tip)
                        cornerAt(pressed.x, c) = foot + 1e-12 * (tip - foot);
                }
                if (pressed.validate(*Soup::build(coarse.mesh)).empty()) {
                    map->map = pressed;
                    break;
                }
            }
            return map;
        };
        UnwrapOptions options;
        options.quality = UnwrapQuality::Draft;
        options.lambda = 0.1; // with a bound, the last search joins what it can
        const auto map = mapByCoarse(soup, snapshot, options, search, {});
        QVERIFY(map);
        QCOMPARE(map->map.validate(*soup), std::string());
        QVERIFY(!coversItself(*soup, map->map));
        const auto chartsOf = [&](const Candidate &found) {
            return CutMesh(*snapshot.mesh, found.map.cut).chartCount;
        };
        QVERIFY(chartsOf(*map) > chartsOf(*mapByCoarse(soup, snapshot, options, draft(400), {})));
        options.lambda.reset();
        const auto bounded = mapByCoarse(soup, snapshot, options, search, {});
        QVERIFY(bounded);
        QCOMPARE(bounded->map.validate(*soup), std::string());
        const double distortion = bounded->map.distortion(*soup);
        QVERIFY2(distortion <= 4.1, qPrintable(QString::number(distortion)));
    }

    void whatTheUserCutIsCut()
    {
        Snapshot snapshot;
        snapshot.mesh = meshCalled(QStringLiteral("sphere"));
        const MeshData &mesh = *snapshot.mesh;
        Steering &steering = snapshot.editSteering();
        steering.pairState.assign(mesh.cornerPairCount(), PairState::Free);
        const std::size_t edge = mesh.edgePairs.size() / 2;
        steering.pairState[2 * edge] = steering.pairState[2 * edge + 1] = PairState::Cut;
        const auto soup = Soup::build(snapshot.mesh);
        const auto map = carried(snapshot, soup);
        QVERIFY(map);
        QVERIFY(map->map.cut[edge]);
        QCOMPARE(map->map.validate(*soup), std::string());
    }

    void meshesThatCannotBeCoarserAreLeftAlone()
    {
        Snapshot snapshot;
        snapshot.mesh = test::cube();
        QVERIFY(!carried(snapshot, Soup::build(snapshot.mesh)));
    }

    void meshesThatSuit_data()
    {
        QTest::addColumn<int>("side");
        QTest::addColumn<int>("change");
        QTest::addColumn<bool>("inDraft");
        QTest::addColumn<bool>("inStandard");
        QTest::newRow("small") << 38 << 0 << false << false; // 2,888 triangles
        QTest::newRow("medium") << 40 << 0 << false << true;
        QTest::newRow("for drafts") << 75 << 0 << true << true; // 11,250 triangles
        // The flat faces of hard surface would bend.
        QTest::newRow("hard surface") << 75 << 1 << false << false;
        QTest::newRow("existing UVs") << 75 << 2 << false << false;
        QTest::newRow("pins") << 75 << 3 << true << false;
        QTest::newRow("given seams") << 75 << 4 << true << false;
        QTest::newRow("lambda") << 75 << 5 << false << false;
        QTest::newRow("coarse version") << 40 << 6 << true << true;
        QTest::newRow("large") << 120 << 1 << true << true; // 28,800 triangles
    }
    void meshesThatSuit()
    {
        QFETCH(int, side);
        QFETCH(int, change);
        Snapshot snapshot;
        snapshot.mesh = test::grid(side);
        snapshot.settings.surface = change == 1 ? SurfaceKind::HardSurface : SurfaceKind::Organic;
        if (change == 2)
            snapshot.settings.start = StartMode::ExistingUv;
        if (change == 3)
            snapshot.editSteering().pins.emplace_back();
        if (change == 4)
            snapshot.settings.seams = SeamMode::Keep;
        UnwrapOptions options;
        if (change == 5)
            options.lambda = 0.1;
        options.coarse = change == 6;
        QTEST(suitsCoarseToFine(snapshot, options), "inStandard");
        options.quality = UnwrapQuality::Draft;
        QTEST(suitsCoarseToFine(snapshot, options), "inDraft");
    }

    void coarseVersionsAreAFifth()
    {
        Snapshot snapshot;
        snapshot.mesh = test::grid(120);
        snapshot.settings.surface = SurfaceKind::Organic;
        QCOMPARE(coarseTriangles(snapshot), 5760);
        snapshot.mesh = test::grid(150);
        QCOMPARE(coarseTriangles(snapshot), 9000);
        snapshot.settings.surface = SurfaceKind::HardSurface;
        QCOMPARE(coarseTriangles(snapshot), 6000); // it is searched as it is
        snapshot.mesh = test::grid(40);
        QCOMPARE(coarseTriangles(snapshot), 1500);
    }
};

QTEST_APPLESS_MAIN(TestMultires)

} // namespace tst_multires

#include "tst_multires.moc"
