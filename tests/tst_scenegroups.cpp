// Objects and materials: their faces, tiles and colours.
#include "model/document/materialcolor.h"
#include "model/document/scenegroups.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/obj/objreader.h"
#include "model/io/projects/projectfile.h"
#include "support/editsupport.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_scenegroups {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Three quads in a row: two of the object "a", one of "b"; the materials are none, "red" and "blue".
const char *const quadsObj = "mtllib some.mtl\n"
                             "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
                             "o a\nf 1 2 6 5\nusemtl red\nf 2 3 7 6\no b\nusemtl blue\nf 3 4 8 7\n";

bool write(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

QStringList namesOf(const std::vector<SceneGroup> &groups)
{
    QStringList names;
    for (const SceneGroup &group : groups)
        names << group.name;
    return names;
}

} // namespace

class TestSceneGroups : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void facesAreGrouped()
    {
        const Scene scene = parseObj(quadsObj, u"a.obj"_s).value();
        const std::vector<SceneGroup> objects = sceneGroups(scene, SceneKind::Objects);
        QCOMPARE(namesOf(objects), QStringList({u"a"_s, u"b"_s}));
        QCOMPARE(objects[0].faces, QList<int>({0, 1}));
        const std::vector<SceneGroup> materials = sceneGroups(scene, SceneKind::Materials);
        QCOMPARE(namesOf(materials), QStringList({u"red"_s, u"blue"_s, QString()}));
        QCOMPARE(materials[2].number, -1);
        QCOMPARE(materials[2].faces, QList<int>({0}));
    }

    void sceneWithoutNamesIsOneGroup()
    {
        Scene scene = test::sceneOf(test::grid(2));
        scene.faceMaterial.clear();
        scene.objectNames.clear();
        for (const SceneKind kind : {SceneKind::Objects, SceneKind::Materials}) {
            QCOMPARE(sceneGroups(scene, kind).size(), std::size_t(1));
            QCOMPARE(sceneGroups(scene, kind)[0].faces.size(), 4);
        }
    }

    void islandsGoWhereMostOfThemBelongs()
    {
        const Scene scene = parseObj(quadsObj, u"a.obj"_s).value();
        const std::vector<SceneGroup> objects = sceneGroups(scene, SceneKind::Objects);
        ChartMap whole{{0, 0, 0}, 1};
        QCOMPARE(tilesOfGroups(objects, whole, 1001), std::vector<int>({1001, 1001, 1001}));
        ChartMap apart{{0, 0, 1}, 2};
        QCOMPARE(tilesOfGroups(objects, apart, 1005), std::vector<int>({1005, 1005, 1006}));
        QVERIFY(tilesOfGroups(objects, apart, 9999).empty());
        // What is of two objects is two islands; materials divide nothing.
        const ChartMap divided = dividedByObjects(whole, objects);
        QCOMPARE(divided.count, 2);
        QCOMPARE(tilesOfGroups(objects, divided, 1001), std::vector<int>({1001, 1001, 1002}));
        QCOMPARE(dividedByObjects(whole, sceneGroups(scene, SceneKind::Materials)).count, 1);
    }

    void coloursComeFromTheFile()
    {
        QTemporaryDir folder;
        QVERIFY(write(folder.filePath(u"some.mtl"_s), "newmtl red\nKd 1 0.5 0\nnewmtl green\nKd nan 0 0\n"));
        const QString path = folder.filePath(u"model.obj"_s);
        QVERIFY(write(path, quadsObj));
        Scene scene = readMesh(path).value();
        QCOMPARE(scene.materialColors, (std::vector<QRgb>{qRgb(255, 128, 0), 0}));
        QCOMPARE(shownMaterialColor(scene, 0), qRgb(255, 128, 0));
        QVERIFY(shownMaterialColor(scene, 1) != 0);

        const Document document(std::move(scene));
        ProjectWriter writer;
        const Result<LoadedProject> loaded = parseProject(writer.bytes(document.state(), {}), u"a"_s);
        QVERIFY(loaded->state == document.state());
    }

    //! A model names files; only those beside it are read.
    void filesElsewhereAreNotRead()
    {
        QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir(u"models"_s));
        QVERIFY(write(folder.filePath(u"some.mtl"_s), "newmtl red\nKd 1 0 0\n"));
        const QString path = folder.filePath(u"models/model.obj"_s);
        QVERIFY(write(path, QByteArray(quadsObj).replace("mtllib some.mtl", "mtllib ../some.mtl")));
        const Scene scene = readMesh(path).value();
        QCOMPARE(scene.materialColors, (std::vector<QRgb>{0, 0}));
    }

    void lightIsNotColour()
    {
        QCOMPARE(linearMaterialColor(1, 0, 0.2140411), qRgb(255, 0, 127));
        QCOMPARE(materialColor(2, -1, 0.5), qRgb(255, 0, 128));
        QCOMPARE(materialColor(std::nan(""), 0, 0), QRgb(0));
    }
};

QTEST_APPLESS_MAIN(TestSceneGroups)

} // namespace tst_scenegroups

#include "tst_scenegroups.moc"
