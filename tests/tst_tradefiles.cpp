// Files of the formats that Assimp alone reads: their axes, units and UVs, what is written of them, and
// damaged ones.
#include "model/io/assimp/assimpprocess.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "support/tradefiles.h"

#include <QDirIterator>
#include <QRandomGenerator>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/scene.h>

namespace tst_tradefiles {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Short, for files that hang.
constexpr ReaderLimits shortLimits{qint64(512) << 20, 1, 60};

//! Formats of which a file is too much to make here; those of Assimp's test models are read.
const QStringList onlyOfOthers{u"3ds"_s, u"blend"_s, u"hmp"_s, u"ifc"_s, u"lxo"_s,
                               u"mdc"_s, u"mdl"_s,   u"q3o"_s, u"q3s"_s, u"sib"_s};

const QStringList ownReaders{u"obj"_s, u"ply"_s, u"stl"_s, u"off"_s, u"gltf"_s, u"glb"_s, u"fbx"_s, u"dae"_s};

//! Other endings of one format.
const QHash<QString, QString> otherEndings{{u"ac3d"_s, u"ac"_s}, {u"acc"_s, u"ac"_s}};

QString put(const QTemporaryDir &folder, const QString &name, const QByteArray &bytes)
{
    const QString path = folder.filePath(name);
    if (!saveAtomically(path, bytes))
        qFatal("a file cannot be written");
    return path;
}

tradefiles::TradeFile sheetIn(const QString &suffix)
{
    for (const tradefiles::TradeFile &file : tradefiles::sheets()) {
        if (file.suffix == otherEndings.value(suffix, suffix))
            return file;
    }
    qFatal("there is no such sheet");
}

QString putSheet(const QTemporaryDir &folder, const QString &suffix)
{
    const tradefiles::TradeFile file = sheetIn(suffix);
    for (const auto &[name, bytes] : file.beside)
        put(folder, name, bytes);
    return put(folder, u"sheet."_s + suffix, file.bytes);
}

//! What is wrong with a sheet that was read, or nothing.
QString faultOf(const Scene &scene, bool hasUv)
{
    const MeshData &mesh = *scene.mesh;
    if (!mesh.validate().empty())
        return u"the mesh is not valid"_s;
    const Vec3 size = mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff();
    const Vec3 least = mesh.positions.colwise().minCoeff();
    if ((size - Vec3(2, 1, 0)).norm() > 1e-6 || least.norm() > 1e-6)
        return u"the sheet is %1 x %2 x %3 large"_s.arg(size.x()).arg(size.y()).arg(size.z());
    if (std::abs(mesh.area - 2) > 1e-6)
        return u"the area is %1"_s.arg(mesh.area);
    if (scene.hasUv() != hasUv)
        return u"UVs"_s;
    for (int c = 0; hasUv && c < mesh.cornerCount(); ++c) {
        const auto at = mesh.positions.row(mesh.cornerVertex[std::size_t(c)]);
        const auto uv = scene.uvSets.front().uv.row(c);
        if (std::abs(uv.x() - at.x() / 2) > 1e-6 || std::abs(uv.y() - at.y()) > 1e-6)
            return u"a corner has the UV %1 %2"_s.arg(uv.x()).arg(uv.y());
    }
    return {};
}

void addSheetRows()
{
    QTest::addColumn<QString>("suffix");
    for (const tradefiles::TradeFile &file : tradefiles::sheets())
        QTest::newRow(qPrintable(file.suffix)) << file.suffix;
}

} // namespace

class TestTradeFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allFormatsAreHere();
    void sheets_data();
    void sheets();
    void units_data();
    void units();
    void otherFormats_data() { addSheetRows(); }
    void otherFormats();
    void bonesThatAreNotThere();
    void lightsThatAreNotThere();
    void ownFormat_data() { addSheetRows(); }
    void ownFormat();
    void colladaArchives();
    void filesOfOthers_data();
    void filesOfOthers();
    void damagedFiles_data() { addSheetRows(); }
    void damagedFiles();
    void formatsToWrite();
    void theDocumentationNamesAll();
};

void TestTradeFiles::allFormatsAreHere()
{
    QStringList tested = ownReaders + onlyOfOthers + otherEndings.keys();
    tested << u"zae"_s; // colladaArchives()
    for (const tradefiles::TradeFile &file : tradefiles::sheets())
        tested << file.suffix;
    QStringList readable = readableFormats();
    std::sort(tested.begin(), tested.end());
    std::sort(readable.begin(), readable.end());
    QCOMPARE(tested, readable);
}

void TestTradeFiles::sheets_data()
{
    addSheetRows();
    for (const QString &ending : otherEndings.keys())
        QTest::newRow(qPrintable(ending)) << ending;
}

void TestTradeFiles::sheets()
{
    QFETCH(QString, suffix);
    QTemporaryDir folder;
    const Result<Scene> scene = readMesh(putSheet(folder, suffix));
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    QCOMPARE(faultOf(scene.value(), sheetIn(suffix).hasUv), QString());
    QCOMPARE(scene->format, suffix);
}

void TestTradeFiles::units_data()
{
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<QByteArray>("bytes");
    const std::pair<const char *, double> units[]{
        {"", 1000}, {"millimeter", 1000}, {"micron", 1e6}, {"meter", 1}, {"inch", 1 / 0.0254}};
    for (const auto &[unit, perMetre] : units) {
        QTest::addRow("3mf %s", unit) << u"3mf"_s << tradefiles::sheetAs3mf(unit, perMetre);
        QTest::addRow("amf %s", unit) << u"amf"_s << tradefiles::sheetAsAmf(unit, perMetre);
    }
    QTest::newRow("3mf centimeter") << u"3mf"_s << tradefiles::sheetAs3mf("centimeter", 100);
    QTest::newRow("3mf foot") << u"3mf"_s << tradefiles::sheetAs3mf("foot", 1 / 0.3048);
    QTest::newRow("amf feet") << u"amf"_s << tradefiles::sheetAsAmf("feet", 1 / 0.3048);
    for (const double metres : {1.0, 0.01}) {
        QTest::addRow("ogex %g, y up", metres) << u"ogex"_s << tradefiles::sheetAsOgex(metres, false);
        QTest::addRow("ogex %g, z up", metres) << u"ogex"_s << tradefiles::sheetAsOgex(metres, true);
    }
}

void TestTradeFiles::units()
{
    QFETCH(QString, suffix);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const Result<Scene> scene = readMesh(put(folder, u"sheet."_s + suffix, bytes));
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    QCOMPARE(faultOf(scene.value(), sheetIn(suffix).hasUv), QString());
}

void TestTradeFiles::otherFormats()
{
    QFETCH(QString, suffix);
    QTemporaryDir folder;
    const Result<Scene> scene = readMesh(putSheet(folder, suffix));
    QVERIFY(scene.ok());
    for (const char *format : {"obj", "glb", "dae"}) {
        const QString path = folder.filePath(u"written."_s + QLatin1String(format));
        QVERIFY2(writeMesh(scene.value(), path).ok(), format);
        const Result<Scene> again = readMesh(path);
        QVERIFY2(again.ok(), format);
        QCOMPARE(faultOf(again.value(), scene->hasUv()), QString());
    }
    const QString path = folder.filePath(u"written.fbx"_s);
    QVERIFY(writeMesh(scene.value(), path).ok());
    const Result<Scene> again = readMesh(path);
    QVERIFY(again.ok());
    QCOMPARE(again->mesh->faceCount(), scene->mesh->faceCount());
    QCOMPARE(again->mesh->area, scene->mesh->area);
}

//! Assimp's exporters crash on bones without a node.
void TestTradeFiles::bonesThatAreNotThere()
{
    QTemporaryDir folder;
    const Result<Scene> scene = readMesh(put(folder, u"sheet.x"_s, tradefiles::skinnedX({"Root", "Gone"})));
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    for (const char *format : {"glb", "dae", "fbx"})
        QVERIFY2(writeMesh(scene.value(), folder.filePath(u"written."_s + QLatin1String(format))).ok(),
                 format);
}

//! So they do on cameras and lights.
void TestTradeFiles::lightsThatAreNotThere()
{
    QTemporaryDir folder;
    const QByteArray light =
        "LightObject $light1 (type = \"point\")\n{\n\tColor (attrib = \"light\") {float[3] "
        "{{1.0, 1.0, 1.0}}}\n}\n";
    const QString path = put(folder, u"sheet.ogex"_s, tradefiles::sheetAsOgex(1, true) + light);
    const Result<Scene> scene = readMesh(path);
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    QVERIFY(writeMesh(scene.value(), folder.filePath(u"written.ply"_s)).ok());
}

void TestTradeFiles::ownFormat()
{
    QFETCH(QString, suffix);
    const Result<Done> checked = checkWriteFormat(u"/a."_s + suffix);
    QVERIFY(!checked.ok());
    QVERIFY(checked.error().message.contains(suffix));
    QVERIFY(checked.error().remedy.contains(u"fbx"_s));
}

//! What is in them is read as any Collada file, with its names.
void TestTradeFiles::colladaArchives()
{
    QTemporaryDir folder;
    Scene scene = readMesh(putSheet(folder, u"ms3d"_s)).value();
    scene.objectNames = {u"Tür & Tor"_s};
    scene.uvSets.front().name = u"Lightmap"_s;
    const QString dae = folder.filePath(u"m.dae"_s);
    QVERIFY(writeMesh(scene, dae).ok());
    const QByteArray text = loadFile(dae, 1 << 20).value();
    const QByteArray manifest = "<?xml version=\"1.0\"?><dae_root>m.dae</dae_root>";
    const Result<Scene> again =
        readMesh(put(folder, u"m.zae"_s, tradefiles::zip({{"manifest.xml", manifest}, {"m.dae", text}})));
    QVERIFY2(again.ok(), again ? "" : qPrintable(again.error().toString()));
    QCOMPARE(faultOf(again.value(), true), QString());
    QCOMPARE(again->objectNames, scene.objectNames);
    QCOMPARE(again->uvSets.front().name, u"Lightmap"_s);
}

void TestTradeFiles::filesOfOthers_data()
{
    QTest::addColumn<QString>("suffix");
    for (const QString &suffix : onlyOfOthers)
        QTest::newRow(qPrintable(suffix)) << suffix;
}

void TestTradeFiles::filesOfOthers()
{
    QFETCH(QString, suffix);
    QStringList paths;
    QDirIterator each(u"/usr/share/assimp/models"_s, {u"*."_s + suffix}, QDir::Files,
                      QDirIterator::Subdirectories);
    while (each.hasNext())
        paths << each.next();
    if (paths.isEmpty())
        QSKIP("no meshes: Debian's package assimp-testmodels is not there");
    const bool anyIsRead = std::any_of(paths.begin(), paths.end(), [](const QString &path) {
        const Result<Scene> scene = readMesh(path);
        return scene.ok() && scene->mesh->validate().empty();
    });
    QVERIFY(anyIsRead);
}

//! Files that are cut off, with some bits turned.
void TestTradeFiles::damagedFiles()
{
    QFETCH(QString, suffix);
    const tradefiles::TradeFile file = sheetIn(suffix);
    QTemporaryDir folder;
    putSheet(folder, suffix);
    QRandomGenerator random(42);
    for (int n = 0; n < 10; ++n) {
        QByteArray bytes = file.bytes;
        if (n % 2 == 0)
            bytes.truncate(random.bounded(1, int(bytes.size())));
        for (int turned = n % 3; turned >= 0; --turned)
            bytes[random.bounded(int(bytes.size()))] ^= char(1 << random.bounded(8));
        const QString path = put(folder, u"damaged."_s + suffix, bytes);
        const auto read = readInProcess(path, shortLimits, nullptr);
        // What can be read at all is no reason to wait for.
        const Result<Scene> scene = read ? readMesh(path) : Result<Scene>(read.error());
        if (scene) {
            QVERIFY(scene->mesh->validate().empty());
            continue;
        }
        const Error &error = scene.error();
        QCOMPARE(error.file, path);
        QVERIFY(!error.message.isEmpty() && !error.remedy.isEmpty());
        QVERIFY(!error.message.contains(u'\n'));
    }
}

void TestTradeFiles::formatsToWrite()
{
    for (const QString &format : writableFormats())
        QCOMPARE(formatToWrite(format), format);
    QCOMPARE(formatToWrite(u"stl"_s), u"obj"_s);
    QCOMPARE(formatToWrite({}), u"obj"_s);
    QCOMPARE(formatToWrite(u"lwo"_s), u"fbx"_s);
}

void TestTradeFiles::theDocumentationNamesAll()
{
    QFile file(QStringLiteral(AUTOCUTS_SOURCE_DIR "/docs/formats.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    for (const QString &suffix : readableFormats())
        QVERIFY2(text.contains(u"`."_s + suffix + u'`'), qPrintable(suffix));
}

QTEST_GUILESS_MAIN(TestTradeFiles)

} // namespace tst_tradefiles

#include "tst_tradefiles.moc"
