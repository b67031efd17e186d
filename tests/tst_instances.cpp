// Objects that share a mesh, in the studio: figures and reports are those of the file, which has one map.
#include "model/io/instances.h"
#include "model/io/savefile.h"
#include "support/fbxfiles.h"
#include "support/studiosession.h"

#include <QJsonDocument>
#include <QJsonObject>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestInstances : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void figuresAreThoseOfTheFile()
    {
        test::StudioSession session;
        const QString model = session.folder.filePath(u"twins.fbx"_s);
        const std::vector<fbxfiles::Node> mesh =
            fbxfiles::quads({fbxfiles::uvElement(0, "UVMap"), fbxfiles::layer(0, {0})});
        const fbxfiles::Kind kind;
        QVERIFY(saveAtomically(
                    model, fbxfiles::model(
                               kind, {{"One", mesh},
                                      {"Two", {}, {fbxfiles::property(kind, "Lcl Translation", {9, 0, 0})}}}))
                    .ok());
        session.context.files.open(model);
        QVERIFY(session.jobsRest());
        QVERIFY(session.document());
        const int faces = session.document()->mesh().faceCount();
        QCOMPARE(faces, 4); // two of each object
        QVERIFY(session.measured());
        // Both objects have the same UVs, and that is not a fault.
        QVERIFY(session.context.map.figures()->metrics.overlapPairs == 0);
        const QString report = session.folder.filePath(u"twins.json"_s);
        session.context.files.exportReport(report);
        QVERIFY(session.jobsRest());
        const QJsonObject json = QJsonDocument::fromJson(loadFile(report, 1 << 20).value()).object();
        QCOMPARE(json[u"overlap_pairs"_s].toInt(-1), 0);
    }
};

QTEST_MAIN(TestInstances)
#include "tst_instances.moc"
