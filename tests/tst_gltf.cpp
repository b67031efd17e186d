// glTF files come back changed in nothing but their UVs: containers, attributes, seams, sessions, damage.
#include "model/io/exportlosses.h"
#include "model/io/gltf/gltfprimitive.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfwriter.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/io/projectscene.h"
#include "model/io/savefile.h"

#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int gridSize = 4;
constexpr int gridVertices = (gridSize + 1) * (gridSize + 1);

//! Puts a glTF file together.
struct FileBuilder
{
    Json json{{"asset", {{"version", "2.0"}, {"extras", {{"kept", 1.5}}}}}, {"unknown", {"kept", 7}}};
    QByteArray buffer;

    int addView(const QByteArray &bytes, int stride = 0)
    {
        buffer.append(-buffer.size() & 3, '\0');
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
        if (stride > 0)
            json["bufferViews"].back()["byteStride"] = stride;
        buffer.append(bytes);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    int addAccessor(int view, const char *type, int componentType, std::size_t count)
    {
        json["accessors"].push_back({{"bufferView", view},
                                     {"componentType", componentType},
                                     {"count", count},
                                     {"type", type},
                                     {"name", "accessor " + std::to_string(json["accessors"].size())}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    template <typename T>
    int add(const std::vector<T> &values, const char *type, int componentType, std::size_t components)
    {
        const QByteArray bytes(reinterpret_cast<const char *>(values.data()),
                               static_cast<qsizetype>(values.size() * sizeof(T)));
        return addAccessor(addView(bytes), type, componentType, values.size() / components);
    }
    Json &primitive() { return json["meshes"][0]["primitives"][0]; }

    //! The .glb file.
    QByteArray glb() const
    {
        GltfDocument document{json, {buffer}, {}};
        document.json["buffers"] = {{{"byteLength", buffer.size()}}};
        return glbBytes(std::move(document));
    }
    //! The .gltf file. \param uri of the buffer; empty: a data URI
    QByteArray text(const std::string &uri = {}) const
    {
        Json whole = json;
        whole["buffers"] = {{{"byteLength", buffer.size()}, {"uri", uri.empty() ? dataUri(buffer) : uri}}};
        return jsonText(whole, "{\n  \"a\"");
    }
};

std::vector<float> gridPositions()
{
    std::vector<float> positions;
    for (int v = 0; v < gridVertices; ++v) {
        const float x = float(v % (gridSize + 1));
        const float y = float(v / (gridSize + 1));
        positions.insert(positions.end(), {x, y, 0.25f * x * y});
    }
    return positions;
}

std::vector<float> gridUvs()
{
    std::vector<float> uvs;
    for (int v = 0; v < gridVertices; ++v) {
        uvs.push_back(float(v % (gridSize + 1)) / 7);
        uvs.push_back(float(v / (gridSize + 1)) / 7);
    }
    return uvs;
}

std::vector<std::uint16_t> gridTriangles()
{
    std::vector<std::uint16_t> triangles;
    for (int q = 0; q < gridSize * gridSize; ++q) {
        const int a = q / gridSize * (gridSize + 1) + q % gridSize;
        for (const int v : {a, a + 1, a + gridSize + 2, a, a + gridSize + 2, a + gridSize + 1})
            triangles.push_back(static_cast<std::uint16_t>(v));
    }
    return triangles;
}

//! Values that differ from vertex to vertex.
template <typename T>
std::vector<T> counted(std::size_t components)
{
    std::vector<T> values;
    for (std::size_t i = 0; i < gridVertices * components; ++i)
        values.push_back(static_cast<T>(i * 7 % 251));
    return values;
}

//! A bumpy grid of 32 triangles with one UV set.
FileBuilder grid()
{
    FileBuilder file;
    file.json["scene"] = 0;
    file.json["scenes"] = {{{"nodes", {0}}}};
    file.json["nodes"] = {{{"name", "grid"}, {"mesh", 0}, {"extras", {{"note", "a \"quoted\" one"}}}}};
    const int positions = file.add(gridPositions(), "VEC3", 5126, 3);
    file.json["accessors"][positions]["min"] = {0, 0, 0};
    file.json["accessors"][positions]["max"] = {4, 4, 4};
    const int uvs = file.add(gridUvs(), "VEC2", 5126, 2);
    const int indices = file.add(gridTriangles(), "SCALAR", 5123, 1);
    file.json["meshes"] = {{{"name", "grid mesh"},
                            {"primitives",
                             {{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                               {"indices", indices},
                               {"mode", 4}}}}}};
    return file;
}

FileBuilder interleaved()
{
    FileBuilder file = grid();
    const std::vector<float> positions = gridPositions();
    const std::vector<float> uvs = gridUvs();
    std::vector<float> rows;
    for (std::size_t v = 0; v < gridVertices; ++v) {
        rows.insert(rows.end(), positions.begin() + long(3 * v), positions.begin() + long(3 * v + 3));
        rows.insert(rows.end(), uvs.begin() + long(2 * v), uvs.begin() + long(2 * v + 2));
    }
    const int view =
        file.addView({reinterpret_cast<const char *>(rows.data()), qsizetype(rows.size() * 4)}, 20);
    const int position = file.addAccessor(view, "VEC3", 5126, gridVertices);
    const int uv = file.addAccessor(view, "VEC2", 5126, gridVertices);
    file.json["accessors"][uv]["byteOffset"] = 12;
    file.primitive()["attributes"] = {{"TEXCOORD_0", uv}, {"POSITION", position}};
    return file;
}

//! Normals, two colours, a joint each, custom data and a second UV set of normalized bytes.
FileBuilder manyAttributes()
{
    FileBuilder file = grid();
    Json &attributes = file.primitive()["attributes"];
    std::vector<float> normals;
    for (int v = 0; v < gridVertices; ++v)
        normals.insert(normals.end(), {0, 0, 1});
    attributes["NORMAL"] = file.add(normals, "VEC3", 5126, 3);
    attributes["COLOR_0"] = file.add(counted<std::uint8_t>(3), "VEC3", 5121, 3);
    file.json["accessors"].back()["normalized"] = true;
    attributes["COLOR_1"] = file.add(counted<float>(4), "VEC4", 5126, 4);
    attributes["_CUSTOM"] = file.add(counted<std::int16_t>(1), "SCALAR", 5122, 1);
    attributes["TEXCOORD_1"] = file.add(counted<std::uint8_t>(2), "VEC2", 5121, 2);
    file.json["accessors"].back()["normalized"] = true;
    return file;
}

FileBuilder skinned()
{
    FileBuilder file = grid();
    Json &attributes = file.primitive()["attributes"];
    attributes["JOINTS_0"] = file.add(std::vector<std::uint8_t>(gridVertices * 4, 0), "VEC4", 5121, 4);
    std::vector<float> weights;
    for (int v = 0; v < gridVertices; ++v)
        weights.insert(weights.end(), {1, 0, 0, 0});
    attributes["WEIGHTS_0"] = file.add(weights, "VEC4", 5126, 4);
    file.json["nodes"].push_back({{"name", "bone"}});
    file.json["scenes"][0]["nodes"] = {0, 1};
    const std::vector<float> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    file.json["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", file.add(identity, "MAT4", 5126, 16)}}};
    file.json["nodes"][0]["skin"] = 0;
    return file;
}

//! A dense morph target, and a sparse one without other data.
FileBuilder morphed()
{
    FileBuilder file = grid();
    const int dense = file.add(counted<float>(3), "VEC3", 5126, 3);
    const int places = file.addView(QByteArray("\x03\x00\x0c\x00", 4));
    const std::vector<float> moves{1, 2, 3, 4, 5, 6};
    const int values = file.addView({reinterpret_cast<const char *>(moves.data()), 24});
    Json sparse{{"componentType", 5126},
                {"count", gridVertices},
                {"type", "VEC3"},
                {"sparse",
                 {{"count", 2},
                  {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                  {"values", {{"bufferView", values}}}}}};
    file.json["accessors"].push_back(sparse);
    file.primitive()["targets"] = {{{"POSITION", dense}}, {{"POSITION", dense + 1}}};
    return file;
}

//! A strip for each row of the grid, joined by triangles without area.
FileBuilder strip()
{
    FileBuilder file = grid();
    std::vector<std::uint8_t> indices;
    for (int row = 0; row < gridSize; ++row) {
        const auto at = [row](int x, int up) { return std::uint8_t((row + up) * (gridSize + 1) + x); };
        if (row > 0)
            indices.insert(indices.end(), {indices.back(), at(0, 1)});
        for (int x = 0; x <= gridSize; ++x)
            indices.insert(indices.end(), {at(x, 1), at(x, 0)});
    }
    file.primitive()["mode"] = 5;
    file.primitive()["indices"] = file.add(indices, "SCALAR", 5121, 1);
    return file;
}

FileBuilder fan()
{
    FileBuilder file = grid();
    file.primitive()["mode"] = 6;
    file.primitive()["indices"] =
        file.add(std::vector<std::uint16_t>{6, 0, 1, 2, 7, 12, 11, 10, 5}, "SCALAR", 5123, 1);
    return file;
}

FileBuilder withoutIndices()
{
    FileBuilder file = grid();
    std::vector<float> positions, uvs;
    for (const std::uint16_t v : gridTriangles()) {
        const std::vector<float> p = gridPositions();
        const std::vector<float> uv = gridUvs();
        positions.insert(positions.end(), p.begin() + 3 * v, p.begin() + 3 * v + 3);
        uvs.insert(uvs.end(), uv.begin() + 2 * v, uv.begin() + 2 * v + 2);
    }
    file.primitive().erase("indices");
    file.primitive()["attributes"] = {{"POSITION", file.add(positions, "VEC3", 5126, 3)},
                                      {"TEXCOORD_0", file.add(uvs, "VEC2", 5126, 2)}};
    return file;
}

//! Two primitives with the same attributes, another one with the same positions only, and one of lines.
FileBuilder shared()
{
    FileBuilder file = grid();
    const std::vector<std::uint16_t> all = gridTriangles();
    const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    file.json["materials"] = {{{"name", "red"}}, {{"extras", 5}}};
    Json &primitives = file.json["meshes"][0]["primitives"];
    Json second = primitives[0];
    second["indices"] = file.add(std::vector<std::uint16_t>(half, all.end()), "SCALAR", 5123, 1);
    second["material"] = 0;
    primitives[0]["indices"] = file.add(std::vector<std::uint16_t>(all.begin(), half), "SCALAR", 5123, 1);
    Json third = second;
    third["attributes"].erase("TEXCOORD_0");
    third["material"] = 1;
    const Json lines{{"attributes", third["attributes"]}, {"mode", 1}};
    for (const Json &p : {second, lines, third})
        primitives.push_back(p);
    return file;
}

//! Two nodes with the mesh, one of them mirrored.
FileBuilder instanced()
{
    FileBuilder file = grid();
    file.json["nodes"].push_back(
        {{"name", "mirrored"}, {"mesh", 0}, {"scale", {-1, 2, 1}}, {"translation", {-1, 0, 0}}});
    file.json["nodes"].push_back({{"children", {1, 0}}});
    file.json["scenes"][0]["nodes"] = {2};
    return file;
}

Scene parsed(const QByteArray &bytes)
{
    Result<Scene> scene = parseGltf({bytes, {}}, u"made.glb"_s);
    if (!scene)
        qFatal("%s", qPrintable(scene.error().toString()));
    return std::move(scene).value();
}

//! UVs with seams: some corners of a vertex agree, some do not.
UvMatrix seamyUv(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const int v = mesh.vertexWeld[mesh.cornerVertex[c]];
        uv.row(c) << std::sin(v) + (v % 3 ? 0 : c % 4), 0.1 * v + (v % 5 ? 0 : c % 2);
    }
    return uv;
}

//! The attributes that a corner has, by name; those of morph targets with their number before it.
using CornerData = std::map<std::string, QByteArray>;

//! The corners of a primitive without tangents and UVs.
std::vector<CornerData> cornersOf(const GltfDocument &document, const Json &primitive)
{
    GltfData data(document);
    const GltfPrimitive read = readPrimitive(data, primitive);
    std::vector<CornerData> corners(read.corners.size());
    const auto add = [&](const std::string &name, const GltfElements &elements) {
        for (std::size_t c = 0; c < corners.size(); ++c)
            corners[c][name] = QByteArray(elements.at(read.corners[c]), qsizetype(elements.size));
    };
    for (const auto &[name, elements] : read.attributes) {
        if (texcoordNumber(name) < 0 && name != "TANGENT")
            add(name, elements);
    }
    const Json &targets = member(primitive, "targets");
    for (std::size_t t = 0; t < targets.size(); ++t) {
        for (const auto &[name, accessor] : targets[t].items()) {
            if (name != "TANGENT")
                add(std::to_string(t) + name, data.elements(accessor.get<std::size_t>()));
        }
    }
    return corners;
}

//! The JSON without what new UVs may change.
Json restOf(Json json)
{
    for (const char *key : {"accessors", "bufferViews", "buffers"})
        json.erase(key);
    for (Json &image : json["images"]) {
        if (!isDataUri(textOf(image, "uri")))
            image.erase("uri"); // it leads to the same file from another folder
    }
    for (Json &mesh : json["meshes"]) {
        for (Json &primitive : mesh["primitives"]) {
            for (const char *key : {"attributes", "targets", "indices", "mode"})
                primitive.erase(key);
        }
    }
    return json;
}

//! What differs between two files besides UVs; empty when nothing does.
QString differenceOf(GltfFile before, GltfFile after)
{
    const GltfDocument a = openGltf(before);
    const GltfDocument b = openGltf(after);
    if (restOf(a.json) != restOf(b.json))
        return u"JSON"_s;
    for (std::size_t m = 0; m < a.json["meshes"].size(); ++m) {
        const Json &primitives = a.json["meshes"][m]["primitives"];
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const Json &other = b.json["meshes"][m]["primitives"][p];
            if (hasTriangles(primitives[p]) ? cornersOf(a, primitives[p]) != cornersOf(b, other)
                                            : primitives[p] != other)
                return u"primitive %1 of mesh %2"_s.arg(p).arg(m);
        }
    }
    return {};
}

//! The largest difference of the UVs of two scenes; infinite when they do not correspond.
double uvDifference(const Scene &a, const Scene &b)
{
    if (a.uvSets.size() != b.uvSets.size() || a.mesh->cornerVertex.size() != b.mesh->cornerVertex.size())
        return std::numeric_limits<double>::infinity();
    double result = 0;
    for (std::size_t s = 0; s < a.uvSets.size(); ++s)
        result = std::max(result, (a.uvSets[s].uv - b.uvSets[s].uv).cwiseAbs().maxCoeff());
    return result;
}

QByteArray contentOf(const QString &path)
{
    Result<QByteArray> bytes = loadFile(path, 1 << 30);
    return bytes ? std::move(bytes).value() : QByteArray();
}

//! The bytes of the scene as .glb.
QByteArray written(const Scene &scene)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"out.glb"_s);
    if (const Result<Done> done = writeMesh(scene, path); !done)
        qFatal("%s", qPrintable(done.error().toString()));
    return contentOf(path);
}

Json jsonOf(const QByteArray &glb)
{
    GltfFile file{glb, {}};
    return openGltf(file).json;
}

std::size_t vertexCount(const Json &json, std::size_t primitive = 0)
{
    const Json &attributes = json["meshes"][0]["primitives"][primitive]["attributes"];
    return json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
}

} // namespace

class TestGltf : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyUvsChange_data();
    void onlyUvsChange();
    void containers_data();
    void containers();
    void oldSeamsAreJoined();
    void unsplitMeshesKeepTheirIndices();
    void vertexOrderStays();
    void newSets();
    void removedAndRenamedSets();
    void tangentsOfChangedUvs();
    void instances();
    void objectsMaterialsAndNotes();
    void savingAgainDoesNotGrow();
    void bufferFiles();
    void imagesOfAnotherFolder();
    void sessions();
    void otherFormats();
    void missingCorners();
    void badFiles_data();
    void badFiles();
    void stopping();
    void mutations();
    void realFiles();
};

void TestGltf::onlyUvsChange_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("grid") << grid().glb();
    QTest::newRow("interleaved") << interleaved().glb();
    QTest::newRow("many attributes") << manyAttributes().glb();
    QTest::newRow("skin") << skinned().glb();
    QTest::newRow("morph targets") << morphed().glb();
    QTest::newRow("strip") << strip().glb();
    QTest::newRow("fan") << fan().glb();
    QTest::newRow("without indices") << withoutIndices().glb();
    QTest::newRow("shared attributes") << shared().glb();
    QTest::newRow("text") << morphed().text();
}

void TestGltf::onlyUvsChange()
{
    QFETCH(QByteArray, bytes);
    Scene scene = parsed(bytes);
    QCOMPARE(QString::fromStdString(scene.mesh->validate()), QString());
    const std::size_t before = vertexCount(jsonOf(bytes));
    for (UvSet &set : scene.uvSets)
        set.uv = seamyUv(*scene.mesh);
    const QByteArray out = written(scene);
    QCOMPARE(differenceOf({bytes, {}}, {out, {}}), QString());
    const Scene again = parsed(out);
    QVERIFY(uvDifference(scene, again) <= 1e-6);
    QVERIFY(vertexCount(jsonOf(out)) != before);
    // Nothing was changed now.
    QCOMPARE(written(again), out);
}

void TestGltf::containers_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    for (const QString &from : {u"glb"_s, u"gltf"_s, u"gltf with bin"_s}) {
        for (const QString &to : {u"glb"_s, u"gltf"_s})
            QTest::addRow("%s to %s", qPrintable(from), qPrintable(to)) << from << to;
    }
}

void TestGltf::containers()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    const QTemporaryDir folder;
    const FileBuilder file = manyAttributes();
    const QString path = folder.filePath(u"in."_s + from.split(u' ').first());
    const bool outer = from.endsWith("bin"_L1);
    QVERIFY(
        saveAtomically(path, from == "glb"_L1 ? file.glb() : file.text(outer ? "some%20data.bin" : "")).ok());
    if (outer)
        QVERIFY(saveAtomically(folder.filePath(u"some data.bin"_s), file.buffer).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());

    const QString same = folder.filePath(u"same."_s + to);
    QVERIFY(writeMesh(scene.value(), same).ok());
    const bool sameContainer = from.startsWith(to + u' ') || from == to;
    QCOMPARE(contentOf(same) == contentOf(path), sameContainer);
    QCOMPARE(uvDifference(scene.value(), readMesh(same).value()), 0.0);

    scene->uvSets[0].uv = seamyUv(*scene->mesh);
    const QString changed = folder.filePath(u"changed."_s + to);
    QVERIFY(writeMesh(scene.value(), changed).ok());
    QVERIFY(uvDifference(scene.value(), readMesh(changed).value()) <= 1e-6);
    QCOMPARE(QFile::exists(folder.filePath(u"changed.bin"_s)), outer && to == "gltf"_L1);
    QCOMPARE(contentOf(changed).startsWith("glTF"), to == "glb"_L1);
    if (from != "glb"_L1 && to == "gltf"_L1)
        QVERIFY(contentOf(changed).startsWith("{\n  \"asset\""));
}

void TestGltf::oldSeamsAreJoined()
{
    // Every corner has a vertex of its own.
    Scene scene = parsed(withoutIndices().glb());
    QCOMPARE(scene.mesh->vertexCount(), 96);
    for (Eigen::Index c = 0; c < scene.uvSets[0].uv.rows(); ++c) {
        const Vec3 p = scene.mesh->cornerPosition(int(c));
        scene.uvSets[0].uv.row(c) << p.x() / 3, p.y() / 3;
    }
    QCOMPARE(vertexCount(jsonOf(written(scene))), std::size_t(gridVertices));
}

void TestGltf::unsplitMeshesKeepTheirIndices()
{
    const QByteArray bytes = shared().glb();
    Scene scene = parsed(bytes);
    const Eigen::Index half = scene.uvSets[0].uv.rows() / 3;
    scene.uvSets[0].uv.topRows(2 * half).array() *= 0.5;
    const Json before = jsonOf(bytes);
    const Json after = jsonOf(written(scene));
    QCOMPARE(after["accessors"].size(), before["accessors"].size() + 1);
    for (std::size_t p = 0; p < 2; ++p) {
        const Json &a = before["meshes"][0]["primitives"][p];
        const Json &b = after["meshes"][0]["primitives"][p];
        QVERIFY(a["indices"] == b["indices"]);
        QVERIFY(a["attributes"]["POSITION"] == b["attributes"]["POSITION"]);
        QVERIFY(b["attributes"]["TEXCOORD_0"] == before["accessors"].size());
    }
}

void TestGltf::vertexOrderStays()
{
    Scene scene = parsed(grid().glb());
    UvMatrix &uv = scene.uvSets[0].uv;
    uv.row(0).array() += 3; // one corner leaves its vertex
    const Scene again = parsed(written(scene));
    GltfFile file = gltfSourceOf(again)->file;
    const GltfDocument document = openGltf(file);
    GltfData data(document);
    const GltfPrimitive primitive = readPrimitive(data, document.json["meshes"][0]["primitives"][0]);
    QCOMPARE(primitive.vertexCount, std::size_t(gridVertices + 1));
    const std::vector<float> positions = gridPositions();
    QVERIFY(primitive.attributes.at("POSITION")
                .bytes.startsWith(QByteArrayView(reinterpret_cast<const char *>(positions.data()),
                                                 qsizetype(positions.size() * 4))));
}

void TestGltf::newSets()
{
    Scene scene = parsed(grid().glb());
    scene.uvSets.insert(scene.uvSets.begin(), {u"another"_s, seamyUv(*scene.mesh)});
    const Scene again = parsed(written(scene));
    QCOMPARE(again.uvSets.size(), std::size_t(2));
    QCOMPARE(again.uvSets[1].name, u"UVMap2"_s);
    QVERIFY((again.uvSets[0].uv - scene.uvSets[1].uv).isZero(0));
    QVERIFY((again.uvSets[1].uv - scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-6);

    // The numbers have no gaps where a mesh had no UVs.
    Scene partly = parsed(shared().glb());
    partly.uvSets.push_back({u"another"_s, seamyUv(*partly.mesh)});
    const Json json = jsonOf(written(partly));
    for (const std::size_t p : {0, 1, 3})
        QVERIFY(json["meshes"][0]["primitives"][p]["attributes"].contains("TEXCOORD_0"));

    // A file without UVs.
    FileBuilder bare = grid();
    bare.primitive()["attributes"].erase("TEXCOORD_0");
    Scene first = parsed(bare.glb());
    QVERIFY(first.uvSets.empty());
    first.uvSets = {{u"UVMap"_s, seamyUv(*first.mesh)}};
    QVERIFY(uvDifference(first, parsed(written(first))) < 1e-6);
}

void TestGltf::removedAndRenamedSets()
{
    const QByteArray bytes = manyAttributes().glb();
    Scene scene = parsed(bytes);
    QCOMPARE(scene.uvSets.size(), std::size_t(2));
    // Which one is the active one does not matter.
    std::swap(scene.uvSets[0], scene.uvSets[1]);
    QCOMPARE(written(scene), bytes);
    scene.uvSets.erase(scene.uvSets.begin());
    QCOMPARE(written(scene), bytes);
    QVERIFY(exportLosses(scene, u"glb"_s).join(u' ').contains("removed"_L1));
    scene.uvSets[0].name = u"renamed"_s;
    QCOMPARE(written(scene), bytes);
    QVERIFY(!exportLosses(parsed(bytes), u"glb"_s).join(u' ').contains("removed"_L1));
}

void TestGltf::tangentsOfChangedUvs()
{
    FileBuilder file = manyAttributes();
    file.primitive()["attributes"]["TANGENT"] = file.add(counted<float>(4), "VEC4", 5126, 4);
    file.json["materials"] = {{{"normalTexture", {{"index", 0}, {"texCoord", 1}}}}};
    file.primitive()["material"] = 0;
    const auto hasTangents = [](const Scene &scene) {
        return jsonOf(written(scene))["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT");
    };
    Scene scene = parsed(file.glb());
    scene.uvSets[0].uv = seamyUv(*scene.mesh);
    QVERIFY(hasTangents(scene));
    scene.uvSets[1].uv = seamyUv(*scene.mesh);
    QVERIFY(!hasTangents(scene));
    QVERIFY(exportLosses(scene, u"glb"_s).join(u' ').contains("tangents"_L1));
}

void TestGltf::instances()
{
    const QByteArray bytes = instanced().glb();
    Scene scene = parsed(bytes);
    const MeshData &mesh = *scene.mesh;
    QCOMPARE(mesh.faceCount(), 64);
    QCOMPARE(scene.objectNames, (std::vector<QString>{u"mirrored"_s, u"grid"_s}));
    QCOMPARE(mesh.positions.col(0).minCoeff(), -5.0);
    QCOMPARE(mesh.positions.col(1).maxCoeff(), 8.0);
    // All faces look up, also the mirrored ones.
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        const Vec3 b = mesh.cornerPosition(mesh.triangles[t][1]) - a;
        const Vec3 c = mesh.cornerPosition(mesh.triangles[t][2]) - a;
        QVERIFY(b.x() * c.y() - b.y() * c.x() > 0);
    }
    QVERIFY(scene.notes.at(0).contains(u"several nodes"_s));
    scene.uvSets[0].uv = seamyUv(mesh);
    const QByteArray out = written(scene);
    QCOMPARE(differenceOf({bytes, {}}, {out, {}}), QString());
    const UvMatrix uv = parsed(out).uvSets[0].uv;
    QVERIFY((uv.topRows(96) - scene.uvSets[0].uv.topRows(96)).cwiseAbs().maxCoeff() < 1e-6);
}

void TestGltf::objectsMaterialsAndNotes()
{
    const Scene scene = parsed(shared().glb());
    QCOMPARE(scene.objectNames, std::vector<QString>{u"grid"_s});
    QCOMPARE(scene.materialNames, (std::vector<QString>{u"red"_s, u"material 2"_s}));
    QCOMPARE(scene.faceMaterial.front(), -1);
    QCOMPARE(scene.faceMaterial.at(16), 0);
    QCOMPARE(scene.faceMaterial.back(), 1);
    QCOMPARE(scene.notes.size(), std::size_t(1));
    QVERIFY(scene.notes[0].contains("line(s) left out"_L1));
    // v points up here.
    QCOMPARE(scene.uvSets[0].name, u"UVMap"_s);
    QCOMPARE(scene.uvSets[0].uv(0, 1), 1.0);
    QCOMPARE(scene.uvSets[0].uv(2, 1), 1 - double(1.0f / 7));
    QVERIFY(scene.hardEdges.empty());

    FileBuilder hard = withoutIndices();
    std::vector<float> normals;
    for (std::size_t c = 0; c < 3 * 32; ++c)
        normals.insert(normals.end(), {c < 48 ? 1.0f : 0.0f, 0, 1});
    hard.primitive()["attributes"]["NORMAL"] = hard.add(normals, "VEC3", 5126, 3);
    const std::vector<bool> edges = parsed(hard.glb()).hardEdges;
    QCOMPARE(std::count(edges.begin(), edges.end(), true), gridSize);
}

void TestGltf::savingAgainDoesNotGrow()
{
    Scene scene = parsed(morphed().glb());
    scene.uvSets[0].uv = seamyUv(*scene.mesh);
    const QByteArray first = written(scene);
    Scene again = parsed(first);
    again.uvSets[0].uv *= 0.5;
    again.uvSets[0].uv.row(5) << 7, 7;
    const QByteArray second = written(again);
    QVERIFY(second.size() < first.size() + 300);
    QCOMPARE(differenceOf({first, {}}, {second, {}}), QString());
    QVERIFY(uvDifference(again, parsed(second)) < 1e-6);
}

void TestGltf::bufferFiles()
{
    const QTemporaryDir folder;
    FileBuilder file = grid();
    const QString path = folder.filePath(u"in.gltf"_s);
    // A second buffer that has the name which the first would get.
    Json json = Json::parse(file.text("in.bin").toStdString());
    json["buffers"].push_back({{"byteLength", 4}, {"uri", "out.bin"}});
    QVERIFY(saveAtomically(path, jsonText(json, {})).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    QVERIFY(saveAtomically(folder.filePath(u"out.bin"_s), QByteArrayView("kept")).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    scene->uvSets[0].uv = seamyUv(*scene->mesh);
    QVERIFY(writeMesh(scene.value(), folder.filePath(u"out.gltf"_s)).ok());
    QCOMPARE(contentOf(folder.filePath(u"out.bin"_s)), QByteArray("kept"));
    QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);
    QVERIFY(uvDifference(scene.value(), readMesh(folder.filePath(u"out.gltf"_s)).value()) < 1e-6);

    // Over itself: what was in the buffer stays in its place.
    QVERIFY(writeMesh(scene.value(), path).ok());
    QVERIFY(contentOf(folder.filePath(u"in.bin"_s)).startsWith(file.buffer));
    QVERIFY(uvDifference(scene.value(), readMesh(path).value()) < 1e-6);
}

void TestGltf::imagesOfAnotherFolder()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath(u"a"_s) && QDir(folder.path()).mkpath(u"b"_s));
    FileBuilder file = grid();
    file.json["images"] = {{{"uri", "my%20picture.png"}}, {{"uri", "data:image/png;base64,AAAA"}}};
    const QString path = folder.filePath(u"a/in.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"a/in.bin"_s), file.buffer).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    QVERIFY(writeMesh(scene.value(), folder.filePath(u"b/out.gltf"_s)).ok());
    QCOMPARE(contentOf(folder.filePath(u"b/out.bin"_s)), file.buffer);
    GltfFile out{contentOf(folder.filePath(u"b/out.gltf"_s)), {{"out.bin", file.buffer}}};
    const Json images = openGltf(out).json["images"];
    QCOMPARE(QByteArray::fromStdString(images[0]["uri"]), QByteArray("../a/my%20picture.png"));
    QCOMPARE(QByteArray::fromStdString(images[1]["uri"]), QByteArray("data:image/png;base64,AAAA"));
}

void TestGltf::sessions()
{
    const QTemporaryDir folder;
    const FileBuilder file = skinned();
    const QString path = folder.filePath(u"in.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    const DocumentState state = DocumentState::initial(readMesh(path).value());
    QVERIFY(QFile::remove(path) && QFile::remove(folder.filePath(u"in.bin"_s)));
    const QString session = folder.filePath(u"a.acproj"_s);
    QVERIFY(saveProject(state, {}, session).ok());
    Result<LoadedProject> project = loadProject(session);
    QVERIFY2(project.ok(), project.ok() ? "" : qPrintable(project.error().toString()));
    Scene &scene = project->state.scene;
    QVERIFY(gltfSourceOf(scene));
    QCOMPARE(scene.path, path);
    QVERIFY(writeMesh(scene, path).ok());
    QCOMPARE(contentOf(path), file.text("in.bin"));
    QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);

    // A made-up session writes nowhere else.
    const QString outside = folder.filePath(u"outside.bin"_s);
    QVERIFY(QDir(folder.path()).mkdir(u"inner"_s));
    Result<Scene> sly = parseGltf({file.text("../outside.bin"), {{"../outside.bin", file.buffer}}},
                                  folder.filePath(u"inner/in.gltf"_s));
    QVERIFY(sly.ok() && writeMesh(sly.value(), sly->path).ok());
    QVERIFY(!QFile::exists(outside) && readMesh(sly->path).ok());

    // Without its glTF file, it still holds the polygons.
    PartMap parts = scenePartsOf(state.scene);
    parts["gltf"].truncate(300);
    QStringList lost;
    const Result<Scene> partly = readSceneParts(parts, session, lost);
    QVERIFY(partly.ok() && !partly->source);
    QCOMPARE(lost, QStringList{u"the glTF file"_s});
    parts = scenePartsOf(state.scene);
    parts.erase("polygons");
    QVERIFY(gltfSourceOf(readSceneParts(parts, session, lost).value()));
}

void TestGltf::otherFormats()
{
    const QTemporaryDir folder;
    Scene scene = parsed(skinned().glb());
    scene.uvSets[0].uv = seamyUv(*scene.mesh);
    const QString path = folder.filePath(u"out.dae"_s);
    QVERIFY(writeMesh(scene, path).ok());
    QVERIFY(contentOf(path).contains("<skin"));
    const Result<Scene> again = readMesh(path);
    QVERIFY(again.ok());
    QCOMPARE(again->mesh->faceCount(), scene.mesh->faceCount());
    QVERIFY((again->uvSets.at(0).uv - scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-5);
    QVERIFY(exportLosses(scene, u"ply"_s).join(u' ').contains("bones and animations are lost"_L1));
    QVERIFY(exportLosses(parsed(morphed().glb()), u"dae"_s).join(u' ').contains("morph targets"_L1));
    // Corners that start elsewhere, and triangles that our reader leaves out.
    for (const FileBuilder &file : {strip(), fan(), instanced()}) {
        Scene other = parsed(file.glb());
        other.uvSets[0].uv = seamyUv(*other.mesh);
        QVERIFY(writeMesh(other, path).ok());
        const Result<Scene> read = readMesh(path);
        QVERIFY(read.ok());
        QVERIFY(read->uvSets.at(0).uv.array().isFinite().all());
        QVERIFY(std::abs(read->uvSets[0].uv.maxCoeff() - other.uvSets[0].uv.maxCoeff()) < 1e-5);
    }
}

void TestGltf::missingCorners()
{
    Scene scene = parsed(grid().glb());
    const UvMatrix before = scene.uvSets[0].uv;
    scene.uvSets[0].uv.array() += 2;
    scene.uvSets[0].uv.row(4).fill(std::numeric_limits<double>::quiet_NaN());
    const UvMatrix after = parsed(written(scene)).uvSets[0].uv;
    QCOMPARE(after.row(4), before.row(4));
    QVERIFY(std::abs(after(5, 0) - before(5, 0) - 2) < 1e-6);
}

void TestGltf::badFiles_data()
{
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char *name, const std::function<void(FileBuilder &)> &change) {
        FileBuilder file = grid();
        change(file);
        QTest::newRow(name) << file.glb();
    };
    const auto accessor = [](FileBuilder &file, int number) -> Json & {
        return file.json["accessors"][number];
    };
    row("huge count", [&](FileBuilder &f) { accessor(f, 0)["count"] = 4000000000; });
    row("huge count without data", [&](FileBuilder &f) {
        accessor(f, 0)["count"] = 200000000;
        accessor(f, 0).erase("bufferView");
    });
    row("negative offset", [&](FileBuilder &f) { accessor(f, 0)["byteOffset"] = -4; });
    row("overflowing offset", [&](FileBuilder &f) { accessor(f, 0)["byteOffset"] = 0xFFFFFFFFFFFFFFFE; });
    row("stride", [&](FileBuilder &f) { f.json["bufferViews"][0]["byteStride"] = 1; });
    row("view beyond the buffer", [&](FileBuilder &f) { f.json["bufferViews"][0]["byteLength"] = 1 << 30; });
    row("no such view", [&](FileBuilder &f) { accessor(f, 0)["bufferView"] = 77; });
    row("no such buffer", [&](FileBuilder &f) { f.json["bufferViews"][0]["buffer"] = 2; });
    row("no such accessor", [&](FileBuilder &f) { f.primitive()["indices"] = 99; });
    row("no such mesh", [&](FileBuilder &f) { f.json["nodes"][0]["mesh"] = 5; });
    row("no such node", [&](FileBuilder &f) { f.json["scenes"][0]["nodes"] = {5}; });
    row("component type", [&](FileBuilder &f) { accessor(f, 0)["componentType"] = 1; });
    row("type", [&](FileBuilder &f) { accessor(f, 0)["type"] = "VEC9"; });
    row("positions of two numbers", [&](FileBuilder &f) { f.primitive()["attributes"]["POSITION"] = 1; });
    row("counts differ", [&](FileBuilder &f) { accessor(f, 1)["count"] = 3; });
    row("no positions", [&](FileBuilder &f) { f.primitive()["attributes"].erase("POSITION"); });
    row("all indices wrong", [&](FileBuilder &f) { accessor(f, 0)["count"] = accessor(f, 1)["count"] = 0; });
    row("infinite position", [&](FileBuilder &f) {
        const float infinite = std::numeric_limits<float>::infinity();
        std::memcpy(f.buffer.data(), &infinite, 4);
    });
    row("infinite transform", [&](FileBuilder &f) { f.json["nodes"][0]["scale"] = {1e300, 1e300, 1e300}; });
    row("sparse place", [&](FileBuilder &f) {
        const int view = f.addView(QByteArray(12, '\x77'));
        accessor(f, 0)["sparse"] = {{"count", 1},
                                    {"indices", {{"bufferView", view}, {"componentType", 5121}}},
                                    {"values", {{"bufferView", view}}}};
    });
    row("draco", [&](FileBuilder &f) {
        f.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                     {"attributes", {{"POSITION", 0}}}};
    });
    row("meshopt", [&](FileBuilder &f) {
        f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {
            {"buffer", 0}, {"byteLength", 20}, {"byteStride", 12}, {"mode", "ATTRIBUTES"}, {"count", 25}};
    });
    row("meshopt, huge", [&](FileBuilder &f) {
        f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                             {"byteLength", 20},
                                                                             {"byteStride", 12},
                                                                             {"mode", "ATTRIBUTES"},
                                                                             {"count", 4000000000}};
    });
    row("unknown compression",
        [&](FileBuilder &f) { f.json["extensionsRequired"] = {"X_mesh_compression"}; });
    QTest::newRow("buffer elsewhere") << grid().text("/etc/passwd");
    QTest::newRow("buffer missing") << grid().text("missing.bin");
    QTest::newRow("nested deeply") << "{\"a\":" + QByteArray("[").repeated(100000) +
                                          QByteArray("]").repeated(100000) + "}";
    QTest::newRow("cut off") << grid().glb().first(200);
    QTest::newRow("no JSON") << QByteArray("{\"asset\":");
    QTest::newRow("an array") << QByteArray("[]");
    QTest::newRow("header only") << grid().glb().first(12);
}

void TestGltf::badFiles()
{
    QFETCH(QByteArray, bytes);
    const Result<Scene> scene = parseGltf({bytes, {}}, u"bad.glb"_s);
    QVERIFY(!scene.ok());
    QCOMPARE(scene.error().file, u"bad.glb"_s);
    QVERIFY(!scene.error().message.isEmpty() && !scene.error().remedy.isEmpty());
    QVERIFY(!scene.error().message.contains(u'\n'));
}

void TestGltf::stopping()
{
    const std::atomic<bool> stop = true;
    const Result<Scene> scene = parseGltf({grid().glb(), {}}, u"a.glb"_s, &stop);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().message.contains("cancelled"_L1));
}

//! Overwrites, removes or doubles some bytes.
void damage(QByteArray &bytes, std::mt19937 &random)
{
    const auto below = [&](qsizetype n) {
        return static_cast<qsizetype>(random() % static_cast<std::size_t>(n));
    };
    for (auto changes = 1 + below(4); changes > 0; --changes) {
        const qsizetype at = below(bytes.size());
        const qsizetype size = 1 + below(std::min<qsizetype>(8, bytes.size() - at));
        switch (below(4)) {
        case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
        case 1: // another digit makes another number
            bytes[at] = static_cast<char>('0' + below(10));
            break;
        case 2:
            bytes.insert(at, bytes.mid(at, size));
            break;
        default:
            bytes.remove(at, size);
        }
    }
}

void TestGltf::mutations()
{
    std::mt19937 random(1);
    const QList<QByteArray> seeds{manyAttributes().glb(), morphed().glb(), skinned().text(),
                                  strip().glb(),          shared().text(), instanced().text()};
    int opened = 0;
    for (int i = 0; i < 3000; ++i) {
        QByteArray bytes = seeds[i % seeds.size()];
        damage(bytes, random);
        Result<Scene> scene = parseGltf({bytes, {}}, u"/nowhere/damaged.glb"_s);
        if (!scene) {
            QVERIFY(!scene.error().message.isEmpty());
            continue;
        }
        ++opened;
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        for (UvSet &set : scene->uvSets)
            set.uv = seamyUv(*scene->mesh);
        if (!gltfSourceOf(scene.value()))
            continue;
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"out.glb"_s);
        if (writeMesh(scene.value(), path))
            QVERIFY2(readMesh(path).ok(), qPrintable(QString::number(i)));
    }
    QVERIFY(opened > 300);
}

void TestGltf::realFiles()
{
    QStringList files;
    const QByteArray meshes = qgetenv("AUTOCUTS_MESHES");
    const QString shared = meshes.isEmpty() ? QStringLiteral(AUTOCUTS_SOURCE_DIR "/../shared/meshes")
                                            : QString::fromLocal8Bit(meshes);
    for (const QString &folder : {shared + "/gltf"_L1, u"/usr/share/assimp/models/glTF2"_s}) {
        QDirIterator walk(folder, {u"*.gltf"_s, u"*.glb"_s}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            files << walk.next();
    }
    int changed = 0;
    for (const QString &path : files) {
        Result<Scene> scene = readMesh(path);
        if (!scene || scene->mesh->faceCount() > 20000)
            continue;
        const QTemporaryDir folder;
        const bool binary = path.endsWith(".glb"_L1, Qt::CaseInsensitive);
        const QString same = folder.filePath(binary ? u"a.glb"_s : u"a.gltf"_s);
        QVERIFY2(writeMesh(scene.value(), same).ok(), qPrintable(path));
        if (binary)
            QVERIFY2(contentOf(same) == contentOf(path), qPrintable(path));
        if (scene->uvSets.empty())
            scene->uvSets = {{u"UVMap"_s, {}}};
        scene->uvSets[0].uv = seamyUv(*scene->mesh);
        const QByteArray out = written(scene.value());
        const Scene again = parsed(out);
        QCOMPARE(again.mesh->faceCount(), scene->mesh->faceCount());
        if (gltfSourceOf(scene.value())->contents.instances ||
            gltfSourceOf(scene.value())->contents.compressed)
            continue;
        ++changed;
        QVERIFY2(uvDifference(scene.value(), again) < 1e-4, qPrintable(path));
        QCOMPARE(path + differenceOf(gltfSourceOf(scene.value())->file, {out, {}}), path);
    }
    if (changed == 0)
        QSKIP("there are no glTF files");
}

QTEST_GUILESS_MAIN(TestGltf)
#include "tst_gltf.moc"
