#include "model/io/assimp/assimpscene.h"

#include "model/io/assimp/assimpbinding.h"
#include "model/io/assimp/assimpmatrix.h"
#include "model/io/assimp/assimpmesh.h"
#include "model/io/formats/meshformats.h"
#include "model/plain/picture.h"

#include <QUrl>

#include <assimp/scene.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace autocuts {

namespace {

//! The values that are not lists of their own; null when there are none. Assimp's copier ends the program at
//! lists, such as the extensions of a node of a glTF file.
aiMetadata *copyOf(const aiMetadata *from)
{
    if (!from)
        return nullptr;
    auto copy = std::make_unique<aiMetadata>(*from);
    const auto isKept = [](const aiMetadataEntry &value) {
        return value.mData && value.mType <= AI_AIVECTOR3D;
    };
    const auto kept =
        static_cast<unsigned>(std::count_if(copy->mValues, copy->mValues + copy->mNumProperties, isKept));
    if (kept == 0)
        return nullptr;
    aiMetadata *some = aiMetadata::Alloc(kept);
    unsigned count = 0;
    for (unsigned i = 0; i < copy->mNumProperties; ++i) {
        if (!isKept(copy->mValues[i]))
            continue;
        std::swap(some->mKeys[count], copy->mKeys[i]);
        std::swap(some->mValues[count++], copy->mValues[i]);
    }
    return some;
}

//! Copies the node tree without its meshes; also returns the copies in depth-first order.
aiNode *copyTree(const aiNode &from, std::vector<aiNode *> &order)
{
    auto *node = new aiNode;
    order.push_back(node);
    node->mName = from.mName;
    node->mTransformation = from.mTransformation;
    node->mMetaData = copyOf(from.mMetaData);
    if (from.mNumChildren > 0)
        node->mChildren = new aiNode *[from.mNumChildren];
    for (unsigned c = 0; c < from.mNumChildren; ++c) {
        node->mChildren[c] = copyTree(*from.mChildren[c], order);
        node->mChildren[c]->mParent = node;
        node->mNumChildren = c + 1;
    }
    return node;
}

void setMeshes(aiScene &scene, const std::vector<aiMesh *> &meshes)
{
    scene.mNumMeshes = static_cast<unsigned>(meshes.size());
    scene.mMeshes = new aiMesh *[meshes.size()];
    std::copy(meshes.begin(), meshes.end(), scene.mMeshes);
}

void setMeshes(aiNode &node, const std::vector<unsigned> &meshes)
{
    node.mNumMeshes = static_cast<unsigned>(meshes.size());
    node.mMeshes = new unsigned[meshes.size()];
    std::copy(meshes.begin(), meshes.end(), node.mMeshes);
}

constexpr std::pair<TextureChannel, aiTextureType> textureTypes[] = {
    {TextureChannel::BaseColor, aiTextureType_DIFFUSE},
    {TextureChannel::Normal, aiTextureType_NORMALS},
    {TextureChannel::Emission, aiTextureType_EMISSIVE},
    {TextureChannel::Occlusion, aiTextureType_LIGHTMAP},
    {TextureChannel::Height, aiTextureType_DISPLACEMENT}};

//! Takes out the pictures: they are named anew.
void removeTextures(aiMaterial &material)
{
    unsigned kept = 0;
    for (unsigned p = 0; p < material.mNumProperties; ++p) {
        aiMaterialProperty *property = material.mProperties[p];
        if (std::string_view(property->mKey.C_Str()).starts_with("$tex."))
            delete property;
        else
            material.mProperties[kept++] = property;
    }
    material.mNumProperties = kept;
}

//! \param from what Assimp has read of it; null: nothing \param looks null: no pictures
aiMaterial *makeMaterial(const QString &name, int number, const aiMaterial *from, MaterialLooks *looks)
{
    auto *material = new aiMaterial;
    if (from)
        aiMaterial::CopyPropertyList(material, from);
    removeTextures(*material);
    const aiString text(name.toStdString());
    material->AddProperty(&text, AI_MATKEY_NAME);
    if (!looks)
        return material;
    const Vec3 color = looks->color(number);
    const aiColor4D diffuse(static_cast<float>(color.x()), static_cast<float>(color.y()),
                            static_cast<float>(color.z()), 1);
    material->AddProperty(&diffuse, 1, AI_MATKEY_COLOR_DIFFUSE);
    const int shading = aiShadingMode_Phong;
    material->AddProperty(&shading, 1, AI_MATKEY_SHADING_MODEL);
    for (const auto &[channel, type] : textureTypes) {
        const SceneTexture picture = looks->picture(number, channel).picture;
        if (picture.isEmpty())
            continue;
        const aiString file(QUrl::toPercentEncoding(looks->fileOf(picture), "/:").toStdString());
        material->AddProperty(&file, AI_MATKEY_TEXTURE(type, 0));
    }
    return material;
}

//! The names of nodes that something besides the tree uses.
std::set<std::string_view> namesUsedElsewhere(const aiScene &scene)
{
    std::set<std::string_view> names;
    const auto add = [&names](const aiString &name) { names.insert({name.data, name.length}); };
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c)
            add(scene.mAnimations[a]->mChannels[c]->mNodeName);
    }
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
            add(scene.mMeshes[m]->mBones[b]->mName);
    }
    for (unsigned c = 0; c < scene.mNumCameras; ++c)
        add(scene.mCameras[c]->mName);
    for (unsigned l = 0; l < scene.mNumLights; ++l)
        add(scene.mLights[l]->mName);
    return names;
}

//! Gives the nodes of objects the names that the objects have in the program.
void nameNodes(const Scene &scene, const AssimpSource &source, const std::vector<aiNode *> &nodes)
{
    const std::set<std::string_view> kept = namesUsedElsewhere(*source.scene);
    for (const AssimpPiece &piece : source.pieces) {
        if (piece.faceCount == 0)
            continue;
        const int object = scene.mesh->faceObject[static_cast<std::size_t>(piece.firstFace)];
        aiNode &node = *nodes[static_cast<std::size_t>(piece.node)];
        if (object < std::ssize(scene.objectNames) && !kept.contains({node.mName.data, node.mName.length}))
            node.mName = scene.objectNames[static_cast<std::size_t>(object)].toStdString();
    }
}

//! The faces of each pair of object and material; -1 means none.
std::map<std::pair<int, int>, std::vector<int>> facesByMaterial(const Scene &scene)
{
    std::map<std::pair<int, int>, std::vector<int>> faces;
    for (int f = 0; f < scene.mesh->faceCount(); ++f) {
        const int material = f < std::ssize(scene.faceMaterial) ? scene.faceMaterial[f] : -1;
        faces[{scene.mesh->faceObject[f], material}].push_back(f);
    }
    return faces;
}

} // namespace

ExportScene::ExportScene(const Scene &scene, const ExportOptions &options)
    : mScene(new aiScene), mOptions(options)
{
    if (const auto *source = sourceOf<AssimpSource>(scene))
        takeFromSource(scene, *source);
    else
        makePlain(scene);
}

void ExportScene::borrow(const aiScene &from)
{
    mBorrowed = true;
    if (mOptions.animations && from.mNumAnimations > 0) {
        mScene->mAnimations = new aiAnimation *[from.mNumAnimations];
        for (unsigned a = 0; a < from.mNumAnimations; ++a) {
            auto *animation = new aiAnimation;
            // Assimp refuses animations that are called like a node.
            animation->mName = "animation " + std::to_string(a);
            animation->mDuration = from.mAnimations[a]->mDuration;
            animation->mTicksPerSecond = from.mAnimations[a]->mTicksPerSecond;
            animation->mNumChannels = from.mAnimations[a]->mNumChannels;
            animation->mChannels = from.mAnimations[a]->mChannels;
            mScene->mAnimations[a] = animation;
        }
        mScene->mNumAnimations = from.mNumAnimations;
    }
    mScene->mNumLights = from.mNumLights;
    mScene->mLights = from.mLights;
    mScene->mNumCameras = from.mNumCameras;
    mScene->mCameras = from.mCameras;
}

void ExportScene::takeFromSource(const Scene &scene, const AssimpSource &source)
{
    const aiScene &from = *source.scene;
    borrow(from);
    makeMaterials(scene, &from);
    mScene->mMetaData = copyOf(from.mMetaData);

    const bool sameColors = isGltfFormat(scene.format) == mOptions.linearColors;
    const auto toFile = sameColors ? nullptr : mOptions.linearColors ? linearFromSrgb : srgbFromLinear;
    std::vector<aiNode *> nodes;
    mScene->mRootNode = copyTree(*from.mRootNode, nodes);
    // What Assimp reads is in metres, but the axes may differ.
    const bool zUp = unitsOfFormat(scene.format).zUp;
    if (const Eigen::Matrix4d turn = unitChange({1, zUp}, mOptions.units); !turn.isIdentity(0))
        mScene->mRootNode->mTransformation = toAssimp(turn) * mScene->mRootNode->mTransformation;
    nameNodes(scene, source, nodes);
    std::vector<aiMesh *> meshes;
    std::vector<std::vector<unsigned>> nodeMeshes(nodes.size());
    for (const AssimpPiece &piece : source.pieces) {
        if (piece.faceCount == 0)
            continue;
        std::vector<int> faces(piece.faceCount);
        for (int i = 0; i < piece.faceCount; ++i)
            faces[i] = piece.firstFace + i;
        nodeMeshes[piece.node].push_back(static_cast<unsigned>(meshes.size()));
        const MeshOptions options{nullptr, from.mMeshes[piece.mesh], piece, mOptions.triangulate, toFile};
        meshes.push_back(makeExportMesh(scene, faces, options));
    }
    setMeshes(*mScene, meshes);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodeMeshes[n].empty())
            continue;
        setMeshes(*nodes[n], nodeMeshes[n]);
        const std::vector<aiMesh *> own = meshesOf(*nodes[n]);
        if (mOptions.weighsAll)
            weighAll(*mScene, *nodes[n], own);
    }
    if (mOptions.joinsMaterials)
        mParts = joinMeshes(*mScene);
    bindMeshes(source, nodes);
}

std::vector<aiMesh *> ExportScene::meshesOf(const aiNode &node) const
{
    std::vector<aiMesh *> meshes;
    for (unsigned m = 0; m < node.mNumMeshes; ++m)
        meshes.push_back(mScene->mMeshes[node.mMeshes[m]]);
    return meshes;
}

//! Brings the skeletons to the form that the exporter and its readers need.
void ExportScene::bindMeshes(const AssimpSource &source, const std::vector<aiNode *> &nodes)
{
    mBareBones = autocuts::bareBones(*mScene, source.limbs);
    if (mOptions.laysOutSkeletons) {
        std::set<std::string> bones = boneNames(*mScene);
        bones.insert(mBareBones.begin(), mBareBones.end());
        for (const aiNode *node : nodes)
            bindToBone(*source.scene, *node, meshesOf(*node), bones);
        mBareBones = autocuts::bareBones(*mScene, source.limbs);
    }
    if (mOptions.namesAllBones) {
        for (const aiNode *node : nodes)
            addBonesBelow(*mScene, meshesOf(*node));
    }
    if (mOptions.laysOutSkeletons)
        mChanges = layOutSkeletons(*mScene, *source.scene, mBareBones);
    if (!mOptions.bindsAtParent)
        return;
    std::vector<aiNode *> all = nodes;
    all.insert(all.end(), mChanges.added.begin(), mChanges.added.end());
    for (aiNode *node : all) {
        const auto known = source.boundAt.find(node->mName.C_Str());
        bindAtParent(*mScene, *node, meshesOf(*node),
                     known == source.boundAt.end() ? nullptr : &known->second);
    }
}

//! One material more than there are names, for faces without a material. \param from null: Assimp has read
//! none
void ExportScene::makeMaterials(const Scene &scene, const aiScene *from)
{
    const auto count = static_cast<unsigned>(scene.materialNames.size());
    mScene->mNumMaterials = from ? std::max(count, 1U) : count + 1;
    mScene->mMaterials = new aiMaterial *[mScene->mNumMaterials];
    for (unsigned m = 0; m < mScene->mNumMaterials; ++m) {
        const bool named = m < count;
        mScene->mMaterials[m] =
            makeMaterial(named ? scene.materialNames[m] : QStringLiteral("DefaultMaterial"),
                         named ? static_cast<int>(m) : -1,
                         from && m < from->mNumMaterials ? from->mMaterials[m] : nullptr, mOptions.looks);
    }
}

void ExportScene::makePlain(const Scene &scene)
{
    PositionMatrix normals;
    if (const FileSource *source = sourceOf(scene))
        normals = source->shading().normals;
    const bool hasNormals = normals.rows() == scene.mesh->cornerCount() && normals.allFinite();

    makeMaterials(scene, nullptr);
    std::vector<aiMesh *> meshes;
    std::map<int, std::vector<unsigned>> objectMeshes;
    MeshOptions options{hasNormals ? &normals : nullptr,
                        nullptr,
                        {},
                        mOptions.triangulate,
                        mOptions.linearColors ? nullptr : srgbFromLinear};
    options.place = unitChange(unitsOf(scene), mOptions.units).topLeftCorner<3, 3>();
    for (const auto &[key, faces] : facesByMaterial(scene)) {
        const auto [object, material] = key;
        aiMesh *mesh = makeExportMesh(scene, faces, options);
        const bool named = object >= 0 && object < std::ssize(scene.objectNames);
        mesh->mName = aiString(named ? scene.objectNames[object].toStdString() : std::string());
        mesh->mMaterialIndex = material >= 0 ? static_cast<unsigned>(material) : mScene->mNumMaterials - 1;
        objectMeshes[object].push_back(static_cast<unsigned>(meshes.size()));
        meshes.push_back(mesh);
    }
    setMeshes(*mScene, meshes);

    auto *root = new aiNode("Scene");
    mScene->mRootNode = root;
    root->mChildren = new aiNode *[objectMeshes.size()];
    for (const auto &[object, list] : objectMeshes) {
        const QString name =
            object >= 0 && object < std::ssize(scene.objectNames) ? scene.objectNames[object] : QString();
        auto *node = new aiNode(name.isEmpty() ? "object" : name.toStdString());
        node->mParent = root;
        setMeshes(*node, list);
        root->mChildren[root->mNumChildren++] = node;
    }
    if (mOptions.joinsMaterials)
        mParts = joinMeshes(*mScene);
}

ExportScene::~ExportScene()
{
    for (unsigned a = 0; a < mScene->mNumAnimations; ++a) {
        mScene->mAnimations[a]->mNumChannels = 0;
        mScene->mAnimations[a]->mChannels = nullptr;
    }
    if (mBorrowed) {
        mScene->mNumLights = mScene->mNumCameras = 0;
        mScene->mLights = nullptr;
        mScene->mCameras = nullptr;
    }
    delete mScene;
}

} // namespace autocuts
