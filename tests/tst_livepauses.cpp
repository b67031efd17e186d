// Stop a live solve at any moment, and the map is valid: what is shown lands in the document.
#include "commands/setseamstate.h"
#include "model/io/meshes/meshfile.h"
#include "model/samples/samples.h"
#include "solver/base/random.h"
#include "solver/metrics/uvmetrics.h"
#include "support/meshbuilders.h"
#include "support/patience.h"
#include "views/control/files/filecontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTest>

namespace tst_livepauses {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int latestPause = 4000; //!< milliseconds

//! Pauses per mesh. $AUTOCUTS_PAUSES asks for more of them, $AUTOCUTS_PAUSE_MESHES for further meshes, and
//! $AUTOCUTS_PAUSE_FOLDER for the maps, to be measured by another program.
int pauses()
{
    const int asked = qEnvironmentVariableIntValue("AUTOCUTS_PAUSES");
    return asked > 0 ? asked : 3;
}

} // namespace

class TestLivePauses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPauseGivesAValidMap_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *sample : {"bumpycube", "character", "torus", "machine"})
            QTest::newRow(sample) << QString::fromLatin1(sample);
        const QString meshes = qEnvironmentVariable("AUTOCUTS_PAUSE_MESHES");
        for (const QString &mesh : meshes.split(u':', Qt::SkipEmptyParts))
            QTest::newRow(qPrintable(mesh)) << mesh;
    }
    void everythingThatIsShownIsAMap_data() { everyPauseGivesAValidMap_data(); }
    //! Also on the way from one map to the next.
    void everythingThatIsShownIsAMap()
    {
        QFETCH(QString, name);
        Workspace workspace;
        ShownMap shown(workspace);
        SolverController solver(workspace, shown);
        const Result<Scene> scene = name.endsWith(u".obj")
                                        ? readMesh(QString::fromStdString(test::meshFolder()) + u'/' + name)
                                        : makeSample(name);
        QVERIFY(scene);
        workspace.open(std::make_unique<Document>(Scene(scene.value())), {});
        const MeshData &mesh = workspace.document()->mesh();
        int seen = 0;
        QStringList problems;
        connect(&shown, &ShownMap::changed, this, [&] {
            UvMatrix uv(mesh.cornerCount(), 2);
            for (int t = 0; t < mesh.triangleCount(); ++t) {
                for (int k = 0; k < 3; ++k)
                    uv.row(mesh.triangles[t][std::size_t(k)]) = shown.uv().row(3 * t + k);
            }
            ++seen;
            const metrics::UvMetrics figures = metrics::measureUv(mesh, uv);
            if (figures.flipped > 0 || figures.overlapPairs > 0)
                problems << u"picture %1: %2 flips, %3 overlaps"_s.arg(seen)
                                .arg(figures.flipped)
                                .arg(figures.overlapPairs);
        });
        solver.run();
        QVERIFY(QTest::qWaitFor([&] { return seen > 1; }, test::patience));
        const auto looksOn = [&] { // for a bounded time
            const int enough = seen + 3;
            (void)QTest::qWaitFor([&] { return seen >= enough; }, 1000);
        };
        looksOn();
        solver.restart();
        const int before = seen;
        QVERIFY(QTest::qWaitFor([&] { return seen > before; }, test::patience));
        looksOn();
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u'\n')));
    }
    //! Begins anew every time; some edges are cut in every second run.
    void everyPauseGivesAValidMap()
    {
        QFETCH(QString, name);
        Workspace workspace;
        ShownMap shown(workspace);
        SolverController solver(workspace, shown);
        const Result<Scene> scene = name.endsWith(u".obj")
                                        ? readMesh(QString::fromStdString(test::meshFolder()) + u'/' + name)
                                        : makeSample(name);
        QVERIFY(scene);
        workspace.open(std::make_unique<Document>(Scene(scene.value())), {});
        Document &document = *workspace.document();
        Random random(1);
        QStringList problems;
        for (int i = 0; i < pauses(); ++i) {
            solver.restart();
            const int wait = static_cast<int>(random.uniform() * random.uniform() * latestPause);
            QTest::qWait(wait / 2);
            if (i % 2) {
                const int pair =
                    static_cast<int>(random.uniform() * document.mesh().cornerPairCount()) / 2 * 2;
                IndexRanges edge;
                edge.append(pair);
                edge.append(pair + 1);
                pushCommand(std::make_unique<SetSeamState>(document, SetSeamState::Edit::Cut, edge));
            }
            QTest::qWait(wait / 2);
            const std::shared_ptr<const unwrap::LiveMapResult> before = solver.map();
            QElapsedTimer sincePause;
            sincePause.start();
            solver.pause();
            QVERIFY(QTest::qWaitFor([&] { return !solver.isPausing(); }, test::patience));
            const qint64 took = sincePause.elapsed();
            const metrics::UvMetrics figures = metrics::measureUv(document.mesh(), document.uv());
            const QString state = u"after %1 ms, pause of %2 ms: D %3, seams %4, charts %5"_s.arg(wait)
                                      .arg(took)
                                      .arg(figures.symDirichlet)
                                      .arg(figures.seamNorm)
                                      .arg(figures.charts);
            if (pauses() > 3)
                qInfo("%s", qPrintable(state));
            if (figures.flipped > 0 || figures.overlapPairs > 0)
                problems << u"%1: %2 flips, %3 overlaps"_s.arg(state)
                                .arg(figures.flipped)
                                .arg(figures.overlapPairs);
            if (before && before->withinBound &&
                figures.symDirichlet > document.solveSettings().maxDistortion + 1e-6)
                problems << u"%1: above the bound again"_s.arg(state);
            if (const QString folder = qEnvironmentVariable("AUTOCUTS_PAUSE_FOLDER"); !folder.isEmpty())
                QVERIFY(writeMesh(sceneForWriting(document),
                                  folder + u"/%1_%2.obj"_s.arg(QFileInfo(name).completeBaseName()).arg(i)));
            if (!solver.map() || document.uv() != solver.map()->uv)
                problems << u"%1: not what was shown"_s.arg(state);
        }
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u'\n')));
    }
};

QTEST_GUILESS_MAIN(TestLivePauses)

} // namespace tst_livepauses

#include "tst_livepauses.moc"
