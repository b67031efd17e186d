#include "support/gltffiles.h"

#include "model/io/files/savefile.h"
#include "model/io/gltf/gltfprimitive.h"
#include "model/io/meshes/meshfile.h"

#include <QTemporaryDir>

#include <cmath>
#include <limits>
#include <map>

using namespace Qt::Literals::StringLiterals;

namespace gltffiles {

namespace {

//! The attributes that a corner has, by name; those of morph targets with their number before it.
using CornerData = std::map<std::string, QByteArray>;

} // namespace

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

namespace {

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

} // namespace

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

UvMatrix seamyUv(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const int v = mesh.vertexWeld[mesh.cornerVertex[c]];
        uv.row(c) << std::sin(v) + (v % 3 ? 0 : c % 4), 0.1 * v + (v % 5 ? 0 : c % 2);
    }
    return uv;
}

namespace {

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

} // namespace

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

std::size_t vertexCount(const Json &json, std::size_t primitive)
{
    const Json &attributes = json["meshes"][0]["primitives"][primitive]["attributes"];
    return json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
}

} // namespace gltffiles
