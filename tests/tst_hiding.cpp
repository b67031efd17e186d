// Hidden faces in both views, by real mouse and key events: drawing, picking, tools, framing.
#include "commands/hidefaces.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "support/studiosession.h"
#include "views/canvas/mappicker.h"
#include "views/canvas/scenecontent.h"

#include <QSignalSpy>
#include <QTest>

#include <numeric>

namespace tst_hiding {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

namespace {

//! Two quads over each other, looked at from the front: face 0 behind, face 1 in front.
std::unique_ptr<Document> twoLayers()
{
    const test::MeshPtr mesh = test::polygonMesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0.3}, {1, 0, 0.3}, {1, 1, 0.3}, {0, 1, 0.3}},
        {{0, 1, 2, 3}, {4, 5, 6, 7}});
    Scene scene = test::sceneOf(mesh);
    UvMatrix uv(8, 2);
    uv << 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1;
    scene.uvSets.push_back({u"first"_s, uv});
    return std::make_unique<Document>(std::move(scene));
}

void hide(Document &document, const QList<int> &faces)
{
    QVERIFY(pushCommand(HideFaces::change(document, faces, true)));
}

} // namespace

class TestHiding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hiddenFacesAreNotDrawn()
    {
        const auto canvases = Canvases::onGrid(4);
        canvases->lookFromFront();
        const QImage mesh = canvases->mesh.picture(), map = canvases->uv.picture();
        hide(canvases->document(), {5, 6});
        const QImage meshWithout = canvases->mesh.picture(), mapWithout = canvases->uv.picture();
        QVERIFY(mesh != meshWithout && map != mapWithout);
        for (const Canvas *canvas :
             {static_cast<const Canvas *>(&canvases->mesh), static_cast<const Canvas *>(&canvases->uv)})
            QVERIFY(!canvas->screenOf(3 * 10)); // triangle 10 is in face 5
        pushCommand(std::make_unique<HideFaces>(canvases->document(), QList<int>()));
        QCOMPARE(canvases->mesh.picture(), mesh);
        QCOMPARE(canvases->uv.picture(), map);
    }

    //! Where nothing is shown, nothing says which faces are meant.
    void jobsOnNothingShownAreRefused()
    {
        const auto canvases = Canvases::onGrid(4);
        const UvMatrix before = canvases->document().uv();
        QList<int> all(canvases->document().mesh().faceCount());
        std::iota(all.begin(), all.end(), 0);
        hide(canvases->document(), all);
        const QSignalSpy failed(&canvases->map, &MapController::failed);
        canvases->map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(!canvases->map.jobs().isBusy());
        canvases->map.finish();
        QVERIFY(!canvases->map.jobs().isBusy());
        QCOMPARE(failed.count(), 2);
        QVERIFY(failed.first().first().toString().contains(u"hidden"_s));
        QVERIFY(canvases->document().uv() == before);
    }

    void clicksReachWhatIsBehind()
    {
        Canvases canvases;
        Document &document = canvases.open(twoLayers());
        canvases.lookFromFront();
        const QPoint middle(250, 250);
        QCOMPARE(document.mesh().triangleFace[canvases.mesh.pick(middle).triangle], 1);
        QTest::mouseClick(&canvases.mesh, Qt::LeftButton, {}, middle);
        QCOMPARE(document.selection().faces, QList<int>{1});
        hide(document, {1});
        QCOMPARE(document.mesh().triangleFace[canvases.mesh.pick(middle).triangle], 0);
        QTest::mouseClick(&canvases.mesh, Qt::LeftButton, {}, middle);
        QCOMPARE(document.selection().faces, QList<int>{0});
        document.undoStack().undo();
        QCOMPARE(document.selection().faces, QList<int>{1});
        QCOMPARE(document.mesh().triangleFace[canvases.mesh.pick(middle).triangle], 1);
        hide(document, {0, 1});
        QCOMPARE(canvases.mesh.pick(middle).triangle, -1);
        QCOMPARE(canvases.mesh.pick(middle).edge, -1);
    }

    void shortestWaysDoNotRunThroughThem()
    {
        const auto canvases = Canvases::onGrid(4);
        canvases->lookFromFront();
        Document &document = canvases->document();
        const int first = canvases->edgeBetween({0, 0.5, 0}, {0.25, 0.5, 0}),
                  last = canvases->edgeBetween({0.75, 0.5, 0}, {1, 0.5, 0});
        const auto way = [&] {
            QTest::mouseClick(&canvases->mesh, Qt::LeftButton, {},
                              Canvases::middleOfEdge(canvases->mesh, first));
            QTest::mouseClick(&canvases->mesh, Qt::LeftButton, Qt::ControlModifier,
                              Canvases::middleOfEdge(canvases->mesh, last));
            return document.selection().edges;
        };
        canvases->select(SelectionMode::Edges);
        QCOMPARE(way().size(), 4); // straight on
        hide(document, {5, 6, 9, 10});
        const QList<int> around = way();
        QCOMPARE(around.size(), 6);
        for (const int edge : around) {
            const auto &faces = document.adjacency().edgeFaces(edge);
            QVERIFY(!document.hidden()[faces[0]] || (faces[1] >= 0 && !document.hidden()[faces[1]]));
        }
        // Without a way around there are only the two that were clicked.
        hide(document, {1, 2, 13, 14});
        QCOMPARE(way(), (QList<int>{std::min(first, last), std::max(first, last)}));
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(way().size(), 4);
    }

    void theMapIsPickedWithoutThem()
    {
        Canvases canvases;
        Document &document = canvases.open(twoLayers());
        const QPointF place = canvases.uv.camera().toScreen(Vec2(0.3, 0.4));
        QCOMPARE(document.mesh().triangleFace[canvases.uv.pick(place).triangle], 1);
        hide(document, {1});
        QCOMPARE(document.mesh().triangleFace[canvases.uv.pick(place).triangle], 0);
    }

    void boxesLeaveThemOut()
    {
        const auto canvases = Canvases::onGrid(4);
        canvases->lookFromFront();
        hide(canvases->document(), {0, 1, 2, 3});
        for (const Canvas *canvas :
             {static_cast<const Canvas *>(&canvases->mesh), static_cast<const Canvas *>(&canvases->uv)}) {
            const BoxPick pick = canvas->pickBox(PickRegion(QRectF(0, 0, 500, 500)));
            QCOMPARE(pick.faces.size(), std::size_t(12));
            QCOMPARE(pick.faces.front(), 4);
            QCOMPARE(pick.corners.size(), std::size_t(48));
            QVERIFY(pick.edges.size() < 40 && pick.edges.size() >= 31);
        }
    }

    void framingIgnoresThem()
    {
        const auto canvases = Canvases::onGrid(4);
        canvases->mesh.frameAll();
        const double whole = canvases->mesh.camera().distance();
        pushCommand(HideFaces::others(canvases->document(), {0}));
        canvases->mesh.frameAll();
        QVERIFY(canvases->mesh.camera().distance() < 0.5 * whole);
    }

    void keysHideIsolateAndShow()
    {
        test::StudioSession studio;
        studio.context.workspace.open(test::gridDocument(), {});
        QApplication::processEvents();
        Document &document = *studio.document(); // faces 1 to 3 are selected
        QVERIFY(!studio.action("view.showAll")->isEnabled());
        studio.press(Qt::Key_H);
        QCOMPARE(document.state().hiddenFaces, QList<int>({1, 2, 3}));
        QVERIFY(document.selection().faces.isEmpty());
        studio.press(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(document.selection().faces.size(), 13);
        studio.press(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(document.selection().faces.isEmpty());
        studio.press(Qt::Key_H, Qt::AltModifier);
        QVERIFY(document.state().hiddenFaces.isEmpty());
        QCOMPARE(document.selection().faces, QList<int>({1, 2, 3})); // as in Blender
        studio.press(Qt::Key_H, Qt::ShiftModifier);
        QCOMPARE(document.state().hiddenFaces.size(), 13);
        QCOMPARE(document.selection().faces, QList<int>({1, 2, 3}));
        studio.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document.state().hiddenFaces.isEmpty());
        QVERIFY(studio.context.view.options().coloring == Coloring::Plain);
        studio.press(Qt::Key_T, Qt::ShiftModifier);
        QVERIFY(studio.context.view.options().coloring == Coloring::SignedStretch);
    }

    //! A job works on the whole map, whatever is hidden meanwhile, and is not begun again.
    void jobsGoOnWithoutThem()
    {
        test::StudioSession studio;
        studio.context.workspace.open(test::layoutDocument(test::grid(4, 0.5)), {});
        Document &document = *studio.document();
        hide(document, {0, 1});
        const UvMatrix before = document.uv();
        studio.context.map.pack(PackScope::All);
        hide(document, {2});
        QVERIFY(studio.jobsRest());
        QVERIFY(!document.uv().row(0).isApprox(before.row(0)));
        QCOMPARE(document.state().hiddenFaces, QList<int>({0, 1, 2}));
        document.undoStack().undo();
        QCOMPARE(document.uv(), before);
        QCOMPARE(document.validate(), QString());
    }

    void aLiveSolveGoesOn()
    {
        test::StudioSession studio;
        studio.context.workspace.open(test::layoutDocument(test::grid(6, 1.0)), {});
        Document &document = *studio.document();
        studio.context.solver.run();
        QVERIFY(studio.context.solver.isRunning());
        studio.press(Qt::Key_A, Qt::ControlModifier);
        hide(document, {0, 7, 14});
        QCOMPARE(document.selection().faces.size(), 33);
        QVERIFY(studio.context.solver.isRunning());
        studio.window.meshView().picture();
        studio.window.uvView().picture();
        studio.press(Qt::Key_Z, Qt::ControlModifier); // pauses first, then takes back what came last
        QVERIFY(studio.solverRests());
        QCOMPARE(document.validate(), QString());
        studio.context.workspace.open(twoLayers(), {});
        QVERIFY(studio.document()->hidden().empty());
        studio.window.meshView().picture();
    }
};

QTEST_MAIN(TestHiding)

} // namespace tst_hiding

#include "tst_hiding.moc"
