// Work off the GUI thread, and values that come from there.
#include "support/patience.h"
#include "views/ui/task.h"

#include <QTest>
#include <QThread>

#include <semaphore>
#include <stdexcept>
#include <thread>

namespace tst_task {

using namespace autocuts;

namespace {

const Task::Failed neverFails = [](const QString &message) { QFAIL(qPrintable(message)); };

} // namespace

class TestTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QCOMPARE(Task::threads(), 0); }
    void cleanup() { QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience); }

    //! An exception ends the work alone, not the program.
    void workFailsAlone_data()
    {
        QTest::addColumn<QString>("what");
        for (const char *what : {"nothing", "memory", "error"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void workFailsAlone()
    {
        QFETCH(const QString, what);
        Task task;
        int result = 0;
        QString message;
        QThread *workThread = nullptr, *endThread = nullptr;
        task.start(
            [&, what](const std::atomic<bool> &) {
                workThread = QThread::currentThread();
                if (what == u"memory")
                    throw std::bad_alloc();
                if (what == u"error")
                    throw std::runtime_error("the error");
                return 7;
            },
            [&](int value) {
                endThread = QThread::currentThread();
                result = value;
            },
            [&](const QString &text) {
                endThread = QThread::currentThread();
                message = text;
            });
        QVERIFY(task.isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(endThread, test::patience);
        QVERIFY(!task.isRunning());
        QCOMPARE(endThread, thread());
        QVERIFY(workThread != thread());
        QCOMPARE(result, what == u"nothing" ? 7 : 0);
        QCOMPARE(message, what == u"memory"  ? noMemoryText()
                          : what == u"error" ? QStringLiteral("the error")
                                             : QString());
    }

    void onlyTheNewestCounts()
    {
        Task task;
        std::vector<int> taken;
        const auto take = [&](int value) { taken.push_back(value); };
        std::atomic<bool> wasAsked = false;
        task.start(
            [&](const std::atomic<bool> &stop) {
                while (!stop)
                    std::this_thread::yield();
                wasAsked = true;
                return 1;
            },
            take, neverFails);
        task.start([](const std::atomic<bool> &) { return 2; }, take, neverFails);
        QTRY_VERIFY_WITH_TIMEOUT(!taken.empty(), test::patience);
        QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience);
        QVERIFY(wasAsked);
        QCOMPARE(taken, std::vector<int>{2});
    }

    void aStoppedOneStillGivesWhatItHas()
    {
        Task task;
        int result = 0;
        task.start(
            [](const std::atomic<bool> &stop) {
                int turns = 1;
                for (; !stop; ++turns)
                    std::this_thread::yield();
                return turns;
            },
            [&](int turns) { result = turns; }, neverFails);
        task.stop();
        QVERIFY(task.isRunning());
        task.wait();
        QVERIFY(!task.isRunning());
        QVERIFY(result > 0);
    }

    void nothingComesWhenTheTaskIsGone()
    {
        std::binary_semaphore release(0);
        bool called = false;
        {
            Task task;
            task.start(
                [&](const std::atomic<bool> &) {
                    release.acquire();
                    return 1;
                },
                [&](int) { called = true; }, neverFails);
        }
        release.release();
        QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience);
        QVERIFY(!called);
    }

    void whatWasDroppedIsWaitedForOnDemand()
    {
        Task task;
        std::atomic<bool> ended = false;
        bool called = false;
        task.start(
            [&](const std::atomic<bool> &stop) {
                while (!stop)
                    std::this_thread::yield();
                ended = true;
                return 1;
            },
            [&](int) { called = true; }, neverFails);
        task.drop();
        QVERIFY(!task.isRunning());
        task.waitForDropped();
        QVERIFY(ended);
        QVERIFY(!called);
    }

    //! What takes a result may start the next work, or end the task.
    void aResultMayStartOrEndTheTask()
    {
        auto task = std::make_unique<Task>();
        int last = 0;
        std::function<void(int)> take = [&](int value) {
            last = value;
            if (value == 3)
                task.reset();
            else
                task->start([value](const std::atomic<bool> &) { return value + 1; }, take, neverFails);
        };
        take(0);
        QTRY_VERIFY_WITH_TIMEOUT(!task, test::patience);
        QCOMPARE(last, 3);
    }

    void workWaitsWhileItIsHeld()
    {
        Task task, job(true);
        int value = 0, ofJob = 0;
        {
            const Task::Hold hold;
            const auto work = [](const std::atomic<bool> &) { return 1; };
            task.start(
                work, [&](int v) { value = v; }, neverFails);
            job.start(
                work, [&](int v) { ofJob = v; }, neverFails);
            job.wait();
            QCoreApplication::processEvents();
            QCOMPARE(value, 0);
        }
        task.wait();
        QCOMPARE(value, 1);
        QCOMPARE(ofJob, 1);
    }

    void theNewestValueIsTakenOnce()
    {
        Inbox<int> inbox;
        std::vector<int> taken;
        const auto put = inbox.open<int>([&](int value) { taken.push_back(value); },
                                         [](std::optional<int> &newest, int value) {
                                             if (value > 0)
                                                 newest = value;
                                         });
        {
            const std::jthread other([&] {
                for (int i = -1; i < 4; ++i)
                    put(i);
            });
        }
        QVERIFY(taken.empty());
        QTRY_VERIFY_WITH_TIMEOUT(!taken.empty(), test::patience);
        QCOMPARE(taken, std::vector<int>{3});
        put(5);
        QCoreApplication::processEvents();
        QCOMPARE(taken, (std::vector<int>{3, 5}));
    }

    void aClosedInboxTakesNothing()
    {
        std::vector<int> taken;
        const auto take = [&](int value) { taken.push_back(value); };
        const auto newest = [](std::optional<int> &held, int value) { held = value; };
        std::function<void(const int &)> first, second;
        {
            Inbox<int> inbox;
            first = inbox.open<int>(take, newest);
            first(1); // still to be taken when another one begins
            second = inbox.open<int>(take, newest);
            first(2);
            second(3);
            QCoreApplication::processEvents();
            QCOMPARE(taken, std::vector<int>{3});
            second(4);
        }
        second(5);
        QCoreApplication::processEvents();
        QCOMPARE(taken, std::vector<int>{3});
    }
};

QTEST_GUILESS_MAIN(TestTask)

} // namespace tst_task

#include "tst_task.moc"
