// Whole sessions of an artist on real meshes, with real events in the real window.
#include "model/io/meshes/meshfile.h"
#include "model/samples/samples.h"
#include "support/artistsession.h"
#include "support/meshbuilders.h"

#include <QTest>

namespace tst_artistsession {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestArtistSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wholeSession_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::newRow("fish, quads") << u"polygons/fish_control_mesh.obj"_s;
        QTest::newRow("bishop") << u"organic/bishop_part.obj"_s;
        QTest::newRow("spot, quads") << u"polygons/spot_control_mesh.obj"_s;
    }
    void wholeSession()
    {
        QFETCH(QString, mesh);
        if (test::meshFolder().empty())
            QSKIP(test::noMeshes);
        const QString file = QString::fromStdString(test::meshFolder()) + u'/' + mesh;
        test::Artist artist({1100, 750});
        const QString problem = test::runArtistSession(artist, file);
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
    }

    void sampleSession()
    {
        test::Artist artist({1100, 750});
        const QString file = artist.studio.folder.filePath(u"sample.obj"_s);
        const Result<Scene> scene = makeSample(u"character"_s);
        QVERIFY(scene && writeMesh(scene.value(), file));
        const QString problem = test::runArtistSession(artist, file);
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
    }
};

QTEST_MAIN(TestArtistSession)

} // namespace tst_artistsession

#include "tst_artistsession.moc"
