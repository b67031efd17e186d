// What the actions of the menus do.
#include "commands/changesettings.h"
#include "commands/setuvs.h"
#include "support/gridstudio.h"
#include "support/patience.h"
#include "views/selecting/selecting.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <numeric>

namespace tst_actioneffects {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::GridStudio;

namespace {

QList<int> range(int count)
{
    QList<int> result(count);
    std::iota(result.begin(), result.end(), 0);
    return result;
}

//! A solve does not keep the map of the document then.
void flipAFace(GridStudio &studio)
{
    UvMatrix uv = studio.document().uv();
    uv.row(0).swap(uv.row(2));
    pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Move, uv));
}

} // namespace

class TestActionEffects : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void selectMenu()
    {
        GridStudio studio;
        const MeshAdjacency &adjacency = studio.document().adjacency();
        studio.trigger("select.all");
        QCOMPARE(studio.selection().faces, range(16));
        studio.trigger("select.none");
        QVERIFY(studio.selection().isEmpty());
        studio.selectFaces({0, 1});
        studio.trigger("select.invert");
        QCOMPARE(studio.selection().faces, range(16).mid(2));
        studio.selectFaces({0});
        studio.trigger("select.grow");
        QCOMPARE(studio.selection().faces, QList<int>({0, 1, 4, 5}));
        studio.trigger("select.shrink");
        QCOMPARE(studio.selection().faces, QList<int>({0}));
        studio.trigger("select.island");
        QCOMPARE(studio.selection().faces, QList<int>({0, 1, 4, 5, 8, 9, 12, 13}));
        studio.selectFaces({0});
        studio.trigger("select.similar");
        QCOMPARE(studio.selection().faces, range(16));
        studio.selectFaces({3});
        studio.trigger("select.linked");
        QCOMPARE(studio.selection().faces, range(16));
        studio.trigger("select.edges");
        QCOMPARE(studio.selection().mode, SelectionMode::Edges);
        QVERIFY(studio.action("select.edges")->isChecked() && !studio.action("select.faces")->isChecked());
        studio.trigger("select.all");
        QVERIFY(studio.selection().faces.isEmpty());
        QCOMPARE(studio.selection().edges.size(), 40);
        studio.selectEdges({adjacency.edgeOfCorner(0)});
        studio.trigger("select.loop");
        QCOMPARE(studio.selection().edges.size(), 16); // along the boundary
        studio.trigger("select.vertices");
        studio.trigger("select.all");
        QCOMPARE(studio.selection().corners, range(64));
    }

    void flippedFacesAreFound()
    {
        GridStudio studio;
        QVERIFY(flippedFaces(studio.document()).isEmpty());
        // One corner of face 0 beyond the opposite one, together with all corners joined to it.
        UvMatrix uv = studio.document().uv();
        const UvMatrix::RowXpr inner = uv.row(2);
        const Eigen::RowVector2d from = inner, to = Eigen::RowVector2d(-0.6, -0.6);
        for (Eigen::Index row = 0; row < uv.rows(); ++row) {
            if (uv.row(row) == from)
                uv.row(row) = to;
        }
        pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Move, uv));
        QCOMPARE(flippedFaces(studio.document()), QList<int>({0}));
        studio.trigger("select.flipped");
        QCOMPARE(studio.selection().faces, QList<int>({0}));
    }

    void seamsFromEdgesAndFaces()
    {
        GridStudio studio;
        const auto edges = [&](PairState state) {
            int count = 0;
            for (int pair = 0; pair < int(studio.document().mesh().edgePairs.size()); ++pair)
                count += studio.document().seams().edgeIs(pair, state);
            return count;
        };
        studio.selectFaces({5, 6});
        studio.trigger("uv.cut");
        QCOMPARE(edges(PairState::Cut), 6); // around the two faces
        studio.trigger("uv.join");
        QCOMPARE(edges(PairState::Joined), 1); // between them
        studio.trigger("uv.clearSteering");
        QCOMPARE(edges(PairState::Cut) + edges(PairState::Joined), 0);
        QCOMPARE(studio.entries(), 3);
        studio.trigger("uv.clearSteering");
        QCOMPARE(studio.entries(), 3);
    }

    void pinsAndFlags()
    {
        GridStudio studio;
        studio.selectFaces({5});
        studio.trigger("uv.pin");
        const Document &document = studio.document();
        QCOMPARE(int(document.constraints().pins.size()), 4);
        for (const UvPin &pin : document.constraints().pins)
            QCOMPARE(pin.position, Vec2(document.uv().row(pin.corner)));
        studio.trigger("uv.unpin");
        QVERIFY(document.constraints().pins.empty());
        const auto flags = [&] { return document.marks().flagsOf(document.islands().faces(0)); };
        studio.trigger("uv.lock");
        QCOMPARE(flags().locked, 1);
        QCOMPARE(document.marks().flagsOf(document.islands().faces(1)).locked, 0);
        studio.trigger("uv.unlock");
        QCOMPARE(flags().locked, 0);
        studio.selectFaces({0, 3});
        studio.trigger("uv.stack");
        studio.trigger("uv.group");
        QVERIFY(flags().stack > 0 && flags().group > 0);
        QCOMPARE(document.marks().flagsOf(document.islands().faces(1)), flags());
        studio.trigger("uv.unstack");
        studio.trigger("uv.ungroup");
        QCOMPARE(flags(), IslandFlags());
        QSignalSpy said(&studio.context.map, &MapController::done);
        studio.trigger("uv.ungroup");
        QVERIFY(said.takeLast().at(0).toString().contains(QLatin1String("Nothing to do")));
    }

    void lambdaAndDeltaKeys()
    {
        GridStudio studio;
        const SolveSettings &settings = studio.document().solveSettings();
        const double lambda = settings.lambda, delta = settings.delta;
        for (int i = 0; i < 3; ++i)
            studio.trigger("uv.lambdaMore");
        QCOMPARE(settings.lambda, lambda + 0.15);
        QCOMPARE(studio.entries(), 1);
        studio.trigger("uv.deltaHalve");
        studio.trigger("uv.deltaHalve");
        QCOMPARE(settings.delta, delta / 4);
        studio.trigger("uv.deltaDouble");
        QCOMPARE(settings.delta, delta / 2);
        for (int i = 0; i < 40; ++i)
            studio.trigger("uv.lambdaLess");
        QCOMPARE(settings.lambda, 0.0);
        for (int i = 0; i < 100; ++i)
            studio.trigger("uv.deltaHalve");
        QCOMPARE(settings.delta, UvActions::minDelta);
    }

    void keysTakeOverFromTheBudget()
    {
        GridStudio studio;
        QSignalSpy said(&studio.context.map, &MapController::done);
        studio.trigger("uv.budget");
        QCOMPARE(studio.solver.mode(), SolveMode::Budget);
        QVERIFY(studio.action("uv.budget")->isChecked());
        studio.trigger("uv.lambdaMore");
        QCOMPARE(studio.solver.mode(), SolveMode::Manual);
        QVERIFY(!studio.action("uv.budget")->isChecked());
        QVERIFY(said.takeLast().at(0).toString().contains(QLatin1String("by hand now")));
        studio.trigger("edit.undo");
        QCOMPARE(studio.solver.mode(), SolveMode::Budget);
        // Where nothing changes, neither does the mode.
        SolveSettings lowest = studio.document().solveSettings();
        lowest.lambda = 0;
        pushCommand(std::make_unique<ChangeSettings>(studio.document(), lowest));
        studio.trigger("uv.lambdaLess");
        QCOMPARE(studio.solver.mode(), SolveMode::Budget);
        QVERIFY(said.takeLast().at(0).toString().contains(QLatin1String("cannot go further")));
        // A mode that was chosen stays.
        studio.trigger("uv.deltaDouble");
        studio.trigger("uv.budget");
        studio.trigger("uv.budget");
        studio.trigger("edit.undo");
        QCOMPARE(studio.solver.mode(), SolveMode::Manual);
    }

    void choicesShowTheSettings()
    {
        GridStudio studio;
        studio.trigger("uv.start.tutte");
        studio.trigger("uv.energy.amips");
        studio.trigger("uv.weighting.count");
        const SolveSettings settings = studio.document().solveSettings();
        QCOMPARE(settings.start, StartMode::Tutte);
        QCOMPARE(settings.energy, DistortionEnergy::Amips);
        QCOMPARE(settings.weighting, SeamWeighting::Count);
        studio.trigger("edit.undo");
        QVERIFY(studio.action("uv.weighting.length")->isChecked());
        QVERIFY(!studio.action("uv.weighting.count")->isChecked());
        QVERIFY(studio.action("uv.energy.amips")->isChecked());
    }

    void runPausesAndUndoes()
    {
        GridStudio studio;
        flipAFace(studio);
        const int entries = studio.entries();
        QCOMPARE(studio.action("uv.run")->iconText(), u"Run"_s);
        studio.trigger("uv.run");
        QVERIFY(studio.solver.isRunning());
        QCOMPARE(studio.action("uv.run")->iconText(), u"Pause"_s);
        const UvMatrix before = studio.document().uv();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration > 3; }, 60'000));
        QVERIFY(studio.action("edit.undo")->isEnabled());
        studio.trigger("edit.undo");
        QVERIFY(studio.rests());
        QCOMPARE(studio.document().uv(), before);
        QCOMPARE(studio.entries(), entries + 1);
        QVERIFY(studio.action("edit.redo")->isEnabled());
    }

    void viewOptions()
    {
        test::StudioParts studio;
        const ViewOptions &options = studio.view.options();
        QVERIFY(studio.action("view.wireframe")->isChecked());
        studio.trigger("view.wireframe");
        QVERIFY(!options.wireframe && !studio.action("view.wireframe")->isChecked());
        QList<Coloring> colorings;
        for (int i = 0; i < 4; ++i) {
            studio.trigger("view.heatMap");
            colorings << options.coloring;
        }
        QCOMPARE(colorings, QList<Coloring>({Coloring::SignedStretch, Coloring::StretchMagnitude,
                                             Coloring::Density, Coloring::Plain}));
        studio.trigger("view.coloring.paint");
        QCOMPARE(options.coloring, Coloring::PaintWeights);
        studio.trigger("view.texture");
        QCOMPARE(options.pattern, Pattern::Checker);
        studio.trigger("view.texture");
        QCOMPARE(options.pattern, Pattern::Lettered);
        studio.trigger("view.texture");
        QCOMPARE(options.pattern, Pattern::None);
        ViewOptions changed = options;
        changed.rulers = false;
        changed.pattern = Pattern::Checker;
        studio.view.setOptions(changed);
        QVERIFY(!studio.action("view.rulers")->isChecked() &&
                studio.action("view.pattern.checker")->isChecked());
    }

    void texture()
    {
        test::StudioParts studio;
        const QString path = studio.path("Текстура 1.png");
        QVERIFY(QImage(4, 4, QImage::Format_RGB32).save(path));
        studio.answers.filesToOpen = {path};
        studio.trigger("view.pattern.texture");
        QCOMPARE(studio.view.options().texturePath, path);
        QCOMPARE(studio.view.options().pattern, Pattern::Texture);
        studio.trigger("view.texture");
        QCOMPARE(studio.view.options().pattern, Pattern::None);
        // Cancelled: nothing changes, and the menu shows so.
        studio.trigger("view.loadTexture");
        QCOMPARE(studio.view.options().pattern, Pattern::None);
        QVERIFY(studio.action("view.pattern.none")->isChecked());
        studio.answers.filesToOpen = {studio.path("missing.png")};
        studio.trigger("view.loadTexture");
        QCOMPARE(studio.answers.errors.size(), 1);
        QCOMPARE(studio.view.options().texturePath, path);
    }

    void viewsAreArranged()
    {
        test::StudioParts studio;
        ViewActions &view = studio.actions.view();
        QSignalSpy chosen(&view, &ViewActions::layoutChosen), all(&view, &ViewActions::frameAll);
        studio.trigger("view.maximizeUv");
        studio.trigger("view.maximizeUv");
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(view.layout(), ViewLayout::OnlyUv);
        view.setLayout(ViewLayout::Both);
        QVERIFY(studio.action("view.both")->isChecked() && !studio.action("view.maximizeUv")->isChecked());
        studio.workspace.open(test::layoutDocument(test::grid(2)), {});
        studio.trigger("view.frameAll");
        QCOMPARE(all.count(), 1);
    }

    void unsavedChangesAreAskedAbout_data()
    {
        QTest::addColumn<int>("answer");
        QTest::addColumn<QString>("path");
        QTest::addColumn<bool>("left");
        QTest::addColumn<bool>("saved");
        QTest::newRow("save") << int(Questions::Unsaved::Save) << u"a.acproj"_s << true << true;
        QTest::newRow("save, no name") << int(Questions::Unsaved::Save) << QString() << false << false;
        QTest::newRow("save, no folder")
            << int(Questions::Unsaved::Save) << u"no/a.acproj"_s << false << false;
        QTest::newRow("discard") << int(Questions::Unsaved::Discard) << QString() << true << false;
        QTest::newRow("cancel") << int(Questions::Unsaved::Cancel) << QString() << false << false;
    }

    void unsavedChangesAreAskedAbout()
    {
        QFETCH(int, answer);
        QFETCH(QString, path);
        QFETCH(bool, left);
        QFETCH(bool, saved);
        GridStudio studio;
        studio.answers.unsaved = Questions::Unsaved(answer);
        QVERIFY(studio.actions.file().mayClose());
        QCOMPARE(studio.answers.unsavedAsked, 0);
        studio.selectFaces({0});
        studio.trigger("uv.cut");
        const QString file = studio.folder.filePath(path);
        if (!path.isEmpty())
            studio.answers.filesToSave = {file, file};
        QCOMPARE(studio.actions.file().mayClose(), left);
        QCOMPARE(studio.answers.unsavedAsked, 1);
        QCOMPARE(QFile::exists(file) && !path.isEmpty(), saved);
        studio.trigger("file.close");
        QCOMPARE(studio.workspace.document() == nullptr, left);
    }

    void closingAsksWhileTheSolverRuns()
    {
        GridStudio studio;
        flipAFace(studio);
        const int entries = studio.entries();
        QWidget window;
        studio.answers.setWindow(&window);
        window.show();
        studio.trigger("uv.run");
        QVERIFY(QTest::qWaitFor(
            [&] { return studio.solver.map() && studio.solver.map()->uv != studio.document().uv(); },
            test::patience));
        studio.answers.unsaved = Questions::Unsaved::Cancel;
        QVERIFY(!studio.actions.file().mayClose());
        QCOMPARE(studio.answers.unsavedAsked, 1);
        QVERIFY(window.isVisible());
        studio.answers.unsaved = Questions::Unsaved::Discard;
        QVERIFY(studio.actions.file().mayClose());
        // What the solver has found is saved, then the window closes.
        studio.answers.unsaved = Questions::Unsaved::Save;
        const QString file = studio.path("a.acproj");
        studio.answers.filesToSave = {file};
        QVERIFY(!studio.actions.file().mayClose());
        QVERIFY(QTest::qWaitFor([&] { return !window.isVisible(); }, test::patience));
        QVERIFY(!studio.solver.isRunning());
        QCOMPARE(studio.entries(), entries + 1);
        QVERIFY(loadProject(file).value().state.scene.uvSets[0].uv == studio.document().uv());
    }

    void leavingARunningJobIsAsked()
    {
        GridStudio studio;
        const auto waits = [](JobControl &job) {
            while (!job.stop())
                QThread::msleep(1);
            return true;
        };
        QVERIFY(studio.map.jobs().start(QStringLiteral("Unwrapping"), waits, [](bool) {}));
        studio.answers.confirms = false;
        QVERIFY(!studio.actions.file().mayClose());
        studio.trigger("file.close");
        QVERIFY(studio.workspace.document());
        QVERIFY(studio.map.jobs().isBusy());
        QCOMPARE(studio.answers.confirmations.size(), 2);
        studio.answers.confirms = true;
        studio.trigger("file.close");
        QCOMPARE(studio.answers.confirmations.size(), 3);
        QVERIFY(!studio.workspace.document());
        QVERIFY(!studio.map.jobs().isBusy());
        QVERIFY(studio.actions.file().mayClose()); // there is nothing to ask about any more
        QCOMPARE(studio.answers.confirmations.size(), 3);
    }

    void closingWaitsForASave()
    {
        GridStudio studio;
        studio.selectFaces({0});
        studio.trigger("uv.cut");
        const QString file = studio.path("a.acproj");
        studio.answers.filesToSave = {file};
        studio.trigger("file.save");
        QVERIFY(studio.files.isSaving());
        QVERIFY(studio.actions.file().mayClose());
        QCOMPARE(studio.answers.unsavedAsked, 0);
        QVERIFY(loadProject(file).value().state.seams == studio.document().seams());
        // A save that fails meanwhile is a reason to ask.
        studio.trigger("edit.undo");
        studio.files.save(studio.path("no/a.acproj"));
        studio.answers.unsaved = Questions::Unsaved::Cancel;
        QVERIFY(!studio.actions.file().mayClose());
        QCOMPARE(studio.answers.unsavedAsked, 1);
    }

    void saveAndOpen()
    {
        GridStudio studio;
        studio.selectFaces({0});
        studio.trigger("uv.cut");
        const QString file = studio.path("Сессия один.acproj");
        studio.answers.filesToSave = {file};
        studio.trigger("file.save");
        QVERIFY(studio.rests());
        QCOMPARE(studio.workspace.sessionPath(), file);
        QVERIFY(!studio.workspace.isModified());
        QCOMPARE(studio.preferences.lastFolder(), studio.folder.path());
        const DocumentState state = studio.document().state();
        studio.trigger("uv.join");
        studio.trigger("uv.clearSteering");
        studio.trigger("file.save"); // has its name now
        QVERIFY(studio.rests());
        QVERIFY(!studio.workspace.isModified());
        studio.trigger("edit.undo");
        studio.trigger("file.sample.bumpycube");
        QCOMPARE(studio.answers.unsavedAsked, 1);
        QCOMPARE(studio.document().mesh().report.objects, 1);
        studio.answers.filesToOpen = {file};
        studio.trigger("file.open");
        QVERIFY(studio.rests());
        QCOMPARE(studio.workspace.sessionPath(), file);
        QCOMPARE(studio.document().mesh().faceCount(), state.scene.mesh->faceCount());
        QCOMPARE(studio.preferences.recentFiles().first(), file);
        QVERIFY(studio.answers.errors.isEmpty());
    }

    void watchingTheFile()
    {
        GridStudio studio;
        QVERIFY(!studio.action("file.watch")->isEnabled()); // it is from none
        const QString model = studio.path("grid.obj");
        studio.files.exportMesh(model);
        QVERIFY(studio.rests());
        studio.files.open(model);
        QVERIFY(studio.rests());
        FileWatch &watch = studio.actions.file().watch();
        QVERIFY(studio.action("file.watch")->isEnabled() && !studio.action("file.watch")->isChecked());
        studio.trigger("file.watch");
        QVERIFY(studio.action("file.watch")->isChecked() && watch.choice().watches);
        // A file that is there already is replaced only if the user wants it.
        QVERIFY(QFile::copy(model, studio.path("grid_uv.obj")));
        studio.answers.confirms = false;
        studio.trigger("file.exportAgain");
        QCOMPARE(studio.answers.confirmations.size(), 1);
        QVERIFY(!studio.action("file.exportAgain")->isChecked() && !watch.choice().exports);
        studio.answers.confirms = true;
        studio.trigger("file.exportAgain");
        QVERIFY(studio.action("file.exportAgain")->isChecked() && watch.choice().exports);
        studio.trigger("file.exportAgain");
        QVERIFY(!studio.action("file.exportAgain")->isChecked());
        QCOMPARE(studio.answers.confirmations.size(), 2);
        studio.trigger("file.sample.torus");
        QVERIFY(!studio.action("file.watch")->isChecked() && !studio.action("file.watch")->isEnabled());
    }

    void helpOpensTheRecoveryFolder()
    {
        test::StudioParts studio;
        studio.trigger("help.recovery");
        QCOMPARE(studio.answers.folders, QStringList(studio.path("recovery")));
        QVERIFY(QFileInfo(studio.path("recovery")).isDir());
    }
};

QTEST_MAIN(TestActionEffects)

} // namespace tst_actioneffects

#include "tst_actioneffects.moc"
