// Collada files come back changed in nothing but their UVs: sources, indices, shared inputs, damage.
#include "model/io/collada/colladamesh.h"
#include "model/io/collada/colladasource.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>
#include <random>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! What differs between the files of the tests.
struct Parts
{
    QByteArray verticesInput; //!< in <vertices>
    QByteArray primitives;    //!< of the first geometry
    QByteArray texcoordStride = "2";
    QByteArray texcoords = "0 0 1 0\n1 1 0 1 0.25 0.75";
    QByteArray texcoordCount = "5";
    QByteArray nodeScale = "1 1 1";
    QByteArray moreNodes;
};

//! A square of two triangles with a roof: five vertices.
QByteArray file(const Parts &parts)
{
    return R"(<?xml version="1.0" encoding="utf-8"?>
<!-- kept <comment> with é -->
<COLLADA xmlns="urn:collada" version="1.4.1">
  <asset><unit name="inch" meter="0.0254"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g" name="square &amp; roof"><mesh>
    <source id="positions"><float_array id="positions-array" count="15">0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5 1</float_array>
      <technique_common><accessor source="#positions-array" count="5" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <source id="uvs"><float_array id="uvs-array" count=")" +
           QByteArray::number(parts.texcoords.simplified().count(' ') + 1) + R"(">)" + parts.texcoords +
           R"(</float_array><technique_common>
      <accessor source='#uvs-array' count=")" +
           parts.texcoordCount + R"(" stride=")" + parts.texcoordStride +
           R"("><param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#positions"/>)" +
           parts.verticesInput + R"(</vertices>
)" + parts.primitives +
           R"(
    <extra><technique profile="ours"><note>kept</note></technique></extra>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n" name="node"><scale>)" +
           parts.nodeScale + R"(</scale><instance_geometry url="#g"/></node>)" + parts.moreNodes +
           R"(</visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
}

const QByteArray vertexInput = R"(<input semantic="VERTEX" source="#v" offset="0"/>)";
const QByteArray uvInput = R"(<input semantic="TEXCOORD" source="#uvs" offset="1" set="0"/>)";

Parts polylist()
{
    Parts parts;
    parts.primitives = R"(<polylist count="3" material="m">)" + vertexInput + uvInput +
                       "<vcount>4 3 3</vcount><p>0 0 1 1\n2 2 3 3  0 0 1 1 4 4\t1 1 2 2 4 4</p></polylist>";
    return parts;
}

Parts triangles()
{
    Parts parts;
    parts.primitives =
        R"(<triangles count="2">)" + vertexInput + uvInput + "<p>0 0 1 1 2 2 0 0 2 2 3 3</p></triangles>";
    return parts;
}

Parts polygons()
{
    Parts parts;
    parts.primitives = R"(<polygons count="2">)" + vertexInput + uvInput +
                       "<p>0 0 1 1 2 2 3 3</p><p>0 0 1 1 4 4</p></polygons>";
    return parts;
}

//! Positions and UVs have the same index.
Parts sharedOffset()
{
    Parts parts;
    parts.primitives =
        R"(<triangles count="2">)" + vertexInput +
        R"(<input semantic="TEXCOORD" source="#uvs" offset="0" set="0"/><p>0 1 2 0 2 3</p></triangles>)";
    return parts;
}

Parts inVertices()
{
    Parts parts;
    parts.verticesInput = R"(<input semantic="TEXCOORD" source="#uvs"/>)";
    parts.primitives = R"(<triangles count="1">)" + vertexInput +
                       R"(<p>0 1 2</p></triangles><triangles count="1">)" + vertexInput +
                       "<p>0 2 3</p></triangles>";
    return parts;
}

//! Two primitives with one source, the second has lines and a third column.
Parts twoPrimitives()
{
    Parts parts = triangles();
    parts.texcoords = "0 0 7 1 0 7 1 1 8 0 1 8 0.25 0.75 9";
    parts.texcoordStride = "3";
    parts.primitives += R"(<polylist count="2" material="m">)" + vertexInput + uvInput +
                        R"(<vcount>2 3</vcount><p>0 0 1 1 1 1 2 2 4 4</p></polylist>)";
    return parts;
}

//! Two sets from one source.
Parts twoSets()
{
    Parts parts;
    parts.primitives =
        R"(<triangles count="1">)" + vertexInput + uvInput +
        R"(<input semantic="TEXCOORD" source="#uvs" offset="2" set="3"/><p>0 0 4 1 1 3 2 2 2</p></triangles>)";
    return parts;
}

Parts withoutUvs()
{
    Parts parts;
    parts.primitives = R"(<triangles count="2">)" + vertexInput + "<p>0 1 2 0 2 3</p></triangles>";
    return parts;
}

Scene sceneOf(const QByteArray &bytes, const QString &name = u"a.dae"_s)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(name);
    if (!saveAtomically(path, bytes).ok())
        qFatal("the file cannot be written");
    Result<Scene> scene = readMesh(path);
    if (!scene)
        qFatal("%s", qPrintable(scene.error().toString()));
    return std::move(scene).value();
}

//! UVs that differ at most corners.
UvMatrix newUv(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) << 1.0 / (3 + mesh.cornerVertex[c]), std::sin(c / 2);
    return uv;
}

//! The text without sources of UVs, inputs of UVs and indices.
QByteArray restOf(const QByteArray &bytes)
{
    const std::string_view text(bytes.constData(), std::size_t(bytes.size()));
    const std::optional<ColladaFile> read = readCollada(text);
    if (!read)
        return "unreadable";
    std::vector<TextEdit> edits;
    const auto cut = [&](std::string_view part) {
        edits.push_back({part.data(), part.data() + part.size(), {}});
    };
    for (const XmlElement &child : read->geometries.at(0).mesh->children) {
        if (child.name == "source" && child.attribute("id") != "positions")
            cut(child.whole);
        for (const XmlElement &part : child.children) {
            if (part.name == "p" || part.attribute("semantic") == "TEXCOORD")
                cut(part.name == "p" ? part.content : part.whole);
        }
    }
    QByteArray rest = QByteArray::fromStdString(edited(text, std::move(edits)));
    return rest.replace('\n', "");
}

//! The positions of all corners in the text.
std::vector<Vec3> positionsIn(const QByteArray &bytes)
{
    const std::optional<ColladaFile> read = readCollada({bytes.constData(), std::size_t(bytes.size())});
    std::vector<Vec3> result;
    for (const ColladaPrimitive &primitive : read->geometries[0].primitives) {
        const std::vector<Vec3> positions = positionsOf(*read, read->geometries[0], primitive);
        result.insert(result.end(), positions.begin(), positions.end());
    }
    return result;
}

} // namespace

class TestCollada : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyUvsChange_data();
    void onlyUvsChange();
    void textStaysInPlace();
    void newSet();
    void tooManySets();
    void mirroredAndInstanced();
    void otherTextIsLeftToAssimp_data();
    void otherTextIsLeftToAssimp();
    void materialsOfOneObject();
    void noMeshesAreAnError();
    void mutations();
    void realFiles();
};

void TestCollada::onlyUvsChange_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("polylist") << file(polylist());
    QTest::newRow("triangles") << file(triangles());
    QTest::newRow("polygons") << file(polygons());
    QTest::newRow("shared offset") << file(sharedOffset());
    QTest::newRow("in vertices") << file(inVertices());
    QTest::newRow("two primitives") << file(twoPrimitives());
    QTest::newRow("two sets") << file(twoSets());
    QTest::newRow("without UVs") << file(withoutUvs());
    QTest::newRow("other line ends") << file(polylist()).replace('\n', "\r\n");
}

void TestCollada::onlyUvsChange()
{
    QFETCH(QByteArray, bytes);
    Scene scene = sceneOf(bytes);
    const ColladaSource *source = sourceOf<ColladaSource>(scene);
    QVERIFY(source);
    QCOMPARE(rewriteCollada(*source, scene), bytes);
    if (scene.uvSets.empty())
        scene.uvSets = {{u"UVMap"_s, {}}};
    const UvMatrix before = scene.uvSets.back().uv;
    scene.uvSets[0].uv = newUv(*scene.mesh);
    const QByteArray out = rewriteCollada(*source, scene);
    QCOMPARE(restOf(out), restOf(bytes));
    QVERIFY(positionsIn(out) == positionsIn(bytes));
    const Scene again = sceneOf(out);
    QVERIFY(sourceOf<ColladaSource>(again));
    QCOMPARE(again.uvSets.size(), scene.uvSets.size());
    QVERIFY((again.uvSets[0].uv - scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-6);
    if (scene.uvSets.size() > 1)
        QVERIFY((again.uvSets[1].uv - before).isZero(0));
    QCOMPARE(exportLosses(scene, u"dae"_s), QStringList());
}

void TestCollada::textStaysInPlace()
{
    Scene scene = sceneOf(file(twoPrimitives()));
    scene.uvSets[0].uv.row(4) << 0.5, 0.125;
    const QByteArray out = rewriteCollada(*sourceOf<ColladaSource>(scene), scene);
    // The third column, and the corners of lines, which have no UV here, are kept.
    QVERIFY(out.contains(">0 0 7 1 0 7 1 1 8 0.5 0.125 8 0 1 8 0.25 0.75 9<"));
    QVERIFY(out.contains("<p>0 0 1 1 2 2 0 0 2 3 3 4</p>"));
    QVERIFY(out.contains("<p>0 0 1 1 1 1 2 2 4 5</p>"));
    QVERIFY(out.contains("count=\"18\">0 0 7"));
    Scene spaced = sceneOf(file(polylist()));
    spaced.uvSets[0].uv.row(0) << 3, 3;
    QVERIFY(rewriteCollada(*sourceOf<ColladaSource>(spaced), spaced)
                .contains("<p>0 0 1 1\n2 2 3 3  0 4 1 1 4 5\t1 1 2 2 4 5</p>"));
}

void TestCollada::newSet()
{
    Scene scene = sceneOf(file(polylist()));
    scene.uvSets.insert(scene.uvSets.begin(), {u"new"_s, newUv(*scene.mesh)});
    const QByteArray out = rewriteCollada(*sourceOf<ColladaSource>(scene), scene);
    QVERIFY(out.contains(uvInput +
                         R"(<input semantic="TEXCOORD" source="#autocuts-uv-0-1" offset="2" set="1"/>)"));
    const Scene again = sceneOf(out);
    QCOMPARE(again.uvSets.size(), std::size_t(2));
    QVERIFY((again.uvSets[0].uv - scene.uvSets[1].uv).isZero(0));
    QVERIFY((again.uvSets[1].uv - scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-6);
}

//! More sets than Assimp reads would make the file unreadable for it.
void TestCollada::tooManySets()
{
    Scene scene = sceneOf(file(polylist()));
    for (int s = 1; s < 10; ++s)
        scene.uvSets.push_back({u"set %1"_s.arg(s), newUv(*scene.mesh)});
    QVERIFY(exportLosses(scene, u"dae"_s).join(u' ').contains("after the eighth"_L1));
    const Scene again = sceneOf(rewriteCollada(*sourceOf<ColladaSource>(scene), scene));
    QCOMPARE(again.uvSets.size(), std::size_t(8));
    QVERIFY((again.uvSets[7].uv - scene.uvSets[7].uv).cwiseAbs().maxCoeff() < 1e-6);
}

void TestCollada::mirroredAndInstanced()
{
    Parts parts = polylist();
    parts.nodeScale = "-1 2 1";
    parts.moreNodes = R"(<node id="m"><instance_geometry url="#g"/></node>)";
    Scene scene = sceneOf(file(parts));
    QCOMPARE(scene.mesh->faceCount(), 6);
    QVERIFY(sourceOf<ColladaSource>(scene));
    scene.uvSets[0].uv = newUv(*scene.mesh);
    const Scene again = sceneOf(rewriteCollada(*sourceOf<ColladaSource>(scene), scene));
    QVERIFY((again.uvSets[0].uv - scene.uvSets[0].uv).topRows(10).cwiseAbs().maxCoeff() < 1e-6);
    QVERIFY(exportLosses(scene, u"dae"_s).join(u' ').contains("first node"_L1));
}

void TestCollada::otherTextIsLeftToAssimp_data()
{
    QTest::addColumn<QByteArray>("bytes");
    Parts strips = triangles();
    strips.primitives.replace("triangles", "tristrips");
    QTest::newRow("strips") << file(strips);
    QTest::newRow("commas") << file(triangles()).replace("0.25", "0,25");
}

void TestCollada::otherTextIsLeftToAssimp()
{
    QFETCH(QByteArray, bytes);
    Scene scene = sceneOf(bytes);
    QVERIFY(scene.source && !sourceOf<ColladaSource>(scene));
    scene.uvSets[0].uv = newUv(*scene.mesh);
    const QTemporaryDir folder;
    QVERIFY(writeMesh(scene, folder.filePath(u"a.dae"_s)).ok());
}

//! An object with several materials is one object in new files.
void TestCollada::materialsOfOneObject()
{
    const QTemporaryDir folder;
    const QString obj = folder.filePath(u"m.obj"_s), dae = folder.filePath(u"m.dae"_s);
    QVERIFY(saveAtomically(obj,
                           "o box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                           "usemtl a\nf 1/1 2/2 3/3 4/4\nusemtl b\nf 2/1 5/2 6/3\nusemtl a\nf 2/4 6/3 3/1\n"
                           "usemtl c\nf 5/2 7/1 6/4\n")
                .ok());
    const Scene before = readMesh(obj).value();
    QVERIFY(writeMesh(before, dae).ok());
    const QByteArray text = loadFile(dae, 1 << 20).value();
    QCOMPARE(text.count("<geometry "), 1);
    QCOMPARE(text.count("<polylist "), 3);
    QCOMPARE(text.count("<instance_geometry "), 1);
    QCOMPARE(text.count("<instance_material "), 3);
    const Scene after = readMesh(dae).value();
    QCOMPARE(after.objectNames, before.objectNames);
    QCOMPARE(after.mesh->faceCount(), before.mesh->faceCount());
    const auto looks = [](const Scene &scene) {
        std::map<QString, std::vector<double>> sums; // by material: corners, sums of places and UVs
        for (int f = 0; f < scene.mesh->faceCount(); ++f) {
            auto &sum = sums[scene.materialNames[static_cast<std::size_t>(scene.faceMaterial[f])]];
            sum.resize(4);
            for (int c = scene.mesh->faceStart[f]; c < scene.mesh->faceStart[f + 1]; ++c) {
                sum[0] += 1;
                sum[1] += scene.mesh->positions(scene.mesh->cornerVertex[c], 0);
                sum[2] += scene.uvSets[0].uv(c, 0);
                sum[3] += scene.uvSets[0].uv(c, 1);
            }
        }
        return sums;
    };
    QCOMPARE(looks(after), looks(before));
}

//! Assimp would make up a mesh of the nodes.
void TestCollada::noMeshesAreAnError()
{
    const QByteArray lights = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><up_axis>Y_UP</up_axis></asset>
  <library_lights><light id="l"><technique_common><point><color>1 1 1</color></point></technique_common></light>
  </library_lights>
  <library_visual_scenes><visual_scene id="s"><node id="a" name="a"><instance_light url="#l"/>
    <node id="b" name="b"><translate>1 0 0</translate></node></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"lights.dae"_s);
    QVERIFY(saveAtomically(path, lights).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(!scene.ok());
    QVERIFY2(scene.error().message.contains(u"no faces"), qPrintable(scene.error().message));
}

void TestCollada::mutations()
{
    std::mt19937 random(1);
    const QList<QByteArray> seeds{file(polylist()), file(inVertices()), file(twoPrimitives()),
                                  file(twoSets())};
    int read = 0;
    for (int i = 0; i < 4000; ++i) {
        QByteArray bytes = seeds[i % seeds.size()];
        for (auto changes = 1 + random() % 4; changes > 0; --changes) {
            const auto at = static_cast<qsizetype>(random() % std::size_t(bytes.size()));
            switch (random() % 3) {
            case 0:
                bytes[at] = static_cast<char>('0' + random() % 10);
                break;
            case 1:
                bytes.remove(at, 1 + qsizetype(random() % 9));
                break;
            default:
                bytes.insert(at, bytes.mid(qsizetype(random() % std::size_t(bytes.size())), 20));
            }
        }
        const std::optional<ColladaFile> collada =
            readCollada({bytes.constData(), std::size_t(bytes.size())});
        if (!collada)
            continue;
        ++read;
        for (const ColladaGeometry &geometry : collada->geometries) {
            for (const ColladaPrimitive &primitive : geometry.primitives)
                positionsOf(*collada, geometry, primitive);
        }
    }
    QVERIFY(read > 300);
    QVERIFY(!xmlSpans(QByteArray("<a>").repeated(100000).toStdString()));
}

void TestCollada::realFiles()
{
    const QDir folder(u"/usr/share/assimp/models/Collada"_s);
    const QStringList names = folder.entryList({u"*.dae"_s}, QDir::Files);
    if (names.isEmpty())
        QSKIP("Assimp's test models are not installed");
    int kept = 0;
    for (const QString &name : names) {
        Result<Scene> scene = readMesh(folder.filePath(name));
        const ColladaSource *source = scene ? sourceOf<ColladaSource>(scene.value()) : nullptr;
        if (!source)
            continue;
        ++kept;
        QVERIFY2(rewriteCollada(*source, scene.value()) == source->bytes, qPrintable(name));
        if (scene->uvSets.empty())
            scene->uvSets = {{u"UVMap"_s, {}}};
        scene->uvSets[0].uv = newUv(*scene->mesh);
        const Scene again = sceneOf(rewriteCollada(*source, scene.value()), name);
        QVERIFY2(sourceOf<ColladaSource>(again), qPrintable(name));
        QCOMPARE(again.uvSets.size(), scene->uvSets.size());
        if (!exportLosses(scene.value(), u"dae"_s).isEmpty())
            continue; // a mesh at several nodes
        QVERIFY2((again.uvSets[0].uv - scene->uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-5, qPrintable(name));
    }
    QVERIFY(kept > 15);
}

QTEST_GUILESS_MAIN(TestCollada)
#include "tst_collada.moc"
