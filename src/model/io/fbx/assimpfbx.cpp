#include "model/io/fbx/assimpfbx.h"

#include "model/io/assimp/assimpbinding.h"
#include "model/io/assimp/assimpmatrix.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace autocuts {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double ticksPerSecond = 46186158000.0; //!< of FBX
constexpr double filmInches = 1.259842;          //!< 32 mm
constexpr double centimetres = 100;              //!< in a metre

//! Angles of a rotation in degrees: about x first, then y, then z. \param near of the many, those close to
//! these
Vec3 anglesOf(const Eigen::Matrix3d &rotation, const Vec3 &near = Vec3::Zero())
{
    const double y = std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0));
    Vec3 first;
    if (std::abs(rotation(2, 0)) > 1 - 1e-12) {
        first = {std::atan2(-rotation(1, 2), rotation(1, 1)), y, 0};
    } else {
        first = {std::atan2(rotation(2, 1), rotation(2, 2)), y, std::atan2(rotation(1, 0), rotation(0, 0))};
    }
    first *= degrees;
    Vec3 second(first.x() + 180, 180 - first.y(), first.z() + 180);
    const auto closeTo = [&near](Vec3 angles) {
        for (int k = 0; k < 3; ++k)
            angles[k] += 360 * std::round((near[k] - angles[k]) / 360);
        return angles;
    };
    first = closeTo(first);
    second = closeTo(second);
    return (first - near).squaredNorm() <= (second - near).squaredNorm() ? first : second;
}

struct Parts
{
    Vec3 translation;
    Eigen::Matrix3d rotation;
    Vec3 scaling;
};

Parts partsOf(const Eigen::Affine3d &transform)
{
    Parts parts{transform.translation(), transform.linear(), Vec3::Ones()};
    for (int k = 0; k < 3; ++k) {
        parts.scaling[k] = parts.rotation.col(k).norm();
        if (parts.scaling[k] > 0)
            parts.rotation.col(k) /= parts.scaling[k];
    }
    if (parts.rotation.determinant() < 0) {
        parts.scaling.x() *= -1;
        parts.rotation.col(0) *= -1;
    }
    if (!(std::abs(parts.rotation.determinant()) > 1e-6))
        parts.rotation.setIdentity();
    return parts;
}

template <typename T>
const T *objectOf(T *const *objects, unsigned count, const aiString &name)
{
    T *const *found =
        std::find_if(objects, objects + count, [&name](const T *o) { return o->mName == name; });
    return found == objects + count ? nullptr : *found;
}

Eigen::Matrix3d turnOf(bool isCamera)
{
    Eigen::Matrix3d turn;
    if (isCamera) // along x, y up
        turn << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    else // along -y
        turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return turn;
}

std::vector<FbxNewNode> cameraProperties(const aiCamera &camera)
{
    const double aspect = camera.mAspect > 0 ? camera.mAspect : 16.0 / 9;
    const double wide = camera.mHorizontalFOV > 0 && camera.mHorizontalFOV < 3 ? camera.mHorizontalFOV : 0.7;
    std::vector<FbxNewNode> properties{
        fbxProperty("AspectWidth", "double", "Number", {aspect}),
        fbxProperty("AspectHeight", "double", "Number", {1.0}),
        fbxNumber("FilmWidth", filmInches),
        fbxNumber("FilmHeight", filmInches / aspect),
        fbxNumber("FilmAspectRatio", aspect),
        fbxProperty("ApertureMode", "enum", "", {std::int32_t(3)}),
        fbxProperty("FieldOfView", "FieldOfView", "", {wide * degrees}),
        fbxNumber("FocalLength", filmInches * 25.4 / 2 / std::tan(wide / 2)),
        fbxNumber("NearPlane", std::max<double>(camera.mClipPlaneNear, 0.001)),
        fbxNumber("FarPlane", camera.mClipPlaneFar > 0 ? camera.mClipPlaneFar : 1000.0)};
    if (camera.mOrthographicWidth > 0) {
        properties.push_back(fbxProperty("CameraProjectionType", "enum", "", {std::int32_t(1)}));
        properties.push_back(fbxNumber("OrthoZoom", 2.0 * camera.mOrthographicWidth));
    }
    return properties;
}

std::vector<FbxNewNode> lightProperties(const aiLight &light, bool fromGltf)
{
    const bool sun = light.mType == aiLightSource_DIRECTIONAL;
    const Vec3 color(light.mColorDiffuse.r, light.mColorDiffuse.g, light.mColorDiffuse.b);
    const double strength = color.maxCoeff();
    const double watts = fromGltf ? strength * (sun ? 1 : 4 * std::numbers::pi) / 683 : strength;
    const int type = sun                                 ? 1
                     : light.mType == aiLightSource_SPOT ? 2
                     : light.mType == aiLightSource_AREA ? 3
                                                         : 0;
    return {fbxProperty("LightType", "enum", "", {std::int32_t(type)}),
            fbxVector("Color", "Color", strength > 0 ? Vec3(color / strength) : Vec3(Vec3::Ones())),
            fbxProperty("Intensity", "Number", "", {centimetres * watts}),
            fbxProperty("InnerAngle", "Number", "", {light.mAngleInnerCone * degrees}),
            fbxProperty("OuterAngle", "Number", "", {light.mAngleOuterCone * degrees})};
}

} // namespace

AssimpPoints assimpPoints(const AssimpSource &source, const MeshData &mesh)
{
    AssimpPoints points;
    points.positions = mesh.positions;
    points.origin.resize(static_cast<std::size_t>(mesh.vertexCount()));
    points.reversed.assign(static_cast<std::size_t>(mesh.faceCount()), false);
    points.normals = PositionMatrix::Zero(mesh.cornerCount(), 3);
    for (const AssimpPiece &piece : source.pieces) {
        const aiMesh &from = *source.scene->mMeshes[piece.mesh];
        for (unsigned v = 0; v < from.mNumVertices; ++v) {
            const aiVector3D &p = from.mVertices[v];
            const auto row = static_cast<std::size_t>(piece.firstVertex) + v;
            points.positions.row(static_cast<Eigen::Index>(row)) << p.x, p.y, p.z;
            points.origin[row] = {piece.mesh, v};
        }
        for (int f = piece.firstFace; f < piece.firstFace + piece.faceCount; ++f) {
            points.reversed[static_cast<std::size_t>(f)] = piece.mirrored;
            const auto object = static_cast<std::size_t>(mesh.faceObject[f]);
            points.nodeOfObject.resize(std::max(points.nodeOfObject.size(), object + 1));
            points.nodeOfObject[object] = piece.node;
        }
        for (int c = mesh.faceStart[piece.firstFace];
             from.HasNormals() && c < mesh.faceStart[piece.firstFace + piece.faceCount]; ++c) {
            const aiVector3D &n = from.mNormals[mesh.cornerVertex[c] - piece.firstVertex];
            points.normals.row(c) << n.x, n.y, n.z;
        }
    }
    if (!(points.normals.rowwise().squaredNorm().minCoeff() > 0))
        points.normals.resize(0, 3);
    return points;
}

std::int64_t addFbxModel(FbxNewObjects &objects, const QString &name, const QByteArray &kind,
                         const Eigen::Affine3d &transform)
{
    const Parts parts = partsOf(transform);
    std::vector<FbxNewNode> properties{fbxProperty("InheritType", "enum", "", {std::int32_t(1)})};
    if (!transform.matrix().isIdentity(0)) {
        properties.push_back(fbxVector("Lcl Translation", "Lcl Translation", parts.translation));
        properties.push_back(fbxVector("Lcl Rotation", "Lcl Rotation", anglesOf(parts.rotation)));
        properties.push_back(fbxVector("Lcl Scaling", "Lcl Scaling", parts.scaling));
    }
    return objects.add("Model", name, kind,
                       {fbxLeaf("Version", std::int32_t(232)), fbxProperties(std::move(properties)),
                        fbxLeaf("Culling", QByteArray("CullingOff"))});
}

//! Writes the attribute of a camera, a light, a bone or a node without anything.
void FbxRig::addView(const aiNode &node, std::int64_t model)
{
    const aiScene &scene = *mSource.scene;
    const QString name = QString::fromUtf8(node.mName.C_Str());
    if (const aiCamera *camera = objectOf(scene.mCameras, scene.mNumCameras, node.mName)) {
        const std::int64_t id = mObjects.add(
            "NodeAttribute", name, "Camera",
            {fbxLeaf("TypeFlags", QByteArray("Camera")), fbxProperties(cameraProperties(*camera))});
        mObjects.connect(id, model);
    } else if (const aiLight *light = objectOf(scene.mLights, scene.mNumLights, node.mName)) {
        const std::int64_t id = mObjects.add("NodeAttribute", name, "Light",
                                             {fbxLeaf("TypeFlags", QByteArray("Light")),
                                              fbxLeaf("GeometryVersion", std::int32_t(124)),
                                              fbxProperties(lightProperties(*light, mFromGltf))});
        mObjects.connect(id, model);
    }
}

FbxRig::FbxRig(FbxNewObjects &objects, const AssimpSource &source, bool fromGltf)
    : mObjects(objects), mSource(source), mFromGltf(fromGltf), mBones(boneNames(*source.scene))
{
    mBones.merge(bareBones(*source.scene, source.limbs));
}

void FbxRig::addNode(const aiNode &node, const Above &above, const std::map<int, QString> &names)
{
    const aiScene &scene = *mSource.scene;
    const auto number = static_cast<int>(mModels.size());
    mNumberOf.try_emplace(node.mName.C_Str(), mModels.size());
    Eigen::Affine3d local = Eigen::Affine3d(toEigen(node.mTransformation));
    mWorld.push_back(above.world * local);
    const bool isRoot = &node == scene.mRootNode;
    const bool isCamera = objectOf(scene.mCameras, scene.mNumCameras, node.mName);
    const bool isLight = objectOf(scene.mLights, scene.mNumLights, node.mName);
    const auto object = names.find(number);
    // Programs find no armature above bones where there is a mesh: it gets a model below that of its node.
    const bool isApart = object != names.end() && isAboveBone(node, mBones);
    const bool isMesh = object != names.end() && !isApart;
    const QByteArray kind = isMesh ? "Mesh" : isCamera ? "Camera" : isLight ? "Light" : "Null";
    // Programs take what is above the first bone for the armature, and all below it for bones.
    const bool isBone = kind == "Null" && (above.armature || mBones.contains(node.mName.C_Str()));
    const std::optional<Eigen::Affine3d> armature = above.armature ? above.armature
                                                    : isBone       ? std::optional(above.world)
                                                                   : std::nullopt;
    mArmature.push_back(armature.value_or(Eigen::Affine3d::Identity()));
    // Where a bound mesh is now says nothing, and programs take that for where it was bound.
    const aiMesh *first = node.mNumMeshes > 0 ? scene.mMeshes[node.mMeshes[0]] : nullptr;
    const std::optional<Eigen::Affine3d> bound =
        first && (isApart || node.mNumChildren == 0) ? bindPlace(scene, *first, mWorld.back()) : std::nullopt;
    mMeshWorld.push_back(bound.value_or(mWorld.back()));
    if (isMesh && bound)
        local = above.world.inverse() * mMeshWorld.back();
    std::int64_t id = above.model;
    // A root without anything is the scene itself.
    if (!isRoot || object != names.end() || !local.matrix().isIdentity(0)) {
        const QByteArray written = isBone ? QByteArray("LimbNode") : kind;
        if (isCamera || isLight) {
            mTurns[node.mName.C_Str()] = turnOf(isCamera);
            local.linear() = local.linear() * turnOf(isCamera);
        }
        const QString name = QString::fromUtf8(node.mName.C_Str());
        id = addFbxModel(mObjects,
                         freeName(isMesh    ? object->second
                                  : isApart ? name + QStringLiteral("_node")
                                            : name),
                         written, local);
        mObjects.connect(id, above.model);
        if (written == "LimbNode") {
            const std::int64_t bone =
                mObjects.add("NodeAttribute", QString::fromUtf8(node.mName.C_Str()), "LimbNode",
                             {fbxLeaf("TypeFlags", QByteArray("Skeleton"))});
            mObjects.connect(bone, id);
        }
        addView(node, id);
    }
    mModels.push_back(id);
    mMeshModels.push_back(id);
    if (isApart) {
        mMeshModels.back() =
            addFbxModel(mObjects, freeName(object->second), "Mesh",
                        mWorld[mMeshModels.size() - 1].inverse() * mMeshWorld[mMeshModels.size() - 1]);
        mObjects.connect(mMeshModels.back(), id);
    }
    const Above below{id, mWorld.back(), armature};
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        addNode(*node.mChildren[c], below, names);
}

void FbxRig::addNodes(const std::map<int, QString> &names)
{
    addNode(*mSource.scene->mRootNode, {}, names);
}

void FbxRig::addSkin(std::int64_t geometry, int node, const std::vector<FbxSkinPoint> &points)
{
    const aiScene &scene = *mSource.scene;
    struct Cluster
    {
        Eigen::Affine3d offset;
        std::vector<int> points;
        std::vector<double> weights;
    };
    std::map<std::size_t, Cluster> clusters; // by the number of the bone's node
    std::map<unsigned, std::vector<std::vector<std::pair<std::size_t, double>>>>
        weights; // by mesh and vertex
    for (const FbxSkinPoint &point : points)
        weights[point.mesh].resize(scene.mMeshes[point.mesh]->mNumVertices);
    for (auto &[number, ofVertex] : weights) {
        const aiMesh &mesh = *scene.mMeshes[number];
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const auto bone = mNumberOf.find(mesh.mBones[b]->mName.C_Str());
            if (bone == mNumberOf.end())
                continue;
            clusters[bone->second].offset = Eigen::Affine3d(toEigen(mesh.mBones[b]->mOffsetMatrix));
            for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w) {
                const aiVertexWeight &weight = mesh.mBones[b]->mWeights[w];
                if (weight.mVertexId < ofVertex.size() && weight.mWeight > 0)
                    ofVertex[weight.mVertexId].emplace_back(bone->second,
                                                            static_cast<double>(weight.mWeight));
            }
        }
    }
    if (clusters.empty())
        return;
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (const auto &[bone, weight] : weights[points[p].mesh][points[p].vertex]) {
            clusters[bone].points.push_back(static_cast<int>(p));
            clusters[bone].weights.push_back(weight);
        }
    }
    const auto matrixNode = [](const char *name, const Eigen::Affine3d &matrix) {
        const Eigen::Matrix4d values = matrix.matrix();
        return fbxLeaf(name, std::vector<double>(values.data(), values.data() + 16));
    };
    const std::int64_t skin = mObjects.add(
        "Deformer", {}, "Skin", {fbxLeaf("Version", std::int32_t(101)), fbxLeaf("Link_DeformAcuracy", 50.0)});
    mObjects.connect(skin, geometry);
    for (auto &[bone, cluster] : clusters) {
        const Eigen::Affine3d bind = mMeshWorld[static_cast<std::size_t>(node)] * cluster.offset.inverse();
        const std::int64_t id = mObjects.add(
            "Deformer", {}, "Cluster",
            {fbxLeaf("Version", std::int32_t(100)), fbxLeaf("Indexes", std::move(cluster.points)),
             fbxLeaf("Weights", std::move(cluster.weights)), matrixNode("Transform", cluster.offset),
             matrixNode("TransformLink", bind), matrixNode("TransformAssociateModel", mArmature[bone])});
        mObjects.connect(id, skin);
        mObjects.connect(mModels[bone], id);
    }
}

void FbxRig::addCurves(const aiNode &node, std::int64_t layer, const char *property, const char *label,
                       const std::vector<std::int64_t> &times, const std::vector<Vec3> &values)
{
    if (times.empty())
        return;
    const char *components[] = {"d|X", "d|Y", "d|Z"};
    std::vector<FbxNewNode> properties;
    for (int k = 0; k < 3; ++k)
        properties.push_back(fbxProperty(components[k], "Number", "", {values.front()[k]}));
    const std::int64_t curveNode = mObjects.add("AnimationCurveNode", QString::fromLatin1(label), {},
                                                {fbxProperties(std::move(properties))});
    mObjects.connect(curveNode, layer);
    mObjects.connect(curveNode, mModels[mNumberOf.at(node.mName.C_Str())], property);
    for (int k = 0; k < 3; ++k) {
        std::vector<float> numbers;
        for (const Vec3 &value : values)
            numbers.push_back(static_cast<float>(value[k]));
        constexpr int linear = 4;
        const std::int64_t curve = mObjects.add(
            "AnimationCurve", {}, {},
            {fbxLeaf("Default", static_cast<double>(numbers.front())), fbxLeaf("KeyVer", std::int32_t(4008)),
             fbxLeaf("KeyTime", times), fbxLeaf("KeyValueFloat", std::move(numbers)),
             fbxLeaf("KeyAttrFlags", std::vector<int>{linear}),
             fbxLeaf("KeyAttrDataFloat", std::vector<float>{0, 0, 0, 0}),
             fbxLeaf("KeyAttrRefCount", std::vector<int>{static_cast<int>(times.size())})});
        mObjects.connect(curve, curveNode, components[k]);
    }
}

void FbxRig::addAnimations()
{
    const aiScene &scene = *mSource.scene;
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        const aiAnimation &animation = *scene.mAnimations[a];
        const double perSecond = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25;
        const auto toFbx = [&](double time) { return std::llround(time / perSecond * ticksPerSecond); };
        const QString name = animation.mName.length > 0 ? QString::fromUtf8(animation.mName.C_Str())
                                                        : QStringLiteral("Take %1").arg(a + 1);
        const std::int64_t stop = toFbx(animation.mDuration);
        const std::int64_t stack =
            mObjects.add("AnimationStack", name, {},
                         {fbxProperties({fbxProperty("LocalStop", "KTime", "Time", {stop}),
                                         fbxProperty("ReferenceStop", "KTime", "Time", {stop})})});
        const std::int64_t layer = mObjects.add("AnimationLayer", QStringLiteral("BaseLayer"), {}, {});
        mObjects.connect(layer, stack);
        for (unsigned c = 0; c < animation.mNumChannels; ++c) {
            const aiNodeAnim &channel = *animation.mChannels[c];
            const aiNode *node = scene.mRootNode->FindNode(channel.mNodeName);
            if (!node || !mNumberOf.contains(channel.mNodeName.C_Str()) ||
                mModels[mNumberOf.at(channel.mNodeName.C_Str())] == 0)
                continue;
            std::vector<std::int64_t> times;
            std::vector<Vec3> values;
            const auto collect = [&](const auto *keys, unsigned count, const auto &valueOf) {
                times.clear();
                values.clear();
                for (unsigned k = 0; k < count; ++k) {
                    times.push_back(toFbx(keys[k].mTime));
                    values.push_back(valueOf(keys[k].mValue));
                }
            };
            const auto vector = [](const aiVector3D &v) { return Vec3(v.x, v.y, v.z); };
            const auto turn = mTurns.find(channel.mNodeName.C_Str());
            collect(channel.mPositionKeys, channel.mNumPositionKeys, vector);
            addCurves(*node, layer, "Lcl Translation", "T", times, values);
            collect(channel.mRotationKeys, channel.mNumRotationKeys, [&](const aiQuaternion &q) {
                Eigen::Matrix3d rotation =
                    Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
                if (turn != mTurns.end())
                    rotation = rotation * turn->second;
                return anglesOf(rotation, values.empty() ? Vec3(Vec3::Zero()) : values.back());
            });
            addCurves(*node, layer, "Lcl Rotation", "R", times, values);
            collect(channel.mScalingKeys, channel.mNumScalingKeys, vector);
            addCurves(*node, layer, "Lcl Scaling", "S", times, values);
        }
    }
}

} // namespace autocuts
