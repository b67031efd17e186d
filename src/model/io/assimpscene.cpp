#include "model/io/assimpscene.h"

#include "model/io/assimpmesh.h"
#include "model/io/gltf/gltfsource.h"
#include "model/io/objsource.h"
#include "model/plain/picture.h"

#include <assimp/scene.h>

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! Copies the node tree without its meshes; also returns the copies in depth-first order.
aiNode *copyTree(const aiNode &from, std::vector<aiNode *> &order)
{
    auto *node = new aiNode;
    order.push_back(node);
    node->mName = from.mName;
    node->mTransformation = from.mTransformation;
    if (from.mMetaData)
        node->mMetaData = new aiMetadata(*from.mMetaData);
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

aiMaterial *makeMaterial(const QString &name)
{
    auto *material = new aiMaterial;
    const aiString text(name.toStdString());
    material->AddProperty(&text, AI_MATKEY_NAME);
    return material;
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

bool hasMorphTargets(const aiScene &scene)
{
    return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh *mesh) { return mesh->mNumAnimMeshes > 0; });
}

bool hasBones(const aiScene &scene)
{
    return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh *mesh) { return mesh->mNumBones > 0; });
}

bool isInstanced(const AssimpSource &source)
{
    std::vector<unsigned> meshes;
    for (const AssimpPiece &piece : source.pieces)
        meshes.push_back(piece.mesh);
    std::sort(meshes.begin(), meshes.end());
    return std::adjacent_find(meshes.begin(), meshes.end()) != meshes.end();
}

//! True when at least one node has several meshes.
bool hasSplitNodes(const AssimpSource &source)
{
    const auto sameNode = [](const AssimpPiece &a, const AssimpPiece &b) { return a.node == b.node; };
    return std::ranges::adjacent_find(source.pieces, sameNode) != source.pieces.end();
}

//! Puts a new root without transform above the root.
void wrapRoot(aiScene &scene)
{
    auto *root = new aiNode("Root");
    root->mNumChildren = 1;
    root->mChildren = new aiNode *[1] { scene.mRootNode };
    scene.mRootNode->mParent = root;
    scene.mRootNode = root;
}

} // namespace

ExportOptions exportOptions(const QString &format)
{
    ExportOptions options;
    options.triangulate = format == QLatin1String("glb") || format == QLatin1String("gltf");
    // Assimp cannot read back Collada files with animations, and its FBX exporter crashes on embedded
    // textures.
    options.animations = format != QLatin1String("dae");
    options.embeddedTextures = options.rootTransform = format != QLatin1String("fbx");
    options.linearColors = isGltfFormat(format);
    return options;
}

bool isFromAssimp(const Scene &scene)
{
    return dynamic_cast<const AssimpSource *>(scene.source.get()) != nullptr;
}

SourceContents contentsOf(const AssimpSource &source)
{
    const aiScene &from = *source.scene;
    SourceContents contents;
    contents.bones = hasBones(from);
    contents.shapeKeys = hasMorphTargets(from);
    contents.animations = from.mNumAnimations > 0;
    contents.lightsOrCameras = from.mNumLights > 0 || from.mNumCameras > 0;
    contents.embeddedTextures = from.mNumTextures > 0;
    contents.hierarchy = from.mRootNode->mNumChildren > 0;
    contents.instances = isInstanced(source);
    contents.splitObjects = hasSplitNodes(source);
    return contents;
}

ExportScene::ExportScene(const Scene &scene, const ExportOptions &options)
    : mScene(new aiScene), mOptions(options)
{
    const auto *source = dynamic_cast<const AssimpSource *>(scene.source.get());
    const bool fits =
        source && !source->pieces.empty() &&
        source->pieces.back().firstFace + source->pieces.back().faceCount == scene.mesh->faceCount();
    if (fits)
        takeFromSource(scene, *source);
    else
        makePlain(scene);
}

void ExportScene::borrow(const aiScene &from)
{
    mBorrowed = true;
    mScene->mNumMaterials = from.mNumMaterials;
    mScene->mMaterials = from.mMaterials;
    if (mOptions.embeddedTextures) {
        mScene->mNumTextures = from.mNumTextures;
        mScene->mTextures = from.mTextures;
    }
    if (mOptions.animations) {
        mScene->mNumAnimations = from.mNumAnimations;
        mScene->mAnimations = from.mAnimations;
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
    if (from.mMetaData)
        mScene->mMetaData = new aiMetadata(*from.mMetaData);

    const bool sameColors = isGltfFormat(scene.format) == mOptions.linearColors;
    const auto toFile = sameColors ? nullptr : mOptions.linearColors ? linearFromSrgb : srgbFromLinear;
    std::vector<aiNode *> nodes;
    mScene->mRootNode = copyTree(*from.mRootNode, nodes);
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
        if (!nodeMeshes[n].empty())
            setMeshes(*nodes[n], nodeMeshes[n]);
    }
    if (!mOptions.rootTransform && !mScene->mRootNode->mTransformation.IsIdentity())
        wrapRoot(*mScene);
}

void ExportScene::makePlain(const Scene &scene)
{
    PositionMatrix normals;
    if (const auto *obj = dynamic_cast<const ObjSource *>(scene.source.get()))
        normals = objShading(*obj).normals;
    const bool hasNormals = normals.rows() == scene.mesh->cornerCount() && normals.allFinite();

    // One material more than there are names, for faces without a material.
    mScene->mNumMaterials = static_cast<unsigned>(scene.materialNames.size() + 1);
    mScene->mMaterials = new aiMaterial *[mScene->mNumMaterials];
    for (std::size_t m = 0; m < scene.materialNames.size(); ++m)
        mScene->mMaterials[m] = makeMaterial(scene.materialNames[m]);
    mScene->mMaterials[scene.materialNames.size()] = makeMaterial(QStringLiteral("DefaultMaterial"));

    std::vector<aiMesh *> meshes;
    std::map<int, std::vector<unsigned>> objectMeshes;
    const MeshOptions options{hasNormals ? &normals : nullptr,
                              nullptr,
                              {},
                              mOptions.triangulate,
                              mOptions.linearColors ? nullptr : srgbFromLinear};
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
}

ExportScene::~ExportScene()
{
    if (mBorrowed) {
        mScene->mNumMaterials = mScene->mNumTextures = mScene->mNumAnimations = mScene->mNumLights =
            mScene->mNumCameras = 0;
        mScene->mMaterials = nullptr;
        mScene->mTextures = nullptr;
        mScene->mAnimations = nullptr;
        mScene->mLights = nullptr;
        mScene->mCameras = nullptr;
    }
    delete mScene;
}

} // namespace autocuts
