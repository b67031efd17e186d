// What a job may change.
#include "model/plain/uvlayout.h"
#include "model/samples/samples.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <atomic>
#include <map>

namespace tst_freepart {

using namespace autocuts;
using namespace autocuts::unwrap;

class TestFreePart : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pinnedIslandsStay_data();
    void pinnedIslandsStay();
    void whatStaysTakesFromTheBound();
    void theRestIsNotMadeWorse_data();
    void theRestIsNotMadeWorse();
};

void TestFreePart::pinnedIslandsStay_data()
{
    QTest::addColumn<int>("islands");
    QTest::addColumn<bool>("hard");
    QTest::addColumn<int>("left");    // corners without a pin
    QTest::addColumn<double>("away"); // of the pins from the map
    QTest::addColumn<int>("free");    // faces; -1: none
    QTest::newRow("one of two") << 1 << true << 0 << 0.0 << 8;
    QTest::newRow("both") << 2 << true << 0 << 0.0 << -1;
    QTest::newRow("by springs") << 1 << false << 0 << 0.0 << 16;
    QTest::newRow("but for a corner") << 1 << true << 1 << 0.0 << 16;
    QTest::newRow("the pins are elsewhere") << 1 << true << 0 << 0.01 << 16;
}

void TestFreePart::pinnedIslandsStay()
{
    QFETCH(int, islands);
    QFETCH(bool, hard);
    QFETCH(int, left);
    QFETCH(double, away);
    QFETCH(int, free);
    Snapshot snapshot;
    snapshot.mesh = test::grid(4);
    const MeshData &mesh = *snapshot.mesh;
    // The grid as it lies, its right half moved away.
    UvMatrix uv(mesh.cornerCount(), 2);
    std::vector<bool> isRight(mesh.faceCount());
    for (int face = 0; face < mesh.faceCount(); ++face) {
        double right = 0;
        for (const int s : mesh.soupCornersOf(face))
            right += mesh.cornerPosition(mesh.cornerOfSoup(s)).x() - mesh.positions.col(0).mean();
        isRight[face] = right > 0;
        for (const int s : mesh.soupCornersOf(face)) {
            const int c = mesh.cornerOfSoup(s);
            uv.row(c) = mesh.cornerPosition(c).head<2>();
            uv(c, 0) += isRight[face] ? 10 : 0;
        }
    }
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    snapshot.uvScale = layoutScale(mesh, uv);
    for (int s = left; s < mesh.soupCornerCount(); ++s) {
        const Vec2 at = uv.row(mesh.cornerOfSoup(s)).transpose();
        if (islands == 2 || !isRight[mesh.triangleFace[s / 3]])
            snapshot.editSteering().pins.push_back({s, (at + Vec2(away, 0)) / snapshot.uvScale, hard, 1});
    }
    const std::optional<FreePart> part = FreePart::of(snapshot);
    QCOMPARE(part ? part->snapshot().mesh->faceCount() : -1, free);
    if (part)
        return;
    const UnwrapResult result = unwrapMesh(snapshot, {});
    QVERIFY(result.nothingFree);
    QVERIFY(result.uv == uv);
}

//! The mean of the whole map keeps to the bound, where it did before.
void TestFreePart::whatStaysTakesFromTheBound()
{
    Snapshot snapshot;
    snapshot.mesh = test::grid(4);
    const MeshData &mesh = *snapshot.mesh;
    JobScope scope{std::vector<bool>(mesh.faceCount()), true, true};
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        double right = 0;
        for (const int s : mesh.soupCornersOf(face))
            right += mesh.cornerPosition(mesh.cornerOfSoup(s)).x() - mesh.positions.col(0).mean();
        scope.faces[face] = right < 0;
        for (const int s : mesh.soupCornersOf(face)) {
            const int c = mesh.cornerOfSoup(s);
            uv.row(c) = mesh.cornerPosition(c).head<2>();
            if (right > 0) // stretched, of the same area
                uv.row(c) = UvMatrix(uv.row(c)).cwiseProduct(Eigen::RowVector2d(1.25, 0.8)) +
                            Eigen::RowVector2d(10, 0);
        }
    }
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    snapshot.uvScale = layoutScale(mesh, uv);
    snapshot.scope = std::make_shared<const JobScope>(scope);
    const std::optional<FreePart> part = FreePart::of(snapshot);
    const double stays = 2 * (1.25 * 1.25 + 0.8 * 0.8);
    QVERIFY(std::abs(part->boundBeside(4.3) - (4.3 - (stays - 4.3))) < 1e-9);
    QCOMPARE(part->boundBeside(stays + 0.1), stays + 0.1); // stretched less than the bound
    QCOMPARE(part->boundBeside(4.1), 4.1);                 // the map before misses it anyway
}

void TestFreePart::theRestIsNotMadeWorse_data()
{
    QTest::addColumn<QString>("sample");
    QTest::addColumn<int>("held"); // island, by size; -1: a face is hidden
    QTest::newRow("the largest island") << QStringLiteral("machine") << 0;
    QTest::newRow("the second island") << QStringLiteral("machine") << 1;
    QTest::newRow("a face") << QStringLiteral("machine") << -1;
    // Here what may change is stretched more than the bound.
    QTest::newRow("an island stretched less than the others") << QStringLiteral("character") << 0;
}

//! Unwrapped anew beside an island that is locked, or a face that is hidden, a map of a document stays or
//! gets better, also where the bound is used up: the bound is for the mean of all.
void TestFreePart::theRestIsNotMadeWorse()
{
    QFETCH(QString, sample);
    QFETCH(int, held);
    Snapshot snapshot;
    snapshot.mesh = makeSample(sample).value().mesh;
    snapshot.keepTiles = true;
    const MeshData &mesh = *snapshot.mesh;
    UnwrapOptions options;
    options.packing.effort = 0.02;
    static std::map<QString, UnwrapResult> firstOf;
    if (!firstOf.contains(sample))
        firstOf[sample] = unwrapMesh(snapshot, options);
    const UnwrapResult &first = firstOf[sample];
    snapshot.uv = std::make_shared<const UvMatrix>(first.uv);
    snapshot.uvScale = layoutScale(mesh, first.uv);
    std::vector<std::vector<int>> islands = findCharts(mesh, first.uv).faces();
    std::stable_sort(islands.begin(), islands.end(),
                     [](const auto &a, const auto &b) { return a.size() > b.size(); });
    if (held < 0) {
        JobScope scope{std::vector<bool>(mesh.faceCount(), true), true, false};
        scope.faces[islands[0][islands[0].size() / 2]] = false;
        snapshot.scope = std::make_shared<const JobScope>(std::move(scope));
    } else {
        std::vector<IslandFlags> &flags = snapshot.editSteering().faceFlags;
        flags.resize(mesh.faceCount());
        for (const int face : islands[static_cast<std::size_t>(held)])
            flags[face].locked = 1;
    }
    options.quality = UnwrapQuality::Draft; // which finds a worse map, but does not give it
    const UnwrapResult again = unwrapMesh(snapshot, options);
    const auto seams = [&](const UvMatrix &uv) { return metrics::measureShapes(mesh, uv, 1).seamNorm; };
    QVERIFY(again.withinBound && again.unmet.empty());
    QVERIFY2(seams(again.uv) <= 1.02 * seams(first.uv),
             qPrintable(QStringLiteral("%1 -> %2").arg(seams(first.uv)).arg(seams(again.uv))));
    QCOMPARE(again.nothingGained, again.uv == first.uv);
    // Nor does a live solve, and it does not say that the map is above the bound.
    Snapshot begun = snapshot;
    begun.settings.start = StartMode::ExistingUv;
    std::atomic<bool> stop = false;
    std::shared_ptr<const LiveMapResult> shown;
    LiveMap live([&](std::shared_ptr<const LiveMapResult> map) {
        shown = std::move(map);
        stop = true;
    });
    live.begin(std::make_shared<const Snapshot>(begun), {options.maxDistortion, options.packing});
    live.work({&stop, 1});
    QVERIFY(shown->uv == first.uv && shown->distortion <= options.maxDistortion && shown->withinBound);
    // A plain file gets what the search finds.
    snapshot.keepTiles = false;
    QVERIFY(!unwrapMesh(snapshot, options).nothingGained);
    // The length that is said on the way is that of the whole map.
    const std::optional<FreePart> part = FreePart::of(snapshot);
    const std::shared_ptr<const Soup> soup = Soup::build(part->snapshot().mesh);
    const std::optional<SeamedMap> own =
        seamedMapOf(*soup, part->partUv(first.uv), CutFlags(soup->mesh->edgePairs.size(), false));
    QVERIFY(std::abs(own->seamLength(*soup) / part->unit() + part->seamLengthOfRest() - seams(first.uv)) <
            1e-9);
}

QTEST_GUILESS_MAIN(TestFreePart)

} // namespace tst_freepart

#include "tst_freepart.moc"
