// Vertex colours: how each format's become the colours of corners, sessions, and what writing keeps.
#include "model/io/fbx/fbxreader.h"
#include "model/io/formats/modelunits.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/obj/objreader.h"
#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectscene.h"
#include "model/plain/picture.h"
#include "support/fbxfiles.h"
#include "support/gltffiles.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>

namespace tst_cornercolors {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

//! What the files of this test give a vertex, by its place.
std::array<double, 3> colorAt(double x, double y)
{
    return {x / 4, y / 4, 0.6};
}

//! Empty when all corners have these colours. \param linear the file that they are of has linear ones
QString problemOf(const Scene &scene, bool linear)
{
    if (!scene.cornerColors)
        return u"there are no colours"_s;
    if (std::ssize(*scene.cornerColors) != scene.mesh->cornerCount())
        return u"their number is wrong"_s;
    for (int c = 0; c < scene.mesh->cornerCount(); ++c) {
        const Vec3 place = scene.mesh->cornerPosition(c);
        const std::array<double, 3> expected = colorAt(place.x(), place.y());
        const CornerColor &color = (*scene.cornerColors)[static_cast<std::size_t>(c)];
        for (int k = 0; k < 3; ++k) {
            const float value = linear ? color.value()[k] : srgbFromLinear(color.value()[k]);
            if (!color.known || std::abs(value - expected[static_cast<std::size_t>(k)]) > 0.01)
                return u"corner %1 has %2 in place of %3"_s.arg(c).arg(value).arg(expected[std::size_t(k)]);
        }
    }
    return {};
}

QByteArray obj(const QByteArray &colors)
{
    QByteArray text;
    const QList<QByteArray> ofVertices = colors.split(';');
    const char *places[] = {"0 0 0", "4 0 0", "4 4 0", "0 4 0"};
    for (qsizetype v = 0; v < 4; ++v)
        text += QByteArray("v ") + places[v] + ' ' + ofVertices.value(v) + '\n';
    return text + "f 1 2 3 4\n";
}

const QByteArray objColors = "0 0 .6;1 0 .6;1 1 .6;0 1 .6";

QByteArray ply(const QByteArray &type, const QByteArray &one, const QByteArray &blue)
{
    QByteArray text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                      "property float z\n";
    for (const char *name : {"red", "green", "blue"})
        text += "property " + type + ' ' + name + '\n';
    text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    text += "0 0 0 0 0 " + blue + "\n4 0 0 " + one + " 0 " + blue + "\n4 4 0 " + one + ' ' + one + ' ' +
            blue + "\n0 4 0 0 " + one + ' ' + blue + "\n4 0 1 2 3\n";
    return text;
}

//! Colours for the vertices of gltffiles::grid(). \param full the number that means 1
template <typename T>
std::vector<T> gridColors(int components, double full)
{
    std::vector<T> values;
    const std::vector<float> positions = gltffiles::gridPositions();
    for (std::size_t v = 0; v < gltffiles::gridVertices; ++v) {
        const auto color = colorAt(positions[3 * v], positions[3 * v + 1]);
        for (int k = 0; k < components; ++k)
            values.push_back(static_cast<T>(k < 3 ? full * color[std::size_t(k)] : full / 3));
    }
    return values;
}

template <typename T>
QByteArray gltf(int components, int type, double full, bool normalized)
{
    gltffiles::FileBuilder file = gltffiles::grid();
    const char *name = components == 3 ? "VEC3" : components == 4 ? "VEC4" : "VEC2";
    file.primitive()["attributes"]["COLOR_0"] =
        file.add(gridColors<T>(components, full), name, type, std::size_t(components));
    if (normalized)
        file.json["accessors"].back()["normalized"] = true;
    return file.glb();
}

using fbxfiles::Node;

//! A file of fbxfiles::quads() with a layer of colours. \param indices empty: there are none
QByteArray fbx(const QByteArray &mapping, const std::vector<double> &colors,
               const std::vector<std::int32_t> &indices = {}, bool binary = true)
{
    std::vector<Node> content{{"Colors", {colors}, {}}};
    if (!indices.empty())
        content.push_back({"ColorIndex", {indices}, {}});
    const Node element = fbxfiles::layerElement("LayerElementColor", 0, "colors", mapping,
                                                indices.empty() ? "Direct" : "IndexToDirect", content);
    Node layer = fbxfiles::layer(0, {});
    layer.children.push_back(
        {"LayerElement",
         {},
         {{"Type", {QByteArray("LayerElementColor")}, {}}, {"TypedIndex", {std::int32_t(0)}, {}}}});
    return fbxfiles::model({binary, 7400}, {{"quads", fbxfiles::quads({element, layer})}});
}

//! Of the six control points of fbxfiles::quads().
const std::vector<double> pointColors{0, 0,   .6, 1, .25, 0, .6, 1, .25, .25, .6, 1,
                                      0, .25, .6, 1, .5,  0, .6, 1, .5,  .25, .6, 1};
const std::vector<std::int32_t> cornerPoints{0, 1, 2, 3, 1, 4, 5, 2};

QByteArray dae(const QByteArray &colors)
{
    return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="urn:collada" version="1.4.1">
  <asset><up_axis>Y_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="pa" count="12">0 0 0 4 0 0 4 4 0 0 4 0</float_array><technique_common>
      <accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
      <param name="Z" type="float"/></accessor></technique_common></source>
    <source id="c"><float_array id="ca" count="12">)" +
           colors + R"(</float_array><technique_common>
      <accessor source="#ca" count="4" stride="3"><param name="R" type="float"/><param name="G" type="float"/>
      <param name="B" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/>
      <input semantic="COLOR" source="#c" offset="1"/><p>0 0 1 1 2 2 0 0 2 2 3 3</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
  </library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
}

bool mentionsColors(const QStringList &lines)
{
    return std::ranges::any_of(lines, [](const QString &line) { return line.contains(u"colours"_s); });
}

bool mentionsColors(const std::vector<QString> &notes)
{
    return mentionsColors(QStringList(notes.begin(), notes.end()));
}

} // namespace

class TestCornerColors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void formats_data();
    void formats();
    void damaged_data();
    void damaged();
    void someVertices();
    void onePrimitiveOfTwo();
    void mirroredInstance();
    void wrongCountIsRefused();
    void sessions_data() { formats_data(); }
    void sessions();
    void damagedSession();
    void writtenAgain_data();
    void writtenAgain();
    void otherFormats_data() { writtenAgain_data(); }
    void otherFormats();
    void losses();

private:
    Result<Scene> read(const QByteArray &bytes, const QString &format) const
    {
        QFile file(mFolder.filePath(u"model."_s + format));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            return Error{u"cannot write"_s, {}, 0, {}};
        file.close();
        return readMesh(file.fileName());
    }

    QTemporaryDir mFolder;
};

void TestCornerColors::formats_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("format");
    QTest::newRow("obj") << obj(objColors) << u"obj"_s;
    QTest::newRow("obj, bytes") << obj("0 0 153;255 0 153;255 255 153;0 255 153") << u"obj"_s;
    QTest::newRow("obj, alpha") << obj("0 0 .6 1;1 0 .6 1;1 1 .6 1;0 1 .6 0") << u"obj"_s;
    QTest::newRow("ply, bytes") << ply("uchar", "255", "153") << u"ply"_s;
    QTest::newRow("ply, floats") << ply("float", "1", "0.6") << u"ply"_s;
    QTest::newRow("glb, floats") << gltf<float>(3, 5126, 1, false) << u"glb"_s;
    QTest::newRow("glb, floats with alpha") << gltf<float>(4, 5126, 1, false) << u"glb"_s;
    QTest::newRow("glb, bytes") << gltf<std::uint8_t>(4, 5121, 255, true) << u"glb"_s;
    QTest::newRow("glb, shorts") << gltf<std::uint16_t>(3, 5123, 65535, true) << u"glb"_s;
    QTest::newRow("glb, bytes, not said to be normalized")
        << gltf<std::uint8_t>(3, 5121, 255, false) << u"glb"_s;
    QTest::newRow("fbx, by corner") << fbx("ByPolygonVertex", pointColors, cornerPoints) << u"fbx"_s;
    QTest::newRow("fbx, by vertex") << fbx("ByVertice", pointColors) << u"fbx"_s;
    QTest::newRow("fbx, text") << fbx("ByVertice", pointColors, {}, false) << u"fbx"_s;
    QTest::newRow("dae") << dae("0 0 .6 1 0 .6 1 1 .6 0 1 .6") << u"dae"_s;
}

void TestCornerColors::formats()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, format);
    const Result<Scene> scene = read(bytes, format);
    QVERIFY2(scene.ok(), qPrintable(scene.ok() ? QString() : scene.error().toString()));
    QCOMPARE(problemOf(scene.value(), format == u"glb"_s), QString());
    QVERIFY(!mentionsColors(scene->notes));
}

void TestCornerColors::damaged_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("format");
    QTest::addColumn<bool>("noted");
    QTest::newRow("obj, weights") << obj("1;1;1;1") << u"obj"_s << false;
    QTest::newRow("obj, two numbers") << obj("1 0;1 0;1 0;1 0") << u"obj"_s << true;
    QTest::newRow("obj, not a number") << obj("nan 0 0;1 inf 0;1 0 1e999;x y z") << u"obj"_s << true;
    QTest::newRow("obj, all white") << obj("1 1 1;1 1 1;1 1 1;1 1 1") << u"obj"_s << false;
    QTest::newRow("obj, negative") << obj("-1 -1 -1;0 0 -1;0 -1 0;-1 0 0") << u"obj"_s << true;
    QTest::newRow("glb, two numbers") << gltf<float>(2, 5126, 1, false) << u"glb"_s << true;
    QTest::newRow("glb, not finite") << gltf<float>(3, 5126, notANumber, false) << u"glb"_s << false;
    QTest::newRow("fbx, too few") << fbx("ByPolygonVertex", pointColors) << u"fbx"_s << true;
    QTest::newRow("fbx, none") << fbx("ByPolygonVertex", {}) << u"fbx"_s << true;
    QTest::newRow("fbx, wrong indices")
        << fbx("ByPolygonVertex", pointColors, {6, 7, -1, -9, 99, 1 << 30, 6, 6}) << u"fbx"_s << false;
    QTest::newRow("fbx, not finite") << fbx("ByVertice", std::vector<double>(24, notANumber)) << u"fbx"_s
                                     << false;
}

void TestCornerColors::damaged()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, format);
    QFETCH(bool, noted);
    const Result<Scene> scene = read(bytes, format);
    QVERIFY2(scene.ok(), qPrintable(scene.ok() ? QString() : scene.error().toString()));
    QVERIFY(!scene->cornerColors);
    QCOMPARE(mentionsColors(scene->notes), noted);
}

//! Colours outside of 0 to 1 are clamped; vertices without one stay without.
void TestCornerColors::someVertices()
{
    const Result<Scene> scene = parseObj(obj(";0.5 7 0.25;;"), u"some.obj"_s);
    QVERIFY(scene.ok() && scene->cornerColors);
    const CornerColors &colors = *scene->cornerColors;
    QVERIFY(!colors[0].known && colors[1].known && !colors[2].known && !colors[3].known);
    QCOMPARE(colors[1].linear[1], std::uint16_t(65535));
}

void TestCornerColors::onePrimitiveOfTwo()
{
    gltffiles::FileBuilder file = gltffiles::grid();
    file.json["meshes"][0]["primitives"].push_back(file.primitive());
    file.json["meshes"][0]["primitives"][1]["attributes"]["COLOR_0"] =
        file.add(gridColors<float>(3, 1), "VEC3", 5126, 3);
    file.json["meshes"][0]["primitives"].push_back(file.primitive());
    const Scene scene = gltffiles::parsed(file.glb());
    QVERIFY(scene.cornerColors);
    const int third = scene.mesh->cornerCount() / 3;
    for (int c = 0; c < scene.mesh->cornerCount(); ++c)
        QCOMPARE((*scene.cornerColors)[std::size_t(c)].known, c / third == 1);
}

//! The corners of mirrored faces are in reverse order.
void TestCornerColors::mirroredInstance()
{
    gltffiles::FileBuilder file = gltffiles::instanced();
    file.primitive()["attributes"]["COLOR_0"] = file.add(gridColors<float>(3, 1), "VEC3", 5126, 3);
    const Scene scene = gltffiles::parsed(file.glb());
    QVERIFY(scene.cornerColors);
    const int half = scene.mesh->cornerCount() / 2;
    for (int c = 0; c < half; c += 3) {
        const auto at = [&](int corner) { return (*scene.cornerColors)[std::size_t(corner)]; };
        QCOMPARE(at(half + c), at(c + 2));
        QCOMPARE(at(half + c + 1), at(c + 1));
    }
}

void TestCornerColors::wrongCountIsRefused()
{
    gltffiles::FileBuilder file = gltffiles::grid();
    std::vector<float> colors = gridColors<float>(3, 1);
    colors.resize(colors.size() - 3);
    file.primitive()["attributes"]["COLOR_0"] = file.add(colors, "VEC3", 5126, 3);
    const Result<Scene> scene = parseGltf({file.glb(), {}}, u"wrong.glb"_s);
    QVERIFY(!scene.ok());
    QVERIFY2(scene.error().message.contains(u"different numbers"_s), qPrintable(scene.error().message));
}

void TestCornerColors::sessions()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, format);
    Result<Scene> scene = read(bytes, format);
    QVERIFY(scene.ok());
    const DocumentState state = DocumentState::initial(std::move(scene).value());
    const QString path = mFolder.filePath(u"session.acproj"_s);
    QVERIFY(saveProject(state, {}, path).ok());
    const Result<LoadedProject> loaded = loadProject(path);
    QVERIFY2(loaded.ok(), qPrintable(loaded.ok() ? QString() : loaded.error().toString()));
    QVERIFY(loaded->state.scene.cornerColors);
    QVERIFY(*loaded->state.scene.cornerColors == *state.scene.cornerColors);
}

void TestCornerColors::damagedSession()
{
    Result<Scene> scene = read(ply("uchar", "255", "153"), u"ply"_s);
    QVERIFY(scene.ok());
    scene->cornerColors = std::make_shared<const CornerColors>(2);
    const PartMap parts = scenePartsOf(scene.value());
    QStringList lost;
    const Result<Scene> again = readSceneParts(parts, u"session"_s, lost);
    QVERIFY(again.ok() && !again->cornerColors);
    QVERIFY(mentionsColors(lost));
}

void TestCornerColors::writtenAgain_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("format");
    QTest::newRow("obj") << obj(objColors) << u"obj"_s;
    QTest::newRow("ply") << ply("uchar", "255", "153") << u"ply"_s;
    QTest::newRow("glb") << gltf<std::uint8_t>(4, 5121, 255, true) << u"glb"_s;
    QTest::newRow("fbx") << fbx("ByPolygonVertex", pointColors, cornerPoints) << u"fbx"_s;
    QTest::newRow("dae") << dae("0 0 .6 1 0 .6 1 1 .6 0 1 .6") << u"dae"_s;
}

//! With new UVs that have seams.
void TestCornerColors::writtenAgain()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, format);
    Result<Scene> scene = read(bytes, format);
    QVERIFY(scene.ok());
    scene->uvSets = {{u"UVMap"_s, gltffiles::seamyUv(*scene->mesh)}};
    QVERIFY(!mentionsColors(exportLosses(scene.value(), format)));
    const QString path = mFolder.filePath(u"again."_s + format);
    QVERIFY(writeMesh(scene.value(), path).ok());
    const Result<Scene> again = readMesh(path);
    QVERIFY(again.ok() && again->hasUv());
    QCOMPARE(problemOf(again.value(), format == u"glb"_s), QString());
}

void TestCornerColors::otherFormats()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, format);
    const Result<Scene> scene = read(bytes, format);
    QVERIFY(scene.ok());
    for (const QString &other : {u"glb"_s, u"ply"_s, u"dae"_s, u"fbx"_s}) {
        QVERIFY(!mentionsColors(certainExportLosses(scene.value(), other)));
        const QString path = mFolder.filePath(u"other."_s + other);
        QVERIFY(writeMesh(scene.value(), path).ok());
        const Result<Scene> again = readMesh(path);
        QVERIFY(again.ok());
        // The same light, whatever the numbers in the files.
        const QString problem =
            problemOf(inUnitsOf(again.value(), unitsOf(scene.value())), format == u"glb"_s);
        QVERIFY2(problem.isEmpty(), qPrintable(other + u": "_s + problem));
    }
}

void TestCornerColors::losses()
{
    const Result<Scene> scene = parseObj(obj(objColors), u"colored.obj"_s);
    const Result<Scene> plain = parseObj(obj({}), u"plain.obj"_s);
    QVERIFY(scene.ok() && plain.ok());
    // FBX has colours; OBJ files of models from other formats have none.
    QVERIFY(!mentionsColors(exportLosses(scene.value(), u"fbx"_s)));
    Scene foreign = scene.value();
    foreign.source.reset();
    QVERIFY(mentionsColors(exportLosses(foreign, u"obj"_s)));
    QVERIFY(!mentionsColors(exportLosses(plain.value(), u"obj"_s)));
}

QTEST_GUILESS_MAIN(TestCornerColors)

} // namespace tst_cornercolors

#include "tst_cornercolors.moc"
