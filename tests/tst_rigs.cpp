// Skeletons from one format to another: rest poses, sizes, ends of limbs, and what programs need to find
// them.
#include "model/io/assimp/assimpmatrix.h"
#include "model/io/assimp/assimpplacing.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/files/savefile.h"
#include "model/io/files/xmlspans.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "model/transfer/facematch.h"
#include "support/gltffiles.h"

#include <QTemporaryDir>
#include <QTest>

#include <Eigen/Geometry>

#include <assimp/scene.h>

#include <cmath>
#include <map>

namespace tst_rigs {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! The numbers of glTF's matrix of a move.
std::vector<float> moved(float x, float y, float z)
{
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

//! A grid that the bone "bone" holds, which ends in "tip" and is below "Rig". The grid lies where it is
//! bound, whatever its own node says: the bone is at 1 3 3.
gltffiles::FileBuilder rig()
{
    gltffiles::FileBuilder file = gltffiles::skinned();
    Json &nodes = file.json["nodes"];
    nodes[1]["translation"] = {0, 1, 0};
    nodes[1]["children"] = {2};
    nodes.push_back({{"name", "tip"}, {"translation", {0, 2, 0}}});
    nodes.push_back({{"name", "Rig"}, {"translation", {1, 2, 3}}, {"children", {1}}});
    file.json["scenes"][0]["nodes"] = {0, 3};
    file.json["skins"][0]["inverseBindMatrices"] = file.add(moved(-1, -3, -3), "MAT4", 5126, 16);
    return file;
}

//! Moves a node from place to place within two seconds.
void animate(gltffiles::FileBuilder &file, int node, const std::vector<float> &places)
{
    const int times = file.add(std::vector<float>{0, 2}, "SCALAR", 5126, 1);
    const int values = file.add(places, "VEC3", 5126, 3);
    const Json channel{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}};
    const Json sampler{{"input", times}, {"output", values}};
    file.json["animations"] = {{{"channels", Json::array({channel})}, {"samplers", Json::array({sampler})}}};
}

const aiScene &assimpScene(const Scene &scene)
{
    return *dynamic_cast<const AssimpSource &>(*scene.source).scene;
}

Eigen::Affine3d worldOfNode(const aiNode *node)
{
    Eigen::Affine3d world = Eigen::Affine3d::Identity();
    for (; node; node = node->mParent)
        world = Eigen::Affine3d(toEigen(node->mTransformation)) * world;
    return world;
}

const aiBone *boneNamed(const aiMesh &mesh, const char *name)
{
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        if (mesh.mBones[b]->mName == aiString(name))
            return mesh.mBones[b];
    }
    return nullptr;
}

//! The element of a node of this name; null without one.
const XmlElement *nodeNamed(const XmlElement &element, std::string_view name)
{
    if (element.name == "node" && element.attribute("name") == name)
        return &element;
    for (const XmlElement &child : element.children) {
        if (const XmlElement *found = nodeNamed(child, name))
            return found;
    }
    return nullptr;
}

//! Leaves bytes of this value in memory that is free.
void fillMemory(char value)
{
    std::vector<QByteArray> blocks;
    for (qsizetype size = 16; size <= 4096; size += 16) {
        for (int i = 0; i < 4; ++i)
            blocks.emplace_back(size, value);
    }
}

} // namespace

class TestRigs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { mFolder = std::make_unique<QTemporaryDir>(); }

    //! The place of the node of a skinned mesh says nothing in glTF and Collada.
    void boundWhereTheBonesSay()
    {
        gltffiles::FileBuilder file = rig();
        file.json["nodes"][0]["translation"] = {5, 0, 0};
        QVERIFY(convert(file, u"fbx"_s));
        const Result<FbxTree> tree = parseFbxTree(loadFile(at(u"r.fbx"_s), 1 << 20).value(), at(u"r.fbx"_s));
        QVERIFY(tree.ok());
        int clusters = 0;
        const int objects = tree->child(0, "Objects");
        for (int node = tree->child(objects, "Deformer"); node >= 0; node = tree->nextNamed(node)) {
            const int link = tree->child(node, "TransformLink");
            if (link < 0)
                continue;
            ++clusters;
            const std::vector<double> matrix = tree->doubles(link).value();
            QVERIFY((Vec3(matrix[12], matrix[13], matrix[14]) - Vec3(1, 3, 3)).norm() < 1e-6);
        }
        QCOMPARE(clusters, 1);
        // The mesh is there, too.
        const Scene before = gltffiles::parsed(rig().glb()), fbx = readMesh(at(u"r.fbx"_s)).value();
        QVERIFY((before.mesh->positions.colwise().mean() - fbx.mesh->positions.colwise().mean()).norm() <
                1e-6);
    }

    //! A pose is not the rest pose, though the bone that has it is the first one.
    void restPoseOfFbxInCollada()
    {
        gltffiles::FileBuilder file = rig();
        Json &nodes = file.json["nodes"];
        nodes[1]["translation"] = {0, 4, 0};
        nodes.push_back({{"name", "left"}, {"translation", {-1, 0, 0}}});
        nodes.push_back({{"name", "right"}, {"translation", {1, 0, 0}}});
        nodes[3]["children"] = {1, 4, 5};
        std::vector<float> binds = moved(-1, -3, -3);
        for (const std::vector<float> &bind : {moved(0, -2, -3), moved(-2, -2, -3)})
            binds.insert(binds.end(), bind.begin(), bind.end());
        file.json["skins"] = {
            {{"joints", {1, 4, 5}}, {"inverseBindMatrices", file.add(binds, "MAT4", 5126, 16)}}};
        QVERIFY(convert(file, u"fbx"_s));
        const Scene fbx = readMesh(at(u"r.fbx"_s)).value();
        QVERIFY(writeMesh(fbx, at(u"r.dae"_s)).ok());
        QVERIFY(exportLosses(fbx, u"dae"_s).join(u' ').contains(u"rest pose"_s));
        const Scene dae = readMesh(at(u"r.dae"_s)).value();
        const aiBone *bone = boneNamed(*assimpScene(dae).mMeshes[0], "bone");
        QVERIFY(bone);
        const Eigen::Affine3d rest(toEigen(bone->mOffsetMatrix).inverse());
        // With z up.
        QVERIFY((rest.translation() - Vec3(1, -3, 3)).norm() < 1e-5);
    }

    //! Programs pose bones correctly where nothing above them has a transform, and the file has z up.
    void skeletonsInCollada()
    {
        gltffiles::FileBuilder file = rig();
        animate(file, 1, {0, 1, 0, 0, 1, 4});
        QVERIFY(convert(file, u"dae"_s));
        const std::string text = loadFile(at(u"r.dae"_s), 1 << 20)->toStdString();
        QVERIFY(text.find("Z_UP") != std::string::npos);
        const XmlElement root = xmlSpans(text).value();
        const XmlElement *above = nodeNamed(root, "Rig"), *tip = nodeNamed(root, "tip");
        QVERIFY(above && tip && tip->attribute("type") == "JOINT");
        QCOMPARE(QByteArray(above->child("matrix")->content.data(), 8), "1 0 0 0 "_ba);
        const Scene dae = readMesh(at(u"r.dae"_s)).value();
        const aiScene &scene = assimpScene(dae);
        const aiMesh &mesh = *scene.mMeshes[0];
        const aiBone *bone = boneNamed(mesh, "bone");
        QVERIFY(bone);
        // What the bones make of the mesh is what was there.
        const Eigen::Affine3d skin = worldOfNode(scene.mRootNode->FindNode(bone->mName)) *
                                     Eigen::Affine3d(toEigen(bone->mOffsetMatrix));
        Vec3 low = Vec3::Constant(1e9), lowBefore = low;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            low = low.cwiseMin(skin * Vec3(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z));
        const std::vector<float> positions = gltffiles::gridPositions();
        for (std::size_t p = 0; p < positions.size(); p += 3)
            lowBefore = lowBefore.cwiseMin(Vec3(positions[p], positions[p + 1], positions[p + 2]));
        QVERIFY((low - lowBefore).norm() < 1e-4);
        // The motion has what was above.
        const aiNodeAnim &motion = *scene.mAnimations[0]->mChannels[0];
        const aiVector3D end = motion.mPositionKeys[motion.mNumPositionKeys - 1].mValue;
        const Eigen::Affine3d up = worldOfNode(scene.mRootNode->FindNode(bone->mName)->mParent);
        QVERIFY((up * Vec3(end.x, end.y, end.z) - Vec3(1, 3, 7)).norm() < 1e-4);
        QVERIFY(
            !exportLosses(readMesh(at(u"r.glb"_s)).value(), u"dae"_s).join(u' ').contains(u"rest pose"_s));
    }

    //! Blender shows bones that have no key as they were bound.
    void stillBonesInCollada()
    {
        gltffiles::FileBuilder file = rig();
        animate(file, 1, {0, 1, 0, 0, 1, 4});
        QVERIFY(convert(file, u"dae"_s));
        const Scene dae = readMesh(at(u"r.dae"_s)).value();
        const aiScene &scene = assimpScene(dae);
        QCOMPARE(scene.mNumAnimations, 1U);
        const aiAnimation &animation = *scene.mAnimations[0];
        std::map<std::string, const aiNodeAnim *> channels;
        for (unsigned c = 0; c < animation.mNumChannels; ++c)
            channels[animation.mChannels[c]->mNodeName.C_Str()] = animation.mChannels[c];
        QCOMPARE(channels.size(), 2U);
        QVERIFY(channels.contains("tip"));
        const aiNodeAnim &tip = *channels["tip"];
        QCOMPARE(tip.mNumPositionKeys, 1U);
        const aiNode *node = scene.mRootNode->FindNode("tip");
        aiVector3D scaling, place;
        aiQuaternion turn;
        node->mTransformation.Decompose(scaling, turn, place);
        QVERIFY((tip.mPositionKeys[0].mValue - place).Length() < 1e-5F);
    }

    //! What moves a skeleton is one of its bones.
    void movingRigsInCollada()
    {
        gltffiles::FileBuilder file = rig();
        animate(file, 3, {1, 2, 3, 1, 2, 9});
        QVERIFY(convert(file, u"dae"_s));
        const std::string text = loadFile(at(u"r.dae"_s), 1 << 20)->toStdString();
        const XmlElement root = xmlSpans(text).value();
        QCOMPARE(std::string(nodeNamed(root, "Rig")->attribute("type")), std::string("JOINT"));
    }

    //! Blender crashes where a mesh is above its bones.
    void meshesAboveTheirBonesInCollada()
    {
        gltffiles::FileBuilder file = gltffiles::skinned();
        file.json["nodes"][0]["children"] = {1};
        file.json["scenes"][0]["nodes"] = {0};
        QVERIFY(convert(file, u"dae"_s));
        const std::string text = loadFile(at(u"r.dae"_s), 1 << 20)->toStdString();
        const XmlElement root = xmlSpans(text).value();
        const XmlElement *scene = root.child("library_visual_scenes")->child("visual_scene");
        int skins = 0;
        for (const XmlElement &node : scene->children) {
            const bool isSkin = node.child("instance_controller");
            skins += isSkin;
            QVERIFY(!isSkin || !node.child("node"));
        }
        QCOMPARE(skins, 1);
        QCOMPARE(readMesh(at(u"r.dae"_s))->objectNames, readMesh(at(u"r.glb"_s))->objectNames);
    }

    //! Bones without weights are bones.
    void endsOfLimbsInGltf()
    {
        QVERIFY(convert(rig(), u"fbx"_s));
        QVERIFY(writeMesh(readMesh(at(u"r.fbx"_s)).value(), at(u"again.glb"_s)).ok());
        const Json json = gltffiles::jsonOf(gltffiles::contentOf(at(u"again.glb"_s)));
        std::set<std::string> names;
        for (const Json &joint : json["skins"][0]["joints"])
            names.insert(json["nodes"][joint.get<std::size_t>()]["name"].get<std::string>());
        QCOMPARE(names, (std::set<std::string>{"bone", "tip"}));
    }

    //! What was in memory before has no part in a file.
    void sameBytesFromRunToRun_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        for (const QString &from : {u"glb"_s, u"fbx"_s}) {
            for (const QString &to : {u"glb"_s, u"gltf"_s, u"dae"_s, u"fbx"_s, u"obj"_s, u"ply"_s})
                QTest::addRow("%s to %s", qPrintable(from), qPrintable(to)) << from << to;
        }
    }
    void sameBytesFromRunToRun()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        gltffiles::FileBuilder file = rig();
        animate(file, 1, {0, 1, 0, 0, 1, 4});
        QVERIFY(convert(file, u"fbx"_s));
        QByteArray first;
        for (char run = 0; run < 8; ++run) {
            fillMemory(run);
            QVERIFY(writeMesh(readMesh(at(u"r."_s + from)).value(), at(u"w."_s + to)).ok());
            const QByteArray bytes = gltffiles::contentOf(at(u"w."_s + to));
            if (run == 0)
                first = bytes;
            QVERIFY(!bytes.isEmpty() && bytes == first);
        }
        QVERIFY(to != u"dae"_s || first.contains("<created>1970-01-01T00:00:00</created>"));
    }

    //! Assimp leaves bytes of memory behind the joints of skins.
    void noUnusedBytesInGltf()
    {
        QVERIFY(convert(rig(), u"fbx"_s));
        QVERIFY(writeMesh(readMesh(at(u"r.fbx"_s)).value(), at(u"w.glb"_s)).ok());
        const QByteArray bytes = gltffiles::contentOf(at(u"w.glb"_s));
        const Json json = gltffiles::jsonOf(bytes);
        std::size_t used = 0;
        for (const Json &view : json["bufferViews"]) {
            QCOMPARE(view["byteOffset"].get<std::size_t>(), used);
            used += (view["byteLength"].get<std::size_t>() + 3) / 4 * 4;
        }
        QCOMPARE(json["buffers"][0]["byteLength"].get<std::size_t>(), used);
        // What has moved is what it was.
        const Scene before = gltffiles::parsed(rig().glb()), after = gltffiles::parsed(bytes);
        QVERIFY(gltffiles::uvDifference(before, after) < 1e-6);
    }

    //! Programs leave out the scale of bones in the rest pose.
    void unitsAreNotScalesOfBones()
    {
        aiScene scene;
        scene.mRootNode = new aiNode("root");
        aiNode *children[] = {new aiNode("bone"), new aiNode("Armature")};
        scene.mRootNode->addChildren(2, children);
        scene.mMeshes = new aiMesh *[1] { new aiMesh };
        scene.mNumMeshes = 1;
        scene.mMeshes[0]->mBones = new aiBone *[1] { new aiBone };
        scene.mMeshes[0]->mNumBones = 1;
        scene.mMeshes[0]->mBones[0]->mName = "bone";
        Eigen::Matrix4d centimetres = Eigen::Matrix4d::Identity();
        centimetres.topLeftCorner<3, 3>() *= 0.01;
        placeScene(scene, centimetres);
        const aiNode *bone = scene.mRootNode->FindNode("bone");
        QVERIFY(bone && bone->mTransformation.IsIdentity());
        QCOMPARE(bone->mParent->mName.C_Str(), "Armature_2");
        QCOMPARE(bone->mParent->mParent, scene.mRootNode);
        QVERIFY(toEigen(bone->mParent->mTransformation).isApprox(centimetres, 1e-6));
        QVERIFY(toEigen(scene.mRootNode->FindNode("Armature")->mTransformation).isApprox(centimetres, 1e-6));
    }

    //! Programs refuse files with such names.
    void namesThatAreNoUtf8InCollada()
    {
        const QByteArray fbx =
            "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: "
            "7400\n}\n"
            "Objects:  {\n\tGeometry: 1, \"Geometry::\", \"Mesh\" {\n\t\tVertices: *9 {\n\t\t\ta: "
            "0,0,0,1,0,0,1,2,3\n\t\t}\n\t\tPolygonVertexIndex: *3 {\n\t\t\ta: 0,1,-3\n\t\t}\n"
            "\t\tGeometryVersion: 124\n\t}\n\tModel: 2, \"Model::Face\", \"Mesh\" {\n\t\tVersion: 232\n\t}\n"
            "\tModel: 3, \"Model::a\xff\xfe\", \"Null\" {\n\t\tVersion: 232\n\t}\n}\n"
            "Connections:  {\n\tC: \"OO\",3,0\n\tC: \"OO\",2,3\n\tC: \"OO\",1,2\n}\n";
        QVERIFY(saveAtomically(at(u"n.fbx"_s), fbx).ok());
        QVERIFY(writeMesh(readMesh(at(u"n.fbx"_s)).value(), at(u"n.dae"_s)).ok());
        const QByteArray text = loadFile(at(u"n.dae"_s), 1 << 20).value();
        QVERIFY(text.contains("name=\"a"));
        QVERIFY(text.isValidUtf8());
    }

    //! Parts of an object that have one material share it in new Collada files.
    void partsOfOneMaterial()
    {
        gltffiles::FileBuilder file = gltffiles::grid();
        Json &primitives = file.json["meshes"][0]["primitives"];
        primitives.push_back(Json(primitives[0]));
        QVERIFY(convert(file, u"dae"_s));
        const QByteArray text = loadFile(at(u"r.dae"_s), 1 << 20).value();
        QCOMPARE(text.count("<geometry "), 1);
        QCOMPARE(text.count("<polylist "), 2);
        QCOMPARE(text.count("<instance_material "), 1);
    }

    //! Rigs of files that are read in two ways are found by their faces.
    void verticesCloserThanTheTolerance()
    {
        PositionMatrix exact(5, 3), rounded(5, 3);
        exact << 0, 1e-7, 0, 0, -1e-7, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0;
        rounded = exact;
        rounded(0, 1) = rounded(1, 1) = 0;
        const auto mesh = [](const PositionMatrix &positions, const std::vector<int> &corners) {
            return MeshData::build(positions, {0, 3, 6}, corners, {0, 0});
        };
        const FaceMatch match =
            matchFacesInPlace(*mesh(rounded, {0, 2, 3, 4, 2, 1}), *mesh(exact, {0, 2, 3, 1, 4, 2}), 2e-6);
        QCOMPARE(match.face, (std::vector<int>{0, 1}));
        QCOMPARE(match.corner, (std::vector<int>{0, 1, 2, 4, 5, 3}));
    }

private:
    QString at(const QString &name) const { return mFolder->filePath(name); }
    //! Writes r.glb and, in another format, r.FORMAT of it.
    bool convert(const gltffiles::FileBuilder &file, const QString &format) const
    {
        if (!saveAtomically(at(u"r.glb"_s), file.glb()))
            return false;
        const Result<Scene> scene = readMesh(at(u"r.glb"_s));
        return scene && writeMesh(scene.value(), at(u"r."_s + format)).ok();
    }

    std::unique_ptr<QTemporaryDir> mFolder;
};

QTEST_GUILESS_MAIN(TestRigs)

} // namespace tst_rigs

#include "tst_rigs.moc"
