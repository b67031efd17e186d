// Parts that are copies of each other: how they are found, and that an unwrap gives them the same seams.
#include "model/plain/chartcopies.h"
#include "model/plain/copymatcher.h"
#include "model/plain/rigidpieces.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"
#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/preference/seampreference.h"
#include "solver/rigid/nets.h"
#include "solver/search/seamoptimizer.h"
#include "solver/unwrap/alikeparts.h"
#include "solver/unwrap/unwrap.h"
#include "support/props.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace tst_alikeparts {

using namespace autocuts;
using namespace autocuts::test::props;

namespace {

//! A part without any symmetry: a house with a chimney on one side of its front.
Model lopsided()
{
    Model model = house();
    model.points[8] += Vec3(0.3, 0.2, 0);
    model.points[5] += Vec3(0.1, 0, 0.2);
    return model;
}

//! Some copies, turned and mirrored, and two other parts. \param copies of the part
Model scene(const Model &part, int copies)
{
    Model all = box({-3, -9, 0}, {2, 1, 1.5});
    for (int i = 0; i < copies; ++i)
        all.add(moved(turned(i % 3 == 2 ? mirrored(part) : part, 0.7 * i), {9.0 * i, 0, 0}));
    all.add(moved(sphere(8, 1), {-6, 0, 0}));
    return all;
}

Snapshot snapshotOf(const test::MeshPtr &mesh)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    return snapshot;
}

//! Length of the seams of each part, in units of the mesh.
std::vector<double> seamsOfParts(const MeshData &mesh, const CutFlags &cut)
{
    std::vector<double> length(mesh.componentCount, 0);
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (cut[e])
            length[mesh.component[mesh.edgePairs[e].triangle[0]]] += mesh.edgePairs[e].length;
    }
    return length;
}

} // namespace

class TestAlikeParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void copiesAreMatched_data();
    void copiesAreMatched();
    void oneOfEachKindStandsForTheOthers();
    void expandedMapsAreTheSameProblem();
    void whatDiffersIsNoCopy_data();
    void whatDiffersIsNoCopy();
    void unwrapCutsCopiesAlike_data();
    void unwrapCutsCopiesAlike();
    void unwrapStacksCopies();
    void theBestCopyStandsForAll();
    void aNearCopyStandsForNone();
    void aStopEndsTheComparison();
};

void TestAlikeParts::copiesAreMatched_data()
{
    QTest::addColumn<Model>("other");
    QTest::addColumn<bool>("plain");
    QTest::addColumn<bool>("mirrored");
    QTest::newRow("moved") << lopsided() << true << false;
    QTest::newRow("turned") << turned(lopsided(), 1) << true << false;
    QTest::newRow("mirrored") << mirrored(lopsided()) << false << true;
    QTest::newRow("mirrored and turned") << turned(mirrored(lopsided()), 2) << false << true;
    QTest::newRow("symmetric") << house() << false << false;
    Model higher = lopsided();
    higher.points[9].z() += 0.01;
    QTest::newRow("a little higher") << higher << false << false;
}

void TestAlikeParts::copiesAreMatched()
{
    QFETCH(Model, other);
    Model all = lopsided();
    all.add(moved(other, {20, 0, 0}));
    const test::MeshPtr mesh = all.mesh();
    const MeshAdjacency adjacency(*mesh);
    std::vector<int> part(mesh->faceCount());
    std::vector<std::vector<int>> faces(2);
    for (int face = 0; face < mesh->faceCount(); ++face) {
        part[face] = mesh->component[mesh->faceTriangle[face]];
        faces[part[face]].push_back(face);
    }
    CopyMatcher matcher(*mesh, adjacency, part, faces);
    for (const bool mirrored : {false, true}) {
        QTEST(matcher.match(0, 1, mirrored, matcher.colours(0), matcher.colours(1)),
              mirrored ? "mirrored" : "plain");
        if (!matcher.match(0, 1, mirrored, matcher.colours(0), matcher.colours(1)))
            continue;
        std::set<int> sources;
        for (int c = mesh->faceStart[faces[1].front()]; c < mesh->cornerCount(); ++c) {
            sources.insert(matcher.sourceCorner(c));
            // Sides match in length, and so do the faces beyond.
            QVERIFY(std::abs(adjacency.edgeLength(adjacency.edgeOfCorner(c)) -
                             adjacency.edgeLength(adjacency.edgeOfCorner(matcher.sourceSide(c)))) < 1e-3);
        }
        QCOMPARE(static_cast<int>(sources.size()), mesh->cornerCount() / 2);
    }
}

void TestAlikeParts::oneOfEachKindStandsForTheOthers()
{
    const test::MeshPtr mesh = scene(lopsided(), 5).mesh();
    const auto parts = unwrap::AlikeParts::of(snapshotOf(mesh));
    QVERIFY(parts);
    const MeshData &one = *parts->snapshot().mesh;
    QCOMPARE(one.componentCount, 3);
    QVERIFY(one.validate().empty());
    std::map<int, int> copies;
    for (int t = 0; t < one.triangleCount(); ++t)
        copies[one.component[t]] = one.copiesOf(t);
    QCOMPARE(copies, (std::map<int, int>{{0, 1}, {1, 5}, {2, 1}}));
    const std::shared_ptr<const Soup> soup = Soup::build(parts->snapshot().mesh);
    double weight = 0, area = 0;
    for (int t = 0; t < soup->triangleCount(); ++t) {
        weight += soup->weight[t];
        area += soup->areaShare(t);
    }
    QVERIFY(std::abs(weight - 1) < 1e-12);
    QVERIFY(std::abs(area - 1) < 1e-12);
    QCOMPARE(parts->snapshot().settings.symmetry, SymmetryMode::Off);
    QVERIFY(!unwrap::AlikeParts::of(parts->snapshot()));
}

//! Distortion and cost of the seams are those of the whole mesh.
void TestAlikeParts::expandedMapsAreTheSameProblem()
{
    const test::MeshPtr mesh = scene(sphere(5, 0.8), 5).mesh();
    const auto parts = unwrap::AlikeParts::of(snapshotOf(mesh));
    QVERIFY(parts);
    const std::shared_ptr<const Soup> soup = Soup::build(mesh), own = Soup::build(parts->snapshot().mesh);
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.pack = false;
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(parts->snapshot(), options);
    SeamedMap map;
    map.cut = result.cut;
    map.x.resize(own->coordinateCount());
    for (int c = 0; c < own->mesh->soupCornerCount(); ++c) {
        for (int k = 0; k < 2; ++k)
            map.x[2 * c + k] = result.uv(own->mesh->cornerOfSoup(c), k);
    }
    const SeamedMap whole = parts->expanded(map);
    QCOMPARE(whole.validate(*soup), std::string());
    QVERIFY(map.distortion(*own) > 4.01);
    QVERIFY(std::abs(whole.distortion(*soup) - map.distortion(*own)) < 1e-9);
    // The unit of length differs by the areas, and the mean weight of seams is that of the copies.
    const double unit = soup->scale / own->scale;
    QVERIFY(std::abs(whole.seamCost(*soup, snapshotOf(mesh)) -
                     unit / own->perCopy * map.seamCost(*own, parts->snapshot())) < 1e-9);
}

void TestAlikeParts::whatDiffersIsNoCopy_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"nothing", "off", "a cut", "a join", "a weight", "a loop", "texels",
                             "hidden seams", "pins", "given seams", "a large part"})
        QTest::newRow(what) << QString::fromLatin1(what);
}

void TestAlikeParts::whatDiffersIsNoCopy()
{
    QFETCH(QString, what);
    Model all = lopsided();
    all.add(moved(lopsided(), {9, 0, 0}));
    if (what == u"a large part") // beside which two copies are little
        all.add(box({30, 0, 0}, {20, 20, 20}));
    Snapshot snapshot = snapshotOf(all.mesh());
    const int pairs = snapshot.mesh->cornerPairCount();
    if (what == u"off")
        snapshot.settings.alike = AlikeMode::Off;
    if (what == u"a cut" || what == u"a join") {
        snapshot.editSteering().pairState.assign(pairs, PairState::Free);
        snapshot.editSteering().pairState[0] = what == u"a cut" ? PairState::Cut : PairState::Joined;
    }
    if (what == u"a weight") {
        snapshot.editSteering().pairWeight.assign(pairs, 1);
        snapshot.editSteering().pairWeight[1] = 2;
    }
    if (what == u"a loop")
        snapshot.editSteering().straightLoops = {{0, 1}};
    if (what == u"texels") {
        std::vector<double> weights(snapshot.mesh->faceCount(), 1);
        weights.back() = 2;
        snapshot.mesh = withTexelWeights(snapshot.mesh, weights);
    }
    if (what == u"hidden seams")
        snapshot.settings.visibility = 0.5;
    if (what == u"pins")
        snapshot.editSteering().pins = {{0, {0, 0}, true, 1}};
    if (what == u"given seams")
        snapshot.settings.seams = SeamMode::Keep;
    QCOMPARE(unwrap::AlikeParts::of(snapshot).has_value(), what == u"nothing" || what == u"a large part");
}

void TestAlikeParts::unwrapCutsCopiesAlike_data()
{
    QTest::addColumn<Model>("part");
    QTest::addColumn<bool>("curved");
    QTest::newRow("house") << lopsided() << false;
    QTest::newRow("cylinder") << column(16, 1, 0.8, 3, 3) << false;
    QTest::newRow("sphere") << sphere(6, 1.5) << true;
}

void TestAlikeParts::unwrapCutsCopiesAlike()
{
    QFETCH(Model, part);
    const test::MeshPtr mesh = scene(part, 5).mesh();
    Snapshot snapshot = snapshotOf(mesh);
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    double reported = 0; // while it searches: of all copies, as in the end
    const JobContext job(nullptr, 1, [&](const JobProgress &progress) {
        if (progress.stage != JobStage::Packing && progress.seamLength > 0)
            reported = progress.seamLength;
    });
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options, job);
    QVERIFY(result.withinBound);
    QVERIFY(result.packed);
    QVERIFY2(std::abs(reported / result.seamLength - 1) < 0.1,
             qPrintable(QStringLiteral("%1, then %2").arg(reported).arg(result.seamLength)));
    const std::vector<double> seams = seamsOfParts(*mesh, result.cut);
    for (int copy = 2; copy <= 5; ++copy)
        QVERIFY2(std::abs(seams[copy] - seams[1]) < 1e-9, qPrintable(QString::number(seams[copy])));
    QVERIFY(seams[1] > 0);
    // Every triangle is turned the right way round, in mirrored copies as well.
    for (int t = 0; t < mesh->triangleCount(); ++t) {
        const Vec2 a = result.uv.row(mesh->triangles[t][0]), b = result.uv.row(mesh->triangles[t][1]),
                   c = result.uv.row(mesh->triangles[t][2]);
        QVERIFY(cross2(a, b, c) > 0);
    }
    // On their own they cost no less than with the tolerance that the bound gives copies.
    snapshot.settings.alike = AlikeMode::Off;
    const unwrap::UnwrapResult apart = unwrap::unwrapMesh(snapshot, options);
    QVERIFY2(result.seamLength < 1.1 * apart.seamLength,
             qPrintable(QStringLiteral("%1 beside %2").arg(result.seamLength).arg(apart.seamLength)));
}

//! Copies lie on each other, also when they did before; what the user locked or grouped stays out of it.
void TestAlikeParts::unwrapStacksCopies()
{
    const test::MeshPtr mesh = scene(lopsided(), 5).mesh();
    Snapshot snapshot = snapshotOf(mesh);
    snapshot.settings.alike = AlikeMode::Stack;
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    const MeshAdjacency adjacency(*mesh);
    for (const bool again : {false, true}) {
        const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options);
        QVERIFY(result.packed && result.withinBound);
        QCOMPARE(result.flags.size(), std::size_t(mesh->faceCount()));
        const ChartMap charts = chartsOf(*mesh, CutMesh(*mesh, result.cut));
        std::vector<int> all(charts.count);
        std::iota(all.begin(), all.end(), 0);
        int copies = 0, mirrored = 0;
        for (const AlikeCharts &kind : findAlikeCharts(*mesh, adjacency, charts, all)) {
            for (const ChartCopy &copy : kind.copies) {
                ++copies;
                mirrored += copy.mirrored;
                for (std::size_t c = 0; c < copy.corner.size(); ++c)
                    QCOMPARE(Vec2(result.uv.row(copy.corner[c])), Vec2(result.uv.row(copy.source[c])));
            }
        }
        QVERIFY(copies >= 3 && mirrored > 0);
        const std::vector<int> stacks = stackOfCharts(charts, result.flags);
        QVERIFY(std::count_if(stacks.begin(), stacks.end(), [](int stack) { return stack > 0; }) > copies);
        metrics::UvMetricsOptions figures;
        figures.faceFlags = result.flags;
        const metrics::UvMetrics measured = metrics::measureUv(*mesh, result.uv, figures);
        QCOMPARE(measured.overlapPairs, 0);
        QVERIFY(measured.stackedPairs > 0);
        if (again)
            break;
        snapshot.uv = std::make_shared<const UvMatrix>(result.uv);
        snapshot.uvScale = layoutScale(*mesh, result.uv);
        snapshot.editSteering().faceFlags = result.flags;
    }
    snapshot.editSteering().faceFlags.assign(mesh->faceCount(), {});
    for (IslandFlags &flags : snapshot.editSteering().faceFlags)
        flags.group = 1;
    QVERIFY(unwrap::unwrapMesh(snapshot, options).nothingFree);
}

//! A live solve cuts each copy on its own; then all get the map of the best one.
void TestAlikeParts::theBestCopyStandsForAll()
{
    const Model part = sphere(6, 1.5);
    const test::MeshPtr mesh = scene(part, 4).mesh();
    Snapshot snapshot = snapshotOf(mesh);
    const std::optional<unwrap::AlikeParts> parts = unwrap::AlikeParts::of(snapshot);
    QVERIFY(parts);
    const std::shared_ptr<const Soup> soup = Soup::build(mesh);
    snapshot.settings.alike = AlikeMode::Off;
    search::OptimizeOptions options;
    options.effort = {1, {{25, 1}}};
    const auto found = search::optimizeSeams(search::SeamGraph::build(soup, snapshot), options);
    QVERIFY(found);
    const std::vector<double> before = seamsOfParts(*mesh, found->map.cut);
    const SeamedMap same = parts->unified(found->map, snapshot, 0.15, options.maxDistortion);
    QCOMPARE(same.validate(*soup), std::string());
    const std::vector<double> after = seamsOfParts(*mesh, same.cut);
    bool differed = false;
    for (int copy = 2; copy <= 4; ++copy) {
        differed = differed || std::abs(before[copy] - before[1]) > 1e-6;
        QVERIFY(std::abs(after[copy] - after[1]) < 1e-9);
    }
    QVERIFY(differed);
    QVERIFY(same.seamCost(*soup, snapshot) <= 1.05 * found->map.seamCost(*soup, snapshot));
    QVERIFY(same.distortion(*soup) <= options.maxDistortion);
    // With a bound that it does not meet, the map stays.
    const SeamedMap kept = parts->unified(found->map, snapshot, 0.15, 4.0001);
    QVERIFY(kept.distortion(*soup) <= found->map.distortion(*soup));
}

//! Its seams are the shortest, but exact copies would be stretched in its map.
void TestAlikeParts::aNearCopyStandsForNone()
{
    Model boxes = box({0, 0, 0}, {1, 1, 2});
    boxes.add(box({2, 0, 0}, {1, 1, 2}));
    boxes.add(box({4, 0, 0}, {1, 1, 1.98}));
    const test::MeshPtr mesh = boxes.mesh();
    const Snapshot snapshot = preference::SeamPreference().applied(snapshotOf(mesh));
    const std::optional<unwrap::AlikeParts> parts = unwrap::AlikeParts::of(snapshotOf(mesh));
    QVERIFY(parts && snapshot.rigid);
    const std::shared_ptr<const Soup> soup = Soup::build(mesh);
    SeamedMap apart;
    apart.cut.assign(mesh->edgePairs.size(), true);
    apart.x.resize(soup->coordinateCount());
    const SeamedMap nets = rigid::Nets(soup, snapshot).joined(0, apart);
    QVERIFY(nets.distortion(*soup) < 4 + 1e-9);
    const SeamedMap same = parts->unified(nets, snapshot, 0.15, 4.1);
    QCOMPARE(same.validate(*soup), std::string());
    QVERIFY2(same.distortion(*soup) < 4 + 1e-7, qPrintable(QString::number(same.distortion(*soup) - 4)));
}

void TestAlikeParts::aStopEndsTheComparison()
{
    const std::atomic<bool> stop = true;
    QVERIFY(!unwrap::AlikeParts::of(snapshotOf(scene(lopsided(), 3).mesh()), &stop));
}

QTEST_GUILESS_MAIN(TestAlikeParts)

} // namespace tst_alikeparts

#include "tst_alikeparts.moc"
