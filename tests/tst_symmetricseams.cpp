// Symmetric seams where the setting leaves them open: an unwrap makes them where they hardly cost more, and
// jobs that change a map keep them.
#include "model/document/cborvalues.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/liveproblem.h"
#include "solver/unwrap/symmetricseams.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QCborMap>
#include <QTest>

#include <numbers>

namespace tst_symmetricseams {

using namespace autocuts;
using test::MeshPtr;

namespace {

constexpr double price = 1.05; // what symmetric seams may cost

//! A banana of quads, symmetric across x. \param twisted it has no plane of symmetry
MeshPtr banana(bool twisted)
{
    constexpr int rings = 7, segments = 8;
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    const auto add = [&](double theta, double phi) {
        const double z = std::cos(theta);
        Vec3 p(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi) + z * z, 3 * z);
        if (twisted)
            p += Vec3(0.3 * p.z() * p.y(), 0.2 * p.x() * p.z(), 0);
        points.push_back(p);
    };
    const auto at = [&](int r, int s) { return 1 + (r - 1) * segments + s % segments; };
    add(0, 0);
    for (int r = 1; r < rings; ++r) {
        for (int s = 0; s < segments; ++s)
            add(std::numbers::pi * r / rings, 2 * std::numbers::pi * s / segments);
    }
    add(std::numbers::pi, 0);
    const int last = static_cast<int>(points.size()) - 1;
    for (int s = 0; s < segments; ++s) {
        faces.push_back({0, at(1, s), at(1, s + 1)});
        for (int r = 1; r + 1 < rings; ++r)
            faces.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)});
        faces.push_back({last, at(rings - 1, s + 1), at(rings - 1, s)});
    }
    return test::polygonMesh(points, faces);
}

Snapshot problemOf(MeshPtr mesh, SymmetryMode mode = SymmetryMode::Auto)
{
    Snapshot snapshot;
    snapshot.mesh = std::move(mesh);
    snapshot.keepTiles = true;
    snapshot.settings.symmetry = mode;
    return snapshot;
}

unwrap::UnwrapResult unwrapped(const Snapshot &snapshot, unwrap::UnwrapQuality quality, int threads = 2)
{
    unwrap::UnwrapOptions options;
    options.quality = quality;
    return unwrap::unwrapMesh(snapshot, options, {nullptr, threads});
}

//! With a map as the document's.
Snapshot withMap(Snapshot snapshot, const UvMatrix &uv)
{
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
    return snapshot;
}

//! A symmetric map of the banana, in a document that leaves symmetry open.
Snapshot symmetricMap()
{
    const Snapshot asked = problemOf(banana(false), SymmetryMode::On);
    Snapshot open = withMap(asked, unwrapped(asked, unwrap::UnwrapQuality::Draft).uv);
    open.settings.symmetry = SymmetryMode::Auto;
    return open;
}

} // namespace

class TestSymmetricSeams : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unwrapMakesThemWhereTheyAreCheap_data()
    {
        QTest::addColumn<MeshPtr>("mesh");
        QTest::addColumn<unwrap::UnwrapQuality>("quality");
        QTest::addColumn<bool>("made");
        QTest::newRow("standard") << banana(false) << unwrap::UnwrapQuality::Standard << true;
        QTest::newRow("draft") << banana(false) << unwrap::UnwrapQuality::Draft << false;
        QTest::newRow("not symmetric") << banana(true) << unwrap::UnwrapQuality::Standard << false;
        QTest::newRow("hard surface") << test::quadCube() << unwrap::UnwrapQuality::Standard << false;
    }

    void unwrapMakesThemWhereTheyAreCheap()
    {
        QFETCH(const MeshPtr, mesh);
        QFETCH(const unwrap::UnwrapQuality, quality);
        QFETCH(const bool, made);
        const unwrap::UnwrapResult found = unwrapped(problemOf(mesh), quality);
        QCOMPARE(found.symmetry.has_value(), made);
        QVERIFY(!found.symmetryMissed && found.withinBound);
        const unwrap::UnwrapResult free = unwrapped(problemOf(mesh, SymmetryMode::Off), quality);
        QVERIFY(!free.symmetry);
        if (!made) {
            QVERIFY(found.uv == free.uv);
            return;
        }
        QCOMPARE(*found.symmetry, 1.0);
        QCOMPARE(preference::symmetricShare(*mesh, *preference::findSymmetry(*mesh), found.cut), 1.0);
        QVERIFY2(found.seamLength <= price * free.seamLength,
                 qPrintable(QString::number(found.seamLength / free.seamLength)));
        QVERIFY(unwrapped(problemOf(mesh), quality, 1).uv == found.uv);
    }

    void steeringLeavesNothingOpen_data()
    {
        QTest::addColumn<Snapshot>("snapshot");
        QTest::addColumn<bool>("open");
        const Snapshot plain = symmetricMap();
        QTest::newRow("nothing") << plain << true;
        Snapshot snapshot = plain;
        snapshot.editSteering().pairState.assign(snapshot.mesh->cornerPairCount(), PairState::Free);
        snapshot.editSteering().pairState[4] = snapshot.editSteering().pairState[5] = PairState::Cut;
        QTest::newRow("a cut") << snapshot << false;
        snapshot = plain;
        snapshot.editSteering().pins.push_back({.soupCorner = 3, .target = Vec2(0.5, 0.5), .hard = true});
        QTest::newRow("a pin") << snapshot << false;
        snapshot = plain;
        snapshot.settings.seams = SeamMode::Keep;
        QTest::newRow("given seams") << snapshot << false;
        snapshot = plain;
        snapshot.settings.surface = SurfaceKind::HardSurface;
        QTest::newRow("hard surface") << snapshot << false;
        snapshot = plain;
        snapshot.settings.align = CreaseMode::On;
        QTest::newRow("straight") << snapshot << false;
        snapshot.settings.align = CreaseMode::Auto; // on hard surfaces only
        QTest::newRow("straight where it is hard") << snapshot << true;
    }

    void steeringLeavesNothingOpen()
    {
        QFETCH(Snapshot, snapshot);
        QFETCH(const bool, open);
        QCOMPARE(unwrap::isSymmetryOpen(snapshot), open);
        QCOMPARE(unwrap::settledSymmetry(snapshot), open ? SymmetryMode::On : SymmetryMode::Off);
        for (const SymmetryMode mode : {SymmetryMode::Off, SymmetryMode::On}) {
            snapshot.settings.symmetry = mode;
            QCOMPARE(unwrap::settledSymmetry(snapshot), mode);
        }
    }

    void finishingKeepsThem()
    {
        const Snapshot open = symmetricMap();
        const UvMatrix made = unwrap::finishMap({.snapshot = open}).uv;
        QVERIFY(unwrap::hasSymmetricSeams(withMap(open, made)));
    }

    //! As long as the document's map has them, and until the user steers.
    void aLiveSolveKeepsThem()
    {
        const Snapshot open = symmetricMap();
        Snapshot cut = open;
        cut.editSteering().pairState.assign(cut.mesh->cornerPairCount(), PairState::Free);
        cut.editSteering().pairState[4] = cut.editSteering().pairState[5] = PairState::Cut;
        unwrap::LiveProblem problem;
        problem.update(std::make_shared<const Snapshot>(cut), 1);
        QVERIFY(!problem.isSymmetric());
        problem.update(std::make_shared<const Snapshot>(open), 1);
        QVERIFY(problem.isSymmetric());
        problem.update(std::make_shared<const Snapshot>(cut), 1);
        QVERIFY(!problem.isSymmetric());
        problem.update(std::make_shared<const Snapshot>(open), 1);
        QVERIFY(problem.isSymmetric());
        const Snapshot free = problemOf(open.mesh, SymmetryMode::Off);
        Snapshot other = withMap(open, unwrapped(free, unwrap::UnwrapQuality::Draft).uv);
        QVERIFY(!unwrap::hasSymmetricSeams(other));
        problem.update(std::make_shared<const Snapshot>(other), 1);
        QVERIFY(!problem.isSymmetric());
        other.uv = nullptr;
        problem.update(std::make_shared<const Snapshot>(other), 1);
        QVERIFY(!problem.isSymmetric());
    }

    //! Former versions wrote a switch.
    void oldSessionsAreRead_data()
    {
        QTest::addColumn<bool>("on");
        QTest::addColumn<SymmetryMode>("mode");
        QTest::newRow("on") << true << SymmetryMode::On;
        QTest::newRow("off") << false << SymmetryMode::Auto;
    }
    void oldSessionsAreRead()
    {
        QFETCH(const bool, on);
        QFETCH(const SymmetryMode, mode);
        CborReader reader(QCborMap{{QStringLiteral("symmetry"), on}});
        QCOMPARE(readSolveSettings(reader).symmetry, mode);
        QVERIFY(!reader.failed());
    }
};

QTEST_GUILESS_MAIN(TestSymmetricSeams)

} // namespace tst_symmetricseams

#include "tst_symmetricseams.moc"
