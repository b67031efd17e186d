// Selecting the largest region without overlaps and dragging it away.
#include "commands/editpins.h"
#include "commands/setislandflags.h"
#include "solver/metrics/uvmetrics.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "views/control/editing/cleanfaces.h"
#include "views/ui/task.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <numbers>

namespace tst_regiontool {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace autocuts::metrics;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

namespace {

//! A strip of quads around a ring, 32 to a turn; of one and a half turns a third lies twice.
std::unique_ptr<Document> spiral(int count = 48)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2 * std::numbers::pi * i / 32;
        for (double radius : {0.6, 1.0})
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.4 * i / count);
        if (i < count)
            faces.push_back({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
    }
    Scene scene = test::sceneOf(test::polygonMesh(points, faces));
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (int c = 0; c < scene.mesh->cornerCount(); ++c)
        uv.row(c) = 0.2 * scene.mesh->cornerPosition(c).head<2>() + Vec2(0.25, 0.5);
    scene.uvSets = {{u"UV"_s, uv}};
    return std::make_unique<Document>(std::move(scene));
}

} // namespace

class TestRegionTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        mStudio->open(spiral());
        mStudio->tools.setTool(u"region"_s);
    }
    void cleanup() { mStudio.reset(); }

    void clickAndDragRemoveTheOverlaps()
    {
        QVERIFY(overlaps() > 0);
        QCOMPARE(document().islands().count(), 1);
        const DocumentState before = test::withoutSelection(document().state());
        clickFace(20);
        const QList<int> region = document().selection().faces;
        QVERIFY(region.size() >= 30 && region.size() <= 33);
        QVERIFY(region.contains(20));
        QCOMPARE(document().undoStack().count(), 0);
        dragFace(20, {220, -30});
        QCOMPARE(overlaps(), 0);
        QVERIFY(document().islands().count() >= 2);
        QCOMPARE(document().islands().faces(document().islands().islandOfFace(20)).size(),
                 std::size_t(region.size()));
        QCOMPARE(document().undoStack().count(), 1);
        const DocumentState after = test::withoutSelection(document().state());
        document().undoStack().undo();
        QVERIFY(test::withoutSelection(document().state()) == before);
        document().undoStack().redo();
        QVERIFY(test::withoutSelection(document().state()) == after);
        QCOMPARE(document().selection().faces, region);
        QCOMPARE(document().validate(), QString());
    }

    void escapeLeavesNoTrace()
    {
        clickFace(20);
        const DocumentState before = document().state();
        const QPoint start = placeOf(20);
        QTest::mousePress(&mStudio->uv, Qt::LeftButton, {}, start);
        Canvases::moveMouse(mStudio->uv, start + QPoint(50, 20), Qt::LeftButton);
        Canvases::moveMouse(mStudio->uv, start + QPoint(90, 20), Qt::LeftButton);
        QVERIFY(!(document().state() == before));
        QTest::keyClick(&mStudio->uv, Qt::Key_Escape);
        QVERIFY(document().state() == before);
        Canvases::moveMouse(mStudio->uv, start + QPoint(120, 20), Qt::LeftButton);
        QTest::mouseRelease(&mStudio->uv, Qt::LeftButton, {}, start + QPoint(120, 20));
        QVERIFY(document().state() == before);
        QCOMPARE(document().undoStack().count(), 0);
        QVERIFY(!document().undoStack().canRedo());
    }

    void dragsBesideTheSelectionDoNothing()
    {
        const DocumentState before = document().state();
        dragFace(20, {100, 0});
        QVERIFY(document().state() == before);
        clickFace(20);
        clickAt(mStudio->uv, {4, 490});
        QVERIFY(document().selection().isEmpty());
        clickFace(20);
        Canvases::drag(mStudio->mesh, {Canvases::middle(mStudio->mesh, 20), {10, 10}});
        QCOMPARE(document().undoStack().count(), 0);
    }

    void lockedIslandsStayAndPinsTravel()
    {
        const int corner = document().mesh().faceStart[20];
        UvPin pin;
        pin.corner = corner;
        pin.position = document().uv().row(corner);
        pushCommand(std::make_unique<EditPins>(document(), EditPins::Edit::Pin, std::vector{pin}));
        clickFace(20);
        dragFace(20, {220, 0});
        QCOMPARE(document().undoStack().count(), 2);
        QVERIFY((document().constraints().pins[0].position - Vec2(document().uv().row(corner))).norm() <
                1e-12);
        QVERIFY((document().constraints().pins[0].position - pin.position).norm() > 0.1);
        document().undoStack().undo();
        QCOMPARE(document().constraints().pins, std::vector{pin});
        pushCommand(std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector{0}));
        const UvMatrix uv = document().uv();
        clickFace(20);
        dragFace(20, {220, 0});
        QCOMPARE(document().uv(), uv);
    }

    void theModelSelectsToo()
    {
        const QPoint place = Canvases::middle(mStudio->mesh, 90);
        const int triangle = mStudio->mesh.pick(place).triangle;
        QVERIFY(triangle >= 0);
        clickAt(mStudio->mesh, place);
        QVERIFY(document().selection().faces.contains(document().mesh().triangleFace[triangle]));
        QVERIFY(document().selection().faces.size() >= 30);
    }

    void theSolverIsPausedFirst()
    {
        mStudio->solver.setMode(SolveMode::Manual);
        mStudio->solver.run();
        QTRY_VERIFY_WITH_TIMEOUT(mStudio->solver.status().iteration > 2, test::patience);
        QVERIFY(mStudio->shown.isLive());
        mStudio->uv.frameAll();
        clickFace(20);
        QTRY_VERIFY_WITH_TIMEOUT(!mStudio->solver.isRunning() && !mStudio->solver.isPausing(),
                                 test::patience);
        QVERIFY(!mStudio->shown.isLive());
        QVERIFY(!document().selection().faces.isEmpty());
        QVERIFY(document().islands().count() >= 1);
        // It goes on when the region has been moved.
        const UvMatrix before = document().uv();
        mStudio->uv.frameAll();
        dragFace(20, {30, 10});
        QVERIFY(!(document().uv() == before));
        QVERIFY(mStudio->solver.isRunning());
        mStudio->solver.pause();
        QTRY_VERIFY_WITH_TIMEOUT(!mStudio->solver.isPausing(), test::patience);
    }

    //! Three layers do not come apart in two: the tool says so and takes what it can.
    void moreThanTwoLayersAreTold()
    {
        clickFace(20);
        QVERIFY(!mStudio->tools.tool()->hint().contains(u"no single region"_s));
        mStudio->open(spiral(80)); // two and a half turns
        const int before = overlaps();
        clickFace(40);
        QVERIFY(mStudio->tools.tool()->hint().contains(u"no single region"_s));
        dragFace(40, {220, -30});
        QVERIFY(overlaps() < before);
        QVERIFY(overlaps() > 0);
    }

    //! The triangles of a large mesh are not in the order of its faces.
    void facesRiseInLargeMeshes()
    {
        const Document &large = mStudio->open(test::layoutDocument(test::grid(64)));
        const std::vector<int> &order = large.mesh().triangleFace;
        QVERIFY(!std::is_sorted(order.begin(), order.end()));
        const QList<int> faces = cleanPart(MapWithSeams(large, mStudio->shown), 1000).faces;
        QVERIFY(faces.size() > 100);
        QVERIFY(std::adjacent_find(faces.begin(), faces.end(), std::greater_equal<>()) == faces.end());
    }

    void escapeEndsTheSearch()
    {
        QTest::mouseClick(&mStudio->uv, Qt::LeftButton, {}, placeOf(20));
        AbstractTool &tool = *mStudio->tools.tool();
        QVERIFY(tool.isBusy());
        QCOMPARE(mStudio->uv.cursor().shape(), Qt::BusyCursor);
        QTest::keyClick(&mStudio->uv, Qt::Key_Escape);
        QVERIFY(!tool.isBusy());
        QCOMPARE(mStudio->uv.cursor().shape(), Qt::ArrowCursor);
        Task::waitForAll();
        QVERIFY(document().selection().isEmpty());
        clickFace(20);
        QVERIFY(!document().selection().isEmpty());
    }

    void mapsWithoutUvs()
    {
        mStudio->open(std::make_unique<Document>(test::sceneOf(test::grid(4))));
        mStudio->lookFromFront();
        clickAt(mStudio->mesh, Canvases::middle(mStudio->mesh, 3));
        QVERIFY(document().selection().isEmpty());
        Canvases::drag(mStudio->uv, {{200, 200}, {300, 300}});
        QCOMPARE(document().undoStack().count(), 0);
    }

private:
    Document &document() { return mStudio->document(); }
    int overlaps() { return static_cast<int>(measureUv(document().mesh(), document().uv()).overlapPairs); }
    //! The middle of a face in the map.
    QPoint placeOf(int face) { return Canvases::place(mStudio->uv, {6 * face, 6 * face + 1, 6 * face + 2}); }
    //! Clicks and waits for the region.
    void clickAt(Canvas &canvas, const QPoint &place)
    {
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, place);
        QVERIFY(QTest::qWaitFor([this] { return !mStudio->tools.tool()->isBusy(); }, 20'000));
    }
    void clickFace(int face) { clickAt(mStudio->uv, placeOf(face)); }
    void dragFace(int face, const QPoint &way)
    {
        Canvases::drag(mStudio->uv, {placeOf(face), placeOf(face) + way});
    }

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestRegionTool)

} // namespace tst_regiontool

#include "tst_regiontool.moc"
