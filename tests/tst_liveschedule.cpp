// The schedule of a live solve, told step by step what a solver would give.
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/liveschedule.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <limits>
#include <vector>

namespace tst_liveschedule {

using namespace autocuts;
using namespace autocuts::homotopy;

namespace {

constexpr double bound = 4.1;
constexpr double metDistortion = 4.095; //!< within the bound, and most of what it allows is used
constexpr int stepsPerLevel = 40;
constexpr int mostSteps = 100'000; //!< more than any run has

//! A schedule, and a solver that gives the distortion it is told to.
struct Run
{
    std::shared_ptr<const Soup> soup = Soup::build(test::sphere(8, 12));
    LiveSchedule schedule{*soup, bound};
    double energy = 100;

    SolveSettings settings() const
    {
        SolveSettings result;
        schedule.apply(result);
        return result;
    }
    //! A step that gains enough to go on.
    bool step(double distortion)
    {
        energy *= 0.99;
        return schedule.report({.energy = energy, .distortion = distortion, .stepLength = 1});
    }
    //! The rest of the steps of one level.
    bool level(double distortion)
    {
        const double delta = settings().delta;
        bool goesOn = true;
        for (int i = 0; i < stepsPerLevel && goesOn && settings().delta == delta; ++i)
            goesOn = step(distortion);
        return goesOn;
    }
    //! The levels of delta until the schedule has come to the smallest one and beyond, or ends.
    std::vector<double> round(double distortion, bool *goesOn = nullptr)
    {
        std::vector<double> deltas;
        bool more = true;
        do {
            deltas.push_back(settings().delta);
            more = level(distortion);
        } while (more && settings().delta < deltas.back());
        if (goesOn)
            *goesOn = more;
        return deltas;
    }
};

} // namespace

class TestLiveSchedule : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void deltaFallsLevelByLevel()
    {
        Run run;
        const std::vector<double> expected = deltaLevels(*run.soup, 1);
        QVERIFY(expected.size() > 5);
        QCOMPARE(expected.back(), finalDelta(*run.soup));
        for (std::size_t level = 0; level < expected.size(); ++level) {
            for (int i = 0; i < stepsPerLevel; ++i) {
                QCOMPARE(run.settings().delta, expected[level]);
                QCOMPARE(run.settings().lambda, 0.05);
                QVERIFY(run.step(4.5));
            }
        }
        // Then, warmed up again, from a smaller delta than at first.
        QCOMPARE(run.settings().delta, 0.01);
    }

    void levelsThatStallEndEarly()
    {
        Run run;
        const std::vector<double> deltas = deltaLevels(*run.soup, 1);
        const StepResult blocked{.energy = 7, .distortion = 4.5, .stepLength = 0};
        QVERIFY(run.schedule.report(blocked));
        QCOMPARE(run.settings().delta, deltas[1]);
        // Without a step before it in its level there is nothing that a step could have failed to gain on.
        const StepResult still{.energy = 7, .distortion = 4.5, .stepLength = 1};
        QVERIFY(run.schedule.report(still));
        QCOMPARE(run.settings().delta, deltas[1]);
        QVERIFY(run.schedule.report(still));
        QCOMPARE(run.settings().delta, deltas[2]);
    }

    void lambdaGoesTowardsTheBound_data()
    {
        QTest::addColumn<double>("distortion");
        QTest::addColumn<bool>("rises");
        QTest::newRow("too much distortion") << 4.4 << false;
        QTest::newRow("room for more") << 4.02 << true;
    }
    void lambdaGoesTowardsTheBound()
    {
        QFETCH(double, distortion);
        QFETCH(bool, rises);
        Run run;
        for (int round = 0; round < 2; ++round) {
            const double before = run.settings().lambda;
            run.round(distortion);
            const double after = run.settings().lambda;
            QVERIFY(rises ? after > 1.5 * before : after < before / 1.5);
        }
    }

    void laterRoundsWarmUpOnly()
    {
        Run run;
        QCOMPARE(run.round(4.4), deltaLevels(*run.soup, 1));
        for (int round = 0; round < 3; ++round)
            QCOMPARE(run.round(4.4), deltaLevels(*run.soup, 0.01));
    }

    void itEndsWhenTheBoundIsMetTwice()
    {
        Run run;
        bool goesOn = false;
        run.round(metDistortion, &goesOn);
        QVERIFY(goesOn);
        run.round(metDistortion, &goesOn);
        QVERIFY(!goesOn);
        QCOMPARE(run.settings().delta, finalDelta(*run.soup)); // stays cold
    }

    void itDoesNotEndBefore_data()
    {
        QTest::addColumn<double>("distortion");
        QTest::addColumn<int>("rounds");
        // Twelve more rounds try to keep the bound.
        QTest::newRow("above the bound") << 4.1001 << 20;
        QTest::newRow("far below the bound") << 4.08 << 9;
    }
    void itDoesNotEndBefore()
    {
        QFETCH(double, distortion);
        QFETCH(int, rounds);
        Run run;
        bool goesOn = true;
        int taken = 0;
        for (; goesOn && taken < mostSteps; ++taken)
            run.round(distortion, &goesOn);
        QCOMPARE(taken, rounds);
        QCOMPARE(run.settings().delta, finalDelta(*run.soup));
        // One round that meets the bound is enough then.
        Run other;
        for (int round = 0; round < 3; ++round)
            other.round(distortion);
        other.round(metDistortion, &goesOn);
        QVERIFY(!goesOn);
    }

    void aRunIsResumedWhereItWas_data()
    {
        QTest::addColumn<double>("delta");
        QTest::newRow("at a level") << 0.0625;
        QTest::newRow("between two levels") << 0.05;
        QTest::newRow("at the start") << 1.0;
        QTest::newRow("warmer than the start") << 3.0;
        QTest::newRow("at the end") << 1e-9;
    }
    void aRunIsResumedWhereItWas()
    {
        QFETCH(double, delta);
        Run run;
        const std::vector<double> all = deltaLevels(*run.soup, 1);
        std::vector<double> expected;
        for (const double level : all) {
            if (level <= delta)
                expected.push_back(level);
        }
        if (expected.empty())
            expected.push_back(all.back());
        run.round(4.4); // forgotten
        run.step(4.4);
        run.schedule.resume(0.2, delta);
        QCOMPARE(run.settings().lambda, 0.2);
        bool goesOn = false;
        QCOMPARE(run.round(metDistortion, &goesOn), expected);
        QVERIFY(goesOn); // it counts as the first round
        QCOMPARE(run.round(metDistortion, &goesOn), deltaLevels(*run.soup, 0.01));
        QVERIFY(!goesOn);
    }

    void aReheatWarmsUpAndLooksAgain()
    {
        Run run;
        run.round(4.4);
        const double lambda = run.settings().lambda;
        run.level(4.4);
        for (int i = 0; i < stepsPerLevel - 1; ++i)
            run.step(4.4);
        run.schedule.reheat();
        QCOMPARE(run.settings().lambda, lambda); // the balance found so far
        QCOMPARE(run.settings().delta, 0.01);
        run.step(4.4); // the first of a level, not the last one of that before
        QCOMPARE(run.settings().delta, 0.01);
        bool goesOn = true;
        QCOMPARE(run.round(metDistortion, &goesOn), deltaLevels(*run.soup, 0.01));
        QVERIFY(!goesOn);
    }

    void aReheatGivesAnEndedRunItsRoundsBack()
    {
        Run run;
        bool goesOn = true;
        for (int rounds = 0; goesOn && rounds < mostSteps; ++rounds)
            run.round(4.4, &goesOn);
        run.schedule.reheat();
        run.round(4.4, &goesOn);
        QVERIFY(goesOn);
    }
};

QTEST_APPLESS_MAIN(TestLiveSchedule)

} // namespace tst_liveschedule

#include "tst_liveschedule.moc"
