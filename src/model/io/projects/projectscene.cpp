#include "model/io/projects/projectscene.h"

#include "model/document/bitmap.h"
#include "model/document/cborvalues.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/formats/filesource.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/obj/objreader.h"
#include "model/io/projects/packedarrays.h"
#include "model/plain/polygonsides.h"

#include <QCborArray>

#include <algorithm>
#include <stdexcept>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Damaged object names are replaced only when the numbers of the objects exceed the number of faces by at
//! most this. It keeps a damaged file from taking much memory. Chosen by hand.
constexpr int maxEmptyObjects = 1000;

QCborArray textArray(const std::vector<QString> &texts)
{
    QCborArray array;
    for (const QString &text : texts)
        array.append(text);
    return array;
}

bool readTexts(const QCborMap &map, QLatin1StringView key, std::vector<QString> &texts)
{
    const QCborValue value = map.value(key);
    if (!value.isArray())
        return false;
    for (const QCborValue &text : value.toArray()) {
        if (!text.isString())
            return false;
        texts.push_back(text.toString());
    }
    return true;
}

QCborArray colorArray(const std::vector<QRgb> &colors)
{
    QCborArray array;
    for (QRgb color : colors)
        array.append(static_cast<qint64>(color));
    return array;
}

//! Damaged colours are left out: they only help to tell materials apart.
std::vector<QRgb> readColors(const QCborMap &map, std::size_t materials)
{
    std::vector<QRgb> colors;
    for (const QCborValue &value : map.value("materialColors"_L1).toArray()) {
        const qint64 color = value.toInteger(-1);
        if (color < 0 || color > 0xffffffff || colors.size() == materials)
            return {};
        colors.push_back(static_cast<QRgb>(color));
    }
    return colors;
}

QCborArray textureArray(const std::vector<SceneTexture> &textures)
{
    QCborArray array;
    for (const SceneTexture &texture : textures)
        array.append(texture.file);
    return array;
}

//! The names of textures. Pictures inside of the model's file are those of that file, if it is there.
std::vector<SceneTexture> readTextures(const QCborMap &map, std::vector<SceneTexture> inFile,
                                       std::size_t materials)
{
    if (!map.contains("materialTextures"_L1)) // of an older program, or without textures
        return inFile.size() > materials ? std::vector<SceneTexture>() : inFile;
    const QCborArray names = map.value("materialTextures"_L1).toArray();
    if (std::size_t(names.size()) > materials)
        return {};
    inFile.resize(static_cast<std::size_t>(names.size()));
    for (std::size_t m = 0; m < inFile.size(); ++m)
        inFile[m].file = names[static_cast<qsizetype>(m)].toString();
    return inFile;
}

//! The same for what else the file says of materials.
std::vector<TextureSet> readSets(const QCborMap &map, std::vector<TextureSet> inFile, std::size_t materials)
{
    if (!map.contains("materialSets"_L1)) // of an older program, or without any
        return inFile.size() > materials ? std::vector<TextureSet>() : inFile;
    auto sets = readTextureSets(map.value("materialSets"_L1).toArray(), materials);
    if (!sets)
        return {};
    for (std::size_t m = 0; m < std::min(sets->size(), inFile.size()); ++m) {
        for (auto &[channel, entry] : (*sets)[m]) {
            if (const auto found = inFile[m].find(channel); found != inFile[m].end())
                entry.picture.content = found->second.picture.content;
        }
    }
    return *sets;
}

//! Numbers of vertices, faces and corners, to detect a model that was read differently.
QByteArray countsOf(const MeshData &mesh)
{
    return packedArray(std::vector<int>{mesh.vertexCount(), mesh.faceCount(), mesh.cornerCount()});
}

QCborMap sceneMap(const Scene &scene)
{
    QCborMap map{{"path"_L1, scene.path},
                 {"format"_L1, scene.format},
                 {"counts"_L1, countsOf(*scene.mesh)},
                 {"objects"_L1, textArray(scene.objectNames)},
                 {"materials"_L1, textArray(scene.materialNames)},
                 {"faceMaterial"_L1, packedArray(scene.faceMaterial)},
                 {"notes"_L1, textArray(scene.notes)}};
    if (!scene.materialColors.empty())
        map["materialColors"_L1] = colorArray(scene.materialColors);
    if (!scene.materialTextures.empty())
        map["materialTextures"_L1] = textureArray(scene.materialTextures);
    if (!scene.materialSets.empty())
        map["materialSets"_L1] = toCbor(scene.materialSets);
    if (scene.uniqueMeshes)
        map["uniqueMeshes"_L1] = true;
    return map;
}

int lastObject(const MeshData &mesh)
{
    const auto &objects = mesh.faceObject;
    return objects.empty() ? -1 : *std::max_element(objects.begin(), objects.end());
}

//! Reads the names and notes of a scene that has its mesh. False when they are damaged; then the scene is
//! unchanged.
bool readNames(const QCborMap &map, Scene &scene)
{
    const MeshData &mesh = *scene.mesh;
    Scene named;
    const QCborValue path = map.value("path"_L1);
    const QCborValue format = map.value("format"_L1);
    const QByteArray materials = map.value("faceMaterial"_L1).toByteArray();
    const auto faceMaterial = unpackedIntegers(materials, packedIntegerCount(materials));
    if (!path.isString() || !format.isString() || !faceMaterial ||
        !readTexts(map, "objects"_L1, named.objectNames) ||
        !readTexts(map, "materials"_L1, named.materialNames) || !readTexts(map, "notes"_L1, named.notes))
        return false;
    const auto fits = [&](int material) {
        return material >= -1 && material < static_cast<int>(named.materialNames.size());
    };
    if ((!faceMaterial->empty() && std::ssize(*faceMaterial) != mesh.faceCount()) ||
        !std::all_of(faceMaterial->begin(), faceMaterial->end(), fits) ||
        lastObject(mesh) >= static_cast<int>(named.objectNames.size()))
        return false;
    scene.path = path.toString();
    scene.format = format.toString();
    scene.objectNames = std::move(named.objectNames);
    scene.materialNames = std::move(named.materialNames);
    scene.materialColors = readColors(map, scene.materialNames.size());
    scene.materialTextures = readTextures(map, std::move(scene.materialTextures), scene.materialNames.size());
    scene.materialSets = readSets(map, std::move(scene.materialSets), scene.materialNames.size());
    scene.faceMaterial = *faceMaterial;
    scene.notes = std::move(named.notes);
    scene.uniqueMeshes = map.value("uniqueMeshes"_L1).toBool(); // no, in sessions of older programs
    return true;
}

//! One bit per corner, set when the side that starts there is the first side of a hard edge.
QByteArray hardSides(const Scene &scene)
{
    QByteArray bits(bitmapSize(scene.mesh->cornerCount()), '\0');
    for (std::size_t e = 0; e < scene.hardEdges.size(); ++e) {
        if (scene.hardEdges[e])
            setBit(bits, sideOfEdge(*scene.mesh, static_cast<int>(e)));
    }
    return bits;
}

//! Reads hardSides(); false when they are damaged.
bool readHardSides(const QByteArray &bits, Scene &scene)
{
    const MeshData &mesh = *scene.mesh;
    if (bits.size() != bitmapSize(mesh.cornerCount()))
        return false;
    const std::vector<int> pairs = edgePairsBySide(mesh);
    scene.hardEdges.assign(mesh.edgePairs.size(), false);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        if (bitAt(bits, c) && pairs[static_cast<std::size_t>(c)] < 0)
            return false;
        if (bitAt(bits, c))
            scene.hardEdges[static_cast<std::size_t>(pairs[static_cast<std::size_t>(c)])] = true;
    }
    return true;
}

//! Two integers for each corner: red and green, then blue and whether the colour is known.
QByteArray packedColors(const CornerColors &colors)
{
    std::vector<int> integers;
    integers.reserve(2 * colors.size());
    for (const CornerColor &color : colors) {
        integers.push_back(static_cast<int>(color.linear[0] | unsigned(color.linear[1]) << 16));
        integers.push_back(static_cast<int>(color.linear[2] | unsigned(color.known) << 16));
    }
    return packedArray(integers);
}

//! Reads packedColors(); null when they are damaged.
std::shared_ptr<const CornerColors> unpackedColors(const QByteArray &bytes, int corners)
{
    const auto integers = unpackedIntegers(bytes, 2 * qsizetype(corners));
    if (!integers)
        return nullptr;
    CornerColors colors(static_cast<std::size_t>(corners));
    for (std::size_t c = 0; c < colors.size(); ++c) {
        const auto first = static_cast<unsigned>((*integers)[2 * c]);
        const auto second = static_cast<unsigned>((*integers)[2 * c + 1]);
        colors[c].known = (second >> 16 & 1) != 0;
        if (colors[c].known)
            colors[c].linear = {static_cast<std::uint16_t>(first & 0xffff),
                                static_cast<std::uint16_t>(first >> 16),
                                static_cast<std::uint16_t>(second & 0xffff)};
    }
    return std::make_shared<const CornerColors>(std::move(colors));
}

//! \param hasFile the file is stored, which has the vertex colours
QCborMap polygonsMap(const Scene &scene, bool hasFile)
{
    const MeshData &mesh = *scene.mesh;
    std::vector<int> sizes;
    for (int f = 0; f < mesh.faceCount(); ++f)
        sizes.push_back(mesh.faceStart[f + 1] - mesh.faceStart[f]);
    const std::span<const double> positions(mesh.positions.data(),
                                            static_cast<std::size_t>(mesh.positions.size()));
    QCborMap map{{"positions"_L1, packedArray(positions)},
                 {"faceSizes"_L1, packedArray(sizes)},
                 {"corners"_L1, packedArray(mesh.cornerVertex)},
                 {"faceObjects"_L1, packedArray(mesh.faceObject)}};
    if (!scene.hardEdges.empty())
        map["hardSides"_L1] = hardSides(scene);
    if (scene.cornerColors && !hasFile)
        map["cornerColors"_L1] = packedColors(*scene.cornerColors);
    return map;
}

Error damagedModel(const QString &path)
{
    return {u"the model in the session is damaged"_s, path, 0,
            u"Open a backup of it: the same name with .1 or .2 behind it"_s};
}

//! The start offsets of faces with the given numbers of corners; empty when the numbers do not add up.
std::vector<int> startsOf(const std::vector<int> &sizes, std::size_t cornerCount)
{
    std::vector<int> starts{0};
    for (int size : sizes) {
        if (size < 3 ||
            static_cast<std::size_t>(size) > cornerCount - static_cast<std::size_t>(starts.back()))
            return {};
        starts.push_back(starts.back() + size);
    }
    return starts;
}

Result<Scene> readPolygons(const QByteArray &part, const QString &path, QStringList &lost)
{
    CborReader reader(parsedMap(part).value_or(QCborMap()));
    const auto integers = [&](QLatin1StringView key) {
        const QByteArray bytes = reader.bytes(key);
        return unpackedIntegers(bytes, packedIntegerCount(bytes));
    };
    const QByteArray packedPositions = reader.bytes("positions"_L1);
    const auto positions = unpackedDoubles(packedPositions, packedDoubleCount(packedPositions));
    const auto sizes = integers("faceSizes"_L1);
    auto corners = integers("corners"_L1);
    auto objects = integers("faceObjects"_L1);
    if (reader.failed() || !positions || positions->size() % 3 != 0 || !sizes || !corners || !objects)
        return damagedModel(path);
    std::vector<int> starts = startsOf(*sizes, corners->size());
    const auto isNegative = [](int object) { return object < 0; };
    if (starts.empty() || std::any_of(objects->begin(), objects->end(), isNegative))
        return damagedModel(path);
    PositionMatrix matrix = Eigen::Map<const PositionMatrix>(
        positions->data(), static_cast<Eigen::Index>(positions->size() / 3), 3);
    Scene scene;
    scene.mesh =
        MeshData::build(std::move(matrix), std::move(starts), std::move(*corners), std::move(*objects));
    if (reader.contains("hardSides"_L1) && !readHardSides(reader.bytes("hardSides"_L1), scene))
        return damagedModel(path);
    if (reader.contains("cornerColors"_L1)) {
        scene.cornerColors = unpackedColors(reader.bytes("cornerColors"_L1), scene.mesh->cornerCount());
        if (!scene.cornerColors)
            lost << u"the vertex colours"_s;
    }
    return scene;
}

Result<Scene> readGltfPart(const QByteArray &part, const QString &path)
{
    const QCborMap map = parsedMap(part).value_or(QCborMap());
    GltfFile file{map.value("main"_L1).toByteArray(), {}};
    for (const auto &entry : map.value("outer"_L1).toMap())
        file.outer[entry.first.toString().toUtf8()] = entry.second.toByteArray();
    return parseGltf(std::move(file), path);
}

//! Gives the polygons the glTF file that they came from; false when the file is damaged.
bool addGltf(Scene &scene, const QByteArray &part, const QString &path)
{
    const Result<Scene> whole = readGltfPart(part, path);
    const MeshData &mesh = *scene.mesh;
    if (!whole || whole->mesh->faceStart != mesh.faceStart ||
        whole->mesh->cornerVertex != mesh.cornerVertex || whole->mesh->faceObject != mesh.faceObject ||
        whole->mesh->positions.rows() != mesh.positions.rows() || whole->mesh->positions != mesh.positions)
        return false;
    scene.source = whole->source;
    scene.cornerColors = whole->cornerColors;
    scene.materialTextures = whole->materialTextures;
    scene.materialSets = whole->materialSets;
    return true;
}

//! Reads the mesh, its hard edges and its source. A glTF file is stored with its polygons as well: so a
//! damaged block, or older programs, lose less.
Result<Scene> readModel(const PartMap &parts, const QString &path, QStringList &lost)
{
    const auto obj = parts.find("obj");
    const auto fbx = parts.find("fbx");
    const auto gltf = parts.find("gltf");
    const auto polygons = parts.find("polygons");
    if (obj != parts.end())
        return parseObj(obj->second, path);
    if (fbx != parts.end())
        return parseFbx(fbx->second, path);
    if (polygons == parts.end())
        return gltf == parts.end() ? damagedModel(path) : readGltfPart(gltf->second, path);
    Result<Scene> scene = readPolygons(polygons->second, path, lost);
    if (scene && gltf != parts.end() && !addGltf(scene.value(), gltf->second, path))
        lost << u"the glTF file"_s;
    return scene;
}

//! Replaces damaged names; false when the object numbers are damaged as well.
bool makeUpNames(Scene &scene, const QString &path)
{
    scene.path = path;
    const int last = lastObject(*scene.mesh);
    if (!scene.objectNames.empty())
        return true;
    if (last > scene.mesh->faceCount() + maxEmptyObjects)
        return false;
    for (int i = 0; i <= last; ++i)
        scene.objectNames.push_back(u"object %1"_s.arg(i + 1));
    return true;
}

} // namespace

PartMap scenePartsOf(const Scene &scene)
{
    PartMap parts;
    parts["scene"] = sceneMap(scene).toCborValue().toCbor();
    const FileSource *source = sourceOf(scene);
    const FileBlock block = source ? source->sessionBlock() : FileBlock();
    if (block.name)
        parts[block.name] = source->bytesForSession();
    if (!block.holdsPolygons)
        parts["polygons"] = polygonsMap(scene, block.name != nullptr).toCborValue().toCbor();
    return parts;
}

Result<Scene> readSceneParts(const PartMap &parts, const QString &path, QStringList &lost)
{
    try {
        Result<Scene> scene = readModel(parts, path, lost);
        if (!scene)
            return damagedModel(path);
        scene->uvSets.clear();
        const auto names = parts.find("scene");
        const std::optional<QCborMap> map = names == parts.end() ? std::nullopt : parsedMap(names->second);
        if (map && map->value("counts"_L1).toByteArray() != countsOf(*scene->mesh))
            return damagedModel(path);
        if (!map || !readNames(*map, scene.value())) {
            if (!makeUpNames(scene.value(), path))
                return damagedModel(path);
            lost << u"the names of objects and materials"_s;
        }
        return scene;
    } catch (const std::invalid_argument &) {
        return damagedModel(path);
    }
}

QString modelPathIn(const QByteArray &sceneBlock)
{
    const std::optional<QCborMap> map = parsedMap(sceneBlock);
    return map ? map->value("path"_L1).toString() : QString();
}

QStringList sessionLosses(const Scene &scene)
{
    const FileSource *source = sourceOf(scene);
    if (!source || source->sessionBlock().name)
        return {};
    return {u"the session holds the polygons, objects, materials' names, vertex colours and UV sets of the "
            u"%1 file, but "
            "not its normals, textures, bones, animations and hierarchy: to keep those, save the map in a "
            "model file as well"_s.arg(scene.format)};
}

} // namespace autocuts
