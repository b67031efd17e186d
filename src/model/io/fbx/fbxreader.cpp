#include "model/io/fbx/fbxreader.h"

#include "model/io/fbx/fbxcolors.h"
#include "model/io/fbx/fbxgeometry.h"
#include "model/io/fbx/fbxmaterials.h"
#include "model/io/fbx/fbxobjects.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/fbx/fbxshading.h"
#include "model/io/fbx/fbxsource.h"
#include "model/io/fbx/fbxuvsets.h"
#include "model/io/files/meshlimits.h"
#include "model/io/files/savefile.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Bytes; chosen by hand. Offsets in most binary files have 32 bits.
constexpr qint64 maxFbxSize = qint64(2) << 30;
//! What a corner of the soup takes of the room for arrays: a small file may repeat a geometry many times.
constexpr qint64 cornerBytes = 32;

class SceneBuilder
{
public:
    SceneBuilder(FbxTree tree, const QString &path, const std::atomic<bool> *stop)
        : mTree(std::move(tree)), mPath(path), mStop(stop), mSource(std::make_shared<FbxSource>())
    {}

    Result<Scene> build();

private:
    bool addModel(const FbxModel &model, const Eigen::Affine3d &transform);
    bool addInstance(std::size_t use, const FbxModel &model, const Eigen::Affine3d &transform);
    bool addPoints(const FbxGeometry &geometry, const FbxModel &model, const Eigen::Affine3d &transform);
    void addFaces(std::size_t use, const FbxModel &model, int firstVertex, bool mirrored);
    std::optional<std::size_t> useOf(int node);
    void joinSets();
    bool readUvs();
    void addNotes();
    bool cancelled()
    {
        if (!mStop || !*mStop)
            return false;
        mError = readingCancelled(mPath);
        return true;
    }
    bool fail(const QString &message)
    {
        mError = Error{message, mPath, 0, u"Export the model again from the program that made it"_s};
        return false;
    }

    void failWithoutFaces();

    FbxTree mTree;
    QString mPath;
    const std::atomic<bool> *mStop;
    std::shared_ptr<FbxSource> mSource;
    FbxObjects mObjects;
    FbxGeometries mGeometries;
    std::vector<FbxFaceSlots> mSlots; //!< by geometry
    std::optional<FbxMaterials> mMaterials;
    std::map<int, std::size_t> mUseOfNode;
    std::optional<Error> mError;
    Scene mScene;
    std::vector<double> mPositions;
    std::vector<int> mFaceStart{0}, mCornerVertex, mFaceObject;
    int mDamaged = 0; //!< geometries
    int mDamagedColors = 0;
};

//! Says what there is instead.
void SceneBuilder::failWithoutFaces()
{
    if (mDamaged > 0) {
        fail(u"the meshes of the file are damaged"_s);
        return;
    }
    QStringList held;
    if (mObjects.surfaces)
        held << u"NURBS surfaces"_s;
    if (mObjects.curves)
        held << u"curves"_s;
    if (mObjects.skeleton)
        held << u"a skeleton"_s;
    if (mObjects.contents.lightsOrCameras)
        held << u"lights or cameras"_s;
    fail(held.isEmpty() ? u"the file has no faces"_s
                        : u"the file has no faces, only %1"_s.arg(held.join(u", "_s)));
    if (mObjects.surfaces)
        mError->remedy = u"Convert the surfaces to polygons, and export the model again"_s;
    else if (!held.isEmpty())
        mError->remedy = u"Export the meshes, too"_s;
}

//! The geometry of a node, read when it is used for the first time; nothing when it is damaged.
std::optional<std::size_t> SceneBuilder::useOf(int node)
{
    if (const auto known = mUseOfNode.find(node); known != mUseOfNode.end())
        return known->second;
    std::optional<FbxGeometry> geometry = readFbxGeometry(mTree, node);
    if (!geometry)
        return {};
    mUseOfNode.emplace(node, mGeometries.size());
    mSource->uses.push_back({{static_cast<int>(geometry->faces.size()), {}}, node, {}});
    mSlots.push_back(readFbxFaceSlots(mTree, *geometry));
    mGeometries.push_back(std::move(*geometry));
    return mGeometries.size() - 1;
}

bool SceneBuilder::addPoints(const FbxGeometry &geometry, const FbxModel &model,
                             const Eigen::Affine3d &transform)
{
    for (Eigen::Index p = 0; p < geometry.points.rows(); ++p) {
        const Vec3 position = transform * Vec3(geometry.points.row(p));
        if (!position.allFinite() || position.cwiseAbs().maxCoeff() > maxCoordinate)
            return fail(
                u"a vertex of \"%1\" has a coordinate that is not finite or is too large"_s.arg(model.name));
        mPositions.insert(mPositions.end(), position.data(), position.data() + 3);
    }
    return true;
}

void SceneBuilder::addFaces(std::size_t use, const FbxModel &model, int firstVertex, bool mirrored)
{
    const FbxGeometry &geometry = mGeometries[use];
    const FbxFaceSlots &slots = mSlots[use];
    for (const int face : geometry.faces) {
        const auto begin = geometry.cornerPoint.begin() + geometry.polygonStart[face];
        const auto end = geometry.cornerPoint.begin() + geometry.polygonStart[face + 1];
        const auto first = std::ssize(mCornerVertex);
        for (auto point = begin; point != end; ++point)
            mCornerVertex.push_back(firstVertex + *point);
        if (mirrored)
            std::reverse(mCornerVertex.begin() + first, mCornerVertex.end());
        mFaceStart.push_back(static_cast<int>(mCornerVertex.size()));
        mFaceObject.push_back(static_cast<int>(mScene.objectNames.size()));
        mScene.faceMaterial.push_back(mMaterials->of(model, slots.materials[face], slots.textures[face]));
    }
}

bool SceneBuilder::addInstance(std::size_t use, const FbxModel &model, const Eigen::Affine3d &transform)
{
    const FbxGeometry &geometry = mGeometries[use];
    if (geometry.faces.empty())
        return true;
    if (mCornerVertex.size() + geometry.cornerPoint.size() > maxElements ||
        mPositions.size() / 3 + static_cast<std::size_t>(geometry.points.rows()) > maxElements ||
        !mTree.take((geometry.cornerCount() + geometry.points.rows()) * cornerBytes))
        return fail(u"the model is too large: its objects repeat their meshes too often"_s);
    const int firstVertex = static_cast<int>(mPositions.size() / 3);
    const bool mirrored = transform.linear().determinant() < 0;
    mSource->uses[use].instances.push_back({static_cast<int>(mFaceObject.size()), mirrored});
    if (!addPoints(geometry, model, transform))
        return false;
    addFaces(use, model, firstVertex, mirrored);
    return true;
}

bool SceneBuilder::addModel(const FbxModel &model, const Eigen::Affine3d &transform)
{
    const std::size_t firstFace = mFaceObject.size();
    for (const int node : model.geometries) {
        if (cancelled())
            return false;
        const std::optional<std::size_t> use = useOf(node);
        if (!use)
            ++mDamaged;
        else if (!addInstance(*use, model, transform))
            return false;
    }
    if (mFaceObject.size() > firstFace)
        mScene.objectNames.push_back(model.name);
    return true;
}

//! Finds the UV sets of all geometries.
void SceneBuilder::joinSets()
{
    FbxUvSets sets;
    for (FbxUse &use : mSource->uses) {
        if (use.instances.empty())
            continue;
        std::vector<int> nodes;
        std::vector<QString> names;
        for (int e = mTree.child(use.node, "LayerElementUV"); e >= 0; e = mTree.nextNamed(e)) {
            nodes.push_back(e);
            names.push_back(fbxLayerName(mTree, e));
        }
        const std::vector<int> joined = sets.join(names);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (joined[i] >= 0)
                use.elements.push_back({nodes[i], joined[i]});
        }
    }
    mSource->setNames = sets.names();
}

bool SceneBuilder::readUvs()
{
    const MeshData &mesh = *mScene.mesh;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const QString &name : mSource->setNames) {
        if (!mTree.take(16 * qint64(mesh.cornerCount())))
            return fail(u"the UV sets of the file are too large for its size"_s);
        mScene.uvSets.push_back({name, UvMatrix::Constant(mesh.cornerCount(), 2, nan)});
    }
    for (std::size_t u = 0; u < mSource->uses.size(); ++u) {
        const FbxUse &use = mSource->uses[u];
        for (const FbxUvElement &element : use.elements) {
            if (cancelled())
                return false;
            bool fits = false;
            const UvMatrix read = readFbxUv(mTree, element.node, mGeometries[u], fits);
            if (!fits)
                mScene.notes.push_back(u"the UV set \"%1\" of \"%2\" is damaged and was left out"_s.arg(
                    mSource->setNames[static_cast<std::size_t>(element.set)],
                    mScene
                        .objectNames[static_cast<std::size_t>(mesh.faceObject[use.instances[0].firstFace])]));
            UvMatrix &uv = mScene.uvSets[static_cast<std::size_t>(element.set)].uv;
            for (const FbxUse::Instance &instance : use.instances) {
                const std::vector<int> soup = fbxSoupCorners(mesh, mGeometries[u], instance);
                for (std::size_t c = 0; c < soup.size(); ++c) {
                    if (soup[c] >= 0 && read.row(static_cast<Eigen::Index>(c)).allFinite())
                        uv.row(soup[c]) = read.row(static_cast<Eigen::Index>(c));
                }
            }
        }
    }
    return true;
}

void SceneBuilder::addNotes()
{
    int elements = 0;
    int faces = 0;
    std::ptrdiff_t repeated = 0;
    for (std::size_t u = 0; u < mGeometries.size(); ++u) {
        elements += mGeometries[u].skippedElements;
        faces += mGeometries[u].skippedFaces;
        repeated += std::max<std::ptrdiff_t>(std::ssize(mSource->uses[u].instances) - 1, 0);
    }
    std::vector<QString> notes;
    if (elements > 0)
        notes.push_back(u"%1 point(s) and line(s) left out: they cannot be unwrapped"_s.arg(elements));
    if (faces > 0)
        notes.push_back(
            u"%1 face(s) left out: their vertices are damaged, or fewer than three differ"_s.arg(faces));
    if (mDamaged > 0)
        notes.push_back(u"%1 mesh(es) left out: their data are damaged"_s.arg(mDamaged));
    if (mDamagedColors > 0)
        notes.push_back(
            u"the vertex colours of %1 mesh(es) left out: their data are damaged"_s.arg(mDamagedColors));
    if (repeated > 0)
        notes.push_back(
            u"%1 object(s) share a mesh with another object: the file holds one map for both, unless the "
            "meshes are made unique"_s.arg(repeated));
    mObjects.contents.instances = repeated > 0;
    mScene.notes.insert(mScene.notes.begin(), notes.begin(), notes.end());
}

Result<Scene> SceneBuilder::build()
{
    mObjects = readFbxObjects(mTree);
    mMaterials.emplace(mObjects);
    const std::vector<Eigen::Affine3d> transforms = fbxTransforms(mTree, mObjects);
    for (std::size_t m = 0; m < mObjects.models.size(); ++m) {
        if (mObjects.models[m].connected && !addModel(mObjects.models[m], transforms[m]))
            return *mError;
    }
    if (mFaceObject.empty()) {
        failWithoutFaces();
        return *mError;
    }
    mScene.path = mPath;
    mScene.format = u"fbx"_s;
    mScene.materialNames = std::move(mObjects.materialNames);
    mScene.materialColors = std::move(mObjects.materialColors);
    mScene.materialTextures = std::move(mObjects.materialTextures);
    mScene.materialSets = std::move(mObjects.materialSets);
    PositionMatrix positions = Eigen::Map<const PositionMatrix>(
        mPositions.data(), static_cast<Eigen::Index>(mPositions.size() / 3), 3);
    mPositions = {};
    mScene.mesh = MeshData::build(std::move(positions), std::move(mFaceStart), std::move(mCornerVertex),
                                  std::move(mFaceObject));
    joinSets();
    if (!readUvs() || cancelled())
        return *mError;
    mScene.hardEdges = fbxHardEdges(mTree, *mScene.mesh, *mSource, mGeometries);
    mScene.cornerColors = fbxCornerColors(mTree, *mScene.mesh, *mSource, mGeometries, mDamagedColors);
    addNotes();
    mSource->bytes = mTree.bytes;
    mSource->version = mTree.version;
    mSource->space = fbxSpace(mTree);
    mSource->contents = mObjects.contents;
    mSource->corners = mScene.mesh->cornerCount();
    mScene.source = mSource;
    return std::move(mScene);
}

} // namespace

Result<Scene> parseFbx(QByteArray bytes, const QString &path, const std::atomic<bool> *stop)
{
    Result<FbxTree> tree = parseFbxTree(std::move(bytes), path, stop);
    if (!tree)
        return tree.error();
    return SceneBuilder(std::move(tree).value(), path, stop).build();
}

Result<Scene> readFbx(const QString &path, const std::atomic<bool> *stop)
{
    Result<QByteArray> bytes = loadFile(path, maxFbxSize);
    if (!bytes)
        return bytes.error();
    return parseFbx(std::move(bytes).value(), path, stop);
}

} // namespace autocuts
