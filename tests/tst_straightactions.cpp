// Keep straight, Release and Align to the axes by keys and menus: what they change, undo while a live solve
// runs, locks and Escape.
#include "commands/setislandflags.h"
#include "model/document/straightloops.h"
#include "solver/metrics/uvmetrics.h"
#include "support/editsupport.h"
#include "support/studioparts.h"
#include "views/shell/contextmenu.h"

#include <QMenu>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>

namespace tst_straightactions {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! The studio on a bulged grid in two islands, turned and bent in the map.
struct BentStudio : test::StudioParts
{
    QSignalSpy failed{&map, &MapController::failed};

    BentStudio()
    {
        DocumentState state = test::layoutDocument(test::grid(8, 0.1))->state();
        UvMatrix &uv = state.scene.uvSets.front().uv;
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            const double u = uv(c, 0), v = uv(c, 1) + 0.1 * u * u;
            uv.row(c) << 0.3 * (std::cos(0.3) * u - std::sin(0.3) * v) + 0.2,
                0.3 * (std::sin(0.3) * u + std::cos(0.3) * v);
        }
        workspace.open(std::move(*Document::create(std::move(state)).operator->()), {});
    }

    //! The edges along the line y = 1/4 of the model.
    QList<int> row()
    {
        const MeshData &mesh = document().mesh();
        QList<int> edges;
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            const auto isThere = [&](int end) {
                const int corner = mesh.cornerOfSoup(mesh.edgePairs[e].corner[end][0]);
                return std::abs(mesh.cornerPosition(corner).y() - 0.25) < 1e-9;
            };
            if (!mesh.edgePairs[e].diagonal && isThere(0) && isThere(1))
                edges << static_cast<int>(e);
        }
        return edges;
    }

    void select(SelectionMode mode, const QList<int> &items)
    {
        Selection selection;
        selection.mode = mode;
        (mode == SelectionMode::Edges ? selection.edges : selection.faces) = items;
        document().setSelection(selection);
    }

    qsizetype straightEdges()
    {
        const std::vector<std::uint8_t> &marks = document().seams().straight;
        return std::count(marks.begin(), marks.end(), 1) / 2;
    }

    //! How far the row is from a line along an axis, per island.
    double bendOfRow()
    {
        double bend = 0;
        const MeshData &mesh = document().mesh();
        for (int island = 0; island < document().islands().count(); ++island) {
            Eigen::AlignedBox2d box;
            for (const int face : document().islands().faces(island)) {
                for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
                    if (std::abs(mesh.cornerPosition(c).y() - 0.25) < 1e-9)
                        box.extend(Vec2(document().uv().row(c).transpose()));
                }
            }
            if (!box.isEmpty())
                bend = std::max(bend, box.sizes().minCoeff() / std::max(box.sizes().maxCoeff(), 1e-12));
        }
        return bend;
    }

    bool isValid()
    {
        const metrics::UvMetrics figures = metrics::measureUv(document().mesh(), document().uv());
        return figures.flipped == 0 && figures.overlapPairs == 0 && document().validate().isEmpty();
    }
};

} // namespace

class TestStraightActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void edgesAreKeptStraightAndReleased()
    {
        BentStudio studio;
        QVERIFY(!studio.action("uv.keepStraight")->isEnabled());
        const QList<int> row = studio.row();
        QCOMPARE(row.size(), 8);
        studio.select(SelectionMode::Edges, row);
        QMenu menu;
        fillContextMenu(menu, studio.context);
        QVERIFY(menu.actions().contains(studio.action("uv.keepStraight")));
        QVERIFY(menu.actions().contains(studio.action("uv.releaseStraight")));
        studio.trigger("uv.keepStraight");
        QCOMPARE(studio.straightEdges(), 8);
        QCOMPARE(studio.document().undoStack().undoText(), u"Keep 8 edges straight"_s);
        studio.trigger("uv.keepStraight"); // changes nothing
        QCOMPARE(studio.document().undoStack().count(), 1);
        studio.select(SelectionMode::Edges, {row[0]});
        studio.trigger("uv.releaseStraight");
        QCOMPARE(studio.straightEdges(), 7);
        studio.trigger("edit.undo");
        QCOMPARE(studio.straightEdges(), 8);
        studio.trigger("edit.undo");
        QCOMPARE(studio.straightEdges(), 0);
        studio.trigger("edit.redo");
        studio.trigger("uv.finish");
        QVERIFY(studio.rests());
        QVERIFY(studio.bendOfRow() < 1e-9);
        QVERIFY(studio.isValid());
    }

    void aLiveSolveTakesThemUp()
    {
        BentStudio studio;
        studio.select(SelectionMode::Edges, studio.row());
        studio.trigger("uv.run");
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.isRunning(); }, 10'000));
        const int iteration = studio.solver.status().iteration;
        studio.trigger("uv.keepStraight");
        QTRY_VERIFY(studio.solver.status().iteration != iteration);
        studio.trigger("edit.undo"); // pauses the solve, or takes the mark back
        QVERIFY(studio.document().validate().isEmpty());
        if (studio.straightEdges() == 0)
            studio.trigger("uv.keepStraight");
        if (!studio.solver.isRunning())
            studio.trigger("uv.run");
        const auto rowIsStraight = [&] {
            studio.trigger("uv.run");
            const bool straight = studio.rests() && studio.bendOfRow() < 1e-9;
            studio.trigger("uv.run");
            return straight;
        };
        QVERIFY(QTest::qWaitFor(
            [&] {
                const auto before = studio.solver.map();
                (void)QTest::qWaitFor([&] { return studio.solver.map() != before; }, 1000);
                return rowIsStraight();
            },
            60'000));
        studio.trigger("uv.run");
        QVERIFY(studio.rests());
        QVERIFY(studio.isValid());
    }

    void islandsAreAligned()
    {
        BentStudio studio;
        Document &document = studio.document();
        const auto isAligned = [&](int island) {
            UvMatrix uv = document.uv();
            const MeshData &mesh = document.mesh();
            for (int face = 0; face < mesh.faceCount(); ++face) {
                if (document.islands().islandOfFace(face) == island)
                    continue;
                for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                    uv.row(c).setConstant(std::numeric_limits<double>::quiet_NaN());
            }
            return metrics::measureUv(mesh, uv).axisAlignedShare > 1 - 1e-9;
        };
        studio.select(SelectionMode::Faces, {0});
        const int island = document.islands().islandOfFace(0);
        QVERIFY(!isAligned(island));
        const DocumentState before = document.state();
        studio.trigger("uv.alignAxes");
        QVERIFY(studio.rests());
        QCOMPARE(document.undoStack().undoText(), UndoText::tr("Align %n islands to the axes", nullptr, 1));
        QVERIFY(isAligned(document.islands().islandOfFace(0)));
        QVERIFY(!isAligned(1 - document.islands().islandOfFace(0)));
        QVERIFY(studio.isValid());
        const DocumentState after = document.state();
        studio.trigger("edit.undo");
        QVERIFY(document.state() == before);
        studio.trigger("edit.redo");
        QVERIFY(document.state() == after);
        QCOMPARE(document.undoStack().count(), 1);

        // A second time changes next to nothing, and a locked island stays.
        pushCommand(std::make_unique<SetIslandFlags>(document, SetIslandFlags::Edit::Lock,
                                                     std::vector{document.islands().islandOfFace(0)}));
        studio.trigger("uv.alignAxes");
        QVERIFY(studio.rests());
        QCOMPARE(document.undoStack().count(), 2);
        QCOMPARE(studio.failed.count(), 1);
    }

    void alignCanBeCancelled()
    {
        BentStudio studio;
        studio.select(SelectionMode::Faces, {0});
        const DocumentState before = studio.document().state();
        studio.trigger("uv.alignAxes");
        studio.trigger("uv.cancel");
        QVERIFY(studio.rests());
        QVERIFY(studio.document().state() == before || studio.document().undoStack().count() == 1);
        QVERIFY(studio.isValid());
    }
};

QTEST_MAIN(TestStraightActions)

} // namespace tst_straightactions

#include "tst_straightactions.moc"
