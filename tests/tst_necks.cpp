// Arms that unfold at odd angles become islands of their own: where islands are cut through, and where not.
#include "solver/metrics/uvmetrics.h"
#include "solver/straight/necks.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>

using namespace autocuts;

namespace {

//! A flat box with an arm. Their neck is the only edge between them.
test::MeshPtr boxWithArm(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), across(-std::sin(angle), std::cos(angle), 0);
    const auto arm = [&](double x, double y) -> Vec3 { return Vec3(4, 1, 0) + x * along + y * across; };
    return test::polygonMesh({{0, 0, 0},
                              {4, 0, 0},
                              {4, 0.9, 0},
                              {4, 1.1, 0},
                              {4, 2, 0},
                              {0, 2, 0},
                              arm(0.6, -0.4),
                              arm(3.6, -0.4),
                              arm(3.6, 0.4),
                              arm(0.6, 0.4)},
                             {{0, 1, 2, 3, 4, 5}, {2, 6, 7, 8, 9, 3}});
}

//! The mesh, laid out as it is.
struct Layout
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;
    SeamedMap map;

    explicit Layout(const test::MeshPtr &mesh)
    {
        snapshot.mesh = mesh;
        snapshot.settings.align = CreaseMode::On;
        soup = Soup::build(mesh);
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            uv.row(c) = soup->scale * mesh->cornerPosition(c).head<2>().transpose();
        map = *seamedMapOf(*soup, uv, CutFlags(mesh->edgePairs.size(), false));
    }
    int islands() const { return CutMesh(*soup->mesh, map.cut).chartCount; }
};

} // namespace

class TestNecks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void armsBecomeIslands_data();
    void armsBecomeIslands();
    void theHandDecides_data();
    void theHandDecides();
    void aStoppedJobCutsNothing();
    void jobsCut();
};

void TestNecks::armsBecomeIslands_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<int>("islands");
    QTest::newRow("along the box") << 0.0 << 1;
    QTest::newRow("nearly along the box") << 4.0 << 1;
    QTest::newRow("at an odd angle") << 30.0 << 2;
    QTest::newRow("diagonal") << 45.0 << 2;
}

void TestNecks::armsBecomeIslands()
{
    QFETCH(double, degrees);
    QFETCH(int, islands);
    Layout layout(boxWithArm(degrees));
    const std::vector<double> before = layout.map.x;
    QCOMPARE(straight::cutNecks(*layout.soup, layout.snapshot, layout.map), islands > 1);
    QCOMPARE(layout.islands(), islands);
    QVERIFY(layout.map.x == before);
    QVERIFY(layout.map.validate(*layout.soup).empty());
    QVERIFY(!straight::cutNecks(*layout.soup, layout.snapshot, layout.map));
}

void TestNecks::theHandDecides_data()
{
    QTest::addColumn<std::function<void(Snapshot &)>>("decide");
    const auto row = [](const char *name, std::function<void(Snapshot &)> decide) {
        QTest::newRow(name) << std::move(decide);
    };
    row("joined",
        [](Snapshot &s) { s.editSteering().pairState.assign(s.mesh->cornerPairCount(), PairState::Joined); });
    row("painted against seams",
        [](Snapshot &s) { s.editSteering().pairWeight.assign(s.mesh->cornerPairCount(), 100); });
    row("pinned", [](Snapshot &s) { s.editSteering().pins.push_back({0, Vec2::Zero(), true, 1}); });
    row("given seams", [](Snapshot &s) { s.settings.seams = SeamMode::Keep; });
    row("symmetric seams", [](Snapshot &s) { s.settings.symmetry = true; });
    row("symmetric maps", [](Snapshot &s) { s.settings.mirrorMaps = true; });
}

void TestNecks::theHandDecides()
{
    QFETCH(std::function<void(Snapshot &)>, decide);
    Layout layout(boxWithArm(30));
    decide(layout.snapshot);
    QVERIFY(!straight::cutNecks(*layout.soup, layout.snapshot, layout.map));
    QCOMPARE(layout.islands(), 1);
}

void TestNecks::aStoppedJobCutsNothing()
{
    Layout layout(boxWithArm(30));
    const std::atomic<bool> stop{true};
    QVERIFY(!straight::cutNecks(*layout.soup, layout.snapshot, layout.map, &stop));
}

//! Unwrap and a live solve at rest cut necks, and only for maps that are to be straight.
void TestNecks::jobsCut()
{
    const auto snapshot = std::make_shared<Snapshot>(Layout(boxWithArm(30)).snapshot);
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(*snapshot, {});
    const metrics::UvMetrics figures = metrics::measureUv(*snapshot->mesh, result.uv);
    QCOMPARE(figures.charts, 2);
    std::shared_ptr<const unwrap::LiveMapResult> last;
    unwrap::LiveMap live([&](std::shared_ptr<const unwrap::LiveMapResult> map) { last = std::move(map); });
    live.begin(snapshot, {});
    QVERIFY(live.work({}) && last);
    QCOMPARE(last->islands, 2);
    QCOMPARE(metrics::measureUv(*snapshot->mesh, last->uv).charts, 2);
    snapshot->settings.align = CreaseMode::Off;
    QCOMPARE(metrics::measureUv(*snapshot->mesh, unwrap::unwrapMesh(*snapshot, {}).uv).charts, 1);
}

QTEST_APPLESS_MAIN(TestNecks)
#include "tst_necks.moc"
