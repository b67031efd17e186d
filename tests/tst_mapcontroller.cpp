// Jobs on whole maps: results come back as commands.
#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/edituvsets.h"
#include "commands/hidefaces.h"
#include "commands/setislandflags.h"
#include "commands/setuvs.h"
#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "solver/unwrap/unwrap.h"
#include "support/mapstudio.h"
#include "support/meshbuilders.h"
#include "views/control/mapjobs/mapjobs.h"

#include <cstring>
#include <numeric>

namespace tst_mapcontroller {

using namespace autocuts;
using namespace autocuts::metrics;
using namespace autocuts::unwrap;
using Studio = test::MapStudio;

class TestMapController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Base colours are shown with the first set: a new set leaves them right.
    void texturesFitTheFirstSet()
    {
        Studio studio;
        DocumentState state = studio.document().state();
        state.scene.materialNames = {QStringLiteral("paint")};
        state.scene.materialTextures = {{state.scene.materialNames.front(), {}}};
        studio.workspace.open(std::make_unique<Document>(std::move(state)), {});
        studio.layOut(true);
        for (const bool first : {true, false}) {
            QVERIFY(first || pushCommand(std::make_unique<AddUvSet>(studio.document(), QString(), 0)));
            studio.map.pack(PackScope::All);
            QVERIFY(studio.ends());
            QCOMPARE(studio.done.takeLast().at(0).toString().contains(QLatin1String("map before")), first);
        }
    }

    void withoutAMapThereIsNothingToFinish()
    {
        Studio studio;
        studio.map.finish();
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 1);
        QVERIFY(studio.failed.last().at(0).toString().contains(QLatin1String("unwrap first")));
    }

    //! Two faces that hard pins hold on each other: no job takes them apart, and each says so.
    void heldOverlapsAreSaid()
    {
        Studio studio("torus");
        studio.layOut(false);
        const MeshData &mesh = studio.document().mesh();
        UvMatrix uv = studio.document().uv();
        const int corners = mesh.faceStart[1];
        QCOMPARE(mesh.faceStart[2], 2 * corners);
        uv.middleRows(corners, corners) = uv.topRows(corners);
        pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Move, uv));
        std::vector<UvPin> pins;
        for (int c = 0; c < 2 * corners; ++c)
            pins.push_back({c, uv.row(c).transpose()});
        pushCommand(std::make_unique<EditPins>(studio.document(), EditPins::Edit::Pin, pins));
        const auto said = [&] {
            return studio.ends() && studio.failed.count() == 1 &&
                   studio.failed.takeLast().at(0).toString().contains(
                       QLatin1String("hold faces on each other"));
        };
        studio.map.finish();
        QVERIFY(said());
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(said());
    }

    //! Hidden faces are mapped again only if the user says so; that is asked once.
    void hiddenFacesAreAskedAbout()
    {
        Studio studio;
        // A map with longer seams than the bound later needs: otherwise a job would leave it as it is.
        const SolveSettings usual = studio.document().solveSettings();
        SolveSettings tight = usual;
        tight.maxDistortion = 4.01;
        QVERIFY(pushCommand(std::make_unique<ChangeSettings>(studio.document(), tight)));
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.ends());
        QVERIFY(pushCommand(std::make_unique<ChangeSettings>(studio.document(), usual)));
        const MeshData &mesh = studio.document().mesh();
        QList<int> hidden(mesh.faceCount() / 4);
        std::iota(hidden.begin(), hidden.end(), 0);
        std::optional<JobReach> answer;
        int asked = 0;
        studio.map.setHiddenQuestion([&](qsizetype count) {
            ++asked;
            return count == hidden.size() ? answer : std::nullopt;
        });
        const auto hiddenChanged = [&](const UvMatrix &before) {
            return std::any_of(hidden.begin(), hidden.end(), [&](int face) {
                const int first = mesh.faceStart[face], count = mesh.faceStart[face + 1] - first;
                return !sameBits(before.middleRows(first, count),
                                 studio.document().uv().middleRows(first, count));
            });
        };
        QVERIFY(pushCommand(std::make_unique<HideFaces>(studio.document(), hidden)));
        const UvMatrix before = studio.document().uv();
        studio.map.unwrap(UnwrapQuality::Draft); // not wanted
        QVERIFY(!studio.map.jobs().isBusy());
        QCOMPARE(asked, 1);
        answer = JobReach::Shown;
        studio.done.clear();
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.ends());
        QVERIFY(!hiddenChanged(before));
        QVERIFY(
            studio.done.last().at(0).toString().contains(QLatin1String("Hidden faces stay as they were")));
        QCOMPARE(studio.stack().undoText(), QStringLiteral("Unwrap"));
        studio.map.unwrap(UnwrapQuality::Draft);
        studio.map.cancel();
        QVERIFY(studio.ends());
        QCOMPARE(asked, 2);
        QVERIFY(!hiddenChanged(before));
        // Once all is shown, the answer is forgotten.
        QVERIFY(pushCommand(std::make_unique<HideFaces>(studio.document(), QList<int>())));
        studio.map.unwrap(UnwrapQuality::Draft);
        studio.map.cancel();
        QVERIFY(studio.ends());
        QVERIFY(pushCommand(std::make_unique<HideFaces>(studio.document(), hidden)));
        answer = JobReach::All;
        studio.map.finish();
        studio.map.cancel();
        QCOMPARE(asked, 3);
    }

    //! Every job, one after the other, on a map in which one island is locked and another has a hard pin.
    void handWorkStaysThroughAllJobs()
    {
        Studio studio("machine");
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.ends());
        QCOMPARE(studio.stack().undoText(), QStringLiteral("Unwrap"));
        const auto faces = findCharts(studio.document().mesh(), studio.document().uv()).faces();
        Selection first;
        first.mode = SelectionMode::Faces;
        first.faces = QList<int>(faces[0].begin(), faces[0].end());
        studio.document().setSelection(first);
        studio.map.unwrap(UnwrapQuality::Draft, JobReach::SelectionFree);
        QVERIFY(studio.ends());
        QCOMPARE(studio.stack().undoText(), QStringLiteral("Unwrap selection"));
        studio.stack().undo();
        studio.document().setSelection({});
        pushCommand(std::make_unique<SetIslandFlags>(studio.document(), SetIslandFlags::Edit::Lock,
                                                     std::vector<int>{0}));
        const MeshData &mesh = studio.document().mesh();
        const int pinned = mesh.faceStart[faces[1].front()];
        const Vec2 place = Vec2(studio.document().uv().row(pinned)) + Vec2(0.01, 0.02);
        pushCommand(std::make_unique<EditPins>(studio.document(), EditPins::Edit::Pin,
                                               std::vector<UvPin>{{pinned, place, true, 1}}));
        const UvMatrix before = studio.document().uv();
        const auto obeys = [&](bool reshapes) {
            for (const int face : faces[0]) {
                for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
                    if (std::memcmp(Vec2(studio.document().uv().row(c)).data(), Vec2(before.row(c)).data(),
                                    sizeof(Vec2)) != 0)
                        return false;
                }
            }
            const bool onPin = (Vec2(studio.document().uv().row(pinned)) - place).norm() <= 1e-6;
            return studio.document().constraints().pins.front().position == place && (onPin || !reshapes);
        };
        studio.map.pack(PackScope::All);
        QVERIFY(studio.ends());
        QVERIFY(obeys(false));
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.ends());
        QVERIFY(obeys(true));
        studio.map.finish();
        QVERIFY(studio.ends());
        QVERIFY(obeys(true));
        studio.map.separateOverlaps();
        QVERIFY(studio.ends());
        QVERIFY(obeys(true));
        studio.map.equalizeDensity();
        QVERIFY(studio.ends());
        QVERIFY(obeys(true));
        studio.solver.setLiveView(LiveView::Soup);
        studio.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration >= 5; }, test::patience));
        studio.solver.pause();
        QVERIFY(QTest::qWaitFor([&] { return !studio.solver.isPausing(); }, test::patience));
        QVERIFY(obeys(true));
    }

    void unwrappingGivesAMapFitForUse()
    {
        Studio studio;
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.map.jobs().isBusy());
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        QCOMPARE(studio.stack().count(), 1);
        QVERIFY(studio.measures());
        const UvMetrics &metrics = studio.map.figures()->metrics;
        QCOMPARE(metrics.flipped, 0);
        QCOMPARE(metrics.overlapPairs, 0);
        QVERIFY(metrics.symDirichlet <= 4.2);
        QVERIFY(metrics.inUnitSquare);
        QVERIFY(studio.map.figures()->overlapping.empty());
        studio.stack().undo();
        QVERIFY(!studio.document().uv().allFinite());
    }

    void missingSymmetryIsSaid()
    {
        Studio studio;
        Scene scene;
        scene.mesh = test::polygonMesh({{0, 0, 0}, {3, 0, 0}, {0.5, 2, 0}, {1, 0.7, 1.5}},
                                       {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
        DocumentState state = DocumentState::initial(std::move(scene));
        state.solveSettings.symmetry = SymmetryMode::On;
        studio.workspace.open(Document::create(std::move(state)).value(), {});
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 1);
        const QString said = studio.failed.first().first().toString();
        QVERIFY2(said.contains(QStringLiteral("not symmetric")), qPrintable(said));
        QVERIFY(studio.document().uv().allFinite());
    }

    void finishingMakesALiveMapFinal_data()
    {
        QTest::addColumn<int>("steps");
        QTest::newRow("paused at once") << 3; // all is torn then
        QTest::newRow("paused on the way") << 60;
    }
    void finishingMakesALiveMapFinal()
    {
        QFETCH(int, steps);
        Studio studio;
        studio.solver.setLiveView(LiveView::Soup);
        studio.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration > steps; }, test::patience));
        studio.map.finish();
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        QCOMPARE(studio.stack().count(), 2); // the run, and its finish
        QVERIFY(!studio.solver.isRunning());
        QVERIFY(!studio.shown.isLive());
        QVERIFY(studio.measures());
        QCOMPARE(studio.map.figures()->metrics.flipped, 0);
        QCOMPARE(studio.map.figures()->metrics.overlapPairs, 0);
        QVERIFY(studio.map.figures()->metrics.symDirichlet <= 4.5);
    }

    //! Where the soup is shown, its seams are finished, those of the definite map otherwise.
    void finishingStartsFromWhatIsShown()
    {
        Studio studio;
        studio.solver.setLiveView(LiveView::Soup);
        studio.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration > 3; }, test::patience));
        MapInput input;
        studio.solver.whenPaused([&] {
            const Document &document = studio.document();
            input.snapshot = makeSnapshot(document);
            input.uv = document.uv();
            input.uvScale = document.uvScale();
            input.packing = document.packingSettings();
            input.live = {studio.solver.soup(), !studio.solver.status().converged};
        });
        studio.map.finish();
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        QVERIFY(input.live.result);
        JobControl control;
        QVERIFY(studio.document().uv() == finishJob(input, control).uv);
    }

    //! The solve itself has to get to its end first.
    void finishingASolveIntoARectangle()
    {
        Studio studio;
        LayoutRectangle box;
        box.lower = Vec2(0.1, 0.3);
        box.upper = Vec2(0.9, 0.7);
        box.weight = 100; // as in the paper's figure 8; a weak box may be left by more
        for (int face = 0; face < studio.document().mesh().faceCount(); ++face)
            box.faces << face;
        pushCommand(EditRectangles::add(studio.document(), box));
        studio.solver.setLiveView(LiveView::Soup);
        studio.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration > 10; }, test::patience));
        studio.map.finish();
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        QVERIFY(studio.measures());
        const UvMetrics &metrics = studio.map.figures()->metrics;
        QCOMPARE(metrics.flipped, 0);
        QCOMPARE(metrics.overlapPairsSameChart, 0);
        QVERIFY2(metrics.charts <= 8, qPrintable(QString::number(metrics.charts)));
        const UvMatrix &uv = studio.document().uv();
        const double side = (box.upper - box.lower).minCoeff();
        for (int axis = 0; axis < 2; ++axis) {
            QVERIFY(uv.col(axis).minCoeff() > box.lower[axis] - 0.01 * side);
            QVERIFY(uv.col(axis).maxCoeff() < box.upper[axis] + 0.01 * side);
        }
    }

    void finishingAMapDoesNotMakeItWorse()
    {
        Studio studio;
        studio.map.unwrap(UnwrapQuality::Draft);
        QVERIFY(studio.ends() && studio.measures());
        const double seams = studio.map.figures()->metrics.seamNorm;
        studio.done.clear();
        studio.map.finish();
        QVERIFY(studio.ends() && studio.measures());
        const UvMetrics &metrics = studio.map.figures()->metrics;
        QVERIFY2(metrics.seamNorm <= seams * (1 + 1e-9),
                 qPrintable(QString::number(metrics.seamNorm / seams)));
        QVERIFY(metrics.symDirichlet <= 4.2);
        QCOMPARE(metrics.overlapPairs, 0);
    }

    void overlapsAreFoundAndTakenApart_data()
    {
        QTest::addColumn<bool>("greedily");
        QTest::newRow("along short seams") << false;
        QTest::newRow("greedily") << true;
    }
    void overlapsAreFoundAndTakenApart()
    {
        QFETCH(bool, greedily);
        Studio studio("machine");
        studio.layOut(true);
        QVERIFY(studio.measures());
        QVERIFY(studio.map.figures()->metrics.overlapPairs > 0);
        QVERIFY(!studio.map.figures()->overlapping.empty());
        QVERIFY(!studio.map.figures()->overlapPairs.empty());
        greedily ? studio.map.separateGreedily() : studio.map.separateOverlaps();
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        QVERIFY(studio.measures());
        QCOMPARE(studio.map.figures()->metrics.overlapPairs, 0);
        QVERIFY(studio.map.figures()->metrics.inUnitSquare);
    }

    void lockedIslandsStayAndStacksStayTogether()
    {
        Studio studio("machine");
        studio.layOut(false);
        Document &document = studio.document();
        const MeshData &mesh = document.mesh();
        const Islands &islands = document.islands();
        QVERIFY(islands.count() > 4);
        // Island 0 is locked; 1 and 2 are a stack.
        const QList<int> locked(islands.faces(0).begin(), islands.faces(0).end());
        using Edit = SetIslandFlags::Edit;
        QVERIFY(pushCommand(std::make_unique<SetIslandFlags>(document, Edit::Lock, std::vector<int>{0})));
        QVERIFY(pushCommand(std::make_unique<SetIslandFlags>(document, Edit::Stack, std::vector<int>{1, 2})));
        const UvMatrix before = document.uv();
        const int first = mesh.faceStart[islands.faces(1).front()];
        const int second = mesh.faceStart[islands.faces(2).front()];
        const double distance = (before.row(first) - before.row(second)).norm();
        const double side = (before.row(first) - before.row(first + 1)).norm();
        studio.map.pack(PackScope::All);
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        const UvMatrix &after = document.uv();
        for (int face : locked) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                QVERIFY(after.row(c) == before.row(c));
        }
        const double scale = (after.row(first) - after.row(first + 1)).norm() / side;
        QVERIFY(std::abs((after.row(first) - after.row(second)).norm() - scale * distance) < 1e-9);
    }

    void packingASelectionLeavesTheOthers()
    {
        Studio studio("machine");
        studio.layOut(false);
        Document &document = studio.document();
        Selection selection;
        selection.faces = {0, 1, 2, 3};
        document.setSelection(selection);
        const UvMatrix before = document.uv();
        studio.map.pack(PackScope::Selection);
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 0);
        const MeshData &mesh = document.mesh();
        int moved = 0;
        const std::vector<int> selected = document.islands().islandsOf(selection.faces);
        QCOMPARE(studio.stack().undoText(), QStringLiteral("Pack %1 islands").arg(selected.size()));
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const bool isSelected =
                std::binary_search(selected.begin(), selected.end(), document.islands().islandOfFace(f));
            const int c = mesh.faceStart[f];
            if (!isSelected)
                QVERIFY(document.uv().row(c) == before.row(c));
            else
                moved += document.uv().row(c) != before.row(c);
        }
        QVERIFY(moved > 0);
    }

    void densityIsMadeEqual()
    {
        Studio studio("machine");
        studio.layOut(false);
        UvMatrix uv = studio.document().uv();
        for (int c = 0; c < 3; ++c)
            uv.row(c) *= 0.25;
        pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Scale, uv));
        QVERIFY(studio.measures());
        QVERIFY(studio.map.figures()->metrics.texelDensitySpread > 1.01);
        studio.map.equalizeDensity();
        QVERIFY(studio.ends() && studio.measures());
        QVERIFY(studio.map.figures()->metrics.texelDensitySpread < 1.0001);
        QCOMPARE(studio.failed.count(), 0);
    }

    void overlapsThatEqualisingMakesAreSaid()
    {
        Studio studio("machine");
        studio.layOut(false);
        // A small island beside another one.
        UvMatrix uv = studio.document().uv();
        const int end = studio.document().mesh().faceStart[1];
        const Eigen::RowVector2d shift =
            uv.row(end) - 0.05 * uv.row(0) - Eigen::RowVector2d(studio.cell() / 60, 0);
        for (int c = 0; c < end; ++c)
            uv.row(c) = 0.05 * uv.row(c) + shift;
        pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Scale, uv));
        studio.map.equalizeDensity();
        QVERIFY(studio.ends());
        QCOMPARE(studio.failed.count(), 1);
        const auto message = studio.failed.first().first().toString();
        QVERIFY2(message.contains(QStringLiteral("did not before")), qPrintable(message));
        QVERIFY(studio.failed.first().at(1).value<Selection>().faces.contains(0));
        QVERIFY(studio.measures());
        QVERIFY(studio.map.figures()->metrics.overlapPairs > 0);
    }
};

QTEST_GUILESS_MAIN(TestMapController)

} // namespace tst_mapcontroller

#include "tst_mapcontroller.moc"
