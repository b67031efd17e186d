// Drags during a live solve that are taken back.
#include "commands/newmap.h"
#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "model/samples/samples.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/unwrap.h"
#include "support/patience.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QTest>

#include <algorithm>

namespace tst_livedrags {

using namespace autocuts;

namespace {

//! Soup corners of the largest island.
std::vector<int> largestIsland(const MeshData &mesh, const UvMatrix &uv)
{
    std::vector<std::vector<int>> islands = findCharts(mesh, uv).faces();
    const auto largest = std::ranges::max_element(islands, {}, [](const auto &i) { return i.size(); });
    std::vector<int> corners;
    for (const int face : *largest) {
        for (const int corner : mesh.soupCornersOf(face))
            corners.push_back(corner);
    }
    return corners;
}

std::vector<Pin> pullsOf(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &corners,
                         const Vec2 &way)
{
    std::vector<Pin> pulls;
    for (const int corner : corners)
        pulls.push_back({corner, Vec2(uv.row(mesh.cornerOfSoup(corner))) + way, false, 100});
    return pulls;
}

} // namespace

class TestLiveDrags : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void escapeGivesTheMapBefore_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("pauses");
        for (const char *sample : {"bumpycube", "machine"}) {
            QTest::addRow("%s, paused at once", sample) << QString::fromLatin1(sample) << true;
            QTest::addRow("%s, going on", sample) << QString::fromLatin1(sample) << false;
        }
    }
    //! Bit for bit, also when the solve is paused or told something before its threads know of it.
    void escapeGivesTheMapBefore()
    {
        QFETCH(QString, name);
        QFETCH(bool, pauses);
        Workspace workspace;
        ShownMap shown(workspace);
        SolverController solver(workspace, shown);
        workspace.open(std::make_unique<Document>(makeSample(name).value()), {});
        Document &document = *workspace.document();
        const MeshData &mesh = document.mesh();
        unwrap::UnwrapOptions options;
        options.quality = unwrap::UnwrapQuality::Draft;
        options.packing = packing::tileOptions(document.packingSettings());
        pushCommand(
            newMapCommand(document, UvEdit::Unwrap, unwrap::unwrapMesh(makeSnapshot(document), options).uv));
        solver.run();
        QVERIFY(QTest::qWaitFor([&] { return solver.map() != nullptr; }, test::patience));
        // The drag begins with the map of that moment.
        const std::vector<int> island = largestIsland(mesh, solver.map()->uv);
        solver.setPulls(pullsOf(mesh, solver.map()->uv, island, {0, 0}), island);
        const UvMatrix before = solver.map()->uv;
        const auto isMoved = [&] {
            const int corner = mesh.cornerOfSoup(island.front());
            return (solver.map()->uv.row(corner) - before.row(corner)).norm() > 0.1;
        };
        for (int step = 1; step <= 10 || !isMoved(); ++step) {
            QVERIFY(step < 1000);
            solver.setPulls(pullsOf(mesh, before, island, std::min(step, 10) * Vec2(0.08, 0.06)), island);
            QTest::qWait(30);
        }
        const int maps = solver.status().iteration;
        solver.cancelPulls();
        QVERIFY(solver.map()->uv == before);
        if (pauses) {
            solver.pause();
            QVERIFY(
                QTest::qWaitFor([&] { return !solver.isRunning() && !solver.isPausing(); }, test::patience));
            QVERIFY(document.uv() == before);
            return;
        }
        // The keeper gives that map as well, then better ones.
        connect(&solver, &SolverController::statusChanged, this, [&] {
            if (solver.status().iteration == maps + 2)
                QVERIFY(solver.map()->uv == before);
        });
        QVERIFY(QTest::qWaitFor([&] { return solver.status().iteration > maps + 2 || !solver.isRunning(); },
                                test::patience));
    }
};

QTEST_MAIN(TestLiveDrags)

} // namespace tst_livedrags

#include "tst_livedrags.moc"
