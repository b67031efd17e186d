// Moving, rotating and scaling islands with real mouse and key events in the UV view.
#include "commands/editpins.h"
#include "commands/setislandflags.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/studiosession.h"
#include "views/tools/islanddrag.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTest>

namespace tst_islandtool {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestIslandTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { mStudio = Canvases::onGrid(4); }
    void cleanup() { mStudio.reset(); }

    void dragMovesTheIslandUnderTheMouse()
    {
        use(u"move"_s);
        const UvMatrix before = document().uv();
        drag(pixel({0.25, 0.3}), pixel({0.25, 0.3}) + QPoint(20, -40));
        QCOMPARE(document().selection().faces, leftFaces);
        const UvMatrix after = moved(before, leftFaces, Vec2(0.1, 0.2));
        QVERIFY((document().uv() - after).cwiseAbs().maxCoeff() < 1e-12);
        QCOMPARE(document().undoStack().count(), 1);
        QCOMPARE(document().undoStack().undoText(), UndoText::tr("Move %n islands", nullptr, 1));
        const UvMatrix exact = document().uv();
        document().undoStack().undo();
        QVERIFY(document().uv() == before);
        document().undoStack().redo();
        QVERIFY(document().uv() == exact);
        QVERIFY(!tool().isBusy());
    }

    void pinsTravelAlong()
    {
        pushCommand(
            std::make_unique<EditPins>(document(), EditPins::Edit::Pin,
                                       std::vector<UvPin>{{0, document().uv().row(0).transpose(), true, 1}}));
        use(u"move"_s);
        drag(pixel({0.25, 0.3}), pixel({0.25, 0.3}) + QPoint(20, 0));
        QVERIFY((document().constraints().pin(0)->position - document().uv().row(0).transpose()).norm() <
                1e-12);
        QCOMPARE(document().undoStack().count(), 2);
    }

    void escapeAndRightButtonLeaveNoTrace()
    {
        use(u"move"_s);
        const UvMatrix before = document().uv();
        for (const bool byKey : {true, false}) {
            const QPoint start = pixel({0.25, 0.3});
            QTest::mousePress(&view(), Qt::LeftButton, {}, start);
            mouse(start + QPoint(30, 30), Qt::LeftButton);
            QVERIFY(document().uv() != before);
            QVERIFY(tool().isBusy());
            if (byKey)
                QTest::keyClick(&view(), Qt::Key_Escape);
            else
                QTest::mousePress(&view(), Qt::RightButton, {}, start + QPoint(30, 30));
            QVERIFY(document().uv() == before);
            QCOMPARE(document().undoStack().count(), 0);
            QVERIFY(!document().undoStack().canRedo());
            mouse(start + QPoint(60, 60), Qt::LeftButton);
            if (!byKey)
                QTest::mouseRelease(&view(), Qt::RightButton, {}, start);
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, start + QPoint(60, 60));
            QVERIFY(document().uv() == before);
            QVERIFY(!tool().isBusy());
        }
    }

    void gestureThatReturnsLeavesNoEntry()
    {
        use(u"move"_s);
        const QPoint start = pixel({0.25, 0.3});
        QTest::mousePress(&view(), Qt::LeftButton, {}, start);
        mouse(start + QPoint(30, 30), Qt::LeftButton);
        mouse(start, Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, start);
        QCOMPARE(document().undoStack().count(), 0);
    }

    void keyBeginsWhereTheMouseIs()
    {
        selectFaces(leftFaces);
        const UvMatrix before = document().uv();
        for (const Qt::Key confirm : {Qt::Key_Enter, Qt::Key_Return, Qt::Key_unknown}) {
            mouse({100, 100});
            mStudio->tools.choose(u"move"_s);
            QVERIFY(tool().isBusy());
            mouse({140, 80});
            QVERIFY((document().uv() - moved(before, leftFaces, Vec2(0.2, 0.1))).cwiseAbs().maxCoeff() <
                    1e-12);
            if (confirm == Qt::Key_unknown)
                QTest::mouseClick(&view(), Qt::LeftButton, {}, {140, 80});
            else
                QTest::keyClick(&view(), confirm);
            QVERIFY(!tool().isBusy());
            QCOMPARE(document().selection().faces, leftFaces);
            mouse({200, 200});
            QCOMPARE(document().undoStack().index(), 1);
            document().undoStack().undo();
            QVERIFY(document().uv() == before);
        }
        // Over the other view the key only chooses the tool.
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view(), &leave);
        Canvases::moveMouse(mStudio->mesh, {100, 100});
        mStudio->tools.choose(u"scale"_s);
        QCOMPARE(tool().id(), u"scale"_s);
        QVERIFY(!tool().isBusy());
        // After a dialog the mouse is there again, and has not moved.
        QEvent leaveModel(QEvent::Leave);
        QCoreApplication::sendEvent(&mStudio->mesh, &leaveModel);
        QEnterEvent enter(QPointF(100, 100), QPointF(100, 100), view().mapToGlobal(QPointF(100, 100)));
        QCoreApplication::sendEvent(&view(), &enter);
        mStudio->tools.choose(u"rotate"_s);
        QVERIFY(tool().isBusy());
        tool().cancel();
    }

    void keysOfTheGesture_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("keys");
        QTest::addColumn<QPointF>("corner"); //!< where (0, 0) of the left island goes
        const double texel = 1.0 / 2048;
        QTest::newRow("x") << u"move"_s << u"X"_s << QPointF(0.2, 0);
        QTest::newRow("y") << u"move"_s << u"Y"_s << QPointF(0, 0.1);
        QTest::newRow("x twice") << u"move"_s << u"XX"_s << QPointF(0.2, 0.1);
        QTest::newRow("number") << u"move"_s << u"64"_s << QPointF(64 * texel, 0);
        QTest::newRow("number along y") << u"move"_s << u"-1.5Y"_s << QPointF(0, -1.5 * texel);
        QTest::newRow("mended number") << u"move"_s << u"Y29<8"_s << QPointF(0, 28 * texel);
        QTest::newRow("quarter turn") << u"rotate"_s << u"90"_s << QPointF(0.75, 0.25);
        QTest::newRow("back") << u"rotate"_s << u"-90"_s << QPointF(-0.25, 0.75);
        QTest::newRow("double") << u"scale"_s << u"2"_s << QPointF(-0.25, -0.5);
        QTest::newRow("half of x") << u"scale"_s << u".5X"_s << QPointF(0.125, 0);
        QTest::newRow("not negative") << u"scale"_s << u"-2"_s << QPointF(-0.25, -0.5);
    }

    void keysOfTheGesture()
    {
        QFETCH(QString, id);
        QFETCH(QString, keys);
        QFETCH(QPointF, corner);
        PackingSettings settings = document().packingSettings();
        QCOMPARE(settings.textureSize, 2048);
        selectFaces(leftFaces);
        const UvMatrix before = document().uv();
        mouse({100, 100});
        mStudio->tools.choose(id);
        mouse({140, 80});
        for (const QChar key : keys)
            QTest::keyClick(&view(), key == u'<' ? Qt::Key_Backspace : Qt::Key(key.unicode()));
        QTest::keyClick(&view(), Qt::Key_Return);
        const Vec2 place = document().uv().row(cornerAt(before, {0, 0})).transpose();
        QVERIFY2((place - Vec2(corner.x(), corner.y())).norm() < 1e-9,
                 qPrintable(u"%1, %2"_s.arg(place.x()).arg(place.y())));
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QVERIFY(document().uv() == before);
    }

    void gizmoHoldsTheAxis()
    {
        use(u"move"_s);
        selectFaces(leftFaces);
        const UvMatrix before = document().uv();
        const QPoint handle = pixel({0.25, 0.5}) + QPoint(50, 0);
        drag(handle, handle + QPoint(40, 40));
        QVERIFY((document().uv() - moved(before, leftFaces, Vec2(0.2, 0))).cwiseAbs().maxCoeff() < 1e-12);
        document().undoStack().undo();
        use(u"scale"_s);
        const QPoint up = pixel({0.25, 0.5}) - QPoint(0, 60);
        drag(up, up - QPoint(0, 60));
        const Vec2 place = document().uv().row(cornerAt(before, {0, 0})).transpose();
        QVERIFY((place - Vec2(0, -0.5)).norm() < 1e-9);
        document().undoStack().undo();
        use(u"rotate"_s);
        const QPoint ring = pixel({0.25, 0.5}) + QPoint(64, 0);
        drag(ring, pixel({0.25, 0.5}) + QPoint(-70, 0));
        const Vec2 turned = document().uv().row(cornerAt(before, {0, 0})).transpose();
        QVERIFY((turned - Vec2(0.5, 1)).norm() < 1e-9);
    }

    //! Typed lengths and the panel's are in one unit, which is chosen.
    void typedMovesHaveAUnit()
    {
        selectFaces(leftFaces);
        for (const LengthUnit unit : {LengthUnit::Texels, LengthUnit::Uv}) {
            const UvMatrix before = document().uv();
            ToolSettings tools = mStudio->view.tools();
            tools.unit = unit;
            mStudio->view.setTools(tools);
            mouse(pixel({0.25, 0.5}));
            mStudio->tools.choose(u"move"_s);
            for (const int key : {Qt::Key_Period, Qt::Key_5})
                QTest::keyClick(&view(), static_cast<Qt::Key>(key));
            QVERIFY2(tool().hint().contains(unit == LengthUnit::Texels ? u"texels"_s : u"UV units"_s),
                     qPrintable(tool().hint()));
            QTest::keyClick(&view(), Qt::Key_Return);
            const double way = (document().uv() - before).col(0).maxCoeff();
            QVERIFY(std::abs(way - (unit == LengthUnit::Uv ? 0.5 : 0.5 / 2048)) < 1e-12);
        }
    }

    void snapping_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<QPoint>("way");
        QTest::addColumn<QPointF>("corner");
        const auto row = [](const char *name, const char *id, int modifiers, QPoint way, QPointF corner) {
            QTest::newRow(name) << QString::fromLatin1(id) << modifiers << way << corner;
        };
        const int ctrl = Qt::ControlModifier, shift = Qt::ShiftModifier, alt = Qt::AltModifier;
        row("tiles", "move", ctrl | alt, {130, -20}, {1, 0});
        row("texels", "move", ctrl | shift, {33, -21},
            {std::round(33 / 200.0 * 2048) / 2048, std::round(21 / 200.0 * 2048) / 2048});
        row("corner of an island", "move", shift, {196, -6}, {1, 0});
        row("side of an island", "move", shift, {80, -199}, {0.4, 1});
        row("margin of an island", "move", shift, {80, -204}, {0.4, 1 + 8.0 / 2048});
        row("no island near", "move", shift, {80, -30}, {0.4, 0.15});
        row("quarters", "rotate", ctrl | alt, {-40, 40}, {-0.25, 0.75});
        row("tenths", "scale", ctrl, {0, -21}, {-0.025, -0.05});
    }

    void snapping()
    {
        QFETCH(QString, id);
        QFETCH(int, modifiers);
        QFETCH(QPoint, way);
        QFETCH(QPointF, corner);
        selectFaces(leftFaces);
        const UvMatrix before = document().uv();
        const QPoint pivot = pixel({0.25, 0.5});
        const QPoint start = id == u"scale"_s    ? pivot - QPoint(0, 200)
                             : id == u"rotate"_s ? pivot + QPoint(40, 0)
                                                 : pivot;
        mouse(start);
        mStudio->tools.choose(id);
        mouse(start + way, Qt::NoButton, Qt::KeyboardModifiers(modifiers));
        QTest::keyClick(&view(), Qt::Key_Return);
        const Vec2 place = document().uv().row(cornerAt(before, {0, 0})).transpose();
        QVERIFY2((place - Vec2(corner.x(), corner.y())).norm() < 1e-9,
                 qPrintable(u"%1, %2"_s.arg(place.x()).arg(place.y())));
    }

    void gridSnapping()
    {
        // The drawn lines: one of the sides of the box lands on one.
        MapCamera camera;
        camera.setScale(200);
        const double step = snapStep(SnapTo::Grid, camera, PackingSettings()).x();
        QVERIFY(step > 0 && step <= 0.5);
        const Eigen::AlignedBox2d box(Vec2(0.01, 0.02), Vec2(0.33, 0.74));
        const Vec2 move = snappedMove(Vec2(0.111, 0.222), box, Vec2::Constant(step));
        for (int axis = 0; axis < 2; ++axis) {
            const double low = (box.min() + move)[axis] / step, high = (box.max() + move)[axis] / step;
            QVERIFY(std::abs(low - std::round(low)) < 1e-9 || std::abs(high - std::round(high)) < 1e-9);
            QVERIFY(std::abs(move[axis] - Vec2(0.111, 0.222)[axis]) <= step / 2 + 1e-12);
        }
        QCOMPARE(snappedMove(Vec2(0.1, 0.2), box, Vec2::Zero()), Vec2(0.1, 0.2));
    }

    void lockedIslandsStay()
    {
        pushCommand(
            std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector<int>{0}));
        const UvMatrix before = document().uv();
        selectFaces(leftFaces);
        mouse({100, 100});
        mStudio->tools.choose(u"move"_s);
        QVERIFY(!tool().isBusy());
        QVERIFY(tool().hint().contains(u"locked"_s));
        drag(pixel({0.25, 0.3}), pixel({0.5, 0.6}));
        QVERIFY(document().uv() == before);
        QCOMPARE(document().undoStack().count(), 1);
        // With others only those move.
        QList<int> all;
        for (int face = 0; face < 16; ++face)
            all << face;
        selectFaces(all);
        drag(pixel({0.25, 0.3}), pixel({0.25, 0.3}) + QPoint(20, -40));
        QVERIFY((document().uv() - moved(before, rightFaces, Vec2(0.1, 0.2))).cwiseAbs().maxCoeff() < 1e-12);
        document().undoStack().undo();
        QVERIFY(document().uv() == before);
    }

    void clicksSelect()
    {
        use(u"move"_s);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({0.25, 0.3}));
        QCOMPARE(document().selection().faces, leftFaces);
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel({1.75, 0.3}));
        QCOMPARE(document().selection().faces.size(), 16);
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel({1.75, 0.3}));
        QCOMPARE(document().selection().faces, leftFaces);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel({1, -0.2}));
        QVERIFY(document().selection().isEmpty());
        QCOMPARE(document().undoStack().count(), 0);
        mStudio->lookFromFront();
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, {}, Canvases::middle(mStudio->mesh, 0));
        QCOMPARE(document().selection().faces, leftFaces);
    }

    void solverIsPausedAndGoesOn()
    {
        mStudio->solver.setMode(SolveMode::Manual);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([this] { return mStudio->solver.status().iteration > 2; }, 60'000));
        selectFaces(leftFaces);
        mouse({100, 100});
        mStudio->tools.choose(u"move"_s);
        QVERIFY(tool().isBusy());
        mouse({140, 80});
        QVERIFY(QTest::qWaitFor(
            [this] { return !mStudio->solver.isRunning() && !mStudio->solver.isPausing(); }, 60'000));
        QCoreApplication::processEvents();
        QVERIFY(tool().isBusy());
        QCOMPARE(document().undoStack().undoText().section(u' ', 0, 0), u"Move"_s);
        const UvMatrix there = document().uv();
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(document().uv() != there);
        // The map of the solve, or the one before if nothing was gained.
        QVERIFY(!document().undoStack().undoText().startsWith(u"Move"_s));
        QVERIFY(mStudio->solver.isRunning()); // on from where it was
        // After a gesture that moved something it goes on from there.
        const auto middle = [this] { return mStudio->shown.uv().topRows(3).colwise().mean().eval(); };
        mStudio->tools.choose(u"move"_s);
        QVERIFY(QTest::qWaitFor(
            [this] { return !mStudio->solver.isRunning() && !mStudio->solver.isPausing(); }, 60'000));
        QCoreApplication::processEvents();
        mouse({140, 180});
        const Eigen::RowVector2d moved = middle();
        QTest::keyClick(&view(), Qt::Key_Return);
        QVERIFY(!tool().isBusy());
        QVERIFY(mStudio->solver.isRunning());
        QVERIFY(QTest::qWaitFor([this] { return mStudio->solver.map() != nullptr; }, 60'000));
        QVERIFY((middle() - moved).norm() < 0.2);
        mStudio->solver.pause();
        QVERIFY(QTest::qWaitFor([this] { return !mStudio->solver.isPausing(); }, 60'000));
        // A solve that rested goes on resting.
        mStudio->tools.choose(u"move"_s);
        mouse({150, 150});
        QTest::keyClick(&view(), Qt::Key_Return);
        QVERIFY(!mStudio->solver.isRunning());
    }

    void otherDocumentEndsTheGesture()
    {
        selectFaces(leftFaces);
        mouse({100, 100});
        mStudio->tools.choose(u"move"_s);
        mouse({140, 80});
        mStudio->open(test::layoutDocument(test::grid(4)));
        QVERIFY(!tool().isBusy());
        QCOMPARE(document().undoStack().count(), 0);
        selectFaces(leftFaces);
        mStudio->tools.choose(u"move"_s);
        mouse({140, 90});
        mStudio->workspace.close();
        QVERIFY(!tool().isBusy());
        QVERIFY(!mStudio->uv.picture().isNull());
    }

    void keysOfActionsWaitForTheEnd()
    {
        test::StudioSession session;
        session.context.workspace.open(test::layoutDocument(test::grid(4)), {});
        UvView &map = session.window.uvView();
        Selection selection;
        selection.faces = leftFaces;
        session.document()->setSelection(selection);
        const auto press = [&map](Qt::Key key) {
            QTest::keyClick(&map, key);
            QCoreApplication::processEvents();
        };
        Canvases::moveMouse(map, {100, 100});
        press(Qt::Key_G);
        QCOMPARE(session.window.tools().tool()->id(), u"move"_s);
        QVERIFY(session.action("tool.move")->isChecked());
        QVERIFY(session.window.tools().tool()->isBusy());
        for (const Qt::Key key : {Qt::Key_Space, Qt::Key_P, Qt::Key_A, Qt::Key_R})
            press(key);
        Canvases::moveMouse(map, {140, 100});
        QVERIFY(session.window.tools().tool()->isBusy());
        QVERIFY(!session.context.solver.isRunning() && !session.context.map.jobs().isBusy());
        press(Qt::Key_Return);
        QCOMPARE(session.document()->undoStack().count(), 1);
        press(Qt::Key_R);
        QCOMPARE(session.window.tools().tool()->id(), u"rotate"_s);
        press(Qt::Key_Escape);
        QVERIFY(!session.window.tools().tool()->isBusy());
        QCOMPARE(session.document()->undoStack().count(), 1);
        press(Qt::Key_Q);
        QCOMPARE(session.window.tools().tool()->id(), u"select"_s);
        // Without a selection there is nothing to begin with.
        session.document()->setSelection({});
        press(Qt::Key_S);
        QCOMPARE(session.window.tools().tool()->id(), u"scale"_s);
        QVERIFY(!session.window.tools().tool()->isBusy());
    }

    void gizmoIsDrawn()
    {
        const QImage without = view().picture();
        selectFaces(leftFaces);
        use(u"move"_s);
        const QImage with = view().picture();
        const QColor red = view().content().colors().axes[0];
        const QPointF place = pixel({0.25, 0.5}) + QPoint(40, 0);
        const auto at = [&](const QImage &image) { return image.pixelColor(place.toPoint()); };
        QVERIFY(qAbs(at(with).red() - red.red()) < 40);
        QVERIFY(at(with) != at(without));
    }

private:
    Document &document() { return mStudio->document(); }
    UvView &view() { return mStudio->uv; }
    AbstractTool &tool() { return *mStudio->tools.tool(); }
    void use(const QString &id)
    {
        mStudio->tools.setTool(id);
        QCOMPARE(tool().id(), id);
    }
    QPoint pixel(const Vec2 &uv) { return view().camera().toScreen(uv).toPoint(); }
    void mouse(const QPoint &place, Qt::MouseButtons buttons = Qt::NoButton,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QMouseEvent event(QEvent::MouseMove, place, view().mapToGlobal(place), Qt::NoButton, buttons,
                          modifiers);
        QCoreApplication::sendEvent(&view(), &event);
    }
    void drag(const QPoint &from, const QPoint &to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, {}, from);
        mouse((from + to) / 2, Qt::LeftButton);
        mouse(to, Qt::LeftButton);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    }
    void selectFaces(const QList<int> &faces)
    {
        Selection selection;
        selection.faces = faces;
        document().setSelection(selection);
    }
    UvMatrix moved(UvMatrix uv, const QList<int> &faces, const Vec2 &by)
    {
        for (int face : faces) {
            for (int c = document().mesh().faceStart[face]; c < document().mesh().faceStart[face + 1]; ++c)
                uv.row(c) += by.transpose();
        }
        return uv;
    }
    static int cornerAt(const UvMatrix &uv, const Vec2 &place)
    {
        int row = -1;
        (uv.rowwise() - place.transpose()).rowwise().norm().minCoeff(&row);
        return row;
    }

    const QList<int> leftFaces{0, 1, 4, 5, 8, 9, 12, 13}, rightFaces{2, 3, 6, 7, 10, 11, 14, 15};
    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestIslandTool)

} // namespace tst_islandtool

#include "tst_islandtool.moc"
