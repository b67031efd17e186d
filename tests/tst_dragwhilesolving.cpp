// Pulling at the map of a running solve, with real mouse and key events.
#include "commands/changesettings.h"
#include "commands/setseamstate.h"
#include "solver/metrics/uvmetrics.h"
#include "support/canvases.h"
#include "support/dragbench.h"
#include "support/editsupport.h"
#include "support/patience.h"

#include <QTest>

#include <algorithm>

namespace tst_dragwhilesolving {

using namespace autocuts;
using namespace autocuts::homotopy;
using test::Canvases;

class TestDragWhileSolving : public QObject, protected test::DragBench
{
    Q_OBJECT

private Q_SLOTS:
    void init() { begin(); }
    void cleanup() { mStudio.reset(); }

    void theRunningSolveDeformsOrTears_data()
    {
        QTest::addColumn<double>("delta");
        QTest::addColumn<bool>("tears");
        QTest::newRow("smooth") << 4.0 << false;
        QTest::newRow("sharp") << 0.004 << true;
    }

    //! Paper, "tear-up gesture": the same pull, with delta large and small.
    void theRunningSolveDeformsOrTears()
    {
        QFETCH(double, delta);
        QFETCH(bool, tears);
        openOneIsland();
        setRadius(0.3);
        runAt(0.05, delta);
        const int soup = soupAt({0.5, 1});
        const UvMatrix before = document().uv();
        const int entries = document().undoStack().count();
        const Row from = mStudio->shown.uv().row(soup);
        const QPoint start = pixel(from.transpose()), end = start - QPoint(0, 110);
        pressAndPull(start, end);
        QTRY_VERIFY_WITH_TIMEOUT((mStudio->shown.uv().row(soup) - from - Row(0, 0.55)).norm() < 0.02,
                                 test::patience);
        const auto open = [this] {
            const std::vector<float> &separation = mStudio->shown.separation();
            return std::count_if(separation.begin(), separation.end(), [](float s) { return s >= 0.5f; });
        };
        if (tears)
            QTRY_VERIFY_WITH_TIMEOUT(open() >= 4, test::patience);
        else
            QCOMPARE(open(), 0);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, end);
        QVERIFY(mStudio->solver.isRunning());
        QVERIFY(document().uv() == before);
        QCOMPARE(document().undoStack().count(), entries + tears);
        const std::vector<PairState> states = document().seams().states;
        QCOMPARE(std::count(states.begin(), states.end(), PairState::Cut) >= 4, tears);
        QCOMPARE(document().validate(), QString());
        if (tears) {
            document().undoStack().undo();
            QVERIFY(std::count(document().seams().states.begin(), document().seams().states.end(),
                               PairState::Cut) == 0);
            document().undoStack().redo();
            QCOMPARE(document().seams().states, states);
        }
    }

    void theRunningSolveAttaches()
    {
        setRadius(0.7);
        cutWhatIsOpen(); // free, the two islands would find together by themselves
        const int soup = soupAt({0.5, 1}), partner = soupAt({1.5, 1});
        runAt(0.3, 1e-4);
        const int entries = document().undoStack().count();
        const QPoint start = pixel(mStudio->shown.uv().row(soup).transpose());
        const QPoint end = pixel(mStudio->shown.uv().row(partner).transpose()) - QPoint(5, 3);
        pressAndPull(start, end);
        // The other island comes nearer too.
        const QPoint there = pixel(mStudio->shown.uv().row(partner).transpose()) - QPoint(5, 3);
        Canvases::moveMouse(view(), there, Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, there);
        QCOMPARE(document().undoStack().count(), entries + 1);
        const std::vector<PairState> &states = document().seams().states;
        QCOMPARE(std::count(states.begin(), states.end(), PairState::Joined), 1);
        QVERIFY(mStudio->solver.isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(
            (mStudio->shown.uv().row(soup) - mStudio->shown.uv().row(partner)).norm() < 0.02, 20'000);
        document().undoStack().undo();
        QCOMPARE(std::count(states.begin(), states.end(), PairState::Joined), 0);
    }

    //! In budget mode the solver would end by itself; not while it is pulled at.
    void aPullKeepsTheSolveRunning()
    {
        const auto ends = [this] { return !mStudio->solver.isRunning() && !mStudio->solver.isPausing(); };
        openOneIsland(test::grid(64, 0.6)); // large enough not to be done before the pull
        setRadius(0.3);
        mStudio->solver.setMode(SolveMode::Budget);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([&] { return mStudio->shown.isLive(); }, 20'000));
        const int soup = soupAt({0.5, 1});
        const QPoint start = pixel(mStudio->shown.uv().row(soup).transpose());
        pressAndPull(start, start + QPoint(10, -30));
        QTRY_VERIFY_WITH_TIMEOUT(mStudio->solver.status().converged, test::patience);
        QTest::qWait(0);
        const bool ran = mStudio->solver.isRunning();
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(10, -30));
        QVERIFY(ran);
        QTRY_VERIFY_WITH_TIMEOUT(ends(), test::patience);
    }

    //! The definite map follows the mouse, and nothing of it comes to lie on anything else.
    void aPullMovesTheDefiniteMapWithoutOverlaps()
    {
        const MapCamera camera = view().camera();
        mStudio->open(
            test::layoutDocument(test::grid(48, 0.6))); // large enough not to be done before the pull
        view().setCamera(camera);
        mStudio->select(SelectionMode::Vertices);
        setRadius(0.7);
        cutWhatIsOpen(); // free, the two islands would become one
        mStudio->solver.setMode(SolveMode::Budget);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([&] { return mStudio->shown.isLive(); }, 20'000));
        const int soup = soupAt({0.5, 1});
        const Row from = mStudio->shown.uv().row(soup);
        const Row to = mStudio->shown.uv().row(soupAt({1.5, 1}));
        const QPoint start = pixel(from.transpose()), end = pixel(to.transpose());
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        for (int step = 1; step <= 8; ++step) {
            Canvases::moveMouse(view(), start + (end - start) * step / 8, Qt::LeftButton);
            QVERIFY(QTest::qWaitFor([&] { return mStudio->solver.status().converged; }, 20'000));
            const metrics::UvMetrics figures =
                metrics::measureUv(document().mesh(), mStudio->solver.map()->uv);
            QCOMPARE(figures.flipped, 0);
            QCOMPARE(figures.overlapPairs, 0);
        }
        QTRY_VERIFY_WITH_TIMEOUT((mStudio->shown.uv().row(soup) - to).norm() < 0.1 * (to - from).norm(),
                                 20'000);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, end);
        QTRY_VERIFY_WITH_TIMEOUT(!mStudio->solver.isRunning() && !mStudio->solver.isPausing(),
                                 test::patience);
        QVERIFY(document().uv() == mStudio->solver.map()->uv);
    }

    //! Also what was torn on the way is closed again.
    void aDragOfTheRunningSolveIsTakenBack_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("by Escape") << true;
        QTest::newRow("by returning to where it began") << false;
    }
    void aDragOfTheRunningSolveIsTakenBack()
    {
        QFETCH(bool, byKey);
        openOneIsland();
        setRadius(0.3);
        runAt(0.05, 0.004);
        // Until then the map moves by itself.
        QVERIFY(QTest::qWaitFor([this] { return mStudio->solver.status().converged; }, test::patience));
        const int soup = soupAt({0.5, 1});
        const int entries = document().undoStack().count();
        const Row from = mStudio->shown.uv().row(soup);
        const QPoint start = pixel(from.transpose()), end = start - QPoint(0, 110);
        pressAndPull(start, end);
        QTRY_VERIFY_WITH_TIMEOUT((mStudio->shown.uv().row(soup) - from - Row(0, 0.55)).norm() < 0.02,
                                 test::patience);
        if (byKey) {
            QTest::keyClick(&view(), Qt::Key_Escape);
        } else {
            Canvases::moveMouse(view(), start + QPoint(3, 2), Qt::LeftButton);
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(3, 2));
        }
        QTRY_VERIFY_WITH_TIMEOUT((mStudio->shown.uv().row(soup) - from).norm() < 0.02, test::patience);
        if (byKey)
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, end);
        QVERIFY(mStudio->solver.isRunning());
        QCOMPARE(document().undoStack().count(), entries);
    }

    void theDefiniteMapOfASolveTears()
    {
        openOneIsland(test::grid(24, 0.6));
        setRadius(0.2);
        mStudio->solver.setMode(SolveMode::Budget);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([&] { return mStudio->shown.isLive(); }, test::patience));
        const int entries = document().undoStack().count();
        const int soup = soupAt({0.5, 1});
        const QPoint start = pixel(mStudio->shown.uv().row(soup).transpose());
        const auto isTorn = [&] {
            const std::vector<PairState> &states = document().seams().states;
            return std::count(states.begin(), states.end(), PairState::Cut) > 0;
        };
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        int steps = 0;
        for (; steps < 40 && !isTorn(); ++steps) {
            const auto before = mStudio->solver.map();
            Canvases::moveMouse(view(), start - QPoint(0, 8 * (steps + 1)), Qt::LeftButton);
            QVERIFY(QTest::qWaitFor([&] { return mStudio->solver.map() != before; }, test::patience));
            const metrics::UvMetrics figures =
                metrics::measureUv(document().mesh(), mStudio->solver.map()->uv);
            QCOMPARE(figures.flipped, 0);
            QCOMPARE(figures.overlapPairs, 0);
        }
        QVERIFY(steps > 2 && steps < 40);
        const QPoint end = start - QPoint(0, 8 * steps);
        // Two or three: where it tears depends on how far the map was.
        QTRY_VERIFY_WITH_TIMEOUT(mStudio->solver.map()->islands > 1, test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(
            (pixel(mStudio->shown.uv().row(soup).transpose()) - end).manhattanLength() < 12, test::patience);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!isTorn());
        QCOMPARE(document().undoStack().count(), entries);
        QTRY_COMPARE_WITH_TIMEOUT(mStudio->solver.map()->islands, 1, test::patience);
        QVERIFY(mStudio->solver.isRunning());
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, end);
    }

private:
    void cutWhatIsOpen()
    {
        const std::vector<float> &separation = mStudio->shown.separation();
        IndexRanges open;
        for (int pair = 0; pair < static_cast<int>(separation.size()); ++pair) {
            if (separation[pair] >= 0.5f)
                open.append(pair);
        }
        QVERIFY(!open.isEmpty());
        pushCommand(std::make_unique<SetSeamState>(document(), SetSeamState::Edit::Cut, open));
    }
    void runAt(double lambda, double delta)
    {
        SolveSettings settings = document().solveSettings();
        settings.lambda = lambda;
        settings.delta = delta;
        pushCommand(std::make_unique<ChangeSettings>(document(), settings));
        mStudio->solver.setMode(SolveMode::Manual);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([this] { return mStudio->solver.status().iteration > 2; }, test::patience));
    }
    //! In small steps, so that the solver keeps up.
    void pressAndPull(const QPoint &from, const QPoint &to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 10; ++step) {
            Canvases::moveMouse(view(), from + (to - from) * step / 10, Qt::LeftButton);
            const int iteration = mStudio->solver.status().iteration;
            QVERIFY(QTest::qWaitFor(
                [&] {
                    return mStudio->solver.status().iteration > iteration + 2 ||
                           mStudio->solver.status().converged;
                },
                test::patience));
        }
    }
};

QTEST_MAIN(TestDragWhileSolving)

} // namespace tst_dragwhilesolving

#include "tst_dragwhilesolving.moc"
