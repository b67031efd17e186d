// What Assimp leaves out of FBX files when they become glTF or Collada: views, strengths of lights, motions
// around pivots, bones without a mesh, places of binding.
#include "model/io/assimp/assimpmatrix.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/fbx/fbxlinks.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/files/savefile.h"
#include "model/io/files/xmlspans.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "support/gltffiles.h"

#include <QTemporaryDir>
#include <QTest>

#include <Eigen/Geometry>

#include <assimp/scene.h>

#include <cmath>
#include <numbers>
#include <set>

namespace tst_fbxconversions {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! The text of a file in centimetres, of objects and connections.
class FbxText
{
public:
    //! \param kind of a node attribute or a model \param properties lines from property()
    void add(int id, const char *node, const char *name, const char *kind, const QByteArray &content = {})
    {
        mObjects += QByteArray("\t") + node + ": " + QByteArray::number(id) + ", \"" + node + "::" + name +
                    "\", \"" + kind + "\" {\n\t\tVersion: 232\n" + content + "\t}\n";
    }
    void model(int id, const char *name, const char *kind, int parent, const QByteArray &properties = {})
    {
        add(id, "Model", name, kind, list(properties));
        connect(id, parent);
    }
    void attribute(int id, const char *kind, int model, const QByteArray &properties)
    {
        add(id, "NodeAttribute", "", kind, list(properties));
        connect(id, model);
    }
    //! A box from -1 to 1.
    void box(int id, int model)
    {
        add(id, "Geometry", "", "Mesh",
            "\t\tVertices: *24 {\n\t\t\ta: "
            "-1,-1,-1,1,-1,-1,1,1,-1,-1,1,-1,-1,-1,1,1,-1,1,1,1,1,-1,1,1\n\t\t}\n"
            "\t\tPolygonVertexIndex: *24 {\n\t\t\ta: "
            "0,3,2,-2,4,5,6,-8,0,1,5,-5,1,2,6,-6,2,3,7,-7,3,0,4,-8\n\t\t}\n\t\tGeometryVersion: 124\n");
        connect(id, model);
    }
    void triangle(int id, int model)
    {
        add(id, "Geometry", "", "Mesh",
            "\t\tVertices: *9 {\n\t\t\ta: 0,0,0,1,0,0,0,1,0\n\t\t}\n\t\tPolygonVertexIndex: *3 {\n\t\t\ta: "
            "0,1,-3\n\t\t}\n\t\tGeometryVersion: 124\n");
        connect(id, model);
    }
    //! Binds the box to a bone. Matrices move only.
    void bind(int id, int geometry, int bone, const QByteArray &more, const Vec3 &meshInBone,
              const Vec3 &boneAt)
    {
        add(id, "Deformer", "", "Skin", more);
        connect(id, geometry);
        add(id + 1, "Deformer", "", "Cluster",
            "\t\tIndexes: *8 {\n\t\t\ta: 0,1,2,3,4,5,6,7\n\t\t}\n\t\tWeights: *8 {\n\t\t\ta: "
            "1,1,1,1,1,1,1,1\n\t\t}\n" +
                matrix("Transform", meshInBone) + matrix("TransformLink", boneAt));
        connect(id + 1, id);
        connect(bone, id + 1);
    }
    //! Turns a model about z within a second. \param degrees at the end
    void turn(int model, double degrees)
    {
        add(900, "AnimationStack", "Take", "");
        add(901, "AnimationLayer", "Layer", "");
        add(902, "AnimationCurveNode", "R", "", list(property("d|X", "0") + property("d|Y", "0")));
        add(903, "AnimationCurve", "", "",
            "\t\tKeyTime: *2 {\n\t\t\ta: 0,46186158000\n\t\t}\n\t\tKeyValueFloat: *2 {\n\t\t\ta: 0," +
                QByteArray::number(degrees) + "\n\t\t}\n");
        connect(901, 900);
        connect(902, 901);
        connect(902, model, "Lcl Rotation");
        connect(903, 902, "d|Z");
    }
    void connect(int child, int parent, const char *property = nullptr)
    {
        mConnections += QByteArray("\tC: \"") + (property ? "OP" : "OO") + "\"," + QByteArray::number(child) +
                        "," + QByteArray::number(parent) +
                        (property ? QByteArray(",\"") + property + "\"" : QByteArray()) + "\n";
    }
    //! \param type which some readers look at; null: the name
    static QByteArray property(const char *name, const QByteArray &value, const char *type = nullptr)
    {
        return QByteArray("\t\t\tP: \"") + name + "\", \"" + (type ? type : name) + "\", \"\", \"A\"," +
               value + "\n";
    }

    QByteArray bytes() const
    {
        return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: "
               "7400\n}\nObjects:  {\n" +
               mObjects + "}\nConnections:  {\n" + mConnections + "}\n";
    }

private:
    static QByteArray list(const QByteArray &properties)
    {
        return properties.isEmpty() ? properties : "\t\tProperties70:  {\n" + properties + "\t\t}\n";
    }
    static QByteArray matrix(const char *name, const Vec3 &moved)
    {
        QByteArray numbers = "1,0,0,0,0,1,0,0,0,0,1,0,";
        for (const double x : moved)
            numbers += QByteArray::number(x) + ",";
        return QByteArray("\t\t") + name + ": *16 {\n\t\t\ta: " + numbers + "1\n\t\t}\n";
    }

    QByteArray mObjects, mConnections;
};

//! A box that hangs on the second of two bones without weights.
FbxText barebones()
{
    FbxText file;
    file.model(1, "Rig", "Null", 0, FbxText::property("Lcl Translation", "100,0,0"));
    file.model(2, "root", "LimbNode", 1);
    file.model(3, "tip", "LimbNode", 2, FbxText::property("Lcl Translation", "0,200,0"));
    file.model(4, "Box", "Mesh", 3, FbxText::property("Lcl Translation", "0,0,300"));
    file.box(5, 4);
    return file;
}

const aiScene &assimpScene(const Scene &scene)
{
    return *dynamic_cast<const AssimpSource &>(*scene.source).scene;
}

//! The elements of this name, in the order of the text.
std::vector<const XmlElement *> elements(const XmlElement &root, std::string_view name)
{
    std::vector<const XmlElement *> found;
    if (root.name == name)
        found.push_back(&root);
    for (const XmlElement &child : root.children) {
        const auto below = elements(child, name);
        found.insert(found.end(), below.begin(), below.end());
    }
    return found;
}

double numberIn(const XmlElement &element, std::string_view name)
{
    const auto found = elements(element, name);
    return found.empty() ? NAN
                         : QByteArray(found[0]->content.data(), std::ssize(found[0]->content)).toDouble();
}

} // namespace

class TestFbxConversions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { mFolder = std::make_unique<QTemporaryDir>(); }

    void anglesOfCameras_data()
    {
        QTest::addColumn<QByteArray>("properties");
        QTest::addColumn<double>("wide");
        const auto p = [](const char *name, const char *value) { return FbxText::property(name, value); };
        const QByteArray film = p("FilmWidth", "1.41732") + p("FocalLength", "49.454570530261435");
        QTest::newRow("focal length") << p("ApertureMode", "3") + film << 40.0;
        QTest::newRow("focal length, whatever the angle says")
            << p("ApertureMode", "3") + p("FieldOfView", "10") + film << 40.0;
        QTest::newRow("horizontal") << p("ApertureMode", "1") + p("FieldOfView", "50") + film << 50.0;
        QTest::newRow("both") << p("ApertureMode", "0") + p("FieldOfViewX", "60") + p("FieldOfViewY", "20")
                              << 60.0;
        const double tangent = std::tan(10 * std::numbers::pi / 180) * 16 / 9;
        QTest::newRow("vertical") << p("ApertureMode", "2") + p("FieldOfView", "20") + film
                                  << 2 * std::atan(tangent) * 180 / std::numbers::pi;
        QTest::newRow("nothing but the film") << film << 40.0;
    }

    void anglesOfCameras()
    {
        QFETCH(QByteArray, properties);
        QFETCH(double, wide);
        FbxText file = withCamera(properties);
        QVERIFY(convert(file));
        const double xfov = numberIn(xmlSpans(mDae).value(), "xfov");
        QVERIFY2(std::abs(xfov - wide) < 1e-3, qPrintable(QString::number(xfov)));
        const Json view = mGltf["cameras"][0]["perspective"];
        QVERIFY(std::abs(view["aspectRatio"].get<double>() - 16.0 / 9) < 1e-5);
        const double high = 2 * std::atan(std::tan(wide * std::numbers::pi / 360) * 9 / 16);
        QVERIFY(std::abs(view["yfov"].get<double>() - high) < 1e-5);
    }

    void orthographicCameras()
    {
        FbxText file =
            withCamera(FbxText::property("CameraProjectionType", "1") + FbxText::property("OrthoZoom", "8"));
        QVERIFY(convert(file));
        QCOMPARE(mGltf["cameras"][0]["type"].get<std::string>(), std::string("orthographic"));
        QVERIFY(std::abs(mGltf["cameras"][0]["orthographic"]["xmag"].get<double>() - 4) < 1e-5);
        const XmlElement root = xmlSpans(mDae).value();
        QVERIFY(elements(root, "perspective").empty());
        QCOMPARE(elements(root, "orthographic").size(), 1U);
        QVERIFY(std::abs(numberIn(root, "xmag") - 4) < 1e-5);
        // And it is read again.
        QVERIFY(writeMesh(readMesh(at(u"f.dae"_s)).value(), at(u"again.glb"_s)).ok());
        const Json again = gltffiles::jsonOf(gltffiles::contentOf(at(u"again.glb"_s)));
        QVERIFY(std::abs(again["cameras"][0]["orthographic"]["xmag"].get<double>() - 4) < 1e-5);
    }

    //! Blender takes the strength of a light from nowhere else.
    void strengthsOfLightsInCollada()
    {
        FbxText file = withBox();
        file.model(3, "Sun", "Light", 0);
        file.attribute(4, "Light", 3,
                       FbxText::property("LightType", "1", "enum") +
                           FbxText::property("Intensity", "500", "Number") +
                           FbxText::property("Color", "1,0.5,0"));
        file.model(5, "Spot", "Light", 0);
        file.attribute(6, "Light", 5,
                       FbxText::property("LightType", "2", "enum") +
                           FbxText::property("Intensity", "3000", "Number") +
                           FbxText::property("OuterAngle", "60", "Number"));
        QVERIFY(convert(file));
        const XmlElement root = xmlSpans(mDae).value();
        const auto lights = elements(root, "light");
        QCOMPARE(lights.size(), 2U);
        QCOMPARE(numberIn(*lights[0], "type"), 1.0);
        QVERIFY(std::abs(numberIn(*lights[0], "energy") - 5) < 1e-5);
        QVERIFY(std::abs(numberIn(*lights[0], "green") - 0.5) < 1e-5);
        QCOMPARE(numberIn(*lights[1], "type"), 2.0);
        QVERIFY(std::abs(numberIn(*lights[1], "energy") - 30) < 1e-4);
        QVERIFY(std::abs(numberIn(*lights[1], "spotsize") - 60) < 1e-3);
        // From glTF, where it is in candela: 100 W are 683 * 100 / (4 pi).
        QVERIFY(writeMesh(readMesh(at(u"f.glb"_s)).value(), at(u"g.dae"_s)).ok());
        const std::string text = loadFile(at(u"g.dae"_s), 1 << 20)->toStdString();
        const XmlElement again = xmlSpans(text).value();
        QVERIFY(std::abs(numberIn(*elements(again, "light")[1], "energy") - 30) < 1e-3);
    }

    //! A model that turns around a pivot moves on an arc. Flat ones, which hide what is behind them, too.
    void motionsAroundPivots_data()
    {
        QTest::addColumn<QByteArray>("scaling");
        QTest::newRow("box") << QByteArray("1,1,1");
        QTest::newRow("flat") << QByteArray("1,1e-12,1");
    }

    void motionsAroundPivots()
    {
        QFETCH(QByteArray, scaling);
        FbxText file;
        // Assimp reads this one behind the other.
        file.add(5, "Model", "Beside", "Mesh",
                 "\t\tProperties70:  {\n" + FbxText::property("Lcl Translation", "0,0,700") + "\t\t}\n");
        file.box(6, 5);
        file.model(1, "Box", "Mesh", 0,
                   FbxText::property("RotationPivot", "100,0,0", "Vector3D") +
                       FbxText::property("Lcl Translation", "0,312.3456789,0") +
                       FbxText::property("RotationActive", "1") + FbxText::property("Lcl Scaling", scaling));
        file.box(2, 1);
        file.connect(5, 0);
        file.turn(1, 180);
        QVERIFY(convert(file));
        QVERIFY(!mLosses.contains(u"only FBX can hold"_s));
        QCOMPARE(mGltf["animations"].size(), 1U);
        const Scene dae = readMesh(at(u"f.dae"_s)).value();
        const aiScene &scene = assimpScene(dae);
        QCOMPARE(scene.mNumAnimations, 1U);
        const aiAnimation &animation = *scene.mAnimations[0];
        const aiNodeAnim &motion = *animation.mChannels[0];
        const aiNode *node = scene.mRootNode->FindNode(motion.mNodeName);
        Eigen::Matrix4d above = Eigen::Matrix4d::Identity();
        for (const aiNode *n = node->mParent; n; n = n->mParent)
            above = toEigen(n->mTransformation) * above;
        double deepest = 0;
        Vec3 last = Vec3::Zero();
        for (unsigned k = 0; k < motion.mNumPositionKeys; ++k) {
            const aiVector3D &key = motion.mPositionKeys[k].mValue;
            last = (above * Eigen::Vector4d(key.x, key.y, key.z, 1)).head<3>() - Vec3(0, 3.123456789, 0);
            QVERIFY(std::abs((last - Vec3(1, 0, 0)).norm() - 1) < 1e-4);
            deepest = std::min(deepest, last.y());
        }
        // In metres, with y up, from where it began.
        QVERIFY2((last - Vec3(2, 0, 0)).norm() < 1e-4,
                 qPrintable(QString::number(last.x()) + u' ' + QString::number(last.y())));
        QVERIFY(deepest < -0.99);
        const double end = motion.mPositionKeys[motion.mNumPositionKeys - 1].mTime;
        QVERIFY(std::abs(end / animation.mTicksPerSecond - 1) < 1e-3);
    }

    //! Objects of one kind that Assimp reads in another order keep their names, and with them the rest.
    void objectsInAnotherOrder()
    {
        FbxText file;
        int id = 1;
        for (const char *name : {"First", "Second"}) {
            file.add(id, "Model", name, "Mesh",
                     "\t\tProperties70:  {\n" +
                         FbxText::property("Lcl Translation", id == 1 ? "0,0,700" : "0,0,0") + "\t\t}\n");
            file.triangle(id + 1, id);
            id += 2;
        }
        file.connect(3, 0);
        file.connect(1, 0);
        QVERIFY(convert(file));
        for (const QString &format : {u"fbx"_s, u"glb"_s, u"dae"_s}) {
            const Scene scene = readMesh(at(u"f."_s + format)).value();
            const double metres = format == u"fbx"_s ? 0.01 : 1;
            for (int f = 0; f < scene.mesh->faceCount(); ++f) {
                const double z =
                    metres * scene.mesh->positions(scene.mesh->cornerVertex[scene.mesh->faceStart[f]], 2);
                QCOMPARE(scene.objectNames[static_cast<std::size_t>(scene.mesh->faceObject[f])],
                         z > 1 ? u"First"_s : u"Second"_s);
            }
        }
    }

    //! Blender turns objects that move only in files with z up.
    void movingObjectsInCollada()
    {
        FbxText file = withBox();
        QVERIFY(convert(file));
        QVERIFY(mDae.find("Y_UP") != std::string::npos);
        file.turn(1, 90);
        QVERIFY(convert(file));
        QVERIFY(mDae.find("Z_UP") != std::string::npos);
    }

    void bonesWithoutAMeshInGltf()
    {
        QVERIFY(convert(barebones()));
        QCOMPARE(mGltf["skins"].size(), 1U);
        const Json &skin = mGltf["skins"][0];
        std::vector<std::string> joints;
        for (const Json &joint : skin["joints"])
            joints.push_back(mGltf["nodes"][joint.get<std::size_t>()]["name"].get<std::string>());
        QCOMPARE(joints, (std::vector<std::string>{"root", "tip"}));
        QCOMPARE(mGltf["accessors"][skin["inverseBindMatrices"].get<std::size_t>()]["count"].get<int>(), 2);
        QVERIFY(!mGltf["meshes"].empty() && mGltf.dump().find("JOINTS_0") == std::string::npos);
        // The file is sound, and the box where it was.
        const Scene glb = readMesh(at(u"f.glb"_s)).value();
        QVERIFY((Vec3(glb.mesh->positions.colwise().mean()) - Vec3(1, 2, 3)).norm() < 1e-5);
    }

    //! What hangs on a bone is bound to it: Blender loses it otherwise.
    void bonesWithoutAMeshInCollada()
    {
        QVERIFY(convert(barebones()));
        const XmlElement root = xmlSpans(mDae).value();
        std::vector<std::string> joints;
        for (const XmlElement *node : elements(root, "node")) {
            if (node->attribute("type") == "JOINT")
                joints.emplace_back(node->attribute("name"));
        }
        QCOMPARE(joints, (std::vector<std::string>{"root", "tip"}));
        QCOMPARE(elements(root, "instance_controller").size(), 1U);
        const Scene dae = readMesh(at(u"f.dae"_s)).value();
        QCOMPARE(dae.objectNames, std::vector<QString>{u"Box"_s});
        QVERIFY((Vec3(dae.mesh->positions.colwise().mean()) - Vec3(1, 2, 3)).norm() < 1e-5);
        const aiMesh &mesh = *assimpScene(dae).mMeshes[0];
        for (unsigned b = 0; b < mesh.mNumBones; ++b)
            QCOMPARE(mesh.mBones[b]->mNumWeights > 0, mesh.mBones[b]->mName == aiString("tip"));
        // Nothing hangs on these.
        FbxText alone = withBox();
        alone.model(3, "root", "LimbNode", 0);
        alone.model(4, "tip", "LimbNode", 3);
        QVERIFY(convert(alone));
        const XmlElement bare = xmlSpans(mDae).value();
        int bones = 0;
        for (const XmlElement *node : elements(bare, "node"))
            bones += node->attribute("type") == "JOINT" && !node->attribute("sid").empty();
        QCOMPARE(bones, 2);
    }

    //! Assimp leaves places of them only.
    void whatHasNoFacesIsSaid()
    {
        FbxText file = withBox();
        QVERIFY(convert(file));
        QVERIFY(!mLosses.contains(u"curves"_s) && !mLosses.contains(u"stereo"_s));
        file.model(7, "Path", "NurbsCurve", 0);
        file.model(8, "Eyes", "CameraStereo", 0);
        QVERIFY(convert(file));
        QVERIFY(mLosses.contains(u"curves and NURBS surfaces are lost"_s));
        QVERIFY(mLosses.contains(u"stereo cameras are lost"_s));
    }

    //! They are shown with the sign for what cannot be read.
    void namesThatAreNoUtf8()
    {
        FbxText file;
        file.model(1, "B\xffx", "Mesh", 0);
        file.box(2, 1);
        QVERIFY(convert(file));
        const QString name = QString::fromStdString(mGltf["nodes"][0]["name"].get<std::string>());
        QCOMPARE(name, QString::fromUtf8("B\xffx"));
        QCOMPARE(QString::fromStdString(mDae).toStdString(), mDae);
        QVERIFY(readMesh(at(u"f.glb"_s)).ok() && readMesh(at(u"f.dae"_s)).ok());
    }

    //! From each of the formats that know bones to the others.
    void bonesWithoutAMeshStayBones()
    {
        FbxText alone = withBox();
        alone.model(3, "root", "LimbNode", 0);
        alone.model(4, "tip", "LimbNode", 3, FbxText::property("Lcl Translation", "0,200,0"));
        alone.model(5, "helper", "Null", 0);
        QVERIFY(convert(alone));
        for (const QString &from : {u"f.glb"_s, u"f.dae"_s}) {
            const Result<Scene> scene = readMesh(at(from));
            QVERIFY(scene.ok());
            QVERIFY(writeMesh(scene.value(), at(u"g.fbx"_s)) && writeMesh(scene.value(), at(u"g.glb"_s)));
            const FbxTree fbx =
                parseFbxTree(loadFile(at(u"g.fbx"_s), 1 << 20).value(), at(u"g.fbx"_s)).value();
            const FbxLinks links(fbx);
            std::set<std::string> limbs;
            for (const auto &[name, model] : links.modelsByName()) {
                if (links.kind(model) == "LimbNode")
                    limbs.insert(name);
            }
            QCOMPARE(limbs, (std::set<std::string>{"root", "tip"}));
            const Json gltf = gltffiles::jsonOf(gltffiles::contentOf(at(u"g.glb"_s)));
            QCOMPARE(gltf["skins"].size(), 1U);
            QCOMPARE(gltf["skins"][0]["joints"].size(), 2U);
            QVERIFY(gltf.dump().find("autocuts.limb") == std::string::npos);
        }
    }

    //! Clusters say where mesh and bone were; where they are now is something else.
    void placesOfBindingInCollada()
    {
        FbxText file;
        file.model(1, "Skin", "Mesh", 0, FbxText::property("Lcl Translation", "500,0,0"));
        file.box(2, 1);
        file.model(3, "bone", "LimbNode", 0, FbxText::property("Lcl Translation", "0,300,0"));
        file.bind(4, 2, 3, {}, Vec3(0, -200, 0), Vec3(0, 200, 0));
        QVERIFY(convert(file));
        const Scene dae = readMesh(at(u"f.dae"_s)).value();
        const aiMesh &mesh = *assimpScene(dae).mMeshes[0];
        QCOMPARE(mesh.mNumBones, 1U);
        const Eigen::Affine3d rest(toEigen(mesh.mBones[0]->mOffsetMatrix).inverse());
        // In metres, with z up.
        QVERIFY((rest.translation() - Vec3(0, 0, 2)).norm() < 1e-5);
    }

    void rulesOfFbxAreSaidToBeLost()
    {
        const auto skinned = [](const QByteArray &skinning, const QByteArray &rule,
                                const QByteArray &scaling) {
            FbxText file;
            file.model(1, "Skin", "Mesh", 0);
            file.box(2, 1);
            file.model(3, "bone", "LimbNode", 0, FbxText::property("Lcl Scaling", scaling));
            file.model(6, "tip", "LimbNode", 3, FbxText::property("InheritType", rule));
            file.bind(4, 2, 3, "\t\tSkinningType: \"" + skinning + "\"\n", Vec3::Zero(), Vec3::Zero());
            return file;
        };
        const auto saysDual = [this] { return mLosses.contains(u"dual quaternions"_s); };
        const auto saysRule = [this] { return mLosses.contains(u"another rule"_s); };
        QVERIFY(convert(skinned("Linear", "1", "1,2,1")));
        QVERIFY(!saysDual() && !saysRule());
        QVERIFY(convert(skinned("DualQuaternion", "2", "1,1,1")));
        QVERIFY(saysDual() && !saysRule());
        QVERIFY(convert(skinned("Blend", "2", "2,2,2")));
        QVERIFY(saysDual() && saysRule());
        QVERIFY(convert(skinned("Rigid", "0", "2,2,2")));
        QVERIFY(!saysDual() && !saysRule());
        QVERIFY(convert(skinned("Rigid", "0", "2,1,2")));
        QVERIFY(!saysDual() && saysRule());
        QVERIFY(!exportLosses(readMesh(at(u"f.fbx"_s)).value(), u"fbx"_s).join(u' ').contains(u"rule"_s));
    }

private:
    QString at(const QString &name) const { return mFolder->filePath(name); }

    static FbxText withBox()
    {
        FbxText file;
        file.model(1, "Box", "Mesh", 0);
        file.box(2, 1);
        return file;
    }

    static FbxText withCamera(const QByteArray &properties)
    {
        FbxText file = withBox();
        file.model(3, "Eye", "Camera", 0);
        file.attribute(4, "Camera", 3,
                       FbxText::property("AspectWidth", "960") + FbxText::property("AspectHeight", "540") +
                           properties);
        return file;
    }

    //! Writes f.fbx, f.glb and f.dae.
    bool convert(const FbxText &file)
    {
        if (!saveAtomically(at(u"f.fbx"_s), file.bytes()))
            return false;
        const Result<Scene> scene = readMesh(at(u"f.fbx"_s));
        if (!scene || !writeMesh(scene.value(), at(u"f.glb"_s)) || !writeMesh(scene.value(), at(u"f.dae"_s)))
            return false;
        mGltf = gltffiles::jsonOf(gltffiles::contentOf(at(u"f.glb"_s)));
        mDae = loadFile(at(u"f.dae"_s), 1 << 20)->toStdString();
        mLosses = exportLosses(scene.value(), u"dae"_s).join(u' ');
        return true;
    }

    std::unique_ptr<QTemporaryDir> mFolder;
    Json mGltf;
    std::string mDae;
    QString mLosses;
};

QTEST_GUILESS_MAIN(TestFbxConversions)

} // namespace tst_fbxconversions

#include "tst_fbxconversions.moc"
