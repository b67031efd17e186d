// The first maps of surfaces of many handles and borders: clusters of triangles that face alike.
#include "solver/definite/relaxing.h"
#include "solver/search/chartclusters.h"
#include "solver/search/firstclusters.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"
#include "support/props.h"

#include <QTest>

#include <algorithm>
#include <array>

namespace tst_firstclusters {

using namespace autocuts;
using namespace autocuts::search;

namespace {

//! A plate of n by n cells, of which every second one of every second row is a hole: n / 2 squared handles.
test::props::Model perforatedPlate(int n, double thickness = 0.3)
{
    test::props::Model plate;
    const auto isHole = [n](int i, int j) {
        return i < 0 || j < 0 || i >= n || j >= n || (i % 2 == 1 && j % 2 == 1);
    };
    const auto point = [n](int i, int j, bool top) { return 2 * (i * (n + 1) + j) + top; };
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            plate.points.emplace_back(i, j, 0);
            plate.points.emplace_back(i, j, thickness);
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            if (isHole(i, j))
                continue;
            const std::array<std::array<int, 2>, 4> corner{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
            const std::array<std::array<int, 2>, 4> beside{{{i, j - 1}, {i + 1, j}, {i, j + 1}, {i - 1, j}}};
            std::vector<int> top, bottom;
            for (const auto &[a, b] : corner) {
                top.push_back(point(a, b, true));
                bottom.insert(bottom.begin(), point(a, b, false));
            }
            plate.faces.push_back(top);
            plate.faces.push_back(bottom);
            for (int k = 0; k < 4; ++k) {
                if (!isHole(beside[k][0], beside[k][1]))
                    continue;
                const auto &a = corner[k], &b = corner[(k + 1) % 4];
                plate.faces.push_back({point(a[0], a[1], false), point(b[0], b[1], false),
                                       point(b[0], b[1], true), point(a[0], a[1], true)});
            }
        }
    }
    return plate;
}

test::props::Model tetrahedron(const Vec3 &at, double size)
{
    test::props::Model model;
    model.points = {at, at + size * Vec3::UnitX(), at + size * Vec3::UnitY(), at + size * Vec3::UnitZ()};
    model.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return model;
}

//! Two boxes that touch in one edge, at which four faces meet.
test::MeshPtr touchingBoxes()
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    const auto indexOf = [&](const Vec3 &p) {
        const auto found = std::find_if(points.begin(), points.end(), [&](const Vec3 &q) { return p == q; });
        if (found != points.end())
            return static_cast<int>(found - points.begin());
        points.push_back(p);
        return static_cast<int>(points.size()) - 1;
    };
    for (const double shift : {0.0, 1.0}) {
        const test::props::Model box = test::props::box({shift, shift, 0}, {1, 1, 1});
        for (const std::vector<int> &face : box.faces) {
            faces.emplace_back();
            for (const int p : face)
                faces.back().push_back(indexOf(box.points[p]));
        }
    }
    return test::polygonMesh(points, faces);
}

test::MeshPtr meshOf(const QString &name)
{
    if (name == QLatin1String("plate"))
        return perforatedPlate(7).mesh();
    if (name == QLatin1String("touching boxes"))
        return touchingBoxes();
    if (name == QLatin1String("tube"))
        return test::props::tube({{0, 0}, {3, 0}, {6, 1}}, 0.2, 8).mesh();
    test::props::Model model = perforatedPlate(5);
    model.add(tetrahedron({10, 0, 0}, 0.01));
    return model.mesh();
}

Snapshot snapshotOf(test::MeshPtr mesh)
{
    Snapshot snapshot;
    snapshot.mesh = std::move(mesh);
    return snapshot;
}

std::shared_ptr<const SeamGraph> graphOf(const Snapshot &snapshot)
{
    return SeamGraph::build(Soup::build(snapshot.mesh), snapshot);
}

int clustersOf(const Snapshot &snapshot, double spread)
{
    const auto graph = graphOf(snapshot);
    return CutMesh(*snapshot.mesh, clusterSeams(*graph, std::vector<double>(graph->triangleCount(), spread)))
        .chartCount;
}

} // namespace

class TestFirstClusters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sidesOfABox()
    {
        const Snapshot cube = snapshotOf(test::quadCube());
        QCOMPARE(clustersOf(cube, 1e-6), 6);
        QCOMPARE(clustersOf(cube, 100), 1);
    }

    void aPlateHasTwoSides()
    {
        // Its thin walls are too small for charts, so they belong to the sides.
        const Snapshot plate = snapshotOf(perforatedPlate(9, 0.01).mesh());
        QCOMPARE(clustersOf(plate, 0.02), 2);
    }

    void userCutsAndJoinsHold()
    {
        Snapshot cube = snapshotOf(test::quadCube());
        std::vector<PairState> &states = cube.editSteering().pairState;
        states.assign(cube.mesh->cornerPairCount(), PairState::Free);
        std::vector<std::size_t> edges;
        for (std::size_t e = 0; e < cube.mesh->edgePairs.size(); ++e) {
            if (!cube.mesh->edgePairs[e].diagonal)
                edges.push_back(e);
        }
        const std::size_t cut = edges.front(), joined = edges.back();
        states[2 * cut] = states[2 * cut + 1] = PairState::Cut;
        states[2 * joined] = states[2 * joined + 1] = PairState::Joined;
        const auto graph = graphOf(cube);
        for (const double spread : {1e-6, 100.0}) {
            const CutFlags flags = clusterSeams(*graph, std::vector<double>(graph->triangleCount(), spread));
            QVERIFY(flags[cut]);
            QVERIFY(!flags[joined]);
        }
    }

    void everySurfaceHasAMap_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"plate", "touching boxes", "tube", "plate and dust"})
            QTest::newRow(name) << name;
    }
    void everySurfaceHasAMap()
    {
        QFETCH(QString, name);
        const Snapshot snapshot = snapshotOf(meshOf(name));
        const std::optional<CutState> state = firstClusters(graphOf(snapshot), {});
        QVERIFY(state);
        const Soup &soup = *state->graph->soup;
        QCOMPARE(QString::fromStdString(state->map().validate(soup)), QString());
        QVERIFY(!definite::coversItself(soup, state->map()));
        QVERIFY2(state->distortion < 8, qPrintable(QString::number(state->distortion)));
    }

    void draftsKeepTheBound_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"plate", "touching boxes", "plate and dust"})
            QTest::newRow(name) << name;
    }
    void draftsKeepTheBound()
    {
        QFETCH(QString, name);
        Snapshot snapshot = snapshotOf(meshOf(name));
        snapshot.settings.flat = FlatMode::Free; // else the start is from nets
        unwrap::UnwrapOptions options;
        options.quality = unwrap::UnwrapQuality::Draft;
        const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options);
        QVERIFY2(result.distortion <= options.maxDistortion, qPrintable(QString::number(result.distortion)));
        QVERIFY(!result.onlyPatches);
    }
};

QTEST_APPLESS_MAIN(TestFirstClusters)

} // namespace tst_firstclusters

#include "tst_firstclusters.moc"
