// OBJ files: byte identity, and what changes with the UVs.
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/obj/objreader.h"
#include "model/io/obj/objrewriter.h"
#include "model/io/obj/objwriter.h"
#include "model/plain/uvlayout.h"
#include "support/meshbuilders.h"
#include "support/objcases.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstring>

namespace tst_objio {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

bool isUvLine(const QByteArray &line)
{
    return line.startsWith("vt ") || line.startsWith("vt\t") || line.startsWith("f ") ||
           line.startsWith("f\t");
}

//! The lines without vt lines; of f lines only the vertex and normal indices.
QByteArray withoutUvs(const QByteArray &bytes)
{
    QByteArray result;
    for (QByteArray line : bytes.split('\n')) {
        if (line.startsWith("vt"))
            continue;
        if (isUvLine(line)) {
            QByteArray stripped;
            int slashes = 0;
            for (char c : line) {
                if (c == '/')
                    ++slashes;
                else if (c == ' ' || c == '\t' || c == '\r')
                    slashes = 0;
                if (slashes != 1)
                    stripped += c == '/' ? '|' : c;
            }
            line = stripped;
        }
        result += line + '\n';
    }
    return result;
}

QStringList realMeshes()
{
    QStringList files;
    const std::string folder = test::meshFolder();
    if (folder.empty())
        return files;
    QDirIterator it(QString::fromStdString(folder), {QStringLiteral("*.obj")}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext())
        files << it.next();
    files.sort();
    return files;
}

} // namespace

class TestObjIo : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readingStops();
    void unchangedIsByteIdentical_data();
    void unchangedIsByteIdentical();
    void realMeshesAreByteIdentical();
    void readsWhatTheFileSays();
    void textureVertexForms();
    void changedUvsChangeOnlyUvLines();
    void realMeshesChangeOnlyUvLines();
    void exactTextAfterAChange_data();
    void exactTextAfterAChange();
    void missingUvsStayMissing();
    void weldedCornersShareTextureVertices();
    void savingTwiceDoesNotGrow();
    void skippedFacesStayInTheFile();
    void plainObjFromOtherScenes();
    void pathsInAnyAlphabet();
};

void TestObjIo::readingStops()
{
    const std::atomic<bool> stop = true;
    const Result<Scene> scene = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", u"a.obj"_s, &stop);
    QVERIFY(!scene.ok());
    QCOMPARE(scene.error().message, u"reading was cancelled"_s);
    QCOMPARE(scene.error().file, u"a.obj"_s);
}

void TestObjIo::unchangedIsByteIdentical_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("plain") << test::triangleObj;
    QTest::newRow("nasty") << test::nastyObj;
    QTest::newRow("crlf") << QByteArray(test::nastyObj).replace("\r\n", "\n").replace("\n", "\r\n");
    QTest::newRow("cr only") << QByteArray(test::triangleObj).replace("\n", "\r");
    QTest::newRow("no newline at the end") << test::triangleObj.chopped(1);
    QTest::newRow("byte order mark") << "\xEF\xBB\xBF" + test::triangleObj;
    QTest::newRow("degenerate only") << QByteArray("v 0 0 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
    QTest::newRow("nan texture vertex")
        << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt nan 0\nvt inf 1\nvt -nan(ind) 2\nf 1/1 2/2 3/3\n");
    QTest::newRow("curve") << test::triangleObj +
                                  "cstype bezier\ndeg 3\ncurv 0.0 1.0 1 2 3 1\nparm u 0 \\\n 1\nend\n";
    QTest::newRow("forward references") << QByteArray("f 1/1 2/1 3/1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n");
}

void TestObjIo::unchangedIsByteIdentical()
{
    QFETCH(QByteArray, bytes);
    const Scene scene = test::parsed(bytes);
    QCOMPARE(QString::fromStdString(scene.mesh->validate()), QString());
    QCOMPARE(objBytes(scene), bytes);

    // Also after new UVs were put in and the old ones back.
    Scene changed = scene;
    test::setNewUvs(changed);
    QVERIFY(objBytes(changed) != bytes);
    changed.uvSets = scene.uvSets;
    QCOMPARE(objBytes(changed), bytes);
}

void TestObjIo::realMeshesAreByteIdentical()
{
    const QStringList files = realMeshes();
    if (files.isEmpty())
        QSKIP(test::noMeshes);
    QTemporaryDir folder;
    for (const QString &path : files) {
        const Result<Scene> scene = readMesh(path);
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        const QString copy = folder.filePath(QStringLiteral("copy.obj"));
        QVERIFY(writeMesh(scene.value(), copy).ok());
        QVERIFY2(test::contentOf(copy) == test::contentOf(path), qPrintable(path));
    }
}

void TestObjIo::readsWhatTheFileSays()
{
    const Scene scene = test::parsed(test::nastyObj);
    const MeshData &mesh = *scene.mesh;
    QCOMPARE(mesh.vertexCount(), 4);
    QCOMPARE(mesh.faceCount(), 5);
    QCOMPARE(mesh.cornerCount(), 16);
    QCOMPARE(mesh.positions(1, 0), 1.5);
    QCOMPARE(mesh.positions(2, 1), 1.0);
    QCOMPARE(scene.objectNames,
             (std::vector<QString>{QStringLiteral("First  thing"), QStringLiteral("second")}));
    QCOMPARE(mesh.faceObject, (std::vector<int>{0, 0, 0, 1, 1}));
    QCOMPARE(scene.materialNames, (std::vector<QString>{QStringLiteral("red"), QStringLiteral("blue")}));
    QCOMPARE(scene.faceMaterial, (std::vector<int>{0, 0, 1, 1, 1}));
    QCOMPARE(std::vector<int>(mesh.cornerVertex.begin() + 3, mesh.cornerVertex.begin() + 10),
             (std::vector<int>{0, 2, 3, 0, 1, 2, 3}));
    QCOMPARE(scene.uvSets.size(), std::size_t(1));
    const UvMatrix &uv = scene.uvSets[0].uv;
    QCOMPARE(uv.rows(), 16);
    QCOMPARE(uv(0, 0), 0.25);
    QCOMPARE(uv(1, 0), 0.5);
    QCOMPARE(uv(1, 1), 0.0);
    QCOMPARE(uv(3, 1), 0.5);
    QCOMPARE(uv(5, 1), 1.0);
    QVERIFY(!uv.row(6).allFinite());
    QVERIFY(scene.notes.empty());
}

void TestObjIo::textureVertexForms()
{
    const Scene scene =
        test::parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5\nvt 0.25 0.75 9\nvt nan 1\nf 1/1 2/2 3/3\n");
    const UvMatrix &uv = scene.uvSets.at(0).uv;
    QCOMPARE(uv(0, 0), 0.5);
    QCOMPARE(uv(0, 1), 0.0);
    QCOMPARE(uv(1, 1), 0.75);
    QVERIFY(!uv.row(2).allFinite());
    QCOMPARE(scene.notes.size(), std::size_t(2));
    QVERIFY(test::parsed(test::triangleObj).uvSets.empty());
}

void TestObjIo::changedUvsChangeOnlyUvLines()
{
    for (const bool crlf : {false, true}) {
        const QByteArray lf = QByteArray(test::nastyObj).replace("\r\n", "\n");
        const QByteArray bytes = crlf ? QByteArray(lf).replace("\n", "\r\n") : lf;
        Scene scene = test::parsed(bytes);
        test::setNewUvs(scene);
        const QByteArray changed = objBytes(scene);
        QVERIFY(changed != bytes);
        QCOMPARE(changed.count('\n') == changed.count("\r\n"), crlf);
        const Scene again = test::parsed(changed);
        QVERIFY(sameBits(again.uvSets.at(0).uv, scene.uvSets.at(0).uv));
        QCOMPARE(again.mesh->cornerVertex, scene.mesh->cornerVertex);
        // What is written between the lines that may differ is the same.
        scene.uvSets.clear();
        QVERIFY(!objBytes(scene).contains("vt"));
        Scene stripped = again;
        stripped.uvSets.clear();
        QCOMPARE(objBytes(stripped), objBytes(scene));
        QByteArray expected = bytes;
        for (const char *vt : {"vt 0.25 0.5", "vt .5", "vt 1 1 0.0", "vt 0 1 # last"})
            expected.replace(QByteArray(vt) + (crlf ? "\r\n" : "\n"), "");
        expected.replace("1/1/1", "1//1").replace("2/2/1", "2//1").replace("3/3/1", "3//1");
        expected.replace("-4/-4/-1 -2/-2/-1 -1/-1/-1", "-4//-1 -2//-1 -1//-1").replace("1/ 3/ 4/", "1 3 4");
        QCOMPARE(objBytes(scene), expected);
    }
}

void TestObjIo::realMeshesChangeOnlyUvLines()
{
    const QStringList files = realMeshes();
    if (files.isEmpty())
        QSKIP(test::noMeshes);
    for (const QString &path : files) {
        Result<Scene> scene = readMesh(path);
        QVERIFY(scene.ok());
        test::setNewUvs(scene.value());
        const QByteArray changed = objBytes(scene.value());
        const Scene again = test::parsed(changed);
        QVERIFY2(sameBits(again.uvSets.at(0).uv, scene->uvSets.at(0).uv), qPrintable(path));
        // "1" and "1//" may become "1/7" and back: compare with slashes around empty parts removed.
        auto normal = [](QByteArray text) {
            return text.replace("||", "|").replace("| ", " ").replace("|\n", "\n").replace("|\r", "\r");
        };
        QVERIFY2(normal(withoutUvs(changed)) == normal(withoutUvs(test::contentOf(path))), qPrintable(path));
    }
}

void TestObjIo::exactTextAfterAChange_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    const QByteArray v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    // The new UV of vertex i (from 0) is i / 4, i / 2.
    const QByteArray vts = "vt 0 0\nvt 0.25 0.5\nvt 0.5 1\n";
    QTest::newRow("none before") << v + "g a\nf 1 2 3\n# end\n"
                                 << v + "g a\n" + vts + "f 1/1 2/2 3/3\n# end\n";
    QTest::newRow("in place of the old ones")
        << "vt 9 9\n# c\n" + v + "g a\nf 1/1 2/1 3/1" << vts + "# c\n" + v + "g a\nf 1/1 2/2 3/3";
    QTest::newRow("in two places") << v + "vt 9 9\nf 1/1 2/1 3/1\no b\nvt 8 8\nvt 7 7\nf 3/-1 2/-1 1/-2\n"
                                   << v + vts + "f 1/1 2/2 3/3\no b\nf 3/3 2/2 1/1\n";
    QTest::newRow("each where it is needed")
        << v + "v 1 1 0\nvt 9 9\nf 1/1 2/1 3/1\no b\nvt 8 8\nf 2/2 4/2 3/2\n"
        << v + "v 1 1 0\n" + vts + "f 1/1 2/2 3/3\no b\nvt 0.75 1.5\nf 2/2 4/4 3/3\n";
    QTest::newRow("line element keeps its vt") << v + "vt 9 9\nvt 8 8\nvt 7 7\nl 1/2 2/1\nf 1/1 2/2 3/3\n"
                                               << v + "vt 9 9\nvt 8 8\n" + vts + "l 1/2 2/1\nf 1/3 2/4 3/5\n";
    QTest::newRow("relative line element after the faces")
        << v + "vt 9 9\nf 1/1 2/1 3/1\nvt 8 8\nl 1/-2 2/-1\nvt 7 7\n"
        << v + "vt 9 9\nf 1/3 2/4 3/5\nvt 8 8\nl 1/-2 2/-1\n" + vts;
    QTest::newRow("kept vt in the last line")
        << v + "f 1 2 3\nl 1/1 2/1\nvt 9 9" << v + "f 1/2 2/3 3/4\nl 1/1 2/1\nvt 9 9\n" + vts;
    QTest::newRow("byte order mark") << "\xEF\xBB\xBF"
                                        "f 1 2 3\n" +
                                            v
                                     << "\xEF\xBB\xBF" + vts + "f 1/1 2/2 3/3\n" + v;
}

void TestObjIo::exactTextAfterAChange()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    Scene scene = test::parsed(before);
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (int c = 0; c < scene.mesh->cornerCount(); ++c)
        uv.row(c) << scene.mesh->cornerVertex[c] / 4.0, scene.mesh->cornerVertex[c] / 2.0;
    scene.uvSets = {{QString(), uv}};
    QCOMPARE(objBytes(scene), after);
    QVERIFY(sameBits(test::parsed(after).uvSets.at(0).uv, uv));
}

void TestObjIo::missingUvsStayMissing()
{
    Scene scene =
        test::parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 3/1 2/1 1/1\n");
    scene.uvSets[0].uv.bottomRows(3).fill(std::numeric_limits<double>::quiet_NaN());
    scene.uvSets[0].uv(0, 0) = 0.5;
    QCOMPARE(objBytes(scene), QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 1\nvt 1 1\nvn 0 0 1\n"
                                         "f 1/1/1 2/2/1 3/3/1\nf 3 2 1\n")
                                  .replace("vt 1 1\n", "vt 1 1\nvt 1 1\n"));
}

void TestObjIo::weldedCornersShareTextureVertices()
{
    // Vertices 1 and 4 are at one place.
    Scene scene = test::parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\nf 4 3 2\n");
    test::setNewUvs(scene);
    QCOMPARE(objBytes(scene).count("vt "), 3);
    scene.uvSets[0].uv(3, 0) += 0.5;
    QCOMPARE(objBytes(scene).count("vt "), 4);
    // Zero and minus zero are two numbers.
    scene.uvSets[0].uv(3, 0) = 0.0;
    scene.uvSets[0].uv(0, 0) = -0.0;
    QCOMPARE(objBytes(scene).count("vt "), 4);
    QVERIFY(sameBits(test::parsed(objBytes(scene)).uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestObjIo::savingTwiceDoesNotGrow()
{
    Scene scene = test::parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nl 1/1 2/1\nf 1/1 2/1 3/1\n");
    test::setNewUvs(scene);
    const QByteArray once = objBytes(scene);
    Scene again = test::parsed(once);
    again.uvSets[0].uv.array() += 0.5;
    QCOMPARE(objBytes(again).count('\n'), once.count('\n'));
    again = test::parsed(objBytes(again));
    again.uvSets = scene.uvSets;
    QCOMPARE(objBytes(again), once);
}

void TestObjIo::skippedFacesStayInTheFile()
{
    const QByteArray bytes =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1\nf 1/1 2/1 3/1\nf 3/1 3/1 3/1 1/1\nf\n";
    Scene scene = test::parsed(bytes);
    QCOMPARE(scene.mesh->faceCount(), 1);
    QCOMPARE(scene.notes.size(), std::size_t(1));
    QVERIFY(scene.notes[0].contains(QLatin1String("3 face(s)")) &&
            scene.notes[0].contains(QLatin1String("line 5")));
    QCOMPARE(objBytes(scene), bytes);
    test::setNewUvs(scene);
    const QByteArray changed = objBytes(scene);
    QVERIFY(changed.contains("\nf 1 2\nf 1/1 2/2 3/3\nf 3 3 3 1\nf\n"));
    QVERIFY(sameBits(test::parsed(changed).uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestObjIo::plainObjFromOtherScenes()
{
    Scene scene;
    scene.mesh = test::quadCube();
    scene.objectNames = {QStringLiteral("the cube")};
    scene.materialNames = {QStringLiteral("red")};
    scene.faceMaterial = {-1, -1, 0, 0, -1, 0};
    QCOMPARE(objBytes(scene).count("vt "), 0);
    test::setNewUvs(scene);
    const Scene again = test::parsed(objBytes(scene));
    QCOMPARE(again.mesh->positions, scene.mesh->positions);
    QCOMPARE(again.mesh->cornerVertex, scene.mesh->cornerVertex);
    QCOMPARE(again.objectNames, scene.objectNames);
    QCOMPARE(again.faceMaterial, scene.faceMaterial);
    QVERIFY(sameBits(again.uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestObjIo::pathsInAnyAlphabet()
{
    QTemporaryDir folder;
    const QString name = QString::fromUtf8("\xd0\xbc\xd0\xbe\xd0\xb4\xd0\xb5\xd0\xbb\xd1\x8c with spaces");
    QVERIFY(QDir(folder.path()).mkdir(name));
    const QString path = folder.filePath(name + QLatin1Char('/') + name + QStringLiteral(".OBJ"));
    QVERIFY(writeMesh(test::parsed(test::nastyObj), path).ok());
    QCOMPARE(test::contentOf(path), test::nastyObj);
    QCOMPARE(readMesh(path).value().mesh->faceCount(), 5);
}

QTEST_APPLESS_MAIN(TestObjIo)

} // namespace tst_objio

#include "tst_objio.moc"
