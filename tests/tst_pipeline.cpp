// The whole way from a mesh to a packed map: valid, within the bound, steerable, the same every time.
#include "model/plain/uvlayout.h"
#include "solver/definite/relaxing.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/unwrap/flatpatches.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"
#include "support/objuv.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <tuple>

namespace tst_pipeline {

using namespace autocuts;
using namespace autocuts::metrics;
using namespace autocuts::overlap;
using namespace autocuts::unwrap;

namespace {

constexpr double margin = 8;

test::MeshPtr pipelineMesh(const QString &name)
{
    if (name == QLatin1String("two triangles")) // apart from each other
        return test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {5, 2, 0}, {5, 0, 2}},
                                 {{0, 1, 2}, {3, 4, 5}});
    if (name == QLatin1String("square of two"))
        return test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    if (name == QLatin1String("large sphere")) // unwrapped by way of a coarser mesh
        return test::sphere(120, 110);
    return test::meshNamed(name);
}

Snapshot snapshotOf(const test::MeshPtr &mesh)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    return snapshot;
}

UnwrapOptions draft()
{
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    options.packing.effort = 0.05;
    options.packing.margin = margin;
    return options;
}

//! What is wrong with the map of a mesh; empty when it is fit for use. Flips and overlaps are looked for in
//! the mesh's own triangles: the measure splits every polygon into a fan, even where that covers other
//! ground.
QString problemWith(const MeshData &mesh, const UvMatrix &uv, bool packed = true)
{
    if (uv.rows() != mesh.cornerCount())
        return QStringLiteral("not one UV per corner");
    const UvMetrics m = measureUv(mesh, uv);
    QStringList problems;
    if (m.facesWithoutUv > 0)
        problems << QStringLiteral("%1 faces without UVs").arg(m.facesWithoutUv);
    int turned = 0;
    for (const auto &t : mesh.triangles)
        turned += !(cross2(uv.row(t[0]), uv.row(t[1]), uv.row(t[2])) > 0);
    if (turned > 0)
        problems << QStringLiteral("%1 triangles turned over").arg(turned);
    if (m.symDirichletInfinite > 0)
        problems << QStringLiteral("%1 collapsed triangles").arg(m.symDirichletInfinite);
    if (!m.inUnitSquare)
        problems << QStringLiteral("outside of the unit square");
    const std::size_t overlaps = packed ? findOverlaps(soupUv(mesh, uv), {}).pairs.size() : 0;
    if (overlaps > 0)
        problems << QStringLiteral("%1 overlaps").arg(overlaps);
    if (packed && m.charts > 1 && !(m.minGutterTexels >= margin * (1 - 1e-6)))
        problems << QStringLiteral("gutter of %1 texels").arg(m.minGutterTexels);
    if (packed && !(m.borderGutterTexels >= margin / 2 * (1 - 1e-6)))
        problems << QStringLiteral("border of %1 texels").arg(m.borderGutterTexels);
    return problems.join(QStringLiteral(", "));
}

bool sameBytes(const UvMatrix &a, const UvMatrix &b)
{
    return a.rows() == b.rows() && std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0;
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

//! True when the two sides of an edge are at different places in the UVs.
bool isSeam(const MeshData &mesh, const UvMatrix &uv, int e)
{
    for (int end = 0; end < 2; ++end) {
        const auto [a, b] = mesh.edgePairs[e].corner[end];
        if (uv.row(mesh.cornerOfSoup(a)) != uv.row(mesh.cornerOfSoup(b)))
            return true;
    }
    return false;
}

void setState(Snapshot &snapshot, int e, PairState state)
{
    Steering &steering = snapshot.editSteering();
    steering.pairState.resize(snapshot.mesh->cornerPairCount(), PairState::Free);
    steering.pairState[2 * e] = steering.pairState[2 * e + 1] = state;
}

//! An open tube of quads: vertices are segments * ring + segment.
test::MeshPtr tube(int rings, int segments)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            const double angle = 2 * std::numbers::pi * s / segments;
            points.emplace_back(std::cos(angle), std::sin(angle), 0.6 * r);
        }
    }
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            const int next = (s + 1) % segments;
            faces.push_back(
                {segments * r + s, segments * r + next, segments * (r + 1) + next, segments * (r + 1) + s});
        }
    }
    return test::polygonMesh(points, faces);
}

} // namespace

class TestPipeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mapsAreValid_data()
    {
        QTest::addColumn<bool>("fans"); // all polygons are: then the measure sees the same triangles
        for (const char *name : {"triangle", "two triangles", "square of two", "cube", "quad cube", "sphere",
                                 "turned sphere", "torus", "grid", "dirty"})
            QTest::newRow(name) << true;
        QTest::newRow("machine") << false;
    }
    void mapsAreValid()
    {
        QFETCH(bool, fans);
        const auto mesh = pipelineMesh(QString::fromLatin1(QTest::currentDataTag()));
        const UnwrapOptions options = draft();
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh), options);
        QCOMPARE(problemWith(*mesh, result.uv), QString());
        QVERIFY(!result.stopped);
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            QCOMPARE(isSeam(*mesh, result.uv, static_cast<int>(e)), bool(result.cut[e]));
            QVERIFY(!(result.cut[e] && mesh->edgePairs[e].diagonal));
        }
        QVERIFY(result.withinBound);
        QVERIFY(result.distortion <= options.maxDistortion);
        const UvMetrics m = measureUv(*mesh, result.uv);
        if (fans) {
            QCOMPARE(m.flipped, 0);
            QCOMPARE(m.overlapPairs, std::int64_t(0));
            QVERIFY(std::abs(m.symDirichlet - result.distortion) <= 1e-6 * result.distortion);
        }
        if (fans && m.nonManifoldEdges == 0)
            QVERIFY2(std::abs(m.seamNorm - result.seamLength) <= 1e-6 * (1 + m.seamNorm),
                     qPrintable(QStringLiteral("%1 %2").arg(m.seamNorm).arg(result.seamLength)));
    }

    void flatMeshesNeedNoSeam()
    {
        for (const char *name : {"triangle", "square of two", "grid"}) {
            const auto mesh = pipelineMesh(QString::fromLatin1(name));
            const UnwrapResult result = unwrapMesh(snapshotOf(mesh), draft());
            QCOMPARE(result.seamLength, 0.0);
            QVERIFY(result.distortion >= 4 - 1e-9);
        }
    }

    void aTighterBoundIsRespected()
    {
        const auto mesh = test::sphere(6, 8);
        UnwrapOptions options = draft();
        double seam[2];
        for (int i = 0; i < 2; ++i) {
            options.maxDistortion = i == 0 ? 4.5 : 4.08;
            const UnwrapResult result = unwrapMesh(snapshotOf(mesh), options);
            QVERIFY2(result.withinBound, qPrintable(QString::number(result.distortion)));
            QVERIFY(measureUv(*mesh, result.uv).symDirichlet <= options.maxDistortion + 1e-9);
            seam[i] = result.seamLength;
        }
        QVERIFY2(seam[0] < seam[1], qPrintable(QStringLiteral("%1 %2").arg(seam[0]).arg(seam[1])));
    }

    void theSameEveryTimeOnAnyNumberOfThreads()
    {
        for (const char *name : {"quad cube", "torus"}) {
            const auto mesh = pipelineMesh(QString::fromLatin1(name));
            UnwrapOptions options = draft();
            options.quality = UnwrapQuality::Standard; // more than one chain
            options.maxDistortion = 4.3;
            UvMatrix uv[3];
            for (int i = 0; i < 3; ++i) {
                uv[i] = unwrapMesh(snapshotOf(mesh), options, {nullptr, i == 2 ? 3 : 1}).uv;
            }
            QVERIFY(sameBytes(uv[0], uv[1]));
            QVERIFY(sameBytes(uv[0], uv[2]));
        }
    }

    void stoppingStillGivesAValidMap_data()
    {
        QTest::addColumn<int>("calls"); // of progress before the stop
        for (const char *name : {"triangle", "quad cube", "torus", "dirty", "machine"}) {
            for (const int calls : {0, 1, 7})
                QTest::addRow("%s %d", name, calls) << calls;
        }
        QTest::addRow("torus 100") << 100;
        // By way of a coarser mesh.
        for (const int calls : {0, 1, 20, 60})
            QTest::addRow("large sphere %d", calls) << calls;
    }
    void stoppingStillGivesAValidMap()
    {
        QFETCH(int, calls);
        const QString tag = QString::fromLatin1(QTest::currentDataTag());
        const auto mesh = pipelineMesh(tag.left(tag.lastIndexOf(QLatin1Char(' '))));
        std::atomic<bool> stop = calls == 0;
        int seen = 0;
        const UnwrapResult result =
            unwrapMesh(snapshotOf(mesh), draft(), {&stop, 1, [&](const JobProgress &) {
                                                       if (++seen == calls)
                                                           stop = true;
                                                   }});
        QCOMPARE(problemWith(*mesh, result.uv), QString());
        QCOMPARE(result.stopped, calls == 0 || seen >= calls); // few calls for a single triangle
    }

    //! Polygons that no map can lay flat with the faces around them.
    void oddPolygonsDoNotRefuseTheModel_data()
    {
        QTest::addColumn<std::vector<int>>("polygon"); // on the vertices of a cube
        QTest::newRow("a b c b") << std::vector<int>{0, 1, 2, 1};
        QTest::newRow("opposite corners in one place") << std::vector<int>{0, 1, 0, 3};
        QTest::newRow("two vertices twice") << std::vector<int>{0, 1, 2, 0, 2, 3};
        QTest::newRow("many times") << std::vector<int>{3, 6, 4, 3, 7, 3, 4, 2, 5};
        QTest::newRow("bow-tie") << std::vector<int>{0, 2, 1, 3};
    }
    void oddPolygonsDoNotRefuseTheModel()
    {
        QFETCH(std::vector<int>, polygon);
        const std::vector<Vec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        const auto mesh = test::polygonMesh(
            cube, {{4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, polygon});
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh), draft());
        QVERIFY(result.uv.allFinite());
        for (const auto &t : mesh->triangles)
            QVERIFY(cross2(result.uv.row(t[0]), result.uv.row(t[1]), result.uv.row(t[2])) > 0);
    }

    //! On one thread a job is stopped after the same work each time.
    void moreTimeNeverGivesLess()
    {
        const auto mesh = test::torus(24, 16);
        UnwrapOptions options;
        options.pack = false;
        bool hasMap = false, fitted = false;
        double last = std::numeric_limits<double>::infinity();
        for (int calls = 0; calls < 400; calls = 2 * calls + 1) {
            std::atomic<bool> stop = calls == 0;
            int seen = 0;
            const UnwrapResult result =
                unwrapMesh(snapshotOf(mesh), options, {&stop, 1, [&](const JobProgress &) {
                                                           if (++seen == calls)
                                                               stop = true;
                                                       }});
            if (result.onlyPatches) {
                QVERIFY(!hasMap);
                continue;
            }
            hasMap = true;
            const double value = result.withinBound ? result.seamLength : result.distortion;
            QVERIFY(result.withinBound || !fitted);
            if (result.withinBound && !fitted)
                last = std::numeric_limits<double>::infinity();
            fitted = result.withinBound;
            QVERIFY2(value <= last * (1 + 1e-9),
                     qPrintable(QStringLiteral("%1 after %2, %3 before").arg(value).arg(calls).arg(last)));
            last = value;
        }
        QVERIFY(fitted);
    }

    void bestIsNeverWorseThanStandard_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"cube", "sphere", "torus"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void bestIsNeverWorseThanStandard()
    {
        QFETCH(QString, name);
        UnwrapOptions options;
        options.pack = false;
        const UnwrapResult standard = unwrapMesh(snapshotOf(pipelineMesh(name)), options, {nullptr, 2});
        options.quality = UnwrapQuality::Best;
        const UnwrapResult best = unwrapMesh(snapshotOf(pipelineMesh(name)), options, {nullptr, 2});
        QVERIFY(standard.withinBound && best.withinBound);
        QVERIFY(best.seamLength <= standard.seamLength * (1 + 1e-9));
    }

    void flatPatchesAreValid_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"triangle", "quad cube", "sphere", "torus", "dirty", "machine"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void flatPatchesAreValid()
    {
        QFETCH(QString, name);
        const Snapshot snapshot = snapshotOf(pipelineMesh(name));
        const auto soup = Soup::build(snapshot.mesh);
        const SeamedMap map = flatPatches(*soup, snapshot);
        QCOMPARE(map.validate(*soup), std::string());
        QVERIFY(!definite::coversItself(*soup, map));
        QVERIFY(map.distortion(*soup) < 5);
    }

    void progressRises()
    {
        double last = 0;
        int calls = 0;
        bool falls = false;
        std::ignore = unwrapMesh(snapshotOf(test::quadCube()), draft(),
                                 {nullptr, 1, [&](const JobProgress &p) {
                                      falls = falls || p.fraction < last || p.fraction > 1;
                                      last = p.fraction;
                                      ++calls;
                                  }});
        QVERIFY(calls > 10);
        QVERIFY(!falls);
        QVERIFY(last > 0.9);
    }

    void overlapsMayStay()
    {
        const auto mesh = test::torus(8, 6);
        UnwrapOptions options = draft();
        options.allowOverlaps = true;
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh), options);
        const UvMetrics m = measureUv(*mesh, result.uv);
        QCOMPARE(m.flipped, 0);
        QVERIFY(m.inUnitSquare);
        QCOMPARE(m.overlapPairs, m.overlapPairsSameChart); // islands do not lie on each other
    }

    void withoutPackingTheMapFillsTheSquare()
    {
        const auto mesh = test::quadCube();
        UnwrapOptions options = draft();
        options.pack = false;
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh), options);
        QCOMPARE(problemWith(*mesh, result.uv, false), QString());
        const Eigen::RowVector2d low = result.uv.colwise().minCoeff(), high = result.uv.colwise().maxCoeff();
        QCOMPARE(low, Eigen::RowVector2d(0, 0));
        QVERIFY(std::abs((high - low).maxCoeff() - 1) < 1e-12);
    }

    void fixedLambdaBalances()
    {
        const auto mesh = test::sphere(6, 8);
        UnwrapOptions options = draft();
        UnwrapResult result[3];
        const double lambdas[] = {0, 0.5, 1};
        for (int i = 0; i < 3; ++i) {
            options.lambda = lambdas[i];
            result[i] = unwrapMesh(snapshotOf(mesh), options);
            QCOMPARE(problemWith(*mesh, result[i].uv), QString());
            QCOMPARE(result[i].lambda, lambdas[i]);
            QVERIFY(result[i].withinBound);
        }
        QVERIFY(std::abs(result[0].distortion - 4) < 1e-6); // distortion alone: every triangle on its own
        QVERIFY(result[1].seamLength < result[0].seamLength);
        QVERIFY(result[1].distortion > result[0].distortion);
    }

    void everyStartWorks_data()
    {
        QTest::addColumn<int>("start");
        QTest::newRow("rigid") << static_cast<int>(StartMode::Rigid);
        QTest::newRow("tutte") << static_cast<int>(StartMode::Tutte);
        QTest::newRow("random") << static_cast<int>(StartMode::Random);
        QTest::newRow("existing") << static_cast<int>(StartMode::ExistingUv);
    }
    void everyStartWorks()
    {
        QFETCH(int, start);
        for (const auto &mesh : {test::quadCube(), test::torus(8, 6), test::dirty()}) {
            Snapshot snapshot = snapshotOf(mesh);
            snapshot.settings.start = static_cast<StartMode>(start);
            if (snapshot.settings.start == StartMode::ExistingUv)
                snapshot.startUv = std::make_shared<const UvMatrix>(
                    startUvFromCorners(*mesh, mesh->positions(mesh->cornerVertex, {0, 1})));
            const UnwrapResult result = unwrapMesh(snapshot, draft());
            QCOMPARE(problemWith(*mesh, result.uv), QString());
            QVERIFY(result.withinBound);
        }
    }

    void bothEnergiesAndSolversWork()
    {
        for (const auto energy : {DistortionEnergy::SymmetricDirichlet, DistortionEnergy::Amips}) {
            for (const auto solver : {SolverKind::Fast, SolverKind::Exact}) {
                Snapshot snapshot = snapshotOf(test::quadCube());
                snapshot.settings.energy = energy;
                snapshot.settings.solver = solver;
                snapshot.settings.weighting =
                    solver == SolverKind::Fast ? SeamWeighting::Count : SeamWeighting::Length;
                const UnwrapResult result = unwrapMesh(snapshot, draft());
                QCOMPARE(problemWith(*snapshot.mesh, result.uv), QString());
            }
        }
    }

    void joinedEdgesAreNoSeams()
    {
        // Every edge in turn: joining one leaves the others enough room to open.
        const auto mesh = test::quadCube();
        for (int e = 0; e < static_cast<int>(mesh->edgePairs.size()); ++e) {
            if (mesh->edgePairs[e].diagonal)
                continue;
            Snapshot snapshot = snapshotOf(mesh);
            setState(snapshot, e, PairState::Joined);
            const UnwrapResult result = unwrapMesh(snapshot, draft());
            QVERIFY2(!isSeam(*mesh, result.uv, e), qPrintable(QString::number(e)));
            QCOMPARE(problemWith(*mesh, result.uv), QString());
        }
    }

    void aForcedRingIsASeam()
    {
        // A ring around the tube, where nothing else would cut it.
        const int segments = 8;
        const auto mesh = tube(4, segments);
        Snapshot snapshot = snapshotOf(mesh);
        for (int s = 0; s < segments; ++s)
            setState(snapshot, edgeBetween(*mesh, 2 * segments + s, 2 * segments + (s + 1) % segments),
                     PairState::Cut);
        const UnwrapResult result = unwrapMesh(snapshot, draft());
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            if (snapshot.steering->pairState[2 * e] == PairState::Cut)
                QVERIFY(result.cut[e] && isSeam(*mesh, result.uv, static_cast<int>(e)));
        }
        QVERIFY(measureUv(*mesh, result.uv).charts >= 2);
    }

    void seamsGoWhereTheyAreCheap()
    {
        // A tube must be cut along its length once; all places are equal but for the weights.
        const int rings = 3, segments = 10;
        const auto mesh = tube(rings, segments);
        for (const int cheap : {1, 6}) {
            Snapshot snapshot = snapshotOf(mesh);
            Steering &steering = snapshot.editSteering();
            steering.pairWeight.assign(mesh->cornerPairCount(), 1);
            double expected = 0;
            for (int r = 0; r < rings; ++r) {
                const int e = edgeBetween(*mesh, segments * r + cheap, segments * (r + 1) + cheap);
                steering.pairWeight[2 * e] = steering.pairWeight[2 * e + 1] = 0.1;
                expected += mesh->edgePairs[e].length;
            }
            const UnwrapResult result = unwrapMesh(snapshot, draft());
            for (int r = 0; r < rings; ++r)
                QVERIFY(result.cut[edgeBetween(*mesh, segments * r + cheap, segments * (r + 1) + cheap)]);
            QVERIFY(std::abs(measureUv(*mesh, result.uv).seamLength - expected) < 1e-9);
        }
    }

    void badOptionsAreRefused()
    {
        const auto refused = [](UnwrapOptions options) {
            try {
                std::ignore = unwrapMesh(snapshotOf(test::triangle()), options);
            } catch (const std::invalid_argument &) {
                return true;
            }
            return false;
        };
        for (const double bound : {4.0, 3.0, double(NAN)}) {
            UnwrapOptions options = draft();
            options.maxDistortion = bound;
            QVERIFY(refused(options));
        }
        for (const double lambda : {-0.1, 1.1, double(NAN)}) {
            UnwrapOptions options = draft();
            options.lambda = lambda;
            QVERIFY(refused(options));
        }
        const auto flat = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, std::ignore = unwrapMesh(snapshotOf(flat), draft()));
    }
};

QTEST_APPLESS_MAIN(TestPipeline)

} // namespace tst_pipeline

#include "tst_pipeline.moc"
