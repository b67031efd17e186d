// The panels of history, seams, islands, packing, overlaps and view: what they do to the
// document and how they follow it.
#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "model/plain/udimtiles.h"
#include "support/editsupport.h"
#include "support/panelongrid.h"
#include "views/panels/doctorpanel.h"
#include "views/panels/heatlegend.h"
#include "views/panels/historypanel.h"
#include "views/panels/historyview.h"
#include "views/panels/mapoutcome.h"
#include "views/panels/overlappanel.h"
#include "views/panels/packpanel.h"
#include "views/panels/seamcounts.h"
#include "views/panels/seampanel.h"
#include "views/panels/sliderspin.h"
#include "views/panels/viewpanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

namespace tst_panels {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Bench;
using test::child;
using test::click;

namespace {

void type(QWidget *field, const QString &text)
{
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

//! Cuts the first edges of the grid, one entry each.
void cutEdges(Document &document, int count)
{
    for (int edge = 0, done = 0; done < count; ++edge) {
        const IndexRanges pairs = cornerPairsOfEdges(document.mesh(), std::vector<int>{edge});
        done += pushCommand(std::make_unique<SetSeamState>(document, SetSeamState::Edit::Cut, pairs));
    }
}

template <class PanelType>
void checkEmptyState(const char *control)
{
    Bench<PanelType> bench(false);
    auto *const note = child<QLabel>(bench.panel, "emptyNote");
    QVERIFY(note->isVisible());
    QVERIFY(!note->text().isEmpty());
    QVERIFY(!child<QWidget>(bench.panel, control)->isEnabled());
    bench.openGrid();
    QVERIFY(bench.followed());
    QVERIFY(!note->isVisible());
    bench.workspace.close();
    QVERIFY(bench.followed());
    QVERIFY(note->isVisible());
    QVERIFY(!child<QWidget>(bench.panel, control)->isEnabled());
}

} // namespace

class TestPanels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! What is proposed for a map keeps the work of the hand where that can be mended.
    void whatComesNext()
    {
        const auto document = test::layoutDocument(test::grid(2));
        MapFigures figures;
        metrics::UvMetrics &m = figures.metrics;
        m.charts = 1;
        m.symDirichlet = m.tileDirichlet = 5;
        m.chartSymDirichlet.assign(document->islands().count(), 5);
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), "uv.finish"_L1);
        m.flipped = 1;
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), "uv.unwrap"_L1);
        // Packed with the margin that the user wants.
        m.flipped = 0;
        m.symDirichlet = 4;
        m.minGutterTexels = 0.2;
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), "uv.pack"_L1);
        PackingSettings packing = document->packingSettings();
        packing.margin = 0;
        pushCommand(std::make_unique<ChangeSettings>(*document, packing));
        QVERIFY(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction) != "uv.pack"_L1);
        // No packing moves what is pinned.
        m.chartsOffTile = {{0, 1001}};
        figures.islandsOffTile = {{0, 1001}};
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), "uv.pack"_L1);
        const int corner = document->mesh().faceStart[document->islands().faces(0).front()];
        pushCommand(std::make_unique<EditPins>(
            *document, EditPins::Edit::Pin,
            std::vector<UvPin>{{corner, document->uv().row(corner).transpose(), false, 1}}));
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), ""_L1);
        document->undoStack().undo();
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), "uv.pack"_L1);
        using Edit = SetIslandFlags::Edit;
        pushCommand(std::make_unique<SetIslandFlags>(*document, Edit::Lock, std::vector<int>{0}));
        QCOMPARE(QLatin1StringView(outcomeOf(*document, figures, 4.1).nextAction), ""_L1);
    }

    void emptyStates()
    {
        checkEmptyState<HistoryPanel>("history");
        checkEmptyState<SeamPanel>("strength");
        checkEmptyState<PackPanel>("textureSize");
        checkEmptyState<OverlapPanel>("overlaps");
        checkEmptyState<DoctorPanel>("notes");
        checkEmptyState<ViewPanel>("coloring");
    }

    // History.

    void aClickGoesBackInTheHistory()
    {
        Bench<HistoryPanel> bench;
        const DocumentState opened = bench.document().state();
        cutEdges(bench.document(), 5);
        auto *const view = child<HistoryView>(bench.panel, "history");
        QCOMPARE(view->model()->rowCount(), 6);
        const auto clickRow = [view](int row) {
            QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                              view->visualRect(view->model()->index(row, 0)).center());
        };
        clickRow(2);
        QCOMPARE(bench.stack().index(), 2);
        clickRow(0);
        QCOMPARE(bench.stack().index(), 0);
        QVERIFY(test::withoutSelection(bench.document().state()) == test::withoutSelection(opened));
        view->setFocus();
        QTest::keyClick(view, Qt::Key_End);
        QCOMPARE(bench.stack().index(), 5);
    }

    void releasedEntriesCannotBeChosen()
    {
        Bench<HistoryPanel> bench;
        cutEdges(bench.document(), 6);
        bench.stack().setMemoryLimit(0);
        QCOMPARE(bench.stack().releasedCount(), 5);
        QVERIFY(bench.followed());
        auto *const view = child<HistoryView>(bench.panel, "history");
        const auto clickRow = [view](int row) {
            QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                              view->visualRect(view->model()->index(row, 0)).center());
        };
        clickRow(2);
        QCOMPARE(bench.stack().index(), 6);
        QCOMPARE(bench.stack().count(), 6);
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Home);
        QCOMPARE(bench.stack().index(), 5); // as far back as it goes
        QCOMPARE(bench.stack().count(), 6);
        clickRow(6);
        QCOMPARE(bench.stack().index(), 6);
        QVERIFY(!view->grab().isNull());
    }

    void memoryIsShown()
    {
        Bench<HistoryPanel> bench;
        const QString before = bench.text("memory");
        cutEdges(bench.document(), 3);
        QVERIFY(bench.followed());
        QVERIFY(bench.text("memory") != before);
        QVERIFY(bench.text("memory").contains(QLocale().formattedDataSize(bench.stack().memoryUsed())));
    }

    // Seams.

    void itIsChosenWhoseSeams()
    {
        Bench<SeamPanel> bench;
        QVERIFY(bench.followed());
        auto *const mode = child<QComboBox>(bench.panel, "seamMode");
        auto *const map = child<QCheckBox>(bench.panel, "seamMap");
        auto *const angle = child<QDoubleSpinBox>(bench.panel, "sharpAngle");
        const auto settings = [&] { return bench.document().solveSettings(); };
        QCOMPARE(mode->currentText(), QStringLiteral("Free"));
        QVERIFY(!map->isEnabled() && !angle->isEnabled());
        QVERIFY(map->isChecked() && child<QCheckBox>(bench.panel, "seamCuts")->isChecked());
        QCOMPARE(bench.text("givenCount"), QStringLiteral("–"));
        mode->setFocus();
        QTest::keyClick(mode, Qt::Key_Down);
        QCOMPARE(settings().seams, SeamMode::Keep);
        QVERIFY(bench.followed());
        QVERIFY(map->isEnabled() && angle->isEnabled());
        QCOMPARE(bench.text("givenCount"), QStringLiteral("4")); // between the two islands
        cutEdges(bench.document(), 3);                           // one of them is a seam of the map
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("givenCount"), QStringLiteral("6"));
        QTest::mouseClick(map, Qt::LeftButton, {}, {10, map->height() / 2});
        QVERIFY(!settings().givenSeams.map);
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("givenCount"), QStringLiteral("3"));
        for (const char *name : {"seamSharp", "seamHard", "seamMaterials"}) {
            auto *const box = child<QCheckBox>(bench.panel, name);
            box->setFocus();
            QTest::keyClick(box, Qt::Key_Space);
        }
        type(angle, QStringLiteral("12.5"));
        const GivenSeamOptions expected{
            .cuts = true, .map = false, .sharp = true, .hard = true, .materials = true, .sharpAngle = 12.5};
        QVERIFY(settings().givenSeams == expected);
        QCOMPARE(bench.stack().undoText(), QStringLiteral("Change angle of sharp edges"));
        QCOMPARE(bench.stack().count(), 1 + 3 + 1 + 3 + 1);
        while (bench.stack().canUndo())
            bench.stack().undo();
        QVERIFY(settings() == SolveSettings());
        QVERIFY(bench.followed());
        QCOMPARE(mode->currentText(), QStringLiteral("Free"));
        QCOMPARE(angle->value(), 30.0);
        QVERIFY(map->isChecked() && !map->isEnabled());
    }

    void givenSeamsFollowTheMap()
    {
        Bench<SeamPanel> bench;
        SolveSettings settings;
        settings.seams = SeamMode::Only;
        pushCommand(std::make_unique<ChangeSettings>(bench.document(), settings));
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("givenCount"), QStringLiteral("4"));
        UvMatrix uv = bench.document().uv();
        uv.topRows(4).array() += 5; // the first face, in a corner of the grid
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Drag, uv));
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("givenCount"), QStringLiteral("6"));
    }

    void selectedEdgesAreSteered_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<int>("state");
        QTest::newRow("cut") << QStringLiteral("cut") << int(PairState::Cut);
        QTest::newRow("join") << QStringLiteral("join") << int(PairState::Joined);
    }

    void selectedEdgesAreSteered()
    {
        QFETCH(QString, button);
        QFETCH(int, state);
        Bench<SeamPanel> bench;
        QVERIFY(bench.followed());
        QVERIFY(!child<QPushButton>(bench.panel, "cut")->isEnabled());
        bench.select({}, {3, 5});
        QVERIFY(bench.followed());
        click(bench.panel, button.toLatin1().constData());
        QVERIFY(bench.document().seams().edgeIs(3, PairState(state)));
        QVERIFY(bench.document().seams().edgeIs(5, PairState(state)));
        QVERIFY(bench.document().seams().edgeIs(4, PairState::Free));
        QCOMPARE(bench.stack().count(), 1);
        QVERIFY(bench.followed());
        const bool cut = PairState(state) == PairState::Cut;
        QCOMPARE(bench.text("cutCount"), QString::number(cut ? 2 : 0));
        QCOMPARE(bench.text("joinCount"), QString::number(cut ? 0 : 2));
        click(bench.panel, "clear");
        QVERIFY(bench.document().seams().edgeIs(3, PairState::Free));
        bench.stack().undo();
        QVERIFY(bench.followed());
        QCOMPARE(bench.text(cut ? "cutCount" : "joinCount"), QStringLiteral("2"));
        click(bench.panel, "clearAll");
        QVERIFY(bench.document().seams().edgeIs(5, PairState::Free));
        QVERIFY(bench.followed());
        QVERIFY(!child<QPushButton>(bench.panel, "clearAll")->isEnabled());
    }

    void straightEdgesAreKeptAndReleased()
    {
        Bench<SeamPanel> bench;
        QVERIFY(bench.followed());
        const int before = bench.text("straightCount").toInt();
        QVERIFY(!child<QPushButton>(bench.panel, "straight")->isEnabled());
        bench.select({}, {3, 5});
        QVERIFY(bench.followed());
        click(bench.panel, "straight");
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("straightCount").toInt(), before + 2);
        QCOMPARE(bench.document().seams().straight[2 * 5 + 1], std::uint8_t(1));
        bench.select({}, {3});
        QVERIFY(bench.followed());
        click(bench.panel, "release");
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("straightCount").toInt(), before + 1);
        QCOMPARE(bench.stack().count(), 2);
    }

    void halfCutsAreCountedByThemselves()
    {
        Bench<SeamPanel> bench;
        IndexRanges one;
        one.append(6);
        pushCommand(std::make_unique<SetSeamState>(bench.document(), SetSeamState::Edit::Cut, one));
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("cutCount"), QStringLiteral("0"));
        QCOMPARE(bench.text("halfCutCount"), QStringLiteral("1"));
    }

    void selectedFacesArePainted()
    {
        Bench<SeamPanel> bench;
        bench.select({5}, {}); // an inner face: four edges
        QVERIFY(bench.followed());
        auto *const strength = child<SliderSpin>(bench.panel, "strength");
        type(strength->spinBox(), QStringLiteral("100"));
        QCOMPARE(bench.stack().count(), 0);
        click(bench.panel, "keep");
        const std::vector<int> edges = edgesOfFaces(bench.document(), {5});
        QCOMPARE(edges.size(), std::size_t(4));
        for (int edge : edges)
            QCOMPARE(bench.document().seams().weights[2 * edge], 100.0);
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("keepCount"), QStringLiteral("4"));
        click(bench.panel, "attract");
        QCOMPARE(bench.document().seams().weights[2 * edges[0] + 1], 0.0);
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("attractCount"), QStringLiteral("4"));
        click(bench.panel, "erase");
        QCOMPARE(bench.document().seams().weights[2 * edges[0]], unpaintedWeight);
        QCOMPARE(bench.stack().count(), 3);
        bench.stack().undo();
        QVERIFY(bench.followed());
        click(bench.panel, "eraseAll");
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("attractCount"), QStringLiteral("0"));
    }

    void paintGrowsWithTheStrength()
    {
        QCOMPARE(keepTogetherWeight(0.5), 10.0);
        QCOMPARE(attractCutsWeight(0.25), 0.75);
        for (double s = 0.1; s < 1; s += 0.1) {
            QVERIFY(keepTogetherWeight(s) > keepTogetherWeight(s - 0.1));
            QVERIFY(attractCutsWeight(s) < attractCutsWeight(s - 0.1));
        }
    }

    void theSeamLengthOfTheMapIsShown()
    {
        Bench<SeamPanel> bench;
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        // The grid of side 1 is split in the middle by four edges.
        QCOMPARE(bench.text("seamEdges"), QStringLiteral("4"));
        QCOMPARE(bench.text("seamLength"), QStringLiteral("1"));
    }

    // Packing.

    void packingSettings()
    {
        Bench<PackPanel> bench;
        const auto &settings = [&]() -> const PackingSettings & {
            return bench.document().packingSettings();
        };
        auto *const size = child<QComboBox>(bench.panel, "textureSize");
        type(size->lineEdit(), QStringLiteral("3000"));
        QCOMPARE(settings().textureSize, 3000);
        type(size->lineEdit(), QStringLiteral("0"));
        QCOMPARE(settings().textureSize, 3000);
        size->setFocus();
        size->setCurrentIndex(2);
        Q_EMIT size->activated(2);
        QCOMPARE(settings().textureSize, 1024);
        type(child<QAbstractSpinBox>(bench.panel, "margin"), QStringLiteral("16"));
        QCOMPARE(settings().margin, 16);
        QVERIFY(bench.followed());
        QVERIFY(bench.text("marginUv").contains(QStringLiteral("0.0156")));
        type(child<QAbstractSpinBox>(bench.panel, "tile"), QStringLiteral("1012"));
        QCOMPARE(settings().udimTile, 1012);
        auto *const rotation = child<QComboBox>(bench.panel, "rotation");
        rotation->setFocus();
        QTest::keyClick(rotation, Qt::Key_Home);
        QCOMPARE(settings().rotation, PackRotation::None);
        click(bench.panel, "keepScale");
        QVERIFY(settings().keepScale);
        auto *const border = child<QSpinBox>(bench.panel, "border");
        border->setFocus();
        QTest::keyClick(border, Qt::Key_Up);
        QCOMPARE(settings().border, 0.0);
        auto *const effort = child<QDoubleSpinBox>(bench.panel, "effort");
        effort->setFocus();
        QTest::keyClick(effort, Qt::Key_Up);
        QCOMPARE(settings().effort, 1.0);
        QCOMPARE(bench.stack().count(), 8);
        while (bench.stack().canUndo())
            bench.stack().undo();
        QVERIFY(bench.followed());
        QCOMPARE(size->currentText(), QStringLiteral("2048"));
        QVERIFY(!child<QCheckBox>(bench.panel, "keepScale")->isChecked());
        QCOMPARE(rotation->currentData().toInt(), int(PackRotation::Free));
    }

    void escapeTakesBackWhatWasTyped()
    {
        Bench<PackPanel> bench;
        auto *const size = child<QComboBox>(bench.panel, "textureSize");
        const QString before = size->currentText();
        size->setFocus();
        size->lineEdit()->selectAll();
        QTest::keyClicks(size, QStringLiteral("777"));
        QCOMPARE(size->currentText(), QStringLiteral("777"));
        QTest::keyClick(size, Qt::Key_Escape);
        QVERIFY(!size->hasFocus());
        QCOMPARE(size->currentText(), before);
        QCOMPARE(bench.stack().count(), 0);
    }

    void aSmallerTextureTakesTheMarginAlong()
    {
        Bench<PackPanel> bench;
        type(child<QAbstractSpinBox>(bench.panel, "margin"), QStringLiteral("900"));
        type(child<QComboBox>(bench.panel, "textureSize")->lineEdit(), QStringLiteral("64"));
        QCOMPARE(bench.document().packingSettings().textureSize, 64);
        QCOMPARE(bench.document().packingSettings().margin, 64);
    }

    void packing()
    {
        Bench<PackPanel> bench;
        QVERIFY(bench.followed());
        const std::vector<int> tiles = udimTiles(bench.document().mesh(), bench.document().uv(), 1);
        QVERIFY(!child<QPushButton>(bench.panel, "packSelection")->isEnabled());
        click(bench.panel, "pack");
        QVERIFY(bench.map.jobs().isBusy());
        QVERIFY(bench.followed());
        QVERIFY(!child<QPushButton>(bench.panel, "pack")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.map.jobs().isBusy(), test::panelPatience);
        QCOMPARE(bench.stack().count(), 1);
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        QCOMPARE(udimTiles(bench.document().mesh(), bench.document().uv(), 1), tiles);
        const double gutter = bench.map.figures()->metrics.minGutterTexels;
        QVERIFY(gutter >= 8);
        QVERIFY(bench.text("gutter").startsWith(QLocale().toString(gutter, 'f', 1)));
        // Of the tiles in use, which are listed.
        QVERIFY(bench.text("efficiency").contains(QLatin1Char('%')));
        const auto *list = child<QTreeWidget>(bench.panel, "tiles");
        const std::vector<metrics::TileFigures> &figures = bench.map.figures()->metrics.tiles;
        QVERIFY(list->isVisible() && figures.size() > 1);
        QCOMPARE(list->topLevelItemCount(), int(figures.size()));
        QCOMPARE(list->topLevelItem(1)->text(0), QString::number(figures[1].tile));
        QCOMPARE(list->topLevelItem(1)->text(1), QString::number(figures[1].charts));
        QCOMPARE(list->topLevelItem(1)->text(3),
                 QLocale().toString(figures[1].density * bench.map.figures()->textureSize, 'g', 4));
    }

    // Overlaps.

    void overlapsAreListedAndShown()
    {
        Bench<OverlapPanel> bench;
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        auto *const list = child<QListView>(bench.panel, "overlaps");
        QCOMPARE(bench.text("pairs"), QStringLiteral("0"));
        QCOMPARE(list->model()->rowCount(), 0);
        QVERIFY(!child<QPushButton>(bench.panel, "next")->isEnabled());

        // The right island moves half a face over the left one.
        UvMatrix uv = bench.document().uv();
        for (Eigen::Index row = 0; row < uv.rows(); ++row)
            uv(row, 0) -= uv(row, 0) >= 1.25 ? 1.375 : 0;
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Move, uv));
        QVERIFY(bench.followed());
        QVERIFY(!child<QLabel>(bench.panel, "pairs")->isEnabled()); // of the map before
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        QVERIFY(child<QLabel>(bench.panel, "pairs")->isEnabled());
        QCOMPARE(bench.text("pairs"), QString::number(bench.map.figures()->metrics.overlapPairs));
        QVERIFY(list->model()->rowCount() > 0);

        QSignalSpy frames(&bench.panel, &OverlapPanel::frameSelectionRequested);
        click(bench.panel, "next");
        QCOMPARE(frames.count(), 1);
        const auto pair = bench.map.figures()->overlapPairs.front();
        const MeshData &mesh = bench.document().mesh();
        QList<int> expected{mesh.triangleFace[pair[0]], mesh.triangleFace[pair[1]]};
        std::sort(expected.begin(), expected.end());
        QCOMPARE(bench.document().selection().faces, expected);
        click(bench.panel, "previous"); // around to the last
        QCOMPARE(list->currentIndex().row(), list->model()->rowCount() - 1);
        QCOMPARE(frames.count(), 2);
        bench.actions.setMet(NeedsOverlaps);
        bench.actions.action("select.nextOverlap")->trigger(); // from the menu
        QCOMPARE(list->currentIndex().row(), 0);
        bench.actions.action("select.previousOverlap")->trigger();
        QCOMPARE(list->currentIndex().row(), list->model()->rowCount() - 1);
        QCOMPARE(frames.count(), 4);

        click(bench.panel, "separate");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.map.jobs().isBusy(), test::panelPatience);
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        QCOMPARE(bench.text("pairs"), QStringLiteral("0"));
        QCOMPARE(list->model()->rowCount(), 0);
    }

    void flippedFacesAreSelected()
    {
        Bench<OverlapPanel> bench;
        UvMatrix uv = bench.document().uv();
        const MeshData &mesh = bench.document().mesh();
        // Mirror one corner of face 0, at the border of the grid, through the middle of the face.
        const int corner = mesh.faceStart[0];
        uv.row(corner) = 2 * uv.row(corner + 2) - uv.row(corner);
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Drag, uv));
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        QVERIFY(bench.map.figures()->metrics.flipped > 0);
        QCOMPARE(bench.text("flipped"), QString::number(bench.map.figures()->metrics.flipped));
        click(bench.panel, "selectFlipped");
        QVERIFY(bench.document().selection().faces.contains(0));
    }

    // View.

    void viewOptionsFollowBothWays()
    {
        Bench<ViewPanel> bench;
        auto *const coloring = child<QComboBox>(bench.panel, "coloring");
        coloring->setFocus();
        QTest::keyClick(coloring, Qt::Key_Down);
        QTest::keyClick(coloring, Qt::Key_Down);
        QCOMPARE(bench.view.options().coloring, Coloring::SignedStretch);
        QVERIFY(bench.followed());
        QVERIFY(child<QWidget>(bench.panel, "stretchClamp")->isVisible());
        QVERIFY(!child<QWidget>(bench.panel, "magnitudeClamp")->isVisible());
        QVERIFY(child<QWidget>(bench.panel, "legend")->isVisible());
        type(child<SliderSpin>(bench.panel, "stretchClamp")->spinBox(), QStringLiteral("2"));
        QCOMPARE(bench.view.options().stretchClamp, 2.0);
        QVERIFY(bench.followed());
        QVERIFY(child<HeatLegend>(bench.panel, "legend")->labels()[2].startsWith(QLatin1Char('4')));

        ViewOptions options = bench.view.options();
        options.coloring = Coloring::StretchMagnitude;
        options.magnitudeClamp = 12;
        options.pattern = Pattern::Checker;
        bench.view.setOptions(options);
        QVERIFY(bench.followed());
        QCOMPARE(coloring->currentData().toInt(), int(Coloring::StretchMagnitude));
        QCOMPARE(child<SliderSpin>(bench.panel, "magnitudeClamp")->value(), 12.0);
        type(child<QAbstractSpinBox>(bench.panel, "checkerSize"), QStringLiteral("40"));
        QCOMPARE(bench.view.options().checkerSize, 40.0);
        QCOMPARE(bench.stack().count(), 0); // how it is shown is no edit
    }

    void aTextureIsAskedForBeforeItIsShown()
    {
        Bench<ViewPanel> bench;
        QSignalSpy asked(bench.actions.action("view.loadTexture"), &QAction::triggered);
        auto *const pattern = child<QComboBox>(bench.panel, "pattern");
        pattern->setFocus();
        QTest::keyClick(pattern, Qt::Key_End);
        QCOMPARE(asked.count(), 1);
        QCOMPARE(bench.view.options().pattern, Pattern::None);
        QVERIFY(bench.followed());
        QCOMPARE(pattern->currentData().toInt(), int(Pattern::None));
    }
};

QTEST_MAIN(TestPanels)

} // namespace tst_panels

#include "tst_panels.moc"
