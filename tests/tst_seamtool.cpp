// Cutting and joining with the mouse, in both views.
#include "commands/changesettings.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "views/tools/seamtool.h"

#include <QTest>

namespace tst_seamtool {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestSeamTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        // One island, so that every edge is in one place of the map.
        Scene scene = test::sceneOf(test::grid(4));
        UvMatrix uv(scene.mesh->cornerCount(), 2);
        for (int c = 0; c < scene.mesh->cornerCount(); ++c)
            uv.row(c) = scene.mesh->cornerPosition(c).head<2>();
        scene.uvSets = {{u"UV"_s, uv}};
        mStudio->open(std::make_unique<Document>(std::move(scene)));
        mStudio->lookFromFront();
        mStudio->tools.setTool(u"cut"_s);
    }
    void cleanup() { mStudio.reset(); }

    void clicksTakeOneEdge_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<bool>("inMap");
        QTest::addColumn<PairState>("state");
        QTest::newRow("cut in 3D") << u"cut"_s << false << PairState::Cut;
        QTest::newRow("cut in the map") << u"cut"_s << true << PairState::Cut;
        QTest::newRow("join in 3D") << u"join"_s << false << PairState::Joined;
        QTest::newRow("join in the map") << u"join"_s << true << PairState::Joined;
    }

    void clicksTakeOneEdge()
    {
        QFETCH(QString, tool);
        QFETCH(bool, inMap);
        QFETCH(PairState, state);
        mStudio->tools.setTool(tool);
        const int edge = across(1, 1);
        click(canvas(inMap), Canvases::middleOfEdge(canvas(inMap), edge));
        QCOMPARE(edgesIn(state), std::vector<int>{edge});
        const Seams after = document().seams();
        undo();
        QCOMPARE(document().seams(), Seams::allFree(document().mesh()));
        document().undoStack().redo();
        QCOMPARE(document().seams(), after);
        // Once more changes nothing; Shift clears it.
        click(canvas(inMap), Canvases::middleOfEdge(canvas(inMap), edge));
        QCOMPARE(document().undoStack().count(), 1);
        click(canvas(inMap), Canvases::middleOfEdge(canvas(inMap), edge), Qt::ShiftModifier);
        QCOMPARE(document().seams(), Seams::allFree(document().mesh()));
        QCOMPARE(document().undoStack().count(), 2);
    }

    void doubleClicksTakeTheLoop_data() { viewRows(); }

    void doubleClicksTakeTheLoop()
    {
        QFETCH(bool, inMap);
        const QPoint place = Canvases::middleOfEdge(canvas(inMap), across(1, 2));
        click(canvas(inMap), place);
        QTest::mouseDClick(&canvas(inMap), Qt::LeftButton, {}, place);
        std::vector<int> row;
        for (int x = 0; x < 4; ++x)
            row.push_back(across(x, 2));
        std::sort(row.begin(), row.end());
        QCOMPARE(edgesIn(PairState::Cut), row);
        QCOMPARE(document().undoStack().count(), 1); // with the click before it
        undo();
        QVERIFY(edgesIn(PairState::Cut).empty());
        document().undoStack().redo();
        QCOMPARE(edgesIn(PairState::Cut), row);
    }

    void ctrlClicksTakeTheWay_data() { viewRows(); }

    void ctrlClicksTakeTheWay()
    {
        QFETCH(bool, inMap);
        Canvas &view = canvas(inMap);
        click(view, Canvases::middleOfEdge(view, across(0, 1)));
        Canvases::moveMouse(view, vertexPlace(view, 3, 1), Qt::NoButton, Qt::ControlModifier);
        const std::vector<int> way = sorted({across(0, 1), across(1, 1), across(2, 1)});
        QCOMPARE(tool().preview(), way);
        click(view, vertexPlace(view, 3, 1), Qt::ControlModifier);
        QCOMPARE(edgesIn(PairState::Cut), way);
        // And on from there.
        click(view, vertexPlace(view, 3, 3), Qt::ControlModifier);
        QCOMPARE(edgesIn(PairState::Cut),
                 sorted({across(0, 1), across(1, 1), across(2, 1), up(3, 1), up(3, 2)}));
        QCOMPARE(document().undoStack().count(), 3);
        undo();
        QCOMPARE(edgesIn(PairState::Cut), way);
    }

    void dragsTakeTheWay_data() { viewRows(); }

    void dragsTakeTheWay()
    {
        QFETCH(bool, inMap);
        Canvas &view = canvas(inMap);
        Canvases::drag(view, {vertexPlace(view, 1, 1), vertexPlace(view, 1, 3)});
        QCOMPARE(edgesIn(PairState::Cut), sorted({up(1, 1), up(1, 2)}));
        QCOMPARE(document().undoStack().count(), 1);
        Canvases::drag(view, {vertexPlace(view, 1, 3), vertexPlace(view, 1, 2)}, Qt::ShiftModifier);
        QCOMPARE(edgesIn(PairState::Cut), std::vector<int>{up(1, 1)});
        undo();
        undo();
        QVERIFY(edgesIn(PairState::Cut).empty());
    }

    void escapeLeavesNoTrace_data() { viewRows(); }

    void escapeLeavesNoTrace()
    {
        QFETCH(bool, inMap);
        Canvas &view = canvas(inMap);
        const DocumentState before = document().state();
        QTest::mousePress(&view, Qt::LeftButton, {}, vertexPlace(view, 1, 1));
        Canvases::moveMouse(view, vertexPlace(view, 1, 3), Qt::LeftButton);
        QVERIFY(tool().isBusy() && tool().preview().size() == 2);
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!tool().isBusy() && tool().preview().empty());
        QTest::mouseRelease(&view, Qt::LeftButton, {}, vertexPlace(view, 1, 3));
        QVERIFY(document().state() == before);
        QCOMPARE(document().undoStack().count(), 0);
    }

    void previewIsDrawnInBothViews()
    {
        const QImage mesh = mStudio->mesh.picture(), map = mStudio->uv.picture();
        Canvases::moveMouse(mStudio->uv, Canvases::middleOfEdge(mStudio->uv, across(2, 2)));
        QCOMPARE(tool().preview(), std::vector<int>{across(2, 2)});
        for (Canvas *view : {&canvas(false), &canvas(true)}) {
            const QImage &before = view == &mStudio->uv ? map : mesh;
            const QPoint place = Canvases::middleOfEdge(*view, across(2, 2));
            const QColor color = view->picture().pixelColor(place);
            QVERIFY(color != before.pixelColor(place));
            QVERIFY(color.blue() > color.red()); // a cut
        }
        QVERIFY(document().undoStack().count() == 0);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&mStudio->uv, &leave);
        QCOMPARE(mStudio->mesh.picture(), mesh);
        QCOMPARE(mStudio->uv.picture(), map);
    }

    void boundariesAndDiagonalsAreNeverTaken()
    {
        click(mStudio->uv, Canvases::middleOfEdge(mStudio->uv, across(1, 0)));
        for (int triangle = 0; triangle < document().mesh().triangleCount(); ++triangle)
            click(mStudio->uv, Canvases::middle(mStudio->uv, triangle));
        // The middles of the quads lie on their diagonals.
        for (int x = 0; x < 4; ++x) {
            for (int y = 0; y < 4; ++y)
                click(mStudio->uv, mStudio->uv.camera().toScreen({(x + 0.5) / 4, (y + 0.5) / 4}).toPoint());
        }
        QCOMPARE(document().undoStack().count(), 0);
        for (int y = 0; y <= 4; ++y)
            Canvases::drag(mStudio->mesh,
                           {vertexPlace(mStudio->mesh, 0, y), vertexPlace(mStudio->mesh, 4, 4 - y)});
        QVERIFY(!edgesIn(PairState::Cut).empty());
        const MeshData &mesh = document().mesh();
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e)
            QVERIFY(!mesh.edgePairs[e].diagonal ||
                    document().seams().edgeIs(static_cast<int>(e), PairState::Free));
        QCOMPARE(document().validate(), QString());
    }

    void clickOutsideDoesNothing()
    {
        click(mStudio->mesh, {3, 3});
        Canvases::drag(mStudio->mesh, {{3, 3}, {40, 12}});
        QTest::mouseDClick(&mStudio->mesh, Qt::LeftButton, {}, {3, 3});
        QCOMPARE(document().undoStack().count(), 0);
        mStudio->workspace.close();
        click(mStudio->mesh, {250, 250});
        Canvases::drag(mStudio->mesh, {{200, 200}, {240, 212}});
    }

    void gainIsToldWhileTheSolverRuns()
    {
        mStudio->open(std::make_unique<Document>(test::sceneOf(test::sphere(12, 16))));
        SolveSettings settings = document().solveSettings();
        settings.lambda = 0.9;
        pushCommand(std::make_unique<ChangeSettings>(document(), settings));
        mStudio->solver.setMode(SolveMode::Manual);
        mStudio->solver.run();
        QTRY_VERIFY_WITH_TIMEOUT(mStudio->solver.status().iteration > 3, test::patience);
        EnergyGain gain;
        QVERIFY(gain.text(mStudio->solver).isEmpty());
        const double before = mStudio->solver.status().energy;
        gain.begin(mStudio->solver);
        const int start = mStudio->solver.status().iteration;
        // The solver goes on from where it is, even when it had come to rest.
        std::vector<int> edges;
        for (int e = 0; e < 100; ++e)
            edges.push_back(e);
        pushCommand(std::make_unique<SetSeamState>(document(), SetSeamState::Edit::Cut,
                                                   cornerPairsOfEdges(document().mesh(), edges)));
        QTRY_VERIFY_WITH_TIMEOUT(mStudio->solver.status().iteration > start, test::patience);
        QVERIFY(mStudio->solver.status().energy < before);
        QVERIFY2(gain.text(mStudio->solver).startsWith(u"Energy saved since the edit"_s),
                 qPrintable(gain.text(mStudio->solver)));
        mStudio->solver.discard();
        QVERIFY(gain.text(mStudio->solver).isEmpty());
    }

private:
    static void viewRows()
    {
        QTest::addColumn<bool>("inMap");
        QTest::newRow("3D") << false;
        QTest::newRow("map") << true;
    }
    Document &document() { return mStudio->document(); }
    void undo() { document().undoStack().undo(); }
    Canvas &canvas(bool inMap)
    {
        return inMap ? static_cast<Canvas &>(mStudio->uv) : static_cast<Canvas &>(mStudio->mesh);
    }
    const SeamTool &tool() { return *qobject_cast<const SeamTool *>(mStudio->tools.tool()); }
    static void click(Canvas &view, const QPoint &place, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&view, Qt::LeftButton, modifiers, place);
    }
    static std::vector<int> sorted(std::vector<int> edges)
    {
        std::sort(edges.begin(), edges.end());
        return edges;
    }
    //! The edge that goes right, or up, from a vertex of the grid.
    int across(int x, int y) { return mStudio->edgeBetween(vertex(x, y), vertex(x + 1, y)); }
    int up(int x, int y) { return mStudio->edgeBetween(vertex(x, y), vertex(x, y + 1)); }
    static Vec3 vertex(int x, int y) { return Vec3(x / 4.0, y / 4.0, 0); }
    QPoint vertexPlace(const Canvas &view, int x, int y)
    {
        const MeshData &mesh = document().mesh();
        for (int s = 0; s < mesh.soupCornerCount(); ++s) {
            if (mesh.cornerPosition(mesh.cornerOfSoup(s)) == vertex(x, y))
                return Canvases::place(view, {s});
        }
        return {};
    }
    //! The edges that have the state at both ends.
    std::vector<int> edgesIn(PairState state)
    {
        std::vector<int> edges;
        for (int e = 0; e < static_cast<int>(document().mesh().edgePairs.size()); ++e) {
            if (document().seams().edgeIs(e, state))
                edges.push_back(e);
        }
        return edges;
    }

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestSeamTool)

} // namespace tst_seamtool

#include "tst_seamtool.moc"
