// The definite map of a live solve on its thread: valid at every moment, and it obeys at once.
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/live/mapkeeper.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/preference/seampreference.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"
#include "support/patience.h"
#include "support/props.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <functional>
#include <numeric>

namespace tst_mapkeeper {

using namespace autocuts;
using namespace autocuts::live;
using namespace autocuts::unwrap;

namespace {

using MapPtr = std::shared_ptr<const LiveMapResult>;

//! What a search minimises of the seams: creases cost less than their length. In the units of the mesh.
double seamCostOf(const Snapshot &snapshot, const UvMatrix &uv)
{
    const Snapshot preferred = preference::SeamPreference().applied(snapshot);
    const MeshData &mesh = *snapshot.mesh;
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    double cost = 0;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const Vec3 from = mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[0][0]));
        const Vec3 to = mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[1][0]));
        if (open[2 * e] || open[2 * e + 1])
            cost += preferred.edgeWeight(e) * (to - from).norm();
    }
    return cost;
}

//! A keeper on its thread, and the maps that it gave.
struct Bench : QObject
{
    explicit Bench(const test::MeshPtr &mesh, int threads = 2) : keeper(new MapKeeper(threads))
    {
        snapshot.mesh = mesh;
        snapshot.token = {1, 1, 1, 1};
        options.packing.effort = 0.02;
        keeper->moveToThread(&thread);
        connect(&thread, &QThread::finished, keeper, &QObject::deleteLater);
        connect(keeper, &MapKeeper::mapReady, this, [this] {
            if (const MapPtr map = keeper->takeMap())
                maps.push_back(map);
        });
        connect(keeper, &MapKeeper::rests, this, [this] { rests = rests || keeper->takeRest(); });
        thread.start();
    }
    ~Bench() override
    {
        keeper->pause();
        thread.quit();
        thread.wait();
    }

    void start()
    {
        rests = false;
        keeper->start(std::make_shared<const Snapshot>(snapshot), options);
        keeper->run();
    }
    //! Starts from a map.
    void startFrom(const UvMatrix &uv)
    {
        snapshot.uv = std::make_shared<const UvMatrix>(uv);
        snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
        snapshot.settings.start = StartMode::ExistingUv;
        start();
    }
    void steer(const std::function<void(Steering &)> &change, bool pulled = false,
               const MapPtr &back = nullptr)
    {
        change(snapshot.editSteering());
        ++snapshot.token.steering;
        rests = false;
        keeper->update(std::make_shared<const Snapshot>(snapshot), options, pulled, back);
    }
    bool waitFor(const std::function<bool()> &what) { return QTest::qWaitFor(what, test::patience); }
    bool hasMap()
    {
        return waitFor([this] { return !maps.empty(); });
    }
    //! Until there is a map that was made for the last steering.
    bool obeys()
    {
        return waitFor(
            [this] { return !maps.empty() && maps.back()->token.steering == snapshot.token.steering; });
    }
    bool comesToRest()
    {
        return waitFor([this] { return rests; });
    }
    QString problem(const LiveMapResult &map) const
    {
        const metrics::UvMetrics figures = metrics::measureUv(*snapshot.mesh, map.uv);
        if (figures.flipped > 0 || figures.overlapPairs > 0)
            return QStringLiteral("%1 flips, %2 overlaps").arg(figures.flipped).arg(figures.overlapPairs);
        if (std::abs(figures.tileDirichlet - map.distortion) > 1e-3 || figures.charts != map.islands)
            return QStringLiteral("it says D %1 and %2 islands").arg(map.distortion).arg(map.islands);
        if (std::abs(figures.seamNorm - map.seamLength) > 1e-9)
            return QStringLiteral("it says seams of %1, not %2").arg(map.seamLength).arg(figures.seamNorm);
        return {};
    }
    QString problems() const
    {
        QStringList all;
        for (const MapPtr &map : maps) {
            if (const QString one = problem(*map); !one.isEmpty())
                all << one;
        }
        return all.join(u'\n');
    }

    QThread thread;
    MapKeeper *keeper;
    Snapshot snapshot;
    LiveMapOptions options;
    std::vector<MapPtr> maps;
    bool rests = false;
};

void setState(Steering &steering, const MeshData &mesh, const std::vector<int> &edges, PairState state)
{
    steering.pairState.resize(mesh.cornerPairCount(), PairState::Free);
    for (const int e : edges)
        steering.pairState[2 * e] = steering.pairState[2 * e + 1] = state;
}

std::vector<int> edgesOf(const MapPtr &map, bool cut, int count)
{
    std::vector<int> edges;
    for (int e = 0; e < static_cast<int>(map->cut.size()) && static_cast<int>(edges.size()) < count; ++e) {
        if (map->cut[e] == cut)
            edges.push_back(e);
    }
    return edges;
}

bool areCut(const MapPtr &map, const std::vector<int> &edges, bool cut)
{
    return std::all_of(edges.begin(), edges.end(), [&](int e) { return map->cut[e] == cut; });
}

} // namespace

class TestMapKeeper : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyMapIsValidAndTheLastOneIsGood_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"sphere", "turned sphere", "torus", "bumpycube", "grid"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void everyMapIsValidAndTheLastOneIsGood()
    {
        QFETCH(QString, name);
        const test::MeshPtr mesh = name == QLatin1String("sphere")  ? test::sphere(6, 8)
                                   : name == QLatin1String("torus") ? test::torus(18, 10)
                                                                    : test::meshNamed(name);
        Bench bench(mesh);
        bench.start();
        QVERIFY(bench.comesToRest());
        QVERIFY(!bench.maps.empty());
        QCOMPARE(bench.problems(), QString());
        // Once the bound is met, it stays met.
        bool met = false;
        for (const MapPtr &map : bench.maps) {
            QVERIFY(!met || map->withinBound);
            met = map->withinBound;
        }
        QVERIFY(met);
        const UnwrapResult unwrapped = unwrapMesh(bench.snapshot, {});
        const double length = bench.maps.back()->seamLength;
        QVERIFY2(length <= 1.1 * unwrapped.seamLength,
                 qPrintable(QStringLiteral("%1 against %2").arg(length).arg(unwrapped.seamLength)));
    }

    //! A solve that finds nothing better leaves the document's map as it is, to the last bit.
    void aGoodMapStaysUntilItIsBeaten_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"sphere", "torus", "machine"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void aGoodMapStaysUntilItIsBeaten()
    {
        QFETCH(QString, name);
        Bench bench(test::meshNamed(name));
        UvMatrix before = unwrapMesh(bench.snapshot, {}).uv;
        bench.startFrom(before);
        QVERIFY(bench.hasMap());
        QVERIFY(bench.waitFor([&] { return bench.rests || bench.maps.size() > 20; }));
        QCOMPARE(bench.problems(), QString());
        const metrics::UvMetrics was = metrics::measureUv(*bench.snapshot.mesh, before);
        const double costBefore = seamCostOf(bench.snapshot, before);
        for (const MapPtr &map : bench.maps) {
            const double cost = seamCostOf(bench.snapshot, map->uv);
            QVERIFY2(map->uv == before || cost < costBefore || map->distortion < was.symDirichlet,
                     qPrintable(QStringLiteral("seams cost %1, then %2; D %3, then %4")
                                    .arg(costBefore)
                                    .arg(cost)
                                    .arg(was.symDirichlet)
                                    .arg(map->distortion)));
        }
        QCOMPARE(bench.maps.front()->uv, before);
        // The margin is halved at most twice for islands to stay.
        const double margin = bench.options.packing.margin / bench.options.packing.textureSize;
        const metrics::UvMetrics last = metrics::measureUv(*bench.snapshot.mesh, bench.maps.back()->uv);
        QVERIFY2(last.charts == 1 || last.minGutter >= 0.249 * margin,
                 qPrintable(QStringLiteral("%1, %2 at first, margin %3")
                                .arg(last.minGutter)
                                .arg(was.minGutter)
                                .arg(margin)));
    }

    void aTighterBoundIsMet()
    {
        Bench bench(test::sphere(6, 8));
        bench.start();
        QVERIFY(bench.comesToRest());
        QVERIFY(bench.maps.back()->distortion > 4.03);
        bench.options.maxDistortion = 4.03;
        bench.steer([](Steering &) {});
        QVERIFY(bench.comesToRest());
        QVERIFY(bench.maps.back()->withinBound);
        QVERIFY(bench.maps.back()->distortion <= 4.03);
        QCOMPARE(bench.problems(), QString());
    }

    //! As when an artist draws a rectangle first, then presses Space.
    void aSolveBeginsWithARectangle()
    {
        Bench bench(test::sphere(6, 8));
        bench.startFrom(unwrapMesh(bench.snapshot, {}).uv);
        bench.keeper->pause();
        std::vector<int> all(bench.snapshot.mesh->soupCornerCount());
        std::iota(all.begin(), all.end(), 0);
        const Vec2 low(0.5, 0.25), high(0.75, 0.5);
        bench.snapshot.editSteering().rectangles = {
            {low / bench.snapshot.uvScale, high / bench.snapshot.uvScale, all, true, 1}};
        ++bench.snapshot.token.steering;
        bench.start();
        QVERIFY(bench.obeys());
        QVERIFY(bench.comesToRest());
        QVERIFY(bench.maps.back()->unmet.rectangles.empty());
        const UvMatrix &uv = bench.maps.back()->uv;
        QVERIFY((uv.rowwise() - low.transpose()).minCoeff() > -1e-9);
        QVERIFY((uv.rowwise() - high.transpose()).maxCoeff() < 1e-9);
        QCOMPARE(bench.problems(), QString());
    }

    //! The document sends its state again while the thread is busy: the start from its map stays one.
    void anEditBeforeTheStartDoesNotChangeIt()
    {
        Bench bench(test::meshNamed(QStringLiteral("sphere")));
        UvMatrix before = unwrapMesh(bench.snapshot, {}).uv;
        QSemaphore goesOn;
        QMetaObject::invokeMethod(
            bench.keeper, [&] { goesOn.acquire(); }, Qt::QueuedConnection);
        bench.startFrom(before);
        bench.snapshot.settings.start = SolveSettings().start;
        bench.steer([](Steering &) {});
        goesOn.release();
        QVERIFY(bench.hasMap());
        QCOMPARE(bench.maps.front()->uv, before);
    }

    void copiesEndUpAlike_data()
    {
        QTest::addColumn<bool>("hasMap");
        QTest::newRow("anew") << false;
        QTest::newRow("from a map") << true;
    }
    void copiesEndUpAlike()
    {
        QFETCH(bool, hasMap);
        test::props::Model spheres;
        for (int i = 0; i < 4; ++i)
            spheres.add(test::props::moved(test::props::sphere(6, 1.5), {9.0 * i, 0, 0}));
        Bench bench(spheres.mesh());
        const MeshData &mesh = *bench.snapshot.mesh;
        if (hasMap) { // in which they differ
            Snapshot different = bench.snapshot;
            different.settings.alike = AlikeMode::Off;
            UnwrapOptions draft;
            draft.quality = UnwrapQuality::Draft;
            bench.startFrom(unwrapMesh(different, draft).uv);
        } else
            bench.start();
        QVERIFY(bench.comesToRest());
        std::vector<double> seams(static_cast<std::size_t>(mesh.componentCount), 0);
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            if (bench.maps.back()->cut[e])
                seams[mesh.component[mesh.edgePairs[e].triangle[0]]] += mesh.edgePairs[e].length;
        }
        for (const double length : seams)
            QVERIFY2(std::abs(length - seams[0]) < 1e-9, qPrintable(QString::number(length - seams[0])));
        QVERIFY(seams[0] > 0);
    }

    //! Flat faces are nets in the live solve, too.
    void flatModelsUnfold_data()
    {
        QTest::addColumn<bool>("hasMap");
        QTest::newRow("anew") << false;
        QTest::newRow("from a stretched map") << true;
    }
    void flatModelsUnfold()
    {
        QFETCH(bool, hasMap);
        Bench bench(test::props::column(6, 1, 1, 3).mesh());
        if (hasMap) {
            UvMatrix stretched = unwrapMesh(bench.snapshot, {}).uv;
            stretched.col(0) *= 1.2;
            bench.startFrom(stretched);
        } else
            bench.start();
        QVERIFY(bench.comesToRest());
        const LiveMapResult &last = *bench.maps.back();
        QVERIFY2(last.distortion < 4 + 1e-6, qPrintable(QString::number(last.distortion, 'g', 10)));
        QVERIFY(last.islands < bench.snapshot.mesh->faceCount() / 2);
        QCOMPARE(bench.problem(last), QString());
    }

    //! What was found before a pause is where it goes on.
    void itGoesOnAfterAPause()
    {
        Bench bench(test::sphere(6, 8));
        bench.start();
        QVERIFY(bench.waitFor([&] { return !bench.maps.empty() && bench.maps.back()->withinBound; }));
        bench.keeper->pause();
        const std::size_t before = bench.maps.size();
        const double length = bench.maps.back()->seamLength;
        bench.rests = false;
        bench.keeper->run();
        QVERIFY(bench.comesToRest());
        for (std::size_t m = before; m < bench.maps.size(); ++m) {
            QVERIFY(bench.maps[m]->withinBound);
            QVERIFY(bench.maps[m]->seamLength <= length + 1e-9);
        }
        QVERIFY(bench.maps.size() > before);
    }

    void cutsAndJoinsAreObeyed()
    {
        Bench bench(test::sphere(8, 10));
        bench.start();
        QVERIFY(bench.comesToRest());
        const std::vector<int> cuts = edgesOf(bench.maps.back(), false, 12);
        bench.steer([&](Steering &s) { setState(s, *bench.snapshot.mesh, cuts, PairState::Cut); });
        QVERIFY(bench.obeys());
        QVERIFY(areCut(bench.maps.back(), cuts, true));
        const std::vector<int> seam = edgesOf(bench.maps.back(), true, 200);
        std::vector<int> joins;
        for (const int e : seam) {
            if (std::find(cuts.begin(), cuts.end(), e) == cuts.end() && joins.size() < 8)
                joins.push_back(e);
        }
        QVERIFY(!joins.empty());
        bench.steer([&](Steering &s) { setState(s, *bench.snapshot.mesh, joins, PairState::Joined); });
        QVERIFY(bench.obeys());
        QVERIFY(areCut(bench.maps.back(), cuts, true));
        QVERIFY(areCut(bench.maps.back(), joins, false));
        QVERIFY(bench.comesToRest());
        QVERIFY(areCut(bench.maps.back(), cuts, true));
        QVERIFY(areCut(bench.maps.back(), joins, false));
        // Taken back, the cuts close again.
        bench.steer([&](Steering &s) { s.pairState.clear(); });
        QVERIFY(bench.obeys());
        QVERIFY(bench.comesToRest());
        QVERIFY(!areCut(bench.maps.back(), cuts, true));
        QCOMPARE(bench.problems(), QString());
    }

    void pinsAndRectanglesAreObeyed()
    {
        Bench bench(test::sphere(6, 8));
        bench.start();
        QVERIFY(bench.comesToRest());
        bench.startFrom(bench.maps.back()->uv);
        QVERIFY(bench.comesToRest());
        const double scale = bench.snapshot.uvScale;
        const int corner = bench.snapshot.mesh->cornerOfSoup(30);
        const Vec2 place =
            bench.maps.back()->uv.row(corner).transpose() + Eigen::RowVector2d(0.05, 0.02).transpose();
        bench.steer([&](Steering &s) { s.pins.push_back({30, place / scale, true, 1}); });
        QVERIFY(bench.obeys());
        QVERIFY((bench.maps.back()->uv.row(corner).transpose() - place).norm() < 1e-9);
        QVERIFY(bench.comesToRest());
        QVERIFY((bench.maps.back()->uv.row(corner).transpose() - place).norm() < 1e-9);
        std::vector<int> all(bench.snapshot.mesh->soupCornerCount());
        for (int c = 0; c < static_cast<int>(all.size()); ++c)
            all[c] = c;
        bench.steer([&](Steering &s) {
            s.pins.clear();
            s.rectangles.push_back({Vec2(2, 0) / scale, Vec2(3.2, 1.2) / scale, all});
        });
        QVERIFY(bench.obeys());
        QVERIFY(bench.comesToRest());
        const UvMatrix &uv = bench.maps.back()->uv;
        QVERIFY(uv.col(0).minCoeff() > 1.99 && uv.col(0).maxCoeff() < 3.21);
        QVERIFY(uv.col(1).minCoeff() > -0.01 && uv.col(1).maxCoeff() < 1.21);
        QCOMPARE(bench.problems(), QString());
    }

    void aLockedIslandKeepsItsBits()
    {
        const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                        {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}};
        const test::MeshPtr mesh = test::polygonMesh(
            corners,
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {4, 7, 6}});
        Bench bench(mesh);
        bench.start();
        QVERIFY(bench.comesToRest());
        const UvMatrix uv = bench.maps.back()->uv;
        QVERIFY(bench.maps.back()->islands > 1);
        bench.startFrom(uv);
        QVERIFY(bench.hasMap());
        const ChartMap charts = findCharts(*mesh, uv);
        bench.steer([&](Steering &s) {
            s.faceFlags.resize(mesh->faceCount());
            for (int face = 0; face < mesh->faceCount(); ++face)
                s.faceFlags[face].locked = charts.faceChart[face] == 0;
        });
        QVERIFY(bench.obeys());
        QVERIFY(bench.comesToRest());
        for (int face = 0; face < mesh->faceCount(); ++face) {
            for (int c = mesh->faceStart[face]; charts.faceChart[face] == 0 && c < mesh->faceStart[face + 1];
                 ++c)
                QVERIFY(bench.maps.back()->uv.row(c) == uv.row(c));
        }
        QCOMPARE(bench.problem(*bench.maps.back()), QString());
        // With all of them locked nothing may change, and it says so.
        QSignalSpy failed(bench.keeper, &MapKeeper::failed);
        bench.steer([&](Steering &s) {
            for (IslandFlags &flags : s.faceFlags)
                flags.locked = 1;
        });
        QVERIFY(bench.waitFor([&] { return failed.count() > 0; }));
        QVERIFY(bench.keeper->takeFailure());
        bench.steer([](Steering &s) { s.faceFlags.clear(); });
        bench.keeper->run();
        QVERIFY(bench.obeys());
    }

    void aPulledMapFollowsAndComesBack()
    {
        Bench bench(test::sphere(6, 8));
        bench.start();
        QVERIFY(bench.comesToRest());
        bench.startFrom(bench.maps.back()->uv);
        QVERIFY(bench.comesToRest());
        const MapPtr before = bench.maps.back();
        const int corner = bench.snapshot.mesh->cornerOfSoup(9);
        const Vec2 from = before->uv.row(corner).transpose(), to = from + Vec2(0.3, 0.1);
        bench.steer(
            [&](Steering &s) {
                s.pins.push_back({9, to / bench.snapshot.uvScale, false, 100});
            },
            true);
        QVERIFY(bench.obeys());
        const double distance = (bench.maps.back()->uv.row(corner).transpose() - to).norm();
        QVERIFY2(distance < 0.01, qPrintable(QString::number(distance)));
        bench.steer([](Steering &s) { s.pins.clear(); }, false, before);
        QVERIFY(bench.obeys());
        QVERIFY((bench.maps.back()->uv.row(corner).transpose() - from).norm() < 0.05);
        QCOMPARE(bench.problems(), QString());
    }

    void aPausedKeeperGivesNothing()
    {
        Bench bench(test::sphere(40, 60));
        bench.start();
        QVERIFY(bench.hasMap());
        bench.keeper->pause();
        QMetaObject::invokeMethod(
            bench.keeper, [] {}, Qt::BlockingQueuedConnection);
        QCoreApplication::processEvents();
        const std::size_t count = bench.maps.size();
        bench.steer([](Steering &s) { s.pairWeight.clear(); });
        QMetaObject::invokeMethod(
            bench.keeper, [] {}, Qt::BlockingQueuedConnection);
        QCoreApplication::processEvents();
        QCOMPARE(bench.maps.size(), count);
        bench.keeper->run();
        QVERIFY(bench.obeys());
    }

    void ordersFromAllSidesLeaveOneStateBehind()
    {
        Bench bench(test::sphere(6, 8));
        for (int run = 1; run <= 30; ++run) {
            bench.snapshot.mesh = test::sphere(run % 3 == 0 ? 12 : 8, 16);
            ++bench.snapshot.token.topology;
            bench.snapshot.editSteering() = {};
            bench.start();
            if (run % 2)
                bench.steer([&](Steering &s) {
                    setState(s, *bench.snapshot.mesh, {run, run + 7}, PairState::Cut);
                });
            if (run % 5 == 0)
                bench.keeper->setToken(bench.snapshot.token);
            bench.keeper->pause();
        }
        bench.keeper->run();
        QVERIFY(bench.waitFor(
            [&] { return !bench.maps.empty() && bench.maps.back()->token == bench.snapshot.token; }));
        QVERIFY(bench.comesToRest());
        QCOMPARE(bench.problem(*bench.maps.back()), QString());
    }
};

QTEST_GUILESS_MAIN(TestMapKeeper)

} // namespace tst_mapkeeper

#include "tst_mapkeeper.moc"
