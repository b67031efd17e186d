#include "model/io/fbx/fbxwriter.h"

#include "model/io/fbx/assimpfbx.h"
#include "model/io/fbx/fbxeditor.h"
#include "model/io/fbx/fbxnewmaterials.h"
#include "model/io/fbx/fbxnewobjects.h"
#include "model/io/fbx/fbxuvdata.h"
#include "model/io/fbx/fbxuvelements.h"
#include "model/io/files/savefile.h"
#include "model/io/formats/filesource.h"
#include "model/io/formats/meshformats.h"
#include "model/io/formats/modelunits.h"
#include "model/plain/picture.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace autocuts {

namespace {

// What programs compare of a file: an id, a time, and the id of the footer that follows from both. These
// three fit each other.
constexpr QByteArrayView fileId("\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16);
constexpr QByteArrayView creationTime("1970-01-01 10:00:00:000");
constexpr QByteArrayView footerId("\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e", 16);
constexpr QByteArrayView footerEnd("\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16);

FbxNewNode layerElement(const char *name, const char *mapping, const char *reference, FbxNewNode content)
{
    return {name,
            {std::int32_t(0)},
            {fbxLeaf("Version", std::int32_t(101)), fbxLeaf("Name", QByteArray()),
             fbxLeaf("MappingInformationType", QByteArray(mapping)),
             fbxLeaf("ReferenceInformationType", QByteArray(reference)), std::move(content)},
            true};
}

FbxNewNode header()
{
    return {"FBXHeaderExtension",
            {},
            {fbxLeaf("FBXHeaderVersion", std::int32_t(1003)), fbxLeaf("FBXVersion", std::int32_t(7400)),
             fbxLeaf("Creator", QByteArray("Autocuts"))},
            true};
}

//! x to the right, y up, z to the front; one unit is a metre.
FbxNewNode globalSettings()
{
    std::vector<FbxNewNode> properties;
    const std::pair<const char *, int> axes[] = {{"UpAxis", 1},    {"UpAxisSign", 1},
                                                 {"FrontAxis", 2}, {"FrontAxisSign", 1},
                                                 {"CoordAxis", 0}, {"CoordAxisSign", 1}};
    for (const auto &[name, value] : axes)
        properties.push_back(fbxProperty(name, "int", "Integer", {std::int32_t(value)}));
    properties.push_back(fbxNumber("UnitScaleFactor", 100.0));
    return {"GlobalSettings",
            {},
            {fbxLeaf("Version", std::int32_t(1000)), fbxProperties(std::move(properties))},
            true};
}

//! Makes the objects of a scene and their connections.
class SceneNodes
{
public:
    SceneNodes(const Scene &scene, const QString &path)
        : mScene(scene), mMesh(*scene.mesh), mPath(path),
          mPositions(inUnits(scene.mesh->positions, unitsOf(scene), {})),
          mReversed(static_cast<std::size_t>(scene.mesh->faceCount()), false)
    {
        if (const FileSource *source = sourceOf(scene)) {
            FileShading shading = source->shading();
            mNormals = std::move(shading.normals);
            setSmoothing(shading.smoothing);
        }
        if (mNormals.rows() != mMesh.cornerCount() || !mNormals.allFinite())
            mNormals.resize(0, 3);
        if (const auto *assimp = sourceOf<AssimpSource>(scene))
            takePieces(*assimp);
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
    void takePieces(const AssimpSource &source);
    void setSmoothing(const std::vector<std::int64_t> &groups);
    bool mayWeld(const std::vector<int> &faces) const;
    Part partOf(const std::vector<int> &faces) const;
    std::int64_t addGeometry(const Part &part);
    void addUvSets(std::vector<FbxNewNode> &geometry, const Part &part) const;
    FbxNewNode colors(const Part &part) const;
    void addObject(int object, const std::vector<int> &faces, FbxRig *rig);

    const Scene &mScene;
    const MeshData &mMesh;
    QString mPath;
    const AssimpSource *mAssimp = nullptr; //!< whose nodes are written; null: objects have their true places
    PositionMatrix mPositions;             //!< of vertices, in metres, in the coordinates of their node
    std::vector<FbxSkinPoint> mOrigin;     //!< of each vertex; empty without Assimp
    std::vector<int> mNodeOf;              //!< by object
    std::vector<bool> mReversed;           //!< per face: its corners are in reverse order in its node
    PositionMatrix mNormals;               //!< per corner; no rows when there are none
    std::vector<int> mSmoothing; //!< per face: a bit for its smoothing group; empty when there are none
    FbxNewObjects mObjects;
    std::vector<std::int64_t> mMaterials;
};

//! Takes the meshes as Assimp has them. Those of formats with z up have no nodes worth keeping.
void SceneNodes::takePieces(const AssimpSource &source)
{
    const bool keepNodes = !unitsOf(mScene).zUp;
    AssimpPoints points = assimpPoints(source, mMesh);
    if (keepNodes) {
        mAssimp = &source;
        mOrigin = std::move(points.origin);
        mPositions = std::move(points.positions);
        mReversed = std::move(points.reversed);
    } else if (points.normals.rows() > 0) {
        points.normals = inUnits(points.normals, unitsOf(mScene), {});
    }
    mNormals = std::move(points.normals);
    mNodeOf = std::move(points.nodeOfObject);
}

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

//! glTF and what Assimp reads have one vertex for each normal and UV at a place. They become one, unless two
//! faces would have the same vertices.
bool SceneNodes::mayWeld(const std::vector<int> &faces) const
{
    if (mOrigin.empty())
        return false;
    std::set<std::vector<int>> seen;
    for (const int face : faces) {
        std::vector<int> vertices;
        for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
            vertices.push_back(mMesh.vertexWeld[mMesh.cornerVertex[c]]);
        std::ranges::sort(vertices);
        if (!seen.insert(std::move(vertices)).second)
            return false;
    }
    return true;
}

SceneNodes::Part SceneNodes::partOf(const std::vector<int> &faces) const
{
    Part part;
    part.faces = faces;
    const bool weld = mayWeld(faces);
    std::map<int, int> points, slots;
    for (const int face : faces) {
        const int begin = mMesh.faceStart[face], end = mMesh.faceStart[face + 1];
        for (int i = 0; i < end - begin; ++i) {
            const int c = mReversed[static_cast<std::size_t>(face)] ? end - 1 - i : begin + i;
            const int vertex = mMesh.cornerVertex[c];
            const auto [it, isNew] = points.try_emplace(weld ? mMesh.vertexWeld[vertex] : vertex,
                                                        static_cast<int>(part.vertices.size()));
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

void SceneNodes::addUvSets(std::vector<FbxNewNode> &geometry, const Part &part) const
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
        geometry.push_back(newUvElement(index, set.name, std::move(data)));
        layers.push_back(newUvLayer(index, index));
    }
    if (layers.empty())
        layers.push_back({"Layer", {std::int32_t(0)}, {fbxLeaf("Version", std::int32_t(100))}, true});
    for (const char *name :
         {"LayerElementNormal", "LayerElementColor", "LayerElementSmoothing", "LayerElementMaterial"}) {
        const QByteArray wanted(name);
        if (std::ranges::find(geometry, wanted, &FbxNewNode::name) != geometry.end())
            layers[0].children.push_back({"LayerElement",
                                          {},
                                          {fbxLeaf("Type", wanted), fbxLeaf("TypedIndex", std::int32_t(0))},
                                          true});
    }
    geometry.insert(geometry.end(), layers.begin(), layers.end());
}

//! White where the scene says nothing.
FbxNewNode SceneNodes::colors(const Part &part) const
{
    std::vector<double> values;
    for (const int corner : part.corners) {
        const CornerColor &color = (*mScene.cornerColors)[static_cast<std::size_t>(corner)];
        const Eigen::Vector3f linear = color.known ? color.value() : Eigen::Vector3f(Eigen::Vector3f::Ones());
        for (const float share : linear)
            values.push_back(static_cast<double>(srgbFromLinear(share)));
        values.push_back(1);
    }
    return layerElement("LayerElementColor", "ByPolygonVertex", "Direct",
                        fbxLeaf("Colors", std::move(values)));
}

std::int64_t SceneNodes::addGeometry(const Part &part)
{
    std::vector<double> points, normals;
    for (const int v : part.vertices)
        points.insert(points.end(), {mPositions(v, 0), mPositions(v, 1), mPositions(v, 2)});
    std::vector<int> indices = part.point;
    std::size_t end = 0;
    for (const int face : part.faces) {
        end += static_cast<std::size_t>(mMesh.faceStart[face + 1] - mMesh.faceStart[face]);
        indices[end - 1] = -1 - indices[end - 1];
    }
    std::vector<FbxNewNode> children{fbxLeaf("GeometryVersion", std::int32_t(124)),
                                     fbxLeaf("Vertices", std::move(points)),
                                     fbxLeaf("PolygonVertexIndex", std::move(indices))};
    for (std::size_t c = 0; mNormals.rows() > 0 && c < part.corners.size(); ++c) {
        const Vec3 normal = mNormals.row(part.corners[c]);
        normals.insert(normals.end(), normal.data(), normal.data() + 3);
    }
    if (!normals.empty())
        children.push_back(layerElement("LayerElementNormal", "ByPolygonVertex", "Direct",
                                        fbxLeaf("Normals", std::move(normals))));
    const auto known = [this](int c) { return (*mScene.cornerColors)[static_cast<std::size_t>(c)].known; };
    if (mScene.cornerColors && std::ranges::any_of(part.corners, known))
        children.push_back(colors(part));
    if (!mSmoothing.empty()) {
        std::vector<int> smoothing;
        for (const int face : part.faces)
            smoothing.push_back(mSmoothing[face]);
        children.push_back(layerElement("LayerElementSmoothing", "ByPolygon", "Direct",
                                        fbxLeaf("Smoothing", std::move(smoothing))));
    }
    if (!part.materials.empty())
        children.push_back(layerElement("LayerElementMaterial", "ByPolygon", "IndexToDirect",
                                        fbxLeaf("Materials", part.slots)));
    addUvSets(children, part);
    return mObjects.add("Geometry", {}, "Mesh", std::move(children));
}

//! \param rig null: the object gets a model of its own
void SceneNodes::addObject(int object, const std::vector<int> &faces, FbxRig *rig)
{
    const Part part = partOf(faces);
    const std::int64_t geometry = addGeometry(part);
    std::int64_t model = 0;
    if (rig) {
        const int node = mNodeOf[static_cast<std::size_t>(object)];
        model = rig->model(node);
        std::vector<FbxSkinPoint> points;
        for (const int vertex : part.vertices)
            points.push_back(mOrigin[static_cast<std::size_t>(vertex)]);
        rig->addSkin(geometry, node, points);
    } else {
        const bool named = object >= 0 && object < std::ssize(mScene.objectNames);
        const QString name = named ? mScene.objectNames[object] : QString();
        model = addFbxModel(mObjects, name.isEmpty() ? QStringLiteral("object") : name, "Mesh",
                            Eigen::Affine3d::Identity());
        mObjects.connect(model, 0);
    }
    mObjects.connect(geometry, model);
    for (const int material : part.materials)
        mObjects.connect(mMaterials[static_cast<std::size_t>(material)], model);
}

std::vector<FbxNewNode> SceneNodes::make()
{
    std::map<int, std::vector<int>> objects;
    for (int f = 0; f < mMesh.faceCount(); ++f)
        objects[mMesh.faceObject[f]].push_back(f);
    mMaterials = FbxNewMaterials(mObjects, mScene, mPath).add();
    std::optional<FbxRig> rig;
    if (mAssimp) {
        std::map<int, QString> names;
        for (const auto &[object, faces] : objects)
            names[mNodeOf[static_cast<std::size_t>(object)]] =
                mScene.objectNames[static_cast<std::size_t>(object)];
        rig.emplace(mObjects, *mAssimp, isGltfFormat(mScene.format));
        rig->addNodes(names);
    }
    for (const auto &[object, faces] : objects)
        addObject(object, faces, rig ? &*rig : nullptr);
    if (rig)
        rig->addAnimations();
    return {header(),
            fbxLeaf("FileId", FbxRaw{fileId.toByteArray()}),
            fbxLeaf("CreationTime", creationTime.toByteArray()),
            fbxLeaf("Creator", QByteArray("Autocuts")),
            globalSettings(),
            {"Documents", {}, {fbxLeaf("Count", std::int32_t(0))}, true},
            {"References", {}, {}, true},
            mObjects.definitions(),
            mObjects.takeObjects(),
            mObjects.takeConnections()};
}

} // namespace

QByteArray fbxBytes(const Scene &scene, const QString &path)
{
    const FbxStyle style;
    QByteArray out("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0", 27);
    for (const FbxNewNode &node : SceneNodes(scene, path).make())
        out.append(fbxNodeBytes(node, style, out.size()));
    out.append(13, '\0').append(footerId).append(4, '\0');
    out.append(16 - out.size() % 16, '\0');
    out.append("\xe8\x1c\0\0", 4).append(120, '\0');
    return out.append(footerEnd);
}

Result<Done> writeNewFbx(const Scene &scene, const QString &path)
{
    return saveAtomically(path, fbxBytes(scene, path));
}

} // namespace autocuts
