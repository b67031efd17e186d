// MeshData: welding, triangulation, edge pairs, and meshes that are broken in every way.
#include "model/meshdata.h"
#include "support/meshbuilders.h"

#include <QTest>

using namespace autocuts;

class TestMeshData : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closedMeshHasOnlyPairs()
    {
        const auto mesh = test::cube();
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->edgePairs.size(), std::size_t(18));
        QVERIFY(mesh->boundarySides.empty());
        QCOMPARE(mesh->area, 6.0);
        QCOMPARE(mesh->componentCount, 1);
    }

    void quadDiagonalsArePaired()
    {
        const auto mesh = test::quadCube();
        QCOMPARE(mesh->validate(), std::string());
        int diagonals = 0;
        for (const EdgePair &pair : mesh->edgePairs)
            diagonals += pair.diagonal;
        QCOMPARE(diagonals, 6);
        QCOMPARE(mesh->edgePairs.size(), std::size_t(18));
    }

    void nonManifoldFacesTakeTheSmoothestPartner()
    {
        // A flat strip of two triangles with a fin on their common edge.
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                            {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->edgePairs.size(), std::size_t(1));
        QCOMPARE(mesh->edgePairs[0].triangle[0], 0);
        QCOMPARE(mesh->edgePairs[0].triangle[1], 1);
        QCOMPARE(mesh->report.nonManifoldEdges, 1);
        QCOMPARE(mesh->componentCount, 2);
    }
};

QTEST_APPLESS_MAIN(TestMeshData)
#include "tst_meshdata.moc"
