#include "model/io/assimp/assimpbinding.h"

#include "model/io/assimp/assimpmatrix.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <string>

namespace autocuts {

namespace {

//! Places of a mesh that differ less, as shares of their largest number, are the same. Chosen by hand.
constexpr double samePlace = 1e-3;

//! The node of the bone that is nearest to the root; null without bones.
aiNode *topBone(const aiScene &scene, const aiMesh &mesh)
{
    aiNode *top = nullptr;
    int depth = std::numeric_limits<int>::max();
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        aiNode *node = scene.mRootNode->FindNode(mesh.mBones[b]->mName);
        int own = 0;
        for (const aiNode *above = node; above; above = above->mParent)
            ++own;
        if (node && own < depth) {
            depth = own;
            top = node;
        }
    }
    return top;
}

//! Where the mesh was bound, if a bone is still where it was then. The first one is that of the topmost bone.
std::vector<Eigen::Affine3d> placesByBones(const aiScene &scene, const aiMesh &mesh)
{
    std::vector<Eigen::Affine3d> places;
    const aiNode *top = topBone(scene, mesh);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiNode *node = scene.mRootNode->FindNode(mesh.mBones[b]->mName);
        if (!node)
            continue;
        const Eigen::Affine3d place =
            worldOf(*node) * Eigen::Affine3d(toEigen(mesh.mBones[b]->mOffsetMatrix));
        if (!place.matrix().allFinite() || !(std::abs(place.linear().determinant()) > 1e-30))
            continue;
        places.push_back(place);
        if (node == top)
            std::swap(places.front(), places.back());
    }
    return places;
}

//! The vertices that no bone moves.
std::vector<unsigned> withoutWeights(const aiMesh &mesh)
{
    std::vector<bool> has(mesh.mNumVertices, false);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const std::span weights(mesh.mBones[b]->mWeights, mesh.mBones[b]->mNumWeights);
        for (const aiVertexWeight &weight : weights)
            has[weight.mVertexId] = has[weight.mVertexId] || weight.mWeight > 0;
    }
    std::vector<unsigned> bare;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        if (!has[v])
            bare.push_back(v);
    }
    return bare;
}

void addChild(aiNode &node, aiNode *child)
{
    auto **children = new aiNode *[node.mNumChildren + 1];
    std::copy_n(node.mChildren, node.mNumChildren, children);
    children[node.mNumChildren++] = child;
    delete[] node.mChildren;
    node.mChildren = children;
    child->mParent = &node;
}

void addBone(aiMesh &mesh, aiBone *bone)
{
    auto **bones = new aiBone *[mesh.mNumBones + 1];
    std::copy_n(mesh.mBones, mesh.mNumBones, bones);
    bones[mesh.mNumBones++] = bone;
    delete[] mesh.mBones;
    mesh.mBones = bones;
}

//! A bone that moves these vertices alone.
aiBone *boneOf(const aiString &name, const std::vector<unsigned> &vertices)
{
    auto *bone = new aiBone;
    bone->mName = name;
    bone->mNumWeights = static_cast<unsigned>(vertices.size());
    bone->mWeights = new aiVertexWeight[vertices.size()];
    for (std::size_t i = 0; i < vertices.size(); ++i)
        bone->mWeights[i] = aiVertexWeight(vertices[i], 1);
    return bone;
}

bool hasChannel(const aiScene &scene, const aiString &node)
{
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        const std::span channels(scene.mAnimations[a]->mChannels, scene.mAnimations[a]->mNumChannels);
        if (std::ranges::any_of(channels, [&node](const aiNodeAnim *c) { return c->mNodeName == node; }))
            return true;
    }
    return false;
}

//! Adds a bone without weights.
void addBareBone(aiMesh &mesh, const aiNode &node, const aiMatrix4x4 &offset)
{
    auto *bone = new aiBone;
    bone->mName = node.mName;
    bone->mOffsetMatrix = offset;
    addBone(mesh, bone);
}

//! The matrices of the bones of a mesh by name: from the mesh to the bone.
using Offsets = std::map<std::string, aiMatrix4x4>;

//! Adds a bone for each node below one that is none and holds nothing. \param offset of the node
void addBonesOf(const aiScene &scene, const aiNode &node, const aiMatrix4x4 &offset, aiMesh &mesh,
                Offsets &bones)
{
    for (unsigned c = 0; c < node.mNumChildren; ++c) {
        const aiNode &child = *node.mChildren[c];
        if (const auto found = bones.find(child.mName.C_Str()); found != bones.end()) {
            addBonesOf(scene, child, aiMatrix4x4(found->second), mesh, bones);
            continue;
        }
        aiMatrix4x4 local = child.mTransformation;
        if (child.mNumMeshes > 0 || isView(scene, child) || !(std::abs(local.Determinant()) > 1e-30F) ||
            scene.mRootNode->FindNode(child.mName) != &child)
            continue;
        const aiMatrix4x4 own = local.Inverse() * offset;
        addBareBone(mesh, child, own);
        bones.emplace(child.mName.C_Str(), own);
        addBonesOf(scene, child, own, mesh, bones);
    }
}

bool isBelow(const aiNode *node, const aiNode &top)
{
    while (node && node != &top)
        node = node->mParent;
    return node;
}

} // namespace

std::set<std::string> boneNames(const aiScene &scene)
{
    std::set<std::string> names;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
            names.insert(scene.mMeshes[m]->mBones[b]->mName.C_Str());
    }
    return names;
}

std::set<std::string> bareBones(const aiScene &scene, const std::set<std::string> &limbs)
{
    const std::set<std::string> bones = boneNames(scene);
    std::set<std::string> bare;
    for (const std::string &limb : limbs) {
        const aiNode *node = scene.mRootNode->FindNode(limb.c_str());
        bool isBare = node && node->mNumMeshes == 0 && !isView(scene, *node) && !isAboveBone(*node, bones);
        for (const aiNode *above = node; above && isBare; above = above->mParent)
            isBare = !bones.contains(above->mName.C_Str());
        if (isBare)
            bare.insert(limb);
    }
    return bare;
}

bool isView(const aiScene &scene, const aiNode &node)
{
    const auto is = [&node](const auto *view) { return view->mName == node.mName; };
    return std::any_of(scene.mCameras, scene.mCameras + scene.mNumCameras, is) ||
           std::any_of(scene.mLights, scene.mLights + scene.mNumLights, is);
}

bool isAboveBone(const aiNode &node, const std::set<std::string> &bones)
{
    return std::any_of(node.mChildren, node.mChildren + node.mNumChildren, [&bones](const aiNode *child) {
        return bones.contains(child->mName.C_Str()) || isAboveBone(*child, bones);
    });
}

Eigen::Affine3d worldOf(const aiNode &node)
{
    Eigen::Affine3d world(toEigen(node.mTransformation));
    for (const aiNode *above = node.mParent; above; above = above->mParent)
        world = Eigen::Affine3d(toEigen(above->mTransformation)) * world;
    return world;
}

std::optional<Eigen::Affine3d> bindPlace(const aiScene &scene, const aiMesh &mesh, const Eigen::Affine3d &own)
{
    const std::vector<Eigen::Affine3d> places = placesByBones(scene, mesh);
    if (places.empty())
        return std::nullopt;
    const auto agreeing = [&places](const Eigen::Affine3d &place) {
        const double far = samePlace * place.matrix().cwiseAbs().maxCoeff();
        return std::ranges::count_if(places, [&](const Eigen::Affine3d &other) {
            return (place.matrix() - other.matrix()).cwiseAbs().maxCoeff() <= far;
        });
    };
    Eigen::Affine3d best = own;
    auto most = agreeing(own);
    for (const Eigen::Affine3d &place : places) {
        if (2 * most >= std::ssize(places))
            break;
        if (const auto count = agreeing(place); count > most) {
            best = place;
            most = count;
        }
    }
    return best;
}

void bindAtParent(const aiScene &scene, aiNode &node, const std::vector<aiMesh *> &meshes,
                  const Eigen::Matrix4d *known)
{
    std::optional<Eigen::Affine3d> place =
        meshes.empty() ? std::nullopt : bindPlace(scene, *meshes.front(), worldOf(node));
    if (place && known)
        place = Eigen::Affine3d(*known);
    const auto isSkinned = [](const aiMesh *mesh) { return mesh->mNumBones > 0; };
    if (!place || node.mNumChildren > 0 || !std::ranges::all_of(meshes, isSkinned))
        return;
    // Programs leave out the place of the node itself, but not those of the nodes above.
    if (node.mParent)
        place = worldOf(*node.mParent).inverse() * *place;
    const aiMatrix4x4 there = toAssimp(place->matrix()), back = toAssimp(place->inverse().matrix());
    const aiMatrix3x3 turn(
        toAssimp(Eigen::Affine3d(Eigen::Matrix3d(place->linear().inverse().transpose())).matrix()));
    for (aiMesh *mesh : meshes) {
        for (unsigned v = 0; v < mesh->mNumVertices; ++v) {
            mesh->mVertices[v] = there * mesh->mVertices[v];
            if (mesh->mNormals)
                mesh->mNormals[v] = (turn * mesh->mNormals[v]).NormalizeSafe();
        }
        for (unsigned b = 0; b < mesh->mNumBones; ++b)
            mesh->mBones[b]->mOffsetMatrix = mesh->mBones[b]->mOffsetMatrix * back;
    }
    node.mTransformation = node.mTransformation * back;
}

void weighAll(const aiScene &scene, const aiNode &node, const std::vector<aiMesh *> &meshes)
{
    aiNode *rest = nullptr;
    for (aiMesh *mesh : meshes) {
        const std::vector<unsigned> bare = withoutWeights(*mesh);
        const aiNode *top = mesh->mNumBones > 0 ? topBone(scene, *mesh) : nullptr;
        if (bare.empty() || !top || !top->mParent)
            continue;
        if (!rest) {
            rest = new aiNode(std::string(node.mName.C_Str()) + ".rest");
            rest->mTransformation =
                toAssimp(Eigen::Matrix4d((worldOf(*top->mParent).inverse() * worldOf(node)).matrix()));
            addChild(*top->mParent, rest);
        }
        addBone(*mesh, boneOf(rest->mName, bare));
    }
}

void bindToBone(const aiScene &animated, const aiNode &node, const std::vector<aiMesh *> &meshes,
                const std::set<std::string> &bones)
{
    const bool isFree = std::ranges::all_of(meshes, [](const aiMesh *mesh) { return mesh->mNumBones == 0; });
    if (!isFree || node.mNumChildren > 0 || bones.contains(node.mName.C_Str()))
        return;
    aiMatrix4x4 place;
    const aiNode *above = &node;
    for (; above && !bones.contains(above->mName.C_Str()); above = above->mParent) {
        if (hasChannel(animated, above->mName))
            return;
        place = above->mTransformation * place;
    }
    for (aiMesh *mesh : meshes) {
        if (!above)
            return;
        std::vector<unsigned> all(mesh->mNumVertices);
        std::iota(all.begin(), all.end(), 0U);
        aiBone *bone = boneOf(above->mName, all);
        bone->mOffsetMatrix = place;
        addBone(*mesh, bone);
        aiMatrix4x4 offset = place;
        for (const aiNode *limb = above; limb->mParent && bones.contains(limb->mParent->mName.C_Str());
             limb = limb->mParent) {
            offset = limb->mTransformation * offset;
            addBareBone(*mesh, *limb->mParent, offset);
        }
    }
}

void addBonesBelow(const aiScene &scene, const std::vector<aiMesh *> &meshes)
{
    for (aiMesh *mesh : meshes) {
        const aiNode *top = topBone(scene, *mesh);
        Offsets bones;
        for (unsigned b = 0; b < mesh->mNumBones; ++b)
            bones.emplace(mesh->mBones[b]->mName.C_Str(), mesh->mBones[b]->mOffsetMatrix);
        const Offsets own = bones;
        for (const auto &[name, offset] : own) {
            // Those below other bones are met on the way down from these.
            const aiNode *node = scene.mRootNode->FindNode(name.c_str());
            const bool isTop =
                node && (node == top || !node->mParent || !own.contains(node->mParent->mName.C_Str()));
            if (isTop)
                addBonesOf(scene, *node, offset, *mesh, bones);
        }
    }
}

void addBonesAbove(const aiScene &scene, const aiNode &top, aiMesh &mesh)
{
    Offsets bones;
    std::vector<const aiNode *> open;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        bones.emplace(mesh.mBones[b]->mName.C_Str(), mesh.mBones[b]->mOffsetMatrix);
        if (const aiNode *node = scene.mRootNode->FindNode(mesh.mBones[b]->mName); isBelow(node, top))
            open.push_back(node);
    }
    while (!open.empty()) {
        const aiNode &node = *open.back();
        open.pop_back();
        if (&node == &top || !node.mParent || bones.contains(node.mParent->mName.C_Str()))
            continue;
        const aiMatrix4x4 offset = node.mTransformation * bones.at(node.mName.C_Str());
        addBareBone(mesh, *node.mParent, offset);
        bones.emplace(node.mParent->mName.C_Str(), offset);
        open.push_back(node.mParent);
    }
}

} // namespace autocuts
