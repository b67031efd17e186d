// What the UV view draws while the solver runs: the numbers of each frame are a valid map. Islands of the map
// before, which shine through, glide over each other, but none is flipped.
#include "solver/metrics/uvmetrics.h"
#include "support/meshbuilders.h"
#include "support/studiosession.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/uvview.h"
#include "views/gl/soupbuffers.h"

#include <QFileInfo>
#include <QTest>

#include <cmath>

namespace tst_drawnmaps {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

//! NaN where nothing is drawn. \param drawn two numbers per soup corner, as the graphics card gets them
UvMatrix cornerUvOf(const MeshData &mesh, const std::vector<float> &drawn)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (std::size_t s = 0; 2 * s < drawn.size(); ++s)
        uv.row(mesh.cornerOfSoup(static_cast<int>(s))) << double(drawn[2 * s]), double(drawn[2 * s + 1]);
    return (uv.array() == double(noUv)).select(std::nan(""), uv);
}

//! What is wrong with a drawn map; empty: nothing. Numbers of single precision overlap by rounding.
QString problemOf(const MeshData &mesh, const std::vector<float> &drawn)
{
    const UvMatrix uv = cornerUvOf(mesh, drawn);
    const metrics::UvMetrics figures = metrics::measureUv(mesh, uv);
    return figures.flipped == 0 && figures.overlapAreaRatio < 1e-6
               ? QString()
               : u"%1 flips, overlaps %2"_s.arg(figures.flipped).arg(figures.overlapAreaRatio);
}

} // namespace

class TestDrawnMaps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFrameOfASolveIsAMap_data()
    {
        QTest::addColumn<QString>("model");
        for (const QString &sample : {u"bumpycube"_s, u"character"_s, u"torus"_s, u"machine"_s})
            QTest::newRow(qPrintable(sample)) << sample;
        for (const QString &file : {u"organic/camel_simple.obj"_s, u"polygons/suzanne.obj"_s})
            QTest::newRow(qPrintable(file))
                << QString(QString::fromStdString(test::meshFolder()) + u'/' + file);
    }

    void everyFrameOfASolveIsAMap()
    {
        QFETCH(const QString, model);
        const bool isFile = model.endsWith(u".obj"_s);
        if (isFile && !QFileInfo::exists(model))
            QSKIP(test::noMeshes);
        StudioSession studio;
        if (isFile)
            studio.context.files.open(model);
        else
            studio.context.files.openSample(model);
        QVERIFY(studio.jobsRest() && studio.document());
        const MeshData &mesh = studio.document()->mesh();
        UvView &view = studio.window.uvView();
        int seen = 0, maps = 0;
        QStringList problems;
        connect(&studio.context.shownMap, &ShownMap::changed, &view,
                [&] { maps += studio.context.shownMap.isLive(); });
        connect(&view, &QOpenGLWidget::frameSwapped, &view, [&] {
            if (!studio.context.shownMap.isLive())
                return;
            ++seen;
            if (const QString problem = problemOf(mesh, view.content().uvs()); !problem.isEmpty())
                problems << u"frame %1: %2"_s.arg(seen).arg(problem);
            if (!view.content().ghostUvs().empty()) {
                const UvMatrix ghost = cornerUvOf(mesh, view.content().ghostUvs());
                if (const auto flipped = metrics::measureUv(mesh, ghost).flipped; flipped > 0)
                    problems << u"behind frame %1: %2 flips"_s.arg(seen).arg(flipped);
            }
        });
        //! Until islands have glided to another map, and a bounded look at what comes then.
        const auto looksOn = [&](int mapsToSee) {
            const int enough = maps + mapsToSee, few = seen + 3;
            const bool saw = QTest::qWaitFor([&] { return maps >= enough && seen > few; }, test::patience);
            (void)QTest::qWaitFor([&] { return maps > enough && seen > few + 30; }, 1500);
            return saw;
        };
        studio.press(Qt::Key_Space);
        QVERIFY(looksOn(2));
        studio.action("uv.restart")->trigger();
        QVERIFY(looksOn(1)); // after the one before
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u'\n')));
        studio.context.solver.pause();
        QVERIFY(studio.solverRests());
        QCOMPARE(problemOf(mesh, view.content().uvs()), QString());
    }
};

QTEST_MAIN(TestDrawnMaps)

} // namespace tst_drawnmaps

#include "tst_drawnmaps.moc"
