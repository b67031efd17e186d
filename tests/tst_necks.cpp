// Arms that unfold at odd angles become islands of their own: where islands are cut through, and where not.
#include "solver/metrics/uvmetrics.h"
#include "solver/search/seamsearch.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>

namespace tst_necks {

using namespace autocuts;

namespace {

struct Part
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
};

//! A flat box with an arm, and another part. The neck of the arm is the only edge between the first two
//! faces.
test::MeshPtr boxWithArm(double degrees, const Part &other)
{
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), across(-std::sin(angle), std::cos(angle), 0);
    const auto arm = [&](double x, double y) -> Vec3 { return Vec3(4, 1, 0) + x * along + y * across; };
    std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0},      {4, 0.9, 0},    {4, 1.1, 0},   {4, 2, 0},
                             {0, 2, 0}, arm(0.6, -0.4), arm(3.6, -0.4), arm(3.6, 0.4), arm(0.6, 0.4)};
    std::vector<std::vector<int>> faces{{0, 1, 2, 3, 4, 5}, {2, 6, 7, 8, 9, 3}};
    const int first = static_cast<int>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (std::vector<int> face : other.faces) {
        for (int &vertex : face)
            vertex += first;
        faces.push_back(face);
    }
    return test::polygonMesh(points, faces);
}

//! Two squares. The map that the tests begin with has a seam between them.
const Part squares{{{10, 0, 0}, {15, 0, 0}, {20, 0, 0}, {10, 5, 0}, {15, 5, 0}, {20, 5, 0}},
                   {{0, 1, 4, 3}, {1, 2, 5, 4}}};
const Part cube{{{9, 0, 0}, {10, 0, 0}, {10, 1, 0}, {9, 1, 0}, {9, 0, 1}, {10, 0, 1}, {10, 1, 1}, {9, 1, 1}},
                {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

//! A box with an arm and the squares, laid out as they are.
struct Layout
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;
    SeamedMap map;

    explicit Layout(double degrees)
    {
        const test::MeshPtr mesh = boxWithArm(degrees, squares);
        snapshot.mesh = mesh;
        snapshot.settings.align = CreaseMode::On;
        soup = Soup::build(mesh);
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            uv.row(c) = soup->scale * mesh->cornerPosition(c).head<2>().transpose();
        CutFlags cut;
        for (const EdgePair &edge : mesh->edgePairs)
            cut.push_back(mesh->triangleFace[edge.triangle[0]] == 2 &&
                          mesh->triangleFace[edge.triangle[1]] == 3);
        map = *seamedMapOf(*soup, uv, cut);
    }
    //! \returns true when the search cuts a neck; the map is then the one with it
    bool cutsNecks(const JobContext &job = {})
    {
        Snapshot aligned = snapshot;
        aligned.aligned = std::make_shared<const std::vector<bool>>(soup->mesh->componentCount, true);
        auto state = search::CutState::from(search::SeamGraph::build(soup, aligned), map, true);
        search::SeamSearch search(state, 1, {.mu = 0.1, .guarded = true, .job = job});
        search.anchor();
        const bool cut = search.cutNecks();
        map = state.map();
        return cut;
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
    QTest::newRow("along the box") << 0.0 << 3;
    QTest::newRow("nearly along the box") << 4.0 << 3;
    QTest::newRow("at an odd angle") << 30.0 << 4;
    QTest::newRow("diagonal") << 45.0 << 4;
}

void TestNecks::armsBecomeIslands()
{
    QFETCH(double, degrees);
    QFETCH(int, islands);
    Layout layout(degrees);
    QCOMPARE(layout.cutsNecks(), islands > 3);
    QCOMPARE(layout.islands(), islands);
    const double distortion = layout.map.distortion(*layout.soup);
    QVERIFY2(distortion < 4 + 1e-6, qPrintable(QString::number(distortion, 'g', 12)));
    QVERIFY(layout.map.validate(*layout.soup).empty());
    QVERIFY(!layout.cutsNecks());
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
}

void TestNecks::theHandDecides()
{
    QFETCH(std::function<void(Snapshot &)>, decide);
    Layout layout(30);
    decide(layout.snapshot);
    QVERIFY(!layout.cutsNecks());
    QCOMPARE(layout.islands(), 3);
}

void TestNecks::aStoppedJobCutsNothing()
{
    Layout layout(30);
    const std::atomic<bool> stop{true};
    QVERIFY(!layout.cutsNecks(&stop));
}

//! Unwrap and a live solve at rest cut necks, and only for maps that are to be straight.
void TestNecks::jobsCut()
{
    const auto snapshot = std::make_shared<Snapshot>();
    snapshot->mesh = boxWithArm(30, cube);
    snapshot->settings.align = CreaseMode::On;
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(*snapshot, {});
    const metrics::UvMetrics figures = metrics::measureUv(*snapshot->mesh, result.uv);
    QCOMPARE(figures.charts, 3);
    std::shared_ptr<const unwrap::LiveMapResult> last;
    unwrap::LiveMap live([&](std::shared_ptr<const unwrap::LiveMapResult> map) { last = std::move(map); });
    live.begin(snapshot, {});
    QVERIFY(live.work({}) && last);
    QCOMPARE(last->islands, 3);
    QCOMPARE(metrics::measureUv(*snapshot->mesh, last->uv).charts, 3);
    snapshot->settings.align = CreaseMode::Off;
    QCOMPARE(metrics::measureUv(*snapshot->mesh, unwrap::unwrapMesh(*snapshot, {}).uv).charts, 2);
}

QTEST_APPLESS_MAIN(TestNecks)

} // namespace tst_necks

#include "tst_necks.moc"
