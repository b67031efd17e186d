// glTF files come back changed in nothing but their UVs: attributes, seams, sets.
#include "model/io/files/savefile.h"
#include "model/io/gltf/gltfprimitive.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfwriter.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectscene.h"
#include "support/gltffiles.h"

#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

namespace tst_gltf {

using namespace autocuts;
using namespace gltffiles;
using namespace Qt::Literals::StringLiterals;

class TestGltf : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyUvsChange_data();
    void onlyUvsChange();
    void oldSeamsAreJoined();
    void unsplitMeshesKeepTheirIndices();
    void vertexOrderStays();
    void newSets();
    void removedAndRenamedSets();
    void tangentsOfChangedUvs();
    void instances();
    void objectsMaterialsAndNotes();
    void missingCorners();
};

void TestGltf::onlyUvsChange_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("grid") << grid().glb();
    QTest::newRow("interleaved") << interleaved().glb();
    QTest::newRow("many attributes") << manyAttributes().glb();
    QTest::newRow("skin") << skinned().glb();
    QTest::newRow("morph targets") << morphed().glb();
    QTest::newRow("strip") << strip().glb();
    QTest::newRow("fan") << fan().glb();
    QTest::newRow("without indices") << withoutIndices().glb();
    QTest::newRow("shared attributes") << shared().glb();
    QTest::newRow("text") << morphed().text();
}

void TestGltf::onlyUvsChange()
{
    QFETCH(QByteArray, bytes);
    Scene scene = parsed(bytes);
    QCOMPARE(QString::fromStdString(scene.mesh->validate()), QString());
    const std::size_t before = vertexCount(jsonOf(bytes));
    for (UvSet &set : scene.uvSets)
        set.uv = seamyUv(*scene.mesh);
    const QByteArray out = written(scene);
    QCOMPARE(differenceOf({bytes, {}}, {out, {}}), QString());
    const Scene again = parsed(out);
    QVERIFY(uvDifference(scene, again) <= 1e-6);
    QVERIFY(vertexCount(jsonOf(out)) != before);
    // Nothing was changed now.
    QCOMPARE(written(again), out);
}

void TestGltf::oldSeamsAreJoined()
{
    // Every corner has a vertex of its own.
    Scene scene = parsed(withoutIndices().glb());
    QCOMPARE(scene.mesh->vertexCount(), 96);
    for (Eigen::Index c = 0; c < scene.uvSets[0].uv.rows(); ++c) {
        const Vec3 p = scene.mesh->cornerPosition(int(c));
        scene.uvSets[0].uv.row(c) << p.x() / 3, p.y() / 3;
    }
    QCOMPARE(vertexCount(jsonOf(written(scene))), std::size_t(gridVertices));
}

void TestGltf::unsplitMeshesKeepTheirIndices()
{
    const QByteArray bytes = shared().glb();
    Scene scene = parsed(bytes);
    const Eigen::Index half = scene.uvSets[0].uv.rows() / 3;
    scene.uvSets[0].uv.topRows(2 * half).array() *= 0.5;
    const Json before = jsonOf(bytes);
    const Json after = jsonOf(written(scene));
    QCOMPARE(after["accessors"].size(), before["accessors"].size() + 1);
    for (std::size_t p = 0; p < 2; ++p) {
        const Json &a = before["meshes"][0]["primitives"][p];
        const Json &b = after["meshes"][0]["primitives"][p];
        QVERIFY(a["indices"] == b["indices"]);
        QVERIFY(a["attributes"]["POSITION"] == b["attributes"]["POSITION"]);
        QVERIFY(b["attributes"]["TEXCOORD_0"] == before["accessors"].size());
    }
}

void TestGltf::vertexOrderStays()
{
    Scene scene = parsed(grid().glb());
    UvMatrix &uv = scene.uvSets[0].uv;
    uv.row(0).array() += 3; // one corner leaves its vertex
    const Scene again = parsed(written(scene));
    GltfFile file = sourceOf<GltfSource>(again)->file;
    const GltfDocument document = openGltf(file);
    GltfData data(document);
    const GltfPrimitive primitive = readPrimitive(data, document.json["meshes"][0]["primitives"][0]);
    QCOMPARE(primitive.vertexCount, std::size_t(gridVertices + 1));
    const std::vector<float> positions = gridPositions();
    QVERIFY(primitive.attributes.at("POSITION")
                .bytes.startsWith(QByteArrayView(reinterpret_cast<const char *>(positions.data()),
                                                 qsizetype(positions.size() * 4))));
}

void TestGltf::newSets()
{
    Scene scene = parsed(grid().glb());
    scene.uvSets.insert(scene.uvSets.begin(), {u"another"_s, seamyUv(*scene.mesh)});
    const Scene again = parsed(written(scene));
    QCOMPARE(again.uvSets.size(), std::size_t(2));
    QCOMPARE(again.uvSets[1].name, u"another"_s);
    QVERIFY((again.uvSets[0].uv - scene.uvSets[1].uv).isZero(0));
    QVERIFY((again.uvSets[1].uv - scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-6);

    // The numbers have no gaps where a mesh had no UVs.
    Scene partly = parsed(shared().glb());
    partly.uvSets.push_back({u"another"_s, seamyUv(*partly.mesh)});
    const Json json = jsonOf(written(partly));
    for (const std::size_t p : {0, 1, 3})
        QVERIFY(json["meshes"][0]["primitives"][p]["attributes"].contains("TEXCOORD_0"));

    // A file without UVs.
    FileBuilder bare = grid();
    bare.primitive()["attributes"].erase("TEXCOORD_0");
    Scene first = parsed(bare.glb());
    QVERIFY(first.uvSets.empty());
    first.uvSets = {{u"UVMap"_s, seamyUv(*first.mesh)}};
    QVERIFY(uvDifference(first, parsed(written(first))) < 1e-6);
}

void TestGltf::removedAndRenamedSets()
{
    const QByteArray bytes = manyAttributes().glb();
    Scene scene = parsed(bytes);
    QCOMPARE(scene.uvSets.size(), std::size_t(2));
    // Which one is the active one does not matter.
    std::swap(scene.uvSets[0], scene.uvSets[1]);
    QCOMPARE(written(scene), bytes);
    scene.uvSets.erase(scene.uvSets.begin());
    QCOMPARE(written(scene), bytes);
    QVERIFY(exportLosses(scene, u"glb"_s).join(u' ').contains("removed"_L1));
    // The file keeps the new name.
    const QString other = scene.uvSets[0].name;
    scene.uvSets[0].name = u"renamed"_s;
    const Scene renamed = parsed(written(scene));
    QCOMPARE(int(std::ranges::count(renamed.uvSets, u"renamed"_s, &UvSet::name)), 1);
    QCOMPARE(int(std::ranges::count(renamed.uvSets, other, &UvSet::name)), 0);
    QVERIFY(!exportLosses(parsed(bytes), u"glb"_s).join(u' ').contains("removed"_L1));
}

void TestGltf::tangentsOfChangedUvs()
{
    FileBuilder file = manyAttributes();
    file.primitive()["attributes"]["TANGENT"] = file.add(counted<float>(4), "VEC4", 5126, 4);
    file.json["materials"] = {{{"normalTexture", {{"index", 0}, {"texCoord", 1}}}}};
    file.primitive()["material"] = 0;
    const auto hasTangents = [](const Scene &scene) {
        return jsonOf(written(scene))["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT");
    };
    Scene scene = parsed(file.glb());
    scene.uvSets[0].uv = seamyUv(*scene.mesh);
    QVERIFY(hasTangents(scene));
    scene.uvSets[1].uv = seamyUv(*scene.mesh);
    QVERIFY(!hasTangents(scene));
    QVERIFY(exportLosses(scene, u"glb"_s).join(u' ').contains("tangents"_L1));
}

void TestGltf::instances()
{
    const QByteArray bytes = instanced().glb();
    Scene scene = parsed(bytes);
    const MeshData &mesh = *scene.mesh;
    QCOMPARE(mesh.faceCount(), 64);
    QCOMPARE(scene.objectNames, (std::vector<QString>{u"mirrored"_s, u"grid"_s}));
    QCOMPARE(mesh.positions.col(0).minCoeff(), -5.0);
    QCOMPARE(mesh.positions.col(1).maxCoeff(), 8.0);
    // All faces look up, also the mirrored ones.
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        const Vec3 b = mesh.cornerPosition(mesh.triangles[t][1]) - a;
        const Vec3 c = mesh.cornerPosition(mesh.triangles[t][2]) - a;
        QVERIFY(b.x() * c.y() - b.y() * c.x() > 0);
    }
    QVERIFY(scene.notes.at(0).contains(u"several nodes"_s));
    scene.uvSets[0].uv = seamyUv(mesh);
    const QByteArray out = written(scene);
    QCOMPARE(differenceOf({bytes, {}}, {out, {}}), QString());
    const UvMatrix uv = parsed(out).uvSets[0].uv;
    QVERIFY((uv.topRows(96) - scene.uvSets[0].uv.topRows(96)).cwiseAbs().maxCoeff() < 1e-6);
}

void TestGltf::objectsMaterialsAndNotes()
{
    const Scene scene = parsed(shared().glb());
    QCOMPARE(scene.objectNames, std::vector<QString>{u"grid"_s});
    QCOMPARE(scene.materialNames, (std::vector<QString>{u"red"_s, u"material 2"_s}));
    QCOMPARE(scene.faceMaterial.front(), -1);
    QCOMPARE(scene.faceMaterial.at(16), 0);
    QCOMPARE(scene.faceMaterial.back(), 1);
    QCOMPARE(scene.notes.size(), std::size_t(1));
    QVERIFY(scene.notes[0].contains("line(s) left out"_L1));
    // v points up here.
    QCOMPARE(scene.uvSets[0].name, u"UVMap"_s);
    QCOMPARE(scene.uvSets[0].uv(0, 1), 1.0);
    QCOMPARE(scene.uvSets[0].uv(2, 1), 1 - double(1.0f / 7));
    QVERIFY(scene.hardEdges.empty());

    FileBuilder hard = withoutIndices();
    std::vector<float> normals;
    for (std::size_t c = 0; c < 3 * 32; ++c)
        normals.insert(normals.end(), {c < 48 ? 1.0f : 0.0f, 0, 1});
    hard.primitive()["attributes"]["NORMAL"] = hard.add(normals, "VEC3", 5126, 3);
    const std::vector<bool> edges = parsed(hard.glb()).hardEdges;
    QCOMPARE(std::count(edges.begin(), edges.end(), true), gridSize);
}

void TestGltf::missingCorners()
{
    Scene scene = parsed(grid().glb());
    const UvMatrix before = scene.uvSets[0].uv;
    scene.uvSets[0].uv.array() += 2;
    scene.uvSets[0].uv.row(4).fill(std::numeric_limits<double>::quiet_NaN());
    const UvMatrix after = parsed(written(scene)).uvSets[0].uv;
    QCOMPARE(after.row(4), before.row(4));
    QVERIFY(std::abs(after(5, 0) - before(5, 0) - 2) < 1e-6);
}

QTEST_GUILESS_MAIN(TestGltf)

} // namespace tst_gltf

#include "tst_gltf.moc"
