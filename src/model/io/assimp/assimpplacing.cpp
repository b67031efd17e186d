#include "model/io/assimp/assimpplacing.h"

#include "model/io/assimp/assimpbinding.h"
#include "model/io/assimp/assimpmatrix.h"

#include <Eigen/Geometry>

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace autocuts {

namespace {

template <typename Change>
void changeChannels(aiScene &scene, const aiNode &node, const Change &change)
{
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c) {
            if (aiNodeAnim &channel = *scene.mAnimations[a]->mChannels[c]; channel.mNodeName == node.mName)
                change(channel);
        }
    }
}

bool isAnimated(aiScene &scene, const aiNode &node)
{
    bool found = false;
    changeChannels(scene, node, [&found](const aiNodeAnim &) { found = true; });
    return found;
}

//! \param placement without shear; mirrored only where nothing is animated
void placeNode(aiScene &scene, aiNode &node, const aiMatrix4x4 &placement)
{
    node.mTransformation = placement * node.mTransformation;
    aiVector3D scaling, position;
    aiQuaternion rotation;
    placement.Decompose(scaling, rotation, position);
    changeChannels(scene, node, [&](aiNodeAnim &channel) {
        for (unsigned k = 0; k < channel.mNumPositionKeys; ++k)
            channel.mPositionKeys[k].mValue = placement * channel.mPositionKeys[k].mValue;
        for (unsigned k = 0; k < channel.mNumRotationKeys; ++k)
            channel.mRotationKeys[k].mValue = rotation * channel.mRotationKeys[k].mValue;
        for (unsigned k = 0; k < channel.mNumScalingKeys; ++k)
            channel.mScalingKeys[k].mValue *= scaling.x;
    });
}

//! The turn to a view along a direction; the upward direction is made up where it says nothing.
Eigen::Matrix3d viewAlong(const aiVector3D &direction, const aiVector3D &upwards)
{
    const Eigen::Vector3d back = -Eigen::Vector3d(direction.x, direction.y, direction.z).normalized();
    Eigen::Vector3d up(upwards.x, upwards.y, upwards.z);
    if (!(back.cross(up).norm() > 1e-3 * up.norm()))
        up = std::abs(back.y()) < 0.9 ? Eigen::Vector3d::UnitY()
                                      : Eigen::Vector3d(0, 0, -std::copysign(1, back.y()));
    Eigen::Matrix3d turn;
    turn.col(0) = up.cross(back).normalized();
    turn.col(1) = back.cross(turn.col(0));
    turn.col(2) = back;
    return turn;
}

//! Gives the node of a camera or light its place and direction; a node with children gets one more.
void turnNode(aiScene &scene, aiString &name, aiVector3D &position, const Eigen::Matrix3d &turn)
{
    aiNode *node = scene.mRootNode->FindNode(name);
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.topLeftCorner<3, 3>() = turn;
    view.topRightCorner<3, 1>() << position.x, position.y, position.z;
    if (!node || !view.allFinite() || view.isIdentity(1e-6))
        return;
    if (node->mNumChildren > 0 || node->mNumMeshes > 0 || node == scene.mRootNode) {
        auto *child = new aiNode(std::string(name.C_Str()) + "_view");
        node->addChildren(1, &child);
        name = child->mName;
        node = child;
    }
    node->mTransformation = node->mTransformation * toAssimp(view);
    const Eigen::Quaterniond rotation(turn);
    const aiQuaternion extra(static_cast<ai_real>(rotation.w()), static_cast<ai_real>(rotation.x()),
                             static_cast<ai_real>(rotation.y()), static_cast<ai_real>(rotation.z()));
    changeChannels(scene, *node, [&extra](aiNodeAnim &channel) {
        for (unsigned k = 0; k < channel.mNumRotationKeys; ++k)
            channel.mRotationKeys[k].mValue = channel.mRotationKeys[k].mValue * extra;
    });
    position = {};
}

//! Puts the bones among the children of a root below a new node, which takes their place: programs show a
//! skeleton in the size that its bones have without the scale of their own.
void gatherBones(const aiScene &scene, aiNode &root)
{
    const std::set<std::string> bones = boneNames(scene);
    aiNode **const end = root.mChildren + root.mNumChildren;
    aiNode **const first = std::stable_partition(
        root.mChildren, end, [&bones](const aiNode *child) { return !bones.contains(child->mName.C_Str()); });
    if (first == end)
        return;
    std::string name = "Armature";
    for (int number = 2; scene.mRootNode->FindNode(name.c_str()); ++number)
        name = "Armature_" + std::to_string(number);
    auto *armature = new aiNode(name);
    armature->addChildren(static_cast<unsigned>(end - first), first);
    armature->mParent = &root;
    *first = armature;
    root.mNumChildren = static_cast<unsigned>(first - root.mChildren) + 1;
}

} // namespace

void placeScene(aiScene &scene, const Eigen::Matrix4d &placement)
{
    const aiMatrix4x4 matrix = toAssimp(placement);
    aiNode &root = *scene.mRootNode;
    // A root without anything of its own stays so, and programs show true sizes at the objects.
    const bool plain = root.mTransformation.IsIdentity() && root.mNumMeshes == 0 &&
                       !isAnimated(scene, root) && placement.topLeftCorner<3, 3>().determinant() > 0;
    if (!plain)
        placeNode(scene, root, matrix);
    const double scale = std::cbrt(std::abs(placement.topLeftCorner<3, 3>().determinant()));
    if (plain && std::abs(scale - 1) > 1e-6)
        gatherBones(scene, root);
    for (unsigned c = 0; plain && c < root.mNumChildren; ++c)
        placeNode(scene, *root.mChildren[c], matrix);
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        aiCamera &camera = *scene.mCameras[c];
        for (float *length : {&camera.mClipPlaneNear, &camera.mClipPlaneFar, &camera.mOrthographicWidth})
            *length *= static_cast<float>(scale);
    }
}

void turnViews(aiScene &scene)
{
    const aiVector3D forward(0, 0, -1), up(0, 1, 0);
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        aiCamera &camera = *scene.mCameras[c];
        turnNode(scene, camera.mName, camera.mPosition, viewAlong(camera.mLookAt, camera.mUp));
        camera.mLookAt = forward;
        camera.mUp = up;
    }
    for (unsigned l = 0; l < scene.mNumLights; ++l) {
        aiLight &light = *scene.mLights[l];
        const bool directed = light.mType != aiLightSource_POINT && light.mType != aiLightSource_AMBIENT &&
                              light.mDirection.SquareLength() > 0;
        turnNode(scene, light.mName, light.mPosition,
                 directed ? viewAlong(light.mDirection, light.mUp) : Eigen::Matrix3d::Identity());
        light.mDirection = forward;
        light.mUp = up;
    }
}

} // namespace autocuts
