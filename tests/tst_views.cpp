// Both views with real mouse and key events: selecting, hovering, navigating.
#include "model/samples/samples.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "views/canvas/mapoverlays.h"
#include "views/canvas/overlays.h"

#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_views {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

namespace {

//! A grid of 4 x 4 quads, its right half an island of its own.
std::unique_ptr<Document> gridDocument()
{
    return test::layoutDocument(test::grid(4));
}

} // namespace

class TestViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! In a narrow view the legend of the edges that are kept straight lies over the other one, not on it.
    void legendsStayApart_data()
    {
        QTest::addColumn<int>("width");
        QTest::newRow("narrow") << 260;
        QTest::newRow("wide") << 900;
    }
    void legendsStayApart()
    {
        QFETCH(int, width);
        const QTemporaryDir folder;
        const Preferences preferences(folder.filePath(QStringLiteral("autocuts.ini")));
        const ViewColors colors = ViewColors::of(preferences.values(), true);
        ViewOptions options;
        options.coloring = Coloring::SignedStretch;
        QImage image(width, 300, QImage::Format_RGB32);
        image.fill(Qt::darkGreen);
        QPainter painter(&image);
        const QRectF legend = drawLegend(painter, image.rect(), colors, options, false, 1);
        QVERIFY(!legend.isEmpty());
        const QImage before = image.copy();
        drawStraightLegend(painter, image.rect(), colors, legend);
        QVERIFY(image != before);
        QVERIFY(image.copy(legend.toAlignedRect()) == before.copy(legend.toAlignedRect()));
    }

    void init()
    {
        mStudio = std::make_unique<Canvases>();
        mStudio->open(gridDocument());
        mStudio->lookFromFront();
    }
    void cleanup() { mStudio.reset(); }

    void emptyViewsSayWhatToDo()
    {
        Canvases empty;
        const QImage before = empty.mesh.picture();
        QVERIFY(test::countNear(before, empty.mesh.content().colors().text, 30) > 50);
        QTest::mouseClick(&empty.mesh, Qt::LeftButton, {}, {100, 100});
        Canvases::moveMouse(empty.uv, {50, 60});
        QTest::keyClick(&empty.uv, Qt::Key_Home);
        QCOMPARE(empty.view.hover(), Hover());
    }

    void emptyMapsSayWhatRuns()
    {
        Canvases canvases;
        canvases.open(std::make_unique<Document>(makeSample(u"character"_s).value()));
        const QImage before = canvases.uv.picture();
        canvases.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(canvases.map.jobs().isBusy());
        const QImage during = canvases.uv.picture();
        QVERIFY(during != before);
        canvases.map.jobs().cancel();
        QVERIFY(QTest::qWaitFor([&] { return !canvases.map.jobs().isBusy(); }, test::patience));
        canvases.document().undoStack().undo();
        QVERIFY(canvases.uv.picture() != during);
    }

    //! In a narrow view, long lines are broken: nothing touches its border.
    void messagesFitNarrowViews_data()
    {
        QTest::addColumn<int>("width");
        for (const int width : {160, 240, 900})
            QTest::addRow("%d", width) << width;
    }
    void messagesFitNarrowViews()
    {
        QFETCH(int, width);
        QImage picture(width, 300, QImage::Format_RGB32);
        picture.fill(Qt::black);
        ViewColors colors = ViewColors::of({}, true);
        colors.text = colors.dimText = Qt::red;
        QPainter painter(&picture);
        drawMessage(painter, picture.rect(), colors, u"All of the map is hidden"_s,
                    {u"View > Show all hidden brings it back"_s});
        painter.end();
        const auto isRed = [&](int x, int y) { return QColor(picture.pixel(x, y)).red() > 150; };
        int inside = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < width; ++x)
                inside += isRed(x, y);
            QVERIFY(!isRed(1, y) && !isRed(10, y) && !isRed(width - 2, y) && !isRed(width - 11, y));
        }
        QVERIFY(inside > 300);
    }

    void facesAreSelectedInBothViews_data()
    {
        QTest::addColumn<bool>("inMap");
        QTest::newRow("model") << false;
        QTest::newRow("map") << true;
    }

    void facesAreSelectedInBothViews()
    {
        QFETCH(bool, inMap);
        Canvas &canvas = inMap ? static_cast<Canvas &>(mStudio->uv) : mStudio->mesh;
        const auto click = [&](int triangle, Qt::KeyboardModifiers modifiers = {}) {
            QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, Canvases::middle(canvas, triangle));
            return mStudio->document().selection().faces;
        };
        QCOMPARE(click(4), QList<int>({2}));
        QCOMPARE(click(11), QList<int>({5}));
        QCOMPARE(click(1, Qt::ShiftModifier), QList<int>({0, 5}));
        QCOMPARE(click(10, Qt::ShiftModifier), QList<int>({0})); // toggles
        QCOMPARE(click(14, Qt::ControlModifier), QList<int>({0}));
        QCOMPARE(click(0, Qt::ControlModifier), QList<int>());
        QCOMPARE(click(4), QList<int>({2}));
        QTest::mouseClick(&canvas, Qt::LeftButton, Qt::ShiftModifier, {3, 470}); // beside everything
        QCOMPARE(mStudio->document().selection().faces, QList<int>({2}));
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, {3, 470});
        QVERIFY(mStudio->document().selection().isEmpty());
        QVERIFY(mStudio->document().undoStack().count() == 0);
    }

    void verticesOfTheModelAreAllTheirCorners()
    {
        mStudio->select(SelectionMode::Vertices);
        const MeshData &mesh = mStudio->document().mesh();
        // The vertex in the middle, where the islands are apart: four corners on the model, two in the map.
        int soup = 0;
        while (mesh.cornerPosition(mesh.cornerOfSoup(soup)) != Vec3(0.5, 0.5, 0))
            ++soup;
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, {}, Canvases::place(mStudio->mesh, {soup}));
        QCOMPARE(mStudio->document().selection().corners.size(), 4);
        QTest::mouseClick(&mStudio->uv, Qt::LeftButton, {}, Canvases::place(mStudio->uv, {soup}));
        const QList<int> corners = mStudio->document().selection().corners;
        QCOMPARE(corners.size(), 2);
        for (int corner : corners)
            QCOMPARE(mesh.cornerPosition(corner), Vec3(0.5, 0.5, 0));
    }

    void edgesLoopsAndPaths()
    {
        mStudio->select(SelectionMode::Edges);
        const Document &document = mStudio->document();
        const int first = mStudio->edgeBetween({0, 0.25, 0}, {0.25, 0.25, 0});
        const int last = mStudio->edgeBetween({0.75, 0.25, 0}, {1, 0.25, 0});
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, {}, Canvases::middleOfEdge(mStudio->mesh, first));
        QCOMPARE(document.selection().edges, QList<int>({first}));
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, Qt::ControlModifier,
                          Canvases::middleOfEdge(mStudio->mesh, last));
        QList<int> row{first, mStudio->edgeBetween({0.25, 0.25, 0}, {0.5, 0.25, 0}),
                       mStudio->edgeBetween({0.5, 0.25, 0}, {0.75, 0.25, 0}), last};
        std::sort(row.begin(), row.end());
        QCOMPARE(document.selection().edges, row);

        const int upright = mStudio->edgeBetween({0.25, 0.25, 0}, {0.25, 0.5, 0});
        QTest::mouseDClick(&mStudio->mesh, Qt::LeftButton, {},
                           Canvases::middleOfEdge(mStudio->mesh, upright));
        QCOMPARE(document.selection().edges.size(), 4);
        for (int edge : document.selection().edges) {
            for (int vertex : document.adjacency().edgeVertices(edge))
                QCOMPARE(document.mesh().positions(vertex, 0), 0.25);
        }
        QTest::mouseDClick(&mStudio->mesh, Qt::LeftButton, Qt::ShiftModifier,
                           Canvases::middleOfEdge(mStudio->mesh, first));
        QCOMPARE(document.selection().edges.size(), 8);
    }

    void islandsAreSelectedWhole()
    {
        mStudio->select(SelectionMode::Islands);
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, {}, Canvases::middle(mStudio->mesh, 0));
        QCOMPARE(mStudio->document().selection().faces, QList<int>({0, 1, 4, 5, 8, 9, 12, 13}));
        QTest::mouseClick(&mStudio->uv, Qt::LeftButton, Qt::ShiftModifier, Canvases::middle(mStudio->uv, 5));
        QCOMPARE(mStudio->document().selection().faces.size(), 16);
        mStudio->select(SelectionMode::Faces);
        QTest::mouseDClick(&mStudio->uv, Qt::LeftButton, {}, Canvases::middle(mStudio->uv, 5));
        QCOMPARE(mStudio->document().selection().faces, QList<int>({2, 3, 6, 7, 10, 11, 14, 15}));
    }

    void boxesSelect()
    {
        UvView &uv = mStudio->uv;
        // Around the middles of faces 0 and 1, from outside.
        const QPoint from = Canvases::middle(uv, 0) + QPoint(-60, 40),
                     to = Canvases::middle(uv, 3) + QPoint(20, -20);
        const auto drag = [&](Qt::KeyboardModifiers modifiers) {
            QTest::mousePress(&uv, Qt::LeftButton, modifiers, from);
            Canvases::moveMouse(uv, (from + to) / 2, Qt::LeftButton);
            Canvases::moveMouse(uv, to, Qt::LeftButton);
            QVERIFY(mStudio->tools.tool()->isBusy());
            QTest::mouseRelease(&uv, Qt::LeftButton, modifiers, to);
        };
        drag({});
        QCOMPARE(mStudio->document().selection().faces, QList<int>({0, 1}));
        Selection selection = mStudio->document().selection();
        selection.faces = {1, 9};
        mStudio->document().setSelection(selection);
        drag(Qt::ShiftModifier);
        QCOMPARE(mStudio->document().selection().faces, QList<int>({0, 1, 9}));
        drag(Qt::ControlModifier);
        QCOMPARE(mStudio->document().selection().faces, QList<int>({9}));
    }

    void escapeCancelsABox()
    {
        MeshView &mesh = mStudio->mesh;
        QTest::mousePress(&mesh, Qt::LeftButton, {}, {40, 40});
        Canvases::moveMouse(mesh, {300, 300}, Qt::LeftButton);
        QVERIFY(mStudio->tools.tool()->isBusy());
        const QImage busy = mesh.picture();
        QTest::keyClick(&mesh, Qt::Key_Escape);
        QVERIFY(!mStudio->tools.tool()->isBusy());
        QVERIFY(mesh.picture() != busy);
        QTest::mouseRelease(&mesh, Qt::LeftButton, {}, {300, 300});
        QVERIFY(mStudio->document().selection().isEmpty());
    }

    void hoverIsMirrored_data()
    {
        QTest::addColumn<SelectionMode>("mode");
        QTest::newRow("faces") << SelectionMode::Faces;
        QTest::newRow("edges") << SelectionMode::Edges;
        QTest::newRow("vertices") << SelectionMode::Vertices;
    }

    void hoverIsMirrored()
    {
        QFETCH(SelectionMode, mode);
        mStudio->select(mode);
        const int edge = mStudio->edgeBetween({0.25, 0.25, 0}, {0.25, 0.5, 0});
        const int soup = mStudio->mesh.content().topology().edgeSides[edge][0];
        const auto target = [&](const Canvas &canvas) {
            return mode == SelectionMode::Faces   ? Canvases::middle(canvas, 13)
                   : mode == SelectionMode::Edges ? Canvases::middleOfEdge(canvas, edge)
                                                  : Canvases::place(canvas, {soup});
        };
        Canvases::moveMouse(mStudio->mesh, {5, 5});
        QCOMPARE(mStudio->view.hover(), Hover());
        const QImage before = mStudio->uv.picture();
        QSignalSpy spy(&mStudio->view, &ViewState::hoverChanged);
        Canvases::moveMouse(mStudio->mesh, target(mStudio->mesh));
        QCOMPARE(spy.count(), 1);
        Canvases::moveMouse(mStudio->mesh, target(mStudio->mesh) + QPoint(0, 1));
        QVERIFY(spy.count() <= 2); // only when something else is under the mouse
        const Hover hover = mStudio->view.hover();
        if (mode == SelectionMode::Faces)
            QCOMPARE(hover.triangle, 13);
        else if (mode == SelectionMode::Edges)
            QCOMPARE(hover.edge, edge);
        else
            QCOMPARE(
                mStudio->document().mesh().cornerPosition(hover.corner),
                mStudio->document().mesh().cornerPosition(mStudio->document().mesh().cornerOfSoup(soup)));
        // The map changes where the element is, and only there.
        const QImage after = mStudio->uv.picture();
        QRect changed;
        for (int y = 0; y < after.height(); ++y) {
            for (int x = 0; x < after.width(); ++x) {
                if (after.pixel(x, y) != before.pixel(x, y))
                    changed |= QRect(x, y, 1, 1);
            }
        }
        QVERIFY(changed.adjusted(-2, -2, 2, 2).contains(target(mStudio->uv)));
        QVERIFY(changed.width() < 130 && changed.height() < 130);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&mStudio->mesh, &leave);
        QCOMPARE(mStudio->view.hover(), Hover());
        QCOMPARE(mStudio->uv.picture(), before);
    }

    void islandsAreHoveredWhole()
    {
        mStudio->select(SelectionMode::Islands);
        Canvases::moveMouse(mStudio->uv, {5, 5});
        const QImage before = mStudio->mesh.picture();
        Canvases::moveMouse(mStudio->uv, Canvases::middle(mStudio->uv, 0));
        const QImage after = mStudio->mesh.picture();
        for (int triangle = 0; triangle < 32; ++triangle) {
            const QPoint place = Canvases::middle(mStudio->mesh, triangle);
            const bool ofIsland = triangle / 2 % 4 < 2; // the left half
            QCOMPARE(after.pixel(place) != before.pixel(place), ofIsland);
        }
    }

    void mouseAndKeysNavigate()
    {
        MeshView &mesh = mStudio->mesh;
        const auto drag = [](QWidget &widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
            QTest::mousePress(&widget, button, modifiers, {200, 200});
            QMouseEvent move(QEvent::MouseMove, QPointF(240, 210), widget.mapToGlobal(QPointF(240, 210)),
                             Qt::NoButton, button, modifiers);
            QCoreApplication::sendEvent(&widget, &move);
            QTest::mouseRelease(&widget, button, modifiers, {240, 210});
        };
        const OrbitCamera start = mesh.camera();
        drag(mesh, Qt::MiddleButton, {});
        QVERIFY(mesh.camera().yaw() != start.yaw() && mesh.camera().pitch() != start.pitch());
        QCOMPARE(mesh.camera().target(), start.target());
        drag(mesh, Qt::MiddleButton, Qt::ShiftModifier);
        QVERIFY(mesh.camera().target() != start.target());
        drag(mesh, Qt::MiddleButton, Qt::ControlModifier);
        QVERIFY(mesh.camera().distance() < start.distance());
        QTest::keyClick(&mesh, Qt::Key_Home);
        QCOMPARE(mesh.camera().target(), start.target());
        QCOMPARE(mesh.camera().distance(), start.distance());

        PreferenceValues values = mStudio->preferences.values();
        values.navigation = NavigationPreset::Maya;
        mStudio->preferences.setValues(values);
        const double yaw = mesh.camera().yaw();
        drag(mesh, Qt::MiddleButton, {});
        QCOMPARE(mesh.camera().yaw(), yaw);
        drag(mesh, Qt::LeftButton, Qt::AltModifier);
        QVERIFY(mesh.camera().yaw() != yaw);
        QVERIFY(mStudio->document().selection().isEmpty());

        UvView &uv = mStudio->uv;
        const Vec2 centre = uv.camera().centre();
        drag(uv, Qt::MiddleButton, Qt::AltModifier);
        QVERIFY(uv.camera().centre() != centre);
        Selection selection;
        selection.faces = {0};
        mStudio->document().setSelection(selection);
        QTest::keyClick(&uv, Qt::Key_F);
        // In the middle of what the rulers leave free.
        const QPointF middle = QPointF(uv.width() + rulerSize, uv.height() + rulerSize) / 2;
        QVERIFY((uv.camera().toScreen(Vec2(0.125, 0.125)) - middle).manhattanLength() < 1e-6);
        QTest::keyClick(&uv, Qt::Key_A);
        QVERIFY(uv.camera().centre().x() > 0.5);
    }

    void wheelZoomsTheMapToTheMouse()
    {
        UvView &uv = mStudio->uv;
        const QPointF place(120, 333);
        const Vec2 before = uv.camera().toUv(place);
        const double scale = uv.camera().scale();
        QWheelEvent wheel(place, uv.mapToGlobal(place), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&uv, &wheel);
        QVERIFY(uv.camera().scale() > 1.2 * scale);
        QVERIFY((uv.camera().toUv(place) - before).norm() < 1e-12);
    }

    void viewStateComesBack()
    {
        OrbitCamera camera = mStudio->mesh.camera();
        camera.setDirection(1.25, -0.5);
        camera.setDistance(7);
        camera.setTarget({0.1, 0.2, -0.3});
        mStudio->mesh.setCamera(camera);
        MapCamera map = mStudio->uv.camera();
        map.setCentre({3, -2});
        map.setScale(77);
        mStudio->uv.setCamera(map);
        const QCborMap ofMesh = mStudio->mesh.viewState(), ofMap = mStudio->uv.viewState();
        mStudio->open(gridDocument());
        QVERIFY(mStudio->mesh.camera().distance() != 7);
        mStudio->mesh.restoreViewState(ofMesh);
        mStudio->uv.restoreViewState(ofMap);
        QCOMPARE(mStudio->mesh.viewState(), ofMesh);
        QCOMPARE(mStudio->uv.viewState(), ofMap);
        // Damaged states change nothing.
        const QCborMap nonsense{{QStringLiteral("target"), QCborArray{1, 2}},
                                {QStringLiteral("distance"), -1},
                                {QStringLiteral("yaw"), qInf()},
                                {QStringLiteral("centre"), QCborArray{qQNaN(), 0}},
                                {QStringLiteral("scale"), QStringLiteral("x")}};
        mStudio->mesh.restoreViewState(nonsense);
        mStudio->uv.restoreViewState(nonsense);
        mStudio->uv.restoreViewState({});
        QCOMPARE(mStudio->mesh.viewState(), ofMesh);
        QCOMPARE(mStudio->uv.viewState(), ofMap);
    }

    void lostReleasesDoNoHarm()
    {
        MeshView &mesh = mStudio->mesh;
        QTest::mousePress(&mesh, Qt::LeftButton, {}, {40, 40});
        Canvases::moveMouse(mesh, {200, 200}, Qt::LeftButton);
        QVERIFY(mStudio->tools.tool()->isBusy());
        Canvases::moveMouse(mesh, {210, 210}); // no button is held any more
        QVERIFY(!mStudio->tools.tool()->isBusy());
        QTest::mousePress(&mesh, Qt::MiddleButton, {}, {40, 40});
        const double yaw = mesh.camera().yaw();
        Canvases::moveMouse(mesh, {200, 200});
        QCOMPARE(mesh.camera().yaw(), yaw);
        QTest::mouseClick(&mesh, Qt::LeftButton, {}, Canvases::middle(mesh, 4));
        QCOMPARE(mStudio->document().selection().faces, QList<int>({2}));
    }

    void toolsAreSwitched()
    {
        QCOMPARE(mStudio->tools.tool()->id(), QStringLiteral("select"));
        QSignalSpy spy(&mStudio->tools, &ToolManager::toolChanged);
        mStudio->tools.setTool(QStringLiteral("no such tool"));
        QCOMPARE(spy.count(), 0);
        QSignalSpy hints(&mStudio->tools, &ToolManager::hintChanged);
        mStudio->select(SelectionMode::Edges);
        QVERIFY(hints.count() > 0);
        QVERIFY(mStudio->tools.tool()->hint().contains(QStringLiteral("edges")));
    }

private:
    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestViews)

} // namespace tst_views

#include "tst_views.moc"
