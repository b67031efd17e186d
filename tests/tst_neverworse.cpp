// Unwrap and the live solve on a map that is good already: none that is worse is shown or kept.
#include "commands/editpins.h"
#include "model/document/makesnapshot.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/unmetsteering.h"
#include "support/editsupport.h"
#include "support/meshbuilders.h"
#include "support/studiosession.h"
#include "views/control/jobs/jobpreview.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTest>

namespace tst_neverworse {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

UvMatrix cornerUvOf(const MeshData &mesh, const UvMatrix &soup)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        uv.row(mesh.cornerOfSoup(s)) = soup.row(s);
    return uv;
}

} // namespace

class TestNeverWorse : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! What a running Unwrap shows in place of a map: only what keeps to the bound and obeys.
    void previewsAreNoWorse_data()
    {
        QTest::addColumn<bool>("hasMap");
        QTest::addColumn<bool>("withinBound");
        QTest::addColumn<int>("unmetPins");
        QTest::addColumn<bool>("shown");
        QTest::newRow("good") << true << true << 0 << true;
        QTest::newRow("too much stretch") << true << false << 0 << false;
        QTest::newRow("off its pins") << true << true << 218 << false;
        QTest::newRow("off one pin") << true << true << 1 << false;
        QTest::newRow("better than none") << false << false << 1 << true;
    }

    void previewsAreNoWorse()
    {
        QFETCH(const bool, hasMap);
        QFETCH(const bool, withinBound);
        QFETCH(const int, unmetPins);
        QFETCH(const bool, shown);
        Workspace workspace;
        Scene scene = test::sceneOf(test::grid(3));
        const std::shared_ptr<const MeshData> mesh = scene.mesh;
        const UvMatrix map = test::splitLayout(*mesh);
        if (hasMap)
            scene.uvSets.push_back({u"map"_s, map});
        workspace.open(std::make_unique<Document>(std::move(scene)), {});
        QCOMPARE(hasUvs(*workspace.document()), hasMap);
        ShownMap shownMap(workspace);
        JobPreview preview(workspace, shownMap);
        unwrap::UnwrapResult result;
        result.uv = 0.5 * map;
        result.withinBound = withinBound;
        for (int pin = 0; pin < unmetPins; ++pin)
            result.unmet.pins.push_back(pin);
        preview.begin()(result);
        QCoreApplication::processEvents();
        QCOMPARE(shownMap.isLive(), shown);
    }

    void pinnedMapsStayGood_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<bool>("live");
        for (const bool live : {false, true}) {
            for (const QString &model : {u"a sphere"_s, u"organic/cathead.obj"_s})
                QTest::newRow(qPrintable(model + (live ? u", live"_s : u", unwrap"_s))) << model << live;
        }
    }

    void pinnedMapsStayGood()
    {
        QFETCH(const QString, model);
        QFETCH(const bool, live);
        StudioSession studio;
        if (model.endsWith(u".obj"_s)) {
            const QString path = QString::fromStdString(test::meshFolder()) + u'/' + model;
            if (!QFileInfo::exists(path))
                QSKIP(test::noMeshes);
            studio.context.files.open(path);
        } else {
            studio.context.workspace.open(std::make_unique<Document>(test::sceneOf(test::sphere(8, 10))), {});
        }
        QVERIFY(studio.jobsRest() && studio.document());
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        Document &document = *studio.document();
        const MeshData &mesh = document.mesh();
        std::vector<UvPin> pins;
        for (int corner = 0; corner < mesh.cornerCount() && pins.size() < 218; ++corner) {
            UvPin pin;
            pin.corner = corner;
            pin.position = document.uv().row(corner);
            pins.push_back(pin);
        }
        QVERIFY(pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Pin, pins)));
        const auto problemOf = [&](const UvMatrix &uv) {
            const metrics::UvMetrics figures = metrics::measureUv(mesh, uv);
            const auto unmet = unwrap::unmetSteering(makeSnapshot(document), uv);
            QString text;
            if (figures.symDirichlet > document.solveSettings().maxDistortion + 1e-6)
                text += u"D %1 "_s.arg(figures.symDirichlet);
            if (figures.flipped > 0)
                text += u"%1 flips "_s.arg(figures.flipped);
            if (figures.overlapAreaRatio > 1e-9)
                text += u"overlaps %1 "_s.arg(figures.overlapAreaRatio);
            if (!unmet.empty())
                text += u"%1 pins"_s.arg(unmet.pins.size());
            return text;
        };
        QCOMPARE(problemOf(document.uv()), QString());
        QStringList problems;
        int seen = 0;
        QElapsedTimer clock;
        clock.start();
        connect(&studio.context.shownMap, &ShownMap::changed, &studio.window, [&] {
            if (!studio.context.shownMap.isLive())
                return;
            ++seen;
            if (const QString problem = problemOf(cornerUvOf(mesh, studio.context.shownMap.uv()));
                !problem.isEmpty())
                problems << u"%1 s: %2"_s.arg(1e-3 * double(clock.elapsed())).arg(problem);
        });
        if (live) {
            studio.press(Qt::Key_Space);
            QVERIFY(QTest::qWaitFor([&] { return seen > 3 || !studio.context.solver.isRunning(); },
                                    test::patience));
            // A bounded look at what comes next.
            (void)QTest::qWaitFor([&] { return seen > 6 || !studio.context.solver.isRunning(); }, 2000);
            studio.context.solver.pause();
            QVERIFY(studio.solverRests());
        } else {
            studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
            QVERIFY(studio.jobsRest());
        }
        qInfo() << seen << "maps," << clock.elapsed() << "ms";
        QCOMPARE(problemOf(document.uv()), QString());
        QCOMPARE(problems.join(u'\n'), QString());
    }
};

QTEST_MAIN(TestNeverWorse)

} // namespace tst_neverworse

#include "tst_neverworse.moc"
