// Pulling at the map with real mouse, wheel and key events, with and without a running solve.
#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "model/plain/uvlayout.h"
#include "solver/metrics/uvmetrics.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "views/tools/draghandles.h"
#include "views/tools/dragtool.h"

#include <QTest>

#include <algorithm>
#include <functional>

namespace tst_dragtool {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestDragTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = Canvases::onGrid(8);
        mStudio->tools.setTool(u"drag"_s);
        QCOMPARE(mStudio->tools.tool()->id(), u"drag"_s);
        mStudio->select(SelectionMode::Vertices);
    }
    void cleanup() { mStudio.reset(); }

    void whatIsInTheCircleFollows()
    {
        setRadius(0.3);
        const double radius = tool().radius() / 200;
        QVERIFY(radius > 0.28 && radius < 0.32);
        const DocumentState before = test::withoutSelection(document().state());
        const UvMatrix uv = document().uv();
        drag({0.25, 0.5}, {0.3, 0.45});
        QCOMPARE(document().undoStack().count(), 1);
        for (int c = 0; c < uv.rows(); ++c) {
            const double distance = (uv.row(c) - Row(0.25, 0.5)).norm();
            const Row way = document().uv().row(c) - uv.row(c);
            if (distance > radius || uv(c, 0) > 1) {
                QCOMPARE(way.norm(), 0.0);
            } else {
                const double share = 1 - distance * distance / (radius * radius);
                QVERIFY((way - share * share * Row(0.05, -0.05)).norm() < 1e-9);
            }
        }
        QCOMPARE(document().islands().count(), 2);
        const DocumentState after = test::withoutSelection(document().state());
        document().undoStack().undo();
        QVERIFY(test::withoutSelection(document().state()) == before);
        document().undoStack().redo();
        QVERIFY(test::withoutSelection(document().state()) == after);
        QCOMPARE(document().validate(), QString());
    }

    void theWheelChangesTheCircleDuringADrag()
    {
        setRadius(0.1);
        const QPoint start = pixel({0.25, 0.5});
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        Canvases::moveMouse(view(), start + QPoint(0, -8), Qt::LeftButton);
        const UvMatrix narrow = document().uv();
        Canvases::turnWheel(view(), start, 120 * 8, Qt::ShiftModifier);
        QVERIFY(tool().radius() > 50);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(0, -8));
        QVERIFY(moved(document().uv(), narrow) > 4);
        QCOMPARE(document().undoStack().count(), 1);
        const double radius = tool().radius();
        Canvases::turnWheel(view(), start, 120, {}); // zooms
        QCOMPARE(tool().radius(), radius);
    }

    void noTriangleTurnsOver_data()
    {
        QTest::addColumn<SelectionMode>("mode");
        QTest::addColumn<double>("radius");
        QTest::newRow("vertex") << SelectionMode::Vertices << 0.05;
        QTest::newRow("vertex and around") << SelectionMode::Vertices << 0.4;
        QTest::newRow("edge") << SelectionMode::Edges << 0.2;
        QTest::newRow("face") << SelectionMode::Faces << 0.2;
    }

    void noTriangleTurnsOver()
    {
        QFETCH(SelectionMode, mode);
        QFETCH(double, radius);
        mStudio->select(mode);
        setRadius(radius);
        for (const Vec2 &way : {Vec2(2, 1), Vec2(-1, 3), Vec2(0, -2), Vec2(-5, -5)}) {
            const UvMatrix before = document().uv();
            drag({0.25 + (mode == SelectionMode::Vertices ? 0 : 0.06), 0.5}, Vec2(0.25, 0.5) + way);
            QVERIFY(moved(document().uv(), before) > 0);
            QVERIFY(smallestArea() > 0);
            document().undoStack().undo();
            QVERIFY(document().uv() == before);
        }
    }

    void islandsMoveWhole()
    {
        mStudio->select(SelectionMode::Islands);
        const UvMatrix before = document().uv();
        drag({0.3, 0.3}, {0.1, 0.4});
        for (int c = 0; c < before.rows(); ++c) {
            const Row way = document().uv().row(c) - before.row(c);
            QVERIFY((way - (before(c, 0) > 1 ? Row(0, 0) : Row(-0.2, 0.1))).norm() < 1e-9);
        }
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QVERIFY(document().uv() == before);
    }

    void cornersSnapToTheirPartners()
    {
        // All partners of the border, by a drag of the whole island.
        mStudio->select(SelectionMode::Islands);
        const QPoint start = pixel({0.3, 0.3});
        Canvases::drag(view(), {start, start + QPoint(195, 6)});
        QCOMPARE(document().islands().count(), 1);
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QCOMPARE(document().islands().count(), 2);
        document().undoStack().redo();
        QCOMPARE(document().islands().count(), 1);
        document().undoStack().undo();
        // Not from further away.
        Canvases::drag(view(), {start, start + QPoint(180, 6)});
        QCOMPARE(document().islands().count(), 2);
        document().undoStack().undo();
        // One vertex alone.
        mStudio->select(SelectionMode::Vertices);
        setRadius(0.7);
        const QPoint corner = pixel({0.5, 1});
        Canvases::drag(view(), {corner, corner + QPoint(194, 0)});
        const int soup = soupAt({0.4999, 0.0});
        QVERIFY(soup >= 0);
        QVERIFY(moved(document().uv(), splitUv()) > 0);
        QCOMPARE((document().uv().rowwise() - Row(1.5, 1)).rowwise().norm().minCoeff(), 0.0);
        QVERIFY(smallestArea() > 0);
    }

    void lockedIslandsAndPinsStay()
    {
        const UvMatrix before = document().uv();
        UvPin pin;
        for (int c = 0; c < before.rows(); ++c) {
            if ((before.row(c) - Row(0.25, 0.625)).norm() < 1e-9)
                pin.corner = c;
        }
        pin.position = before.row(pin.corner);
        pushCommand(std::make_unique<EditPins>(document(), EditPins::Edit::Pin, std::vector{pin}));
        setRadius(0.3);
        drag({0.25, 0.5}, {0.29, 0.46});
        QVERIFY(moved(document().uv(), before) > 4);
        QCOMPARE(document().uv().row(pin.corner), before.row(pin.corner));
        document().undoStack().undo();
        pushCommand(std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector{0}));
        drag({0.25, 0.5}, {0.3, 0.5});
        QVERIFY(document().uv() == before);
        QCOMPARE(document().undoStack().count(), 2);
        // A pinned vertex takes its pin along.
        pushCommand(
            std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Unlock, std::vector{0}));
        drag({0.25, 0.625}, {0.25, 0.675});
        QVERIFY((document().constraints().pins[0].position - Vec2(0.25, 0.675)).norm() < 1e-9);
    }

    void escapeLeavesNoTrace()
    {
        const DocumentState before = document().state();
        const QPoint start = pixel({0.25, 0.5});
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        Canvases::moveMouse(view(), start + QPoint(10, 10), Qt::LeftButton);
        QVERIFY(!(document().state() == before));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(document().state() == before);
        Canvases::moveMouse(view(), start + QPoint(20, 10), Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(20, 10));
        QVERIFY(document().state() == before);
        QCOMPARE(document().undoStack().count(), 0);
    }

    void clicksSelect()
    {
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({0.25, 0.5}));
        QCOMPARE(document().selection().corners.size(), 4);
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel({0.25, 0.25}));
        QCOMPARE(document().selection().corners.size(), 8);
        QCOMPARE(document().undoStack().count(), 0);
        // What is selected moves together.
        const UvMatrix before = document().uv();
        setRadius(0.05);
        drag({0.25, 0.5}, {0.27, 0.5});
        QCOMPARE(moved(document().uv(), before), 8);
    }

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

    void aPulledMapTears_data()
    {
        QTest::addColumn<SelectionMode>("mode");
        QTest::addColumn<Vec2>("from");
        QTest::addColumn<Vec2>("held"); // not yet torn there
        QTest::addColumn<Vec2>("torn");
        QTest::newRow("border vertex, outwards")
            << SelectionMode::Vertices << Vec2(0.5, 1) << Vec2(0.5, 1.4) << Vec2(0.5, 1.9);
        QTest::newRow("inner vertex, sideways")
            << SelectionMode::Vertices << Vec2(0.5, 0.5) << Vec2(0.6, 0.5) << Vec2(0.95, 0.5);
        QTest::newRow("face") << SelectionMode::Faces << Vec2(0.56, 0.94) << Vec2(0.56, 1.3)
                              << Vec2(0.56, 2.1);
    }

    //! Paper, "tear-up gesture", on a definite map.
    void aPulledMapTears()
    {
        QFETCH(const SelectionMode, mode);
        QFETCH(const Vec2, from);
        QFETCH(const Vec2, held);
        QFETCH(const Vec2, torn);
        openOneIsland();
        mStudio->select(mode);
        setRadius(0.3);
        const DocumentState before = test::withoutSelection(document().state());
        drag(from, held);
        QCOMPARE(document().islands().count(), 1);
        document().undoStack().undo();
        drag(from, torn);
        QCOMPARE(document().undoStack().count(), 1);
        QVERIFY(document().undoStack().text(0).startsWith(u"Tear "_s));
        QCOMPARE(document().islands().count(), 2);
        QVERIFY(smallestArea() > 0);
        // What came off keeps its shape and is where the mouse is.
        const UvMatrix ways = document().uv() - before.scene.uvSets[0].uv;
        const Row way = (torn - from).transpose();
        for (int c = 0; c < ways.rows(); ++c)
            QVERIFY(ways.row(c).norm() < 1e-9 || (ways.row(c) - way).norm() < 0.02);
        QVERIFY(std::count(document().seams().states.begin(), document().seams().states.end(),
                           PairState::Cut) >= 4);
        QCOMPARE(document().validate(), QString());
        const DocumentState after = test::withoutSelection(document().state());
        document().undoStack().undo();
        QVERIFY(test::withoutSelection(document().state()) == before);
        document().undoStack().redo();
        QVERIFY(test::withoutSelection(document().state()) == after);
    }

    void beforeItTearsTheToolSaysSo()
    {
        openOneIsland();
        setRadius(0.3);
        const DocumentState before = document().state();
        const QPoint start = pixel({0.5, 1});
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        const auto hintAt = [&](int pixels) {
            Canvases::moveMouse(view(), start - QPoint(0, pixels), Qt::LeftButton);
            return tool().hint();
        };
        const QString calm = hintAt(20);
        QVERIFY(hintAt(80).startsWith(u"Pull further"_s));
        QCOMPARE(hintAt(20), calm);
        QVERIFY(hintAt(190).startsWith(u"Torn off"_s));
        QString said;
        connect(&tool(), &AbstractTool::hintChanged, &tool(), [&] { said = tool().hint(); });
        QTest::keyClick(&view(), Qt::Key_Escape);
        QCOMPARE(said, calm);
        QVERIFY(document().state() == before);
        QCOMPARE(document().undoStack().count(), 0);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start - QPoint(0, 190));
        QVERIFY(document().state() == before);
    }

    void joinedEdgesDoNotTear()
    {
        openOneIsland();
        setRadius(0.3);
        IndexRanges all;
        all.append(IndexRange{0, document().mesh().cornerPairCount()});
        pushCommand(std::make_unique<SetSeamState>(document(), SetSeamState::Edit::Join, all));
        drag({0.5, 0.5}, {0.95, 0.5});
        QCOMPARE(document().islands().count(), 1);
        QVERIFY(smallestArea() > 0);
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

    //! The triangles of a large mesh are not in the order of its faces.
    void handlesRiseInLargeMeshes()
    {
        openOneIsland(test::grid(64));
        const std::vector<int> &order = document().mesh().triangleFace;
        QVERIFY(!std::is_sorted(order.begin(), order.end()));
        Selection selection;
        selection.mode = SelectionMode::Faces;
        for (int face = 0; face < 500; ++face)
            selection.faces << face;
        document().setSelection(selection);
        PickResult pick;
        pick.triangle = document().mesh().trianglesOf(100).front();
        const std::vector<int> corners = dragHandles(document(), view(), mStudio->shown, pick);
        QCOMPARE(corners.size(), std::size_t(3000));
        QVERIFY(std::adjacent_find(corners.begin(), corners.end(), std::greater_equal<>()) == corners.end());
    }

private:
    using Row = Eigen::RowVector2d;
    Document &document() { return mStudio->document(); }
    UvView &view() { return mStudio->uv; }
    DragTool &tool() { return *qobject_cast<DragTool *>(mStudio->tools.tool()); }
    QPoint pixel(const Vec2 &uv) { return view().camera().toScreen(uv).toPoint(); }
    void drag(const Vec2 &from, const Vec2 &to) { Canvases::drag(view(), {pixel(from), pixel(to)}); }
    UvMatrix splitUv() { return test::splitLayout(document().mesh()); }
    void openOneIsland(const test::MeshPtr &mesh = test::grid(8))
    {
        Scene scene = test::sceneOf(mesh);
        UvMatrix uv(scene.mesh->cornerCount(), 2);
        for (int c = 0; c < scene.mesh->cornerCount(); ++c)
            uv.row(c) = scene.mesh->cornerPosition(c).head<2>();
        scene.uvSets = {{u"UV"_s, uv}};
        const MapCamera camera = view().camera();
        mStudio->open(std::make_unique<Document>(std::move(scene)));
        view().setCamera(camera);
        mStudio->select(SelectionMode::Vertices);
    }
    //! By the wheel, to the nearest notch.
    void setRadius(double uv)
    {
        const double notches = std::log(uv * 200 / tool().radius()) / std::log(1.15);
        Canvases::turnWheel(view(), {250, 250}, static_cast<int>(std::lround(120 * notches)),
                            Qt::ShiftModifier);
    }
    static int moved(const UvMatrix &a, const UvMatrix &b)
    {
        return static_cast<int>(((a - b).rowwise().norm().array() > 0).count());
    }
    double smallestArea()
    {
        const UvMatrix soup = soupUv(document().mesh(), document().uv());
        double least = 1;
        for (Eigen::Index s = 0; s < soup.rows(); s += 3) {
            const Row p = soup.row(s + 1) - soup.row(s), q = soup.row(s + 2) - soup.row(s);
            least = std::min(least, p.x() * q.y() - p.y() * q.x());
        }
        return least;
    }
    int soupAt(const Vec2 &uv)
    {
        int row = -1;
        (mStudio->shown.uv().rowwise() - uv.transpose()).rowwise().norm().minCoeff(&row);
        return row;
    }
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

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestDragTool)

} // namespace tst_dragtool

#include "tst_dragtool.moc"
