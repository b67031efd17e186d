// OBJ files that are damaged or cannot be written: clear errors, nothing lost, never a crash.
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

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#endif

namespace tst_objdamage {

using namespace autocuts;

class TestObjDamage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void badInput_data();
    void badInput();
    void badFiles();
    void badTargets();
    void fullDiskLeavesTheOldFile();
    void mutatedFilesNeverCrash();
};

void TestObjDamage::badInput_data()
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

void TestObjDamage::badInput()
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

void TestObjDamage::badFiles()
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
    QVERIFY(saveAtomically(secret, test::triangleObj).ok());
    QFile::setPermissions(secret, {});
    QFile file(secret);
    if (!file.open(QIODevice::ReadOnly))
        QVERIFY(message(secret).contains(QLatin1String("permissions")));
    QVERIFY(QFile::link(QStringLiteral("/dev/zero"), folder.filePath(QStringLiteral("device.obj"))));
    QVERIFY(message(folder.filePath(QStringLiteral("device.obj"))).contains(QLatin1String("regular file")));
#endif
}

void TestObjDamage::badTargets()
{
    QTemporaryDir folder;
    const Scene scene = test::parsed(test::triangleObj);
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
        QCOMPARE(test::contentOf(kept), QByteArray("old"));
    }
}

void TestObjDamage::fullDiskLeavesTheOldFile()
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
    QCOMPARE(test::contentOf(path), QByteArray("old content"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
#else
    QSKIP("no file size limit on this system");
#endif
}

void TestObjDamage::mutatedFilesNeverCrash()
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
    const QByteArrayList seeds{test::nastyObj, test::triangleObj,
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
                bytes = test::triangleObj;
        }
        Result<Scene> scene = parseObj(bytes, QString());
        if (!scene)
            continue;
        ++valid;
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        QVERIFY(objBytes(scene.value()) == bytes);
        test::setNewUvs(scene.value());
        const Result<Scene> again = parseObj(objBytes(scene.value()), QString());
        QVERIFY2(again.ok(), again ? "" : qPrintable(again.error().toString() + QString::fromUtf8(bytes)));
        QVERIFY2(sameBits(again->uvSets.at(0).uv, scene->uvSets[0].uv), bytes.constData());
        QCOMPARE(again->mesh->cornerVertex, scene->mesh->cornerVertex);
        QCOMPARE(again->faceMaterial, scene->faceMaterial);
    }
    QVERIFY(valid > 1000);
}

QTEST_APPLESS_MAIN(TestObjDamage)

} // namespace tst_objdamage

#include "tst_objdamage.moc"
