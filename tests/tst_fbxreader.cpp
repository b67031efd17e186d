// Reading FBX files: polygons, places, objects, materials, UV sets, hard edges.
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxsource.h"
#include "support/fbxfiles.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace tst_fbxreader {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using fbxfiles::Kind;
using fbxfiles::Node;
using fbxfiles::Object;

namespace {

Scene parsed(const QByteArray &bytes)
{
    Result<Scene> scene = parseFbx(bytes, u"a.fbx"_s);
    if (!scene)
        qFatal("%s", qPrintable(scene.error().toString()));
    const std::string problem = scene->mesh->validate();
    if (!problem.empty())
        qFatal("%s", problem.c_str());
    return std::move(scene).value();
}

Scene parsed(const Kind &kind, const std::vector<Object> &objects)
{
    return parsed(fbxfiles::model(kind, objects));
}

std::vector<double> numbers(const UvMatrix &uv)
{
    return {uv.data(), uv.data() + uv.size()};
}

QStringList setNames(const Scene &scene)
{
    QStringList names;
    for (const UvSet &set : scene.uvSets)
        names << set.name;
    return names;
}

Object quadObject(const QByteArray &name, const std::vector<QByteArray> &sets)
{
    std::vector<Node> elements;
    for (int s = 0; s < std::ssize(sets); ++s)
        elements.push_back(fbxfiles::uvElement(s, sets[s]));
    return {name, fbxfiles::quads(elements)};
}

const std::vector<double> quadUvs{0, 0, 0.5, 0, 0.5, 1, 0, 1, 0.5, 0, 1, 0, 1, 1, 0.5, 1};

bool near(const Vec3 &a, const Vec3 &b)
{
    return (a - b).norm() < 1e-12;
}

} // namespace

class TestFbxReader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void kinds_data();
    void kinds();
    void mappings_data();
    void mappings();
    void setsOfSeveralObjects_data();
    void setsOfSeveralObjects();
    void transforms();
    void parentsAndCircles();
    void mirroredFacesAreTurned();
    void instances();
    void materials();
    void hardEdgesOfNormals();
    void hardEdgesOfSmoothing();
    void oddPolygons();
    void noFaces();
    void stops();
};

void TestFbxReader::kinds_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("binary 6100") << Kind{true, 6100};
    QTest::newRow("binary 7100 big-endian") << Kind{true, 7100, true};
    QTest::newRow("binary 7400") << Kind{true, 7400};
    QTest::newRow("binary 7700") << Kind{true, 7700};
    QTest::newRow("text 6100") << Kind{false, 6100};
    QTest::newRow("text 7500") << Kind{false, 7500, false, true, "\r\n"};
}

void TestFbxReader::kinds()
{
    QFETCH(Kind, kind);
    Object object = quadObject("one two", {"UVMap", "second"});
    object.properties = {fbxfiles::property(kind, "Lcl Translation", {10, 0, 0})};
    object.materials = {"red"};
    Object child = quadObject("child", {"UVMap"});
    child.properties = {fbxfiles::property(kind, "Lcl Translation", {0, 5, 0})};
    child.parent = 0;
    const QByteArray bytes = fbxfiles::model(kind, {object, child});
    const Scene scene = parsed(bytes);
    const MeshData &mesh = *scene.mesh;
    QCOMPARE(scene.format, u"fbx"_s);
    QCOMPARE(mesh.faceStart, (std::vector<int>{0, 4, 8, 12, 16}));
    QCOMPARE(mesh.cornerVertex, (std::vector<int>{0, 1, 2, 3, 1, 4, 5, 2, 6, 7, 8, 9, 7, 10, 11, 8}));
    QCOMPARE(mesh.vertexCount(), 12);
    QVERIFY(near(mesh.positions.row(5), {12, 1, 0}));
    QVERIFY(near(mesh.positions.row(11), {12, 6, 0}));
    QCOMPARE(scene.objectNames, (std::vector<QString>{u"one two"_s, u"child"_s}));
    QCOMPARE(mesh.faceObject, (std::vector<int>{0, 0, 1, 1}));
    QCOMPARE(scene.materialNames, (std::vector<QString>{u"red"_s}));
    QCOMPARE(scene.faceMaterial, (std::vector<int>{0, 0, -1, -1}));
    QCOMPARE(setNames(scene), (QStringList{u"UVMap"_s, u"second"_s}));
    QCOMPARE(numbers(scene.uvSets[0].uv.topRows(8)), quadUvs);
    QCOMPARE(numbers(scene.uvSets[0].uv.bottomRows(8)), quadUvs);
    QVERIFY(scene.uvSets[1].uv.topRows(8).allFinite());
    QVERIFY(!scene.uvSets[1].uv.row(8).allFinite());
    QVERIFY(scene.notes.empty());
    const FbxSource *source = sourceOf<FbxSource>(scene);
    QVERIFY(source);
    QCOMPARE(source->bytes, bytes);
}

void TestFbxReader::mappings_data()
{
    using Numbers = std::vector<double>;
    using Indices = std::vector<std::int32_t>;
    QTest::addColumn<QByteArray>("mapping");
    QTest::addColumn<QByteArray>("reference");
    QTest::addColumn<Numbers>("uv");
    QTest::addColumn<Indices>("index");
    QTest::addColumn<Numbers>("expected"); // u of the corners
    QTest::addColumn<bool>("fits");
    const double none = -99; // NaN
    const Numbers eight{0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0};
    const Numbers six{0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0};
    const Numbers two{0, 0, 1, 0};
    const Numbers corners{0, 1, 2, 3, 4, 5, 6, 7};
    const Numbers points{0, 1, 2, 3, 1, 4, 5, 2};
    const Numbers nothing(8, none);
    const Indices eightOfSix{5, 4, 3, 2, 1, 0, 0, 1};
    const auto row = [](const char *name, const char *mapping, const char *reference, const Numbers &uv,
                        const Indices &index, const Numbers &expected, bool fits = true) {
        QTest::newRow(name) << QByteArray(mapping) << QByteArray(reference) << uv << index << expected
                            << fits;
    };
    const char *corner = "ByPolygonVertex";
    const char *indexed = "IndexToDirect";
    row("corner, direct", corner, "Direct", eight, {}, corners);
    row("corner, indexed", corner, indexed, six, eightOfSix, {5, 4, 3, 2, 1, 0, 0, 1});
    row("corner, called Index", corner, "Index", six, eightOfSix, {5, 4, 3, 2, 1, 0, 0, 1});
    row("corner, without index", corner, indexed, eight, {}, corners);
    row("corner, holes", corner, indexed, six, {0, -1, 2, 6, 4, 5, -7, 1}, {0, none, 2, none, 4, 5, none, 1});
    row("corner, long", corner, indexed, six, {5, 4, 3, 2, 1, 0, 0, 1, 9, 9}, {5, 4, 3, 2, 1, 0, 0, 1});
    row("corner, short index", corner, indexed, six, {0, 1, 2}, nothing, false);
    row("corner, short values", corner, "Direct", six, {}, nothing, false);
    row("control point, direct", "ByVertice", "Direct", six, {}, points);
    row("control point, indexed", "ByVertex", indexed, six, {5, 4, 3, 2, 1, 0}, {5, 4, 3, 2, 4, 1, 0, 3});
    row("control point, short", "ByVertice", "Direct", two, {}, nothing, false);
    row("polygon, direct", "ByPolygon", "Direct", two, {}, {0, 0, 0, 0, 1, 1, 1, 1});
    row("polygon, indexed", "ByPolygon", indexed, two, {1, 0}, {1, 1, 1, 1, 0, 0, 0, 0});
    row("all the same", "AllSame", "Direct", {7, 0}, {}, Numbers(8, 7));
    row("all the same, empty", "AllSame", "Direct", {}, {}, nothing, false);
    row("not said, corners", "", indexed, six, eightOfSix, {5, 4, 3, 2, 1, 0, 0, 1});
    row("not said, control points", "", "Direct", six, {}, points);
    row("not said, neither", "", "Direct", two, {}, nothing, false);
    row("edges", "ByEdge", "Direct", two, {}, nothing, false);
    row("not finite", corner, "Direct", {0, 0, std::nan(""), 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0}, {},
        {0, none, 2, 3, 4, 5, 6, 7});
}

void TestFbxReader::mappings()
{
    QFETCH(QByteArray, mapping);
    QFETCH(QByteArray, reference);
    QFETCH(std::vector<double>, uv);
    QFETCH(std::vector<std::int32_t>, index);
    QFETCH(std::vector<double>, expected);
    QFETCH(bool, fits);
    for (const Kind &kind : {Kind{true, 7400}, Kind{false, 7400}, Kind{false, 6100}}) {
        std::vector<Node> content{{"UV", {uv}, {}}};
        if (!index.empty())
            content.push_back({"UVIndex", {index}, {}});
        const Node element = fbxfiles::layerElement("LayerElementUV", 0, "map", mapping, reference, content);
        const Scene scene = parsed(kind, {{"a", fbxfiles::quads({element})}});
        QCOMPARE(setNames(scene), QStringList{u"map"_s});
        for (std::size_t c = 0; c < expected.size(); ++c) {
            const double u = scene.uvSets[0].uv(static_cast<Eigen::Index>(c), 0);
            if (expected[c] == -99)
                QVERIFY(!scene.uvSets[0].uv.row(static_cast<Eigen::Index>(c)).allFinite());
            else
                QCOMPARE(u, expected[c]);
        }
        QCOMPARE(scene.notes.empty(), fits);
        if (!fits)
            QVERIFY(scene.notes[0].contains(u"\"map\" of \"a\""_s));
    }
}

void TestFbxReader::setsOfSeveralObjects_data()
{
    using Names = std::vector<QByteArray>;
    QTest::addColumn<std::vector<Names>>("objects");
    QTest::addColumn<QStringList>("sets");
    QTest::addColumn<QStringList>("members"); // by set: the numbers of the objects that have it
    const auto row = [](const char *name, const std::vector<Names> &objects, const QStringList &sets,
                        const QStringList &members) { QTest::newRow(name) << objects << sets << members; };
    row("equal", {{"a", "b"}, {"a", "b"}}, {u"a"_s, u"b"_s}, {u"01"_s, u"01"_s});
    row("other order", {{"a", "b"}, {"b", "a"}}, {u"a"_s, u"b"_s}, {u"01"_s, u"01"_s});
    row("only the second", {{"a", "b"}, {"b"}}, {u"a"_s, u"b"_s}, {u"0"_s, u"01"_s});
    row("other names", {{"UVMap"}, {"map1"}, {"map1"}}, {u"UVMap"_s}, {u"012"_s});
    row("name of both", {{"a"}, {"b"}, {"a", "b"}}, {u"a"_s, u"b"_s}, {u"012"_s, u"2"_s});
    row("none, then one", {{}, {"a"}}, {u"a"_s}, {u"1"_s});
    row("without names", {{"", ""}, {""}}, {u"UVMap"_s, u"UVMap.2"_s}, {u"01"_s, u"0"_s});
    row("one name twice", {{"a", "a"}}, {u"a"_s, u"a.2"_s}, {u"0"_s, u"0"_s});
}

void TestFbxReader::setsOfSeveralObjects()
{
    QFETCH(std::vector<std::vector<QByteArray>>, objects);
    QFETCH(QStringList, sets);
    QFETCH(QStringList, members);
    std::vector<Object> made;
    for (const auto &names : objects)
        made.push_back(quadObject("object" + QByteArray::number(std::ssize(made)), names));
    const Scene scene = parsed({}, made);
    QCOMPARE(setNames(scene), sets);
    for (qsizetype s = 0; s < sets.size(); ++s) {
        QString found;
        for (int o = 0; o < std::ssize(objects); ++o) {
            if (scene.uvSets[s].uv.row(8 * o).allFinite())
                found += QString::number(o);
        }
        QCOMPARE(found, members[s]);
    }
}

void TestFbxReader::transforms()
{
    const auto place = [](const std::vector<Node> &properties, const Kind &kind = {}) {
        Object object = quadObject("a", {});
        object.properties = properties;
        return Vec3(parsed(kind, {object}).mesh->positions.row(1)); // the point 1 0 0
    };
    const auto with = [](const char *name, const std::vector<double> &values) {
        return fbxfiles::property({}, name, values);
    };
    const Node active = with("RotationActive", {1});
    QVERIFY(near(place({}), {1, 0, 0}));
    QVERIFY(near(place({with("Lcl Rotation", {0, 0, 90})}), {0, 1, 0}));
    // x first, then y, then z.
    QVERIFY(near(place({with("Lcl Rotation", {90, 0, 90})}), {0, 1, 0}));
    QVERIFY(near(place({with("Lcl Rotation", {90, 0, 90}), with("RotationOrder", {5}), active}), {0, 0, 1}));
    QVERIFY(near(place({with("Lcl Rotation", {90, 0, 90}), with("RotationOrder", {5})}), {0, 1, 0}));
    QVERIFY(near(place({with("PreRotation", {0, 0, 90}), active}), {0, 1, 0}));
    QVERIFY(near(place({with("PreRotation", {0, 0, 90})}), {1, 0, 0}));
    QVERIFY(near(place({with("PostRotation", {0, 0, 90}), active}), {0, -1, 0}));
    QVERIFY(near(place({with("Lcl Scaling", {3, 1, 1})}), {3, 0, 0}));
    QVERIFY(near(place({with("Lcl Scaling", {3, 1, 1}), with("ScalingPivot", {1, 0, 0})}), {1, 0, 0}));
    QVERIFY(near(place({with("Lcl Rotation", {0, 0, 90}), with("RotationPivot", {1, 0, 0})}), {1, 0, 0}));
    QVERIFY(near(place({with("RotationOffset", {0, 2, 0}), with("ScalingOffset", {0, 0, 3})}), {1, 2, 3}));
    QVERIFY(near(place({with("GeometricTranslation", {0, 4, 0}), with("GeometricScaling", {2, 2, 2}),
                        with("Lcl Translation", {1, 0, 0})}),
                 {3, 4, 0}));
    QVERIFY(near(place({with("Lcl Translation", {std::nan(""), 0, 0})}), {1, 0, 0}));
}

void TestFbxReader::parentsAndCircles()
{
    Object far = quadObject("far", {});
    far.properties = {fbxfiles::property({}, "Lcl Scaling", {2, 2, 2}),
                      fbxfiles::property({}, "GeometricTranslation", {100, 0, 0})};
    Object child = quadObject("child", {});
    child.properties = {fbxfiles::property({}, "Lcl Translation", {0, 1, 0})};
    child.parent = 0;
    const Scene scene = parsed({}, {far, child});
    QVERIFY(near(scene.mesh->positions.row(1), {202, 0, 0}));
    QVERIFY(near(scene.mesh->positions.row(7), {2, 2, 0})); // without the geometry's own transform
    Object a = quadObject("a", {});
    Object b = quadObject("b", {});
    a.parent = 1;
    b.parent = 0;
    QCOMPARE(parsed({}, {a, b}).mesh->faceCount(), 4);
}

void TestFbxReader::mirroredFacesAreTurned()
{
    Object object = quadObject("a", {"UVMap"});
    object.properties = {fbxfiles::property({}, "Lcl Scaling", {-1, 1, 1})};
    const Scene scene = parsed({}, {object});
    QCOMPARE(scene.mesh->cornerVertex, (std::vector<int>{3, 2, 1, 0, 2, 5, 4, 1}));
    QCOMPARE(numbers(scene.uvSets[0].uv),
             (std::vector<double>{0, 1, 0.5, 1, 0.5, 0, 0, 0, 0.5, 1, 1, 1, 1, 0, 0.5, 0}));
}

void TestFbxReader::instances()
{
    Object second{"second", {}};
    second.properties = {fbxfiles::property({}, "Lcl Translation", {0, 0, 9})};
    const Scene scene = parsed({}, {quadObject("first", {"UVMap"}), second});
    QCOMPARE(scene.mesh->faceCount(), 4);
    QCOMPARE(scene.mesh->positions(6, 2), 9.0);
    QCOMPARE(numbers(scene.uvSets[0].uv.bottomRows(8)), quadUvs);
    QVERIFY(scene.notes.at(0).contains(u"1 object(s) share a mesh"_s));
    QVERIFY(sourceOf<FbxSource>(scene)->contents.instances);
    QCOMPARE(sourceOf<FbxSource>(scene)->uses.at(0).instances.size(), std::size_t(2));
}

void TestFbxReader::materials()
{
    const auto element = [](const char *mapping, const std::vector<std::int32_t> &slots) {
        return fbxfiles::layerElement("LayerElementMaterial", 0, "", mapping, "IndexToDirect",
                                      {{"Materials", {slots}, {}}});
    };
    for (const Kind &kind : {Kind{true, 7400}, Kind{false, 6100}}) {
        const std::vector<QByteArray> both{"red", "blue"};
        const Scene scene =
            parsed(kind, {{"a", fbxfiles::quads({element("ByPolygon", {1, 0})}), {}, -1, both},
                          {"b", fbxfiles::quads({element("AllSame", {0})}), {}, -1, {"blue"}},
                          {"c", fbxfiles::quads({element("ByPolygon", {1, 7})}), {}, -1, both}});
        QCOMPARE(scene.materialNames, (std::vector<QString>{u"red"_s, u"blue"_s}));
        QCOMPARE(scene.faceMaterial, (std::vector<int>{1, 0, 1, 1, 1, -1}));
    }
}

void TestFbxReader::hardEdgesOfNormals()
{
    const auto hard = [](const std::vector<double> &second) {
        std::vector<double> normals;
        for (int c = 0; c < 8; ++c) {
            const std::vector<double> up{0, 0, 1};
            const std::vector<double> &n = c < 4 ? up : second;
            normals.insert(normals.end(), n.begin(), n.end());
        }
        const Node element = fbxfiles::layerElement("LayerElementNormal", 0, "", "ByPolygonVertex", "Direct",
                                                    {{"Normals", {normals}, {}}});
        return parsed({}, {{"a", fbxfiles::quads({element})}}).hardEdges;
    };
    QCOMPARE(std::ranges::count(hard({0, 0, 1}), true), 0);
    QCOMPARE(std::ranges::count(hard({0, 0.5, 0.5}), true), 1);
}

void TestFbxReader::hardEdgesOfSmoothing()
{
    const auto hard = [](const char *mapping, const std::vector<std::int32_t> &values,
                         bool mirrored = false) {
        const Node element = fbxfiles::layerElement("LayerElementSmoothing", 0, "", mapping, "Direct",
                                                    {{"Smoothing", {values}, {}}});
        const std::vector<std::int32_t> edges{0, 1, 2, 3, 4, 5, 6};
        Object object{"a", fbxfiles::quads({{"Edges", {edges}, {}}, element})};
        if (mirrored)
            object.properties = {fbxfiles::property({}, "Lcl Scaling", {1, -1, 1})};
        return std::ranges::count(parsed({}, {object}).hardEdges, true);
    };
    QCOMPARE(hard("ByPolygon", {1, 3}), 0);
    QCOMPARE(hard("ByPolygon", {1, 2}), 1);
    QCOMPARE(hard("ByPolygon", {0, 0}), 1);
    QCOMPARE(hard("ByPolygon", {1}), 0);
    for (const bool mirrored : {false, true}) {
        // The edge that both quads have starts at corner 1.
        QCOMPARE(hard("ByEdge", {1, 0, 1, 1, 1, 1, 1}, mirrored), 1);
        QCOMPARE(hard("ByEdge", {0, 1, 0, 0, 0, 0, 0}, mirrored), 0);
    }
}

void TestFbxReader::oddPolygons()
{
    // A line, a point, a wrong index, a face of two points, a good triangle, and a polygon without end.
    const std::vector<std::int32_t> corners{0, -2, -1, 0, 1, -10, 0, 1, -1, 0, 1, -3, 0, 1, 2};
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 1, 1, 0, std::nan(""), 0, 0};
    std::vector<double> uv;
    for (int c = 0; c < 15; ++c)
        uv.insert(uv.end(), {double(c), 0});
    const Node element =
        fbxfiles::layerElement("LayerElementUV", 0, "map", "ByPolygonVertex", "Direct", {{"UV", {uv}, {}}});
    const Scene scene =
        parsed({}, {{"a", {{"Vertices", {points}, {}}, {"PolygonVertexIndex", {corners}, {}}, element}}});
    QCOMPARE(scene.mesh->cornerVertex, (std::vector<int>{0, 1, 2}));
    QCOMPARE(numbers(scene.uvSets[0].uv), (std::vector<double>{9, 0, 10, 0, 11, 0}));
    QVERIFY(scene.notes.at(0).contains(u"2 point(s) and line(s)"_s));
    QVERIFY(scene.notes.at(1).contains(u"3 face(s) left out"_s));
}

void TestFbxReader::noFaces()
{
    const Result<Scene> empty = parseFbx(fbxfiles::model({}, {}), u"a.fbx"_s);
    QVERIFY(!empty.ok());
    QVERIFY(empty.error().message.contains(u"no faces"_s));
    const Result<Scene> surface = parseFbx("; FBX 7.4.0 project file\n"
                                           "FBXHeaderExtension:  {\n\tFBXVersion: 7400\n}\n"
                                           "Objects:  {\n"
                                           "\tGeometry: 1, \"Geometry::\", \"NurbsSurface\" {\n\t}\n"
                                           "\tModel: 2, \"Model::arm\", \"LimbNode\" {\n\t}\n"
                                           "}\n",
                                           u"a.fbx"_s);
    QVERIFY(!surface.ok());
    QCOMPARE(surface.error().message, u"the file has no faces, only NURBS surfaces, a skeleton"_s);
    QVERIFY(surface.error().remedy.contains(u"to polygons"));
    Object damaged{"a", {{"Vertices", {QByteArray("?")}, {}}, {"PolygonVertexIndex", {}, {}}}};
    const Result<Scene> broken = parseFbx(fbxfiles::model({}, {damaged}), u"a.fbx"_s);
    QVERIFY(!broken.ok());
    QVERIFY(broken.error().message.contains(u"damaged"_s));
}

void TestFbxReader::stops()
{
    const std::atomic<bool> stop = true;
    const QByteArray bytes = fbxfiles::model({}, {quadObject("a", {})});
    const Result<Scene> scene = parseFbx(bytes, u"a.fbx"_s, &stop);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().message.contains(u"cancel"_s, Qt::CaseInsensitive));
}

QTEST_APPLESS_MAIN(TestFbxReader)

} // namespace tst_fbxreader

#include "tst_fbxreader.moc"
