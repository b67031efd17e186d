// Shading normals: smoothing across edges, weights, hard edges, and faces without area.
#include "model/plain/shadingnormals.h"
#include "support/meshbuilders.h"

#include <Eigen/Geometry>

#include <QTest>

#include <cmath>

namespace tst_shadingnormals {

using namespace autocuts;
using Normals = std::vector<Eigen::Vector3f>;

namespace {

//! Two unit squares with the edge (0, 0, 0), (0, 1, 0) in common, bent by an angle in degrees. The normals
//! lean by half of it to both sides.
test::MeshPtr hinge(double degrees)
{
    const double half = degrees / 2 * std::acos(-1.0) / 180;
    const double x = std::cos(half), z = -std::sin(half);
    return test::polygonMesh({{0, 0, 0}, {0, 1, 0}, {x, 0, z}, {x, 1, z}, {-x, 0, z}, {-x, 1, z}},
                             {{0, 2, 3, 1}, {0, 1, 5, 4}});
}

bool near(const Eigen::Vector3f &a, const Eigen::Vector3f &b)
{
    return (a - b).norm() < 1e-6f;
}

//! The number of an edge pair by its vertices; -1 for none.
int pairBetween(const MeshData &mesh, int a, int b)
{
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto &ends = mesh.edgePairs[e].corner;
        const int v = mesh.vertexOfSoup(ends[0][0]), w = mesh.vertexOfSoup(ends[1][0]);
        if (std::minmax(v, w) == std::minmax(a, b))
            return static_cast<int>(e);
    }
    return -1;
}

} // namespace

class TestShadingNormals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneUnitNormalPerCorner_data()
    {
        QTest::addColumn<QString>("mesh");
        for (const char *name :
             {"triangle", "cube", "quad cube", "grid", "sphere", "torus", "dirty", "machine"})
            QTest::newRow(name) << name;
    }

    void oneUnitNormalPerCorner()
    {
        QFETCH(QString, mesh);
        const test::MeshPtr data = test::meshNamed(mesh);
        const Normals normals = shadingNormals(*data, {});
        QCOMPARE(static_cast<int>(normals.size()), data->cornerCount());
        for (const Eigen::Vector3f &normal : normals)
            QVERIFY(std::abs(normal.norm() - 1) < 1e-5f);
    }

    void creasesAreHardFromFortyDegrees()
    {
        const test::MeshPtr soft = hinge(39.9), sharp = hinge(40.1);
        QVERIFY(near(shadingNormals(*soft, {})[0], {0, 0, 1}));
        QVERIFY(!near(shadingNormals(*soft, {})[1], {0, 0, 1}));
        const Normals normals = shadingNormals(*sharp, {});
        for (int c = 1; c < 4; ++c)
            QVERIFY(near(normals[c], normals[0]));
        QVERIFY(!near(normals[4], normals[0]));
    }

    void givenHardEdgesReplaceTheAngle()
    {
        const test::MeshPtr sharp = hinge(80);
        std::vector<bool> hard(sharp->edgePairs.size(), false);
        QVERIFY(near(shadingNormals(*sharp, hard)[0], {0, 0, 1}));
        const test::MeshPtr soft = hinge(10);
        hard.assign(soft->edgePairs.size(), false);
        hard[pairBetween(*soft, 0, 1)] = true;
        QVERIFY(!near(shadingNormals(*soft, hard)[0], {0, 0, 1}));
    }

    void aHardEdgeThatEndsInsideIsSmoothAtItsEnd()
    {
        const test::MeshPtr mesh = test::grid(2, .3); // vertex 4 in the middle, 1 on the border
        std::vector<bool> hard(mesh->edgePairs.size(), false);
        hard[pairBetween(*mesh, 1, 4)] = true;
        const Normals normals = shadingNormals(*mesh, hard);
        std::vector<Eigen::Vector3f> middle, border;
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            if (mesh->cornerVertex[c] == 4)
                middle.push_back(normals[c]);
            if (mesh->cornerVertex[c] == 1)
                border.push_back(normals[c]);
        }
        QCOMPARE(middle.size(), 4u);
        for (const Eigen::Vector3f &normal : middle)
            QVERIFY(near(normal, middle[0]));
        QCOMPARE(border.size(), 2u);
        QVERIFY(!near(border[0], border[1]));
    }

    //! A vertex with a square of 90 degrees on one side, and with two triangles of 45 degrees on the other:
    //! cutting a face apart does not change the normal.
    void facesWeighByTheirAngles()
    {
        const double x = std::sqrt(.5);
        const std::vector<Vec3> points{{0, 0, 0},  {0, 1, 0},   {x, 0, -x},
                                       {x, 1, -x}, {-x, 0, -x}, {-x, 1, -x}};
        const std::vector<bool> none(20, false);
        const auto whole = test::polygonMesh(points, {{0, 2, 3, 1}, {0, 1, 5, 4}});
        const auto cut = test::polygonMesh(points, {{0, 2, 3}, {0, 3, 1}, {0, 1, 5, 4}});
        QVERIFY(near(shadingNormals(*whole, none)[0], {0, 0, 1}));
        QVERIFY(near(shadingNormals(*cut, none)[0], {0, 0, 1}));
    }

    void verticesAtOnePlaceAreOne()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0},
                                             {0, 1, 0},
                                             {1, 0, -.1},
                                             {1, 1, -.1},
                                             {-1, 0, -.1},
                                             {-1, 1, -.1},
                                             {0, 0, 0},
                                             {0, 1, 0}},
                                            {{0, 2, 3, 1}, {6, 7, 5, 4}});
        QVERIFY(near(shadingNormals(*mesh, {})[0], {0, 0, 1}));
    }

    void edgesOfManyFacesAreHard()
    {
        // Three fins on one edge: two of them are flat together, and are paired.
        const auto mesh = test::polygonMesh({{0, 0, 0},
                                             {0, 1, 0},
                                             {1, 0, -.1},
                                             {1, 1, -.1},
                                             {-1, 0, -.1},
                                             {-1, 1, -.1},
                                             {0, 0, 1},
                                             {0, 1, 1}},
                                            {{0, 2, 3, 1}, {0, 1, 5, 4}, {0, 1, 7, 6}});
        QVERIFY(pairBetween(*mesh, 0, 1) >= 0);
        const Normals normals = shadingNormals(*mesh, {});
        QVERIFY(near(normals[0], normals[1]));
        QVERIFY(!near(normals[0], normals[4]));
    }

    void facesWithoutAreaHaveTheNormalsOfTheirVertices()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},
                                            {{0, 1, 2}, {0, 2, 3}, {1, 1, 1}});
        const Normals normals = shadingNormals(*mesh, {});
        QVERIFY(near(normals[0], {0, 0, 1}));
        for (const Eigen::Vector3f &normal : normals)
            QVERIFY(near(normal, {0, 0, 1}));
    }

    void sizeAndPlaceDoNotMatter_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("offset");
        QTest::newRow("tiny") << 1e-30 << 0.0;
        QTest::newRow("huge") << 1e70 << 0.0;
        QTest::newRow("far away") << 1.0 << 1e6;
    }

    void sizeAndPlaceDoNotMatter()
    {
        QFETCH(double, scale);
        QFETCH(double, offset);
        const test::MeshPtr mesh = test::torus(12, 8);
        PositionMatrix positions = (mesh->positions * scale).array() + offset;
        const auto moved = MeshData::build(positions, mesh->faceStart, mesh->cornerVertex, mesh->faceObject);
        const std::vector<bool> none(mesh->edgePairs.size(), false);
        const Normals expected = shadingNormals(*mesh, none), normals = shadingNormals(*moved, none);
        for (std::size_t c = 0; c < normals.size(); ++c)
            QVERIFY(near(normals[c], expected[c]));
    }
};

QTEST_APPLESS_MAIN(TestShadingNormals)

} // namespace tst_shadingnormals

#include "tst_shadingnormals.moc"
