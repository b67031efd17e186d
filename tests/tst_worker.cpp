// The live solver on its thread: what it does is what Solver does, and it obeys at once.
#include "model/plain/uvlayout.h"
#include "solver/live/worker.h"
#include "support/meshbuilders.h"
#include "support/patience.h"

#include <QDir>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

namespace tst_worker {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace autocuts::live;

namespace {

std::shared_ptr<Snapshot> snapshotOf(const test::MeshPtr &mesh)
{
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->mesh = mesh;
    snapshot->settings.lambda = 0.1;
    snapshot->settings.delta = 0.05;
    static std::uint64_t last = 0;
    snapshot->token.uv = ++last;
    return snapshot;
}

//! A worker on its thread, and the results that it gave.
struct Bench : QObject
{
    explicit Bench(int threads = 1)
    {
        worker = new SolveWorker(threads);
        worker->moveToThread(&thread);
        QObject::connect(&thread, &QThread::finished, worker, &QObject::deleteLater);
        QObject::connect(worker, &SolveWorker::resultReady, this, [this] {
            if (const auto result = worker->takeResult()) {
                results.push_back(result);
                trace.insert(trace.end(), result->trace.begin(), result->trace.end());
            }
        });
        thread.start();
    }
    ~Bench() override
    {
        worker->pause();
        thread.quit();
        thread.wait();
    }

    //! Until the worker has made the steps, or has come to rest.
    void runAndWait(std::shared_ptr<const Snapshot> snapshot, int steps)
    {
        QSignalSpy waiting(worker, &SolveWorker::waiting);
        worker->start(std::move(snapshot), Vec2::Zero());
        worker->runSteps(steps);
        QTRY_COMPARE_WITH_TIMEOUT(waiting.count(), 1, test::patience);
    }

    QThread thread;
    SolveWorker *worker;
    std::vector<std::shared_ptr<const SolveResult>> results;
    std::vector<TracePoint> trace;
};

} // namespace

class TestWorker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stepsGiveTheBitsOfTheSolver()
    {
        const auto snapshot = snapshotOf(test::sphere(12, 12));
        Solver solver;
        solver.load(*snapshot);
        for (int i = 0; i < 7; ++i)
            solver.step();

        Bench bench;
        QSignalSpy waiting(bench.worker, &SolveWorker::waiting);
        bench.worker->start(snapshot, Vec2::Zero());
        bench.worker->runSteps(7);
        QTRY_COMPARE_WITH_TIMEOUT(waiting.count(), 1, test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty() && bench.results.back()->status.iteration == 7,
                                 test::patience);
        const SolveResult &last = *bench.results.back();
        QVERIFY(last.token == snapshot->token);
        const std::vector<double> &x = solver.coordinates();
        QVERIFY(std::equal(x.begin(), x.end(), last.soupUv.data()));
        for (int p = 0; p < snapshot->mesh->cornerPairCount(); ++p)
            QCOMPARE(last.separation[p], static_cast<float>(solver.separation(p)));
        QCOMPARE(bench.trace.size(), std::size_t(7));
        for (int i = 0; i < 7; ++i)
            QCOMPARE(bench.trace[i].iteration, i + 1);
    }

    //! As in tst_mapkeeper.
    void anEditBeforeTheStartDoesNotChangeIt()
    {
        auto edited = snapshotOf(test::grid(3));
        auto snapshot = std::make_shared<Snapshot>(*edited);
        UvMatrix uv(snapshot->mesh->cornerCount(), 2);
        for (int c = 0; c < snapshot->mesh->cornerCount(); ++c)
            uv.row(c) = 3 * snapshot->mesh->cornerPosition(c).head<2>().transpose();
        snapshot->uv = std::make_shared<const UvMatrix>(uv);
        snapshot->startUv = std::make_shared<const UvMatrix>(soupUv(*snapshot->mesh, uv));
        snapshot->settings.start = StartMode::ExistingUv;
        edited->startUv = snapshot->startUv;
        Bench bench;
        QSemaphore goesOn;
        QMetaObject::invokeMethod(
            bench.worker, [&] { goesOn.acquire(); }, Qt::QueuedConnection);
        bench.worker->start(snapshot, Vec2::Zero());
        bench.worker->update(edited, false, nullptr);
        goesOn.release();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty(), test::patience);
        QVERIFY(bench.results.front()->soupUv == *snapshot->startUv);
    }

    void theThreadsDoNotChangeTheMap()
    {
        // Large enough for several jobs in every loop of a step.
        const auto snapshot = snapshotOf(test::torus(60, 40));
        std::vector<UvMatrix> maps;
        for (const int threads : {1, 2, 3}) {
            Bench bench(threads);
            bench.runAndWait(snapshot, 15);
            QTRY_COMPARE_WITH_TIMEOUT(bench.results.back()->status.iteration, 15, test::patience);
            maps.push_back(bench.results.back()->soupUv);
        }
        QVERIFY(maps[1] == maps[0]);
        QVERIFY(maps[2] == maps[0]);
    }

    void aStepRunsOnAllThreads()
    {
        // Each thread of the process has a folder there.
        const QDir tasks(QStringLiteral("/proc/self/task"));
        if (!tasks.exists())
            QSKIP("The system does not list the threads of a process");
        const auto threads = [&] { return tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(); };
        Bench bench(1);
        bench.runAndWait(snapshotOf(test::sphere(8, 12)), 1);
        const auto before = threads();
        Bench wide(4);
        wide.runAndWait(snapshotOf(test::sphere(8, 12)), 1);
        QCOMPARE(threads() - before, 4);
    }

    void theMapBeginsAroundTheCentre()
    {
        Bench bench;
        bench.worker->start(snapshotOf(test::sphere(8, 12)), Vec2(3, 4));
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty(), test::patience);
        const Eigen::RowVector2d mean = bench.results.back()->soupUv.colwise().mean();
        QVERIFY((mean - Eigen::RowVector2d(3, 4)).norm() < 0.5);
    }

    void anEditDuringARunIsTakenUp()
    {
        const auto mesh = test::sphere(12, 12);
        const auto before = snapshotOf(mesh);
        const auto after = std::make_shared<Snapshot>(*before);
        after->settings.lambda = 0.5;
        Bench bench;
        bench.worker->start(before, Vec2::Zero());
        bench.worker->run();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.trace.empty(), test::patience);
        bench.worker->update(after);
        QTRY_COMPARE_WITH_TIMEOUT(bench.results.back()->status.lambda, 0.5, test::patience);
        // No restart: the count of steps goes on.
        const int iteration = bench.results.back()->status.iteration;
        QVERIFY(iteration >= 1);
    }

    void aRunThatConvergedGoesOnAfterAnEdit()
    {
        const auto before = snapshotOf(test::sphere(8, 12));
        Bench bench;
        bench.worker->start(before, Vec2::Zero());
        bench.worker->run();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty() && bench.results.back()->status.converged,
                                 test::patience);
        const int iteration = bench.results.back()->status.iteration;
        const auto after = std::make_shared<Snapshot>(*before);
        after->settings.delta = 0.01;
        bench.worker->update(after);
        QTRY_VERIFY_WITH_TIMEOUT(bench.results.back()->status.iteration > iteration, test::patience);
    }

    void aPausedRunStaysPausedAfterAnEdit()
    {
        const auto before = snapshotOf(test::sphere(12, 12));
        Bench bench;
        bench.worker->start(before, Vec2::Zero());
        bench.worker->runSteps(3);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty() && bench.results.back()->status.iteration == 3,
                                 test::patience);
        const auto after = std::make_shared<Snapshot>(*before);
        after->settings.lambda = 0.5;
        bench.worker->update(after);
        bench.worker->pause();
        QMetaObject::invokeMethod(
            bench.worker, [] {}, Qt::BlockingQueuedConnection); // the edit was taken
        QCOMPARE(bench.results.back()->status.iteration, 3);
    }

    void theBudgetIsReached()
    {
        Bench bench;
        QSignalSpy waiting(bench.worker, &SolveWorker::waiting);
        bench.worker->setMode(SolveMode::Budget);
        const auto snapshot = std::make_shared<Snapshot>(*snapshotOf(test::sphere(10, 12)));
        snapshot->settings.maxDistortion = 4.2;
        bench.worker->start(snapshot, Vec2::Zero());
        bench.worker->run();
        QTRY_COMPARE_WITH_TIMEOUT(waiting.count(), 1, test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(bench.results.back()->status.converged, test::patience);
        const SolveStatus &status = bench.results.back()->status;
        QVERIFY2(status.distortion < 4.3, qPrintable(QString::number(status.distortion)));
        QVERIFY(status.seamLength > 0);
        QVERIFY(status.islands < snapshotOf(test::sphere(10, 12))->mesh->triangleCount() / 4);
    }

    //! What was made before an order that makes it void, and not taken yet.
    void whatIsVoidCannotBeTaken()
    {
        QThread thread;
        SolveWorker worker(1);
        worker.moveToThread(&thread);
        QSemaphore rests, gate;
        const auto whileItIsBusy = [&](const auto &act) {
            QMetaObject::invokeMethod(
                &worker, [&] { gate.acquire(); }, Qt::QueuedConnection);
            act();
            gate.release();
        };
        connect(
            &worker, &SolveWorker::waiting, this, [&] { rests.release(); }, Qt::DirectConnection);
        const auto first = snapshotOf(test::sphere(12, 12)), second = snapshotOf(first->mesh);
        thread.start();
        const auto end = qScopeGuard([&] {
            worker.pause();
            thread.quit();
            thread.wait();
        });
        worker.start(first, Vec2::Zero());
        worker.runSteps(1);
        QVERIFY(rests.tryAcquire(1, test::patience));
        QVERIFY(worker.takeRest());
        QVERIFY(!worker.takeRest());
        worker.runSteps(1);
        QVERIFY(rests.tryAcquire(1, test::patience));
        bool atRest = true, hasResult = true;
        whileItIsBusy([&] {
            worker.runSteps(1);
            atRest = worker.takeRest();
        });
        QVERIFY(!atRest);
        QVERIFY(rests.tryAcquire(1, test::patience));
        whileItIsBusy([&] {
            worker.start(second, Vec2::Zero());
            hasResult = worker.takeResult() != nullptr;
        });
        QVERIFY(!hasResult);
    }

    void resultsNameTheStateTheyGoOnFrom()
    {
        const auto snapshot = snapshotOf(test::sphere(8, 12));
        StateToken pushed = snapshot->token;
        ++pushed.uv;
        Bench bench;
        bench.runAndWait(snapshot, 1);
        QTRY_VERIFY_WITH_TIMEOUT(bench.results.back()->status.iteration == 1, test::patience);
        QVERIFY(bench.results.back()->token == snapshot->token);
        bench.worker->setToken(pushed);
        bench.worker->runSteps(1);
        QTRY_VERIFY_WITH_TIMEOUT(bench.results.back()->status.iteration == 2, test::patience);
        QVERIFY(bench.results.back()->token == pushed);
    }

    void aMeshWithoutAreaFailsInWords()
    {
        PositionMatrix positions = PositionMatrix::Zero(3, 3);
        Bench bench;
        QSignalSpy failed(bench.worker, &SolveWorker::failed);
        bench.worker->start(snapshotOf(MeshData::build(positions, {0, 3}, {0, 1, 2}, {0})), Vec2::Zero());
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::patience);
        const std::optional<QString> message = bench.worker->takeFailure();
        QVERIFY(message && !message->isEmpty());
        // And the next model is solved as if nothing had been.
        const auto next = snapshotOf(test::sphere(8, 12));
        bench.worker->start(next, Vec2::Zero());
        bench.worker->runSteps(1);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty() && bench.results.back()->token == next->token,
                                 test::patience);
    }

    void ordersFromAllSidesLeaveOneStateBehind()
    {
        Bench bench;
        for (int run = 1; run <= 40; ++run) {
            bench.worker->start(snapshotOf(test::sphere(run % 3 == 0 ? 12 : 8, 12)), Vec2::Zero());
            bench.worker->run();
            if (run % 2)
                bench.worker->pause();
            if (run % 5 == 0)
                bench.worker->setMode(run % 10 ? SolveMode::Budget : SolveMode::Manual);
            bench.worker->pause();
        }
        bench.worker->setMode(SolveMode::Manual);
        const auto last = snapshotOf(test::sphere(8, 12));
        bench.worker->start(last, Vec2::Zero());
        bench.worker->runSteps(2);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.results.empty() && bench.results.back()->token == last->token &&
                                     bench.results.back()->status.iteration == 2,
                                 test::patience);
    }
};

QTEST_GUILESS_MAIN(TestWorker)

} // namespace tst_worker

#include "tst_worker.moc"
