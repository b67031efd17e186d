// The panel of the islands: its table, selection in both directions, marks and texel density.
#include "commands/reset.h"
#include "commands/setislandtag.h"
#include "commands/settexelweights.h"
#include "commands/setuvs.h"
#include "support/editsupport.h"
#include "support/panelbench.h"
#include "views/control/figures/islandfigures.h"
#include "views/panels/islandpanel.h"
#include "views/panels/islandtable.h"

#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

namespace tst_islandpanel {

using namespace autocuts;
using test::child;
using test::click;

namespace {

//! Every face of a grid of n x n quads is an island of its own, the faces to the right larger in the map.
UvMatrix looseLayout(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            const Vec3 p = mesh.cornerPosition(c);
            uv.row(c) << p.x() * (1 + 0.01 * face) + 2 * face, p.y();
        }
    }
    return uv;
}

struct IslandBench : test::PanelBench
{
    IslandPanel panel{context};

    explicit IslandBench(int n = 4, bool loose = false)
    {
        workspace.open(test::layoutDocument(test::grid(n)), {});
        if (loose) {
            pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Move, looseLayout(document().mesh())));
            stack().clear();
        }
        const bool shown = test::showPanel(panel) && test::isUpToDate(panel);
        Q_ASSERT(shown);
        Q_UNUSED(shown);
    }
    QTableView *table() { return child<QTableView>(panel, "islands"); }
    int rowCount() { return table()->model()->rowCount(); }
    QString text(int row, int column) { return table()->model()->index(row, column).data().toString(); }
    bool clickRow(int row, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, modifiers,
                          table()->visualRect(table()->model()->index(row, IslandTable::Faces)).center());
        return test::isUpToDate(panel);
    }
    QList<int> facesOf(int island)
    {
        const std::vector<int> &faces = document().islands().faces(island);
        return {faces.begin(), faces.end()};
    }
    IslandFlags flags(int island) { return document().marks().flagsOf(document().islands().faces(island)); }
    QList<int> selectedRows()
    {
        QList<int> rows;
        for (const QModelIndex &index : table()->selectionModel()->selectedRows())
            rows << index.row();
        std::sort(rows.begin(), rows.end());
        return rows;
    }
};

} // namespace

class TestIslandPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theListSaysWhatToDoWhileItIsEmpty()
    {
        IslandBench bench;
        pushCommand(std::make_unique<Reset>(bench.document(), Reset::Uvs));
        const auto says = [&](const char *part) {
            const auto labels = bench.panel.findChildren<QLabel *>();
            return test::isUpToDate(bench.panel) &&
                   std::any_of(labels.begin(), labels.end(), [&](const QLabel *label) {
                       return label->text().contains(QLatin1StringView(part));
                   });
        };
        QVERIFY(says("No UVs yet"));
        bench.solver.run();
        QVERIFY(says("Pause the solver"));
        QVERIFY(!says("No UVs yet"));
    }

    void aRightClickInTheListOffersWhatFits()
    {
        IslandBench bench;
        QCOMPARE(bench.table()->contextMenuPolicy(), Qt::ActionsContextMenu);
        const QList<QAction *> offered = bench.table()->actions();
        for (const char *id : {"uv.lock", "uv.packSelection", "select.similar"})
            QVERIFY(offered.contains(bench.actions.action(id)));
    }

    void islandsAreListed()
    {
        IslandBench bench;
        QCOMPARE(bench.rowCount(), 2);
        QCOMPARE(bench.text(0, IslandTable::Faces), QStringLiteral("8"));
        QCOMPARE(bench.text(0, IslandTable::Area), QStringLiteral("50.0 %"));
        // The map is as large as the model: one unit is one texture wide.
        QCOMPARE(bench.text(1, IslandTable::Density), QLocale().toString(2048));
        QVERIFY(bench.measured());
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.text(0, IslandTable::Distortion), QStringLiteral("4.000"));
        pushCommand(std::make_unique<SetIslandTag>(bench.document(), QStringLiteral("left"),
                                                   std::vector<int>{0}, true));
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(bench.text(0, IslandTable::Number).contains(QStringLiteral("left")));
        bench.workspace.close();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.rowCount(), 0);
        QVERIFY(!bench.table()->isEnabled());
    }

    void rowsFollowTheMap()
    {
        IslandBench bench;
        pushCommand(
            std::make_unique<SetUvs>(bench.document(), UvEdit::Move, looseLayout(bench.document().mesh())));
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.rowCount(), 16);
        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.rowCount(), 2);
    }

    void rowsSelectFaces()
    {
        IslandBench bench;
        QVERIFY(bench.clickRow(1));
        QCOMPARE(bench.document().selection().faces, bench.facesOf(1));
        QCOMPARE(bench.document().selection().mode, SelectionMode::Islands);
        QVERIFY(bench.clickRow(0, Qt::ControlModifier));
        QCOMPARE(bench.document().selection().faces.size(), 16);
        QCOMPARE(bench.stack().count(), 0); // selecting is no edit
    }

    void facesSelectRows()
    {
        IslandBench bench(4, true);
        bench.document().setSelection({SelectionMode::Faces, {2, 3, 4, 9}, {}, {}});
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.selectedRows(), (QList<int>{2, 3, 4, 9}));
        QCOMPARE(bench.document().selection().faces, (QList<int>{2, 3, 4, 9}));
        QCOMPARE(bench.document().selection().mode, SelectionMode::Faces);
        bench.document().setSelection({});
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(bench.selectedRows().isEmpty());
    }

    void sortedRowsMeanTheirOwnIslands()
    {
        IslandBench bench(4, true);
        QHeaderView *const header = bench.table()->horizontalHeader();
        const auto clickHeader = [&] {
            QTest::mouseClick(
                header->viewport(), Qt::LeftButton, {},
                {header->sectionViewportPosition(IslandTable::Density) + 10, header->height() / 2});
        };
        clickHeader();
        clickHeader();
        const bool rising = bench.table()->model()->index(0, 0).data(IslandTable::sortRole).toInt() == 0;
        if (rising)
            clickHeader();
        // The largest densities first.
        QCOMPARE(bench.table()->model()->index(0, 0).data(IslandTable::sortRole).toInt(), 15);
        QVERIFY(bench.clickRow(0));
        QCOMPARE(bench.document().selection().faces, bench.facesOf(15));
        bench.document().setSelection({SelectionMode::Faces, {0}, {}, {}});
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.selectedRows(), QList<int>{15});
    }

    void locking()
    {
        IslandBench bench;
        QVERIFY(bench.clickRow(1));
        click(bench.panel, "lock");
        QCOMPARE(bench.flags(1).locked, 1);
        QCOMPARE(bench.flags(0).locked, 0);
        QVERIFY(test::isUpToDate(bench.panel));
        click(bench.panel, "unlock");
        QCOMPARE(bench.flags(1).locked, 0);
        QCOMPARE(bench.stack().count(), 2);
        // The check box in the table, of a row that is not selected.
        const QModelIndex lock = bench.table()->model()->index(0, IslandTable::Lock);
        bench.table()->setCurrentIndex(lock);
        bench.table()->setFocus();
        QTest::keyClick(bench.table(), Qt::Key_Space);
        QCOMPARE(bench.flags(0).locked, 1);
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(lock.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(lock.data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
    }

    void stacksAndGroups()
    {
        IslandBench bench;
        QVERIFY(bench.table()->isColumnHidden(IslandTable::Stack)); // nothing is stacked
        QVERIFY(bench.clickRow(0));
        QVERIFY(bench.clickRow(1, Qt::ShiftModifier));
        bench.context.actions.setMet(~0);
        QSignalSpy stacks(bench.context.actions.action("uv.stackCopies"), &QAction::triggered);
        click(bench.panel, "stack");
        QCOMPARE(stacks.count(), 1);
        QCOMPARE(bench.flags(0), IslandFlags()); // islands that are not alike stay as they are
        pushCommand(std::make_unique<SetIslandFlags>(bench.document(), SetIslandFlags::Edit::Stack,
                                                     std::vector<int>{0, 1}));
        click(bench.panel, "group");
        QCOMPARE(bench.flags(0).stack, 1);
        QCOMPARE(bench.flags(1).stack, 1);
        QCOMPARE(bench.flags(1).group, 1);
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.text(0, IslandTable::Stack), QStringLiteral("1"));
        QVERIFY(!bench.table()->isColumnHidden(IslandTable::Stack));
        QCOMPARE(bench.text(1, IslandTable::Group), QStringLiteral("1"));
        click(bench.panel, "unstack");
        click(bench.panel, "ungroup");
        QCOMPARE(bench.flags(0), IslandFlags());
        QCOMPARE(bench.stack().count(), 4);
    }

    void buttonsNeedASelection()
    {
        IslandBench bench;
        for (const char *name : {"lock", "unlock", "stack", "group", "readDensity", "setDensity"})
            QVERIFY2(!child<QPushButton>(bench.panel, name)->isEnabled(), name);
        QVERIFY(bench.clickRow(0));
        QVERIFY(test::isUpToDate(bench.panel));
        for (const char *name : {"lock", "unlock", "stack", "group", "readDensity", "setDensity"})
            QVERIFY2(child<QPushButton>(bench.panel, name)->isEnabled(), name);
    }

    void densityIsReadAndSet()
    {
        IslandBench bench;
        auto *const density = child<QDoubleSpinBox>(bench.panel, "density");
        QVERIFY(bench.clickRow(1));
        QVERIFY(test::isUpToDate(bench.panel));
        click(bench.panel, "readDensity");
        QCOMPARE(density->value(), 2048.0);
        density->setFocus();
        density->selectAll();
        QTest::keyClicks(density, QStringLiteral("1024"));
        const Vec2 centre = bench.document().islands().box(1).center();
        click(bench.panel, "setDensity");
        QCOMPARE(bench.stack().count(), 1);
        const std::vector<IslandFigures> figures = islandFigures(bench.document(), {});
        QCOMPARE(figures[0].texelDensity, 2048.0);
        QVERIFY(std::abs(figures[1].texelDensity - 1024) < 1e-9 * 1024);
        QVERIFY(bench.document().islands().box(1).center().isApprox(centre));
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.text(1, IslandTable::Density), QLocale().toString(1024));
    }

    void paintedIslandsShowWhatTheyHave()
    {
        IslandBench bench;
        QVERIFY(bench.table()->isColumnHidden(IslandTable::Shown)); // would say the same
        pushCommand(SetTexelWeights::uniform(
            bench.document(), IndexRanges::fromSorted(bench.document().islands().faces(1)), 2));
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(!bench.table()->isColumnHidden(IslandTable::Shown));
        QCOMPARE(bench.text(0, IslandTable::Shown), QLocale().toString(2048));
        // The map is as it was: so are its texels per unit. Where the weight is 1 there would be half of
        // them.
        QCOMPARE(bench.text(1, IslandTable::Shown), QLocale().toString(2048));
        QCOMPARE(bench.text(1, IslandTable::Density), QLocale().toString(1024));
        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(bench.table()->isColumnHidden(IslandTable::Shown));
    }

    void lockedIslandsKeepTheirDensity()
    {
        IslandBench bench;
        pushCommand(std::make_unique<SetIslandFlags>(bench.document(), SetIslandFlags::Edit::Lock,
                                                     std::vector<int>{0}));
        const UvMatrix before = bench.document().uv();
        QVERIFY(!setTexelDensity(bench.document(), {0}, 100)->hasAnyChanges());
        QVERIFY(bench.document().uv() == before);
    }

    void onlyIslandsThatChangeAreCounted()
    {
        IslandBench bench;
        using Edit = SetIslandFlags::Edit;
        pushCommand(std::make_unique<SetIslandFlags>(bench.document(), Edit::Lock, std::vector<int>{0}));
        pushCommand(std::make_unique<SetIslandFlags>(bench.document(), Edit::Stack, std::vector<int>{1}));
        pushCommand(
            std::make_unique<SetIslandFlags>(bench.document(), Edit::Unstack, std::vector<int>{0, 1}));
        QCOMPARE(bench.stack().undoText(), UndoText::tr("Unstack %n islands", nullptr, 1));
    }

    void theDensityThatIsShownChangesNothing()
    {
        IslandBench bench;
        const double present = meanTexelDensity(bench.document(), {1});
        const UvMatrix before = bench.document().uv();
        pushCommand(setTexelDensity(bench.document(), {1}, present + 4e-4));
        QVERIFY(bench.document().uv() == before);
        QCOMPARE(bench.stack().count(), 0);
        pushCommand(setTexelDensity(bench.document(), {1}, present + 2e-3));
        QCOMPARE(bench.stack().count(), 1);
    }

    void pinsTravelAlong()
    {
        IslandBench bench;
        const int corner = bench.document().mesh().faceStart[bench.document().islands().faces(1).front()];
        UvPin pin;
        pin.corner = corner;
        pin.position = bench.document().uv().row(corner);
        pushCommand(
            std::make_unique<EditPins>(bench.document(), EditPins::Edit::Pin, std::vector<UvPin>{pin}));
        pushCommand(setTexelDensity(bench.document(), {1}, 512));
        const Vec2 place = bench.document().uv().row(corner);
        QVERIFY(!place.isApprox(pin.position));
        QVERIFY(bench.document().constraints().pin(corner)->position.isApprox(place));
    }

    void thousandsOfIslands()
    {
        IslandBench bench(60, true);
        QCOMPARE(bench.rowCount(), 3600);
        QList<int> all(3600);
        std::iota(all.begin(), all.end(), 0);
        bench.document().setSelection({SelectionMode::Faces, all, {}, {}});
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.table()->selectionModel()->selection().size(), 1); // one range, not 3600
        bench.table()->setFocus();
        QVERIFY(bench.clickRow(2));
        QCOMPARE(bench.document().selection().faces, QList<int>{2});
        QTest::keyClick(bench.table(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(bench.document().selection().faces, all);
    }
};

QTEST_MAIN(TestIslandPanel)

} // namespace tst_islandpanel

#include "tst_islandpanel.moc"
