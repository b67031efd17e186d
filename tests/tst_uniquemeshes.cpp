// Objects that share a mesh in the file get one each: in FBX, glTF and Collada files and in sessions.
#include "commands/makeunique.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "support/editsupport.h"
#include "support/fbxfiles.h"
#include "support/gltffiles.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <set>

namespace tst_uniquemeshes {

using namespace autocuts;
using namespace autocuts::test;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Three objects with one mesh, the last one mirrored, and one with a mesh of its own.
QByteArray fbx(const fbxfiles::Kind &kind)
{
    const auto mesh = [] {
        return fbxfiles::quads({fbxfiles::uvElement(0, "UVMap"), fbxfiles::layer(0, {0})});
    };
    return fbxfiles::model(kind,
                           {{"One", mesh()},
                            {"Two", {}, {fbxfiles::property(kind, "Lcl Translation", {9, 0, 0})}},
                            {"Three", {}, {fbxfiles::property(kind, "Lcl Scaling", {-1, 1, 1})}},
                            {"Other", mesh(), {fbxfiles::property(kind, "Lcl Translation", {0, 9, 0})}}});
}

//! Two geometries in three nodes; one node is in another, and stands behind it in the text.
const QByteArray collada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="urn:collada" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="Quad"><mesh>
<source id="g-p"><float_array id="g-pa" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array><technique_common>
<accessor source="#g-pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<source id="g-u"><float_array id="g-ua" count="8">0 0 .5 0 .5 .5 0 .5</float_array><technique_common>
<accessor source="#g-ua" count="4" stride="2"><param name="S" type="float"/><param name="T" type="float"/>
</accessor></technique_common></source>
<vertices id="g-v"><input semantic="POSITION" source="#g-p"/></vertices>
<polylist count="1"><input semantic="VERTEX" source="#g-v" offset="0"/>
<input semantic="TEXCOORD" source="#g-u" offset="1" set="0"/><vcount>4</vcount><p>0 0 1 1 2 2 3 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">
<node id="a" name="One"><node id="b" name="Two"><translate>3 0 0</translate><instance_geometry url='#g'/></node>
<instance_geometry url="#g"/></node>
<node id="c" name="Three"><scale>-1 2 1</scale><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";

//! Another UV at each corner.
UvMatrix newUv(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) << static_cast<float>(std::abs(std::sin(c))), static_cast<float>(std::abs(std::cos(3 * c)));
    return uv;
}

bool sameMap(const Scene &a, const Scene &b)
{
    return a.uvSets[0].uv.rows() == b.uvSets[0].uv.rows() &&
           (a.uvSets[0].uv - b.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-5;
}

} // namespace

class TestUniqueMeshes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void files_data()
    {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char *name, const fbxfiles::Kind &kind) {
            QTest::newRow(name) << u"fbx"_s << fbx(kind);
        };
        row("binary FBX", {});
        row("binary FBX with long heads", {true, 7500});
        row("binary FBX of other byte order", {true, 7400, true});
        row("FBX as text", {false});
        row("FBX as text with DOS lines", {false, 7400, false, false, "\r\n"});
        QTest::newRow("glb") << u"glb"_s << gltffiles::instanced().glb();
        QTest::newRow("gltf") << u"gltf"_s << gltffiles::instanced().text();
        QTest::newRow("Collada") << u"dae"_s << collada;
    }
    void files()
    {
        QFETCH(QString, suffix);
        QFETCH(QByteArray, bytes);
        const QString in = mFolder.filePath(u"in."_s + suffix), out = mFolder.filePath(u"out."_s + suffix);
        QVERIFY(saveAtomically(in, bytes).ok());
        Scene scene = readMesh(in).value();
        QVERIFY(hasSharedMeshes(scene));
        scene.uvSets[0].uv = newUv(*scene.mesh);

        // One map for all of them, as the figures say.
        QVERIFY(writeMesh(scene, out).ok());
        const Scene shared = readMesh(out).value();
        QVERIFY(!sameMap(shared, scene));
        QVERIFY(sameMap(shared, asWritten(scene, suffix)));
        QVERIFY(!withInstanceStacks(scene, {}).empty());
        QVERIFY(exportLosses(scene, suffix).join(u' ').contains("unique"_L1));

        scene.uniqueMeshes = true;
        QVERIFY(writeMesh(scene, out).ok());
        const Scene unique = readMesh(out).value();
        QVERIFY(sameMap(unique, scene));
        QVERIFY(sameMap(unique, asWritten(scene, suffix)));
        QVERIFY(withInstanceStacks(scene, {}).empty());
        QVERIFY(!exportLosses(scene, suffix).join(u' ').contains("unique"_L1));
        QVERIFY(!hasSharedMeshes(unique));
        QCOMPARE(unique.objectNames, scene.objectNames);
        QCOMPARE(unique.materialNames, scene.materialNames);
        for (int c = 0; c < scene.mesh->cornerCount(); ++c)
            QCOMPARE(Vec3(unique.mesh->positions.row(unique.mesh->cornerVertex[c])),
                     Vec3(scene.mesh->positions.row(scene.mesh->cornerVertex[c])));
        // Each of them can be changed and written again.
        Scene again = unique;
        again.uvSets[0].uv.col(0) *= 0.5;
        QVERIFY(writeMesh(again, out).ok());
        QVERIFY(sameMap(readMesh(out).value(), again));
    }

    //! A copy has the vertices that it needs, not those of all copies.
    void copiesInGltfAreSmall()
    {
        Scene scene = gltffiles::parsed(gltffiles::instanced().glb());
        scene.uvSets[0].uv = newUv(*scene.mesh);
        scene.uniqueMeshes = true;
        const QString out = mFolder.filePath(u"small.glb"_s);
        QVERIFY(writeMesh(scene, out).ok());
        const Json json = gltffiles::jsonOf(gltffiles::contentOf(out));
        QCOMPARE(json["meshes"].size(), std::size_t(2));
        for (const Json &mesh : json["meshes"]) {
            const auto accessor = mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
            QCOMPARE(json["accessors"][accessor]["count"].get<int>(), 96); // three of each of 32 triangles
        }
    }

    //! UVs of a document are those on the texture, not those of the file.
    void figuresOfATextureThatIsNotSquare()
    {
        const QString in = mFolder.filePath(u"wide.fbx"_s), out = mFolder.filePath(u"wider.fbx"_s);
        constexpr double height = 0.5;
        QVERIFY(saveAtomically(in, fbx({})).ok());
        Scene scene = readMesh(in, nullptr, height).value();
        const int corners = scene.mesh->cornerCount() / 4;
        scene.uvSets[0].uv.middleRows(corners, corners) =
            newUv(*scene.mesh).topRows(corners); // the second one
        QVERIFY(writeMesh(scene, out, height).ok());
        const Scene written = readMesh(out, nullptr, height).value();
        QVERIFY(sameMap(written, asWritten(scene, u"fbx"_s, height)));
        QCOMPARE(written.uvSets[0].uv(0, 0), scene.uvSets[0].uv(corners, 0));
    }

    //! Skins and the number of objects in the file.
    void restOfTheFbx()
    {
        QByteArray bytes = fbx({false});
        const qsizetype at = bytes.indexOf("Connections:");
        const qsizetype line = bytes.indexOf('\n', at) + 1;
        const QByteArray geometry = "Geometry: ";
        const qsizetype number = bytes.indexOf(geometry) + geometry.size();
        const QByteArray id = bytes.mid(number, bytes.indexOf(',', number) - number);
        bytes.insert(line, "\tC: \"OO\",777," + id + "\n");
        bytes.insert(at, "Definitions:  {\n\tCount: 9\n\tObjectType: \"Geometry\" {\n\t\tCount: 2\n\t}\n}\n");
        const QString in = mFolder.filePath(u"skin.fbx"_s), out = mFolder.filePath(u"skinned.fbx"_s);
        QVERIFY(saveAtomically(in, bytes).ok());
        Scene scene = readMesh(in).value();
        scene.uniqueMeshes = true;
        QVERIFY(writeMesh(scene, out).ok());
        const QByteArray written = gltffiles::contentOf(out);
        QCOMPARE(written.count("\"OO\",777,"), 3);
        QVERIFY(written.contains("\tCount: 11\n"));
        QVERIFY(written.contains("\t\tCount: 4\n"));
        QCOMPARE(written.count(geometry), 4);
    }

    void sessionsKeepIt()
    {
        const QString in = mFolder.filePath(u"session.fbx"_s), out = mFolder.filePath(u"session.acproj"_s);
        QVERIFY(saveAtomically(in, fbx({})).ok());
        DocumentState state = DocumentState::initial(readMesh(in).value());
        for (const bool unique : {false, true}) {
            state.scene.uniqueMeshes = unique;
            QVERIFY(saveProject(state, {}, out).ok());
            const Result<LoadedProject> project = loadProject(out);
            QVERIFY(project.ok());
            QCOMPARE(project->state.scene.uniqueMeshes, unique);
            QVERIFY(project->state == state);
        }
    }

    void twiceIsOnce()
    {
        const auto document = gridDocument();
        QVERIFY(pushCommand(std::make_unique<MakeUnique>(*document)));
        QVERIFY(!pushCommand(std::make_unique<MakeUnique>(*document)));
        QCOMPARE(document->undoStack().count(), 1);
    }

    void nothingIsShared()
    {
        const QString in = mFolder.filePath(u"one.fbx"_s), out = mFolder.filePath(u"same.fbx"_s);
        const QByteArray bytes = fbxfiles::model({}, {{"One", fbxfiles::quads({})}});
        QVERIFY(saveAtomically(in, bytes).ok());
        Scene scene = readMesh(in).value();
        QVERIFY(!hasSharedMeshes(scene));
        scene.uniqueMeshes = true;
        QVERIFY(writeMesh(scene, out).ok());
        QCOMPARE(gltffiles::contentOf(out), bytes);
    }

private:
    QTemporaryDir mFolder;
};

QTEST_GUILESS_MAIN(TestUniqueMeshes)

} // namespace tst_uniquemeshes

#include "tst_uniquemeshes.moc"
