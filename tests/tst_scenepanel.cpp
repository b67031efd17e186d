// The panel of objects and materials, used with mouse and keyboard.
#include "commands/hidefaces.h"
#include "support/answers.h"
#include "support/editsupport.h"
#include "support/panelbench.h"
#include "views/panels/scenepanel.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTabBar>
#include <QTableView>

namespace tst_scenepanel {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::child;
using test::click;

namespace {

//! grid(4) in two objects, "left" and "right", and two materials, "low" and "high".
std::unique_ptr<Document> partsDocument()
{
    const test::MeshPtr whole = test::grid(4);
    const MeshData &grid = *whole;
    std::vector<int> objects;
    for (int face = 0; face < grid.faceCount(); ++face)
        objects.push_back(face % 4 < 2 ? 0 : 1);
    Scene scene =
        test::sceneOf(MeshData::build(grid.positions, grid.faceStart, grid.cornerVertex, std::move(objects)));
    scene.objectNames = {u"left"_s, u"right"_s};
    scene.materialNames = {u"low"_s, u"high"_s};
    scene.materialColors = {qRgb(10, 20, 30), 0};
    for (int face = 0; face < 16; ++face)
        scene.faceMaterial[static_cast<std::size_t>(face)] = face < 8 ? 0 : 1;
    scene.uvSets.push_back({u"first"_s, test::splitLayout(*scene.mesh)});
    return std::make_unique<Document>(std::move(scene));
}

struct SceneBench : test::PanelBench
{
    test::Answers answers;
    ScenePanel panel{context, answers};

    SceneBench()
    {
        workspace.open(partsDocument(), {});
        const bool shown = test::showPanel(panel) && test::isUpToDate(panel);
        Q_ASSERT(shown);
        Q_UNUSED(shown);
    }
    QTableView *table() { return child<QTableView>(panel, "scene"); }
    QString text(int row, int column) { return table()->model()->index(row, column).data().toString(); }
    bool clickAt(int row, int column, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, modifiers,
                          table()->visualRect(table()->model()->index(row, column)).center());
        return test::isUpToDate(panel);
    }
    bool choose(int tab)
    {
        auto *tabs = child<QTabBar>(panel, "kinds");
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(tab).center());
        return test::isUpToDate(panel);
    }
    QString summary() { return child<QLabel>(panel, "summary")->text(); }
    const QList<int> &hidden() { return document().state().hiddenFaces; }
};

const QList<int> leftFaces{0, 1, 4, 5, 8, 9, 12, 13};
const QList<int> rightFaces{2, 3, 6, 7, 10, 11, 14, 15};

} // namespace

class TestScenePanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void objectsAndMaterialsAreListed()
    {
        SceneBench bench;
        QCOMPARE(bench.table()->model()->rowCount(), 2);
        QCOMPARE(bench.text(0, SceneTable::Name), u"left"_s);
        QCOMPARE(bench.text(1, SceneTable::Faces), u"8"_s);
        QCOMPARE(bench.text(1, SceneTable::Islands), u"1"_s);
        QVERIFY(bench.measured());
        QTRY_COMPARE(bench.text(0, SceneTable::Distortion), u"4.000"_s);
        QVERIFY(bench.choose(1));
        QCOMPARE(bench.text(0, SceneTable::Name), u"low"_s);
        QCOMPARE(bench.text(0, SceneTable::Islands), u"2"_s);
        const auto color = [&](int row) {
            return bench.table()
                ->model()
                ->index(row, SceneTable::Name)
                .data(Qt::DecorationRole)
                .value<QColor>();
        };
        QCOMPARE(color(0), QColor(10, 20, 30));
        QVERIFY(color(1).isValid());
        bench.workspace.open(test::gridDocument(), {});
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(bench.summary().contains(u"no materials"_s));
        bench.workspace.close();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.table()->model()->rowCount(), 0);
    }

    //! Names that differ at their ends only can be told apart.
    void namesAreReadable()
    {
        SceneBench bench;
        QTableView *table = bench.table();
        const auto width = [&] { return table->columnWidth(SceneTable::Name); };
        const auto needed = [&] {
            return static_cast<QAbstractItemView *>(table)->sizeHintForColumn(SceneTable::Name);
        };
        const auto open = [&](const QStringList &names) {
            DocumentState state = partsDocument()->state();
            state.scene.objectNames = {names.begin(), names.end()};
            bench.workspace.open(std::make_unique<Document>(std::move(state.scene)), {});
            return test::isUpToDate(bench.panel);
        };
        const int atFirst = width();
        QVERIFY(open({u"Object_2.027_body"_s, u"Object_2.028_body"_s}));
        QVERIFY(width() > atFirst && width() >= needed());
        // Half of the list stays for the figures; what is left out is the middle.
        const QString longName = u"a_name_that_is_longer_than_any_panel_is_wide_and_ends_with_"_s;
        QVERIFY(open({longName + u'1', longName + u'2'}));
        QVERIFY(width() < needed());
        QCOMPARE(width(), table->viewport()->width() / 2);
        const QModelIndex index = table->model()->index(1, SceneTable::Name);
        QCOMPARE(index.data(Qt::ToolTipRole).toString(), longName + u'2');
        const auto drawn = [&](int row) {
            const QRect cell = table->visualRect(table->model()->index(row, SceneTable::Name));
            return table->viewport()->grab(cell.adjusted(cell.width() / 2, 1, 0, -1)).toImage();
        };
        table->setAlternatingRowColors(false);
        QVERIFY(drawn(0) != drawn(1));
        // A wider panel gives it more, one that is wide enough all.
        const int before = width();
        bench.panel.resize(500, 900);
        QTRY_VERIFY(width() > before);
        bench.panel.resize(1600, 900);
        QTRY_VERIFY(width() >= needed());
        // What the user has chosen stays.
        table->horizontalHeader()->resizeSection(SceneTable::Name, 77);
        bench.panel.resize(700, 900);
        QVERIFY(open({u"one"_s, u"two"_s}));
        QCOMPARE(width(), 77);
    }

    void clicksSelectAndFollowTheSelection()
    {
        SceneBench bench;
        QVERIFY(bench.clickAt(1, SceneTable::Name));
        QCOMPARE(bench.document().selection().faces, rightFaces);
        QVERIFY(bench.clickAt(0, SceneTable::Name, Qt::ControlModifier));
        QCOMPARE(bench.document().selection().faces.size(), 16);
        QVERIFY(bench.clickAt(1, SceneTable::Faces, Qt::ControlModifier));
        QCOMPARE(bench.document().selection().faces, leftFaces);
        Selection part;
        part.faces = leftFaces.mid(1);
        bench.document().setSelection(part);
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(bench.panel.selectedRows().empty());
        part.faces = rightFaces;
        bench.document().setSelection(part);
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.panel.selectedRows(), std::vector<int>{1});
        QVERIFY(bench.stack().count() == 0); // selecting is no edit
    }

    void theKindOfElementStays()
    {
        for (const SelectionMode mode :
             {SelectionMode::Vertices, SelectionMode::Edges, SelectionMode::Islands}) {
            SceneBench bench;
            Selection selection;
            selection.mode = mode;
            bench.document().setSelection(selection);
            QVERIFY(bench.clickAt(0, SceneTable::Name));
            const Selection &now = bench.document().selection();
            QCOMPARE(now.mode, mode);
            QCOMPARE(now.corners.size() > 0, mode == SelectionMode::Vertices);
            QCOMPARE(now.edges.size() > 0, mode == SelectionMode::Edges);
            QCOMPARE(now.faces.size() > 0, mode == SelectionMode::Islands);
            QCOMPARE(bench.panel.selectedRows(), std::vector<int>{0});
        }
    }

    void eyesHideAndShow()
    {
        SceneBench bench;
        QVERIFY(bench.clickAt(1, SceneTable::Name));
        QVERIFY(bench.clickAt(0, SceneTable::Eye));
        QCOMPARE(bench.hidden(), leftFaces);
        QCOMPARE(bench.document().selection().faces, rightFaces); // an eye selects nothing
        QVERIFY(bench.summary().contains(u"hidden: 1"_s));
        QVERIFY(bench.clickAt(1, SceneTable::Eye));
        QCOMPARE(bench.hidden().size(), 16);
        QVERIFY(bench.document().selection().isEmpty());
        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.panel.selectedRows(), std::vector<int>{1});
        QVERIFY(bench.clickAt(0, SceneTable::Eye));
        QVERIFY(bench.hidden().isEmpty());
    }

    void altShowsARowAlone()
    {
        SceneBench bench;
        QVERIFY(bench.clickAt(0, SceneTable::Eye, Qt::AltModifier));
        QCOMPARE(bench.hidden(), rightFaces);
        QVERIFY(bench.clickAt(1, SceneTable::Eye, Qt::AltModifier));
        QCOMPARE(bench.hidden(), leftFaces);
        QVERIFY(bench.clickAt(1, SceneTable::Eye, Qt::AltModifier));
        QVERIFY(bench.hidden().isEmpty());
        QVERIFY(bench.clickAt(1, SceneTable::Name));
        click(bench.panel, "isolate");
        QCOMPARE(bench.hidden(), leftFaces);
        QCOMPARE(bench.document().selection().faces, rightFaces);
    }

    void aPartOfARowMayBeHidden()
    {
        SceneBench bench;
        pushCommand(HideFaces::change(bench.document(), {0, 1}, true));
        QVERIFY(bench.clickAt(0, SceneTable::Name));
        QCOMPARE(bench.document().selection().faces, leftFaces.mid(2));
        QCOMPARE(bench.panel.selectedRows(), std::vector<int>{0});
        QVERIFY(bench.clickAt(0, SceneTable::Eye));
        QCOMPARE(bench.hidden(), leftFaces);
    }

    void theFilterFindsNames()
    {
        SceneBench bench;
        QTest::keyClicks(child<QLineEdit>(bench.panel, "filter"), u"RIG"_s);
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.table()->model()->rowCount(), 1);
        QVERIFY(bench.clickAt(0, SceneTable::Name));
        QCOMPARE(bench.document().selection().faces, rightFaces);
        QTest::keyClicks(child<QLineEdit>(bench.panel, "filter"), u"x"_s);
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(bench.summary().contains(u"such a name"_s));
        QCOMPARE(bench.document().selection().faces, rightFaces); // filtering changes no selection
    }

    void jobsWorkOnRows()
    {
        SceneBench bench;
        Selection edges;
        edges.mode = SelectionMode::Edges;
        bench.document().setSelection(edges);
        QVERIFY(bench.clickAt(1, SceneTable::Name));
        bench.actions.setMet(~0);
        auto *menu = child<QPushButton>(bench.panel, "jobs")->menu();
        Q_EMIT menu->aboutToShow();
        bool asked = false;
        connect(bench.actions.action("uv.packObjects"), &QAction::triggered, this, [&] {
            asked = true;
            QCOMPARE(bench.document().selection().faces, rightFaces);
        });
        for (QAction *action : menu->actions()) {
            if (action->text() == bench.actions.action("uv.packObjects")->text())
                action->trigger();
        }
        QVERIFY(asked);
        bench.map.packEach(SceneKind::Objects);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.map.jobs().isBusy(), test::panelPatience);
        for (int face : rightFaces) {
            const Vec2 uv = bench.document().uv().row(bench.document().mesh().faceStart[face]);
            QVERIFY(uv.x() > 1 && uv.x() < 2);
        }
    }

    void figuresAreSaved()
    {
        SceneBench bench;
        bench.answers.filesToSave = {bench.folder.filePath(u"figures.csv"_s)};
        QVERIFY(bench.clickAt(1, SceneTable::Name));
        auto *menu = child<QPushButton>(bench.panel, "jobs")->menu();
        Q_EMIT menu->aboutToShow();
        for (QAction *action : menu->actions()) {
            if (action->text() == u"Save figures..."_s)
                action->trigger();
        }
        QTRY_VERIFY_WITH_TIMEOUT(!bench.files.jobs().isBusy(), test::panelPatience);
        QFile file(bench.folder.filePath(u"figures.csv"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().split('\n');
        QCOMPARE(lines.size(), 3);
        QVERIFY(lines[1].startsWith("right,8,1,"));
    }
};

QTEST_MAIN(TestScenePanel)

} // namespace tst_scenepanel

#include "tst_scenepanel.moc"
