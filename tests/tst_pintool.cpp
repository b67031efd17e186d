// Pinning, unpinning and dragging pins with real mouse and key events.
#include "commands/setislandflags.h"
#include "model/plain/uvlayout.h"
#include "support/canvases.h"
#include "support/editsupport.h"

#include <QMouseEvent>
#include <QTest>

#include <algorithm>

namespace tst_pintool {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestPinTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = Canvases::onGrid(4);
        mStudio->tools.setTool(u"pin"_s);
        QCOMPARE(tool().id(), u"pin"_s);
    }
    void cleanup() { mStudio.reset(); }

    void clickPinsAndUnpins()
    {
        click({0.25, 0.25});
        QCOMPARE(pins().size(), 4u); // the corners of the vertex
        for (const UvPin &pin : pins()) {
            QVERIFY(pin.hard);
            QCOMPARE(pin.position, Vec2(0.25, 0.25));
        }
        QCOMPARE(document().undoStack().undoText(), u"Pin 4 corners"_s);
        const std::vector<UvPin> pinned = pins();
        click({0.25, 0.25});
        QVERIFY(pins().empty());
        document().undoStack().undo();
        QVERIFY(pins() == pinned);
        document().undoStack().undo();
        QVERIFY(pins().empty());
        document().undoStack().redo();
        QVERIFY(pins() == pinned);
        click({0.37, 0.37}); // no vertex is near
        QVERIFY(pins() == pinned);
        QVERIFY2(tool().hint().startsWith(u"No vertex is near"_s), qPrintable(tool().hint()));
        click({0.25, 0.25});
        QVERIFY(tool().hint().startsWith(u"Pin vertices"_s));
    }

    void seamsAreTwoPlaces()
    {
        click({0.5, 0.5}); // the right border of the left island
        QCOMPARE(pins().size(), 2u);
        mStudio->lookFromFront();
        document().undoStack().undo();
        // On the model it is one vertex.
        const int soup = soupAt({0.5, 0.5});
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, {}, Canvases::place(mStudio->mesh, {soup}));
        QCOMPARE(pins().size(), 4u);
        QVERIFY(std::count_if(pins().begin(), pins().end(),
                              [](const UvPin &pin) { return pin.position == Vec2(1.5, 0.5); }) == 2);
    }

    void shiftMakesSoftPins()
    {
        click({0.25, 0.25}, Qt::ShiftModifier);
        QCOMPARE(pins().size(), 4u);
        QVERIFY(!pins().front().hard);
        click({0.25, 0.25}, Qt::ShiftModifier);
        QCOMPARE(pins().size(), 4u);
        QVERIFY(pins().front().hard);
        click({0.25, 0.25}, Qt::ShiftModifier);
        QVERIFY(!pins().front().hard);
        document().undoStack().undo();
        QVERIFY(pins().front().hard);
        click({0.25, 0.25});
        QVERIFY(pins().empty());
    }

    void boxPinsAndUnpins()
    {
        drag(pixel({-0.1, -0.1}), pixel({0.35, 0.35}));
        QCOMPARE(pins().size(), 9u); // vertices of 1 + 2 + 2 + 4 faces
        QCOMPARE(document().undoStack().count(), 1);
        drag(pixel({0.35, 0.35}), pixel({0.1, 0.1}), Qt::ControlModifier);
        QCOMPARE(pins().size(), 5u);
        drag(pixel({-0.1, -0.1}), pixel({0.35, 0.35}), Qt::ShiftModifier);
        QCOMPARE(pins().size(), 9u);
        QCOMPARE(std::count_if(pins().begin(), pins().end(), [](const UvPin &pin) { return !pin.hard; }), 4);
        document().undoStack().undo();
        document().undoStack().undo();
        QCOMPARE(pins().size(), 9u);
        document().undoStack().undo();
        QVERIFY(pins().empty());
    }

    void islandModePinsIslands()
    {
        mStudio->select(SelectionMode::Islands);
        click({0.3, 0.3});
        QCOMPARE(pins().size(), 32u);
        click({0.3, 0.3});
        QVERIFY(pins().empty());
        drag(pixel({-0.2, -0.2}), pixel({2.2, 1.2}));
        QCOMPARE(pins().size(), 64u);
        QCOMPARE(document().undoStack().count(), 3);
        // All pins of the island under the mouse follow.
        const UvMatrix before = document().uv();
        drag(pixel({0.25, 0.25}), pixel({0.25, 0.25}) + QPoint(0, -20));
        const double way = (document().uv() - before).col(1).sum();
        QVERIFY(std::abs(way - 32 * 0.1) < 1e-9);
        QCOMPARE(document().undoStack().count(), 4);
    }

    void dragMovesThePinAndItsVertex()
    {
        click({0.25, 0.25});
        const UvMatrix before = document().uv();
        const std::vector<UvPin> pinned = pins();
        drag(pixel({0.25, 0.25}), pixel({0.25, 0.25}) + QPoint(10, 20));
        QCOMPARE(document().undoStack().count(), 2);
        for (const UvPin &pin : pins()) {
            QVERIFY((pin.position - Vec2(0.3, 0.15)).norm() < 1e-12);
            QVERIFY((document().uv().row(pin.corner).transpose() - pin.position).norm() < 1e-12);
        }
        QCOMPARE(((document().uv() - before).rowwise().norm().array() > 0).count(), 4);
        const std::vector<UvPin> moved = pins();
        document().undoStack().undo();
        QVERIFY(pins() == pinned);
        QVERIFY(document().uv() == before);
        document().undoStack().redo();
        QVERIFY(pins() == moved);
    }

    void escapeLeavesNoTrace()
    {
        click({0.25, 0.25});
        const DocumentState before = document().state();
        const QPoint start = pixel({0.25, 0.25});
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        Canvases::moveMouse(view(), start + QPoint(30, 0), Qt::LeftButton);
        QVERIFY(pins() != before.constraints.pins);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(30, 0));
        QVERIFY(pins() == before.constraints.pins);
        QVERIFY(document().uv() == before.scene.uvSets[0].uv);
        QCOMPARE(document().undoStack().count(), 1);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixel({-0.1, -0.1}));
        Canvases::moveMouse(view(), pixel({0.6, 0.6}), Qt::LeftButton);
        QVERIFY(tool().isBusy());
        QTest::mousePress(&view(), Qt::RightButton, {}, pixel({0.6, 0.6}));
        QVERIFY(!tool().isBusy());
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel({0.6, 0.6}));
        QVERIFY(pins() == before.constraints.pins);
    }

    void draggedPinsAreBlue()
    {
        click({0.25, 0.25});
        const QPoint start = pixel({0.25, 0.25}), end = start + QPoint(-30, 12);
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        Canvases::moveMouse(view(), end, Qt::LeftButton);
        const QColor color = view().picture().pixelColor(end);
        QVERIFY2(color.blue() > 200 && color.red() < 120, qPrintable(color.name()));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, end);
        const QColor after = view().picture().pixelColor(end);
        QVERIFY2(after.green() > after.blue(), qPrintable(after.name()));
    }

    void noTriangleTurnsOver()
    {
        click({0.25, 0.25});
        const UvMatrix before = document().uv();
        for (const Vec2 &way : {Vec2(1, 0.3), Vec2(-0.5, 2), Vec2(-3, -3)}) {
            drag(pixel({0.25, 0.25}), pixel(Vec2(0.25, 0.25) + way));
            QVERIFY(!(document().uv() == before));
            const UvMatrix soup = soupUv(document().mesh(), document().uv());
            for (Eigen::Index s = 0; s < soup.rows(); s += 3) {
                const RowVec p = soup.row(s + 1) - soup.row(s), q = soup.row(s + 2) - soup.row(s);
                QVERIFY(p.x() * q.y() - p.y() * q.x() > 0);
            }
            // The pin stays at its vertex.
            for (const UvPin &pin : pins())
                QVERIFY((document().uv().row(pin.corner).transpose() - pin.position).norm() < 1e-12);
            document().undoStack().undo();
            QVERIFY(document().uv() == before);
        }
    }

    //! While a solve or a job shows its map, an island is one of that map.
    void islandsOfTheShownMapArePinned()
    {
        Selection islands;
        islands.mode = SelectionMode::Islands;
        document().setSelection(islands);
        UvMatrix joined = document().uv(); // its two islands in one
        for (Eigen::Index c = 0; c < joined.rows(); ++c)
            joined(c, 0) -= document().islands().islandOfFace(document().adjacency().faceOfCorner(int(c)));
        mStudio->shown.showMap(joined);
        QTRY_VERIFY(mStudio->shown.uv() == soupUv(document().mesh(), joined));
        click({0.3, 0.3});
        QCOMPARE(pins().size(), std::size_t(joined.rows()));
    }

    void pinsOfLockedIslandsStay()
    {
        click({0.25, 0.25});
        pushCommand(
            std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector<int>{0}));
        const UvMatrix before = document().uv();
        const Vec2 place = pins().front().position;
        drag(pixel({0.25, 0.25}), pixel({0.3, 0.3}));
        QVERIFY(document().uv() == before);
        QCOMPARE(pins().front().position, place);
    }

    void pinsSteerTheRunningSolve()
    {
        click({0.25, 0.25});
        mStudio->solver.setMode(SolveMode::Manual);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([this] { return mStudio->solver.status().iteration > 2; }, 60'000));
        const UvMatrix before = document().uv();
        const QPoint start = pixel(pins().front().position);
        drag(start, start + QPoint(-20, 20));
        QVERIFY(mStudio->solver.isRunning());
        QVERIFY(document().uv() == before);
        QCOMPARE(document().undoStack().undoText(), u"Move 4 pins"_s);
        for (const UvPin &pin : pins())
            QVERIFY((pin.position - Vec2(0.15, 0.15)).norm() < 1e-12);
        const int soup = soupAt({0.25, 0.25});
        QVERIFY(QTest::qWaitFor(
            [&] { return (mStudio->shown.uv().row(soup) - RowVec(0.15, 0.15)).norm() < 0.01; }, 60'000));
        mStudio->solver.pause();
        QVERIFY(QTest::qWaitFor([this] { return !mStudio->solver.isPausing(); }, 60'000));
    }

private:
    using RowVec = Eigen::RowVector2d;

    Document &document() { return mStudio->document(); }
    const std::vector<UvPin> &pins() { return document().constraints().pins; }
    UvView &view() { return mStudio->uv; }
    AbstractTool &tool() { return *mStudio->tools.tool(); }
    QPoint pixel(const Vec2 &uv) { return view().camera().toScreen(uv).toPoint(); }
    void click(const Vec2 &uv, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&view(), Qt::LeftButton, modifiers, pixel(uv));
    }
    void drag(const QPoint &from, const QPoint &to, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&view(), Qt::LeftButton, modifiers, from);
        Canvases::moveMouse(view(), (from + to) / 2, Qt::LeftButton);
        Canvases::moveMouse(view(), to, Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, modifiers, to);
    }
    int soupAt(const Vec2 &uv)
    {
        const UvMatrix &shown = mStudio->shown.uv();
        int row = -1;
        (shown.rowwise() - uv.transpose()).rowwise().norm().minCoeff(&row);
        return row;
    }

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestPinTool)

} // namespace tst_pintool

#include "tst_pintool.moc"
