// The live solve beside the document: what is shown, what is put into the history, what edits do to it.
#include "commands/changesettings.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "model/samples/samples.h"
#include "solver/metrics/uvmetrics.h"
#include "support/editsupport.h"
#include "support/mapedits.h"
#include "support/meshbuilders.h"
#include "support/patience.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

namespace tst_solvercontroller {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace autocuts::live;
using namespace autocuts::metrics;

namespace {

//! A workspace with a model, and the solver on it.
struct Studio
{
    Workspace workspace;
    ShownMap shown{workspace};
    SolverController solver{workspace, shown};

    explicit Studio(const char *sample = "bumpycube")
        : Studio(makeSample(QString::fromLatin1(sample)).value())
    {}
    explicit Studio(const test::MeshPtr &mesh) : Studio(test::sceneOf(mesh)) {}
    explicit Studio(Scene scene)
    {
        DocumentState state = DocumentState::initial(std::move(scene));
        state.solveSettings.lambda = 0.1;
        state.solveSettings.delta = 0.02;
        workspace.open(Document::create(std::move(state)).value(), {});
        solver.setMode(SolveMode::Manual);
    }
    Document &document() { return *workspace.document(); }
    UndoStack &stack() { return document().undoStack(); }

    bool runsTo(int iteration)
    {
        solver.run();
        return QTest::qWaitFor([&] { return solver.status().iteration >= iteration; }, test::patience);
    }
    bool settles()
    {
        solver.pause();
        return QTest::qWaitFor([&] { return !solver.isPausing(); }, test::patience);
    }
    bool hasNoUvs() { return !document().uv().allFinite(); }
};

} // namespace

class TestSolverController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theEndOfAnotherRunDoesNotPause()
    {
        QSemaphore rests; // outlives the worker
        Studio studio(test::sphere(6, 8));
        SolveSettings settings = studio.document().solveSettings();
        settings.lambda = 0; // the start is the solution: the worker soon waits
        pushCommand(std::make_unique<ChangeSettings>(studio.document(), settings));
        connect(&studio.solver, &SolverController::workerRests, [&rests] { rests.release(); });
        studio.solver.run();
        // The worker says so while this thread is not listening, and another run begins.
        QVERIFY(rests.tryAcquire(1, test::patience));
        studio.workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("torus")).value()), {});
        studio.solver.setMode(SolveMode::Budget);
        studio.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration >= 3; }, test::patience));
        QVERIFY(studio.solver.isRunning());
    }

    void nothingHappensWithoutADocument()
    {
        Workspace workspace;
        ShownMap shown(workspace);
        SolverController solver(workspace, shown);
        solver.run();
        solver.step();
        solver.restart();
        solver.pause();
        QVERIFY(!solver.isRunning());
        bool called = false;
        solver.whenPaused([&] { called = true; });
        QVERIFY(called);
    }

    void aRunIsOneEntryOfTheHistory()
    {
        Studio studio;
        QVERIFY(studio.runsTo(20));
        QVERIFY(studio.solver.isRunning());
        QVERIFY(studio.shown.isLive());
        QVERIFY(studio.shown.uv().allFinite());
        QCOMPARE(studio.stack().count(), 0);
        QVERIFY(studio.hasNoUvs());

        QVERIFY(studio.settles());
        QVERIFY(!studio.solver.isRunning());
        QVERIFY(!studio.shown.isLive());
        QCOMPARE(studio.stack().count(), 1);
        const UvMatrix settled = studio.document().uv();
        const UvMetrics metrics = measureUv(studio.document().mesh(), settled);
        QCOMPARE(metrics.flipped, 0);
        QCOMPARE(metrics.uvDegenerate, 0);

        studio.stack().undo();
        QVERIFY(studio.hasNoUvs());
        QVERIFY(!studio.solver.canContinue());
        studio.stack().redo();
        QVERIFY(studio.document().uv() == settled);
    }

    void aPausedRunGoesOnWhereItWas()
    {
        Studio studio;
        QVERIFY(studio.runsTo(10));
        QVERIFY(studio.settles());
        const int iteration = studio.solver.status().iteration;
        QVERIFY(studio.solver.canContinue());
        QVERIFY(studio.runsTo(iteration + 5));
        QVERIFY(studio.settles());
        const std::vector<TracePoint> &trace = studio.solver.trace();
        for (std::size_t i = 1; i < trace.size(); ++i)
            QVERIFY(trace[i].iteration > trace[i - 1].iteration);
        QCOMPARE(trace.front().iteration, 1);
    }

    void settingsAndSteeringReachARun()
    {
        Studio studio;
        QVERIFY(studio.runsTo(3));
        const int before = studio.solver.status().iteration;
        SolveSettings settings = studio.document().solveSettings();
        settings.lambda = 0.25;
        settings.delta = 0.5;
        QVERIFY(pushCommand(std::make_unique<ChangeSettings>(studio.document(), settings)));
        QTRY_COMPARE_WITH_TIMEOUT(studio.solver.status().lambda, 0.25, test::patience);
        QCOMPARE(studio.solver.status().delta, 0.5);
        QVERIFY(studio.solver.isRunning());
        QVERIFY(studio.solver.status().iteration >= before);
    }

    void aSingleStepPausesByItself()
    {
        Studio studio;
        studio.solver.step();
        QTRY_VERIFY_WITH_TIMEOUT(!studio.solver.isRunning() && !studio.solver.isPausing(), test::patience);
        QCOMPARE(studio.solver.status().iteration, 1);
        studio.solver.step();
        QTRY_VERIFY_WITH_TIMEOUT(!studio.solver.isRunning() && !studio.solver.isPausing(), test::patience);
        QCOMPARE(studio.solver.status().iteration, 2);
    }

    void theBudgetEndsARun()
    {
        Studio studio;
        studio.solver.setMode(SolveMode::Budget);
        SolveSettings settings = studio.document().solveSettings();
        settings.maxDistortion = 4.3;
        pushCommand(std::make_unique<ChangeSettings>(studio.document(), settings));
        studio.solver.run();
        QTRY_VERIFY_WITH_TIMEOUT(!studio.solver.isRunning() && !studio.solver.isPausing(), test::patience);
        QVERIFY(studio.solver.status().converged);
        QCOMPARE(studio.stack().count(), 2); // the bound, and the run
        const UvMetrics metrics = measureUv(studio.document().mesh(), studio.document().uv());
        QCOMPARE(metrics.flipped, 0);
        QVERIFY2(metrics.symDirichlet < 4.4, qPrintable(QString::number(metrics.symDirichlet)));
        QVERIFY2(metrics.seamNorm < 12, qPrintable(QString::number(metrics.seamNorm)));
    }

    //! A run that finds nothing better says so when it ends.
    void aRunThatGainsNothingSaysSo()
    {
        Studio studio(test::torus(8, 6));
        studio.solver.setMode(SolveMode::Budget);
        const QSignalSpy said(&studio.solver, &SolverController::said);
        const auto ends = [&] {
            studio.solver.run();
            return QTest::qWaitFor([&] { return !studio.solver.isRunning() && !studio.solver.isPausing(); },
                                   test::patience);
        };
        QVERIFY(ends());
        QCOMPARE(said.count(), 0);
        for (int round = 0; round < 5 && said.isEmpty(); ++round) {
            const int entries = studio.stack().count();
            QVERIFY(ends());
            QCOMPARE(said.count(), studio.stack().count() == entries ? 1 : 0);
        }
        QCOMPARE(said.count(), 1);
    }

    //! A corner that is further away than numbers can say.
    void aSolveWithoutAMapEnds()
    {
        for (const SolveMode mode : {SolveMode::Budget, SolveMode::Manual}) {
            Studio studio;
            Scene scene;
            scene.mesh = test::polygonMesh(
                {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1e60, 1, 1}, {0, 1, 1}},
                {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}});
            studio.workspace.open(Document::create(DocumentState::initial(scene)).value(), {});
            studio.solver.setMode(mode);
            const QSignalSpy problems(&studio.solver, &SolverController::foundProblems);
            studio.solver.run();
            QVERIFY(
                QTest::qWaitFor([&] { return studio.solver.map() || problems.count() > 0; }, test::patience));
            QVERIFY(studio.settles());
            QVERIFY(studio.solver.map() || problems.count() > 0);
            bool paused = false;
            studio.solver.whenPaused([&] { paused = true; });
            QVERIFY(paused);
        }
    }

    void steeringByHandGoesOnFromTheBudget()
    {
        Studio studio;
        studio.solver.setMode(SolveMode::Budget);
        studio.solver.setLiveView(LiveView::Soup);
        QVERIFY(studio.runsTo(60));
        studio.solver.setMode(SolveMode::Manual);
        QVERIFY(studio.solver.isRunning());
        const SolveSettings &settings = studio.document().solveSettings();
        QCOMPARE(settings.lambda, studio.solver.status().lambda);
        QCOMPARE(settings.delta, studio.solver.status().delta);
        QVERIFY(settings.delta != 0.02);
        const auto steps = [&] { return studio.solver.status().iteration; };
        const int before = steps();
        QTRY_VERIFY_WITH_TIMEOUT(steps() > before && studio.solver.status().delta == settings.delta,
                                 test::patience);
        const int then = steps();
        QTRY_VERIFY_WITH_TIMEOUT(steps() > then + 5, test::patience);
        QCOMPARE(studio.solver.status().delta, settings.delta);
    }

    void restartForgetsTheMap()
    {
        Studio studio;
        QVERIFY(studio.runsTo(30));
        QVERIFY(studio.settles());
        studio.solver.restart();
        QTRY_VERIFY_WITH_TIMEOUT(studio.solver.status().iteration > 0, test::patience);
        QVERIFY(studio.solver.status().iteration < 30 || studio.solver.trace().front().iteration == 1);
        QVERIFY(studio.settles());
        QVERIFY(studio.document().uv() == studio.solver.map()->uv);
    }

    void anEditOfTheMapDropsTheLiveOne()
    {
        Studio studio;
        QVERIFY(studio.runsTo(5));
        UvMatrix flat = UvMatrix::Random(studio.document().mesh().cornerCount(), 2);
        QVERIFY(pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Move, flat)));
        QVERIFY(!studio.solver.isRunning());
        QVERIFY(!studio.shown.isLive());
        QCOMPARE(studio.stack().count(), 1);
        QVERIFY(studio.document().uv() == flat);
        // Nothing comes after: the next run's results follow all that the first one could say.
        QVERIFY(studio.runsTo(1));
        QCOMPARE(studio.stack().count(), 1);
        QVERIFY(studio.document().uv() == flat);
        QCOMPARE(studio.solver.trace().front().iteration, 1);
    }

    void whatWaitsForTheMapComesAfterIt()
    {
        Studio studio;
        studio.solver.run();
        int entries = -1;
        studio.solver.whenPaused([&] { entries = studio.stack().count(); });
        QCOMPARE(entries, -1);
        QTRY_COMPARE_WITH_TIMEOUT(entries, 1, test::patience);
    }

    //! A solve of some faces leaves all others as they are, also with a cut on the way; the next run is free.
    void aRunOnTheSelectionChangesNothingElse()
    {
        Studio studio("character");
        studio.solver.setMode(SolveMode::Budget);
        studio.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.map() && studio.solver.map()->withinBound; },
                                test::patience));
        QVERIFY(studio.settles());
        const UvMatrix before = studio.document().uv();
        const MeshData &mesh = studio.document().mesh();
        Selection arm;
        arm.mode = SelectionMode::Faces;
        for (int face = 0; face < mesh.faceCount() / 8; ++face)
            arm.faces << face;
        studio.document().setSelection(arm);
        studio.solver.runOnSelection();
        QVERIFY(studio.solver.isRunning());
        QVERIFY(studio.solver.isLimited());
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.map() != nullptr; }, test::patience));
        int edge = 0;
        while (mesh.edgePairs[edge].diagonal || mesh.triangleFace[mesh.edgePairs[edge].triangle[0]] > 20)
            ++edge;
        const std::vector<int> cut{edge};
        pushCommand(std::make_unique<SetSeamState>(studio.document(), SetSeamState::Edit::Cut,
                                                   cornerPairsOfEdges(mesh, cut)));
        QVERIFY(studio.settles());
        const UvMatrix &after = studio.document().uv();
        for (int face = 0; face < mesh.faceCount(); ++face) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                QVERIFY(arm.faces.contains(face) || after.row(c) == before.row(c));
        }
        const UvMetrics figures = measureUv(mesh, after);
        QCOMPARE(figures.flipped, 0);
        QCOMPARE(figures.overlapPairs, 0);
        studio.solver.run();
        QVERIFY(!studio.solver.isLimited());
        QVERIFY(studio.settles());
    }

    //! Without selected faces there is nothing to run on.
    void aRunOnNothingDoesNotBegin()
    {
        Studio studio;
        studio.solver.runOnSelection();
        QVERIFY(!studio.solver.isRunning());
    }

    void anotherDocumentEndsTheRun()
    {
        Studio studio;
        QVERIFY(studio.runsTo(5));
        studio.workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("torus")).value()), {});
        QVERIFY(!studio.solver.isRunning());
        QVERIFY(!studio.shown.isLive());
        QCOMPARE(studio.shown.uv().rows(), studio.document().mesh().soupCornerCount());
        QVERIFY(studio.runsTo(3));
        studio.workspace.close();
        QVERIFY(!studio.solver.isRunning());
        QCOMPARE(studio.shown.uv().rows(), 0);
    }

    void aRunOverPolygonsKeepsThemWhole()
    {
        Studio studio("character");
        QVERIFY(studio.runsTo(25));
        QVERIFY(studio.settles());
        const UvMetrics metrics = measureUv(studio.document().mesh(), studio.document().uv());
        QCOMPARE(metrics.flipped, 0);
        QCOMPARE(metrics.facesWithoutUv, 0);
    }

    //! A cut of a single edge inside an island is no seam of the live map, nor of the one that a pause
    //! leaves.
    void aCutThatOpensNothingIsShownClosed()
    {
        Studio studio;
        Scene scene;
        scene.mesh = test::grid(6, 0.3);
        studio.workspace.open(std::make_unique<Document>(std::move(scene)), {});
        const MeshData &mesh = studio.document().mesh();
        const std::vector<int> inner = test::edgesWhere(mesh, [](const Vec3 &a, const Vec3 &b) {
            const auto inside = [](const Vec3 &p) {
                return p.x() > 0.4 && p.x() < 0.7 && p.y() > 0.3 && p.y() < 0.7;
            };
            return inside(a) && inside(b);
        });
        QVERIFY(!inner.empty());
        const int slit = inner.front();
        const std::vector<int> edges{slit};
        QVERIFY(pushCommand(std::make_unique<SetSeamState>(studio.document(), SetSeamState::Edit::Cut,
                                                           cornerPairsOfEdges(mesh, edges))));
        studio.solver.setMode(SolveMode::Budget);
        studio.solver.run();
        int seen = 0, open = 0;
        connect(&studio.shown, &ShownMap::changed, &studio.solver, [&] {
            seen += studio.shown.isLive();
            open += studio.shown.isLive() && studio.shown.isSeam(slit);
        });
        QTRY_VERIFY_WITH_TIMEOUT(!studio.solver.isRunning() && !studio.solver.isPausing(), test::patience);
        QVERIFY(seen > 0);
        QCOMPARE(open, 0);
        QVERIFY(studio.solver.map()->cut[slit]);
        QVERIFY(!studio.shown.isSeam(slit));
    }

    void missingSymmetryIsSaidAtThePause_data()
    {
        QTest::addColumn<bool>("some");
        QTest::newRow("none") << false;
        QTest::newRow("of most of the surface") << true;
    }

    void missingSymmetryIsSaidAtThePause()
    {
        QFETCH(const bool, some);
        Studio studio("character");
        Scene scene = makeSample(QStringLiteral("character")).value();
        const MeshData &exact = *scene.mesh;
        PositionMatrix positions = exact.positions;
        for (Eigen::Index v = 0; v < positions.rows(); ++v) {
            auto p = positions.row(v);
            if (!some)
                p.x() += 0.3 * p.y() + 0.2 * p.z() * p.z();
            else if (p.x() > 0 && p.y() > 1.75)
                p.z() += 0.2;
        }
        scene.mesh = MeshData::build(positions, exact.faceStart, exact.cornerVertex, exact.faceObject);
        DocumentState state = DocumentState::initial(std::move(scene));
        state.solveSettings.symmetry = SymmetryMode::On;
        state.solveSettings.maxDistortion = 8; // soon met
        studio.workspace.open(Document::create(std::move(state)).value(), {});
        studio.solver.setMode(SolveMode::Budget);
        QSignalSpy problems(&studio.solver, &SolverController::foundProblems);
        studio.solver.run();
        QTRY_VERIFY_WITH_TIMEOUT(studio.solver.map() && studio.solver.map()->withinBound, test::patience);
        QVERIFY(studio.settles());
        QCOMPARE(problems.count(), 1);
        const QString said = problems.first().first().toString();
        QVERIFY2(said.contains(some ? QStringLiteral("no mirror image") : QStringLiteral("not symmetric")),
                 qPrintable(said));
    }
};

QTEST_GUILESS_MAIN(TestSolverController)

} // namespace tst_solvercontroller

#include "tst_solvercontroller.moc"
