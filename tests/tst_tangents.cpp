// Tangents: what MikkTSpace defines, and values that Blender gives (scripts/tangents compares more).
#include "model/plain/shadingnormals.h"
#include "model/plain/tangents.h"
#include "support/mappedmodels.h"
#include "support/meshbuilders.h"

#include <Eigen/Geometry>

#include <QTest>

#include <cmath>
#include <limits>

namespace tst_tangents {

using namespace autocuts;
using Normals = std::vector<Eigen::Vector3f>;

namespace {

Vec2 planar(const Vec3 &point, const Vec3 &)
{
    return point.head<2>();
}

bool isDefault(const Tangent &tangent)
{
    return tangent.direction == Eigen::Vector3f::UnitX() && tangent.sign == -1;
}

float distance(const Tangent &a, const Tangent &b)
{
    return (a.direction - b.direction).norm() + std::abs(a.sign - b.sign);
}

//! A mesh with a map, and its normals and tangents.
struct Shaded
{
    explicit Shaded(test::MappedModel model)
        : mesh(std::move(model.mesh)), normals(shadingNormals(*mesh, {})),
          tangents(mikkTangents(*mesh, model.uv, normals))
    {}

    //! The tangent at a corner of a polygon.
    Tangent at(int corner) const
    {
        for (int s = 0; s < mesh->soupCornerCount(); ++s) {
            if (mesh->cornerOfSoup(s) == corner)
                return tangents[s];
        }
        return {};
    }

    test::MeshPtr mesh;
    Normals normals;
    std::vector<Tangent> tangents;
};

} // namespace

class TestTangents : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unitAndAtRightAngles_data()
    {
        QTest::addColumn<QString>("mesh");
        for (const char *name :
             {"triangle", "cube", "quad cube", "grid", "sphere", "torus", "dirty", "machine"})
            QTest::newRow(name) << name;
    }

    void unitAndAtRightAngles()
    {
        QFETCH(QString, mesh);
        const test::MeshPtr data = test::meshNamed(mesh);
        const Shaded made(test::mapped(data, [](const Vec3 &p, const Vec3 &) {
            return Vec2(p.x() + .31 * p.z(), p.y() - .47 * p.z() + .1 * p.x());
        }));
        QCOMPARE(static_cast<int>(made.tangents.size()), data->soupCornerCount());
        int defined = 0;
        for (int s = 0; s < data->soupCornerCount(); ++s) {
            const Tangent &tangent = made.tangents[s];
            QVERIFY(std::abs(tangent.direction.norm() - 1) < 1e-5f);
            QVERIFY(tangent.sign == 1 || tangent.sign == -1);
            if (isDefault(tangent))
                continue;
            ++defined;
            QVERIFY(std::abs(tangent.direction.dot(made.normals[data->cornerOfSoup(s)])) < 1e-5f);
        }
        QVERIFY(2 * defined > data->soupCornerCount());
    }

    //! Quads and triangles that bend, a crease, a mirrored triangle and one without area in the map. The
    //! numbers are Blender's (3.4, Mesh.calc_tangents with auto smooth at 40 degrees).
    void asInBlender()
    {
        const auto mesh = test::polygonMesh(
            {{0, 0, 0},
             {1, 0, .25},
             {2, 0, 0},
             {0, 1, .5},
             {1, 1, 0},
             {2, 1, .5},
             {0, 2, 0},
             {1, 2, .25},
             {2, 2, -.5},
             {3, 1, 0}},
            {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8}, {4, 8, 7}, {2, 9, 5}, {5, 9, 8}});
        const std::vector<Vec2> map{{0, 0},   {.25, 0},   {.5, .125},  {0, .25},   {.375, .25},
                                    {.5, .5}, {.125, .5}, {.25, .625}, {.125, .75}};
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            // Vertex 9 is where vertex 1 is in the map of one face, and vertex 5 in that of the other.
            const int vertex = mesh->cornerVertex[c];
            uv.row(c) = map[vertex < 9 ? vertex : c < 21 ? 1 : 5].transpose();
        }
        const Shaded made({mesh, uv});
        const std::vector<std::array<float, 4>> expected{
            {0.991880f, 0.047232f, -0.118081f, 1.f},    {0.970493f, -0.239266f, -0.029908f, 1.f},
            {0.957442f, -0.240909f, -0.158956f, 1.f},   {0.992278f, 0.000000f, -0.124035f, 1.f},
            {0.970493f, -0.239266f, -0.029908f, 1.f},   {0.865378f, -0.464137f, -0.188938f, 1.f},
            {0.835549f, -0.476828f, -0.272936f, 1.f},   {0.957442f, -0.240909f, -0.158956f, 1.f},
            {0.992278f, 0.000000f, -0.124035f, 1.f},    {0.957442f, -0.240909f, -0.158956f, 1.f},
            {0.870666f, -0.341107f, -0.354382f, 1.f},   {0.983835f, -0.145187f, -0.104831f, 1.f},
            {0.485071f, -0.485071f, 0.727607f, 1.f},    {0.492366f, -0.615457f, 0.615457f, 1.f},
            {0.492366f, -0.615457f, 0.615458f, 1.f},    {-0.932307f, 0.323717f, 0.161277f, -1.f},
            {-0.744208f, 0.248069f, 0.620174f, -1.f},   {-0.892785f, 0.270096f, 0.360532f, -1.f},
            {-0.601618f, -0.785309f, -0.146102f, -1.f}, {-0.597022f, -0.796030f, -0.099504f, -1.f},
            {-0.603282f, -0.785796f, -0.136293f, -1.f}, {0.492366f, -0.615457f, 0.615457f, 1.f},
            {1.000000f, 0.000000f, 0.000000f, -1.f},    {0.492366f, -0.615457f, 0.615458f, 1.f}};
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            const auto &[x, y, z, sign] = expected[c];
            const float off = distance(made.at(c), {{x, y, z}, sign});
            QVERIFY2(off < 1e-5f, qPrintable(QStringLiteral("corner %1 by %2").arg(c).arg(off)));
        }
    }

    void mirroredPartsHaveTheOtherSign()
    {
        const test::MeshPtr mesh = test::grid(8, .2);
        const Shaded made(test::mapped(
            mesh, [](const Vec3 &p, const Vec3 &) { return Vec2(std::abs(p.x() - .5), p.y()); }));
        for (int s = 0; s < mesh->soupCornerCount(); ++s) {
            const int face = mesh->triangleFace[s / 3];
            double x = 0;
            for (int c = mesh->faceStart[face]; c < mesh->faceStart[face + 1]; ++c)
                x += mesh->cornerPosition(c).x() / 4;
            const Tangent &tangent = made.tangents[s];
            QCOMPARE(tangent.sign, x > .5 ? 1.f : -1.f);
            QVERIFY(x > .5 ? tangent.direction.x() > .5f : tangent.direction.x() < -.5f);
        }
    }

    void bothSidesOfASmoothEdgeAreEqual()
    {
        const test::MeshPtr mesh = test::sphere(16, 24);
        const Shaded made(test::mapped(mesh, planar));
        int equal = 0, apart = 0;
        for (const EdgePair &pair : mesh->edgePairs) {
            for (const auto &[a, b] : pair.corner) {
                // The outline of the sphere is folded: there both sides differ.
                if (made.tangents[a].sign != made.tangents[b].sign) {
                    ++apart;
                } else {
                    QVERIFY(distance(made.tangents[a], made.tangents[b]) < 1e-6f);
                    ++equal;
                }
            }
        }
        QVERIFY(equal > 10 * apart && apart > 0);
    }

    void seamsAndHardEdgesSeparate()
    {
        const test::MeshPtr cube = test::quadCube();
        const Shaded made(test::mapped(
            cube, [](const Vec3 &p, const Vec3 &) { return Vec2(p.x() + .2 * p.z(), p.y() + .3 * p.z()); }));
        for (int f = 0; f < cube->faceCount(); ++f) {
            const Tangent first = made.at(cube->faceStart[f]);
            for (int c = cube->faceStart[f]; c < cube->faceStart[f + 1]; ++c)
                QVERIFY(distance(made.at(c), first) < 1e-6f);
        }
        // A map that is turned by a quarter on the other side of a seam.
        const auto pair = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
        UvMatrix uv = test::mapped(pair, planar).uv;
        for (int c = 4; c < 8; ++c)
            uv.row(c) = Eigen::RowVector2d(5 - pair->cornerPosition(c).y(), pair->cornerPosition(c).x());
        const Shaded turned({pair, uv});
        QVERIFY((turned.at(1).direction - Eigen::Vector3f(1, 0, 0)).norm() < 1e-6f);
        QVERIFY((turned.at(4).direction - Eigen::Vector3f(0, -1, 0)).norm() < 1e-6f);
    }

    //! Between two triangles that share a vertex, the tangent is the mean by the angles there.
    void trianglesWeighByTheirAngles()
    {
        const double a = std::acos(-1.0) / 3; // 90 and 60 degrees at the vertex
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-std::sin(a), std::cos(a), 0}},
                                            {{0, 1, 2}, {0, 2, 3}});
        UvMatrix uv(6, 2);
        uv << 0, 0, 1, 0, 0, 1, /**/ 0, 0, 0, 1, -1, 1;
        const Shaded made({mesh, uv});
        // The second triangle: u grows from its side x = 0, on which v grows, towards its last corner at -1.
        const Eigen::Vector3f second = Eigen::Vector3f(std::sin(a), 1 - std::cos(a), 0).normalized();
        const Eigen::Vector3f mean = (Eigen::Vector3f(1, 0, 0) * 90 + second * 60).normalized();
        QVERIFY((made.at(0).direction - mean).norm() < 1e-5f);
        QVERIFY((made.at(1).direction - Eigen::Vector3f(1, 0, 0)).norm() < 1e-5f);
        QVERIFY((made.at(5).direction - second).norm() < 1e-5f);
    }

    //! A quad with halves of unlike tangents: cut where it is shorter in the map, whatever the mesh does.
    void quadsAreCutInTheMap()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
        UvMatrix uv(4, 2);
        uv << 0, 0, 1, 0, 2, 2, 0, 1; // the cut runs between the second and the fourth corner
        const Shaded made({mesh, uv});
        QVERIFY((made.at(0).direction - Eigen::Vector3f(1, 0, 0)).norm() < 1e-6f);
        QVERIFY((made.at(2).direction - Eigen::Vector3f(2, -1, 0).normalized()).norm() < 1e-5f);
        const Eigen::Vector3f mean = (made.at(0).direction + made.at(2).direction).normalized();
        QVERIFY((made.at(1).direction - mean).norm() < 1e-5f);
        QVERIFY((made.at(3).direction - mean).norm() < 1e-5f);
    }

    void largerPolygonsAreTheirTriangles()
    {
        const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {3, 1, .2}, {1, 3, .1}, {-1, 1, 0}};
        const auto whole = test::polygonMesh(points, {{0, 1, 2, 3, 4}});
        std::vector<std::vector<int>> triangles;
        for (const auto &t : whole->triangles)
            triangles.push_back({t[0], t[1], t[2]});
        const auto cut = test::polygonMesh(points, triangles);
        const auto bend = [](const Vec3 &p, const Vec3 &) {
            return Vec2(p.x() * p.x() + p.y(), p.y() - .2 * p.x() * p.y());
        };
        const Normals up(whole->cornerCount(), Eigen::Vector3f::UnitZ());
        const std::vector<Tangent> a = mikkTangents(*whole, test::mapped(whole, bend).uv, up);
        const std::vector<Tangent> b = mikkTangents(*cut, test::mapped(cut, bend).uv,
                                                    Normals(cut->cornerCount(), Eigen::Vector3f::UnitZ()));
        QCOMPARE(a.size(), b.size());
        for (std::size_t s = 0; s < a.size(); ++s)
            QVERIFY(distance(a[s], b[s]) < 1e-6f);
    }

    void trianglesWithoutAreaTakeTheTangentsAround()
    {
        // A triangle of no area in the map beside a good one, and a collapsed one on its edge.
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                            {{0, 1, 2}, {2, 1, 3}, {0, 1, 1}});
        UvMatrix uv(9, 2);
        uv << 0, 0, 0, 1, -1, 0, /**/ -1, 0, 0, 1, 0, 1, /**/ 0, 0, 0, 1, 0, 1;
        const Shaded made({mesh, uv});
        for (const int corner : {0, 1, 2, 3, 4, 6, 7, 8}) {
            QVERIFY((made.at(corner).direction - Eigen::Vector3f(0, -1, 0)).norm() < 1e-5f);
            QCOMPARE(made.at(corner).sign, 1.f);
        }
    }

    void oddInputGivesNumbers_data()
    {
        QTest::addColumn<double>("value");
        QTest::newRow("missing") << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("huge") << 1e300;
        QTest::newRow("too large for products") << 9e14;
        QTest::newRow("tiny") << 1e-300;
    }

    void oddInputGivesNumbers()
    {
        QFETCH(double, value);
        for (const char *name : {"dirty", "quad cube", "machine"}) {
            const test::MeshPtr mesh = test::meshNamed(QString::fromLatin1(name));
            UvMatrix uv = test::mapped(mesh, planar).uv;
            for (Eigen::Index c = 0; c < uv.rows(); c += 3)
                uv(c, c % 2) = value;
            const Shaded made({mesh, uv});
            for (const Tangent &tangent : made.tangents)
                QVERIFY(tangent.direction.allFinite() && std::abs(tangent.direction.norm() - 1) < 1e-5f);
        }
        const auto huge = test::polygonMesh({{0, 0, 0}, {1e140, 0, 0}, {0, 1e140, 0}}, {{0, 1, 2}});
        const Shaded made(
            test::mapped(huge, [](const Vec3 &p, const Vec3 &) { return Vec2(p.head<2>() / 1e140); }));
        QVERIFY((made.at(0).direction - Eigen::Vector3f::UnitX()).norm() < 1e-6f);
    }

    //! Thousands of faces on one edge take no longer than as many elsewhere.
    void crowdedEdges()
    {
        std::vector<Vec3> points{{0, 0, 0}, {0, 1, 0}};
        std::vector<std::vector<int>> faces;
        for (int i = 0; i < 100000; ++i) {
            points.emplace_back(1 + i, 0, i % 7);
            faces.push_back(i % 2 ? std::vector<int>{0, i + 2, 1} : std::vector<int>{1, i + 2, 0});
        }
        const auto mesh = test::polygonMesh(points, faces);
        const Normals up(mesh->cornerCount(), Eigen::Vector3f::UnitZ());
        for (const Tangent &tangent : mikkTangents(*mesh, test::mapped(mesh, planar).uv, up))
            QVERIFY(tangent.direction.allFinite());
    }
};

QTEST_APPLESS_MAIN(TestTangents)

} // namespace tst_tangents

#include "tst_tangents.moc"
