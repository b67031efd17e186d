// The status bar: hint, messages, selection, figures, jobs, and what happens when there is little room.
#include "commands/changesettings.h"
#include "commands/edituvsets.h"
#include "model/samples/samples.h"
#include "support/editsupport.h"
#include "support/panelbench.h"
#include "views/panels/elidedlabel.h"
#include "views/panels/figurestrip.h"
#include "views/shell/statusbar.h"
#include "views/ui/numbertext.h"

#include <QProgressBar>
#include <QSignalSpy>
#include <QToolButton>

namespace tst_statusbar {

using namespace autocuts;
using namespace autocuts::homotopy;
using test::child;

namespace {

struct BarBench : test::PanelBench
{
    StatusBar bar{context};

    explicit BarBench(int width = 1280)
    {
        const bool shown = test::showPanel(bar, width, 24);
        Q_ASSERT(shown);
        Q_UNUSED(shown);
    }
    void open() { workspace.open(test::layoutDocument(test::grid(4)), {}); }
    void openSample()
    {
        workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("bumpycube")).value()), {});
    }
};

} // namespace

class TestStatusBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aMessageGivesWayToTheHint()
    {
        BarBench bench;
        bench.bar.setHint(QStringLiteral("Click a face"));
        QCOMPARE(bench.bar.shownText(), QStringLiteral("Click a face"));
        bench.bar.showText(QStringLiteral("Saved"), 50);
        QCOMPARE(bench.bar.shownText(), QStringLiteral("Saved"));
        bench.bar.setHint(QStringLiteral("Drag"));
        QCOMPARE(bench.bar.shownText(), QStringLiteral("Saved"));
        QTRY_COMPARE(bench.bar.shownText(), QStringLiteral("Drag"));
    }

    void aLongMessageGetsTheRoomOfTheSelection()
    {
        BarBench bench;
        bench.open();
        Selection some;
        some.mode = SelectionMode::Faces;
        some.faces = {0, 1, 2};
        bench.document().setSelection(some);
        QTRY_VERIFY(!bench.bar.selectionText().isEmpty());
        auto *selection = bench.bar.findChild<QWidget *>(QStringLiteral("selectionText"));
        bench.bar.showText(QStringLiteral("Saved"));
        QVERIFY(selection->isVisible());
        bench.bar.showText(QString(120, u'm'));
        QVERIFY(!selection->isVisible());
        bench.bar.showText({});
        QVERIFY(selection->isVisible());
    }

    //! No digit is cut off, however many there are.
    void figuresThatAreLongerThanUsualGetRoom()
    {
        FigureStrip strip;
        const int figure = strip.addFigure(QStringLiteral("D"), QStringLiteral("00.0000"), {});
        const int usual = strip.sizeHint().width();
        strip.setFigure(figure, QStringLiteral("4.0000"));
        QCOMPARE(strip.sizeHint().width(), usual);
        strip.setFigure(figure, QStringLiteral("3.76e+30, or more"));
        QVERIFY(strip.sizeHint().width() > usual);
        strip.setFigure(figure, QStringLiteral("4.0000"));
        QCOMPARE(strip.sizeHint().width(), usual);
    }

    //! Only where there is a choice.
    void severalSetsAreNamed()
    {
        BarBench bench;
        bench.openSample();
        QCOMPARE(bench.bar.setText(), QString());
        bench.open();
        QTRY_COMPARE(bench.bar.setText(), QStringLiteral("UV set: first"));
        pushCommand(std::make_unique<ChooseUvSet>(bench.document(), 1));
        QTRY_COMPARE(bench.bar.setText(), QStringLiteral("UV set: lightmap"));
        QVERIFY(child<ElidedLabel>(bench.bar, "uvSetText")->isVisible());
        bench.stack().undo();
        QTRY_COMPARE(bench.bar.setText(), QStringLiteral("UV set: first"));
        bench.openSample();
        QTRY_COMPARE(bench.bar.setText(), QString());
        QVERIFY(!child<ElidedLabel>(bench.bar, "uvSetText")->isVisible());
    }

    //! Models in millimetres have areas of many thousands.
    void largeFiguresAreWrittenOut()
    {
        BarBench bench;
        Scene scene = test::layoutDocument(test::grid(4))->state().scene;
        const test::MeshPtr grid = scene.mesh;
        scene.mesh =
            MeshData::build(200 * grid->positions, grid->faceStart, grid->cornerVertex, grid->faceObject);
        bench.workspace.open(std::make_unique<Document>(std::move(scene)), {});
        Selection selection;
        selection.mode = SelectionMode::Faces;
        selection.faces = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
        bench.document().setSelection(selection);
        QTRY_COMPARE(bench.bar.selectionText(),
                     QStringLiteral("Faces: 16, area %1").arg(QLocale().toString(40000)));
        QCOMPARE(significantText(9999.4, 4), QLocale().toString(9999));
        QCOMPARE(significantText(9999.6, 4), QLocale().toString(10000));
        QCOMPARE(significantText(33040.6, 4), QLocale().toString(33041));
        QCOMPARE(significantText(-33040.6, 4), QLocale().toString(-33041));
        QCOMPARE(significantText(12.3456, 4), QLocale().toString(12.35));
        QVERIFY(significantText(1e20, 4).contains(QLatin1Char('e')));
    }

    void selections_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<QStringList>("parts");
        // Faces are squares of 0.25 x 0.25; edge 0 runs along one of them.
        QTest::newRow("vertices") << int(SelectionMode::Vertices)
                                  << QStringList{QStringLiteral("Vertices: 3"), QStringLiteral("corners: 4")};
        QTest::newRow("edges") << int(SelectionMode::Edges)
                               << QStringList{QStringLiteral("Edges: 2"), QStringLiteral("length 0.5")};
        QTest::newRow("faces") << int(SelectionMode::Faces)
                               << QStringList{QStringLiteral("Faces: 3"), QStringLiteral("area 0.1875")};
        QTest::newRow("islands") << int(SelectionMode::Islands)
                                 << QStringList{QStringLiteral("Islands: 2"), QStringLiteral("Faces: 3")};
    }

    void selections()
    {
        QFETCH(int, mode);
        QFETCH(QStringList, parts);
        BarBench bench;
        bench.open();
        const MeshData &mesh = bench.document().mesh();
        Selection selection;
        selection.mode = SelectionMode(mode);
        selection.faces = {0, 1, 2};
        // Two corners of one vertex between faces 0 and 1, and two of other vertices.
        const int shared = mesh.faceStart[0] + 1;
        int twin = mesh.faceStart[1];
        while (mesh.cornerVertex[twin] != mesh.cornerVertex[shared])
            ++twin;
        selection.corners = {mesh.faceStart[0], shared, twin, mesh.faceStart[3]};
        for (int edge = 0; selection.edges.size() < 2; ++edge) {
            if (!bench.document().adjacency().isDiagonal(edge))
                selection.edges << edge;
        }
        bench.document().setSelection(selection);
        QTRY_VERIFY(!bench.bar.selectionText().isEmpty());
        for (const QString &part : parts)
            QVERIFY2(bench.bar.selectionText().contains(part), qPrintable(bench.bar.selectionText()));
        bench.document().setSelection({});
        QTRY_VERIFY(bench.bar.selectionText().isEmpty());
    }

    void figuresOfTheMap()
    {
        BarBench bench;
        QVERIFY(!bench.bar.figures().isVisible());
        bench.open();
        QVERIFY(bench.measured());
        QTRY_COMPARE(bench.bar.figures().figure(StatusBar::Islands), QStringLiteral("2"));
        QVERIFY(bench.bar.figures().isVisible());
        QCOMPARE(bench.bar.figures().figure(StatusBar::Distortion), QStringLiteral("4.0000"));
        QCOMPARE(bench.bar.figures().figure(StatusBar::Flips), QStringLiteral("0"));
        QVERIFY(!bench.bar.figures().isAlert(StatusBar::Overlaps));
        QCOMPARE(bench.bar.figures().figure(StatusBar::Steps), QStringLiteral("–"));
        bench.workspace.close();
        QTRY_VERIFY(!bench.bar.figures().isVisible());
    }

    //! Of a map of many parts, where the mean of the islands, each at its own scale, is another one.
    void jobsSayTheFigureOfTheBar()
    {
        BarBench bench;
        bench.workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("machine")).value()), {});
        const QSignalSpy done(&bench.map, &MapController::done);
        bench.map.unwrap(unwrap::UnwrapQuality::Draft);
        QTRY_VERIFY_WITH_TIMEOUT(!done.isEmpty(), test::panelPatience);
        QVERIFY(bench.measured());
        QTRY_VERIFY(bench.bar.figures().figure(StatusBar::Distortion) != QStringLiteral("–"));
        const QString said = done.first().first().toString();
        QVERIFY2(said.contains(bench.bar.figures().figure(StatusBar::Distortion)), qPrintable(said));
    }

    void overlapsAreAnAlert()
    {
        BarBench bench;
        Scene scene = test::sceneOf(test::grid(4));
        scene.uvSets.push_back({QStringLiteral("uv"), test::splitLayout(*scene.mesh)});
        // Both islands at the same place.
        UvMatrix &uv = scene.uvSets.back().uv;
        for (Eigen::Index row = 0; row < uv.rows(); ++row)
            uv(row, 0) -= uv(row, 0) >= 1.25 ? 1.5 : 0;
        bench.workspace.open(std::make_unique<Document>(std::move(scene)), {});
        QVERIFY(bench.measured());
        QTRY_VERIFY(bench.bar.figures().isAlert(StatusBar::Overlaps));
        QVERIFY(bench.bar.figures().figure(StatusBar::Overlaps).toInt() > 0);
    }

    void figuresOfARunningSolve()
    {
        BarBench bench;
        bench.openSample();
        bench.solver.setMode(SolveMode::Manual);
        bench.solver.run();
        int nothings = 0; // a distortion below 4 cannot be
        const auto watch = connect(&bench.solver, &SolverController::statusChanged, &bench.bar, [&] {
            nothings += bench.bar.figures().figure(StatusBar::Distortion).startsWith(QLatin1Char('0'));
        });
        QTRY_VERIFY_WITH_TIMEOUT(bench.solver.status().iteration > 3, test::panelPatience);
        disconnect(watch);
        QCOMPARE(nothings, 0);
        QTRY_VERIFY(bench.bar.figures().figure(StatusBar::Distortion).startsWith(QLatin1Char('4')));
        QVERIFY(bench.bar.figures().figure(StatusBar::Energy) != QStringLiteral("–"));
        QVERIFY(bench.bar.figures().figure(StatusBar::Lambda).startsWith(QLatin1Char('0')));
        const int width = bench.bar.figures().sizeHint().width();
        const QString energy = bench.bar.figures().figure(StatusBar::Energy);
        // Also a solve that is at rest by now goes on with another balance.
        SolveSettings settings = bench.workspace.document()->solveSettings();
        settings.lambda = 0.05;
        pushCommand(std::make_unique<ChangeSettings>(*bench.workspace.document(), settings));
        QTRY_VERIFY_WITH_TIMEOUT(bench.bar.figures().figure(StatusBar::Energy) != energy,
                                 test::panelPatience);
        QCOMPARE(bench.bar.figures().sizeHint().width(), width); // nothing moves while numbers run
        bench.solver.pause();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.solver.isPausing(), test::panelPatience);
        QTRY_COMPARE(bench.bar.figures().figure(StatusBar::Energy), QStringLiteral("–"));
    }

    void jobsShowTheirProgressAndAreCancelled()
    {
        BarBench bench;
        auto *const progress = child<QProgressBar>(bench.bar, "progress");
        auto *const cancel = child<QToolButton>(bench.bar, "cancel");
        QVERIFY(!progress->isVisible());
        QVERIFY(!cancel->isVisible());
        bench.bar.showText(QStringLiteral("Select something first"));
        std::atomic<bool> report = false;
        bool stopped = false;
        bench.map.jobs().start(
            QStringLiteral("Packing"),
            [&report](JobControl &control) {
                while (!control.stop()) {
                    if (report) {
                        control.setProgress(0.5);
                        control.setStage(QStringLiteral("half"));
                        report = false;
                    }
                    QThread::msleep(1);
                }
                return true;
            },
            [&stopped](bool value) { stopped = value; });
        QTRY_VERIFY(progress->isVisible());
        QCOMPARE(progress->maximum(), 0); // the end is not known yet
        QVERIFY(bench.bar.shownText().contains(QStringLiteral("Packing")));
        report = true;
        QTRY_COMPARE(progress->value(), 50);
        QTRY_VERIFY(bench.bar.shownText().contains(QStringLiteral("half")));
        QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_VERIFY(stopped);
        QVERIFY(!progress->isVisible());
        QVERIFY(!cancel->isVisible());
    }

    void textsGiveWayWhenThereIsLittleRoom()
    {
        BarBench bench(1280);
        bench.open();
        bench.bar.setHint(QString(400, QLatin1Char('x')));
        bench.document().setSelection({SelectionMode::Faces, {0, 1, 2}, {}, {}});
        QTRY_VERIFY(!bench.bar.selectionText().isEmpty());
        QCOMPARE(bench.bar.width(), 1280);
        // Those of the map, and those of the soup when the user drives it.
        QTRY_COMPARE(bench.bar.figures().visibleCount(), 5);
        bench.solver.setMode(SolveMode::Manual);
        QTRY_COMPARE(bench.bar.figures().visibleCount(), 10);
        auto *const text = child<ElidedLabel>(bench.bar, "statusText");
        auto *const selection = child<ElidedLabel>(bench.bar, "selectionText");
        QVERIFY(text->width() > 100);
        QVERIFY(!text->toolTip().isEmpty()); // the whole text
        QVERIFY(selection->width() >= selection->fontMetrics().horizontalAdvance(selection->text()));
        const auto inBar = [&](const QWidget *widget) {
            return QRect(widget->mapTo(&bench.bar, QPoint()), widget->size());
        };
        QVERIFY(inBar(text).right() < inBar(selection).left());
        QVERIFY(inBar(selection).right() < inBar(&bench.bar.figures()).left());
        QVERIFY(bench.bar.minimumSizeHint().width() < 700);
        bench.bar.resize(600, 24);
        QTRY_VERIFY(bench.bar.figures().visibleCount() < 10);
        QVERIFY(bench.bar.figures().visibleCount() > 0);
    }
};

QTEST_MAIN(TestStatusBar)

} // namespace tst_statusbar

#include "tst_statusbar.moc"
