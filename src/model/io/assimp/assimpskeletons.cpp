#include "model/io/assimp/assimpskeletons.h"

#include "model/io/assimp/assimpbinding.h"
#include "model/io/assimp/assimpmatrix.h"
#include "model/io/files/xmlspans.h"
#include "model/io/formats/modelunits.h"

#include <Eigen/Geometry>

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace autocuts {

namespace {

//! Keys that differ less from the place of their node do not move it. Chosen by hand.
constexpr float noMotion = 1e-5F;

bool isMoved(const aiNodeAnim &channel, const aiNode &node)
{
    aiVector3D scaling, place;
    aiQuaternion turn;
    node.mTransformation.Decompose(scaling, turn, place);
    const auto differs = [](const aiVector3D &value) {
        return [value](const aiVectorKey &key) {
            return (key.mValue - value).Length() > noMotion * std::max(1.0F, value.Length());
        };
    };
    const auto turns = [&turn](const aiQuatKey &key) {
        const aiQuaternion &q = key.mValue;
        return std::abs(q.w * turn.w + q.x * turn.x + q.y * turn.y + q.z * turn.z) < 1 - noMotion;
    };
    const aiVectorKey *places = channel.mPositionKeys, *scales = channel.mScalingKeys;
    return std::any_of(places, places + channel.mNumPositionKeys, differs(place)) ||
           std::any_of(channel.mRotationKeys, channel.mRotationKeys + channel.mNumRotationKeys, turns) ||
           std::any_of(scales, scales + channel.mNumScalingKeys, differs(scaling));
}

//! Goes down from the root of a scene to its skeletons.
class Layout
{
public:
    Layout(aiScene &scene, const aiScene &animated, const std::set<std::string> &bare)
        : mScene(scene), mBones(boneNames(scene))
    {
        mBones.insert(bare.begin(), bare.end());
        for (unsigned c = 0; animated.mNumAnimations > 0 && c < animated.mAnimations[0]->mNumChannels; ++c) {
            const aiNodeAnim *channel = animated.mAnimations[0]->mChannels[c];
            mChannels.emplace(channel->mNodeName.C_Str(), channel);
        }
    }

    NodeChanges make()
    {
        if (mBones.empty() && mChannels.empty())
            return {};
        addRoot();
        turnUp(*mScene.mRootNode);
        const std::vector<aiNode *> tops(mScene.mRootNode->mChildren,
                                         mScene.mRootNode->mChildren + mScene.mRootNode->mNumChildren);
        for (aiNode *top : tops)
            clear(*top);
        for (aiNode *top : tops)
            liftSkins(*top);
        return std::move(mChanges);
    }

private:
    //! Gives a transform to what is below a node.
    void pass(aiNode &node, const aiMatrix4x4 &transform)
    {
        for (unsigned c = 0; c < node.mNumChildren; ++c) {
            aiNode &child = *node.mChildren[c];
            child.mTransformation = transform * child.mTransformation;
            auto [before, isNew] =
                mChanges.before.try_emplace(child.mName.C_Str(), Eigen::Matrix4d::Identity());
            before->second = toEigen(transform) * before->second;
        }
    }

    //! Puts a root above one that does something.
    void addRoot()
    {
        aiNode *top = mScene.mRootNode;
        if (top->mNumMeshes == 0 && !mBones.contains(top->mName.C_Str()) && isStill(*top))
            return;
        std::string name = "Scene";
        while (top->FindNode(name.c_str()))
            name += '_';
        mScene.mRootNode = new aiNode(name);
        mScene.mRootNode->addChildren(1, &top);
    }

    bool isSkin(const aiNode &node) const
    {
        return node.mNumMeshes > 0 && node.mNumChildren == 0 &&
               std::all_of(node.mMeshes, node.mMeshes + node.mNumMeshes,
                           [this](unsigned mesh) { return mScene.mMeshes[mesh]->mNumBones > 0; });
    }

    //! Puts the meshes that bones place below the root: only there the nodes above do nothing to them.
    void liftSkins(aiNode &node)
    {
        aiNode **const end = node.mChildren + node.mNumChildren;
        aiNode **const first = std::stable_partition(node.mChildren, end,
                                                     [this](const aiNode *child) { return !isSkin(*child); });
        const Eigen::Affine3d root = worldOf(*mScene.mRootNode);
        std::for_each(first, end, [&root](aiNode *skin) {
            skin->mTransformation = toAssimp((root.inverse() * worldOf(*skin)).matrix());
        });
        if (first != end)
            mScene.mRootNode->addChildren(static_cast<unsigned>(end - first), first);
        node.mNumChildren -= static_cast<unsigned>(end - first);
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            liftSkins(*node.mChildren[c]);
    }

    //! The root turns back what is below. Assimp writes that as the axis of the file, if it is all that the
    //! root does besides scaling.
    void turnUp(aiNode &root)
    {
        const Eigen::Matrix4d own = toEigen(root.mTransformation);
        Eigen::Matrix4d scaled = Eigen::Matrix4d::Identity();
        scaled.topLeftCorner<3, 3>() *= own(0, 0);
        if (root.mNumMeshes > 0 || !(own(0, 0) > 0) || !own.isApprox(scaled, 1e-9))
            return;
        const Eigen::Matrix4d turn = unitChange({}, {1, true});
        pass(root, toAssimp(turn));
        root.mTransformation = root.mTransformation * toAssimp(turn.transpose());
    }

    bool isStill(const aiNode &node) const
    {
        const auto channel = mChannels.find(node.mName.C_Str());
        return channel == mChannels.end() || !isMoved(*channel->second, node);
    }

    //! Gives the meshes of a node one of its own below it, which has the name, as it is that of the object.
    void moveMeshes(aiNode &node)
    {
        if (node.mNumMeshes == 0)
            return;
        auto *holder = new aiNode(node.mName.C_Str());
        std::swap(holder->mMeshes, node.mMeshes);
        std::swap(holder->mNumMeshes, node.mNumMeshes);
        const bool isUsed = mChannels.contains(node.mName.C_Str()) || isView(mScene, node);
        aiString &renamed = isUsed ? holder->mName : node.mName;
        std::string name = std::string(node.mName.C_Str()) + (isUsed ? "_mesh" : "_node");
        while (mScene.mRootNode->FindNode(name.c_str()))
            name += '_';
        renamed = name;
        node.addChildren(1, &holder);
        mChanges.added.push_back(holder);
    }

    //! Lets nodes above skeletons have no transforms.
    void clear(aiNode &node)
    {
        if (mBones.contains(node.mName.C_Str()) || !isAboveBone(node, mBones))
            return;
        // pass() has put a transform in front; animations are compared with the node's own.
        const aiMatrix4x4 transform = node.mTransformation;
        if (auto changed = mChanges.before.find(node.mName.C_Str()); changed != mChanges.before.end())
            node.mTransformation = toAssimp(changed->second.inverse()) * transform;
        const bool still = isStill(node);
        node.mTransformation = transform;
        moveMeshes(node);
        if (!still) {
            for (unsigned m = 0; m < mScene.mNumMeshes; ++m)
                addBonesAbove(mScene, node, *mScene.mMeshes[m]);
            return;
        }
        pass(node, transform);
        node.mTransformation = {};
        mChanges.still.insert(node.mName.C_Str());
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            clear(*node.mChildren[c]);
    }

    aiScene &mScene;
    std::set<std::string> mBones;
    std::map<std::string, const aiNodeAnim *> mChannels;
    NodeChanges mChanges;
};

} // namespace

NodeChanges layOutSkeletons(aiScene &scene, const aiScene &animated, const std::set<std::string> &bare)
{
    return Layout(scene, animated, bare).make();
}

std::string withBareBones(std::string_view text, const std::set<std::string> &bare)
{
    const std::optional<XmlElement> root = bare.empty() ? std::nullopt : xmlSpans(text);
    const XmlElement *scenes = root ? root->child("library_visual_scenes") : nullptr;
    if (!scenes)
        return std::string(text);
    std::vector<TextEdit> edits;
    std::vector<const XmlElement *> open{scenes};
    while (!open.empty()) {
        const XmlElement &element = *open.back();
        open.pop_back();
        for (const XmlElement &child : element.children)
            open.push_back(&child);
        const std::string_view type = element.attribute("type");
        if (element.name != "node" || type != "NODE" || !bare.contains(resolved(element.attribute("name"))))
            continue;
        edits.push_back({type.data(), type.data() + type.size(),
                         "JOINT\" sid=\"" + std::string(element.attribute("id"))});
    }
    return edited(text, std::move(edits));
}

} // namespace autocuts
