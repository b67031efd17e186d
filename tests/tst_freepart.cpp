// What a job may change.
#include "model/plain/uvlayout.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

using namespace autocuts;
using namespace autocuts::unwrap;

class TestFreePart : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pinnedIslandsStay_data();
    void pinnedIslandsStay();
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

QTEST_GUILESS_MAIN(TestFreePart)
#include "tst_freepart.moc"
