// The sample models are what they claim to be: closed, outwards, in one piece or in many, and always the
// same.
#include "model/samples/samples.h"

#include <Eigen/Geometry>

#include <QTest>

#include <set>

namespace tst_samples {

using namespace autocuts;

namespace {

int eulerCharacteristic(const MeshData &mesh)
{
    return mesh.report.vertices - mesh.report.weldedVertices - static_cast<int>(mesh.edgePairs.size()) +
           mesh.triangleCount();
}

} // namespace

class TestSamples : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void shapeIsAsNamed_data()
    {
        QTest::addColumn<int>("fewestFaces");
        QTest::addColumn<int>("mostFaces");
        QTest::addColumn<int>("objects");
        QTest::addColumn<int>("euler");
        QTest::newRow("bumpycube") << 6000 << 10000 << 1 << 2;
        QTest::newRow("character") << 2000 << 4500 << 1 << 2;
        QTest::newRow("torus") << 2000 << 5000 << 1 << -6; // genus 4
        QTest::newRow("machine") << 300 << 2000 << 5 << 2 * 46;
    }

    void shapeIsAsNamed()
    {
        QFETCH(int, fewestFaces);
        QFETCH(int, mostFaces);
        const auto scene = makeSample(QString::fromLatin1(QTest::currentDataTag()));
        QVERIFY(scene.ok());
        const MeshData &mesh = *scene->mesh;
        QCOMPARE(mesh.validate(), std::string());
        QVERIFY(mesh.faceCount() >= fewestFaces && mesh.faceCount() <= mostFaces);
        QTEST(mesh.report.objects, "objects");
        QTEST(eulerCharacteristic(mesh), "euler");
        QVERIFY(mesh.boundarySides.empty());
        QCOMPARE(mesh.report.degenerateTriangles, 0);
        QCOMPARE(mesh.report.duplicateFaces, 0);
        QCOMPARE(mesh.report.isolatedVertices, 0);
        QVERIFY(!scene->hasUv());

        std::vector<double> volume(mesh.componentCount, 0);
        for (int t = 0; t < mesh.triangleCount(); ++t) {
            const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
            const Vec3 b = mesh.cornerPosition(mesh.triangles[t][1]);
            const Vec3 c = mesh.cornerPosition(mesh.triangles[t][2]);
            volume[mesh.component[t]] += a.dot(b.cross(c)) / 6;
        }
        for (double v : volume)
            QVERIFY(v > 0);
    }

    void everyNameMakesANamedScene()
    {
        QCOMPARE(sampleNames(), QStringList({QStringLiteral("bumpycube"), QStringLiteral("character"),
                                             QStringLiteral("torus"), QStringLiteral("machine")}));
        for (const QString &name : sampleNames()) {
            const auto scene = makeSample(name);
            QVERIFY(scene.ok());
            QCOMPARE(static_cast<int>(scene->objectNames.size()), scene->mesh->report.objects);
            QCOMPARE(static_cast<int>(scene->faceMaterial.size()), scene->mesh->faceCount());
            const std::set<int> used(scene->faceMaterial.begin(), scene->faceMaterial.end());
            QCOMPARE(used.size(), scene->materialNames.size());
            QCOMPARE(*used.begin(), 0);
            QVERIFY(scene->mesh->positions == makeSample(name)->mesh->positions);
        }
    }

    void characterIsAllQuads()
    {
        const auto scene = makeSample(QStringLiteral("character"));
        QCOMPARE(scene->mesh->report.polygons, scene->mesh->faceCount());
        QCOMPARE(scene->mesh->cornerCount(), 4 * scene->mesh->faceCount());
    }

    void bumpyCubeHasStraightEdges()
    {
        // The twelve edges of the cube stay where they are: there the bumps have no height.
        const auto scene = makeSample(QStringLiteral("bumpycube"));
        const PositionMatrix &p = scene->mesh->positions;
        int onEdges = 0, highest = 0;
        for (Eigen::Index i = 0; i < p.rows(); ++i) {
            onEdges += (p.row(i).array().abs() == 1).count() >= 2;
            highest += p.row(i).cwiseAbs().maxCoeff() > 1.1;
        }
        QCOMPARE(onEdges, 12 * 26 + 8);
        QVERIFY(highest > 6 * 9);
    }

    void machineHasEveryKindOfFace()
    {
        const auto scene = makeSample(QStringLiteral("machine"));
        std::set<int> sizes;
        for (int f = 0; f < scene->mesh->faceCount(); ++f)
            sizes.insert(scene->mesh->faceStart[f + 1] - scene->mesh->faceStart[f]);
        QVERIFY(sizes.contains(3) && sizes.contains(4) && sizes.contains(6) && sizes.contains(32));
        QVERIFY(scene->mesh->report.concavePolygons >= 4);
        QCOMPARE(scene->mesh->componentCount, 46);
    }

    void unknownNameListsTheKnownOnes()
    {
        const auto scene = makeSample(QStringLiteral("teapot"));
        QVERIFY(!scene.ok());
        QVERIFY(scene.error().message.contains(QLatin1String("teapot")));
        QVERIFY(scene.error().remedy.contains(QLatin1String("bumpycube, character, torus, machine")));
    }
};

QTEST_APPLESS_MAIN(TestSamples)

} // namespace tst_samples

#include "tst_samples.moc"
