// MeshData on real meshes: valid, and counted as uvmetrics, the neutral judge, counts them.
#include "model/plain/meshdata.h"
#include "support/meshbuilders.h"
#include "support/objpolygons.h"

#include <QTest>

namespace tst_realmeshes {

using namespace autocuts;

namespace {

struct Counts
{
    const char *file;
    int faces, triangles, weldedVertices, interiorEdges, boundaryEdges, nonManifoldEdges, zeroAreaTriangles;
};

// clang-format off
constexpr Counts allCounts[] = {
    {"broken/cube.obj", 12, 12, 8, 18, 0, 0, 0},
    {"broken/nonmanifold_toy.obj", 24194, 24194, 12098, 36289, 0, 1, 0},
    {"broken/plane.obj", 2, 2, 4, 1, 4, 0, 0},
    {"broken/triangle_clockwise.obj", 1, 1, 3, 0, 3, 0, 0},
    {"broken/zero_area_48.obj", 48855, 48855, 24509, 73196, 163, 2, 2},
    {"irregular/beetle.obj", 2053, 2053, 1148, 2861, 296, 47, 0},
    {"irregular/double_triangles.obj", 2, 2, 6, 0, 6, 0, 0},
    {"irregular/human_neutral.obj", 20908, 20908, 10475, 31346, 32, 0, 0},
    {"irregular/multiComp.obj", 7942, 7942, 4081, 11803, 220, 0, 0},
    {"irregular/teapot.obj", 6320, 6320, 3241, 9400, 160, 0, 0},
    {"irregular/truck.obj", 4770, 4770, 2956, 6380, 1388, 54, 0},
    {"large/lucy_o_f12067.obj", 12067, 12067, 6055, 18080, 41, 0, 0},
    {"large/lucy_o_f24136.obj", 24136, 24136, 12107, 36166, 76, 0, 0},
    {"large/lucy_o_f48275.obj", 48275, 48275, 24200, 72351, 123, 0, 0},
    {"large/lucy_o_f6032.obj", 6032, 6032, 3032, 9033, 30, 0, 0},
    {"large/nefertiti.obj", 99938, 99938, 49971, 149907, 0, 0, 0},
    {"large/ogre.obj", 124008, 124008, 62185, 185912, 200, 0, 4},
    {"organic/alligator.obj", 5981, 5981, 3208, 8755, 433, 0, 0},
    {"organic/armadillo_i_f10000.obj", 9999, 9999, 5033, 14966, 65, 0, 0},
    {"organic/bimba_i_f10000.obj", 9999, 9999, 5058, 14941, 115, 0, 0},
    {"organic/bishop_part.obj", 152, 152, 81, 224, 8, 0, 0},
    {"organic/camel_simple.obj", 5720, 5720, 2862, 8580, 0, 0, 0},
    {"organic/cathead.obj", 248, 248, 131, 366, 12, 0, 0},
    {"organic/circular_box_o_f20000.obj", 19999, 19999, 10031, 29968, 61, 0, 0},
    {"organic/cow_param_closed.obj", 5804, 5804, 2903, 8706, 0, 0, 0},
    {"organic/gargoyle_i_f10000.obj", 10000, 10000, 5040, 14961, 78, 0, 0},
    {"organic/girl1.obj", 576, 576, 297, 856, 16, 0, 0},
    {"organic/hand_1_i_f5000.obj", 4999, 4999, 2517, 7482, 33, 0, 0},
    {"organic/homer.obj", 12000, 12000, 6002, 18000, 0, 0, 0},
    {"organic/male_2_f20000.obj", 20000, 20000, 10002, 30000, 0, 0, 0},
    {"organic/octopus.obj", 4180, 4180, 2092, 6270, 0, 0, 0},
    {"organic/planck1.obj", 3109, 3109, 1566, 4653, 21, 0, 0},
    {"organic/torus_with_holes.obj", 1838, 1838, 959, 2715, 84, 0, 0},
    {"organic/triceratops_param_closed.obj", 5660, 5660, 2832, 8490, 0, 0, 0},
    {"polygons/fish_control_mesh.obj", 112, 220, 112, 222, 0, 0, 0},
    {"polygons/horse_quad.obj", 2398, 4796, 2400, 4796, 0, 0, 0},
    {"polygons/spot_control_mesh.obj", 180, 372, 188, 366, 0, 0, 0},
    {"polygons/suzanne.obj", 500, 968, 505, 963, 42, 0, 0},
    {"polygons/sword_quad_dominant.obj", 22465, 44582, 22293, 44756, 0, 0, 0},
};
// clang-format on

} // namespace

class TestRealMeshes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsAreTheJudges_data()
    {
        QTest::addColumn<int>("row");
        int row = 0;
        for (const Counts &counts : allCounts)
            QTest::newRow(counts.file) << row++;
    }

    void countsAreTheJudges()
    {
        QFETCH(int, row);
        const Counts &expected = allCounts[row];
        const auto mesh = test::readObjPolygons(test::meshFolder() + '/' + expected.file);
        if (!mesh)
            QSKIP(test::noMeshes);
        QCOMPARE(mesh->validate(), std::string());
        const MeshReport &report = mesh->report;
        QCOMPARE(report.faces, expected.faces);
        QCOMPARE(mesh->triangleCount(), expected.triangles);
        QCOMPARE(report.vertices - report.weldedVertices, expected.weldedVertices);
        QCOMPARE(report.boundaryEdges, expected.boundaryEdges);
        QCOMPARE(report.nonManifoldEdges, expected.nonManifoldEdges);
        QCOMPARE(report.degenerateTriangles, expected.zeroAreaTriangles);
        if (expected.nonManifoldEdges == 0) {
            int joined = 0;
            for (const EdgePair &pair : mesh->edgePairs)
                joined += !pair.diagonal;
            QCOMPARE(joined + report.windingEdges, expected.interiorEdges);
        }
    }
};

QTEST_APPLESS_MAIN(TestRealMeshes)

} // namespace tst_realmeshes

#include "tst_realmeshes.moc"
