// Steering of polygon meshes while a solve runs: seams, paint and tears never go through a polygon (paper,
// figure 12).
#include "commands/changesettings.h"
#include "model/samples/samplemodels.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "views/tools/painttool.h"

#include <QTest>

#include <algorithm>

namespace tst_quadsteering {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestQuadSteering : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void diagonalsStayWhole_data()
    {
        QTest::addColumn<bool>("live");
        QTest::addColumn<bool>("torus");
        QTest::newRow("torus") << false << true;
        QTest::newRow("torus, live") << true << true;
        QTest::newRow("character") << false << false;
        QTest::newRow("character, live") << true << false;
    }

    void diagonalsStayWhole()
    {
        QFETCH(bool, live);
        QFETCH(bool, torus);
        Canvases studio;
        Scene scene = torus ? test::sceneOf(test::torus(12, 8)) : samples::makeCharacter().toScene();
        Document &document = studio.open(std::make_unique<Document>(std::move(scene)));
        const MeshData &mesh = document.mesh();
        QVERIFY(diagonals(mesh) > 20);
        if (live) {
            SolveSettings settings = document.solveSettings();
            settings.lambda = 0.05;
            settings.delta = 0.01;
            pushCommand(std::make_unique<ChangeSettings>(document, settings));
            studio.solver.setMode(SolveMode::Manual);
            studio.solver.run();
            QTRY_VERIFY_WITH_TIMEOUT(studio.solver.status().iteration > 10, test::patience);
            studio.uv.frameAll();
        }
        std::vector<Canvas *> views{&studio.mesh};
        if (live)
            views.push_back(&studio.uv);
        for (Canvas *view : views) {
            // Clicks everywhere, also on diagonals: what is near is taken.
            for (const QString &tool : {u"cut"_s, u"join"_s}) {
                studio.tools.setTool(tool);
                for (int x = 60; x < 480; x += 35)
                    QTest::mouseClick(view, Qt::LeftButton, {}, {x, x / 2 + 120});
                for (int t = 0; t < mesh.triangleCount(); t += 5)
                    QTest::mouseClick(view, Qt::LeftButton, {}, Canvases::middle(*view, t));
                Canvases::drag(*view, {{120, 130}, {300, 260}, {250, 380}});
            }
            studio.tools.setTool(u"paint"_s);
            Canvases::drag(*view, {{150, 150}, {350, 250}, {200, 350}});
            Canvases::drag(*view, {{350, 150}, {150, 250}}, Qt::ControlModifier);
        }
        if (live)
            tear(studio);
        int cut = 0, painted = 0;
        for (int pair = 0; pair < mesh.cornerPairCount(); ++pair) {
            const PairState state = document.seams().states[pair];
            const double weight = document.seams().weights[pair];
            if (mesh.edgePairs[pair / 2].diagonal) {
                QCOMPARE(state, PairState::Free);
                QCOMPARE(weight, 1.0);
            }
            cut += state != PairState::Free;
            painted += weight != 1;
        }
        QVERIFY(cut > 0);
        QVERIFY(painted > 0);
        if (live)
            polygonsAreWhole(studio);
        QCOMPARE(document.validate(), QString());
    }

private:
    static int diagonals(const MeshData &mesh)
    {
        return static_cast<int>(std::count_if(mesh.edgePairs.begin(), mesh.edgePairs.end(),
                                              [](const EdgePair &pair) { return pair.diagonal; }));
    }

    //! A pull at a face of the running solve, far enough to tear it off.
    static void tear(Canvases &studio)
    {
        studio.select(SelectionMode::Faces);
        studio.tools.setTool(u"drag"_s);
        const QPoint start = Canvases::middle(studio.uv, 7);
        QTest::mousePress(&studio.uv, Qt::LeftButton, {}, start);
        for (int step = 1; step <= 10; ++step) {
            Canvases::moveMouse(studio.uv, start + QPoint(12, 9) * step, Qt::LeftButton);
            // The map follows.
            const int iteration = studio.solver.status().iteration;
            QVERIFY(QTest::qWaitFor([&] { return studio.solver.status().iteration > iteration; }, 20'000));
        }
        QTest::mouseRelease(&studio.uv, Qt::LeftButton, {}, start + QPoint(120, 90));
    }

    //! Live the parts of each polygon hang together; settled each of its corners has one place.
    static void polygonsAreWhole(Canvases &studio)
    {
        const MeshData &mesh = studio.document().mesh();
        const int iteration = studio.solver.status().iteration;
        QTRY_VERIFY_WITH_TIMEOUT(
            studio.solver.status().iteration > iteration + 30 || studio.solver.status().converged, 20'000);
        const auto worst = [&] {
            float most = 0;
            for (int pair = 0; pair < mesh.cornerPairCount(); ++pair) {
                if (mesh.edgePairs[pair / 2].diagonal)
                    most = std::max(most, studio.shown.separation()[pair]);
            }
            return most;
        };
        QVERIFY2(worst() < 0.5f, qPrintable(QString::number(double(worst()))));
        studio.solver.pause();
        QTRY_VERIFY_WITH_TIMEOUT(!studio.solver.isPausing(), test::patience);
        QCOMPARE(worst(), 0.0f);
        const std::vector<int> &face = mesh.triangleFace;
        for (const EdgePair &pair : mesh.edgePairs) {
            if (pair.diagonal)
                QCOMPARE(studio.document().islands().islandOfFace(face[pair.triangle[0]]),
                         studio.document().islands().islandOfFace(face[pair.triangle[1]]));
        }
    }
};

QTEST_MAIN(TestQuadSteering)

} // namespace tst_quadsteering

#include "tst_quadsteering.moc"
