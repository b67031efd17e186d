// What the user is told of the results of map jobs: facts as data, and a text for each.
#include "jobs/mapremarks.h"
#include "jobs/packmap.h"
#include "model/plain/uvlayout.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>

namespace tst_mapremarks {

using namespace autocuts;
using namespace autocuts::jobs;
using Kind = Remark::Kind;

namespace {

bool has(const Remarks &remarks, Kind kind)
{
    return std::ranges::any_of(remarks, [&](const Remark &remark) { return remark.kind == kind; });
}

test::MeshPtr tetrahedron()
{
    return test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

Snapshot snapshotOf(const test::MeshPtr &mesh)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    return snapshot;
}

//! Every triangle of a mesh in a map of its own place, as large as on the model.
UvMatrix apart(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const int triangle = c / 3, corner = c % 3;
        uv.row(c) << 0.1 * triangle + 0.05 * (corner == 1), 0.05 * (corner == 2);
    }
    return uv;
}

} // namespace

class TestMapRemarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! A new kind without a text would be an empty line.
    void everyKindHasAText()
    {
        for (int i = 0; i <= static_cast<int>(Kind::IslandsPacked); ++i) {
            Remark remark{static_cast<Kind>(i), 3, {QStringLiteral("name")}, {4, 5}, 4.1};
            QVERIFY2(!textOf(remark).isEmpty(), qPrintable(QString::number(i)));
        }
    }

    void whatIsNotObeyedIsSaidWithItsItems()
    {
        unwrap::UnmetSteering unmet;
        QVERIFY(remarksOn(unmet).empty());
        unmet.pins = {3};
        unmet.joins = {5, 7};
        unmet.bent = {1};
        unmet.missingSeams = {2};
        unmet.rectangles = {0};
        const Remarks remarks = remarksOn(unmet);
        QCOMPARE(remarks.size(), std::size_t(5));
        QCOMPARE(static_cast<int>(remarks.front().kind), static_cast<int>(Kind::UnmetPins));
        const auto joins = std::ranges::find(remarks, Kind::UnmetJoins, &Remark::kind);
        QCOMPARE(joins->items, std::vector<int>({5, 7}));
        QVERIFY(textOf(*joins).endsWith(QLatin1String(": 2")));
    }

    void symmetry_data()
    {
        QTest::addColumn<double>("mirrored");
        QTest::addColumn<int>("kind"); // -1: nothing is said
        QTest::newRow("not at all") << 0.0 << static_cast<int>(Kind::NotSymmetric);
        QTest::newRow("in part") << 0.7 << static_cast<int>(Kind::PartlySymmetric);
        QTest::newRow("nearly") << 0.9995 << -1;
    }
    void symmetry()
    {
        QFETCH(double, mirrored);
        QFETCH(int, kind);
        const Remarks remarks = remarksOnSymmetry(mirrored);
        QCOMPARE(remarks.empty() ? -1 : static_cast<int>(remarks.front().kind), kind);
        if (kind == static_cast<int>(Kind::PartlySymmetric))
            QVERIFY(textOf(remarks.front()).startsWith(QLatin1String("30.0 %")));
    }

    void unwraps_data()
    {
        QTest::addColumn<int>("kind"); // of the first problem, -1: none
        for (const Kind kind : {Kind::NothingFree, Kind::NoRoom, Kind::NoRoomAtScale, Kind::MadeSmaller,
                                Kind::PatchesSoFar, Kind::OnlyPatches, Kind::UnmetJoins, Kind::AboveBound,
                                Kind::NotStraight, Kind::NoSymmetricCuts})
            QTest::addRow("%d", static_cast<int>(kind)) << static_cast<int>(kind);
        QTest::newRow("none") << -1;
    }
    //! Each outcome of the job has its remark.
    void unwraps()
    {
        QFETCH(int, kind);
        const Kind wanted = static_cast<Kind>(kind);
        Snapshot snapshot = snapshotOf(tetrahedron());
        unwrap::UnwrapOptions options;
        unwrap::UnwrapResult made;
        made.uv = apart(*snapshot.mesh);
        made.packed = wanted != Kind::NoRoom && wanted != Kind::NoRoomAtScale;
        options.packing.keepScale = wanted == Kind::NoRoomAtScale;
        made.nothingFree = wanted == Kind::NothingFree;
        made.madeSmaller = wanted == Kind::MadeSmaller;
        made.onlyPatches = wanted == Kind::PatchesSoFar || wanted == Kind::OnlyPatches;
        made.stopped = wanted == Kind::PatchesSoFar || wanted == Kind::NotStraight;
        if (wanted == Kind::UnmetJoins)
            made.unmet.joins = {1};
        made.withinBound = wanted != Kind::AboveBound;
        if (wanted == Kind::NotStraight)
            made.straight = false;
        made.symmetryMissed = wanted == Kind::NoSymmetricCuts;
        if (made.symmetryMissed)
            snapshot.settings.symmetry = SymmetryMode::On;
        const MapRemarks remarks = remarksOn(snapshot, options, made);
        QCOMPARE(remarks.problems.empty() ? -1 : static_cast<int>(remarks.problems.front().kind), kind);
    }

    void finishes()
    {
        unwrap::FinishInput input;
        input.snapshot = snapshotOf(tetrahedron());
        unwrap::FinishResult made;
        QVERIFY(has(remarksOn(input, made, true).problems, Kind::MapCancelled));
        made.uv = apart(*input.snapshot.mesh);
        made.distortion = 4.3;
        made.heldTogether = made.nothingGained = true;
        made.notReplaced = 2;
        made.straight = true;
        const MapRemarks remarks = remarksOn(input, made, true);
        for (const Kind problem : {Kind::HeldTogether, Kind::AboveBound})
            QVERIFY(has(remarks.problems, problem));
        for (const Kind note : {Kind::NothingGained, Kind::NotReplaced, Kind::Straight})
            QVERIFY(has(remarks.notes, note));
        QVERIFY(textOf(remarks.problems.back()).contains(QLatin1String("4.3000")));
    }

    //! A locked face lies under another one: no job takes them apart.
    void heldOverlaps()
    {
        Snapshot snapshot = snapshotOf(tetrahedron());
        unwrap::SeparateResult made;
        made.uv = apart(*snapshot.mesh);
        made.uv.middleRows(3, 3) = made.uv.topRows(3);
        QVERIFY(!has(remarksOn(snapshot, false, made).problems, Kind::HeldOverlaps));
        snapshot.editSteering().faceFlags.resize(4);
        snapshot.editSteering().faceFlags[0].locked = 1;
        QVERIFY(has(remarksOn(snapshot, false, made).problems, Kind::HeldOverlaps));
        made.uv = apart(*snapshot.mesh);
        QVERIFY(!has(remarksOn(snapshot, false, made).problems, Kind::HeldOverlaps));
    }

    void packing()
    {
        const Snapshot snapshot = snapshotOf(tetrahedron());
        const UvMatrix uv = apart(*snapshot.mesh);
        const unwrap::PackJob pack = unwrap::steeredPackJob(snapshot, {});
        const ChartMap charts = findCharts(*snapshot.mesh, uv);
        const PackedMap packed = packMap(*snapshot.mesh, charts, pack, {}, uv, {});
        QCOMPARE(packed.uv.rows(), uv.rows());
        QCOMPARE(textOf(packed.remarks.notes.front()), QStringLiteral("Islands packed: 4"));
        PackChoice tiles;
        tiles.density = 500;
        const PackedMap spread = packMap(*snapshot.mesh, charts, pack, tiles, uv, {});
        QCOMPARE(spread.uv.rows(), uv.rows());
        QVERIFY(!spread.remarks.notes.front().items.empty());
        const std::atomic<bool> stop = true;
        const PackedMap stopped = packMap(*snapshot.mesh, charts, pack, tiles, uv, {&stop});
        QCOMPARE(stopped.uv.rows(), 0);
        QVERIFY(has(stopped.remarks.problems, Kind::MapCancelled));
    }
};

QTEST_APPLESS_MAIN(TestMapRemarks)

} // namespace tst_mapremarks

#include "tst_mapremarks.moc"
