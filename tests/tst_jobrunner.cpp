// Long work off the GUI thread: results, progress, cancel, failure.
#include "support/patience.h"
#include "views/control/session/jobrunner.h"
#include "views/ui/task.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <stdexcept>

namespace tst_jobrunner {

using namespace autocuts;

namespace {

//! Counts up until it is told to stop.
int countUntilStopped(JobControl &control)
{
    int count = 0;
    do {
        ++count;
        QThread::msleep(1);
    } while (!control.stop());
    return count;
}

} // namespace

class TestJobRunner : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theResultComesInTheGuiThread()
    {
        JobRunner runner;
        QThread *workThread = nullptr, *doneThread = nullptr;
        int result = 0;
        QVERIFY(runner.start(
            QStringLiteral("Adding"),
            [&](JobControl &) {
                workThread = QThread::currentThread();
                return 2 + 3;
            },
            [&](int sum) {
                doneThread = QThread::currentThread();
                result = sum;
            }));
        QVERIFY(runner.isBusy());
        QCOMPARE(runner.title(), QStringLiteral("Adding"));
        QTRY_COMPARE_WITH_TIMEOUT(result, 5, test::patience);
        QVERIFY(!runner.isBusy());
        QCOMPARE(doneThread, QThread::currentThread());
        QVERIFY(workThread != doneThread);
    }

    void oneJobAtATime()
    {
        JobRunner runner;
        QVERIFY(runner.start(QStringLiteral("First"), countUntilStopped, [](int) {}));
        bool second = false;
        QVERIFY(!runner.start(
            QStringLiteral("Second"), [](JobControl &) { return 0; }, [&](int) { second = true; }));
        runner.cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!runner.isBusy(), test::patience);
        QVERIFY(!second);
    }

    void progressAndStageAreTold()
    {
        JobRunner runner;
        QSignalSpy progress(&runner, &JobRunner::progressChanged);
        QCOMPARE(runner.progress(), -1.0);
        runner.start(
            QStringLiteral("Working"),
            [](JobControl &control) {
                control.setProgress(0.5);
                control.setStage(QStringLiteral("half way"));
                return countUntilStopped(control);
            },
            [](int) {});
        QTRY_COMPARE_WITH_TIMEOUT(runner.progress(), 0.5, test::patience);
        QTRY_COMPARE_WITH_TIMEOUT(runner.stage(), QStringLiteral("half way"), test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(progress.count() > 2, test::patience);
        runner.cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!runner.isBusy(), test::patience);
        QCOMPARE(runner.progress(), -1.0);
        QVERIFY(runner.stage().isEmpty());
    }

    void aCancelledJobGivesWhatItHas()
    {
        JobRunner runner;
        std::atomic<bool> begun = false;
        int result = -1;
        runner.start(
            QStringLiteral("Counting"),
            [&](JobControl &control) {
                begun = true;
                return countUntilStopped(control);
            },
            [&](int count) { result = count; });
        QTRY_VERIFY_WITH_TIMEOUT(begun, test::patience);
        runner.cancel();
        QTRY_VERIFY_WITH_TIMEOUT(result > 0, test::patience);
    }

    //! The memory of a cancelled job is free when it has ended, and the next one may get it.
    void theJobAfterACancelledOneStays()
    {
        for (int i = 0; i < 5; ++i) {
            JobRunner runner;
            runner.start(QStringLiteral("Counting"), countUntilStopped, [](int) {});
            runner.cancel();
            QTRY_VERIFY_WITH_TIMEOUT(!runner.isBusy(), test::patience);
            std::atomic<bool> release = false;
            runner.start(
                QStringLiteral("Next"),
                [&release](JobControl &) {
                    while (!release)
                        QThread::msleep(1);
                    return 1;
                },
                [](int) {});
            bool tookLong = false;
            QTimer::singleShot(2 * JobRunner::cancelPatience, this, [&] { tookLong = true; });
            QTRY_VERIFY_WITH_TIMEOUT(tookLong, test::patience);
            QVERIFY(runner.isBusy());
            release = true;
            runner.waitForDone();
        }
    }

    void aJobThatIsLetGoIsForgotten()
    {
        JobRunner runner(JobRunner::OnCancel::LetGo);
        bool called = false;
        runner.start(QStringLiteral("Reading"), countUntilStopped, [&](int) { called = true; });
        runner.cancel();
        QVERIFY(!runner.isBusy());
        int result = 0;
        QVERIFY(runner.start(
            QStringLiteral("Another"), [](JobControl &) { return 7; }, [&](int value) { result = value; }));
        QTRY_COMPARE_WITH_TIMEOUT(result, 7, test::patience);
        QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience);
        QVERIFY(!called);
    }

    void aCancelledJobKeepsNobodyWaiting()
    {
        JobRunner runner;
        std::atomic<bool> release = false;
        const auto stubborn = [&release](JobControl &control) {
            control.setProgress(0.5);
            while (!release)
                QThread::msleep(1);
            return 1;
        };
        int late = 0, next = 0;
        const auto begin = [&] {
            release = false;
            QVERIFY(runner.start(QStringLiteral("Thinking"), stubborn, [&](int value) { late += value; }));
            QTRY_COMPARE_WITH_TIMEOUT(runner.progress(), 0.5, test::patience);
            runner.cancel();
            QVERIFY(runner.isBusy());
            QTRY_VERIFY_WITH_TIMEOUT(!runner.isBusy(), test::patience);
        };
        // What it has is used when it comes ...
        begin();
        QCOMPARE(late, 0);
        release = true;
        QTRY_COMPARE_WITH_TIMEOUT(late, 1, test::patience);
        // ... unless something else was begun, or it is not wanted any more.
        begin();
        runner.start(
            QStringLiteral("Next"), [](JobControl &) { return 1; }, [&](int value) { next = value; });
        release = true;
        QTRY_COMPARE_WITH_TIMEOUT(next, 1, test::patience);
        begin();
        runner.abandon();
        release = true;
        QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience);
        QCOMPARE(late, 1);
    }

    void anExceptionBecomesAMessage()
    {
        JobRunner runner;
        QSignalSpy failed(&runner, &JobRunner::failed);
        bool called = false;
        runner.start(
            QStringLiteral("Failing"), [](JobControl &) -> int { throw std::runtime_error("no such thing"); },
            [&](int) { called = true; });
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::patience);
        QCOMPARE(failed.first().first().toString(), QStringLiteral("no such thing"));
        QVERIFY(!called);
        QVERIFY(!runner.isBusy());
    }

    void theNextJobMayBeginFromTheLast()
    {
        JobRunner runner;
        int steps = 0;
        std::function<void(int)> next = [&](int value) {
            steps = value;
            if (value < 3)
                runner.start(
                    QStringLiteral("Next"), [value](JobControl &) { return value + 1; }, next);
        };
        next(0);
        QTRY_COMPARE_WITH_TIMEOUT(steps, 3, test::patience);
        runner.start(
            QStringLiteral("Last"), [](JobControl &) { return 9; }, [&](int v) { steps = v; });
        runner.waitForDone();
        QCOMPARE(steps, 9);
    }

    void destroyingItStopsWhatRuns()
    {
        std::atomic<bool> ended = false;
        {
            JobRunner runner;
            runner.start(
                QStringLiteral("Long"),
                [&](JobControl &control) {
                    const int count = countUntilStopped(control);
                    ended = true;
                    return count;
                },
                [](int) {});
        }
        QVERIFY(ended);
    }
};

QTEST_GUILESS_MAIN(TestJobRunner)

} // namespace tst_jobrunner

#include "tst_jobrunner.moc"
