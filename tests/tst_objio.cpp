// OBJ files: byte identity, what changes with the UVs, bad input, atomic saving, mutated files.
#include "model/io/meshfile.h"
#include "model/io/objreader.h"
#include "model/io/objrewriter.h"
#include "model/io/objwriter.h"
#include "model/io/savefile.h"
#include "support/meshbuilders.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstring>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#endif

using namespace autocuts;

namespace {

Scene parsed(const QByteArray &bytes)
{
    Result<Scene> scene = parseObj(bytes, QStringLiteral("test.obj"));
    if (!scene)
        qFatal("%s", qPrintable(scene.error().toString()));
    return std::move(scene).value();
}

//! Replaces the active UV set by numbers that need all their digits; a UV per vertex, so that corners share.
void setNewUvs(Scene &scene)
{
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (int c = 0; c < scene.mesh->cornerCount(); ++c) {
        const int v = scene.mesh->vertexWeld[scene.mesh->cornerVertex[c]];
        uv.row(c) << 1.0 / (v + 3), std::sqrt(v + 0.1) * 1e-3;
    }
    scene.uvSets = {{QStringLiteral("UVMap"), uv}};
}

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

bool sameBits(const UvMatrix &a, const UvMatrix &b)
{
    return a.rows() == b.rows() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
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

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be opened");
}

const QByteArray triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray nastyObj = "# comment, \xd0\xbf\xd1\x80\xd0\xb8\xd0\xb2\xd0\xb5\xd1\x82 C:\\path\\\n"
                            "mtllib my materials.mtl\n\n"
                            "o  First  thing \n"
                            "v  0.000 -0.0 +0\r\n"
                            "v 1.50 0 0 0.1 0.2 0.3\n"
                            "v 1e0 1 \\\n  0\n"
                            "\tv 0 1 0 1.0\n"
                            "vt 0.25 0.5\nvt .5\nvt 1 1 0.0\n# between\nvt 0 1 # last\n"
                            "vn 0 0 1\n"
                            "vp 0.3 0.4\n"
                            "g group one\ns 1\nusemtl red\n"
                            "f 1/1/1  2/2/1\t3/3/1 # tail\n"
                            "f -4/-4/-1 -2/-2/-1 -1/-1/-1\n"
                            "s off\nusemtl blue\n"
                            "f 1//1 \\\n   2//1 \\\n 3//1 4//1   \n"
                            "o second\nf 1 2 4\n"
                            "p 1 2\nunknown statement 1/2/3\nf 1/ 3/ 4/\n  # end";

} // namespace

class TestObjIo : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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
    void badInput_data();
    void badInput();
    void badFiles();
    void badTargets();
    void fullDiskLeavesTheOldFile();
    void pathsInAnyAlphabet();
    void mutatedFilesNeverCrash();
};

void TestObjIo::unchangedIsByteIdentical_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("plain") << triangleObj;
    QTest::newRow("nasty") << nastyObj;
    QTest::newRow("crlf") << QByteArray(nastyObj).replace("\r\n", "\n").replace("\n", "\r\n");
    QTest::newRow("cr only") << QByteArray(triangleObj).replace("\n", "\r");
    QTest::newRow("no newline at the end") << triangleObj.chopped(1);
    QTest::newRow("byte order mark") << "\xEF\xBB\xBF" + triangleObj;
    QTest::newRow("degenerate only") << QByteArray("v 0 0 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
    QTest::newRow("nan texture vertex")
        << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt nan 0\nvt inf 1\nvt -nan(ind) 2\nf 1/1 2/2 3/3\n");
    QTest::newRow("curve") << triangleObj +
                                  "cstype bezier\ndeg 3\ncurv 0.0 1.0 1 2 3 1\nparm u 0 \\\n 1\nend\n";
    QTest::newRow("forward references") << QByteArray("f 1/1 2/1 3/1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n");
}

void TestObjIo::unchangedIsByteIdentical()
{
    QFETCH(QByteArray, bytes);
    const Scene scene = parsed(bytes);
    QCOMPARE(QString::fromStdString(scene.mesh->validate()), QString());
    QCOMPARE(objBytes(scene), bytes);

    // Also after new UVs were put in and the old ones back.
    Scene changed = scene;
    setNewUvs(changed);
    QVERIFY(objBytes(changed) != bytes);
    changed.uvSets = scene.uvSets;
    QCOMPARE(objBytes(changed), bytes);
}

void TestObjIo::realMeshesAreByteIdentical()
{
    const QStringList files = realMeshes();
    if (files.isEmpty())
        QSKIP("no folder of real meshes");
    QTemporaryDir folder;
    for (const QString &path : files) {
        const Result<Scene> scene = readMesh(path);
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        const QString copy = folder.filePath(QStringLiteral("copy.obj"));
        QVERIFY(writeMesh(scene.value(), copy).ok());
        QVERIFY2(contentOf(copy) == contentOf(path), qPrintable(path));
    }
}

void TestObjIo::readsWhatTheFileSays()
{
    const Scene scene = parsed(nastyObj);
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
        parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5\nvt 0.25 0.75 9\nvt nan 1\nf 1/1 2/2 3/3\n");
    const UvMatrix &uv = scene.uvSets.at(0).uv;
    QCOMPARE(uv(0, 0), 0.5);
    QCOMPARE(uv(0, 1), 0.0);
    QCOMPARE(uv(1, 1), 0.75);
    QVERIFY(!uv.row(2).allFinite());
    QCOMPARE(scene.notes.size(), std::size_t(2));
    QVERIFY(parsed(triangleObj).uvSets.empty());
}

void TestObjIo::changedUvsChangeOnlyUvLines()
{
    for (const bool crlf : {false, true}) {
        const QByteArray lf = QByteArray(nastyObj).replace("\r\n", "\n");
        const QByteArray bytes = crlf ? QByteArray(lf).replace("\n", "\r\n") : lf;
        Scene scene = parsed(bytes);
        setNewUvs(scene);
        const QByteArray changed = objBytes(scene);
        QVERIFY(changed != bytes);
        QCOMPARE(changed.count('\n') == changed.count("\r\n"), crlf);
        const Scene again = parsed(changed);
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
        QSKIP("no folder of real meshes");
    for (const QString &path : files) {
        Result<Scene> scene = readMesh(path);
        QVERIFY(scene.ok());
        setNewUvs(scene.value());
        const QByteArray changed = objBytes(scene.value());
        const Scene again = parsed(changed);
        QVERIFY2(sameBits(again.uvSets.at(0).uv, scene->uvSets.at(0).uv), qPrintable(path));
        // "1" and "1//" may become "1/7" and back: compare with slashes around empty parts removed.
        auto normal = [](QByteArray text) {
            return text.replace("||", "|").replace("| ", " ").replace("|\n", "\n").replace("|\r", "\r");
        };
        QVERIFY2(normal(withoutUvs(changed)) == normal(withoutUvs(contentOf(path))), qPrintable(path));
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
    Scene scene = parsed(before);
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (int c = 0; c < scene.mesh->cornerCount(); ++c)
        uv.row(c) << scene.mesh->cornerVertex[c] / 4.0, scene.mesh->cornerVertex[c] / 2.0;
    scene.uvSets = {{QString(), uv}};
    QCOMPARE(objBytes(scene), after);
    QVERIFY(sameBits(parsed(after).uvSets.at(0).uv, uv));
}

void TestObjIo::missingUvsStayMissing()
{
    Scene scene = parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 3/1 2/1 1/1\n");
    scene.uvSets[0].uv.bottomRows(3).fill(std::numeric_limits<double>::quiet_NaN());
    scene.uvSets[0].uv(0, 0) = 0.5;
    QCOMPARE(objBytes(scene), QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 1\nvt 1 1\nvn 0 0 1\n"
                                         "f 1/1/1 2/2/1 3/3/1\nf 3 2 1\n")
                                  .replace("vt 1 1\n", "vt 1 1\nvt 1 1\n"));
}

void TestObjIo::weldedCornersShareTextureVertices()
{
    // Vertices 1 and 4 are at one place.
    Scene scene = parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\nf 4 3 2\n");
    setNewUvs(scene);
    QCOMPARE(objBytes(scene).count("vt "), 3);
    scene.uvSets[0].uv(3, 0) += 0.5;
    QCOMPARE(objBytes(scene).count("vt "), 4);
    // Zero and minus zero are two numbers.
    scene.uvSets[0].uv(3, 0) = 0.0;
    scene.uvSets[0].uv(0, 0) = -0.0;
    QCOMPARE(objBytes(scene).count("vt "), 4);
    QVERIFY(sameBits(parsed(objBytes(scene)).uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestObjIo::savingTwiceDoesNotGrow()
{
    Scene scene = parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nl 1/1 2/1\nf 1/1 2/1 3/1\n");
    setNewUvs(scene);
    const QByteArray once = objBytes(scene);
    Scene again = parsed(once);
    again.uvSets[0].uv.array() += 0.5;
    QCOMPARE(objBytes(again).count('\n'), once.count('\n'));
    again = parsed(objBytes(again));
    again.uvSets = scene.uvSets;
    QCOMPARE(objBytes(again), once);
}

void TestObjIo::skippedFacesStayInTheFile()
{
    const QByteArray bytes =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1\nf 1/1 2/1 3/1\nf 3/1 3/1 3/1 1/1\nf\n";
    Scene scene = parsed(bytes);
    QCOMPARE(scene.mesh->faceCount(), 1);
    QCOMPARE(scene.notes.size(), std::size_t(1));
    QVERIFY(scene.notes[0].contains(QLatin1String("3 face(s)")) &&
            scene.notes[0].contains(QLatin1String("line 5")));
    QCOMPARE(objBytes(scene), bytes);
    setNewUvs(scene);
    const QByteArray changed = objBytes(scene);
    QVERIFY(changed.contains("\nf 1 2\nf 1/1 2/2 3/3\nf 3 3 3 1\nf\n"));
    QVERIFY(sameBits(parsed(changed).uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestObjIo::plainObjFromOtherScenes()
{
    Scene scene;
    scene.mesh = test::quadCube();
    scene.objectNames = {QStringLiteral("the cube")};
    scene.materialNames = {QStringLiteral("red")};
    scene.faceMaterial = {-1, -1, 0, 0, -1, 0};
    QCOMPARE(objBytes(scene).count("vt "), 0);
    setNewUvs(scene);
    const Scene again = parsed(objBytes(scene));
    QCOMPARE(again.mesh->positions, scene.mesh->positions);
    QCOMPARE(again.mesh->cornerVertex, scene.mesh->cornerVertex);
    QCOMPARE(again.objectNames, scene.objectNames);
    QCOMPARE(again.faceMaterial, scene.faceMaterial);
    QVERIFY(sameBits(again.uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestObjIo::badInput_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("message");
    const QByteArray v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto row = [](const char *name, const QByteArray &bytes, int line, const char *message) {
        QTest::newRow(name) << bytes << line << QString::fromLatin1(message);
    };
    row("empty", "", 0, "empty");
    row("binary", QByteArray("v 0 0 0\n\0\1\2\3", 12), 2, "binary");
    row("garbage", "\x89PNG\r\n\x1a\nhello", 0, "no faces");
    row("no faces", v, 0, "no faces");
    row("only a two-sided face", v + "f 1 2\n", 0, "no faces");
    row("nan", "v 0 nan 0\n", 1, "not finite");
    row("infinite", v + "v 0 0 -inf\n", 4, "not finite");
    row("overflow", v + "v 0 0 1e400\n", 4, "not finite");
    row("too large", v + "v 0 0 1e200\n", 4, "too large");
    row("no number", v + "v 0 zero 0\n", 4, "not a number");
    row("decimal comma", v + "v 0,5 0 0\n", 4, "not a number");
    row("visual c++ nan", v + "v 1.#QNAN 0 0\n", 4, "not a number");
    row("short vertex", v + "v 0 1", 4, "fewer than three");
    row("empty texture vertex", v + "vt\n", 4, "no coordinates");
    row("bad texture vertex", v + "vt a b\n", 4, "not a number");
    row("index zero", v + "f 0 1 2\n", 4, "vertex index \"0\"");
    row("index too high", v + "f 1 2 3\nf 1 2 4\n", 5, "vertex 4, but the file has only 3");
    row("index too low", v + "f -1 -2 -4\n", 4, "vertex index \"-4\"");
    row("index not whole", v + "f 1 2 3.5\n", 4, "vertex index \"3.5\"");
    row("index beyond 64 bit", v + "f 1 2 99999999999999999999\n", 4, "vertex index");
    row("index beyond 32 bit", v + "f 1 2 4294967297\n", 4, "vertex index");
    row("texture index", v + "vt 0 0\nf 1/1 2/1 3/2\n", 5, "texture vertex 2, but the file has only 1");
    row("texture index zero", v + "vt 0 0\nf 1/0 2/1 3/1\n", 5, "texture vertex index");
    row("relative before the first", v + "f 1/-1 2/-1 3/-1\n", 4, "texture vertex index");
    row("four indices", v + "f 1/1/1/1 2 3\n", 4, "more than three indices");
    row("after a continued line", v + "# x\nv 1 \\\n 2 \\\n 3\nf 1 2 9\n", 8, "vertex 9");
    row("truncated face", v + "f 1 2 3\nf 1 2", 5, "middle of a face");
    row("crlf line count", QByteArray("v 0 0 0\r\n\r\nv x 0 0\r\n"), 3, "not a number");
}

void TestObjIo::badInput()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, line);
    QFETCH(QString, message);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("bad.obj"));
    QVERIFY(saveAtomically(path, bytes).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(!scene.ok());
    const Error &error = scene.error();
    QVERIFY2(error.message.contains(message), qPrintable(error.message));
    QCOMPARE(error.line, line);
    QCOMPARE(error.file, path);
    QVERIFY(!error.remedy.isEmpty());
    QVERIFY(!error.toString().contains(QLatin1Char('\n')));
}

void TestObjIo::badFiles()
{
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("folder.obj")));
    const auto message = [](const QString &path) {
        const Result<Scene> scene = readMesh(path);
        return scene.ok() ? QStringLiteral("it was read") : scene.error().toString();
    };
    QVERIFY(message(folder.filePath(QStringLiteral("missing.obj"))).contains(QLatin1String("no such file")));
    QVERIFY(message(folder.filePath(QStringLiteral("missing.ply"))).contains(QLatin1String("no such file")));
    QVERIFY(message(folder.filePath(QStringLiteral("folder.obj"))).contains(QLatin1String("folder")));
    QVERIFY(message(QStringLiteral("model.xyz")).contains(QLatin1String("obj, ply, stl")));
    QVERIFY(message(QStringLiteral("model")).contains(QLatin1String("without a suffix")));
#ifdef Q_OS_UNIX
    const QString secret = folder.filePath(QStringLiteral("secret.obj"));
    QVERIFY(saveAtomically(secret, triangleObj).ok());
    QFile::setPermissions(secret, {});
    QFile file(secret);
    if (!file.open(QIODevice::ReadOnly))
        QVERIFY(message(secret).contains(QLatin1String("permissions")));
    QVERIFY(QFile::link(QStringLiteral("/dev/zero"), folder.filePath(QStringLiteral("device.obj"))));
    QVERIFY(message(folder.filePath(QStringLiteral("device.obj"))).contains(QLatin1String("regular file")));
#endif
}

void TestObjIo::badTargets()
{
    QTemporaryDir folder;
    const Scene scene = parsed(triangleObj);
    const auto message = [&](const QString &path) {
        const Result<Done> done = writeMesh(scene, path);
        return done.ok() ? QStringLiteral("it was written") : done.error().toString();
    };
    QVERIFY(
        message(folder.filePath(QStringLiteral("no/where.obj"))).contains(QLatin1String("does not exist")));
    QVERIFY(message(folder.filePath(QStringLiteral("a.stl"))).contains(QLatin1String("cannot hold UVs")));
    QVERIFY(message(folder.filePath(QStringLiteral("a.abc"))).contains(QLatin1String("obj, glb")));
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("folder.obj")));
    QVERIFY(message(folder.filePath(QStringLiteral("folder.obj"))).contains(QLatin1String("folder")));
    const QString file = folder.filePath(QStringLiteral("file"));
    QVERIFY(saveAtomically(file, "x").ok());
    QVERIFY(message(file + QStringLiteral("/below.obj")).contains(QLatin1String("does not exist")));
#ifdef Q_OS_LINUX
    QVERIFY(message(QStringLiteral("/proc/a.obj")).contains(QLatin1String("cannot be written")));
    QVERIFY(QFile::link(QStringLiteral("/dev/null"), folder.filePath(QStringLiteral("null.obj"))));
    QVERIFY(message(folder.filePath(QStringLiteral("null.obj"))).contains(QLatin1String("regular file")));
#endif
    // A read-only file: root may write it all the same.
    const QString kept = folder.filePath(QStringLiteral("kept.obj"));
    QVERIFY(saveAtomically(kept, "old").ok());
    QFile::setPermissions(kept, QFileDevice::ReadOwner);
    if (!QFileInfo(kept).isWritable()) {
        QVERIFY(message(kept).contains(QLatin1String("permissions")));
        QCOMPARE(contentOf(kept), QByteArray("old"));
    }
}

void TestObjIo::fullDiskLeavesTheOldFile()
{
#ifdef Q_OS_UNIX
    // A limit on the size of files makes writes fail as a full disk does, late and in the middle.
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("out.obj"));
    QVERIFY(saveAtomically(path, "old content").ok());
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{5000, before.rlim_max};
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    // One that fits the write buffer and fails when it is flushed, and one that does not.
    const bool buffered = saveAtomically(path, QByteArray(6000, 'x')).ok();
    const bool direct = saveAtomically(path, QByteArray(600000, 'x')).ok();
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY(!buffered);
    QVERIFY(!direct);
    QCOMPARE(contentOf(path), QByteArray("old content"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
#else
    QSKIP("no file size limit on this system");
#endif
}

void TestObjIo::pathsInAnyAlphabet()
{
    QTemporaryDir folder;
    const QString name = QString::fromUtf8("\xd0\xbc\xd0\xbe\xd0\xb4\xd0\xb5\xd0\xbb\xd1\x8c with spaces");
    QVERIFY(QDir(folder.path()).mkdir(name));
    const QString path = folder.filePath(name + QLatin1Char('/') + name + QStringLiteral(".OBJ"));
    QVERIFY(writeMesh(parsed(nastyObj), path).ok());
    QCOMPARE(contentOf(path), nastyObj);
    QCOMPARE(readMesh(path).value().mesh->faceCount(), 5);
}

void TestObjIo::mutatedFilesNeverCrash()
{
    std::uint64_t state = 1;
    const auto random = [&state](std::uint64_t n) {
        state += 0x9E3779B97F4A7C15ull;
        std::uint64_t z = state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return static_cast<qsizetype>((z ^ (z >> 31)) % n);
    };
    const QByteArrayList snippets{"/",
                                  "//",
                                  "-",
                                  "\\",
                                  "\n",
                                  "\\\n",
                                  "\r",
                                  "nan",
                                  "f ",
                                  "vt ",
                                  "l 1/1 2/-1\n",
                                  "#",
                                  "99999999999",
                                  "1e999",
                                  "v 0 0 1\n",
                                  " ",
                                  QByteArray(1, '\0')};
    const QByteArrayList seeds{nastyObj, triangleObj,
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nl 1/1 2/1\nf 1/1 2/1 3/1\n"};
    int valid = 0;
    for (int i = 0; i < 6000; ++i) {
        QByteArray bytes = seeds[random(3)];
        for (qsizetype n = random(4) + 1; n > 0; --n) {
            const qsizetype at = random(bytes.size());
            switch (random(4)) {
            case 0:
                bytes.remove(at, random(8));
                break;
            case 1:
                bytes.insert(at, snippets[random(snippets.size())]);
                break;
            case 2:
                bytes[at] = static_cast<char>(random(255) + 1);
                break;
            default:
                bytes.insert(at, bytes.mid(random(bytes.size()), random(30)));
                break;
            }
            if (bytes.isEmpty())
                bytes = triangleObj;
        }
        Result<Scene> scene = parseObj(bytes, QString());
        if (!scene)
            continue;
        ++valid;
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        QVERIFY(objBytes(scene.value()) == bytes);
        setNewUvs(scene.value());
        const Result<Scene> again = parseObj(objBytes(scene.value()), QString());
        QVERIFY2(again.ok(), again ? "" : qPrintable(again.error().toString() + QString::fromUtf8(bytes)));
        QVERIFY2(sameBits(again->uvSets.at(0).uv, scene->uvSets[0].uv), bytes.constData());
        QCOMPARE(again->mesh->cornerVertex, scene->mesh->cornerVertex);
        QCOMPARE(again->faceMaterial, scene->faceMaterial);
    }
    QVERIFY(valid > 1000);
}

QTEST_APPLESS_MAIN(TestObjIo)
#include "tst_objio.moc"
