// FBX files as a whole: real ones, damaged ones, sessions that hold them, and other formats made of them.
#include "model/document/documentstate.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxrewriter.h"
#include "model/io/fbx/fbxwriter.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/obj/objreader.h"
#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectscene.h"
#include "support/fbxfiles.h"
#include "support/meshbuilders.h"

#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <limits>
#include <random>

namespace tst_fbxfiles {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using fbxfiles::Kind;
using fbxfiles::Node;
using fbxfiles::Object;

namespace {

QByteArray sample(const Kind &kind)
{
    const Node normals = fbxfiles::layerElement(
        "LayerElementNormal", 0, "", "ByVertice", "Direct",
        {{"Normals", {std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}}, {}}});
    const Node materials = fbxfiles::layerElement("LayerElementMaterial", 0, "", "ByPolygon", "IndexToDirect",
                                                  {{"Materials", {std::vector<std::int32_t>{0, 1}}, {}}});
    Object object{"quads", fbxfiles::quads({fbxfiles::uvElement(0, "UVMap"), normals, materials,
                                            fbxfiles::layer(0, {0})})};
    object.properties = {fbxfiles::property(kind, "Lcl Translation", {10, 0, 0})};
    object.materials = {"red", "blue"};
    return fbxfiles::model(kind, {object, {"copy", {}, {}, 0}});
}

UvMatrix otherUv(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) << 0.125 * mesh.cornerVertex[c], 0.25 + mesh.cornerVertex[c];
    return uv;
}

//! Damages a few places: bits, bytes, whole numbers, pieces left out, doubled or moved.
QByteArray damaged(QByteArray bytes, std::mt19937 &random)
{
    const auto below = [&random](qsizetype n) {
        return static_cast<qsizetype>(random() % static_cast<unsigned>(n));
    };
    const QByteArray odd[] = {
        QByteArray(4, '\0'), QByteArray(4, '\xff'), QByteArray("\xff\xff\xff\x7f", 4), QByteArray("{"),
        QByteArray("}"),     QByteArray("-1"),      QByteArray("*99999999 "),          QByteArray("1e999")};
    for (int turn = 1 + static_cast<int>(below(3)); turn > 0 && bytes.size() > 40; --turn) {
        const qsizetype at = below(bytes.size() - 8);
        const qsizetype length = 1 + below(std::min<qsizetype>(200, bytes.size() - at));
        switch (below(6)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
            break;
        case 1:
            bytes.replace(at, 4, odd[below(std::ssize(odd))]);
            break;
        case 2:
            bytes.truncate(at);
            break;
        case 3:
            bytes.remove(at, length);
            break;
        case 4:
            bytes.insert(at, bytes.sliced(at, length));
            break;
        default:
            bytes.insert(below(bytes.size()), odd[below(std::ssize(odd))]);
        }
    }
    return bytes;
}

QStringList realFiles()
{
    QStringList files;
    for (const QString &folder :
         {QString::fromStdString(test::meshFolder()) + u"/fbx"_s, u"/usr/share/assimp/models/FBX"_s}) {
        QDirIterator it(folder, {u"*.fbx"_s, u"*.FBX"_s}, QDir::Files);
        while (it.hasNext())
            files << it.next();
    }
    files.sort();
    return files;
}

} // namespace

class TestFbxFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readAndWritten();
    void session();
    void otherFormats();
    void newFiles();
    void smoothingGroupsOfObjFiles();
    void oldVersionsAreWrittenPlain();
    void commaWithoutValueIsRefused();
    void mutatedFilesNeverCrash_data();
    void mutatedFilesNeverCrash();
    void realFilesStayTheSame();
};

void TestFbxFiles::readAndWritten()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.FBX"_s);
    const QString other = folder.filePath(u"b.fbx"_s);
    const QByteArray bytes = sample({});
    QVERIFY(saveAtomically(path, bytes).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    QVERIFY(exportLosses(scene.value(), u"fbx"_s).isEmpty());
    QVERIFY(writeMesh(scene.value(), other).ok());
    QCOMPARE(loadFile(other, 1 << 20).value(), bytes);
    scene->uvSets[0].uv = otherUv(*scene->mesh);
    QVERIFY(writeMesh(scene.value(), other).ok());
    const Result<Scene> again = readMesh(other);
    QVERIFY(again.ok());
    QCOMPARE(again->uvSets[0].uv.topRows(8), scene->uvSets[0].uv.topRows(8));
    QCOMPARE(again->materialNames, scene->materialNames);
    QVERIFY(!readMesh(folder.filePath(u"none.fbx"_s)).ok());
}

void TestFbxFiles::session()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.acproj"_s);
    Scene scene = parseFbx(sample({false, 7400}), u"a.fbx"_s).value();
    QVERIFY(sessionLosses(scene).isEmpty());
    scene.uvSets[0].uv = otherUv(*scene.mesh);
    QVERIFY(saveProject(DocumentState::initial(scene), {}, path).ok());
    const Result<LoadedProject> loaded = loadProject(path);
    QVERIFY(loaded.ok());
    QCOMPARE(loaded->notes, QStringList());
    const Scene &again = loaded->state.scene;
    QVERIFY(sourceOf<FbxSource>(again));
    QCOMPARE(again.hardEdges, scene.hardEdges);
    QCOMPARE(again.objectNames, scene.objectNames);
    QCOMPARE(again.uvSets[0].uv, scene.uvSets[0].uv);
    QCOMPARE(rewriteFbx(*sourceOf<FbxSource>(again), again), rewriteFbx(*sourceOf<FbxSource>(scene), scene));
}

void TestFbxFiles::otherFormats()
{
    QTemporaryDir folder;
    Scene scene = parseFbx(sample({}), u"a.fbx"_s).value();
    scene.uvSets[0].uv = otherUv(*scene.mesh);
    scene.uvSets.push_back({u"second"_s, otherUv(*scene.mesh)});
    const QString losses = certainExportLosses(scene, u"glb"_s).join(u' ');
    QVERIFY(losses.contains(u"one copy per node"_s));
    QVERIFY(!losses.contains(u"normals and vertex colours are lost"_s));
    for (const QString &format : {u"glb"_s, u"gltf"_s, u"dae"_s, u"ply"_s, u"obj"_s}) {
        const QString path = folder.filePath(u"a."_s + format);
        QVERIFY(writeMesh(scene, path).ok());
        const Result<Scene> again = readMesh(path);
        QVERIFY(again.ok());
        QCOMPARE(again->mesh->triangleCount(), 8);
        // The sample is in centimetres.
        QVERIFY(std::abs(1e4 * again->mesh->area / scene.mesh->area - 1) < 1e-6);
        // The UVs of the corners in one place.
        QCOMPARE(again->uvSets[0].uv.col(0).sum() / static_cast<double>(again->uvSets[0].uv.rows()) > 0,
                 true);
    }
    const Result<Scene> glb = readMesh(folder.filePath(u"a.glb"_s));
    QCOMPARE(glb->uvSets.size(), std::size_t(2));
    QVERIFY(std::ranges::find(glb->objectNames, u"copy"_s) != glb->objectNames.end());
}

void TestFbxFiles::newFiles()
{
    const Result<Scene> obj =
        parseObj("o one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nvn 0 0 1\nvn 1 0 0\n"
                 "usemtl red\nf 1//1 2//1 3//1 4//1\nusemtl blue\nf 2//2 5//2 3//2\no two\n"
                 "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 6//1 7//1 8//1\n",
                 u"a.obj"_s);
    Scene scene = obj.value();
    scene.uvSets = {{u"first"_s, otherUv(*scene.mesh)}, {u"second"_s, otherUv(*scene.mesh)}};
    scene.uvSets[0].uv.row(1).fill(std::numeric_limits<double>::quiet_NaN());
    scene.uvSets[1].uv.bottomRows(3).fill(std::numeric_limits<double>::quiet_NaN());
    QTemporaryDir folder;
    QVERIFY(writeMesh(scene, folder.filePath(u"a.fbx"_s)).ok());
    const Result<Scene> again = readMesh(folder.filePath(u"a.fbx"_s));
    QVERIFY(again.ok());
    QVERIFY(sourceOf<FbxSource>(again.value())->bytes.startsWith("Kaydara"));
    QCOMPARE(sourceOf<FbxSource>(again.value())->version, 7400);
    QCOMPARE(again->mesh->faceStart, scene.mesh->faceStart);
    QCOMPARE(again->mesh->area, scene.mesh->area);
    QCOMPARE(again->objectNames, scene.objectNames);
    QCOMPARE(again->materialNames, scene.materialNames);
    QCOMPARE(again->faceMaterial, scene.faceMaterial);
    QCOMPARE(again->hardEdges, scene.hardEdges);
    QCOMPARE(std::ranges::count(again->hardEdges, true), 1);
    QCOMPARE(again->uvSets.size(), std::size_t(2));
    for (std::size_t s = 0; s < 2; ++s) {
        QCOMPARE(again->uvSets[s].name, scene.uvSets[s].name);
        for (Eigen::Index c = 0; c < scene.uvSets[s].uv.rows(); ++c) {
            const bool has = scene.uvSets[s].uv.row(c).allFinite();
            QCOMPARE(again->uvSets[s].uv.row(c).allFinite(), has);
            QVERIFY(!has || again->uvSets[s].uv.row(c) == scene.uvSets[s].uv.row(c));
        }
    }
}

void TestFbxFiles::smoothingGroupsOfObjFiles()
{
    QByteArray strip;
    for (const int x : {0, 1, 2, 3}) {
        const QByteArray place = "v " + QByteArray::number(x);
        strip += place + " 0 0\n" + place + " 1 0\n";
    }
    const auto written = [&](const QByteArray &faces) {
        const Result<Scene> obj = parseObj(strip + faces, u"a.obj"_s);
        const Result<Scene> fbx = parseFbx(fbxBytes(obj.value()), u"a.fbx"_s);
        return std::pair(obj->hardEdges, fbx->hardEdges);
    };
    const auto [before, after] = written("s 7\nf 1 3 4 2\nf 3 5 6 4\ns 40\nf 5 7 8 6\n");
    QCOMPARE(std::ranges::count(before, true), 1);
    QCOMPARE(after, before);
    QVERIFY(written("f 1 3 4 2\nf 3 5 6 4\nf 5 7 8 6\n").second.empty());
}

void TestFbxFiles::oldVersionsAreWrittenPlain()
{
    QTemporaryDir folder;
    const Scene scene = parseFbx(sample({true, 6100}), u"a.fbx"_s).value();
    QVERIFY(exportLosses(scene, u"glb"_s).join(u' ').contains(u"normals and vertex colours are lost"_s));
    QVERIFY(writeMesh(scene, folder.filePath(u"a.glb"_s)).ok());
    const Result<Scene> again = readMesh(folder.filePath(u"a.glb"_s));
    QVERIFY(again.ok());
    QVERIFY(std::abs(1e4 * again->mesh->area / scene.mesh->area - 1) < 1e-6);
}

//! A comma before a brace: one cannot say where the node ends.
void TestFbxFiles::commaWithoutValueIsRefused()
{
    const QByteArray bytes = R"(; FBX 7500 project file
FBXHeaderExtension: {
	FBXVersion: 7500
}
Objects: {
	Geometry: 2000,"Geometry::","Mesh" {
		Vertices: *12 {
			a: 0,0,0,1,0,0,1,1,0,0,1,0
		}
		PolygonVertexIndex: *4 {
			a: 0,1,2,-4
		}
		LayerElementUV: 0 {
			Name: "UVMap"
			Type: "ByPolygonVertex"
,		}
	}
}
)";
    const Result<Scene> scene = parseFbx(bytes, u"damaged.fbx"_s);
    QVERIFY(!scene.ok());
    QCOMPARE(scene.error().line, 16);
    QVERIFY(scene.error().message.contains(u"comma"_s));
}

void TestFbxFiles::mutatedFilesNeverCrash_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("binary 6100") << sample({true, 6100});
    QTest::newRow("binary 7400") << sample({true, 7400});
    QTest::newRow("binary 7400, not packed") << sample({true, 7400, false, false});
    QTest::newRow("binary 7700 big-endian") << sample({true, 7700, true});
    QTest::newRow("text 6100") << sample({false, 6100});
    QTest::newRow("text 7400") << sample({false, 7400});
}

void TestFbxFiles::mutatedFilesNeverCrash()
{
    QFETCH(QByteArray, bytes);
    std::mt19937 random(7);
    int read = 0;
    for (int turn = 0; turn < 1000; ++turn) {
        const QByteArray broken = damaged(bytes, random);
        Result<Scene> scene = parseFbx(broken, u"a.fbx"_s);
        if (!scene) {
            QVERIFY(!scene.error().message.isEmpty());
            continue;
        }
        ++read;
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        const FbxSource &source = *sourceOf<FbxSource>(scene.value());
        QCOMPARE(rewriteFbx(source, scene.value()), broken);
        scene->uvSets.insert(scene->uvSets.begin(), {u"new"_s, otherUv(*scene->mesh)});
        for (UvSet &set : scene->uvSets)
            set.uv = otherUv(*scene->mesh);
        const Result<Scene> again = parseFbx(rewriteFbx(source, scene.value()), u"a.fbx"_s);
        QVERIFY2(again.ok(), again ? "" : qPrintable(again.error().toString()));
        QCOMPARE(again->mesh->cornerVertex, scene->mesh->cornerVertex);
        QCOMPARE(again->mesh->positions, scene->mesh->positions);
    }
    QVERIFY(read > 0);
}

void TestFbxFiles::realFilesStayTheSame()
{
    const QStringList files = realFiles();
    if (files.isEmpty())
        QSKIP("no FBX files on this machine");
    int read = 0;
    for (const QString &path : files) {
        Result<Scene> scene = readMesh(path);
        if (!scene) {
            QVERIFY2(!scene.error().message.isEmpty() && !scene.error().remedy.isEmpty(), qPrintable(path));
            continue;
        }
        ++read;
        const FbxSource &source = *sourceOf<FbxSource>(scene.value());
        QVERIFY2(rewriteFbx(source, scene.value()) == source.bytes, qPrintable(path));
        QVERIFY2(scene->mesh->validate().empty(), qPrintable(path));
        if (scene->uvSets.empty())
            scene->uvSets.push_back({u"UVMap"_s, {}});
        scene->uvSets[0].uv = otherUv(*scene->mesh);
        const QByteArray written = rewriteFbx(source, scene.value());
        const Result<Scene> again = parseFbx(written, path);
        QVERIFY2(again.ok(), qPrintable(path));
        QVERIFY2(again->mesh->positions == scene->mesh->positions, qPrintable(path));
        QVERIFY2(again->mesh->cornerVertex == scene->mesh->cornerVertex, qPrintable(path));
        QVERIFY2(again->hardEdges == scene->hardEdges, qPrintable(path));
        if (!source.contents.instances)
            QVERIFY2(again->uvSets[0].uv == scene->uvSets[0].uv, qPrintable(path));
    }
    QVERIFY(read * 2 > files.size());
}

QTEST_GUILESS_MAIN(TestFbxFiles)

} // namespace tst_fbxfiles

#include "tst_fbxfiles.moc"
