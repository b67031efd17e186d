// Drawing, changing and removing rectangles and assigning islands to them, with real mouse and key events.
#include "commands/setislandflags.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "views/tools/rectangletool.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QToolButton>

namespace tst_rectangletool {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestRectangleTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = Canvases::onGrid(4);
        mStudio->tools.setTool(u"rectangle"_s);
        QCOMPARE(tool().id(), u"rectangle"_s);
    }
    void cleanup() { mStudio.reset(); }

    void drawing()
    {
        drag(pixel({0.6, 0.8}), pixel({1.4, 0.3}));
        QCOMPARE(rectangles().size(), 1u);
        const LayoutRectangle made = rectangles().front();
        QCOMPARE(made.id, 1);
        QVERIFY((made.lower - Vec2(0.6, 0.3)).norm() < 1e-12);
        QVERIFY((made.upper - Vec2(1.4, 0.8)).norm() < 1e-12);
        QCOMPARE(made.name, u"Rectangle 1"_s);
        QVERIFY(!made.hard && made.faces.isEmpty());
        QCOMPARE(document().undoStack().count(), 1);
        QCOMPARE(document().undoStack().undoText(), u"Add rectangle"_s);
        QCOMPARE(tool().active(), 1);
        document().undoStack().undo();
        QVERIFY(rectangles().empty());
        QCOMPARE(tool().active(), 0);
        document().undoStack().redo();
        QVERIFY(rectangles().front() == made);
    }

    void drawingIsCancelled()
    {
        const QPoint start = pixel({0.6, 0.8});
        for (const bool byKey : {true, false}) {
            QTest::mousePress(&view(), Qt::LeftButton, {}, start);
            Canvases::moveMouse(view(), start + QPoint(50, 50), Qt::LeftButton);
            QCOMPARE(rectangles().size(), 1u);
            if (byKey)
                QTest::keyClick(&view(), Qt::Key_Escape);
            else
                QTest::mousePress(&view(), Qt::RightButton, {}, start + QPoint(50, 50));
            QVERIFY(rectangles().empty());
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(50, 50));
            if (!byKey)
                QTest::mouseRelease(&view(), Qt::RightButton, {}, start + QPoint(50, 50));
            QCOMPARE(document().undoStack().count(), 0);
            QVERIFY(!document().undoStack().canRedo());
        }
        drag(start, start + QPoint(60, 0)); // no area
        QVERIFY(rectangles().empty());
        QTest::mouseClick(&view(), Qt::LeftButton, {}, start);
        QVERIFY(rectangles().empty());
    }

    void shiftDrawsOverIslands()
    {
        QTest::mousePress(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel({0.2, 0.3}));
        Canvases::moveMouse(view(), pixel({0.3, 0.6}), Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel({0.3, 0.6}));
        QCOMPARE(rectangles().size(), 1u);
    }

    void ctrlSnapsToTexelsAndTiles()
    {
        const QPoint start = pixel({0.6, 0.8}) + QPoint(3, 1);
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        mouse(start + QPoint(107, 83), Qt::ControlModifier | Qt::ShiftModifier);
        const Vec2 lower = 2048 * rectangles().front().lower, upper = 2048 * rectangles().front().upper;
        QVERIFY((lower - Vec2(lower.array().round())).norm() < 1e-9);
        QVERIFY((upper - Vec2(upper.array().round())).norm() < 1e-9);
        mouse(start + QPoint(107, 103), Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(rectangles().front().upper, Vec2(1, 1));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start);
    }

    void movingByOutlineAndByInside()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        const LayoutRectangle before = rectangles().front();
        drag(pixel({0.6, 0.35}), pixel({0.6, 0.35}) + QPoint(20, -10));
        QVERIFY((rectangles().front().lower - Vec2(0.7, 0.25)).norm() < 1e-12);
        QVERIFY((rectangles().front().upper - Vec2(1.5, 0.85)).norm() < 1e-12);
        QCOMPARE(document().undoStack().undoText(), UndoText::tr("Move %n rectangles", nullptr, 1));
        QCOMPARE(document().undoStack().count(), 2);
        document().undoStack().undo();
        QVERIFY(rectangles().front() == before);
        drag(pixel({1, 0.4}), pixel({1, 0.4}) + QPoint(20, -10));
        QVERIFY((rectangles().front().lower - Vec2(0.7, 0.25)).norm() < 1e-12);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixel({1, 0.6}));
        Canvases::moveMouse(view(), pixel({0.5, 0.1}), Qt::LeftButton);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel({0.5, 0.1}));
        QVERIFY((rectangles().front().lower - Vec2(0.7, 0.25)).norm() < 1e-12);
        QCOMPARE(document().undoStack().count(), 2);
    }

    void resizingByHandles_data()
    {
        QTest::addColumn<QPointF>("handle");
        QTest::addColumn<QPointF>("lower");
        QTest::addColumn<QPointF>("upper");
        QTest::newRow("upper right") << QPointF(1.4, 0.8) << QPointF(0.6, 0.2) << QPointF(1.5, 0.9);
        QTest::newRow("lower left") << QPointF(0.6, 0.2) << QPointF(0.7, 0.3) << QPointF(1.4, 0.8);
        QTest::newRow("right") << QPointF(1.4, 0.5) << QPointF(0.6, 0.2) << QPointF(1.5, 0.8);
        QTest::newRow("bottom") << QPointF(1, 0.2) << QPointF(0.6, 0.3) << QPointF(1.4, 0.8);
    }

    void resizingByHandles()
    {
        QFETCH(QPointF, handle);
        QFETCH(QPointF, lower);
        QFETCH(QPointF, upper);
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        QCOMPARE(tool().active(), 1);
        const QPoint from = pixel({handle.x(), handle.y()});
        drag(from, from + QPoint(20, -20));
        QVERIFY((rectangles().front().lower - Vec2(lower.x(), lower.y())).norm() < 1e-12);
        QVERIFY((rectangles().front().upper - Vec2(upper.x(), upper.y())).norm() < 1e-12);
        QCOMPARE(document().undoStack().undoText(), UndoText::tr("Resize %n rectangles", nullptr, 1));
        QCOMPARE(document().undoStack().count(), 2);
        document().undoStack().undo();
        QCOMPARE(rectangles().front().upper, Vec2(1.4, 0.8));
    }

    void resizingBeyondTheOtherSide()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        drag(pixel({1.4, 0.5}), pixel({0.1, 0.5}));
        QVERIFY((rectangles().front().lower - Vec2(0.1, 0.2)).norm() < 1e-12);
        QVERIFY((rectangles().front().upper - Vec2(0.6, 0.8)).norm() < 1e-12);
    }

    void deleteRemoves()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        add({0.7, 1.1}, {1.2, 1.4});
        QTest::keyClick(&view(), Qt::Key_Delete); // none is active
        QCOMPARE(rectangles().size(), 2u);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 1.2}));
        QCOMPARE(tool().active(), 2);
        QTest::keyClick(&view(), Qt::Key_Delete);
        QCOMPARE(rectangles().size(), 1u);
        QCOMPARE(rectangles().front().id, 1);
        QCOMPARE(tool().active(), 0);
        document().undoStack().undo();
        QCOMPARE(rectangles().size(), 2u);
    }

    void doubleClickRenames()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        auto *name = child<QLineEdit>("rectangleName");
        QVERIFY(name->isVisible());
        QCOMPARE(name->selectedText(), u"box"_s);
        QTest::keyClicks(name, u"head"_s);
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(rectangles().front().name, u"head"_s);
        QCOMPARE(document().undoStack().undoText(), UndoText::tr("Rename %n rectangles", nullptr, 1));
        QCOMPARE(document().undoStack().count(), 2);
        document().undoStack().undo();
        QCOMPARE(rectangles().front().name, u"box"_s);
        QCOMPARE(name->text(), u"box"_s);
    }

    void numbersMoveAndResize()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        const auto type = [&](const char *name, const QString &text) {
            auto *field = child<QDoubleSpinBox>(name);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
        };
        type("rectangleU", u"0.25"_s);
        QVERIFY((rectangles().front().lower - Vec2(0.25, 0.2)).norm() < 1e-12);
        QVERIFY((rectangles().front().upper - Vec2(1.05, 0.8)).norm() < 1e-12);
        QCOMPARE(document().undoStack().undoText(), UndoText::tr("Move %n rectangles", nullptr, 1));
        type("rectangleHeight", u"0.5"_s);
        QVERIFY((rectangles().front().upper - Vec2(1.05, 0.7)).norm() < 1e-12);
        QVERIFY((rectangles().front().lower - Vec2(0.25, 0.2)).norm() < 1e-12);
        QCOMPARE(document().undoStack().undoText(), UndoText::tr("Resize %n rectangles", nullptr, 1));

        auto *unit = child<QComboBox>("rectangleUnit");
        unit->setCurrentIndex(1);
        Q_EMIT unit->activated(1);
        QCOMPARE(child<QDoubleSpinBox>("rectangleU")->value(), 512.0);
        type("rectangleWidth", u"1024"_s);
        QVERIFY((rectangles().front().upper - Vec2(0.75, 0.7)).norm() < 1e-12);
        QCOMPARE(document().undoStack().count(), 4);
        // Steps with the arrow keys in one field are one entry.
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(child<QDoubleSpinBox>("rectangleV"), Qt::Key_Up);
        QVERIFY(std::abs(rectangles().front().lower.y() - 0.2 - 3.0 / 2048) < 1e-12);
        QCOMPARE(document().undoStack().count(), 5);
        type("rectangleWidth", u"0"_s); // the smallest
        QVERIFY(rectangles().front().upper.x() > rectangles().front().lower.x());
        for (int i = 0; i < 5; ++i)
            document().undoStack().undo();
        QCOMPARE(rectangles().front().lower, Vec2(0.6, 0.2));
        QCOMPARE(child<QDoubleSpinBox>("rectangleU")->value(), 1228.8);
    }

    void barChangesTheRectangle()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        child<QDoubleSpinBox>("rectangleWeight")->setValue(2.5);
        QCOMPARE(rectangles().front().weight, 2.5);
        child<QCheckBox>("rectangleHard")->click();
        QVERIFY(rectangles().front().hard);
        QVERIFY(!child<QDoubleSpinBox>("rectangleWeight")->isEnabled());
        QCOMPARE(document().undoStack().count(), 3);
        Selection selection;
        selection.faces = {1, 2};
        document().setSelection(selection);
        child<QToolButton>("rectangleAssign")->click();
        QCOMPARE(rectangles().front().faces, QList<int>({1, 2}));
        child<QToolButton>("rectangleClear")->click();
        QVERIFY(rectangles().front().faces.isEmpty());
        const QRgb color = rectangles().front().color;
        child<QToolButton>("rectangleColor")->menu()->actions().at(3)->trigger();
        QVERIFY(rectangles().front().color != color);
        child<QToolButton>("rectangleRemove")->click();
        QVERIFY(rectangles().empty());
        QVERIFY(!child<QLineEdit>("rectangleName")->isVisible());
        while (document().undoStack().index() > 1)
            document().undoStack().undo();
        QCOMPARE(rectangles().front().weight, 1.0);
        QVERIFY(child<QLineEdit>("rectangleName") && !rectangles().front().hard);
    }

    void droppedIslandsAreAssigned()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        add({0.7, 1.1}, {1.2, 1.4});
        const UvMatrix before = document().uv();
        drag(pixel({0.3, 0.3}), pixel({1, 0.5}));
        QCOMPARE(rectangles()[0].faces, leftFaces);
        QCOMPARE(document().undoStack().undoText(),
                 UndoText::tr("Assign faces to %n rectangles", nullptr, 1));
        QCOMPARE(tool().active(), 1);
        // Into another one: no face is in two.
        drag(pixel({0.3, 0.3}), pixel({1, 1.2}));
        QVERIFY(rectangles()[0].faces.isEmpty());
        QCOMPARE(rectangles()[1].faces, leftFaces);
        drag(pixel({1.8, 0.3}), pixel({1, 1.2}));
        QCOMPARE(rectangles()[1].faces.size(), 16);
        // Outside: it is let go.
        drag(pixel({0.3, 0.3}), pixel({1, -0.3}));
        QCOMPARE(rectangles()[1].faces, rightFaces);
        QCOMPARE(document().undoStack().count(), 6);
        document().undoStack().undo();
        document().undoStack().undo();
        document().undoStack().undo();
        QCOMPARE(rectangles()[0].faces, leftFaces);
        document().undoStack().redo();
        QCOMPARE(rectangles()[1].faces, leftFaces);
        QVERIFY(document().uv() == before);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixel({1.8, 0.3}));
        Canvases::moveMouse(view(), pixel({1, 0.5}), Qt::LeftButton);
        QVERIFY(tool().isBusy());
        QTest::keyClick(&view(), Qt::Key_Escape);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel({1, 0.5}));
        QVERIFY(rectangles()[0].faces.isEmpty());
    }

    void selectedIslandsAreAssignedTogetherButNotLockedOnes()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        Selection selection;
        selection.faces = {0, 3};
        document().setSelection(selection);
        drag(pixel({0.3, 0.3}), pixel({1, 0.5}));
        QCOMPARE(rectangles()[0].faces.size(), 16);
        document().undoStack().undo();
        pushCommand(
            std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector<int>{1}));
        drag(pixel({0.3, 0.3}), pixel({1, 0.5}));
        QCOMPARE(rectangles()[0].faces, leftFaces);
    }

    void rectanglesSteerTheRunningSolve()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        mStudio->solver.setMode(SolveMode::Manual);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([this] { return mStudio->solver.status().iteration > 2; }, 60'000));
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({0.6, 0.35}));
        drag(pixel({0.6, 0.35}), pixel({0.6, 0.35}) + QPoint(20, -10));
        QVERIFY(mStudio->solver.isRunning());
        QVERIFY((rectangles().front().lower - Vec2(0.7, 0.25)).norm() < 1e-12);
        mStudio->solver.pause();
        QVERIFY(QTest::qWaitFor([this] { return !mStudio->solver.isPausing(); }, 60'000));
    }

    void otherDocumentsAndToolsHideTheBar()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        auto *name = child<QLineEdit>("rectangleName");
        QVERIFY(name->isVisible());
        mStudio->tools.setTool(u"select"_s);
        QVERIFY(!name->isVisible());
        document().undoStack().undo();
        document().undoStack().redo();
        QVERIFY(!name->isVisible());
        mStudio->tools.setTool(u"rectangle"_s);
        QCOMPARE(tool().active(), 0); // undo has removed it
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        QVERIFY(name->isVisible());
        mStudio->tools.setTool(u"pin"_s);
        mStudio->tools.setTool(u"rectangle"_s);
        QVERIFY(name->isVisible());
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixel({0.6, 0.35}));
        Canvases::moveMouse(view(), pixel({0.8, 0.5}), Qt::LeftButton);
        mStudio->open(test::layoutDocument(test::grid(4)));
        QVERIFY(!name->isVisible() && !tool().isBusy());
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel({0.8, 0.5}));
        QVERIFY(rectangles().empty());
        mStudio->workspace.close();
        QVERIFY(!view().picture().isNull());
    }

    void handlesAreDrawn()
    {
        add({0.6, 0.2}, {1.4, 0.8});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, 0.45}));
        QCOMPARE(view().picture().pixelColor(pixel({1, 0.2})), QColor(Qt::white));
    }

private:
    Document &document() { return mStudio->document(); }
    const std::vector<LayoutRectangle> &rectangles() { return document().constraints().rectangles; }
    UvView &view() { return mStudio->uv; }
    RectangleTool &tool() { return *qobject_cast<RectangleTool *>(mStudio->tools.tool()); }
    template <typename Widget>
    Widget *child(const char *name)
    {
        return view().findChild<Widget *>(QLatin1String(name));
    }
    QPoint pixel(const Vec2 &uv) { return view().camera().toScreen(uv).toPoint(); }
    void mouse(const QPoint &place, Qt::KeyboardModifiers modifiers)
    {
        QMouseEvent event(QEvent::MouseMove, place, view().mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          modifiers);
        QCoreApplication::sendEvent(&view(), &event);
    }
    void drag(const QPoint &from, const QPoint &to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, {}, from);
        Canvases::moveMouse(view(), (from + to) / 2, Qt::LeftButton);
        Canvases::moveMouse(view(), to, Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    }
    void add(const Vec2 &lower, const Vec2 &upper)
    {
        LayoutRectangle rectangle;
        rectangle.name = u"box"_s;
        rectangle.lower = lower;
        rectangle.upper = upper;
        pushCommand(EditRectangles::add(document(), rectangle));
    }

    const QList<int> leftFaces{0, 1, 4, 5, 8, 9, 12, 13}, rightFaces{2, 3, 6, 7, 10, 11, 14, 15};
    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestRectangleTool)

} // namespace tst_rectangletool

#include "tst_rectangletool.moc"
