// Objects that share a mesh, in the studio: figures and reports are those of the file, which has one map.
#include "commands/newmap.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "support/fbxfiles.h"
#include "support/studiosession.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <memory>

namespace tst_instances {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Two objects with one mesh of two quads.
QByteArray twins()
{
    const fbxfiles::Kind kind;
    return fbxfiles::model(
        kind, {{"One", fbxfiles::quads({fbxfiles::uvElement(0, "UVMap"), fbxfiles::layer(0, {0})})},
               {"Two", {}, {fbxfiles::property(kind, "Lcl Translation", {9, 0, 0})}}});
}

metrics::UvMetrics metricsOf(const Scene &file)
{
    metrics::UvMetricsOptions options;
    options.faceFlags = withInstanceStacks(file, {});
    return metrics::measureUv(*file.mesh, file.uvSets.front().uv, options);
}

} // namespace

class TestInstances : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mSession = std::make_unique<test::StudioSession>();
        mModel = mSession->folder.filePath(u"twins.fbx"_s);
        QVERIFY(saveAtomically(mModel, twins()).ok());
        mSession->context.files.open(mModel);
        QVERIFY(mSession->jobsRest());
        QVERIFY(mSession->document());
        QCOMPARE(mSession->document()->mesh().faceCount(), 4); // two of each object
        QVERIFY(mSession->measured());
    }

    void figuresAreThoseOfTheFile()
    {
        // Both objects have the same UVs, and that is not a fault.
        QCOMPARE(figures().metrics.overlapPairs, 0);
        QCOMPARE(report()[u"overlap_pairs"_s].toInt(-1), 0);
    }

    void figuresAfterJobs_data()
    {
        QTest::addColumn<QString>("action");
        for (const char *action : {"uv.separate", "uv.unwrap", "uv.pack"})
            QTest::newRow(action) << QString::fromLatin1(action);
    }
    //! The studio says what is in the file that it writes then.
    void figuresAfterJobs()
    {
        QFETCH(QString, action);
        for (const bool unique : {false, true}) {
            if (unique)
                mSession->action("uv.makeUnique")->trigger();
            mSession->action(action.toLatin1().constData())->trigger();
            QVERIFY(mSession->jobsRest());
            QVERIFY(mSession->measured());
            const metrics::UvMetrics said = figures().metrics, is = metricsOf(exported());
            QCOMPARE(said.charts, is.charts);
            QCOMPARE(said.overlapPairs, is.overlapPairs);
            QCOMPARE(said.overlapPairs, 0);
            QCOMPARE(said.stackedPairs, is.stackedPairs);
            QCOMPARE(said.stackedPairs > 0, !unique);
            QCOMPARE(said.tiles.size(), is.tiles.size());
            QVERIFY(std::abs(said.packingUnit - is.packingUnit) < 1e-6);
            const QJsonObject json = report();
            QCOMPARE(json[u"overlap_pairs"_s].toInt(-1), is.overlapPairs);
            QCOMPARE(json[u"charts"_s].toInt(-1), is.charts);
        }
    }

    //! Lists of islands are those of the document, which the user works on.
    void islandsOfTheDocument()
    {
        Document &document = *mSession->document();
        UvMatrix uv = document.uv();
        uv.topRows(8) *= 0.5;                       // the map of the file
        uv.bottomRows(4).array() += 3;              // a quad of the other object lies apart
        uv.middleRows(8, 4).col(0).array() += 0.75; // and its other quad on the border of a tile
        QVERIFY(pushCommand(newMapCommand(document, UvEdit::Move, uv)));
        QVERIFY(mSession->measured());
        QCOMPARE(document.islands().count(), 3);
        QCOMPARE(figures().metrics.charts, 2);
        QCOMPARE(figures().islandDistortion.size(), std::size_t(3));
        for (const auto &[island, tile] : figures().islandsOffTile)
            QVERIFY(island < 3);
        QCOMPARE(figures().metrics.chartsOffTile.size(), std::size_t(0));
        QVERIFY(!figures().islandsOffTile.empty());
    }

    void makingUnique()
    {
        QAction *action = mSession->action("uv.makeUnique");
        action->trigger();
        QVERIFY(mSession->document()->state().scene.uniqueMeshes);
        QVERIFY(!mSession->context.map.figuresAreFresh());
        QVERIFY(mSession->measured());
        // What they had shared lies on each other now, and that is a fault.
        QVERIFY(figures().metrics.overlapPairs > 0);
        QVERIFY(!hasSharedMeshes(exported()));
        action->trigger();
        QCOMPARE(mSession->document()->undoStack().count(), 1);
        mSession->document()->undoStack().undo();
        QVERIFY(mSession->measured());
        QCOMPARE(figures().metrics.overlapPairs, 0);
        QVERIFY(hasSharedMeshes(exported()));
    }

    //! A changed version of the model shares its meshes as before; the session wants unique ones.
    void relinking()
    {
        mSession->action("uv.makeUnique")->trigger();
        mSession->context.files.relink(mModel);
        QVERIFY(mSession->jobsRest());
        QVERIFY(mSession->document()->state().scene.uniqueMeshes);
    }

private:
    const MapFigures &figures() const { return *mSession->context.map.figures(); }
    QJsonObject report()
    {
        const QString path = mSession->folder.filePath(u"twins.json"_s);
        mSession->context.files.exportReport(path);
        [[maybe_unused]] const bool rest = mSession->jobsRest();
        return QJsonDocument::fromJson(loadFile(path, 1 << 20).value()).object();
    }
    Scene exported()
    {
        const QString path = mSession->folder.filePath(u"out.fbx"_s);
        mSession->context.files.exportMesh(path);
        [[maybe_unused]] const bool rest = mSession->jobsRest();
        return readMesh(path).value();
    }

    std::unique_ptr<test::StudioSession> mSession;
    QString mModel;
};

QTEST_MAIN(TestInstances)

} // namespace tst_instances

#include "tst_instances.moc"
