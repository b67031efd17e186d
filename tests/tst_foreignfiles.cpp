// Files that crash, hang or bloat Assimp, read by autocuts-reader: each becomes an error. Cancelling. How the
// scene comes over. Collada as others write it.
#include "model/io/assimpprocess.h"
#include "model/io/assimpstream.h"
#include "model/io/assimptextures.h"
#include "model/io/meshfile.h"
#include "model/io/objreader.h"
#include "model/io/savefile.h"

#include <QFile>
#include <QImage>
#include <QStringEncoder>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/scene.h>

#include <algorithm>
#include <cerrno>
#include <sys/wait.h>
#include <thread>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Short, for files that hang.
constexpr ReaderLimits shortLimits{qint64(512) << 20, 1, 60};

const QByteArray xyz = "property float x\nproperty float y\nproperty float z\n";

QByteArray ply(const QByteArray &header, const QByteArray &body)
{
    return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

//! Assimp makes room for 3 vertices and fills in 2000.
QByteArray twoVertexElements()
{
    return ply("element vertex 3\n" + xyz + "element vertex 2000\n" + xyz +
                   "element face 1\nproperty list uchar int vertex_indices\n",
               "0 0 0\n1 0 0\n0 1 0\n" + QByteArray("7 1 2\n").repeated(2000) + "3 0 1 2\n");
}

//! A GLB whose JSON claims to have 1 GB.
QByteArray glbOfAGigabyte()
{
    const QByteArray json = "{\"asset\":1}";
    const quint32 head[] = {0x46546C67, 2, quint32(20 + json.size()), 0x40000498, 0x4E4F534A};
    return QByteArray(reinterpret_cast<const char *>(head), sizeof head) + json;
}

//! The pivot becomes part of the node, so that the node that the animation names does not exist.
constexpr QByteArrayView fbxWithAnimatedPivot = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
FBXHeaderVersion: 1003
FBXVersion: 7400
}
Objects:  {
Geometry: 1, "Geometry::", "Mesh" {
Vertices: *9 { a: 0,0,0,1,0,0,0,1,0 }
PolygonVertexIndex: *3 { a: 0,1,-3 }
}
Model: 2, "Model::part", "Mesh" {
Properties70:  {
P: "RotationPivot", "Vector3D", "Vector", "",1,0,0
}
}
AnimationStack: 3, "AnimStack::Take", "" {
}
AnimationLayer: 4, "AnimLayer::Base", "" {
}
AnimationCurveNode: 5, "AnimCurveNode::T", "" {
Properties70:  {
P: "d|X", "Number", "", "A",0
}
}
AnimationCurve: 6, "AnimCurve::", "" {
KeyTime: *2 { a: 0,46186158000 }
KeyValueFloat: *2 { a: 0,1 }
KeyAttrFlags: *1 { a: 264 }
KeyAttrDataFloat: *4 { a: 0,0,0,0 }
KeyAttrRefCount: *1 { a: 2 }
}
}
Connections:  {
C: "OO",1,2
C: "OO",2,0
C: "OO",4,3
C: "OO",5,4
C: "OP",5,2, "Lcl Translation"
C: "OP",6,5, "d|X"
}
)";

//! True when no child process is left, not even one that has ended.
bool hasNoChildren()
{
    return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

//! Puts a script in the place of autocuts-reader.
class OtherReader
{
public:
    explicit OtherReader(const QByteArray &script)
    {
        const QString path = mFolder.filePath(u"reader"_s);
        if (!saveAtomically(path, "#!/bin/sh\n" + script + '\n').ok() ||
            !QFile::setPermissions(path, QFile::ReadOwner | QFile::ExeOwner))
            qFatal("the script cannot be written");
        qputenv("AUTOCUTS_READER", QFile::encodeName(path));
    }
    ~OtherReader()
    {
        if (mBefore.isNull())
            qunsetenv("AUTOCUTS_READER");
        else
            qputenv("AUTOCUTS_READER", mBefore);
    }
    OtherReader(const OtherReader &) = delete;
    OtherReader &operator=(const OtherReader &) = delete;

private:
    QTemporaryDir mFolder;
    QByteArray mBefore = qgetenv("AUTOCUTS_READER");
};

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

//! Two triangles as a Collada file.
QByteArray collada(const QTemporaryDir &folder)
{
    const QString path = folder.filePath(u"plain.dae"_s);
    const Result<Scene> scene =
        parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl rot\nf 1 2 3\nf 1 3 4\n", u"a.obj"_s);
    if (!scene || !writeMesh(scene.value(), path))
        qFatal("the Collada file cannot be written");
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestForeignFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { QVERIFY(hasNoChildren()); }

    void faultyFiles_data();
    void faultyFiles();
    void theWholeWay();
    void cancelling();
    void readersThatMisbehave_data();
    void readersThatMisbehave();
    void missingReader();
    void everyFieldOfASceneComesOver();
    void damagedStreams();
    void largeClaimsTakeNoMemory();
    void deepNodesAreRefused();
    void picturesInside();
    void packedPictureOfABlendFile();
    void limitsGrowWithTheFile();
    void colladaOfOthers_data();
    void colladaOfOthers();
    void blendFilesAreSentToBlender();
    void animatedPivotsCanBeWritten_data();
    void animatedPivotsCanBeWritten();
};

void TestForeignFiles::faultyFiles_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("part"); // of the message; empty: there may be none
    const QByteArray list = "property list uchar int vertex_indices\n";
#ifndef AUTOCUTS_SANITIZED
    // Where the memory that Assimp writes beyond is noticed.
    QTest::newRow("two vertex elements") << u"a.ply"_s << twoVertexElements() << u"damaged"_s;
#endif
    // Reads beyond its memory, so that anything may come of it.
    QTest::newRow("two face elements")
        << u"a.ply"_s
        << ply("element vertex 8\n" + xyz + "element face 3\n" + list + "element face 8\n" + list,
               QByteArray("0 0 0\n").repeated(8) + QByteArray("3 0 1 2\n").repeated(11))
        << QString();
    QTest::newRow("no line end in the header")
        << u"a.ply"_s
        << QByteArray("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nelement "
                      "facend_header\n0 0 0\n")
        << u"takes longer than"_s;
    QTest::newRow("cut property") << u"a.ply"_s
                                  << QByteArray("ply\nformat ascii 1.0\nelement vertex 4\n" + xyz +
                                                "property floatend_header\n0 0 0\n")
                                  << u"takes longer than"_s;
#ifndef AUTOCUTS_SANITIZED
    // Where the reader has a limit of memory.
    QTest::newRow("huge glb") << u"a.glb"_s << glbOfAGigabyte() << u"of memory"_s;
    QTest::newRow("huge off") << u"a.off"_s << QByteArray("OFF\n999999999 1 0\n0 0 0\n") << u"of memory"_s;
#endif
}

void TestForeignFiles::faultyFiles()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, part);
    QTemporaryDir folder;
    const QString path = folder.filePath(name);
    QVERIFY(saveAtomically(path, bytes).ok());
    const auto scene = readInProcess(path, shortLimits, nullptr);
    if (scene.ok() && part.isEmpty())
        return;
    QVERIFY(!scene.ok());
    const Error &error = scene.error();
    QVERIFY2(error.message.contains(part), qPrintable(error.message));
    QCOMPARE(error.file, path);
    QVERIFY(error.remedy.contains(u"export the model again"_s));
}

//! Through the function that the programs call.
void TestForeignFiles::theWholeWay()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.ply"_s);
    QVERIFY(saveAtomically(path, twoVertexElements()).ok());
    const Result<Scene> scene = readMesh(path);
#ifdef AUTOCUTS_SANITIZED
    if (scene.ok())
        QSKIP("Under a sanitizer the memory that Assimp writes beyond is not noticed");
#endif
    QVERIFY(!scene.ok());
    QVERIFY2(scene.error().message.contains(u"damaged"_s), qPrintable(scene.error().message));
}

void TestForeignFiles::cancelling()
{
    // Without the cancelling this would end with another error, after the limit of time.
    const OtherReader sleeping("exec sleep 1000");
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.off"_s);
    QVERIFY(saveAtomically(path, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").ok());
    std::atomic<bool> stop = false;
    const std::jthread user([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop = true;
    });
    const Result<Scene> scene = readMesh(path, &stop);
    QVERIFY(!scene.ok());
    QVERIFY(stop);
    QCOMPARE(scene.error().message, u"reading was cancelled"_s);
    QCOMPARE(scene.error().file, path);
}

void TestForeignFiles::readersThatMisbehave_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QString>("part");
    QTest::newRow("sleeps") << QByteArray("exec sleep 1000") << u"takes longer than"_s;
    QTest::newRow("says nothing") << QByteArray("exit 0") << u"breaks off"_s;
    QTest::newRow("says something else") << QByteArray("echo something else entirely") << u"not a scene"_s;
    QTest::newRow("never ends") << QByteArray("exec cat /dev/zero") << u"of memory"_s;
    QTest::newRow("fails") << QByteArray("printf 'half a scene\\0because'; exit 1") << u"because"_s;
    QTest::newRow("unknown code") << QByteArray("exit 77") << u"damaged"_s;
}

void TestForeignFiles::readersThatMisbehave()
{
    QFETCH(QByteArray, script);
    QFETCH(QString, part);
    const OtherReader reader(script);
    const auto scene = readInProcess(u"a.off"_s, {1 << 22, 1, 1}, nullptr);
    QVERIFY(!scene.ok());
    QVERIFY2(scene.error().message.contains(part), qPrintable(scene.error().message));
}

void TestForeignFiles::missingReader()
{
    const OtherReader reader({});
    qputenv("AUTOCUTS_READER", "/nowhere/autocuts-reader");
    const auto scene = readInProcess(u"a.off"_s, shortLimits, nullptr);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().message.contains(u"autocuts-reader"_s));
    QVERIFY(scene.error().remedy.contains(u"Install Autocuts again"_s));
}

void TestForeignFiles::everyFieldOfASceneComesOver()
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
void TestForeignFiles::damagedStreams()
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

void TestForeignFiles::largeClaimsTakeNoMemory()
{
    // The name of the mesh, then its primitive types: the number of vertices follows.
    QByteArray bytes = streamOf(*fullScene());
    const qsizetype count = bytes.indexOf(QByteArray("\4\0\0\0mesh", 8)) + 8 + 4;
    bytes.replace(count, 4, QByteArray("\xff\xff\xff\x7f", 4));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, sceneFrom(bytes));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, sceneFrom(streamOf(*fullScene()), 10000));
}

void TestForeignFiles::deepNodesAreRefused()
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
void TestForeignFiles::picturesInside()
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

void TestForeignFiles::packedPictureOfABlendFile()
{
    const QString path = u"/usr/share/assimp/models/BLEND/TexturedPlane_ImageUvPacked_248.blend"_s;
    if (!QFile::exists(path))
        QSKIP("Debian's package assimp-testmodels is not there");
    const Result<Scene> scene = readMesh(path);
    QVERIFY2(scene.ok(), scene.ok() ? "" : qPrintable(scene.error().toString()));
    QVERIFY(!QImage::fromData(scene->materialTextures.at(0).content).isNull());
}

void TestForeignFiles::limitsGrowWithTheFile()
{
    const ReaderLimits none = readerLimits(0);
    const ReaderLimits some = readerLimits(100'000'000);
    QVERIFY(none.memory >= qint64(512) << 20 && none.cpuSeconds >= 10 && none.wallSeconds > none.cpuSeconds);
    QVERIFY(some.memory > none.memory + 64 * qint64(100'000'000) && some.cpuSeconds > none.cpuSeconds + 100);
}

void TestForeignFiles::colladaOfOthers_data()
{
    QTest::addColumn<int>("encoding");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("space");
    QTest::newRow("as written") << int(QStringConverter::Utf8) << QString() << QString();
    QTest::newRow("UTF-16LE") << int(QStringConverter::Utf16LE) << QString(QChar(0xFEFF)) << QString();
    QTest::newRow("UTF-16BE") << int(QStringConverter::Utf16BE) << QString(QChar(0xFEFF)) << QString();
    QTest::newRow("UTF-16LE, no mark") << int(QStringConverter::Utf16LE) << QString() << QString();
    QTest::newRow("UTF-16BE, no mark") << int(QStringConverter::Utf16BE) << QString() << QString();
    QTest::newRow("UTF-8, mark") << int(QStringConverter::Utf8) << QString(QChar(0xFEFF)) << QString();
    QTest::newRow("blank lines first") << int(QStringConverter::Utf8) << u"\n  \n"_s << QString();
    QTest::newRow("space before numbers") << int(QStringConverter::Utf8) << QString() << u"  "_s;
    QTest::newRow("all") << int(QStringConverter::Utf16LE) << QString(QChar(0xFEFF)) << u"\n\t"_s;
}

void TestForeignFiles::colladaOfOthers()
{
    QFETCH(int, encoding);
    QFETCH(QString, before);
    QFETCH(QString, space);
    QTemporaryDir folder;
    QString text = before + QString::fromUtf8(collada(folder));
    // A name beyond the first plane of Unicode.
    text.replace(u"rot"_s, u"r\U0001F534t"_s);
    text.replace(u"<color sid=\"diffuse\">"_s, u"<color sid=\"diffuse\">"_s + space);
    text.replace(u"<color sid=\"specular\">"_s, u"<color sid=\"specular\">"_s + space);
    if (encoding != QStringConverter::Utf8)
        text.replace(u"utf-8"_s, u"utf-16"_s, Qt::CaseInsensitive);
    QStringEncoder encoder(static_cast<QStringConverter::Encoding>(encoding));
    const QByteArray bytes = encoder.encode(text);
    const QString path = folder.filePath(u"other.DAE"_s);
    QVERIFY(saveAtomically(path, bytes).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    QCOMPARE(scene->mesh->faceCount(), 2);
    QCOMPARE(scene->mesh->area, 1.0);
    QVERIFY(std::find(scene->materialNames.begin(), scene->materialNames.end(), u"r\U0001F534t"_s) !=
            scene->materialNames.end());
}

void TestForeignFiles::blendFilesAreSentToBlender()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.blend"_s);
    QVERIFY(saveAtomically(path, "BLENDER-v262garbage").ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().remedy.contains(u"Open it in Blender"_s));
}

void TestForeignFiles::animatedPivotsCanBeWritten_data()
{
    QTest::addColumn<QString>("suffix");
    QTest::newRow("glb") << u"glb"_s;
    QTest::newRow("fbx") << u"fbx"_s;
}

void TestForeignFiles::animatedPivotsCanBeWritten()
{
    QFETCH(QString, suffix);
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.fbx"_s);
    QVERIFY(saveAtomically(path, fbxWithAnimatedPivot.toByteArray()).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    const QString written = folder.filePath(u"b."_s + suffix);
    QVERIFY(writeMesh(scene.value(), written).ok());
    const Result<Scene> again = readMesh(written);
    QVERIFY(again.ok());
    QCOMPARE(again->mesh->faceCount(), 1);
}

QTEST_GUILESS_MAIN(TestForeignFiles)
#include "tst_foreignfiles.moc"
