// Bones and animations from one format to another.
#include "model/io/assimp/assimpsource.h"
#include "model/io/fbx/fbxobjects.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxsource.h"
#include "model/io/files/savefile.h"
#include "model/io/formats/modelunits.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "support/gltffiles.h"

#include <QTemporaryDir>
#include <QTest>

#include <assimp/scene.h>

#include <cmath>

namespace tst_animations {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestAnimations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { mFolder = std::make_unique<QTemporaryDir>(); }

    //! Programs look for the armature above the bones, and find none where that is a mesh.
    void meshesAboveTheirBones()
    {
        gltffiles::FileBuilder file = gltffiles::skinned();
        file.json["nodes"][0]["children"] = {1};
        file.json["nodes"][0]["translation"] = {0, 5, 0};
        file.json["scenes"][0]["nodes"] = {0};
        QVERIFY(saveAtomically(at(u"s.glb"_s), file.glb()).ok());
        const Scene scene = readMesh(at(u"s.glb"_s)).value();
        QVERIFY(writeMesh(scene, at(u"s.fbx"_s)).ok());
        const Result<FbxTree> tree = parseFbxTree(loadFile(at(u"s.fbx"_s), 1 << 20).value(), at(u"s.fbx"_s));
        QVERIFY(tree.ok());
        const FbxObjects objects = readFbxObjects(tree.value());
        const auto above = [&objects](const FbxModel &model) {
            return model.parent < 0 ? nullptr : &objects.models[static_cast<std::size_t>(model.parent)];
        };
        int meshes = 0, bones = 0;
        for (const FbxModel &model : objects.models) {
            const bool isMesh = !model.geometries.empty(), isBone = model.name == u"bone"_s;
            meshes += isMesh;
            bones += isBone;
            QVERIFY(!above(model) || above(model)->geometries.empty());
            if (isMesh || isBone)
                QCOMPARE(above(model)->name.endsWith(u"_node"_s), true);
        }
        QCOMPARE(meshes, 1);
        QCOMPARE(bones, 1);
        const Scene again = readMesh(at(u"s.fbx"_s)).value();
        QCOMPARE(again.objectNames, scene.objectNames);
        const auto middle = [](const Scene &model) {
            const PositionMatrix p = inUnits(model.mesh->positions, unitsOf(model), {});
            return Vec3(p.colwise().mean().transpose());
        };
        QVERIFY((middle(scene) - middle(again)).norm() < 1e-4);
    }

    //! Assimp finds what is animated by its name.
    void nodesOfOneName()
    {
        gltffiles::FileBuilder file = gltffiles::grid();
        file.json["nodes"][0]["name"] = "arm";
        file.json["nodes"].push_back({{"name", "arm"}, {"mesh", 0}, {"translation", {70, 0, 0}}});
        file.json["scenes"][0]["nodes"] = {0, 1};
        const int times = file.add(std::vector<float>{0, 1}, "SCALAR", 5126, 1);
        const int values = file.add(std::vector<float>{70, 0, 0, 80, 0, 0}, "VEC3", 5126, 3);
        const Json channel{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}};
        const Json sampler{{"input", times}, {"output", values}};
        file.json["animations"] = {
            {{"channels", Json::array({channel})}, {"samplers", Json::array({sampler})}}};
        for (const QByteArray &bytes : {file.glb(), file.text()}) {
            const QString from = bytes.startsWith('{') ? u"arms.gltf"_s : u"arms.glb"_s;
            QVERIFY(saveAtomically(at(from), bytes).ok());
            QVERIFY(writeMesh(readMesh(at(from)).value(), at(u"arms.fbx"_s)).ok());
            QVERIFY(writeMesh(readMesh(at(u"arms.fbx"_s)).value(), at(u"again.glb"_s)).ok());
            const Json json = gltffiles::jsonOf(gltffiles::contentOf(at(u"again.glb"_s)));
            const Json &target = json["animations"][0]["channels"][0]["target"];
            const Json &node = json["nodes"][target["node"].get<std::size_t>()];
            const double x = node.contains("translation") ? node["translation"][0].get<double>()
                                                          : node["matrix"][12].get<double>();
            QVERIFY(std::abs(x - 70) < 1e-3);
        }
    }

    //! Assimp's exporter writes animations that nobody reads; ours are there again.
    void animationsInCollada()
    {
        gltffiles::FileBuilder file = gltffiles::skinned();
        file.json["nodes"][1]["translation"] = {0, 3, 0};
        const int times = file.add(std::vector<float>{0, 2}, "SCALAR", 5126, 1);
        const int places = file.add(std::vector<float>{0, 3, 0, 5, 3, 0}, "VEC3", 5126, 3);
        const auto half = static_cast<float>(std::sqrt(0.5));
        const int turns = file.add(std::vector<float>{0, 0, 0, 1, 0, 0, half, half}, "VEC4", 5126, 4);
        const auto channel = [](int sampler, const char *path) {
            return Json{{"sampler", sampler}, {"target", {{"node", 1}, {"path", path}}}};
        };
        file.json["animations"] = {
            {{"channels", Json::array({channel(0, "translation"), channel(1, "rotation")})},
             {"samplers", Json::array({Json{{"input", times}, {"output", places}},
                                       Json{{"input", times}, {"output", turns}}})}}};
        QVERIFY(saveAtomically(at(u"a.glb"_s), file.glb()).ok());
        // Directly, and from the FBX file that is made of it.
        QVERIFY(writeMesh(readMesh(at(u"a.glb"_s)).value(), at(u"a.fbx"_s)).ok());
        for (const QString &from : {u"a.glb"_s, u"a.fbx"_s}) {
            QVERIFY(writeMesh(readMesh(at(from)).value(), at(u"a.dae"_s)).ok());
            const Result<Scene> dae = readMesh(at(u"a.dae"_s));
            QVERIFY2(dae.ok(), dae ? "" : qPrintable(dae.error().toString()));
            const auto *source = dynamic_cast<const AssimpSource *>(dae->source.get());
            QVERIFY(source);
            QCOMPARE(source->scene->mNumAnimations, 1U);
            const aiAnimation &animation = *source->scene->mAnimations[0];
            QCOMPARE(animation.mNumChannels, 1U);
            const aiNodeAnim &moved = *animation.mChannels[0];
            QCOMPARE(QString::fromUtf8(moved.mNodeName.C_Str()), u"bone"_s);
            // A quarter turn needs keys between.
            QVERIFY(moved.mNumPositionKeys > 4 && moved.mNumRotationKeys == moved.mNumPositionKeys);
            const auto seconds = [&animation](double ticks) { return ticks / animation.mTicksPerSecond; };
            const aiVectorKey &last = moved.mPositionKeys[moved.mNumPositionKeys - 1];
            QVERIFY(std::abs(seconds(last.mTime) - 2) < 1e-3);
            QVERIFY((last.mValue - aiVector3D(5, 3, 0)).Length() < 1e-4F);
            const aiQuaternion turn = moved.mRotationKeys[moved.mNumRotationKeys - 1].mValue;
            QVERIFY(std::abs(std::abs(turn.z) - half) < 1e-4F && std::abs(std::abs(turn.w) - half) < 1e-4F);
        }
    }

    //! What is kept is not said to be lost.
    void animationsThatAreLost()
    {
        const auto animated = [](const char *path) {
            gltffiles::FileBuilder file = gltffiles::morphed();
            const int times = file.add(std::vector<float>{0, 1}, "SCALAR", 5126, 1);
            const bool moves = std::string(path) == "translation";
            const int values = moves ? file.add(std::vector<float>{0, 0, 0, 1, 0, 0}, "VEC3", 5126, 3)
                                     : file.add(std::vector<float>{0, 0, 1, 1}, "SCALAR", 5126, 1);
            const Json channel{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}};
            const Json sampler{{"input", times}, {"output", values}};
            file.json["animations"] = {
                {{"channels", Json::array({channel})}, {"samplers", Json::array({sampler})}}};
            return gltffiles::parsed(file.glb());
        };
        const auto losses = [](const Scene &scene, const char *format) {
            return exportLosses(scene, QString::fromLatin1(format)).join(u' ');
        };
        const Scene moved = animated("translation"), morphed = animated("weights");
        QVERIFY(!losses(moved, "fbx").contains(u"animations"_s));
        QVERIFY(!losses(moved, "dae").contains(u"animation"_s));
        QVERIFY(losses(morphed, "fbx").contains(u"objects and bones only"_s));
        // Of an FBX file: what we have written moves objects only.
        QVERIFY(writeMesh(moved, at(u"m.fbx"_s)).ok());
        const Scene fbx = readMesh(at(u"m.fbx"_s)).value();
        QVERIFY(sourceOf<FbxSource>(fbx)->contents.animations);
        QVERIFY(!losses(fbx, "glb").contains(u"animations"_s));
    }

private:
    QString at(const QString &name) const { return mFolder->filePath(name); }

    std::unique_ptr<QTemporaryDir> mFolder;
};

QTEST_GUILESS_MAIN(TestAnimations)

} // namespace tst_animations

#include "tst_animations.moc"
