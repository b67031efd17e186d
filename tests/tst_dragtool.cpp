// Pulling at the map with real mouse, wheel and key events. While a solve runs: tst_dragwhilesolving.
#include "commands/editpins.h"
#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "model/plain/uvlayout.h"
#include "support/canvases.h"
#include "support/dragbench.h"
#include "support/editsupport.h"
#include "views/tools/draghandles.h"

#include <QTest>

#include <algorithm>
#include <functional>

namespace tst_dragtool {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestDragTool : public QObject, protected test::DragBench
{
    Q_OBJECT

private Q_SLOTS:
    void init() { begin(); }
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
    UvMatrix splitUv() { return test::splitLayout(document().mesh()); }
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
};

QTEST_MAIN(TestDragTool)

} // namespace tst_dragtool

#include "tst_dragtool.moc"
