// Texel weights of faces: kept by sessions and re-linked models, and aimed for by all that makes maps.
#include "commands/settexelweights.h"
#include "model/document/makesnapshot.h"
#include "model/editing/relink.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/meshpart.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"
#include "solver/base/soup.h"
#include "solver/homotopy/localsolve.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/packing/islandgeometry.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/unwrap.h"
#include "support/editsupport.h"

#include <QTest>

#include <cmath>
#include <optional>
#include <thread>

namespace tst_texelweights {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using namespace autocuts::unwrap;

namespace {

//! The weight of all faces in the upper half of a model, and 1 elsewhere.
std::vector<double> upperHalf(const MeshData &mesh, double weight)
{
    std::vector<double> weights;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        Vec3 middle = Vec3::Zero();
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            middle += mesh.cornerPosition(c) / (mesh.faceStart[face + 1] - mesh.faceStart[face]);
        weights.push_back(middle.z() > 0 ? weight : 1);
    }
    return weights;
}

//! Length in the map per length on the model in the faces of a weight.
double densityWhere(const MeshData &mesh, const UvMatrix &uv, const std::vector<double> &weights,
                    double weight)
{
    double area = 0, uvArea = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (weights[mesh.triangleFace[t]] != weight)
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        area += mesh.triangleArea[t];
        uvArea += 0.5 * std::abs(cross2(uv.row(a), uv.row(b), uv.row(c)));
    }
    return std::sqrt(uvArea / area);
}

double densityRatio(const MeshData &mesh, const UvMatrix &uv, const std::vector<double> &weights,
                    double weight)
{
    return densityWhere(mesh, uv, weights, weight) / densityWhere(mesh, uv, weights, 1);
}

UnwrapOptions draft()
{
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    options.packing.effort = 0.05;
    return options;
}

Snapshot snapshotOf(const test::MeshPtr &mesh)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    return snapshot;
}

QByteArray sessionOf(const DocumentState &state)
{
    return ProjectWriter().bytes(state, {});
}

} // namespace

class TestTexelWeights : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noneAreStoredWhenAllAreOne();
    void snapshotsShareTheMeshUntilItIsPainted();
    void strokesDoNotCopyTheMesh();
    void sessionsKeepThem();
    void relinkingKeepsThem();
    void restShapesAreScaled();
    void metricsAreRelativeToThem();
    void chartsGetTheirDensity();
    void unwrapGivesPaintedDensity_data();
    void unwrapGivesPaintedDensity();
    void scopeAndFinishObeyThem();
    void localSolvesObeyThem();
    void aLiveMapFollowsThem();
};

void TestTexelWeights::noneAreStoredWhenAllAreOne()
{
    const auto document = test::gridDocument();
    const DocumentState before = document->state();
    QVERIFY(pushCommand(SetTexelWeights::uniform(*document, IndexRanges::all(2), 4)));
    QCOMPARE(document->state().texelWeights.size(), std::size_t(document->mesh().faceCount()));
    QVERIFY(pushCommand(SetTexelWeights::uniform(*document, IndexRanges::all(2), 1)));
    QVERIFY(document->state().texelWeights.empty());
    QVERIFY(document->state() == before);
    DocumentState damaged = before;
    damaged.texelWeights.assign(static_cast<std::size_t>(before.scene.mesh->faceCount()), 1.0);
    QVERIFY(!damaged.validate().isEmpty()); // not the stored form
    damaged.texelWeights[0] = 9;
    QVERIFY(!damaged.validate().isEmpty()); // out of range
    damaged.texelWeights = {2};
    QVERIFY(!damaged.validate().isEmpty());
}

void TestTexelWeights::snapshotsShareTheMeshUntilItIsPainted()
{
    const auto document = test::gridDocument();
    QCOMPARE(makeSnapshot(*document).mesh.get(), &document->mesh());
    QVERIFY(pushCommand(SetTexelWeights::uniform(*document, IndexRanges::all(2), 4)));
    const Snapshot painted = makeSnapshot(*document);
    QCOMPARE(painted.mesh->texelWeight, document->state().texelWeights);
    QCOMPARE(makeSnapshot(*document).mesh, painted.mesh); // cached
    QCOMPARE(painted.mesh->validate(), std::string());
    document->undoStack().undo();
    QCOMPARE(makeSnapshot(*document).mesh.get(), &document->mesh());
}

void TestTexelWeights::strokesDoNotCopyTheMesh()
{
    const auto document = test::gridDocument();
    const auto paint = [&](double weight) {
        return pushCommand(SetTexelWeights::uniform(*document, IndexRanges::all(2), weight));
    };
    QVERIFY(paint(2));
    document->weightedMesh();
    QVERIFY(paint(3));
    const MeshData *const shown = document->weightedMesh().get();
    QVERIFY(paint(4));
    QCOMPARE(document->weightedMesh().get(), shown);
    QCOMPARE(shown->texelWeight, document->state().texelWeights);
    // What somebody uses stays as it is, and is taken when nobody uses it any more.
    std::optional<Snapshot> used = makeSnapshot(*document);
    QVERIFY(paint(5));
    QCOMPARE(used->mesh->texelWeight[0], 4.0);
    QCOMPARE(document->weightedMesh()->texelWeight[0], 5.0);
    used.reset();
    std::thread([mesh = document->weightedMesh()] {}).join();
    QVERIFY(paint(6));
    QCOMPARE(document->weightedMesh()->texelWeight[0], 6.0);
    QCOMPARE(document->weightedMesh()->validate(), std::string());
}

void TestTexelWeights::sessionsKeepThem()
{
    DocumentState state = test::gridDocument()->state();
    const QByteArray without = sessionOf(state);
    QVERIFY(!without.contains("texelWeights"));
    state.texelWeights.assign(static_cast<std::size_t>(state.scene.mesh->faceCount()), 1.0);
    state.texelWeights[3] = 2.5;
    state.texelWeights[7] = 0.125;
    const QByteArray with = sessionOf(state);
    const Result<LoadedProject> loaded = parseProject(with, u"a.acproj"_s);
    QVERIFY(loaded.ok());
    QVERIFY(loaded->state == state);
    QVERIFY(parseProject(without, u"a.acproj"_s)->state.texelWeights.empty());
    // A damaged block is said, and nothing else is lost.
    QByteArray damaged = with;
    const qsizetype block = damaged.indexOf("texelWeights");
    damaged[block + 60] = static_cast<char>(damaged[block + 60] ^ 0x55);
    const Result<LoadedProject> rest = parseProject(damaged, u"a.acproj"_s);
    QVERIFY(rest.ok());
    QVERIFY(rest->state.texelWeights.empty());
    QVERIFY2(rest->lost.contains(u"the painted texel density"_s), qPrintable(rest->lost.join(u',')));
}

void TestTexelWeights::relinkingKeepsThem()
{
    DocumentState state = test::gridDocument()->state();
    state.texelWeights.assign(static_cast<std::size_t>(state.scene.mesh->faceCount()), 1.0);
    state.texelWeights[3] = 2.5;
    const Relinked same = relinkDocument(state, test::sceneOf(test::grid(4, 0.3)));
    QCOMPARE(same.state.texelWeights, state.texelWeights);
    QCOMPARE(same.report.weightedFaces, (Carried{1, 0}));
    const Relinked other = relinkDocument(state, test::sceneOf(test::cube()));
    QVERIFY(other.state.texelWeights.empty());
    QCOMPARE(other.report.weightedFaces, (Carried{0, 1}));
    QVERIFY(other.report.lines().join(u'\n').contains(u"texel density"_s));
}

void TestTexelWeights::restShapesAreScaled()
{
    const test::MeshPtr mesh = test::sphere(5, 7);
    std::vector<double> weights(static_cast<std::size_t>(mesh->faceCount()), 1.0);
    weights[4] = 3;
    const auto plain = Soup::build(mesh), painted = Soup::build(withTexelWeights(mesh, weights));
    QCOMPARE(painted->weight, plain->weight);
    QCOMPARE(painted->pairLength, plain->pairLength);
    QCOMPARE(painted->scale, plain->scale);
    for (int t = 0; t < mesh->triangleCount(); ++t) {
        const double factor = weights[mesh->triangleFace[t]];
        for (int i = 0; i < 6; ++i)
            QVERIFY(std::abs(painted->restShape[t][i] - factor * plain->restShape[t][i]) < 1e-14);
    }
    // A part of the mesh has the weights of its faces.
    std::vector<bool> faces(weights.size(), false);
    faces[3] = faces[4] = true;
    const MeshPart part = partOf(*painted->mesh, faces);
    QCOMPARE(part.mesh->texelWeight, (std::vector<double>{1, 3}));
    QCOMPARE(part.mesh->validate(), std::string());
}

void TestTexelWeights::metricsAreRelativeToThem()
{
    // Two squares; the second one is twice as large in the map.
    const test::MeshPtr mesh = test::polygonMesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}},
        {{0, 1, 2, 3}, {4, 5, 6, 7}});
    UvMatrix uv(8, 2);
    uv << 0, 0, 0.2, 0, 0.2, 0.2, 0, 0.2, 0.5, 0, 0.9, 0, 0.9, 0.4, 0.5, 0.4;
    const metrics::UvMetrics plain = metrics::measureUv(*mesh, uv);
    QVERIFY(plain.symDirichlet > 4.5);
    QVERIFY(std::abs(plain.texelDensitySpread - 2) < 1e-12);
    const metrics::UvMetrics painted = metrics::measureUv(*withTexelWeights(mesh, {1, 2}), uv);
    QVERIFY(std::abs(painted.symDirichlet - 4) < 1e-12);
    QVERIFY(std::abs(painted.symDirichletMax - 4) < 1e-12);
    QVERIFY(std::abs(painted.l2Stretch - 1) < 1e-12);
    QVERIFY(std::abs(painted.angleDistortion - 1) < 1e-12);
    QVERIFY(std::abs(painted.areaDistortion - 1) < 1e-12);
    QVERIFY(std::abs(painted.texelDensitySpread - 1) < 1e-12);
    QCOMPARE(painted.area3d, plain.area3d);
    QCOMPARE(painted.seamNorm, plain.seamNorm);
}

void TestTexelWeights::chartsGetTheirDensity()
{
    const test::MeshPtr mesh = test::polygonMesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {7, 0, 0}, {5, 2, 0}}, {{0, 1, 2}, {3, 4, 5}});
    const std::vector<double> weights{1, 4};
    UvMatrix uv(6, 2);
    uv << 0, 0, 0.1, 0, 0, 0.1, 0.5, 0, 0.6, 0, 0.5, 0.1;
    packing::equalizeTexelDensity(*withTexelWeights(mesh, weights), findCharts(*mesh, uv), uv);
    QVERIFY(std::abs(densityRatio(*mesh, uv, weights, 4) - 4) < 1e-12);
}

void TestTexelWeights::unwrapGivesPaintedDensity_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("weight");
    for (const double weight : {2.0, 4.0, 0.5}) {
        for (const char *name : {"sphere", "torus", "bumpycube"})
            QTest::addRow("%s, %g times", name, weight) << QString::fromLatin1(name) << weight;
    }
}

void TestTexelWeights::unwrapGivesPaintedDensity()
{
    QFETCH(QString, name);
    QFETCH(double, weight);
    const test::MeshPtr mesh = test::meshNamed(name);
    const std::vector<double> weights = upperHalf(*mesh, weight);
    const test::MeshPtr painted = withTexelWeights(mesh, weights);
    const UnwrapOptions options = draft();
    const UnwrapResult result = unwrapMesh(snapshotOf(painted), options);
    const metrics::UvMetrics figures = metrics::measureUv(*painted, result.uv);
    QVERIFY(result.withinBound);
    QVERIFY2(figures.symDirichlet <= options.maxDistortion + 1e-6,
             qPrintable(QString::number(figures.symDirichlet)));
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, std::int64_t(0));
    QVERIFY(figures.inUnitSquare);
    const double ratio = densityRatio(*mesh, result.uv, weights, weight);
    QVERIFY2(std::abs(std::log2(ratio / weight)) < 0.1, qPrintable(QString::number(ratio)));
}

void TestTexelWeights::scopeAndFinishObeyThem()
{
    const test::MeshPtr mesh = test::meshNamed(u"sphere"_s);
    const std::vector<double> weights = upperHalf(*mesh, 2);
    Snapshot snapshot = snapshotOf(mesh);
    const UnwrapResult plain = unwrapMesh(snapshot, draft());
    snapshot.mesh = withTexelWeights(mesh, weights);
    snapshot.uv = std::make_shared<const UvMatrix>(plain.uv);
    snapshot.uvScale = layoutScale(*mesh, plain.uv);
    // Only the painted half may change: the other one keeps its place and its size.
    JobScope scope{{}, false};
    for (const double weight : weights)
        scope.faces.push_back(weight == 2);
    Snapshot half = snapshot;
    half.scope = std::make_shared<const JobScope>(scope);
    UnwrapOptions options = draft();
    options.pack = false;
    const UnwrapResult made = unwrapMesh(half, options);
    const double ratio = densityRatio(*mesh, made.uv, weights, 2);
    QVERIFY2(std::abs(std::log2(ratio / 2)) < 0.1, qPrintable(QString::number(ratio)));
    QCOMPARE(densityWhere(*mesh, made.uv, weights, 1), densityWhere(*mesh, plain.uv, weights, 1));
    // Finish starts from the map that is there.
    FinishInput finish;
    finish.snapshot = snapshot;
    finish.maxDistortion = 4.1;
    const FinishResult finished = finishMap(finish, {});
    const double after = densityRatio(*mesh, finished.uv, weights, 2);
    QVERIFY2(std::abs(std::log2(after / 2)) < 0.1, qPrintable(QString::number(after)));
    QCOMPARE(metrics::measureUv(*snapshot.mesh, finished.uv).flipped, 0);
}

void TestTexelWeights::localSolvesObeyThem()
{
    // One strip of quads, the right half of which is to be twice as dense.
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int x = 0; x <= 8; ++x) {
        points.emplace_back(x, 0, 0);
        points.emplace_back(x, 1, 0);
        if (x > 0)
            faces.push_back({2 * x - 2, 2 * x, 2 * x + 1, 2 * x - 1});
    }
    const test::MeshPtr mesh = test::polygonMesh(points, faces);
    const std::vector<double> weights{1, 1, 1, 1, 2, 2, 2, 2};
    UvMatrix uv(mesh->cornerCount(), 2);
    for (int c = 0; c < mesh->cornerCount(); ++c)
        uv.row(c) = mesh->cornerPosition(c).head<2>().transpose() / 10;
    const UvTopology topology = findUvTopology(*mesh, uv);
    homotopy::LocalProblem problem;
    problem.pointOfCorner = topology.cornerRoot;
    for (int face = 0; face < mesh->faceCount(); ++face)
        problem.faces.push_back(face);
    const auto solved = homotopy::solveLocally(*withTexelWeights(mesh, weights), uv, problem, {});
    QVERIFY(densityRatio(*mesh, solved.uv, weights, 2) > 1.5);
    QVERIFY(solved.after < solved.before);
}

void TestTexelWeights::aLiveMapFollowsThem()
{
    const test::MeshPtr mesh = test::meshNamed(u"sphere"_s);
    const std::vector<double> weights = upperHalf(*mesh, 2);
    std::shared_ptr<const LiveMapResult> last;
    LiveMap live([&](std::shared_ptr<const LiveMapResult> result) { last = std::move(result); });
    LiveMapOptions options;
    options.maxDistortion = 4.1;
    live.begin(std::make_shared<const Snapshot>(snapshotOf(mesh)), options);
    QVERIFY(live.work({}));
    QVERIFY(last);
    QVERIFY(std::abs(std::log2(densityRatio(*mesh, last->uv, weights, 2))) < 0.2);
    const std::vector<bool> cutBefore = last->cut;
    live.steer(std::make_shared<const Snapshot>(snapshotOf(withTexelWeights(mesh, weights))), options);
    QVERIFY(live.work({}));
    const double ratio = densityRatio(*mesh, last->uv, weights, 2);
    QVERIFY2(std::abs(std::log2(ratio / 2)) < 0.15, qPrintable(QString::number(ratio)));
    const metrics::UvMetrics figures = metrics::measureUv(*withTexelWeights(mesh, weights), last->uv);
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, std::int64_t(0));
    QVERIFY(figures.symDirichlet <= options.maxDistortion + 1e-6);
    QVERIFY(figures.inUnitSquare);
    live.steer(std::make_shared<const Snapshot>(snapshotOf(mesh)), options);
    QVERIFY(live.work({}));
    QVERIFY(std::abs(std::log2(densityRatio(*mesh, last->uv, weights, 2))) < 0.2);
}

QTEST_GUILESS_MAIN(TestTexelWeights)

} // namespace tst_texelweights

#include "tst_texelweights.moc"
