#include "solver/unwrap/readyresult.h"

#include <QTest>

#include <stdexcept>

namespace tst_readyresult {

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

Candidate candidate(double seamCost, double distortion = 4.05, bool onlyPatches = false)
{
    Candidate result;
    result.seamCost = result.seamLength = seamCost;
    result.distortion = result.bounded = distortion;
    result.onlyPatches = onlyPatches;
    return result;
}

MakeMap makes(Candidate made)
{
    return [made](const JobContext &) { return made; };
}

UnwrapResult placed(Candidate found, const JobContext &)
{
    UnwrapResult result;
    result.seamLength = found.seamLength;
    return result;
}

} // namespace

//! A bound of 4.1 and a thread that makes results.
class TestReadyResult : public QObject
{
    Q_OBJECT

    const UnwrapOptions mOptions;
    const JobContext mJob;
    const Ranking mRanking{mOptions, mJob};

    //! Waits until the thread has taken up this map, too.
    bool takesUp(ReadyResult &ready, const Candidate &next)
    {
        std::atomic<bool> taken = false;
        ready.prepare([&taken, next](const JobContext &) {
            taken = true;
            return next;
        });
        const bool result = QTest::qWaitFor([&] { return taken.load(); });
        // The next one is taken up after this one was placed.
        taken = false;
        ready.prepare([&taken](const JobContext &) -> std::optional<Candidate> {
            taken = true;
            return std::nullopt;
        });
        return result && QTest::qWaitFor([&] { return taken.load(); });
    }

private Q_SLOTS:
    void smallChartsCostSeams()
    {
        const auto withSmall = [](double seamCost, int smallCharts) {
            Candidate result = candidate(seamCost);
            result.smallCharts = smallCharts;
            return result;
        };
        QVERIFY(mRanking.better(withSmall(20, 0), withSmall(19.5, 3)));
        QVERIFY(mRanking.better(withSmall(20, 200), withSmall(20, 300)));
        // Hundreds of them are what a rough surface has.
        QVERIFY(mRanking.better(withSmall(20, 300), withSmall(40, 0)));
        QVERIFY(mRanking.better(withSmall(20, 0), withSmall(19, 300)));
        // The bound comes first.
        Candidate outside = withSmall(10, 0);
        outside.bounded = 4.2;
        QVERIFY(mRanking.better(withSmall(40, 300), outside));
    }

    void theFirstIsWaitedFor()
    {
        ReadyResult ready(mRanking, placed, [](const JobContext &) {
            QTest::qSleep(50);
            return std::optional(candidate(9, 4.01, true));
        });
        QCOMPARE(ready.take().seamLength, 9.0);
    }

    void theBestIsKept()
    {
        ReadyResult ready(mRanking, placed, makes(candidate(90, 4.01, true)));
        // However bad: flat patches are the fallback.
        QCOMPARE(ready.take().seamLength, 90.0);
        QVERIFY(ready.isAsGoodAs(candidate(90, 4.01)));
        QVERIFY(takesUp(ready, candidate(30, 4.2)));
        QCOMPARE(ready.take().seamLength, 30.0);
        QVERIFY(takesUp(ready, candidate(10, 4.3)));
        QCOMPARE(ready.take().seamLength, 30.0);
        QVERIFY(takesUp(ready, candidate(40)));
        QCOMPARE(ready.take().seamLength, 40.0);
        QVERIFY(takesUp(ready, candidate(20)));
        QCOMPARE(ready.take().seamLength, 20.0);
        QVERIFY(ready.isAsGoodAs(candidate(20)));
        QVERIFY(ready.isAsGoodAs(candidate(1, 4.01, true)));
        QVERIFY(!ready.isAsGoodAs(candidate(19)));
        QVERIFY(takesUp(ready, candidate(1, 4.01, true)));
        QCOMPARE(ready.take().seamLength, 20.0);
    }

    void failuresAreTold()
    {
        const MakeMap fails = [](const JobContext &) -> std::optional<Candidate> {
            throw std::runtime_error("no");
        };
        ReadyResult ready(mRanking, placed, fails);
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, ready.take());
        // A result outweighs them, before and after.
        QVERIFY(takesUp(ready, candidate(5)));
        QCOMPARE(ready.take().seamLength, 5.0);
        ready.prepare(fails);
        QVERIFY(takesUp(ready, candidate(4)));
        QCOMPARE(ready.take().seamLength, 4.0);
    }

    void theNewestIsMadeAfterAStop()
    {
        // The second map would have to wait for an hour.
        ReadyResult ready(mRanking, placed, makes(candidate(9)), {}, std::chrono::hours(1));
        QCOMPARE(ready.take().seamLength, 9.0);
        ready.prepare(makes(candidate(8)));
        ready.prepare(makes(candidate(7)));
        QCOMPARE(ready.take().seamLength, 7.0);
        // One that takes long is not waited for.
        std::atomic<bool> ends = false;
        ready.prepare([&](const JobContext &) {
            while (!ends)
                QTest::qSleep(1);
            return std::optional(candidate(6));
        });
        QCOMPARE(ready.take().seamLength, 7.0);
        ends = true;
    }

    void whatIsBeingMadeIsBetterThanPatches()
    {
        ReadyResult ready(mRanking, placed, makes(candidate(90, 4.01, true)));
        QCOMPARE(ready.take().seamLength, 90.0);
        std::atomic<bool> begun = false;
        ready.prepare([&](const JobContext &) {
            begun = true;
            QTest::qSleep(20);
            return std::optional(candidate(30, 4.3));
        });
        QVERIFY(QTest::qWaitFor([&] { return begun.load(); }));
        QCOMPARE(ready.take().seamLength, 30.0);
    }

    void whatIsBeingMadeIsGivenUp()
    {
        std::atomic<bool> begun = false, told = false;
        {
            ReadyResult ready(mRanking, placed, makes(candidate(5)));
            ready.prepare([&](const JobContext &job) -> std::optional<Candidate> {
                begun = true;
                while (!job.stopped())
                    QTest::qSleep(1);
                told = true;
                return std::nullopt;
            });
            QVERIFY(QTest::qWaitFor([&] { return begun.load(); }));
            QCOMPARE(ready.take().seamLength, 5.0); // does not wait for it
        }
        QVERIFY(told);
    }
};

QTEST_GUILESS_MAIN(TestReadyResult)

} // namespace tst_readyresult

#include "tst_readyresult.moc"
