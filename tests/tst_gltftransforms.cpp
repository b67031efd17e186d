// Where nodes are in new glTF files.
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "support/colladafiles.h"
#include "support/gltffiles.h"

#include <QTemporaryDir>
#include <QTest>

namespace tst_gltftransforms {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::viewsDae;
using test::worldBox;

namespace {

const QByteArray movingLamp =
    "<library_animations><animation><source id=\"t\"><float_array id=\"ta\" count=\"2\">0 1</float_array>"
    "<technique_common><accessor source=\"#ta\" count=\"2\" stride=\"1\"><param name=\"TIME\" "
    "type=\"float\"/>"
    "</accessor></technique_common></source><source id=\"m\"><float_array id=\"ma\" count=\"6\">0 0 0 1 2 3"
    "</float_array><technique_common><accessor source=\"#ma\" count=\"2\" stride=\"3\"><param name=\"X\" "
    "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
    "</technique_common></source><source id=\"i\"><Name_array id=\"ia\" count=\"2\">LINEAR "
    "LINEAR</Name_array>"
    "<technique_common><accessor source=\"#ia\" count=\"2\" stride=\"1\"><param name=\"INTERPOLATION\" "
    "type=\"name\"/></accessor></technique_common></source><sampler id=\"sa\"><input semantic=\"INPUT\" "
    "source=\"#t\"/><input semantic=\"OUTPUT\" source=\"#m\"/><input semantic=\"INTERPOLATION\" "
    "source=\"#i\"/></sampler><channel source=\"#sa\" target=\"n3/place\"/></animation></library_animations>";

} // namespace

class TestGltfTransforms : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Assimp takes what is within a hundredth of the identity for it.
    void smallDistancesStayInGltf_data()
    {
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<bool>("moves");
        QTest::newRow("unit") << QByteArray("1.004") << QByteArray() << false;
        for (const bool moves : {false, true}) {
            const char *animated = moves ? ", beside what moves" : "";
            QTest::addRow("place%s", animated)
                << QByteArray("1") << QByteArray("<translate>0.005 0 -0.009</translate>") << moves;
            QTest::addRow("scale and place%s", animated)
                << QByteArray("1")
                << QByteArray("<translate>0 0.007 0</translate><scale>1.006 0.995 1</scale>") << moves;
            QTest::addRow("turn%s", animated)
                << QByteArray("1") << QByteArray("<rotate>0 0 1 0.4</rotate>") << moves;
        }
    }

    void smallDistancesStayInGltf()
    {
        QFETCH(QByteArray, unit);
        QFETCH(QByteArray, place);
        QFETCH(bool, moves);
        QByteArray dae = viewsDae();
        dae.replace("Z_UP", "Y_UP");
        dae.replace("0.01", unit);
        dae.replace("name=\"Box\">", "name=\"Box\">" + place);
        if (moves)
            dae.replace("name=\"Lamp\">", "name=\"Lamp\"><translate sid=\"place\">0 0 0</translate>")
                .replace("<library_visual_scenes>", movingLamp + "<library_visual_scenes>");
        QVERIFY(saveAtomically(at(u"a.dae"_s), dae).ok());
        const Scene scene = readMesh(at(u"a.dae"_s)).value();
        QVERIFY(writeMesh(scene, at(u"a.glb"_s)).ok());
        const Scene copy = readMesh(at(u"a.glb"_s)).value();
        QCOMPARE(gltffiles::jsonOf(gltffiles::contentOf(at(u"a.glb"_s))).contains("animations"), moves);
        const auto [lower, upper] = worldBox(copy);
        const auto [wantedLower, wantedUpper] = worldBox(scene);
        QVERIFY((lower - wantedLower).norm() < 1e-4 && (upper - wantedUpper).norm() < 1e-4);
    }

private:
    QString at(const QString &name) const { return mFolder.filePath(name); }

    QTemporaryDir mFolder;
};

QTEST_GUILESS_MAIN(TestGltfTransforms)

} // namespace tst_gltftransforms

#include "tst_gltftransforms.moc"
