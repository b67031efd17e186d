// The panel of the solver: what its controls do to the document and how they follow it.
#include "commands/setuvs.h"
#include "model/samples/samples.h"
#include "support/answers.h"
#include "support/meshbuilders.h"
#include "support/panelbench.h"
#include "views/panels/convergencegraph.h"
#include "views/panels/deltaspinbox.h"
#include "views/panels/foldsection.h"
#include "views/panels/graphaxis.h"
#include "views/panels/sliderspin.h"
#include "views/panels/solverpanel.h"
#include "views/panels/stretchcontrol.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QToolButton>

#include <cmath>

namespace tst_solverpanel {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace autocuts::live;
using namespace autocuts::preference;
using test::child;
using test::click;

namespace {

//! A solver panel on the bumpy cube, steered by hand.
struct SolverBench : test::PanelBench
{
    test::Answers answers;
    SolverPanel panel{context, answers};

    explicit SolverBench(bool open = true)
    {
        solver.setMode(SolveMode::Manual);
        if (open)
            workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("bumpycube")).value()), {});
        const bool shown = test::showPanel(panel);
        Q_ASSERT(shown);
        Q_UNUSED(shown);
    }
    SliderSpin *lambda() { return child<SliderSpin>(panel, "lambda"); }
    SliderSpin *delta() { return child<SliderSpin>(panel, "delta"); }
    const SolveSettings &settings() { return document().solveSettings(); }
};

void typeInto(QAbstractSpinBox *box, const QString &text)
{
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
}

std::vector<TracePoint> fallingTrace(int count)
{
    std::vector<TracePoint> trace;
    for (int i = 0; i < count; ++i)
        trace.push_back(
            {i + 1, float(4 + 2.0 / (1 + i)), float(300.0 / (1 + i) + 5), float(std::exp2(-i / 200))});
    return trace;
}

} // namespace

class TestSolverPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isDisabledAndExplainedWithoutADocument()
    {
        SolverBench bench(false);
        auto *const note = child<QLabel>(bench.panel, "emptyNote");
        QVERIFY(note->isVisible());
        QVERIFY(!note->text().isEmpty());
        for (const char *name :
             {"run", "step", "restart", "lambda", "delta", "finish", "unwrap", "graph", "settings"})
            QVERIFY2(!child<QWidget>(bench.panel, name)->isEnabled(), name);
        bench.workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("torus")).value()), {});
        QVERIFY(!note->isVisible());
        QVERIFY(child<QWidget>(bench.panel, "run")->isEnabled());
        bench.workspace.close();
        QVERIFY(note->isVisible());
        QVERIFY(!child<QWidget>(bench.panel, "run")->isEnabled());
    }

    void aDragOfLambdaIsOneEntry()
    {
        SolverBench bench;
        test::dragSlider(*bench.lambda()->slider(), 40);
        const double dragged = bench.settings().lambda;
        QVERIFY(dragged > 0);
        QCOMPARE(bench.stack().count(), 1);
        QCOMPARE(bench.lambda()->value(), dragged);

        test::dragSlider(*bench.lambda()->slider(), 20);
        QVERIFY(bench.settings().lambda > dragged);
        QCOMPARE(bench.stack().count(), 2);

        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.settings().lambda, dragged);
        QCOMPARE(bench.lambda()->value(), dragged);
        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.lambda()->value(), 0.0);
        QCOMPARE(bench.lambda()->slider()->value(), 0);
        bench.stack().redo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.lambda()->value(), dragged);
    }

    void aDragBackToItsStartLeavesNoEntry()
    {
        SolverBench bench;
        bench.lambda()->slider()->setFocus();
        QSlider &slider = *bench.lambda()->slider();
        const QPoint start = test::handleOf(slider);
        QTest::mousePress(&slider, Qt::LeftButton, {}, start);
        for (int offset : {10, 30, 10, 0}) {
            const QPointF place = start + QPoint(offset, 0);
            QMouseEvent move(QEvent::MouseMove, place, slider.mapToGlobal(place), Qt::NoButton,
                             Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&slider, &move);
        }
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, start);
        QCOMPARE(bench.settings().lambda, 0.0);
        QCOMPARE(bench.stack().count(), 0);
    }

    void typedNumbersAreTaken()
    {
        SolverBench bench;
        typeInto(bench.lambda()->spinBox(), QStringLiteral("0.25"));
        QCOMPARE(bench.settings().lambda, 0.25);
        QCOMPARE(bench.lambda()->slider()->value(), 500); // the slider is finer near 0: sqrt(0.25)
        typeInto(bench.delta()->spinBox(), QStringLiteral("1e-3"));
        QCOMPARE(bench.settings().delta, 1e-3);
        QCOMPARE(bench.stack().count(), 2);
        // Out of range: what was there stays.
        typeInto(bench.delta()->spinBox(), QStringLiteral("77"));
        QCOMPARE(bench.settings().delta, 1e-3);
        typeInto(bench.delta()->spinBox(), QStringLiteral("-"));
        QCOMPARE(bench.settings().delta, 1e-3);
        QCOMPARE(bench.stack().count(), 2);
    }

    void deltaIsHalvedAndDoubled()
    {
        SolverBench bench;
        click(bench.panel, "halve");
        click(bench.panel, "halve");
        QCOMPARE(bench.settings().delta, 0.25);
        click(bench.panel, "double");
        QCOMPARE(bench.settings().delta, 0.5);
        QCOMPARE(bench.stack().count(), 3);
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.delta()->value(), 0.5);
        bench.delta()->spinBox()->setFocus();
        QTest::keyClick(bench.delta()->spinBox(), Qt::Key_Down);
        QCOMPARE(bench.settings().delta, 0.25);
        for (int i = 0; i < 60; ++i)
            click(bench.panel, "halve");
        QCOMPARE(bench.settings().delta, std::exp2(-24));
    }

    void keysOnTheSliderAreOneEntry()
    {
        SolverBench bench;
        QSlider *const slider = bench.lambda()->slider();
        slider->setFocus();
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(slider, Qt::Key_Right);
        QVERIFY(bench.settings().lambda > 0);
        QCOMPARE(bench.stack().count(), 1);
    }

    void otherSettings_data()
    {
        QTest::addColumn<QString>("box");
        QTest::addColumn<int>("index");
        QTest::addColumn<std::function<int(const SolveSettings &)>>("read");
        using Read = std::function<int(const SolveSettings &)>;
        QTest::newRow("start") << QStringLiteral("start") << 2 << Read([](auto &s) { return int(s.start); });
        QTest::newRow("energy") << QStringLiteral("energy") << 1
                                << Read([](auto &s) { return int(s.energy); });
        QTest::newRow("weighting") << QStringLiteral("weighting") << 1
                                   << Read([](auto &s) { return int(s.weighting); });
        QTest::newRow("solver") << QStringLiteral("solverKind") << 1
                                << Read([](auto &s) { return int(s.solver); });
    }

    void otherSettings()
    {
        QFETCH(QString, box);
        QFETCH(int, index);
        QFETCH(std::function<int(const SolveSettings &)>, read);
        SolverBench bench;
        auto *const combo = child<QComboBox>(bench.panel, box.toLatin1().constData());
        combo->setFocus();
        for (int i = 0; i < index; ++i)
            QTest::keyClick(combo, Qt::Key_Down);
        QCOMPARE(read(bench.settings()), index);
        QCOMPARE(bench.stack().count(), index);
        while (bench.stack().canUndo())
            bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(combo->currentIndex(), 0);
    }

    void seedAndRectangleWeight()
    {
        SolverBench bench;
        typeInto(child<QAbstractSpinBox>(bench.panel, "seed"), QStringLiteral("77"));
        typeInto(child<QAbstractSpinBox>(bench.panel, "boxWeight"), QStringLiteral("12.5"));
        QCOMPARE(bench.settings().seed, 77u);
        QCOMPARE(bench.settings().boxWeight, 12.5);
    }

    void whereSeamsShouldRun()
    {
        SolverBench bench;
        auto *const sharp = child<QCheckBox>(bench.panel, "sharp");
        auto *const creases = child<QComboBox>(bench.panel, "creases");
        QVERIFY(sharp->isChecked());
        QCOMPARE(creases->currentData().toInt(), int(CreaseMode::Auto));
        creases->setFocus();
        QTest::keyClick(creases, Qt::Key_Down);
        QCOMPARE(bench.settings().creases, CreaseMode::On);
        typeInto(child<SliderSpin>(bench.panel, "creaseStrength")->spinBox(), QStringLiteral("0.5"));
        typeInto(child<SliderSpin>(bench.panel, "visibility")->spinBox(), QStringLiteral("0.75"));
        QCOMPARE(bench.settings().creaseStrength, 0.5);
        QCOMPARE(bench.settings().visibility, 0.75);
        auto *const symmetry = child<QComboBox>(bench.panel, "symmetry");
        QCOMPARE(symmetry->currentData().toInt(), int(SymmetryMode::Auto));
        symmetry->setFocus();
        QTest::keyClick(symmetry, Qt::Key_Down);
        QCOMPARE(bench.settings().symmetry, SymmetryMode::On);
        QCOMPARE(bench.stack().count(), 4);
        QVERIFY(test::isUpToDate(bench.panel));
        auto *const hidden = child<QCheckBox>(bench.panel, "hidden");
        QVERIFY(hidden->isChecked());
        hidden->setFocus();
        QTest::keyClick(hidden, Qt::Key_Space);
        QCOMPARE(bench.settings().visibility, 0.0);
        sharp->setFocus();
        QTest::keyClick(sharp, Qt::Key_Space);
        QCOMPARE(bench.settings().creases, CreaseMode::Off);
        for (const char *name : {"align", "mirror"}) {
            child<QCheckBox>(bench.panel, name)->setFocus();
            QTest::keyClick(child<QCheckBox>(bench.panel, name), Qt::Key_Space);
        }
        QCOMPARE(bench.settings().align, CreaseMode::Auto);
        QVERIFY(bench.settings().mirrorMaps);
        auto *const flat = child<QCheckBox>(bench.panel, "flat");
        QVERIFY(flat->isChecked());
        flat->setFocus();
        QTest::keyClick(flat, Qt::Key_Space);
        QCOMPARE(bench.settings().flat, FlatMode::Free);
        auto *const alike = child<QComboBox>(bench.panel, "alike");
        QCOMPARE(alike->currentData().toInt(), int(AlikeMode::SameCuts));
        alike->setFocus();
        QTest::keyClick(alike, Qt::Key_End);
        QCOMPARE(bench.settings().alike, AlikeMode::Stack);
        auto *const up = child<QComboBox>(bench.panel, "worldUp");
        up->setFocus();
        QTest::keyClick(up, Qt::Key_End);
        QCOMPARE(bench.settings().worldUp, WorldUp::AutoZ);
        auto *const surface = child<QComboBox>(bench.panel, "surface");
        surface->setFocus();
        QTest::keyClick(surface, Qt::Key_Down);
        QCOMPARE(bench.settings().surface, SurfaceKind::Organic);
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(!flat->isEnabled());
        while (bench.stack().canUndo())
            bench.stack().undo();
        QVERIFY(bench.settings() == SolveSettings());
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(creases->currentData().toInt(), int(CreaseMode::Auto));
        QCOMPARE(child<SliderSpin>(bench.panel, "visibility")->value(), 0.0);
        QCOMPARE(symmetry->currentData().toInt(), int(SymmetryMode::Auto));
    }

    void theBudgetTakesOverLambdaAndDelta()
    {
        SolverBench bench;
        click(bench.panel, "budget");
        QCOMPARE(bench.solver.mode(), SolveMode::Budget);
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(!bench.lambda()->isEnabled());
        QVERIFY(!bench.delta()->isEnabled());
        auto *const bound = child<QDoubleSpinBox>(bench.panel, "bound");
        typeInto(bound, QStringLiteral("D 4.25"));
        QCOMPARE(bench.settings().maxDistortion, 4.25);
        QCOMPARE(bench.stack().undoText(), QStringLiteral("Change distortion budget"));
        QCOMPARE(bound->minimum(), 4.0001);
        QCOMPARE(bound->maximum(), 100.0);
        click(bench.panel, "manual");
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bench.solver.mode(), SolveMode::Manual);
        QVERIFY(bench.lambda()->isEnabled());
        bench.stack().undo();
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(bound->value(), 4.1);
    }

    void stretchInWordsAndNumbers()
    {
        SolverBench bench;
        auto *const percent = child<QLabel>(bench.panel, "meanStretch");
        const auto word = [&](const char *name) { return child<QToolButton>(bench.panel, name); };
        QVERIFY2(percent->text().contains(QLocale().toString(2.5, 'f', 1)), qPrintable(percent->text()));
        QVERIFY(word("medium")->isChecked());
        QTest::mouseClick(word("low"), Qt::LeftButton);
        QCOMPARE(bench.settings().maxDistortion, 4.04);
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(word("low")->isChecked() && !word("medium")->isChecked());
        QVERIFY2(percent->text().contains(QLocale().toString(1.0, 'f', 1)), qPrintable(percent->text()));
        // A click on the word that holds changes nothing.
        QTest::mouseClick(word("low"), Qt::LeftButton);
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(word("low")->isChecked());
        QCOMPARE(bench.stack().count(), 1);
        // A drag of the slider is one entry; to the right, the map may stretch more.
        QSlider *const slider = child<StretchControl>(bench.panel, "stretch")->findChild<QSlider *>();
        test::dragSlider(*slider, 30);
        QVERIFY(bench.settings().maxDistortion > 4.05);
        QCOMPARE(bench.stack().count(), 2);
        for (const auto &[key, bound] : {std::pair(Qt::Key_Home, 4.0001), std::pair(Qt::Key_End, 100.0)}) {
            slider->setFocus();
            QTest::keyClick(slider, key);
            QCOMPARE(bench.settings().maxDistortion, bound);
        }
        for (const double bound : {4.0001, 4.001, 4.008, 4.02, 4.1, 4.45, 5.0, 60.0, 100.0}) {
            typeInto(child<QDoubleSpinBox>(bench.panel, "bound"), QString::number(bound, 'f', 4));
            QCOMPARE(bench.settings().maxDistortion, bound);
        }
    }

    void advancedOpensForManual()
    {
        test::PanelBench studio;
        studio.workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("bumpycube")).value()),
                              {});
        test::Answers answers;
        SolverPanel panel(studio.context, answers);
        QVERIFY(test::showPanel(panel));
        auto *const advanced = child<FoldSection>(panel, "advanced");
        QVERIFY(!advanced->isOpen());
        QVERIFY(!child<SliderSpin>(panel, "lambda")->isVisible());
        // The values in effect are the first ones of the user.
        studio.solver.setLiveView(LiveView::Soup);
        click(panel, "run");
        QTRY_VERIFY_WITH_TIMEOUT(studio.solver.status().iteration > 3 && studio.solver.status().lambda > 0,
                                 test::panelPatience);
        click(panel, "manual");
        QVERIFY(advanced->isOpen());
        QVERIFY(child<SliderSpin>(panel, "lambda")->isVisible());
        QVERIFY(studio.document().solveSettings().lambda > 0);
        advanced->setOpen(false);
        QVERIFY(test::isUpToDate(panel));
        QVERIFY(!advanced->isOpen()); // a refresh leaves it as it is
        click(panel, "run");
        QTRY_VERIFY_WITH_TIMEOUT(!studio.solver.isRunning() && !studio.solver.isPausing(),
                                 test::panelPatience);
    }

    void theNextStepIsOffered()
    {
        SolverBench bench(false);
        // Two squares that overlap, then apart.
        const test::MeshPtr mesh = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}});
        UvMatrix uv(8, 2);
        uv << .1, .1, .4, .1, .4, .4, .1, .4, .2, .1, .5, .1, .5, .4, .2, .4;
        Scene scene;
        scene.mesh = mesh;
        scene.uvSets.push_back({QStringLiteral("map"), uv});
        bench.workspace.open(std::make_unique<Document>(scene), {});
        auto *const next = child<QPushButton>(bench.panel, "next");
        auto *const outcome = child<QLabel>(bench.panel, "outcome");
        const auto nextIs = [&](const char *id) {
            return QTest::qWaitFor(
                [&] { return next->isVisible() && next->text() == bench.actions.action(id)->iconText(); },
                test::panelPatience);
        };
        QVERIFY2(nextIs("uv.separate"), qPrintable(outcome->text()));
        uv.bottomRows(4).col(0).array() += 0.2001;
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Move, uv));
        QVERIFY2(nextIs("uv.pack"), qPrintable(outcome->text()));
        uv.bottomRows(4).col(0).array() += 0.2;
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Move, uv));
        QVERIFY2(nextIs("file.exportMesh"), qPrintable(outcome->text()));
        // An island of another size is not stretched; in a tile of its own it may well have that size.
        const UvMatrix large = uv;
        uv.bottomRows(4) = 0.5 * uv.bottomRows(4).array() + 0.4;
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Move, uv));
        QVERIFY2(nextIs("uv.density"), qPrintable(outcome->text()));
        uv.bottomRows(4).col(0).array() += 1;
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Move, uv));
        QVERIFY2(nextIs("file.exportMesh"), qPrintable(outcome->text()));
        pushCommand(std::make_unique<SetUvs>(bench.document(), UvEdit::Move, large));
        QVERIFY(nextIs("file.exportMesh"));
        QVERIFY2(outcome->text().contains(u"islands:\u00a02"), qPrintable(outcome->text()));
        bench.actions.action("file.exportMesh")->setEnabled(true);
        QSignalSpy triggered(bench.actions.action("file.exportMesh"), &QAction::triggered);
        click(bench.panel, "next");
        QCOMPARE(triggered.count(), 1);
        bench.workspace.close();
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(!next->isVisible());
    }

    void runStepPauseAndRestart()
    {
        SolverBench bench;
        auto *const run = child<QPushButton>(bench.panel, "run");
        const QString runText = run->text();
        click(bench.panel, "run");
        QVERIFY(bench.solver.isRunning());
        QVERIFY(test::isUpToDate(bench.panel));
        QVERIFY(run->text() != runText);
        auto *const graph = child<ConvergenceGraph>(bench.panel, "graph");
        QTRY_VERIFY_WITH_TIMEOUT(graph->trace().size() > 5, test::panelPatience);
        QCOMPARE(graph->trace().front().iteration, 1);
        click(bench.panel, "run");
        QVERIFY(!bench.solver.isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.solver.isPausing(), test::panelPatience);
        QVERIFY(test::isUpToDate(bench.panel));
        QCOMPARE(run->text(), runText);

        const int iterations = bench.solver.status().iteration;
        click(bench.panel, "step");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.solver.isRunning() && !bench.solver.isPausing(), test::panelPatience);
        QCOMPARE(bench.solver.status().iteration, iterations + 1);
        click(bench.panel, "restart");
        QVERIFY(bench.solver.isRunning());
        QVERIFY(bench.solver.status().iteration < iterations);
    }

    void lambdaIsDraggedWhileItRuns()
    {
        SolverBench bench;
        click(bench.panel, "run");
        QTRY_VERIFY_WITH_TIMEOUT(bench.solver.status().iteration > 3, test::panelPatience);
        test::dragSlider(*bench.lambda()->slider(), 40);
        QVERIFY(bench.settings().lambda > 0);
        QCOMPARE(bench.stack().count(), 1);
        QVERIFY(bench.solver.isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(bench.solver.status().lambda, bench.settings().lambda, test::panelPatience);
        click(bench.panel, "run");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.solver.isPausing(), test::panelPatience);
        QCOMPARE(bench.stack().count(), 2); // the drag and the run
    }

    void clickingAButtonLeavesTheFocus()
    {
        SolverBench bench;
        bench.lambda()->slider()->setFocus();
        click(bench.panel, "halve");
        QVERIFY(bench.lambda()->slider()->hasFocus());
        // By Tab it is reached all the same.
        QVERIFY(child<QPushButton>(bench.panel, "run")->focusPolicy() & Qt::TabFocus);
    }

    void theWheelScrollsUnlessAControlHasTheFocus()
    {
        SolverBench bench;
        auto *const combo = child<QComboBox>(bench.panel, "energy");
        const auto wheel = [combo] {
            const QPointF middle = combo->rect().center();
            QWheelEvent event(middle, combo->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(combo, &event);
        };
        bench.lambda()->slider()->setFocus();
        wheel();
        QCOMPARE(bench.settings().energy, DistortionEnergy::SymmetricDirichlet);
        combo->setFocus();
        wheel();
        QCOMPARE(bench.settings().energy, DistortionEnergy::Amips);
    }

    void theGraphReadsValues()
    {
        ConvergenceGraph graph;
        graph.resize(250, 160);
        graph.setTrace(fallingTrace(5000));
        graph.show();
        QVERIFY(QTest::qWaitForWindowExposed(&graph));
        QVERIFY(graph.marked() == nullptr);
        QTest::mouseMove(&graph, {10, 80});
        QTRY_VERIFY(graph.marked());
        QCOMPARE(graph.marked()->iteration, 1);
        QTest::mouseMove(&graph, {240, 80});
        QTRY_COMPARE(graph.marked()->iteration, 5000);
        QTest::keyClick(&graph, Qt::Key_Left);
        QCOMPARE(graph.marked()->iteration, 4999);
        QTest::keyClick(&graph, Qt::Key_Home);
        QCOMPARE(graph.marked()->iteration, 1);
        // The mark stays at its iteration when the trace is thinned out.
        std::vector<TracePoint> thinned;
        for (const TracePoint &point : fallingTrace(5000)) {
            if (point.iteration % 2 == 1)
                thinned.push_back(point);
        }
        QTest::keyClick(&graph, Qt::Key_Right);
        QTest::keyClick(&graph, Qt::Key_Right);
        graph.setTrace(thinned);
        QCOMPARE(graph.marked()->iteration, 3);
        graph.setTrace({});
        QVERIFY(graph.marked() == nullptr);
    }

    void theGraphSurvivesOddTraces()
    {
        ConvergenceGraph graph;
        graph.resize(250, 160);
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const float infinity = std::numeric_limits<float>::infinity();
        for (const std::vector<TracePoint> &trace : {std::vector<TracePoint>{{1, 4, 0, 1}},
                                                     {{1, nan, nan, nan}},
                                                     {{1, 4, 0, 1}, {2, infinity, -1, 0}},
                                                     {{5, 4, 4, 4}, {5, 4, 4, 4}},
                                                     {{1, 4, 1e30f, 1}, {2, 1e30f, 1e-30f, 1e-30f}}}) {
            graph.setTrace(trace);
            QVERIFY(!graph.grab().isNull());
        }
    }

    void axes_data()
    {
        QTest::addColumn<std::vector<float>>("values");
        QTest::addColumn<bool>("logarithmic");
        QTest::newRow("flat") << std::vector<float>{4, 4, 4} << false;
        QTest::newRow("narrow") << std::vector<float>{4.001f, 4.3f} << false;
        QTest::newRow("wide") << std::vector<float>{5, 400} << true;
        QTest::newRow("zero") << std::vector<float>{0, 400} << false;
        QTest::newRow("none") << std::vector<float>{} << false;
    }

    void axes()
    {
        QFETCH(std::vector<float>, values);
        QFETCH(bool, logarithmic);
        const GraphAxis axis = GraphAxis::around(values);
        QCOMPARE(axis.isLogarithmic(), logarithmic);
        QVERIFY(axis.minimum() < axis.maximum());
        for (float value : values)
            QVERIFY(value >= axis.minimum() && value <= axis.maximum() * (1 + 1e-6));
        QCOMPARE(axis.fraction(axis.minimum()), 0.0);
        QCOMPARE(axis.fraction(axis.maximum()), 1.0);
        const std::vector<double> ticks = axis.ticks(4);
        QVERIFY(ticks.size() >= 2 && ticks.size() <= 7);
        for (std::size_t i = 1; i < ticks.size(); ++i)
            QVERIFY(ticks[i - 1] < ticks[i]);
    }
};

QTEST_MAIN(TestSolverPanel)

} // namespace tst_solverpanel

#include "tst_solverpanel.moc"
