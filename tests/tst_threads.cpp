// Several solvers at the same time give the bits that each gives alone.
#include "model/plain/parallel.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/anneal.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <atomic>
#include <stdexcept>

namespace tst_threads {

using namespace autocuts;
using namespace autocuts::definite;
using namespace autocuts::homotopy;

namespace {

std::vector<double> solved(const test::MeshPtr &mesh, SolverKind kind)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.solver = kind;
    Solver solver;
    solver.load(snapshot);
    AnnealOptions options;
    options.stepsPerLevel = kind == SolverKind::Fast ? 8 : 2;
    annealSoup(solver, options, nullptr);
    SeamedMap map = stitchSoup(solver.sharedSoup(), solver.snapshot(), solver.coordinates());
    relaxMap(solver.sharedSoup(), solver.snapshot(), map, 20);
    return map.x;
}

} // namespace

class TestThreads : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void concurrentSolversDoNotDisturbEachOther_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("fast") << 0;
        QTest::newRow("exact") << 1;
    }
    void concurrentSolversDoNotDisturbEachOther()
    {
        QFETCH(int, kind);
        const auto mesh = test::torus(40, 24);
        const std::vector<double> alone = solved(mesh, static_cast<SolverKind>(kind));
        std::vector<std::vector<double>> together(6);
        parallelFor(6, 3, [&](int i) { together[i] = solved(mesh, static_cast<SolverKind>(kind)); });
        for (const auto &x : together)
            QVERIFY(x == alone);
    }

    void aStepDoesNotDependOnItsThreads()
    {
        // Large enough for several jobs in every loop.
        Snapshot snapshot;
        snapshot.mesh = test::torus(60, 40);
        snapshot.settings.lambda = 0.05;
        snapshot.settings.delta = 0.01;
        std::vector<double> x[3];
        for (int i = 0; i < 3; ++i) {
            Solver solver;
            solver.setThreads(i + 1);
            solver.load(snapshot);
            for (int step = 0; step < 25; ++step)
                solver.step();
            x[i] = solver.coordinates();
        }
        QVERIFY(x[1] == x[0]);
        QVERIFY(x[2] == x[0]);
    }

    void rangesHoldEachStepOnce_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {0, 1, 16384, 16385, 100'000})
            QTest::addRow("%d", count) << count;
    }
    void rangesHoldEachStepOnce()
    {
        QFETCH(const int, count);
        std::vector<int> calls(static_cast<std::size_t>(count), 0);
        parallelRanges(count, [&](int first, int end) {
            for (int i = first; i < end; ++i)
                ++calls[static_cast<std::size_t>(i)];
        });
        QCOMPARE(calls, std::vector<int>(static_cast<std::size_t>(count), 1));
    }

    void aTeamRunsEveryJobOnce()
    {
        ThreadTeam team(3);
        QCOMPARE(team.threads(), 3);
        for (int round = 0; round < 200; ++round) {
            std::vector<std::atomic<int>> runs(7);
            team.run(7, [&](int i) { ++runs[i]; });
            for (const auto &count : runs)
                QCOMPARE(count.load(), 1);
        }
    }

    void aTeamPassesTheFirstExceptionOn_data()
    {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3})
            QTest::addRow("%d", threads) << threads;
    }
    void aTeamPassesTheFirstExceptionOn()
    {
        QFETCH(int, threads);
        ThreadTeam team(threads);
        for (int round = 0; round < 50; ++round) {
            try {
                team.run(20, [&](int i) {
                    if (i % 5 == 2)
                        throw std::runtime_error("job " + std::to_string(i));
                });
                QFAIL("nothing was thrown");
            } catch (const std::runtime_error &error) {
                QCOMPARE(error.what(), "job 2");
            }
            // The team goes on as if nothing had happened.
            std::atomic<int> runs = 0;
            team.run(20, [&](int) { ++runs; });
            QCOMPARE(runs.load(), 20);
        }
    }

    void parallelForRunsEveryJobOnce_data()
    {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3, 16})
            QTest::addRow("%d", threads) << threads;
    }
    void parallelForRunsEveryJobOnce()
    {
        QFETCH(int, threads);
        std::vector<std::atomic<int>> runs(100);
        parallelFor(100, threads, [&](int i) { ++runs[i]; });
        for (const auto &count : runs)
            QCOMPARE(count.load(), 1);
    }

    void parallelForPassesTheFirstExceptionOn()
    {
        std::atomic<int> runs = 0;
        try {
            parallelFor(20, 3, [&](int i) {
                ++runs;
                if (i % 5 == 2)
                    throw std::runtime_error("job " + std::to_string(i));
            });
            QFAIL("nothing was thrown");
        } catch (const std::runtime_error &error) {
            QCOMPARE(error.what(), "job 2");
        }
        QCOMPARE(runs.load(), 20);
    }
};

QTEST_APPLESS_MAIN(TestThreads)

} // namespace tst_threads

#include "tst_threads.moc"
