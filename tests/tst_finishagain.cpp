// Finishing maps again and again: none gets worse, and what cannot be bettered stays to the last bit.
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "model/samples/samples.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/standingmap.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <Eigen/Geometry>
#include <QTest>

namespace tst_finishagain {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! The document of the sample.
Snapshot machine()
{
    Snapshot snapshot;
    snapshot.mesh = makeSample(u"machine"_s).value().mesh;
    snapshot.keepTiles = true;
    return snapshot;
}

UvMatrix draftOf(const Snapshot &snapshot)
{
    unwrap::UnwrapOptions draft;
    draft.quality = unwrap::UnwrapQuality::Draft;
    return unwrap::unwrapMesh(snapshot, draft).uv;
}

unwrap::FinishResult finished(Snapshot &snapshot, const UvMatrix &uv)
{
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
    return unwrap::finishMap({.snapshot = snapshot});
}

//! A map of a small sphere, made once.
const UvMatrix &sphereMap()
{
    static const UvMatrix uv = [] {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 12);
        snapshot.keepTiles = true;
        return unwrap::unwrapMesh(snapshot, {}).uv;
    }();
    return uv;
}

//! The draft of the machine, made once.
const UvMatrix &machineDraft()
{
    static const UvMatrix uv = draftOf(machine());
    return uv;
}

//! What two rounds of Finish make of it, made once.
const std::vector<unwrap::FinishResult> &machineRounds()
{
    static const std::vector<unwrap::FinishResult> rounds = [] {
        Snapshot snapshot = machine();
        std::vector<unwrap::FinishResult> made{finished(snapshot, machineDraft())};
        made.push_back(finished(snapshot, made.front().uv));
        return made;
    }();
    return rounds;
}

//! Per edge pair: true when it is a seam.
std::vector<bool> seamsOf(const MeshData &mesh, const UvMatrix &uv)
{
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    std::vector<bool> seams;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e)
        seams.push_back(open[2 * e] || open[2 * e + 1]);
    return seams;
}

//! Finishes until nothing is gained. Returns the number of rounds; 0 when they do not come to an end, or a
//! map that is said to stay changes, or one that is said to change stays.
int finishToTheEnd(Snapshot &snapshot, UvMatrix &uv, int most)
{
    for (int round = 1; round <= most; ++round) {
        const unwrap::FinishResult made = finished(snapshot, uv);
        if (made.nothingGained != (made.uv == uv))
            return 0;
        uv = made.uv;
        if (made.nothingGained)
            return round;
    }
    return 0;
}

} // namespace

class TestFinishAgain : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Stiff flat regions count a hundred times: what is bent less than is seen decides nothing, also at the
    //! bound.
    void bendThatNobodySees_data()
    {
        QTest::addColumn<double>("bounded");
        QTest::addColumn<double>("cost");
        QTest::addColumn<bool>("better");
        QTest::newRow("bent a little more, and cheaper") << 4.13 << 1.9 << true;
        QTest::newRow("bent a little more, at the same price") << 4.13 << 2.0 << false;
        QTest::newRow("hardly cheaper") << 4.09 << 1.995 << false;
        QTest::newRow("visibly bent, and cheaper") << 4.3 << 1.9 << false;
        QTest::newRow("bent less, and cheaper") << 4.02 << 1.9 << true;
        QTest::newRow("bent a little less, and dearer") << 4.05 << 2.1 << false;
    }
    void bendThatNobodySees()
    {
        QFETCH(double, bounded);
        QFETCH(double, cost);
        unwrap::Candidate standing, map;
        standing.bounded = 4.09;
        standing.distortion = map.distortion = 4.05;
        standing.seamCost = 2;
        map.bounded = bounded;
        map.seamCost = cost;
        QTEST(unwrap::beats(map, standing, 4.1), "better");
    }

    //! Islands that Finish changes keep the margin of the layout, and no map is taken that is worse.
    void finishingAgainMakesNothingWorse()
    {
        const std::shared_ptr<const MeshData> mesh = machine().mesh;
        UvMatrix uv = machineDraft();
        const double margin = packing::PackOptions().margin / packing::PackOptions().textureSize;
        for (int round = 0; round < 2; ++round) {
            const metrics::UvMetrics before = metrics::measureUv(*mesh, uv);
            QVERIFY(before.minGutter >= 0.999 * margin);
            const unwrap::FinishResult &made = machineRounds()[std::size_t(round)];
            const metrics::UvMetrics after = metrics::measureUv(*mesh, made.uv);
            QVERIFY2(after.minGutter >= 0.999 * margin,
                     qPrintable(QString::number(after.minGutter / margin)));
            QVERIFY2(after.seamNorm <= before.seamNorm || after.symDirichlet <= before.symDirichlet,
                     qPrintable(u"round %1: %2 to %3"_s.arg(round).arg(before.seamNorm).arg(after.seamNorm)));
            QCOMPARE(made.nothingGained, made.uv == uv);
            if (round == 1)
                QVERIFY(made.nothingGained);
            uv = made.uv;
        }
    }

    void finishingComesToAnEnd_data()
    {
        QTest::addColumn<bool>("symmetry");
        QTest::newRow("symmetric") << true;
        QTest::newRow("a rectangle") << false;
    }

    //! Finishing again and again leaves the map as it is in the end, to the last bit.
    void finishingComesToAnEnd()
    {
        QFETCH(bool, symmetry);
        Snapshot snapshot = machine();
        snapshot.settings.symmetry = symmetry ? SymmetryMode::On : SymmetryMode::Off;
        if (symmetry)
            snapshot.mesh = test::sphere(10, 12);
        UvMatrix uv = symmetry ? draftOf(snapshot) : machineDraft();
        snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
        if (!symmetry) { // around one of the islands
            const ChartMap charts = findCharts(*snapshot.mesh, uv);
            UvRectangle rectangle;
            Eigen::AlignedBox2d box;
            for (int s = 0; s < snapshot.mesh->soupCornerCount(); ++s) {
                if (charts.faceChart[snapshot.mesh->triangleFace[s / 3]] != 0)
                    continue;
                rectangle.soupCorners.push_back(s);
                box.extend(Vec2(uv.row(snapshot.mesh->cornerOfSoup(s))));
            }
            rectangle.lower = (box.min() - Vec2::Constant(0.001)) / snapshot.uvScale;
            rectangle.upper = (box.max() + Vec2::Constant(0.001)) / snapshot.uvScale;
            rectangle.hard = true;
            snapshot.editSteering().rectangles.push_back(rectangle);
        }
        unwrap::FinishResult made;
        for (int round = 0; round < 4 && !made.nothingGained; ++round) {
            snapshot.uv = std::make_shared<const UvMatrix>(uv);
            made = unwrap::finishMap({.snapshot = snapshot});
            uv = made.uv;
        }
        QVERIFY(made.nothingGained);
        QVERIFY(uv == *snapshot.uv);
    }

    void symmetricSeamsStaySymmetric()
    {
        Snapshot snapshot;
        snapshot.mesh = makeSample(u"character"_s).value().mesh;
        snapshot.keepTiles = true;
        snapshot.settings.symmetry = SymmetryMode::On;
        const std::optional<preference::MeshSymmetry> symmetry = preference::findSymmetry(*snapshot.mesh);
        QVERIFY(symmetry);
        const UvMatrix uv = draftOf(snapshot);
        QCOMPARE(preference::symmetricShare(*snapshot.mesh, *symmetry, seamsOf(*snapshot.mesh, uv)), 1.0);
        const unwrap::FinishResult made = finished(snapshot, uv);
        QVERIFY(!made.nothingGained);
        QCOMPARE(preference::symmetricShare(*snapshot.mesh, *symmetry, seamsOf(*snapshot.mesh, made.uv)),
                 1.0);
    }

    //! Where an island only has to move, all keep their shapes unless better ones are known.
    void islandsThatHaveToMoveKeepTheirShapes()
    {
        Snapshot snapshot = machine();
        QVERIFY(machineRounds().back().nothingGained);
        UvMatrix uv = machineRounds().back().uv;
        const metrics::UvMetrics before = metrics::measureUv(*snapshot.mesh, uv);
        const ChartMap charts = findCharts(*snapshot.mesh, uv);
        const int last = charts.count - 1;
        Eigen::AlignedBox2d box;
        for (int face = 0; face < snapshot.mesh->faceCount(); ++face) {
            for (int c = snapshot.mesh->faceStart[face];
                 charts.faceChart[face] == last && c < snapshot.mesh->faceStart[face + 1]; ++c)
                box.extend(Vec2(uv.row(c)));
        }
        const Vec2 move = Vec2(0.5, 0.5) - box.center(); // onto others
        for (int face = 0; face < snapshot.mesh->faceCount(); ++face) {
            for (int c = snapshot.mesh->faceStart[face];
                 charts.faceChart[face] == last && c < snapshot.mesh->faceStart[face + 1]; ++c)
                uv.row(c) += move.transpose();
        }
        QVERIFY(metrics::measureUv(*snapshot.mesh, uv).overlapPairs > 0);
        const unwrap::FinishResult made = finished(snapshot, uv);
        const metrics::UvMetrics after = metrics::measureUv(*snapshot.mesh, made.uv);
        QCOMPARE(after.overlapPairs, 0);
        // What seams cost decides: those on sharp edges may be a little longer.
        QVERIFY2(after.seamNorm < 1.001 * before.seamNorm,
                 qPrintable(u"%1 to %2"_s.arg(before.seamNorm).arg(after.seamNorm)));
    }

    //! Soft pins are obeyed by and by; a map that they do not pull any nearer is not taken.
    void softPinsComeToAnEnd()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 12);
        snapshot.keepTiles = true;
        UvMatrix uv = sphereMap();
        snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
        Steering steering = *snapshot.steering;
        for (const int corner : {0, 100}) {
            const Vec2 place = Vec2(uv.row(snapshot.mesh->cornerOfSoup(corner))) / snapshot.uvScale;
            steering.pins.push_back({corner, place + Vec2(0.05, corner > 0 ? 0.1 : 0), false, 1});
        }
        snapshot.steering = std::make_shared<const Steering>(steering);
        const double pull = unwrap::Wishes::of(snapshot, uv).pull;
        QVERIFY(finishToTheEnd(snapshot, uv, 6) > 1);
        QVERIFY(unwrap::Wishes::of(snapshot, uv).pull < 0.5 * pull);
    }

    //! What is asked for straight is made straight once; then the map stays.
    void straightMapsComeToAnEnd()
    {
        Snapshot snapshot;
        snapshot.mesh = test::turnedSphere(6, 8);
        snapshot.keepTiles = true;
        UvMatrix uv = draftOf(snapshot);
        snapshot.settings.align = CreaseMode::On;
        const double aligned = unwrap::Wishes::of(snapshot, uv).aligned;
        QVERIFY(finishToTheEnd(snapshot, uv, 5) > 1);
        QVERIFY(unwrap::Wishes::of(snapshot, uv).aligned > aligned + 0.1);
    }

    //! A map that Finish cannot better stays, but not where something else is asked for.
    void whatIsAskedForAnewIsDone()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 12);
        snapshot.keepTiles = true;
        const auto finish = [&](double maxDistortion) {
            snapshot.uvScale = layoutScale(*snapshot.mesh, *snapshot.uv);
            return unwrap::finishMap({.snapshot = snapshot, .maxDistortion = maxDistortion});
        };
        constexpr double bound = 4.1;
        UvMatrix uv = sphereMap();
        unwrap::FinishResult made;
        for (int round = 0; round < 4 && !made.nothingGained; ++round) {
            snapshot.uv = std::make_shared<const UvMatrix>(uv);
            made = finish(bound);
            uv = made.uv;
        }
        QVERIFY(made.nothingGained);
        QVERIFY(uv == *snapshot.uv);
        made = finish(4.05);
        QVERIFY(!made.nothingGained);
        QVERIFY(made.distortion <= 4.05);
        const Snapshot before = snapshot;
        const Vec2 place = Vec2(uv.row(snapshot.mesh->cornerOfSoup(0))) / snapshot.uvScale;
        snapshot.editSteering().pins.push_back({0, place + Vec2(0.2, 0), false, 100});
        made = finish(bound);
        QVERIFY(!made.nothingGained);
        QVERIFY(made.uv != uv);
        snapshot = before;
        snapshot.settings.energy = DistortionEnergy::Amips;
        QVERIFY(!finish(bound).nothingGained);
    }
};

QTEST_GUILESS_MAIN(TestFinishAgain)

} // namespace tst_finishagain

#include "tst_finishagain.moc"
