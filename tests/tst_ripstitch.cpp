// Ripping and stitching in the real window: by mouse and keys, as one entry each, before and after a live
// solve.
#include "commands/editpins.h"
#include "commands/newmap.h"
#include "commands/replay.h"
#include "commands/setislandflags.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/uvseams.h"
#include "solver/metrics/uvmetrics.h"
#include "support/artist.h"
#include "support/canvases.h"
#include "support/cliruns.h"
#include "support/editsupport.h"

#include <QSignalSpy>

#include <numbers>

namespace tst_ripstitch {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Artist;
using test::Canvases;

namespace {

constexpr int size = 8;

//! The studio on a grid of 8 x 8 quads.
struct GridWindow : Artist
{
    QSignalSpy done{&studio.context.map, &MapController::done};
    QSignalSpy failed{&studio.context.map, &MapController::failed};

    //! \param height of the bulge in its middle
    explicit GridWindow(double height = 0, int islands = 1) : Artist({1400, 900})
    {
        Scene scene = test::sceneOf(test::grid(size, height));
        UvMatrix uv = test::splitLayout(*scene.mesh);
        for (Eigen::Index c = 0; c < uv.rows() && islands == 1; ++c)
            uv.row(c) = scene.mesh->cornerPosition(static_cast<int>(c)).head<2>().transpose();
        scene.uvSets = {{u"UV"_s, 0.4 * uv}};
        studio.context.workspace.open(std::make_unique<Document>(std::move(scene)), {});
        studio.action("view.frameAll")->trigger();
        studio.press(Qt::Key_2);
    }
    //! Edges on the line x = column / 8, in the rows [first, end).
    QList<int> column(int x, int first = 0, int end = size)
    {
        QList<int> edges;
        const MeshAdjacency &adjacency = document().adjacency();
        for (int y = first; y < end; ++y)
            edges << adjacency.edgeOfCorner(document().mesh().faceStart[y * size + x - 1] + 1);
        std::sort(edges.begin(), edges.end());
        return edges;
    }
    void select(const QList<int> &edges)
    {
        Selection selection;
        selection.mode = SelectionMode::Edges;
        selection.edges = edges;
        document().setSelection(selection);
    }
    //! Presses V, with Shift to stitch, and waits.
    bool rip() { return press({}); }
    bool stitch() { return press(Qt::ShiftModifier); }
    int countOpen(const QList<int> &edges)
    {
        const std::vector<bool> open = openCornerPairs(document().mesh(), document().uv());
        return static_cast<int>(
            std::count_if(edges.begin(), edges.end(), [&](int e) { return open[2 * e] || open[2 * e + 1]; }));
    }
    int countInState(const QList<int> &edges, PairState state)
    {
        return static_cast<int>(std::count_if(edges.begin(), edges.end(),
                                              [&](int e) { return document().seams().edgeIs(e, state); }));
    }
    //! One more entry with this text, which can be taken back and done again to the last bit.
    void requireEntry(const QString &text, const DocumentState &before)
    {
        UndoStack &stack = document().undoStack();
        QCOMPARE(stack.undoText(), text);
        const DocumentState after = document().state();
        for (int i = 0; i < 2; ++i) {
            studio.press(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(document().state() == before);
            studio.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(document().state() == after);
        }
        QCOMPARE(document().validate(), QString());
    }
    //! No triangle is flipped and none overlaps another.
    void requireCleanMap()
    {
        QVERIFY(studio.measured());
        QCOMPARE(studio.context.map.figures()->metrics.flipped, 0);
        QCOMPARE(studio.context.map.figures()->metrics.overlapPairs, 0);
    }

private:
    bool press(Qt::KeyboardModifiers modifiers)
    {
        done.clear();
        failed.clear();
        studio.press(Qt::Key_V, modifiers);
        return studio.jobsRest();
    }
};

} // namespace

class TestRipStitch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void edgesAreClickedAndRipped_data()
    {
        QTest::addColumn<bool>("inMap");
        QTest::newRow("in 3D") << false;
        QTest::newRow("in the map") << true;
    }

    void edgesAreClickedAndRipped()
    {
        QFETCH(bool, inMap);
        GridWindow window;
        Canvas &canvas = inMap ? window.map() : window.model();
        const QList<int> slit = window.column(4, 0, 3);
        QVERIFY(!window.studio.action("uv.rip")->isEnabled());
        for (const int edge : slit)
            window.click("", canvas, Canvases::middleOfEdge(canvas, edge), Qt::ShiftModifier);
        QCOMPARE(window.document().selection().edges, slit);
        QVERIFY(window.studio.action("uv.rip")->isEnabled());
        const DocumentState before = window.document().state();
        QVERIFY(window.rip());
        QCOMPARE(window.countOpen(slit), 3);
        QCOMPARE(window.countInState(slit, PairState::Cut), 3);
        QCOMPARE(window.document().islands().count(), 1);
        window.requireEntry(u"Rip 3 edges"_s, before);
        window.requireCleanMap();
    }

    void aCutThroughMakesAnIsland()
    {
        GridWindow window;
        window.select(window.column(5));
        const DocumentState before = window.document().state();
        QVERIFY(window.rip());
        QCOMPARE(window.document().islands().count(), 2);
        QCOMPARE(window.done.last().first().toString(), u"Edges ripped: 8, new islands: 1"_s);
        const Eigen::AlignedBox2d left = window.document().islands().box(0),
                                  right = window.document().islands().box(1);
        QVERIFY(right.min().x() - left.max().x() > 0.003);
        QVERIFY(right.min().x() - left.max().x() < 0.01);
        window.requireEntry(u"Rip 8 edges"_s, before);
        window.requireCleanMap();
        // And back: to where it was.
        const DocumentState ripped = window.document().state();
        QVERIFY(window.stitch());
        QCOMPARE(window.document().islands().count(), 1);
        QCOMPARE(window.countInState(window.column(5), PairState::Free), size);
        QVERIFY((window.document().uv() - before.scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-12);
        window.requireEntry(u"Stitch 8 edges"_s, ripped);
    }

    //! What is a seam already is not counted as ripped, but forced.
    void seamsAreForced()
    {
        GridWindow window;
        window.select(window.column(5));
        QVERIFY(window.rip());
        window.select(window.column(3, 0, 2) + window.column(5));
        const DocumentState before = window.document().state();
        QVERIFY(window.rip());
        QCOMPARE(window.done.last().first().toString(), u"Edges ripped: 2, seams already, forced now: 8"_s);
        window.requireEntry(u"Rip 2 edges"_s, before);
        window.requireCleanMap();
    }

    void facesAreRippedOut()
    {
        GridWindow window;
        Selection selection;
        selection.faces = {27, 28, 35, 36};
        window.document().setSelection(selection);
        const DocumentState before = window.document().state();
        QVERIFY(window.rip());
        QCOMPARE(window.document().islands().count(), 2);
        window.requireEntry(u"Rip 8 edges"_s, before);
        window.requireCleanMap();
    }

    void samplesAreRippedAndStitched_data()
    {
        QTest::addColumn<QString>("sample");
        for (const char *sample : {"machine", "character"})
            QTest::newRow(sample) << QString::fromLatin1(sample);
    }

    //! Loops of edges across whole maps.
    void samplesAreRippedAndStitched()
    {
        QFETCH(QString, sample);
        Artist artist({1400, 900});
        artist.studio.action(qPrintable(u"file.sample."_s + sample))->trigger();
        artist.studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(artist.studio.jobsRest());
        artist.studio.press(Qt::Key_2);
        constexpr int wanted = 4;
        int loops = 0;
        for (const QPoint &place : artist.edgesOn(artist.model(), 4 * wanted)) {
            if (loops == wanted)
                break;
            artist.click("", artist.model(), place);
            artist.studio.press(Qt::Key_L, Qt::ShiftModifier);
            const Document &document = artist.document();
            const QList<int> loop = document.selection().edges;
            const auto countClosed = [&] {
                const std::vector<bool> open = openCornerPairs(document.mesh(), document.uv());
                return std::count_if(loop.begin(), loop.end(), [&](int e) {
                    return e < int(open.size() / 2) && !open[2 * e] && !open[2 * e + 1];
                });
            };
            const auto closed = countClosed();
            if (closed < 2)
                continue; // along a seam
            ++loops;
            const UvMatrix before = document.uv();
            artist.studio.press(Qt::Key_V);
            QVERIFY(artist.studio.jobsRest() && artist.studio.measured());
            QVERIFY(countClosed() < closed);
            QCOMPARE(artist.studio.context.map.figures()->metrics.flipped, 0);
            QCOMPARE(artist.studio.context.map.figures()->metrics.overlapPairs, 0);
            QCOMPARE(artist.undoAndRedo(), QString());
            artist.studio.press(Qt::Key_V, Qt::ShiftModifier);
            QVERIFY(artist.studio.jobsRest() && artist.studio.measured());
            QVERIFY(countClosed() >= closed);
            QCOMPARE(artist.studio.context.map.figures()->metrics.flipped, 0);
            QCOMPARE(artist.studio.context.map.figures()->metrics.overlapPairsSameChart, 0);
            QCOMPARE(artist.undoAndRedo(), QString());
            artist.studio.press(Qt::Key_Z, Qt::ControlModifier);
            artist.studio.press(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(document.uv() == before);
        }
        QCOMPARE(loops, wanted);
    }

    void whatCannotOpenIsSaid()
    {
        GridWindow window;
        window.select(window.column(4, 3, 4));
        const UvMatrix before = window.document().uv();
        QVERIFY(window.rip());
        QVERIFY(window.document().uv() == before);
        QCOMPARE(window.countInState(window.column(4, 3, 4), PairState::Cut), 1);
        QVERIFY(window.done.last().first().toString().contains(u"reach no border"_s));
    }

    void lockedIslandsAreLeft()
    {
        GridWindow window(0, 2);
        Document &document = window.document();
        const auto lock = [&](std::vector<int> islands) {
            pushCommand(std::make_unique<SetIslandFlags>(document, SetIslandFlags::Edit::Lock, islands));
        };
        lock({0});
        const DocumentState before = document.state();
        window.select(window.column(2));
        QVERIFY(window.rip());
        QCOMPARE(window.failed.last().first().toString(), u"The island is locked: unlock it to rip it"_s);
        QVERIFY(test::withoutSelection(document.state()) == test::withoutSelection(before));
        // The locked island stays where it is, and the other one comes.
        window.select(window.column(4));
        QVERIFY(window.stitch());
        QCOMPARE(document.islands().count(), 1);
        for (int c = 0; c < document.mesh().cornerCount(); ++c) {
            const int face = document.adjacency().faceOfCorner(c);
            if (face % size < 4)
                QVERIFY(document.uv().row(c) == before.scene.uvSets[0].uv.row(c));
        }
        window.studio.press(Qt::Key_Z, Qt::ControlModifier);
        lock({1});
        const UvMatrix uv = document.uv();
        QVERIFY(window.stitch());
        QVERIFY(window.failed.last().first().toString().contains(u"both sides are locked or pinned"_s));
        QVERIFY(document.uv() == uv);
    }

    void whatComesToLieOnOthersIsSaid()
    {
        GridWindow window(0, 2);
        Document &document = window.document();
        // The last column becomes an island of its own, where the right half will come to lie.
        UvMatrix uv = document.uv();
        for (int c = 0; c < document.mesh().cornerCount(); ++c) {
            if (document.adjacency().faceOfCorner(c) % size == size - 1)
                uv(c, 0) -= 0.5;
        }
        pushCommand(newMapCommand(document, UvEdit::Solve, uv));
        QCOMPARE(document.islands().count(), 3);
        pushCommand(
            std::make_unique<SetIslandFlags>(document, SetIslandFlags::Edit::Lock, std::vector<int>{0}));
        window.select(window.column(4));
        QVERIFY(window.stitch());
        QCOMPARE(document.islands().count(), 2);
        QVERIFY2(window.failed.last().first().toString().contains(u"overlap that did not before"_s),
                 qPrintable(window.failed.last().first().toString()));
    }

    void pinsFollow()
    {
        GridWindow window;
        Document &document = window.document();
        const int corner = document.mesh().faceStart[size - 1]; // lower right
        const Vec2 place = document.uv().row(corner).transpose();
        pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Pin,
                                               std::vector<UvPin>{{corner, place, false, 1}}));
        window.select(window.column(5));
        QVERIFY(window.rip());
        const Vec2 moved = document.uv().row(corner).transpose();
        QVERIFY(moved.x() > place.x());
        QCOMPARE(document.constraints().pin(corner)->position, moved);
        window.studio.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document.constraints().pin(corner)->position, place);
    }

    void aRefusalChangesNothing()
    {
        // Seven equilateral triangles around a vertex: six of them fill the turn, so that there is no room
        // for the last one.
        GridWindow window;
        std::vector<Vec3> points{{0, 0, 0}};
        std::vector<std::vector<int>> faces;
        for (int i = 0; i < 7; ++i) {
            const double angle = 2 * std::numbers::pi * i / 7;
            points.emplace_back(std::cos(angle), std::sin(angle), i % 2 ? 0.6 : -0.6);
            faces.push_back({0, 1 + i, 1 + (i + 1) % 7});
        }
        Scene scene = test::sceneOf(test::polygonMesh(points, faces));
        UvMatrix uv(21, 2);
        for (int i = 0; i < 7; ++i) {
            const Vec2 middle(i < 6 ? 0.3 : 0.8, 0.3);
            for (int k = 0; k < 2; ++k) {
                const double angle = (i + k) * 0.99 * std::numbers::pi / 3;
                uv.row(3 * i + 1 + k) = (middle + 0.2 * Vec2(std::cos(angle), std::sin(angle))).transpose();
            }
            uv.row(3 * i) = middle.transpose();
        }
        scene.uvSets = {{u"UV"_s, uv}};
        window.studio.context.workspace.open(std::make_unique<Document>(std::move(scene)), {});
        QCOMPARE(window.document().islands().count(), 2);
        window.select({window.document().adjacency().edgeOfCorner(18)});
        const DocumentState before = window.document().state();
        QVERIFY(window.stitch());
        QVERIFY(window.failed.last().first().toString().contains(u"would overlap itself"_s));
        QVERIFY(window.document().state() == before);
        QCOMPARE(window.document().undoStack().count(), 0);
    }

    void nothingToDoIsSaid()
    {
        GridWindow window;
        window.select(window.column(4, 2, 6));
        QVERIFY(window.stitch());
        QCOMPARE(window.failed.last().first().toString(), u"Select seams of the map to stitch"_s);
        window.select({window.document().adjacency().edgeOfCorner(0)}); // on the boundary
        QVERIFY(window.rip());
        QCOMPARE(window.failed.last().first().toString(), u"Select edges between two faces to rip"_s);
        QCOMPARE(window.document().undoStack().count(), 0);
    }

    //! Three strips, the slit in the middle one among the seams.
    void severalSeamsAreOneEntry()
    {
        GridWindow window;
        QList<int> seams = window.column(2) + window.column(4, 3, 6) + window.column(6);
        std::sort(seams.begin(), seams.end());
        window.select(seams);
        QVERIFY(window.rip());
        QCOMPARE(window.document().islands().count(), 3);
        QCOMPARE(window.countOpen(seams), 2 * size + 3);
        const DocumentState before = window.document().state();
        QVERIFY(window.stitch());
        QCOMPARE(window.document().islands().count(), 1);
        QCOMPARE(window.document().undoStack().count(), 2);
        window.requireEntry(u"Stitch 19 edges"_s, before);
        window.requireCleanMap();
    }

    void twiceIsOnce()
    {
        GridWindow window;
        window.select(window.column(4, 0, 3));
        QVERIFY(window.rip());
        QVERIFY(window.rip());
        QCOMPARE(window.document().undoStack().count(), 1);
        QCOMPARE(window.done.last().first().toString(), u"Nothing to do: the edges are cut already"_s);
    }

    void finishingKeepsTheCut()
    {
        GridWindow window;
        const QList<int> slit = window.column(4, 0, 4);
        window.select(slit);
        QVERIFY(window.rip());
        window.studio.press(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(window.studio.jobsRest());
        // In a flat map there is nothing to gain by the cut: the map stays as it is.
        QCOMPARE(window.document().undoStack().undoText(), u"Rip 4 edges"_s);
        QCOMPARE(window.countOpen(slit), 4);
    }

    void sessionsAreReplayed()
    {
        GridWindow window(0.3);
        window.select(window.column(5));
        QVERIFY(window.rip());
        window.select(window.column(2, 3, 6));
        QVERIFY(window.rip());
        window.select(window.column(5, 0, 4));
        QVERIFY(window.stitch());
        QCOMPARE(window.document().undoStack().count(), 3);
        const Journal journal = window.studio.context.workspace.recorder().journal();
        QVERIFY(sameWork(replay(journal).value()->state(), window.document().state()));
        const QString file = window.studio.folder.filePath(u"session.acproj"_s);
        QVERIFY(saveProject(window.document().state(), {journal, {}, {}}, file));
        const test::CliRun run = test::runInProcess({u"replay"_s, file});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out, u"replayed commands: 3\nthe result is what the session holds\n"_s);
    }

    void aRunningSolveIsPausedFirst()
    {
        GridWindow window(0.3);
        window.studio.press(Qt::Key_Space);
        QVERIFY(window.studio.runsTo(3));
        const QList<int> slit = window.column(4, 0, 4);
        window.select(slit);
        QVERIFY(window.rip());
        QVERIFY(!window.studio.context.solver.isRunning());
        // The solve is an entry of its own, where it changed anything.
        QVERIFY(window.document().undoStack().undoText().startsWith(u"Rip"_s));
        QCOMPARE(window.countOpen(slit), 4);
    }

    void solvesGoOnFromTheEditedMap_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<bool>("budget");
        QTest::newRow("bulged") << 0.3 << true;
        QTest::newRow("bulged, by hand") << 0.3 << false;
        QTest::newRow("flat") << 0.0 << true;
        QTest::newRow("flat, by hand") << 0.0 << false;
    }

    void solvesGoOnFromTheEditedMap()
    {
        QFETCH(double, height);
        QFETCH(bool, budget);
        GridWindow window(height, 2);
        SolverController &solver = window.studio.context.solver;
        solver.setMode(budget ? homotopy::SolveMode::Budget : homotopy::SolveMode::Manual);
        const QList<int> seam = window.column(4), slit = window.column(2, 0, 4);
        window.select(seam);
        QVERIFY(window.stitch());
        window.select(slit);
        QVERIFY(window.rip());
        // One step from the edited map.
        const UvMatrix edited = window.document().uv();
        window.studio.press(Qt::Key_Space, Qt::ShiftModifier);
        QVERIFY(window.studio.solverRests());
        QCOMPARE(solver.status().iteration, 1);
        for (const int e : seam)
            QVERIFY(!solver.map()->cut[e]);
        QCOMPARE(window.countOpen(seam), 0);
        QCOMPARE(window.countOpen(slit), 4);
        window.studio.press(Qt::Key_Space);
        QVERIFY(window.studio.runsTo(20));
        solver.pause();
        QVERIFY(window.studio.solverRests());
        // It goes on from the edited map, and makes it no worse.
        const MeshData &mesh = window.document().mesh();
        QVERIFY(metrics::measureUv(mesh, window.document().uv()).symDirichlet <=
                metrics::measureUv(mesh, edited).symDirichlet + 1e-9);
        QCOMPARE(window.countOpen(slit), 4);
        QCOMPARE(window.countInState(slit, PairState::Cut), 4);
    }
};

QTEST_MAIN(TestRipStitch)

} // namespace tst_ripstitch

#include "tst_ripstitch.moc"
