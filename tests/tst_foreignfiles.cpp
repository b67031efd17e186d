// Files that crash, hang or bloat Assimp, read by autocuts-reader: each becomes an error. Cancelling. Collada
// as others write it.
#include "model/io/assimp/assimpprocess.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/obj/objreader.h"

#include <QFile>
#include <QImage>
#include <QStringEncoder>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cerrno>
#include <sys/wait.h>
#include <thread>

namespace tst_foreignfiles {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Short, for files that hang.
constexpr ReaderLimits shortLimits{qint64(512) << 20, 1, 60};

const QByteArray xyz = "property float x\nproperty float y\nproperty float z\n";

QByteArray ply(const QByteArray &header, const QByteArray &body)
{
    return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

//! Assimp makes room for 3 vertices and fills in 2000.
QByteArray twoVertexElements()
{
    return ply("element vertex 3\n" + xyz + "element vertex 2000\n" + xyz +
                   "element face 1\nproperty list uchar int vertex_indices\n",
               "0 0 0\n1 0 0\n0 1 0\n" + QByteArray("7 1 2\n").repeated(2000) + "3 0 1 2\n");
}

//! A GLB whose JSON claims to have 1 GB.
[[maybe_unused]] QByteArray glbOfAGigabyte() // not where the sanitizers run
{
    const QByteArray json = "{\"asset\":1}";
    const quint32 head[] = {0x46546C67, 2, quint32(20 + json.size()), 0x40000498, 0x4E4F534A};
    return QByteArray(reinterpret_cast<const char *>(head), sizeof head) + json;
}

//! The pivot becomes part of the node, so that the node that the animation names does not exist.
constexpr QByteArrayView fbxWithAnimatedPivot = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
FBXHeaderVersion: 1003
FBXVersion: 7400
}
Objects:  {
Geometry: 1, "Geometry::", "Mesh" {
Vertices: *9 { a: 0,0,0,1,0,0,0,1,0 }
PolygonVertexIndex: *3 { a: 0,1,-3 }
}
Model: 2, "Model::part", "Mesh" {
Properties70:  {
P: "RotationPivot", "Vector3D", "Vector", "",1,0,0
}
}
AnimationStack: 3, "AnimStack::Take", "" {
}
AnimationLayer: 4, "AnimLayer::Base", "" {
}
AnimationCurveNode: 5, "AnimCurveNode::T", "" {
Properties70:  {
P: "d|X", "Number", "", "A",0
}
}
AnimationCurve: 6, "AnimCurve::", "" {
KeyTime: *2 { a: 0,46186158000 }
KeyValueFloat: *2 { a: 0,1 }
KeyAttrFlags: *1 { a: 264 }
KeyAttrDataFloat: *4 { a: 0,0,0,0 }
KeyAttrRefCount: *1 { a: 2 }
}
}
Connections:  {
C: "OO",1,2
C: "OO",2,0
C: "OO",4,3
C: "OO",5,4
C: "OP",5,2, "Lcl Translation"
C: "OP",6,5, "d|X"
}
)";

//! True when no child process is left, not even one that has ended.
bool hasNoChildren()
{
    return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

//! Puts a script in the place of autocuts-reader.
class OtherReader
{
public:
    explicit OtherReader(const QByteArray &script)
    {
        const QString path = mFolder.filePath(u"reader"_s);
        if (!saveAtomically(path, "#!/bin/sh\n" + script + '\n').ok() ||
            !QFile::setPermissions(path, QFile::ReadOwner | QFile::ExeOwner))
            qFatal("the script cannot be written");
        qputenv("AUTOCUTS_READER", QFile::encodeName(path));
    }
    ~OtherReader()
    {
        if (mBefore.isNull())
            qunsetenv("AUTOCUTS_READER");
        else
            qputenv("AUTOCUTS_READER", mBefore);
    }
    OtherReader(const OtherReader &) = delete;
    OtherReader &operator=(const OtherReader &) = delete;

private:
    QTemporaryDir mFolder;
    QByteArray mBefore = qgetenv("AUTOCUTS_READER");
};

//! Two triangles as a Collada file.
QByteArray collada(const QTemporaryDir &folder)
{
    const QString path = folder.filePath(u"plain.dae"_s);
    const Result<Scene> scene =
        parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl rot\nf 1 2 3\nf 1 3 4\n", u"a.obj"_s);
    if (!scene || !writeMesh(scene.value(), path))
        qFatal("the Collada file cannot be written");
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestForeignFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { QVERIFY(hasNoChildren()); }

    void faultyFiles_data();
    void faultyFiles();
    void theWholeWay();
    void cancelling();
    void readersThatMisbehave_data();
    void readersThatMisbehave();
    void missingReader();
    void packedPictureOfABlendFile();
    void limitsGrowWithTheFile();
    void colladaOfOthers_data();
    void colladaOfOthers();
    void blendFilesAreSentToBlender();
    void animatedPivotsCanBeWritten_data();
    void animatedPivotsCanBeWritten();
};

void TestForeignFiles::faultyFiles_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("part"); // of the message; empty: there may be none
    const QByteArray list = "property list uchar int vertex_indices\n";
#ifndef AUTOCUTS_SANITIZED
    // Where the memory that Assimp writes beyond is noticed.
    QTest::newRow("two vertex elements") << u"a.ply"_s << twoVertexElements() << u"damaged"_s;
#endif
    // Reads beyond its memory, so that anything may come of it.
    QTest::newRow("two face elements")
        << u"a.ply"_s
        << ply("element vertex 8\n" + xyz + "element face 3\n" + list + "element face 8\n" + list,
               QByteArray("0 0 0\n").repeated(8) + QByteArray("3 0 1 2\n").repeated(11))
        << QString();
    QTest::newRow("no line end in the header")
        << u"a.ply"_s
        << QByteArray("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nelement "
                      "facend_header\n0 0 0\n")
        << u"takes longer than"_s;
    QTest::newRow("cut property") << u"a.ply"_s
                                  << QByteArray("ply\nformat ascii 1.0\nelement vertex 4\n" + xyz +
                                                "property floatend_header\n0 0 0\n")
                                  << u"takes longer than"_s;
#ifndef AUTOCUTS_SANITIZED
    // Where the reader has a limit of memory.
    QTest::newRow("huge glb") << u"a.glb"_s << glbOfAGigabyte() << u"of memory"_s;
    QTest::newRow("huge off") << u"a.off"_s << QByteArray("OFF\n999999999 1 0\n0 0 0\n") << u"of memory"_s;
#endif
}

void TestForeignFiles::faultyFiles()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, part);
    QTemporaryDir folder;
    const QString path = folder.filePath(name);
    QVERIFY(saveAtomically(path, bytes).ok());
    const auto scene = readInProcess(path, shortLimits, nullptr);
    if (scene.ok() && part.isEmpty())
        return;
    QVERIFY(!scene.ok());
    const Error &error = scene.error();
    QVERIFY2(error.message.contains(part), qPrintable(error.message));
    QCOMPARE(error.file, path);
    QVERIFY(error.remedy.contains(u"export the model again"_s));
}

//! Through the function that the programs call.
void TestForeignFiles::theWholeWay()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.ply"_s);
    QVERIFY(saveAtomically(path, twoVertexElements()).ok());
    const Result<Scene> scene = readMesh(path);
#ifdef AUTOCUTS_SANITIZED
    if (scene.ok())
        QSKIP("Under a sanitizer the memory that Assimp writes beyond is not noticed");
#endif
    QVERIFY(!scene.ok());
    QVERIFY2(scene.error().message.contains(u"damaged"_s), qPrintable(scene.error().message));
}

void TestForeignFiles::cancelling()
{
    // Without the cancelling this would end with another error, after the limit of time.
    const OtherReader sleeping("exec sleep 1000");
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.off"_s);
    QVERIFY(saveAtomically(path, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").ok());
    std::atomic<bool> stop = false;
    const std::jthread user([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop = true;
    });
    const Result<Scene> scene = readMesh(path, &stop);
    QVERIFY(!scene.ok());
    QVERIFY(stop);
    QCOMPARE(scene.error().message, u"reading was cancelled"_s);
    QCOMPARE(scene.error().file, path);
}

void TestForeignFiles::readersThatMisbehave_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QString>("part");
    QTest::newRow("sleeps") << QByteArray("exec sleep 1000") << u"takes longer than"_s;
    QTest::newRow("says nothing") << QByteArray("exit 0") << u"breaks off"_s;
    QTest::newRow("says something else") << QByteArray("echo something else entirely") << u"not a scene"_s;
    QTest::newRow("never ends") << QByteArray("exec cat /dev/zero") << u"of memory"_s;
    QTest::newRow("fails") << QByteArray("printf 'half a scene\\0because'; exit 1") << u"because"_s;
    QTest::newRow("unknown code") << QByteArray("exit 77") << u"damaged"_s;
}

void TestForeignFiles::readersThatMisbehave()
{
    QFETCH(QByteArray, script);
    QFETCH(QString, part);
    const OtherReader reader(script);
    const auto scene = readInProcess(u"a.off"_s, {1 << 22, 1, 1}, nullptr);
    QVERIFY(!scene.ok());
    QVERIFY2(scene.error().message.contains(part), qPrintable(scene.error().message));
}

void TestForeignFiles::missingReader()
{
    const OtherReader reader({});
    qputenv("AUTOCUTS_READER", "/nowhere/autocuts-reader");
    const auto scene = readInProcess(u"a.off"_s, shortLimits, nullptr);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().message.contains(u"autocuts-reader"_s));
    QVERIFY(scene.error().remedy.contains(u"Install Autocuts again"_s));
}

void TestForeignFiles::packedPictureOfABlendFile()
{
    const QString path = u"/usr/share/assimp/models/BLEND/TexturedPlane_ImageUvPacked_248.blend"_s;
    if (!QFile::exists(path))
        QSKIP("Debian's package assimp-testmodels is not there");
    const Result<Scene> scene = readMesh(path);
    QVERIFY2(scene.ok(), scene.ok() ? "" : qPrintable(scene.error().toString()));
    QVERIFY(!QImage::fromData(scene->materialTextures.at(0).content).isNull());
}

void TestForeignFiles::limitsGrowWithTheFile()
{
    const ReaderLimits none = readerLimits(0);
    const ReaderLimits some = readerLimits(100'000'000);
    QVERIFY(none.memory >= qint64(512) << 20 && none.cpuSeconds >= 10 && none.wallSeconds > none.cpuSeconds);
    QVERIFY(some.memory > none.memory + 64 * qint64(100'000'000) && some.cpuSeconds > none.cpuSeconds + 100);
}

void TestForeignFiles::colladaOfOthers_data()
{
    QTest::addColumn<int>("encoding");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("space");
    QTest::newRow("as written") << int(QStringConverter::Utf8) << QString() << QString();
    QTest::newRow("UTF-16LE") << int(QStringConverter::Utf16LE) << QString(QChar(0xFEFF)) << QString();
    QTest::newRow("UTF-16BE") << int(QStringConverter::Utf16BE) << QString(QChar(0xFEFF)) << QString();
    QTest::newRow("UTF-16LE, no mark") << int(QStringConverter::Utf16LE) << QString() << QString();
    QTest::newRow("UTF-16BE, no mark") << int(QStringConverter::Utf16BE) << QString() << QString();
    QTest::newRow("UTF-8, mark") << int(QStringConverter::Utf8) << QString(QChar(0xFEFF)) << QString();
    QTest::newRow("blank lines first") << int(QStringConverter::Utf8) << u"\n  \n"_s << QString();
    QTest::newRow("space before numbers") << int(QStringConverter::Utf8) << QString() << u"  "_s;
    QTest::newRow("all") << int(QStringConverter::Utf16LE) << QString(QChar(0xFEFF)) << u"\n\t"_s;
}

void TestForeignFiles::colladaOfOthers()
{
    QFETCH(int, encoding);
    QFETCH(QString, before);
    QFETCH(QString, space);
    QTemporaryDir folder;
    QString text = before + QString::fromUtf8(collada(folder));
    // A name beyond the first plane of Unicode.
    text.replace(u"rot"_s, u"r\U0001F534t"_s);
    text.replace(u"<color sid=\"diffuse\">"_s, u"<color sid=\"diffuse\">"_s + space);
    text.replace(u"<color sid=\"specular\">"_s, u"<color sid=\"specular\">"_s + space);
    if (encoding != QStringConverter::Utf8)
        text.replace(u"utf-8"_s, u"utf-16"_s, Qt::CaseInsensitive);
    QStringEncoder encoder(static_cast<QStringConverter::Encoding>(encoding));
    const QByteArray bytes = encoder.encode(text);
    const QString path = folder.filePath(u"other.DAE"_s);
    QVERIFY(saveAtomically(path, bytes).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    QCOMPARE(scene->mesh->faceCount(), 2);
    QCOMPARE(scene->mesh->area, 1.0);
    QVERIFY(std::find(scene->materialNames.begin(), scene->materialNames.end(), u"r\U0001F534t"_s) !=
            scene->materialNames.end());
}

void TestForeignFiles::blendFilesAreSentToBlender()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.blend"_s);
    QVERIFY(saveAtomically(path, "BLENDER-v262garbage").ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().remedy.contains(u"Open it in Blender"_s));
}

void TestForeignFiles::animatedPivotsCanBeWritten_data()
{
    QTest::addColumn<QString>("suffix");
    QTest::newRow("glb") << u"glb"_s;
    QTest::newRow("fbx") << u"fbx"_s;
}

void TestForeignFiles::animatedPivotsCanBeWritten()
{
    QFETCH(QString, suffix);
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.fbx"_s);
    QVERIFY(saveAtomically(path, fbxWithAnimatedPivot.toByteArray()).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    const QString written = folder.filePath(u"b."_s + suffix);
    QVERIFY(writeMesh(scene.value(), written).ok());
    const Result<Scene> again = readMesh(written);
    QVERIFY(again.ok());
    QCOMPARE(again->mesh->faceCount(), 1);
}

QTEST_GUILESS_MAIN(TestForeignFiles)

} // namespace tst_foreignfiles

#include "tst_foreignfiles.moc"
