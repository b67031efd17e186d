// From one format to another: units, axes, colours, pictures, cameras, lights, bones and names stay.
#include "model/document/materialcolor.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxsource.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "model/pictures/picturefiles.h"
#include "model/pictures/texturefiles.h"
#include "support/colladafiles.h"
#include "support/gltffiles.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tst_conversions {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::viewsDae;
using test::worldBox;

namespace {

const QByteArray texturedObj =
    "mtllib a.mtl\n"
    "o Left\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 3 0 0\nv 4 0 0\nv 4 2 1\nv 3 2 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl red\nf 1/1 2/2 3/3 4/4\n"
    "o Right\nusemtl painted\nf 5/1 6/2 7/3 8/4\n";
const QByteArray library = "newmtl red\nKd 1 0 0\nnewmtl painted\nKd 0.8 0.8 0.8\nmap_Kd tex.png\n";

//! A text FBX file of one quad from 0 0 0 to 100 200 300. \param settings of axes and unit
QByteArray quadFbx(const QByteArray &settings)
{
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: "
           "7400\n}\n"
           "GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n" +
           settings +
           "\t}\n}\nObjects:  {\n"
           "\tGeometry: 1, \"Geometry::\", \"Mesh\" {\n\t\tVertices: *12 {\n\t\t\ta: "
           "0,0,0,100,0,0,100,200,300,0,200,300\n"
           "\t\t}\n\t\tPolygonVertexIndex: *4 {\n\t\t\ta: 0,1,2,-4\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n"
           "\tModel: 2, \"Model::Quad\", \"Mesh\" {\n\t\tVersion: 232\n\t}\n}\n"
           "Connections:  {\n\tC: \"OO\",2,0\n\tC: \"OO\",1,2\n}\n";
}

QByteArray integerSetting(const char *name, int value)
{
    return QByteArray("\t\tP: \"") + name + "\", \"int\", \"Integer\", \"\"," + QByteArray::number(value) +
           '\n';
}

QJsonObject jsonOf(const QString &glb)
{
    const QByteArray bytes = loadFile(glb, 1 << 20).value();
    quint32 size = 0;
    memcpy(&size, bytes.constData() + 12, 4);
    return QJsonDocument::fromJson(bytes.mid(20, static_cast<qsizetype>(size))).object();
}

//! The Box of viewsDae() on a bone of a Rig. \param counts of weights of its vertices \param weights pairs of
//! a bone and a weight, each by number
QByteArray riggedDae(const QByteArray &counts, const QByteArray &weights)
{
    QByteArray dae = viewsDae();
    dae.replace(
        "<library_visual_scenes>",
        "<library_controllers><controller id=\"c\"><skin source=\"#g\"><bind_shape_matrix>1 0 0 0 0 1 0 "
        "0 0 0 1 0 0 0 0 1</bind_shape_matrix><source id=\"j\"><Name_array "
        "id=\"ja\" count=\"1\">B</Name_array><technique_common><accessor source=\"#ja\" "
        "count=\"1\"><param name=\"JOINT\" type=\"name\"/></accessor></technique_common></source>"
        "<source id=\"b\"><float_array id=\"ba\" count=\"16\">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
        "</float_array><technique_common><accessor source=\"#ba\" count=\"1\" stride=\"16\"><param "
        "name=\"TRANSFORM\" type=\"float4x4\"/></accessor>"
        "</technique_common></source><source id=\"w\"><float_array id=\"wa\" count=\"1\">1"
        "</float_array><technique_common><accessor source=\"#wa\" count=\"1\" stride=\"1\"><param "
        "name=\"WEIGHT\" type=\"float\"/></accessor></technique_common>"
        "</source><joints><input semantic=\"JOINT\" source=\"#j\"/><input "
        "semantic=\"INV_BIND_MATRIX\" source=\"#b\"/></joints><vertex_weights count=\"3\"><input "
        "semantic=\"JOINT\" source=\"#j\" offset=\"0\"/><input semantic=\"WEIGHT\" "
        "source=\"#w\" offset=\"1\"/><vcount>" +
            counts + "</vcount><v>" + weights +
            "</v></vertex_weights>"
            "</skin></controller></library_controllers><library_visual_scenes>");
    dae.replace("<node id=\"n1\" name=\"Box\"><instance_geometry url=\"#g\"/></node>",
                "<node id=\"a\" name=\"Rig\"><translate>0 0 700</translate><node id=\"bone\" sid=\"B\" "
                "name=\"Bone\" type=\"JOINT\"><translate>100 0 0</translate></node><node id=\"n1\" "
                "name=\"Box\"><instance_controller url=\"#c\"><skeleton>#bone</skeleton>"
                "</instance_controller></node></node>");
    return dae;
}

} // namespace

class TestConversions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mFolder = std::make_unique<QTemporaryDir>();
        QImage image(4, 4, QImage::Format_RGB32);
        image.fill(qRgb(0, 200, 0));
        QVERIFY(image.save(at(u"tex.png"_s)));
        QVERIFY(saveAtomically(at(u"a.mtl"_s), library).ok());
        QVERIFY(saveAtomically(at(u"a.obj"_s), texturedObj).ok());
    }

    void axesAndUnitsOfFbx_data()
    {
        QTest::addColumn<QByteArray>("settings");
        QTest::addColumn<double>("metres");
        QTest::addColumn<bool>("zUp");
        const QByteArray zUp = integerSetting("UpAxis", 2) + integerSetting("UpAxisSign", 1) +
                               integerSetting("FrontAxis", 1) + integerSetting("FrontAxisSign", -1) +
                               integerSetting("CoordAxis", 0) + integerSetting("CoordAxisSign", 1);
        const QByteArray inches = "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\",2.54\n";
        QTest::newRow("nothing said") << QByteArray() << 0.01 << false;
        QTest::newRow("z up") << zUp << 0.01 << true;
        QTest::newRow("inches") << inches << 0.0254 << false;
        QTest::newRow("inches, z up") << inches + zUp << 0.0254 << true;
        QTest::newRow("one axis twice") << integerSetting("UpAxis", 0) << 0.01 << false;
    }
    void axesAndUnitsOfFbx()
    {
        QFETCH(QByteArray, settings);
        QFETCH(double, metres);
        QFETCH(bool, zUp);
        QVERIFY(saveAtomically(at(u"q.fbx"_s), quadFbx(settings)).ok());
        const Result<Scene> scene = readMesh(at(u"q.fbx"_s));
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        const Vec3 low = zUp ? Vec3(0, 0, -200) : Vec3(0, 0, 0);
        const Vec3 high = zUp ? Vec3(100, 300, 0) : Vec3(100, 200, 300);
        QCOMPARE(Vec3(scene->mesh->positions.colwise().minCoeff().transpose()), low);
        QCOMPARE(Vec3(scene->mesh->positions.colwise().maxCoeff().transpose()), high);
        for (const QString &format : {u"glb"_s, u"dae"_s, u"obj"_s, u"ply"_s}) {
            QVERIFY(writeMesh(scene.value(), at(u"b."_s + format)).ok());
            const Result<Scene> again = readMesh(at(u"b."_s + format));
            QVERIFY(again.ok());
            const auto [lowAgain, highAgain] = worldBox(again.value());
            QVERIFY2((lowAgain - metres * low).norm() < 1e-5 && (highAgain - metres * high).norm() < 1e-5,
                     qPrintable(format));
        }
        // The file itself keeps its coordinates.
        QVERIFY(writeMesh(scene.value(), at(u"b.fbx"_s)).ok());
        QCOMPARE(loadFile(at(u"b.fbx"_s), 1 << 20).value(), quadFbx(settings));
    }

    void everythingBecomesBinaryFbxOfTheSameSize()
    {
        Scene obj = readMesh(at(u"a.obj"_s)).value();
        for (const QString &format : {u"glb"_s, u"dae"_s, u"ply"_s})
            QVERIFY(writeMesh(obj, at(u"a."_s + format)).ok());
        for (const QString &format : {u"obj"_s, u"glb"_s, u"dae"_s, u"ply"_s}) {
            const Result<Scene> scene = readMesh(at(u"a."_s + format));
            QVERIFY(writeMesh(scene.value(), at(u"b.fbx"_s)).ok());
            QVERIFY(loadFile(at(u"b.fbx"_s), 1 << 20)->startsWith("Kaydara FBX Binary"));
            const Result<Scene> again = readMesh(at(u"b.fbx"_s));
            QVERIFY2(again.ok(), qPrintable(format));
            QCOMPARE(unitsOf(again.value()).metres, 1.0);
            const auto [low, high] = worldBox(again.value());
            QVERIFY2((low - Vec3(0, 0, 0)).norm() < 1e-6 && (high - Vec3(4, 2, 1)).norm() < 1e-6,
                     qPrintable(format));
            QCOMPARE(again->mesh->report.weldedVertices, 0);
        }
    }

    void coloursAndPicturesStay_data()
    {
        QTest::addColumn<QString>("format");
        for (const char *format : {"glb", "gltf", "dae", "fbx", "obj"})
            QTest::newRow(format) << QString::fromLatin1(format);
    }
    void coloursAndPicturesStay()
    {
        QFETCH(QString, format);
        // Over a glb, so that each format is written from another one, with a picture inside of the file.
        QVERIFY(writeMesh(readMesh(at(u"a.obj"_s)).value(), at(u"inside.glb"_s)).ok());
        QVERIFY(QDir(mFolder->path()).mkdir(u"out"_s));
        for (const QString &from : {u"a.obj"_s, u"inside.glb"_s}) {
            if (from.endsWith(format) || (format == u"gltf"_s && from != u"a.obj"_s))
                continue;
            const QString path = at(u"out/b."_s + format);
            const Scene scene = readMesh(at(from)).value();
            QVERIFY(writeMesh(scene, path).ok());
            const Result<Scene> again = readMesh(path);
            QVERIFY(again.ok());
            const int red = again->faceMaterial.front(), painted = again->faceMaterial.back();
            QCOMPARE(again->materialNames[static_cast<std::size_t>(red)], u"red"_s);
            QCOMPARE(again->materialNames[static_cast<std::size_t>(painted)], u"painted"_s);
            const QRgb color = again->materialColors[static_cast<std::size_t>(red)];
            QCOMPARE(color, qRgb(255, 0, 0));
            const SceneTexture picture = again->fileSet(painted)[TextureChannel::BaseColor].picture;
            const QByteArray bytes = !picture.content.isEmpty()
                                         ? picture.content
                                         : loadFile(findTexture(picture.file, path), 1 << 20).value();
            QCOMPARE(QImage::fromData(bytes).pixel(0, 0), qRgb(0, 200, 0));
            QVERIFY(again->fileSet(red)[TextureChannel::BaseColor].picture.isEmpty());
            QCOMPARE(again->objectNames, (std::vector<QString>{u"Left"_s, u"Right"_s}));
        }
    }

    //! What FBX and Collada say beside a picture is not multiplied by it, as it is in glTF.
    void picturesReplaceColours()
    {
        QVERIFY(saveAtomically(at(u"a.mtl"_s), QByteArray(library).replace("0.8 0.8 0.8", "0.5 0.5 1")).ok());
        QVERIFY(writeMesh(readMesh(at(u"a.obj"_s)).value(), at(u"a.fbx"_s)).ok());
        QVERIFY(writeMesh(readMesh(at(u"a.fbx"_s)).value(), at(u"a.glb"_s)).ok());
        const Json json = gltffiles::jsonOf(loadFile(at(u"a.glb"_s), 1 << 20).value());
        for (const Json &material : json["materials"]) {
            const Json &color = material["pbrMetallicRoughness"]["baseColorFactor"];
            QVERIFY(color == (material["name"] == "painted" ? Json({1, 1, 1, 1}) : Json({1, 0, 0, 1})));
        }
    }

    //! A library that is not ours is never replaced.
    void materialLibraryOfSomebodyElse()
    {
        QVERIFY(writeMesh(readMesh(at(u"a.obj"_s)).value(), at(u"a.glb"_s)).ok());
        const Scene glb = readMesh(at(u"a.glb"_s)).value();
        QVERIFY(saveAtomically(at(u"c.mtl"_s), "newmtl mine\n").ok());
        for (int time = 0; time < 2; ++time) {
            QVERIFY(writeMesh(glb, at(u"c.obj"_s)).ok());
            QCOMPARE(loadFile(at(u"c.mtl"_s), 1000).value(), QByteArray("newmtl mine\n"));
            QVERIFY(loadFile(at(u"c.obj"_s), 1 << 20)->startsWith("mtllib c-2.mtl\n"));
        }
    }

    void camerasAndLightsStay()
    {
        QVERIFY(saveAtomically(at(u"v.dae"_s), viewsDae()).ok());
        const Result<Scene> scene = readMesh(at(u"v.dae"_s));
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        QVERIFY(writeMesh(scene.value(), at(u"v.glb"_s)).ok());
        const QJsonObject json = jsonOf(at(u"v.glb"_s));
        const QJsonObject camera = json[u"cameras"_s].toArray().at(0).toObject()[u"perspective"_s].toObject();
        const double yfov = camera[u"yfov"_s].toDouble();
        // The file is in centimetres.
        QVERIFY(std::abs(camera[u"znear"_s].toDouble() - 0.01) < 1e-6);
        QVERIFY(std::abs(camera[u"zfar"_s].toDouble() - 5) < 1e-4);
        const QJsonObject light =
            json[u"extensions"_s][u"KHR_lights_punctual"_s][u"lights"_s].toArray().at(0).toObject();
        QCOMPARE(light[u"type"_s].toString(), u"spot"_s);
        QCOMPARE(light[u"color"_s].toArray().at(1).toDouble(), 0.5);
        int placed = 0;
        for (const QJsonValue &node : json[u"nodes"_s].toArray())
            placed += node[u"camera"_s].isDouble() + node[u"extensions"_s].isObject();
        QCOMPARE(placed, 2);

        QVERIFY(writeMesh(scene.value(), at(u"v.fbx"_s)).ok());
        const Scene fbx = readMesh(at(u"v.fbx"_s)).value();
        QVERIFY(sourceOf<FbxSource>(fbx)->contents.lightsOrCameras);
        const auto [low, high] = worldBox(fbx);
        QVERIFY((high - Vec3(1, 3, 0)).norm() < 1e-6 && low.norm() < 1e-6);
        // Assimp, which reads FBX for other formats, finds them again where they were.
        QVERIFY(writeMesh(fbx, at(u"w.glb"_s)).ok());
        const QJsonArray cameras = jsonOf(at(u"w.glb"_s))[u"cameras"_s].toArray();
        QCOMPARE(cameras.size(), 1);
        QVERIFY(std::abs(cameras.at(0)[u"perspective"_s][u"yfov"_s].toDouble() - yfov) < 1e-4);
        const QJsonArray lights =
            jsonOf(at(u"w.glb"_s))[u"extensions"_s][u"KHR_lights_punctual"_s][u"lights"_s].toArray();
        QCOMPARE(lights.at(0)[u"type"_s].toString(), u"spot"_s);
    }

    //! Assimp puts cameras of glTF files at the place of their node once more, multiplies angles, and ends
    //! the program at nodes with extensions.
    void viewsOfGltf()
    {
        gltffiles::FileBuilder file = gltffiles::grid();
        file.json["cameras"] = {
            {{"type", "perspective"},
             {"perspective", {{"aspectRatio", 1.75}, {"yfov", 0.3}, {"znear", 0.1}, {"zfar", 100}}}}};
        file.json["extensionsUsed"] = {"KHR_lights_punctual"};
        const Json lamp{{"type", "point"}, {"intensity", 100}};
        file.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({lamp});
        file.json["nodes"].push_back({{"name", "Eye"}, {"camera", 0}, {"translation", {5, 6, 7}}});
        file.json["nodes"].push_back(
            {{"name", "Lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
        const std::size_t count = file.json["nodes"].size();
        file.json["scenes"][0]["nodes"].push_back(count - 2);
        file.json["scenes"][0]["nodes"].push_back(count - 1);
        QVERIFY(saveAtomically(at(u"v.glb"_s), file.glb()).ok());
        const Scene scene = readMesh(at(u"v.glb"_s)).value();

        QVERIFY(writeMesh(scene, at(u"v.dae"_s)).ok());
        const QByteArray dae = loadFile(at(u"v.dae"_s), 1 << 20).value();
        const qsizetype wide = dae.indexOf("<xfov");
        const double xfov = dae.mid(dae.indexOf('>', wide) + 1, 8).split('<').at(0).toDouble();
        QVERIFY(std::abs(xfov * M_PI / 180 - 2 * std::atan(std::tan(0.15) * 1.75)) < 1e-4);

        QVERIFY(writeMesh(scene, at(u"v.fbx"_s)).ok());
        QVERIFY(writeMesh(readMesh(at(u"v.fbx"_s)).value(), at(u"w.glb"_s)).ok());
        const QJsonObject json = jsonOf(at(u"w.glb"_s));
        const QJsonObject view = json[u"cameras"_s].toArray().at(0)[u"perspective"_s].toObject();
        QVERIFY(std::abs(view[u"yfov"_s].toDouble() - 0.3) < 1e-4);
        QVERIFY(std::abs(view[u"znear"_s].toDouble() - 0.1) < 1e-6);
        for (const QJsonValue &node : json[u"nodes"_s].toArray()) {
            if (!node[u"camera"_s].isDouble())
                continue;
            const QJsonArray matrix = node[u"matrix"_s].toArray(), moved = node[u"translation"_s].toArray();
            for (int k = 0; k < 3; ++k)
                QVERIFY(std::abs((moved.isEmpty() ? matrix.at(12 + k) : moved.at(k)).toDouble() - 5 - k) <
                        1e-4);
        }
    }

    //! Assimp knows nodes by their ids, and takes degrees for radians where only the height of a view is
    //! said.
    void namesAndViewsOfCollada()
    {
        QByteArray dae = viewsDae();
        dae.replace("name=\"Eye\"", "name=\"K&#xFC;che &amp; Eye\"");
        // An animation that is called like a node.
        dae.replace("<library_visual_scenes>",
                    "<library_animations><animation name=\"Box\"><source id=\"t\"><float_array id=\"ta\" "
                    "count=\"2\">0 1</float_array><technique_common><accessor source=\"#ta\" count=\"2\"/>"
                    "</technique_common></source><source id=\"o\"><float_array id=\"oa\" count=\"6\">0 0 0 "
                    "100 0 0</float_array><technique_common><accessor source=\"#oa\" count=\"2\" "
                    "stride=\"3\"/></technique_common></source><sampler id=\"m\"><input semantic=\"INPUT\" "
                    "source=\"#t\"/><input semantic=\"OUTPUT\" source=\"#o\"/></sampler><channel "
                    "source=\"#m\" target=\"n1/move\"/></animation></library_animations>"
                    "<library_visual_scenes>");
        dae.replace("name=\"Box\"><instance_geometry",
                    "name=\"Box\"><translate sid=\"move\">0 0 0</translate><instance_geometry");
        QVERIFY(saveAtomically(at(u"v.dae"_s), dae).ok());
        const Result<Scene> scene = readMesh(at(u"v.dae"_s));
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        QCOMPARE(scene->objectNames, std::vector<QString>{u"Box"_s});
        QVERIFY(writeMesh(scene.value(), at(u"v.glb"_s)).ok());
        const QJsonObject json = jsonOf(at(u"v.glb"_s));
        QStringList names;
        for (const QJsonValue &node : json[u"nodes"_s].toArray())
            names << node[u"name"_s].toString();
        names.sort();
        // Nothing else: the root that Assimp makes up for axes and unit is no object.
        QCOMPARE(names, (QStringList{u"Box"_s, u"Küche & Eye"_s, u"Lamp"_s}));
        const QJsonValue camera = json[u"cameras"_s].toArray().at(0);
        QVERIFY(std::abs(camera[u"perspective"_s][u"yfov"_s].toDouble() - 40 * M_PI / 180) < 1e-5);
        const QJsonArray animations = json[u"animations"_s].toArray();
        QCOMPARE(animations.size(), 1);
        QCOMPARE(animations.at(0)[u"name"_s].toString(), u"Box"_s);
        const auto [low, high] = worldBox(readMesh(at(u"v.glb"_s)).value());
        QVERIFY((high - Vec3(1, 3, 0)).norm() < 1e-6 && low.norm() < 1e-6);
    }

    //! In FBX files each bone says where its armature is, or programs put the mesh elsewhere.
    void armaturesInFbx()
    {
        const QByteArray dae = riggedDae("1 1 1", "0 0 0 0 0 0");
        QVERIFY(saveAtomically(at(u"r.dae"_s), dae).ok());
        const Result<Scene> scene = readMesh(at(u"r.dae"_s));
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        QVERIFY(writeMesh(scene.value(), at(u"r.fbx"_s)).ok());
        const Result<FbxTree> tree = parseFbxTree(loadFile(at(u"r.fbx"_s), 1 << 20).value(), at(u"r.fbx"_s));
        QVERIFY(tree.ok());
        int clusters = 0;
        const int objects = tree->child(0, "Objects");
        for (int node = tree->child(objects, "Deformer"); node >= 0; node = tree->nextNamed(node)) {
            const int armature = tree->child(node, "TransformAssociateModel");
            if (tree->child(node, "TransformLink") < 0)
                continue;
            ++clusters;
            const std::optional<std::vector<double>> matrix = tree->doubles(armature);
            QVERIFY(armature >= 0 && matrix && matrix->size() == 16);
            // Seven metres up, which is y.
            QVERIFY((Vec3((*matrix)[12], (*matrix)[13], (*matrix)[14]) - Vec3(0, 7, 0)).norm() < 1e-6);
        }
        QCOMPARE(clusters, 1);
        // Collada has no such node: there the mesh lies where it was bound, which the bone knows, in
        // the coordinates of the file, with z up.
        const Scene fbx = readMesh(at(u"r.fbx"_s)).value();
        QVERIFY(writeMesh(fbx, at(u"s.dae"_s)).ok());
        const QString text = QString::fromUtf8(loadFile(at(u"s.dae"_s), 1 << 20).value());
        const QRegularExpressionMatch array =
            QRegularExpression(u"<float_array id=\"[^\"]*positions-array\"[^>]*>([^<]*)<"_s).match(text);
        QVERIFY(array.hasMatch());
        const QStringList numbers = array.captured(1).split(u' ', Qt::SkipEmptyParts);
        QCOMPARE(numbers.size(), 9);
        Vec3 least = Vec3::Constant(1e9);
        for (int i = 0; i < 9; ++i)
            least[i % 3] = std::min(least[i % 3], numbers[i].toDouble());
        QVERIFY((least - Vec3(1, 0, 7)).norm() < 1e-5);
        const Result<Scene> again = readMesh(at(u"s.dae"_s));
        QVERIFY(again.ok());
        QVERIFY((worldBox(again.value()).first - worldBox(fbx).first).norm() < 1e-5);
    }

    //! glTF files do not say where vertices without weights are: they get a bone that stays with the mesh.
    void verticesWithoutWeightsInGltf()
    {
        QVERIFY(saveAtomically(at(u"w.dae"_s), riggedDae("1 1 0", "0 0 0 0")).ok());
        const Result<Scene> scene = readMesh(at(u"w.dae"_s));
        QVERIFY(scene.ok());
        QVERIFY(writeMesh(scene.value(), at(u"w.glb"_s)).ok());
        GltfFile file{loadFile(at(u"w.glb"_s), 1 << 20).value(), {}};
        const GltfDocument document = openGltf(file);
        const Json &json = document.json;
        const Json &skin = json["skins"][0];
        QCOMPARE(skin["joints"].size(), std::size_t(2));
        const auto numbers = [&](const Json &accessor, int components) {
            const Json &view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
            const auto start = view.value("byteOffset", 0) + accessor.value("byteOffset", 0);
            std::vector<float> values(accessor["count"].get<std::size_t>() * std::size_t(components));
            std::memcpy(values.data(), document.buffers[0].constData() + start,
                        values.size() * sizeof(float));
            return values;
        };
        const Json &attributes = json["meshes"][0]["primitives"][0]["attributes"];
        const std::vector<float> weights =
            numbers(json["accessors"][attributes["WEIGHTS_0"].get<std::size_t>()], 4);
        for (std::size_t v = 0; v < weights.size(); v += 4)
            QCOMPARE(weights[v] + weights[v + 1] + weights[v + 2] + weights[v + 3], 1.0F);
        // Where the new bone puts them is where the mesh's node is: 7 units up, without that of the bone.
        const auto matrices = numbers(json["accessors"][skin["inverseBindMatrices"].get<std::size_t>()], 16);
        int rests = 0;
        for (std::size_t joint = 0; joint < 2; ++joint) {
            const Json &node = json["nodes"][skin["joints"][joint].get<std::size_t>()];
            if (!node["name"].get<std::string>().ends_with(".rest"))
                continue;
            ++rests;
            const Eigen::Map<const Eigen::Matrix4f> bind(matrices.data() + 16 * joint);
            QVERIFY(bind.isIdentity(1e-6F));
            QVERIFY(!node.contains("matrix")); // the mesh is a child of the rig, and so is the bone
        }
        QCOMPARE(rests, 1);
    }

    //! Pictures that glTF cannot hold become others, whatever their name is needed for.
    void targaPicturesInGltf()
    {
        Picture green(4, 4, 3, 0);
        for (std::size_t i = 1; i < green.values.size(); i += 3)
            green.values[i] = 1;
        QVERIFY(writePicture(green, at(u"tex.tga"_s), PictureDepth::Eight).ok());
        QVERIFY(saveAtomically(at(u"a.mtl"_s), QByteArray(library).replace("tex.png", "tex.tga")).ok());
        QVERIFY(writeMesh(readMesh(at(u"a.obj"_s)).value(), at(u"t.glb"_s)).ok());
        const Scene again = readMesh(at(u"t.glb"_s)).value();
        const QByteArray bytes =
            again.fileSet(again.faceMaterial.back())[TextureChannel::BaseColor].picture.content;
        QCOMPARE(QImage::fromData(bytes).pixel(0, 0), qRgb(0, 255, 0));
        QVERIFY(bytes.startsWith("\x89PNG"));
    }

    //! "Cube" and "Cube.001" begin alike, and z is up.
    void objectsOfBlendFiles()
    {
        const QString path = u"/usr/share/assimp/models/BLEND/CubeHierarchy_248.blend"_s;
        if (!QFile::exists(path))
            QSKIP("Debian's package assimp-testmodels is not there");
        const Result<Scene> scene = readMesh(path);
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        std::vector<QString> names = scene->objectNames;
        std::sort(names.begin(), names.end());
        const std::vector<QString> expected{u"Cube"_s,     u"Cube.001"_s, u"Cube.002"_s, u"Cube.003"_s,
                                            u"Cube.004"_s, u"Cube.005"_s, u"Cube.006"_s, u"Cube.007"_s,
                                            u"Cube.008"_s, u"Cube1"_s,    u"Plane"_s};
        QCOMPARE(names, expected);
        // The plane lies below, the cubes are piled up over it.
        const auto [low, high] = worldBox(scene.value());
        QVERIFY(std::abs(low.y() + 0.784) < 1e-3 && std::abs(high.y() - 12.0002) < 1e-3);
    }

    //! Two objects share a mesh: the figures of their maps are those of the file, which has one map.
    void objectsThatShareAMeshHaveOneMapInTheFile()
    {
        QByteArray fbx = quadFbx({});
        fbx.replace("Connections:  {\n", "Connections:  {\n\tC: \"OO\",3,0\n\tC: \"OO\",1,3\n");
        fbx.replace("\tModel: 2,",
                    "\tModel: 3, \"Model::Twin\", \"Mesh\" {\n\t\tVersion: 232\n\t}\n\tModel: 2,");
        QVERIFY(saveAtomically(at(u"q.fbx"_s), fbx).ok());
        Scene scene = readMesh(at(u"q.fbx"_s)).value();
        QCOMPARE(scene.mesh->faceCount(), 2);
        UvMatrix uv(8, 2);
        uv << 0, 0, 0.4, 0, 0.4, 0.4, 0, 0.4, 0.5, 0, 0.9, 0, 0.9, 0.4, 0.5, 0.4;
        scene.uvSets = {{u"UVMap"_s, uv}};
        QVERIFY(writeMesh(scene, at(u"r.fbx"_s)).ok());
        const Scene file = readMesh(at(u"r.fbx"_s)).value();
        const Scene said = asWritten(scene, u"fbx"_s);
        QCOMPARE(said.uvSets[0].uv, file.uvSets[0].uv);
        QCOMPARE(UvMatrix(said.uvSets[0].uv.topRows(4)), UvMatrix(said.uvSets[0].uv.bottomRows(4)));
        QCOMPARE(asWritten(scene, u"obj"_s).uvSets[0].uv, uv);
        const std::vector<IslandFlags> flags = withInstanceStacks(said, {});
        QCOMPARE(flags.size(), std::size_t(2));
        QVERIFY(flags[0].stack > 0);
        QCOMPARE(flags[0].stack, flags[1].stack);
        QVERIFY(withInstanceStacks(readMesh(at(u"a.obj"_s)).value(), {}).empty());
    }

    void namesOfUvSetsInGltf()
    {
        Scene scene = readMesh(at(u"a.obj"_s)).value();
        scene.uvSets.push_back({u"Lightmap"_s, 0.5 * scene.uvSets[0].uv});
        QVERIFY(writeMesh(scene, at(u"n.glb"_s)).ok());
        Scene again = readMesh(at(u"n.glb"_s)).value();
        QCOMPARE(again.uvSets.size(), std::size_t(2));
        QCOMPARE(again.uvSets[1].name, u"Lightmap"_s);
        // Nothing changes: the same bytes.
        QVERIFY(writeMesh(again, at(u"m.glb"_s)).ok());
        QCOMPARE(loadFile(at(u"m.glb"_s), 1 << 20).value(), loadFile(at(u"n.glb"_s), 1 << 20).value());
        again.uvSets.push_back({u"Third one"_s, 2 * again.uvSets[0].uv});
        QVERIFY(writeMesh(again, at(u"m.glb"_s)).ok());
        const Scene third = readMesh(at(u"m.glb"_s)).value();
        QCOMPARE(third.uvSets[1].name, u"Lightmap"_s);
        QCOMPARE(third.uvSets[2].name, u"Third one"_s);
    }

    //! From each of the formats that name them to each other one.
    void namesOfUvSetsStay()
    {
        const std::vector<QString> names{u"Skin & <Bones>"_s, u"\"Light\" möp"_s};
        Scene scene = readMesh(at(u"a.obj"_s)).value();
        scene.uvSets = {{names[0], scene.uvSets[0].uv}, {names[1], 0.5 * scene.uvSets[0].uv}};
        for (const QString &from : {u"dae"_s, u"fbx"_s, u"glb"_s}) {
            QVERIFY(writeMesh(scene, at(u"from."_s + from)).ok());
            for (const QString &to : {u"dae"_s, u"fbx"_s, u"glb"_s}) {
                const Scene source = readMesh(at(u"from."_s + from)).value();
                QVERIFY(writeMesh(source, at(u"to."_s + to)).ok());
                const Scene again = readMesh(at(u"to."_s + to)).value();
                QCOMPARE(again.uvSets.size(), std::size_t(2));
                for (std::size_t set = 0; set < 2; ++set)
                    QVERIFY2(again.uvSets[set].name == names[set], qPrintable(from + u" to "_s + to));
            }
        }
    }

    //! Pictures carried over to a new UV set: the file has them, and its material names the set.
    void newPicturesInGltf()
    {
        QVERIFY(writeMesh(readMesh(at(u"a.obj"_s)).value(), at(u"p.glb"_s)).ok());
        Scene scene = readMesh(at(u"p.glb"_s)).value();
        QImage image(2, 2, QImage::Format_RGB32);
        image.fill(qRgb(9, 8, 7));
        QVERIFY(image.save(at(u"tex_uv2.png"_s)));
        scene.uvSets.insert(scene.uvSets.begin(), {u"Second"_s, 0.5 * scene.uvSets[0].uv});
        std::vector<TextureSet> sets(3);
        sets[2][TextureChannel::BaseColor].picture = {at(u"tex_uv2.png"_s), {}};
        const Scene chosen = withChosenTextures(scene, sets);
        QVERIFY(writeMesh(chosen, at(u"q.glb"_s)).ok());
        const Scene again = readMesh(at(u"q.glb"_s)).value();
        const QByteArray bytes =
            again.fileSet(again.faceMaterial.back())[TextureChannel::BaseColor].picture.content;
        QCOMPARE(QImage::fromData(bytes).pixel(0, 0), qRgb(9, 8, 7));
        const QJsonObject material = jsonOf(at(u"q.glb"_s))[u"materials"_s].toArray().at(1).toObject();
        QCOMPARE(material[u"pbrMetallicRoughness"_s][u"baseColorTexture"_s][u"texCoord"_s].toInt(), 1);
        QCOMPARE(again.uvSets[1].name, u"Second"_s);
    }

private:
    QString at(const QString &name) const { return mFolder->filePath(name); }

    std::unique_ptr<QTemporaryDir> mFolder;
};

QTEST_GUILESS_MAIN(TestConversions)

} // namespace tst_conversions

#include "tst_conversions.moc"
