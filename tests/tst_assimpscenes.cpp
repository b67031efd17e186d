// How scenes come over from autocuts-reader: every field, damaged streams, pictures inside.
#include "model/io/assimp/assimpstream.h"
#include "model/io/assimp/assimptextures.h"

#include <QImage>
#include <QTest>

#include <assimp/scene.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace tst_assimpscenes {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

template <typename T>
T **arrayOf(T *object)
{
    return new T *[1] { object };
}

void addChild(aiNode &node, const char *name)
{
    auto *child = new aiNode(name);
    node.addChildren(1, &child);
}

//! A scene with something in every field that is passed on.
std::unique_ptr<aiScene> fullScene()
{
    auto scene = std::make_unique<aiScene>();
    scene->mName = aiString("scene");
    auto *root = new aiNode("root");
    scene->mRootNode = root;
    addChild(*root, "child");
    aiNode &child = *root->mChildren[0];
    child.mTransformation.a4 = 3;
    child.mNumMeshes = 1;
    child.mMeshes = new unsigned[1]{0};
    child.mMetaData = new aiMetadata;
    aiMetadata inner;
    inner.Add("number", std::int32_t(-5));
    child.mMetaData->Add("flag", true);
    child.mMetaData->Add("large", std::uint64_t(1) << 40);
    child.mMetaData->Add("float", 1.5F);
    child.mMetaData->Add("double", 2.5);
    child.mMetaData->Add("text", aiString("words"));
    child.mMetaData->Add("vector", aiVector3D(1, 2, 3));
    child.mMetaData->Add("inner", inner);

    auto *mesh = new aiMesh;
    scene->mMeshes = arrayOf(mesh);
    scene->mNumMeshes = 1;
    mesh->mName = aiString("mesh");
    mesh->mNumVertices = 3;
    mesh->mVertices = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->mNormals = new aiVector3D[3]{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh->mTangents = new aiVector3D[3]{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    mesh->mBitangents = new aiVector3D[3]{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    mesh->mColors[1] = new aiColor4D[3]{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5F}};
    mesh->mTextureCoords[0] = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->mNumUVComponents[0] = 2;
    mesh->SetTextureCoordsName(0, aiString("map"));
    mesh->mNumFaces = 1;
    mesh->mFaces = new aiFace[1];
    mesh->mFaces[0].mNumIndices = 3;
    mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
    auto *bone = new aiBone;
    bone->mName = aiString("bone");
    bone->mNumWeights = 1;
    bone->mWeights = new aiVertexWeight[1]{{2, 0.25F}};
    mesh->mNumBones = 1;
    mesh->mBones = arrayOf(bone);
    auto *target = new aiAnimMesh;
    target->mName = aiString("smile");
    target->mNumVertices = 3;
    target->mVertices = new aiVector3D[3]{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    mesh->mNumAnimMeshes = 1;
    mesh->mAnimMeshes = arrayOf(target);

    auto *material = new aiMaterial;
    const aiString name("red");
    const aiColor4D red(1, 0, 0, 1);
    material->AddProperty(&name, AI_MATKEY_NAME);
    material->AddProperty(&red, 1, AI_MATKEY_COLOR_DIFFUSE);
    scene->mMaterials = arrayOf(material);
    scene->mNumMaterials = 1;

    auto *texture = new aiTexture;
    texture->mWidth = 5;
    texture->pcData = new aiTexel[2]{{1, 2, 3, 4}, {5, 0, 0, 0}};
    scene->mTextures = arrayOf(texture);
    scene->mNumTextures = 1;

    auto *animation = new aiAnimation;
    animation->mDuration = 7;
    auto *channel = new aiNodeAnim;
    channel->mNodeName = aiString("child");
    channel->mNumPositionKeys = channel->mNumRotationKeys = channel->mNumScalingKeys = 1;
    channel->mPositionKeys = new aiVectorKey[1]{{0.5, {1, 2, 3}}};
    channel->mRotationKeys = new aiQuatKey[1]{{0.5, aiQuaternion(1, 0, 0, 0)}};
    channel->mScalingKeys = new aiVectorKey[1]{{0.5, {1, 1, 1}}};
    animation->mNumChannels = 1;
    animation->mChannels = arrayOf(channel);
    auto *morph = new aiMeshMorphAnim;
    morph->mNumKeys = 1;
    morph->mKeys = new aiMeshMorphKey[1];
    morph->mKeys[0].mNumValuesAndWeights = 1;
    morph->mKeys[0].mValues = new unsigned[1]{0};
    morph->mKeys[0].mWeights = new double[1]{0.75};
    animation->mNumMorphMeshChannels = 1;
    animation->mMorphMeshChannels = arrayOf(morph);
    scene->mAnimations = arrayOf(animation);
    scene->mNumAnimations = 1;

    auto *camera = new aiCamera;
    camera->mName = aiString("camera");
    camera->mAspect = 1.25F;
    scene->mCameras = arrayOf(camera);
    scene->mNumCameras = 1;
    auto *light = new aiLight;
    light->mName = aiString("light");
    light->mType = aiLightSource_SPOT;
    light->mColorDiffuse = aiColor3D(1, 0.5F, 0);
    scene->mLights = arrayOf(light);
    scene->mNumLights = 1;
    return scene;
}

QByteArray streamOf(aiScene &scene)
{
    std::FILE *file = std::tmpfile();
    writeAssimpScene(scene, file);
    QByteArray bytes(static_cast<qsizetype>(std::ftell(file)), '\0');
    std::rewind(file);
    if (std::fread(bytes.data(), 1, std::size_t(bytes.size()), file) != std::size_t(bytes.size()))
        qFatal("the scene cannot be read back");
    std::fclose(file);
    return bytes;
}

std::unique_ptr<aiScene> sceneFrom(const QByteArray &bytes, std::size_t memory = std::size_t(1) << 26)
{
    return readAssimpScene({bytes.constData(), static_cast<std::size_t>(bytes.size())}, memory);
}

} // namespace

class TestAssimpScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFieldOfASceneComesOver();
    void damagedStreams();
    void largeClaimsTakeNoMemory();
    void deepNodesAreRefused();
    void picturesInside();
};

void TestAssimpScenes::everyFieldOfASceneComesOver()
{
    const std::unique_ptr<aiScene> scene = fullScene();
    const QByteArray bytes = streamOf(*scene);
    const std::unique_ptr<aiScene> again = sceneFrom(bytes);
    QCOMPARE(streamOf(*again), bytes);
    QCOMPARE(again->mName, scene->mName);
    const aiNode *child = again->mRootNode->FindNode("child");
    QVERIFY(child && child->mParent == again->mRootNode);
    QCOMPARE(child->mTransformation.a4, 3.0F);
    QVERIFY(*child->mMetaData == *scene->mRootNode->mChildren[0]->mMetaData);
    QCOMPARE(child->mMetaData->mNumProperties, 7U);
    const aiMesh &mesh = *again->mMeshes[0];
    QVERIFY(mesh.mFaces[0] == scene->mMeshes[0]->mFaces[0]);
    QVERIFY(mesh.mTangents[1] == aiVector3D(1, 0, 0) && mesh.mBitangents[1] == aiVector3D(0, 1, 0));
    QVERIFY(mesh.mColors[1][2] == aiColor4D(0, 0, 1, 0.5F));
    QCOMPARE(mesh.GetTextureCoordsName(0)->C_Str(), "map");
    QCOMPARE(mesh.mBones[0]->mName.C_Str(), "bone");
    QVERIFY(mesh.mBones[0]->mWeights[0] == aiVertexWeight(2, 0.25F));
    QVERIFY(mesh.mAnimMeshes[0]->mVertices[2] == aiVector3D(0, 1, 1));
    QCOMPARE(again->mMaterials[0]->GetName().C_Str(), "red");
    aiColor4D color;
    QCOMPARE(again->mMaterials[0]->Get(AI_MATKEY_COLOR_DIFFUSE, color), aiReturn_SUCCESS);
    QVERIFY(color == aiColor4D(1, 0, 0, 1));
    QCOMPARE(again->mTextures[0]->pcData[1].b, 5);
    QCOMPARE(again->mAnimations[0]->mMorphMeshChannels[0]->mKeys[0].mWeights[0], 0.75);
    QVERIFY(again->mAnimations[0]->mChannels[0]->mPositionKeys[0].mValue == aiVector3D(1, 2, 3));
    QCOMPARE(again->mCameras[0]->mAspect, 1.25F);
    QCOMPARE(again->mLights[0]->mType, aiLightSource_SPOT);
}

//! Cut off anywhere, or with any byte set to its largest value: an exception or a scene, never a crash.
void TestAssimpScenes::damagedStreams()
{
    const QByteArray bytes = streamOf(*fullScene());
    for (qsizetype size = 0; size < bytes.size(); ++size)
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, sceneFrom(bytes.first(size)));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, sceneFrom(bytes + '\0'));
    int refused = 0;
    for (qsizetype at = 0; at < bytes.size(); ++at) {
        QByteArray damaged = bytes;
        damaged[at] = '\xff';
        try {
            sceneFrom(damaged);
        } catch (const std::runtime_error &) {
            ++refused;
        }
    }
    QVERIFY(refused > 0);
}

void TestAssimpScenes::largeClaimsTakeNoMemory()
{
    // The name of the mesh, then its primitive types: the number of vertices follows.
    QByteArray bytes = streamOf(*fullScene());
    const qsizetype count = bytes.indexOf(QByteArray("\4\0\0\0mesh", 8)) + 8 + 4;
    bytes.replace(count, 4, QByteArray("\xff\xff\xff\x7f", 4));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, sceneFrom(bytes));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, sceneFrom(streamOf(*fullScene()), 10000));
}

void TestAssimpScenes::deepNodesAreRefused()
{
    aiScene scene;
    scene.mRootNode = new aiNode("root");
    aiNode *last = scene.mRootNode;
    for (int i = 0; i < 5000; ++i) {
        addChild(*last, "node");
        last = last->mChildren[0];
    }
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, streamOf(scene));
}

//! Of picture files and of plain texels, by number and by name; damaged sizes and numbers are no pictures.
void TestAssimpScenes::picturesInside()
{
    const QByteArray file("a picture file");
    aiScene scene;
    scene.mNumTextures = 3;
    scene.mTextures = new aiTexture *[3];
    for (unsigned t = 0; t < 3; ++t) {
        aiTexture &texture = *(scene.mTextures[t] = new aiTexture);
        texture.pcData = new aiTexel[6]();
    }
    scene.mTextures[0]->mWidth = static_cast<unsigned>(file.size());
    std::copy(file.begin(), file.end(), reinterpret_cast<char *>(scene.mTextures[0]->pcData));
    scene.mTextures[0]->mFilename = aiString("folder/wood.png");
    scene.mTextures[1]->mWidth = 3;
    scene.mTextures[1]->mHeight = 2;
    scene.mTextures[1]->pcData[2] = {30, 20, 10, 255};
    scene.mTextures[2]->mWidth = scene.mTextures[2]->mHeight = 1U << 31;
    AssimpTextures textures(scene);
    const auto named = [&](const char *name) {
        aiMaterial material;
        const aiString path(name);
        material.AddProperty(&path, AI_MATKEY_TEXTURE(aiTextureType_DIFFUSE, 0));
        return textures.ofMaterial(material);
    };
    QCOMPARE(named("*0").content, file);
    QCOMPARE(named("*0").file, u"folder/wood.png"_s);
    QCOMPARE(named("C:\\x\\wood.png").content.constData(), named("*0").content.constData()); // shared
    QCOMPARE(QImage::fromData(named("*1").content).size(), QSize(3, 2));
    QCOMPARE(QImage::fromData(named("*1").content).pixel(2, 0), qRgb(10, 20, 30));
    for (const char *broken : {"*2", "*3", "*-1"})
        QVERIFY2(named(broken).content.isEmpty(), broken);
    QCOMPARE(named("iron.png").file, u"iron.png"_s);
    QVERIFY(named("iron.png").content.isEmpty());
}

QTEST_GUILESS_MAIN(TestAssimpScenes)

} // namespace tst_assimpscenes

#include "tst_assimpscenes.moc"
