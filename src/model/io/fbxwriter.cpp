#include "model/io/fbxwriter.h"

#include "model/io/fbxeditor.h"
#include "model/io/fbxuvdata.h"
#include "model/io/fbxuvelements.h"
#include "model/io/objsource.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

// What programs compare of a file: an id, a time, and the id of the footer that follows from both. These
// three fit each other.
constexpr QByteArrayView fileId("\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16);
constexpr QByteArrayView creationTime("1970-01-01 10:00:00:000");
constexpr QByteArrayView footerId("\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e", 16);
constexpr QByteArrayView footerEnd("\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16);

FbxNewNode leaf(const char *name, FbxNewValue value)
{
    return {name, {std::move(value)}, {}, false};
}

QByteArray objectName(const QString &name, const char *kind)
{
    return name.toUtf8() + QByteArray("\0\1", 2) + kind;
}

FbxNewNode property(const char *name, const char *type, const char *label, std::vector<FbxNewValue> values)
{
    FbxNewNode node{"P", {QByteArray(name), QByteArray(type), QByteArray(label), QByteArray()}, {}, false};
    node.values.insert(node.values.end(), values.begin(), values.end());
    return node;
}

FbxNewNode layerElement(const char *name, const char *mapping, const char *reference, FbxNewNode content)
{
    return {name,
            {std::int32_t(0)},
            {leaf("Version", std::int32_t(101)), leaf("Name", QByteArray()),
             leaf("MappingInformationType", QByteArray(mapping)),
             leaf("ReferenceInformationType", QByteArray(reference)), std::move(content)},
            true};
}

FbxNewNode header()
{
    return {"FBXHeaderExtension",
            {},
            {leaf("FBXHeaderVersion", std::int32_t(1003)), leaf("FBXVersion", std::int32_t(7400)),
             leaf("Creator", QByteArray("Autocuts"))},
            true};
}

//! x to the right, y up, z to the front, one unit is a centimetre.
FbxNewNode globalSettings()
{
    FbxNewNode properties{"Properties70", {}, {}, true};
    const std::pair<const char *, int> axes[] = {{"UpAxis", 1},    {"UpAxisSign", 1},
                                                 {"FrontAxis", 2}, {"FrontAxisSign", 1},
                                                 {"CoordAxis", 0}, {"CoordAxisSign", 1}};
    for (const auto &[name, value] : axes)
        properties.children.push_back(property(name, "int", "Integer", {std::int32_t(value)}));
    properties.children.push_back(property("UnitScaleFactor", "double", "Number", {1.0}));
    return {"GlobalSettings", {}, {leaf("Version", std::int32_t(1000)), properties}, true};
}

//! Makes the objects of a scene and their connections.
class SceneNodes
{
public:
    explicit SceneNodes(const Scene &scene) : mScene(scene), mMesh(*scene.mesh)
    {
        const auto *obj = dynamic_cast<const ObjSource *>(scene.source.get());
        if (obj && std::ssize(obj->cornerTextureVertex) == mMesh.cornerCount()) {
            FileShading shading = objShading(*obj);
            mNormals = std::move(shading.normals);
            setSmoothing(shading.smoothing);
        }
        if (mNormals.rows() != mMesh.cornerCount() || !mNormals.allFinite())
            mNormals.resize(0, 3);
    }

    std::vector<FbxNewNode> make();

private:
    //! The part of the soup that is one object, with vertices of its own.
    struct Part
    {
        std::vector<int> faces, corners, point; //!< corners of the soup, and the point of each
        std::vector<int> vertices;              //!< of the soup, by point
        std::vector<int> slots, materials;      //!< material slot of each face, material of each slot
    };
    void setSmoothing(const std::vector<std::int64_t> &groups);
    Part partOf(const std::vector<int> &faces) const;
    FbxNewNode geometry(std::int64_t id, const Part &part) const;
    void addUvSets(FbxNewNode &geometry, const Part &part) const;
    void addObject(int object, const std::vector<int> &faces);
    void addMaterials();
    void connect(std::int64_t child, std::int64_t parent)
    {
        mConnections.children.push_back({"C", {QByteArray("OO"), child, parent}, {}, false});
    }
    FbxNewNode definitions() const;

    static constexpr std::int64_t firstMaterial = 1'000'000'000, firstGeometry = 2'000'000'000,
                                  firstModel = 3'000'000'000;
    const Scene &mScene;
    const MeshData &mMesh;
    PositionMatrix mNormals;     //!< per corner; no rows when there are none
    std::vector<int> mSmoothing; //!< per face: a bit for its smoothing group; empty when there are none
    FbxNewNode mObjects{"Objects", {}, {}, true};
    FbxNewNode mConnections{"Connections", {}, {}, true};
    int mCount = 0;
};

//! Gives each group a bit of its own. FBX has 32; of more groups none is written.
void SceneNodes::setSmoothing(const std::vector<std::int64_t> &groups)
{
    std::map<std::int64_t, std::uint32_t> bits;
    for (const std::int64_t group : groups) {
        if (group > 0)
            bits.try_emplace(group, bits.size() < 32 ? 1U << bits.size() : 0);
    }
    if (bits.empty() || bits.size() > 32 || std::ssize(groups) != mMesh.faceCount())
        return;
    for (const std::int64_t group : groups)
        mSmoothing.push_back(group > 0 ? static_cast<int>(bits[group]) : 0);
}

SceneNodes::Part SceneNodes::partOf(const std::vector<int> &faces) const
{
    Part part;
    part.faces = faces;
    std::map<int, int> points, slots;
    for (const int face : faces) {
        for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
            const int vertex = mMesh.cornerVertex[c];
            const auto [it, isNew] = points.try_emplace(vertex, static_cast<int>(part.vertices.size()));
            if (isNew)
                part.vertices.push_back(vertex);
            part.corners.push_back(c);
            part.point.push_back(it->second);
        }
        const int material = face < std::ssize(mScene.faceMaterial) ? mScene.faceMaterial[face] : -1;
        if (material < 0) {
            part.slots.push_back(-1);
            continue;
        }
        const auto [it, isNew] = slots.try_emplace(material, static_cast<int>(part.materials.size()));
        if (isNew)
            part.materials.push_back(material);
        part.slots.push_back(it->second);
    }
    return part;
}

void SceneNodes::addUvSets(FbxNewNode &geometry, const Part &part) const
{
    std::vector<FbxNewNode> layers;
    for (const UvSet &set : mScene.uvSets) {
        UvMatrix uv(std::ssize(part.corners), 2);
        bool any = false;
        for (std::size_t c = 0; c < part.corners.size(); ++c) {
            uv.row(static_cast<Eigen::Index>(c)) = set.uv.row(part.corners[c]);
            any = any || uv.row(static_cast<Eigen::Index>(c)).allFinite();
        }
        if (!any)
            continue;
        const int index = static_cast<int>(layers.size());
        FbxUvData data = fbxUvData(part.point, static_cast<int>(part.vertices.size()), uv);
        geometry.children.push_back(newUvElement(index, set.name, std::move(data)));
        layers.push_back(newUvLayer(index, index));
    }
    if (layers.empty())
        layers.push_back({"Layer", {std::int32_t(0)}, {leaf("Version", std::int32_t(100))}, true});
    for (const char *name : {"LayerElementNormal", "LayerElementSmoothing", "LayerElementMaterial"}) {
        const QByteArray wanted(name);
        if (std::ranges::find(geometry.children, wanted, &FbxNewNode::name) != geometry.children.end())
            layers[0].children.push_back(
                {"LayerElement", {}, {leaf("Type", wanted), leaf("TypedIndex", std::int32_t(0))}, true});
    }
    geometry.children.insert(geometry.children.end(), layers.begin(), layers.end());
}

FbxNewNode SceneNodes::geometry(std::int64_t id, const Part &part) const
{
    std::vector<double> points, normals;
    for (const int v : part.vertices)
        points.insert(points.end(), {mMesh.positions(v, 0), mMesh.positions(v, 1), mMesh.positions(v, 2)});
    std::vector<int> indices = part.point;
    std::size_t end = 0;
    for (const int face : part.faces) {
        end += static_cast<std::size_t>(mMesh.faceStart[face + 1] - mMesh.faceStart[face]);
        indices[end - 1] = -1 - indices[end - 1];
    }
    FbxNewNode node{"Geometry", {id, objectName({}, "Geometry"), QByteArray("Mesh")}, {}, true};
    node.children = {leaf("GeometryVersion", std::int32_t(124)), leaf("Vertices", std::move(points)),
                     leaf("PolygonVertexIndex", std::move(indices))};
    for (std::size_t c = 0; mNormals.rows() > 0 && c < part.corners.size(); ++c) {
        const Vec3 normal = mNormals.row(part.corners[c]);
        normals.insert(normals.end(), normal.data(), normal.data() + 3);
    }
    if (!normals.empty())
        node.children.push_back(layerElement("LayerElementNormal", "ByPolygonVertex", "Direct",
                                             leaf("Normals", std::move(normals))));
    if (!mSmoothing.empty()) {
        std::vector<int> smoothing;
        for (const int face : part.faces)
            smoothing.push_back(mSmoothing[face]);
        node.children.push_back(layerElement("LayerElementSmoothing", "ByPolygon", "Direct",
                                             leaf("Smoothing", std::move(smoothing))));
    }
    if (!part.materials.empty())
        node.children.push_back(layerElement("LayerElementMaterial", "ByPolygon", "IndexToDirect",
                                             leaf("Materials", part.slots)));
    addUvSets(node, part);
    return node;
}

void SceneNodes::addObject(int object, const std::vector<int> &faces)
{
    const Part part = partOf(faces);
    const std::int64_t geometryId = firstGeometry + mCount;
    const std::int64_t modelId = firstModel + mCount++;
    const bool named = object >= 0 && object < std::ssize(mScene.objectNames);
    const QString name = named ? mScene.objectNames[object] : QString();
    mObjects.children.push_back(geometry(geometryId, part));
    mObjects.children.push_back(
        {"Model",
         {modelId, objectName(name.isEmpty() ? QStringLiteral("object") : name, "Model"), QByteArray("Mesh")},
         {leaf("Version", std::int32_t(232)),
          {"Properties70", {}, {property("InheritType", "enum", "", {std::int32_t(1)})}, true},
          leaf("Culling", QByteArray("CullingOff"))},
         true});
    connect(modelId, 0);
    connect(geometryId, modelId);
    for (const int material : part.materials)
        connect(firstMaterial + material, modelId);
}

void SceneNodes::addMaterials()
{
    for (std::size_t m = 0; m < mScene.materialNames.size(); ++m)
        mObjects.children.push_back(
            {"Material",
             {firstMaterial + static_cast<std::int64_t>(m), objectName(mScene.materialNames[m], "Material"),
              QByteArray()},
             {leaf("Version", std::int32_t(102)),
              leaf("ShadingModel", QByteArray("lambert")),
              leaf("MultiLayer", std::int32_t(0)),
              {"Properties70", {}, {property("DiffuseColor", "Color", "", {0.8, 0.8, 0.8})}, true}},
             true});
}

FbxNewNode SceneNodes::definitions() const
{
    FbxNewNode node{"Definitions", {}, {leaf("Version", std::int32_t(100))}, true};
    const auto materials = static_cast<std::int32_t>(mScene.materialNames.size());
    node.children.push_back(leaf("Count", std::int32_t(1 + 2 * mCount + materials)));
    const std::pair<const char *, int> types[] = {
        {"GlobalSettings", 1}, {"Geometry", mCount}, {"Model", mCount}, {"Material", materials}};
    for (const auto &[type, count] : types)
        node.children.push_back(
            {"ObjectType", {QByteArray(type)}, {leaf("Count", std::int32_t(count))}, true});
    return node;
}

std::vector<FbxNewNode> SceneNodes::make()
{
    std::map<int, std::vector<int>> objects;
    for (int f = 0; f < mMesh.faceCount(); ++f)
        objects[mMesh.faceObject[f]].push_back(f);
    for (const auto &[object, faces] : objects)
        addObject(object, faces);
    addMaterials();
    return {header(),
            leaf("FileId", FbxRaw{fileId.toByteArray()}),
            leaf("CreationTime", creationTime.toByteArray()),
            leaf("Creator", QByteArray("Autocuts")),
            globalSettings(),
            {"Documents", {}, {leaf("Count", std::int32_t(0))}, true},
            {"References", {}, {}, true},
            definitions(),
            std::move(mObjects),
            std::move(mConnections)};
}

} // namespace

QByteArray fbxBytes(const Scene &scene)
{
    const FbxStyle style;
    QByteArray out("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0", 27);
    for (const FbxNewNode &node : SceneNodes(scene).make())
        out.append(fbxNodeBytes(node, style, out.size()));
    out.append(13, '\0').append(footerId).append(4, '\0');
    out.append(16 - out.size() % 16, '\0');
    out.append("\xe8\x1c\0\0", 4).append(120, '\0');
    return out.append(footerEnd);
}

} // namespace autocuts
