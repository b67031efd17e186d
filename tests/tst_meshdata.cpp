// MeshData: welding, triangulation, edge pairs, and meshes that are broken in every way.
#include "model/plain/meshdata.h"
#include "model/plain/meshpart.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace tst_meshdata {

using namespace autocuts;

namespace {

//! Points in rows.
PositionMatrix rows(const std::vector<Vec3> &points)
{
    PositionMatrix matrix(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        matrix.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return matrix;
}

int countDiagonals(const MeshData &mesh)
{
    return static_cast<int>(std::count_if(mesh.edgePairs.begin(), mesh.edgePairs.end(),
                                          [](const EdgePair &pair) { return pair.diagonal; }));
}

int countOpen(const MeshData &mesh, OpenSide reason)
{
    return static_cast<int>(std::count_if(mesh.boundarySides.begin(), mesh.boundarySides.end(),
                                          [&](const BoundarySide &side) { return side.reason == reason; }));
}

//! Pages of a book: triangles on one edge, standing at the given angles (degrees). Every second one runs the
//! other way along the edge.
test::MeshPtr book(const std::vector<double> &angles)
{
    std::vector<Vec3> points{{0, 0, 0}, {0, 0, 1}};
    std::vector<std::vector<int>> faces;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double angle = angles[i] * 0.017453292519943295;
        const int tip = static_cast<int>(points.size());
        points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
        if (i % 2 == 0)
            faces.push_back({0, 1, tip});
        else
            faces.push_back({1, 0, tip});
    }
    return test::polygonMesh(points, faces);
}

} // namespace

class TestMeshData : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void partsAreMeshes_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"grid", "quad cube", "torus", "dirty"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void partsAreMeshes()
    {
        QFETCH(QString, name);
        const auto mesh = test::meshNamed(name);
        for (int every = 1; every <= 3; ++every) {
            std::vector<bool> faces(mesh->faceCount(), false);
            for (int f = 0; f < mesh->faceCount(); f += every)
                faces[f] = true;
            const MeshPart part = partOf(*mesh, faces);
            QCOMPARE(part.mesh->validate(), std::string());
            QCOMPARE(part.mesh->faceCount(), std::count(faces.begin(), faces.end(), true));
            for (int s = 0; s < part.mesh->soupCornerCount(); ++s) {
                QCOMPARE(part.corner[part.mesh->cornerOfSoup(s)], mesh->cornerOfSoup(part.soupCornerOf(s)));
                QCOMPARE(part.mesh->vertexOfSoup(s), mesh->vertexOfSoup(part.soupCornerOf(s)));
            }
            for (std::size_t e = 0; e < part.edgePair.size(); ++e) {
                const EdgePair &own = part.mesh->edgePairs[e], &whole = mesh->edgePairs[part.edgePair[e]];
                QCOMPARE(part.soupCornerOf(own.corner[0][0]), whole.corner[0][0]);
                QCOMPARE(own.diagonal, whole.diagonal);
            }
        }
    }

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

    void signOfZeroDoesNotKeepVerticesApart()
    {
        const auto mesh =
            test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -0.0, -0.0}, {-0.0, -0.0, 0}, {0, -1, 0}},
                              {{0, 1, 2}, {3, 4, 5}});
        QCOMPARE(mesh->validate(), std::string());
        QVERIFY(mesh->vertexWeld == (std::vector<int>{0, 1, 2, 1, 0, 5}));
        QCOMPARE(mesh->report.weldedVertices, 2);
        QCOMPARE(mesh->edgePairs.size(), std::size_t(1));
    }

    void nearestDoublesAreNotWelded()
    {
        const double next = std::nextafter(1.0, 2.0);
        const auto mesh = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {next, 0, 0}, {0, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}});
        QCOMPARE(mesh->report.weldedVertices, 1);
        QVERIFY(mesh->edgePairs.empty());
    }

    void duplicatedSheetsStayApart()
    {
        // Each copy of a quad pairs with itself: its triangles are joined by the diagonal only.
        const auto quad = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                            {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 2, 3, 0}});
        QCOMPARE(quad->validate(), std::string());
        QCOMPARE(quad->report.duplicateFaces, 2);
        QCOMPARE(quad->componentCount, 3);
        // Two copies of a strip: the copies do not mix.
        const auto strip = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                             {{0, 1, 2}, {2, 1, 3}, {0, 1, 2}, {2, 1, 3}});
        QCOMPARE(strip->validate(), std::string());
        QCOMPARE(strip->componentCount, 2);
        QCOMPARE(strip->report.nonManifoldEdges, 1);
        QCOMPARE(strip->edgePairs[0].triangle, (std::array<int, 2>{0, 1}));
        QCOMPARE(strip->edgePairs[1].triangle, (std::array<int, 2>{2, 3}));
    }

    void doubleSidedSheetCloses()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                            {{0, 1, 2}, {2, 1, 3}, {2, 1, 0}, {3, 1, 2}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->report.duplicateFaces, 2);
        QVERIFY(mesh->boundarySides.empty());
        QCOMPARE(mesh->componentCount, 1);
        // Over the inner edge each side continues on its own side of the sheet.
        for (const EdgePair &pair : mesh->edgePairs) {
            const bool inner = pair.length > 1.2;
            QCOMPARE(pair.triangle[0] / 2 == pair.triangle[1] / 2, inner);
        }
    }

    void disagreeingWindingIsNotJoined()
    {
        const auto mesh =
            test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 3}});
        QCOMPARE(mesh->validate(), std::string());
        QVERIFY(mesh->edgePairs.empty());
        QCOMPARE(mesh->report.windingEdges, 1);
        QCOMPARE(mesh->report.boundaryEdges, 4);
        QCOMPARE(countOpen(*mesh, OpenSide::Winding), 2);
        QCOMPARE(mesh->componentCount, 2);
    }

    void pagesOfABookTakeTheSmoothestPartner_data()
    {
        QTest::addColumn<QList<double>>("angles");
        QTest::addColumn<QList<int>>("partners"); // triangles, two by two
        QTest::newRow("three") << QList<double>{0, 180, 90} << QList<int>{0, 1};
        QTest::newRow("three, bent") << QList<double>{0, 100, 60} << QList<int>{0, 1};
        QTest::newRow("three, second continues third") << QList<double>{0, 80, 250} << QList<int>{1, 2};
        QTest::newRow("four, crossed") << QList<double>{0, 180, 90, 270} << QList<int>{0, 1, 2, 3};
        QTest::newRow("four, two pairs") << QList<double>{0, 185, 20, 170} << QList<int>{0, 1, 2, 3};
        QTest::newRow("five") << QList<double>{0, 185, 60, 250, 120} << QList<int>{0, 1, 2, 3};
    }

    void pagesOfABookTakeTheSmoothestPartner()
    {
        QFETCH(QList<double>, angles);
        QFETCH(QList<int>, partners);
        const auto mesh = book({angles.begin(), angles.end()});
        QCOMPARE(mesh->validate(), std::string());
        QList<int> found;
        for (const EdgePair &pair : mesh->edgePairs)
            found << pair.triangle[0] << pair.triangle[1];
        QCOMPARE(found, partners);
        QCOMPARE(mesh->report.nonManifoldEdges, 1);
        QCOMPARE(countOpen(*mesh, OpenSide::NonManifold), static_cast<int>(angles.size() - partners.size()));
        QCOMPARE(mesh->report.boundaryEdges, static_cast<int>(2 * angles.size()));
    }

    void crowdedEdgeIsPairedWithoutFillingTheMemory()
    {
        std::vector<double> angles;
        for (int i = 0; i < 4000; ++i)
            angles.push_back(0.08 * i);
        const auto mesh = book(angles);
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->edgePairs.size(), std::size_t(2000));
    }

    void degenerateTrianglesAreMarked()
    {
        const auto mesh =
            test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1e-11, 0}, {1, 1e-9, 0}},
                              {{0, 1, 2},   // collinear
                               {0, 0, 3},   // a side without length
                               {1, 1, 1},   // a point
                               {0, 2, 4},   // thinner than the threshold
                               {0, 2, 5}}); // thin, but a triangle
        QCOMPARE(mesh->validate(), std::string());
        QVERIFY(mesh->triangleDegenerate == (std::vector<bool>{true, true, true, true, false}));
        QCOMPARE(mesh->report.degenerateTriangles, 4);
    }

    void triangleWithoutAreaIsABridge()
    {
        // A sliver between two halves of a sheet, as left by a T-joint: the sheet stays in one piece.
        const auto mesh = test::polygonMesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -1, 0}},
                                            {{0, 2, 3}, {2, 1, 3}, {0, 1, 2}, {1, 0, 4}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->componentCount, 1);
        QCOMPARE(mesh->edgePairs.size(), std::size_t(4));
    }

    void zeroLengthSideIsOpen()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->report.degenerateTriangles, 1);
        QCOMPARE(mesh->boundarySides.size(), std::size_t(4));
        QCOMPARE(mesh->report.boundaryEdges, 3);
        QVERIFY(mesh->report.selfContactFaces.empty());
    }

    void bridgeToAHoleIsInsideThePolygon()
    {
        // A square frame as one polygon: the bridge is run through twice and must never become a seam.
        const auto mesh = test::polygonMesh(
            {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}},
            {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->area, 12.0);
        QVERIFY(mesh->report.selfContactFaces.empty());
        QCOMPARE(mesh->triangleCount(), 8);
        QCOMPARE(countDiagonals(*mesh), 8); // seven diagonals and the bridge
        QCOMPARE(mesh->edgePairs.size(), std::size_t(8));
        QCOMPARE(mesh->report.boundaryEdges, 8);
        QCOMPARE(mesh->componentCount, 1);
    }

    void faceFoldedOntoItself()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2, 1}, {0, 1, 0}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->report.windingEdges, 0);
        QCOMPARE(mesh->report.degenerateTriangles, 3);
    }

    void polygonsThatMeetThemselvesAreOpenThere_data()
    {
        QTest::addColumn<std::vector<int>>("polygon");
        QTest::addColumn<int>("openSides"); // of the polygon
        QTest::newRow("spur over the whole polygon") << std::vector<int>{4, 5, 6, 5} << 4;
        QTest::newRow("twice through a vertex, next to it") << std::vector<int>{4, 5, 4, 6} << 4;
        QTest::newRow("spur into the polygon") << std::vector<int>{0, 1, 2, 5, 2, 3} << 4;
        QTest::newRow("two vertices twice") << std::vector<int>{4, 5, 6, 4, 6, 7} << 6;
    }
    void polygonsThatMeetThemselvesAreOpenThere()
    {
        QFETCH(std::vector<int>, polygon);
        QFETCH(int, openSides);
        const auto mesh = test::polygonMesh(
            {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}},
            {{0, 4, 5, 1}, polygon, {1, 5, 6, 2}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->report.selfContactFaces, std::vector<int>{1});
        int open = 0;
        for (const BoundarySide &side : mesh->boundarySides) {
            if (side.reason == OpenSide::SelfContact) {
                QCOMPARE(mesh->triangleFace[side.triangle], 1);
                ++open;
            }
        }
        QCOMPARE(open, openSides);
    }

    void concavePolygonsAreCounted()
    {
        const std::vector<Vec3> u{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0},
                                  {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
        const auto mesh = test::polygonMesh(u, {{0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 7}, {2, 3, 4}});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->report.polygons, 2);
        QCOMPARE(mesh->report.concavePolygons, 1);
        QCOMPARE(countDiagonals(*mesh), 6);
        double area = 0;
        for (int t = 0; t < 6; ++t)
            area += mesh->triangleArea[t];
        QCOMPARE(area, 7.0);
    }

    void objectsAreNeverJoined()
    {
        const auto mesh = MeshData::build(rows({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}}),
                                          {0, 3, 6, 9}, {0, 1, 2, 2, 1, 3, 3, 1, 4}, {0, 1, 1});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->edgePairs.size(), std::size_t(1));
        QCOMPARE(mesh->edgePairs[0].triangle, (std::array<int, 2>{1, 2}));
        QCOMPARE(mesh->report.objects, 2);
        QCOMPARE(mesh->componentCount, 2);
        QCOMPARE(mesh->report.boundaryEdges, 7);
        // The same face in two objects is no duplicate.
        const auto twice =
            MeshData::build(rows({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {0, 3, 6}, {0, 1, 2, 0, 1, 2}, {4, 7});
        QCOMPARE(twice->report.duplicateFaces, 0);
        QVERIFY(twice->edgePairs.empty());
    }

    void scaleAndPlaceChangeNothing_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("shift");
        QTest::newRow("1e-150") << 1e-150 << 0.0;
        QTest::newRow("1e-30") << 1e-30 << 0.0;
        QTest::newRow("1e30") << 1e30 << 0.0;
        QTest::newRow("4e149") << 4e149 << 0.0;
        QTest::newRow("a million away") << 1.0 << 1048576.0;
    }

    void scaleAndPlaceChangeNothing()
    {
        QFETCH(double, scale);
        QFETCH(double, shift);
        const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0},
                                       {1, 2, 0}, {0, 2, 0}, {0, 0, 1}};
        const std::vector<std::vector<int>> faces{
            {1, 2, 3, 4, 5, 0}, {1, 0, 6}, {0, 5, 6}, {0, 1, 6}, {0, 0, 6}};
        std::vector<Vec3> moved;
        for (const Vec3 &p : points)
            moved.push_back(scale * p + Vec3::Constant(shift));
        const auto plain = test::polygonMesh(points, faces);
        const auto mesh = test::polygonMesh(moved, faces);
        QCOMPARE(mesh->validate(), std::string());
        QVERIFY(mesh->triangles == plain->triangles);
        QVERIFY(mesh->triangleDegenerate == plain->triangleDegenerate);
        QVERIFY(mesh->component == plain->component);
        QCOMPARE(mesh->edgePairs.size(), plain->edgePairs.size());
        for (std::size_t i = 0; i < mesh->edgePairs.size(); ++i) {
            QCOMPARE(mesh->edgePairs[i].corner, plain->edgePairs[i].corner);
            QCOMPARE(mesh->edgePairs[i].length / scale, plain->edgePairs[i].length);
        }
        QCOMPARE(mesh->area / scale / scale, plain->area);
        QCOMPARE(mesh->report.boxDiagonal / scale, 3.0);
    }

    void dirtyMeshIsReported()
    {
        const auto mesh = test::dirty();
        QCOMPARE(mesh->validate(), std::string());
        const MeshReport &report = mesh->report;
        QCOMPARE(report.vertices, 14);
        QCOMPARE(report.weldedVertices, 1);
        QCOMPARE(report.isolatedVertices, 1);
        QCOMPARE(report.faces, 9);
        QCOMPARE(report.polygons, 5);
        QCOMPARE(report.duplicateFaces, 1);
        QCOMPARE(report.degenerateTriangles, 2);
        QCOMPARE(report.windingEdges, 3); // one of the flipped face, two of the duplicated one
        QCOMPARE(report.nonManifoldEdges, 3);
        QVERIFY(report.distanceFromOrigin > 80000);
    }

    void emptyMesh()
    {
        const auto mesh = test::polygonMesh({}, {});
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->triangleCount(), 0);
        QCOMPARE(mesh->area, 0.0);
    }

    void badInputIsRefused_data()
    {
        QTest::addColumn<QList<int>>("start");
        QTest::addColumn<QList<int>>("corners");
        QTest::addColumn<QList<int>>("objects");
        QTest::addColumn<double>("x");
        const QList<int> one{0, 3}, corners{0, 1, 2};
        QTest::newRow("index too large") << one << QList<int>{0, 1, 3} << QList<int>{0} << 0.0;
        QTest::newRow("negative index") << one << QList<int>{0, 1, -1} << QList<int>{0} << 0.0;
        QTest::newRow("two corners") << QList<int>{0, 2} << QList<int>{0, 1} << QList<int>{0} << 0.0;
        QTest::newRow("starts do not rise") << QList<int>{0, 6, 3} << corners << QList<int>{0, 0} << 0.0;
        QTest::newRow("start out of range")
            << QList<int>{0, std::numeric_limits<int>::min(), 3} << corners << QList<int>{0, 0} << 0.0;
        QTest::newRow("corners left over") << one << QList<int>{0, 1, 2, 0} << QList<int>{0} << 0.0;
        QTest::newRow("no start") << QList<int>{} << QList<int>{} << QList<int>{} << 0.0;
        QTest::newRow("objects missing") << one << corners << QList<int>{} << 0.0;
        QTest::newRow("not a number")
            << one << corners << QList<int>{0} << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("infinite") << one << corners << QList<int>{0}
                                  << std::numeric_limits<double>::infinity();
        QTest::newRow("huge") << one << corners << QList<int>{0} << -1e151;
    }

    void badInputIsRefused()
    {
        QFETCH(QList<int>, start);
        QFETCH(QList<int>, corners);
        QFETCH(QList<int>, objects);
        QFETCH(double, x);
        const std::vector<int> objectList(objects.begin(), objects.end());
        QVERIFY_THROWS_EXCEPTION(
            std::invalid_argument,
            std::ignore = MeshData::build(rows({{x, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                                          std::vector<int>(start.begin(), start.end()),
                                          std::vector<int>(corners.begin(), corners.end()), objectList));
    }

    void validateFindsDamage_data()
    {
        QTest::addColumn<std::function<void(MeshData &)>>("damage");
        const auto row = [](const char *name, std::function<void(MeshData &)> damage) {
            QTest::newRow(name) << std::move(damage);
        };
        row("corner vertex", [](MeshData &m) { m.cornerVertex[3] = 99; });
        row("face start", [](MeshData &m) { m.faceStart[2] = 7; });
        row("face object", [](MeshData &m) { m.faceObject.pop_back(); });
        row("weld size", [](MeshData &m) { m.vertexWeld.push_back(0); });
        row("weld forward", [](MeshData &m) { m.vertexWeld[0] = 1; });
        row("weld others", [](MeshData &m) { m.vertexWeld[3] = 2; });
        row("triangle lost", [](MeshData &m) { m.triangles.pop_back(); });
        row("triangle's corner", [](MeshData &m) { m.triangles[0][1] = 23; });
        row("triangle collapsed", [](MeshData &m) { m.triangles[0][1] = m.triangles[0][0]; });
        row("triangle's face", [](MeshData &m) { m.triangleFace[1] = 1; });
        row("triangle's face out of range", [](MeshData &m) { m.triangleFace[11] = 6; });
        row("first triangle of a face", [](MeshData &m) { m.faceTriangle[1] = 3; });
        row("first triangle out of range", [](MeshData &m) { m.faceTriangle[5] = 11; });
        row("first triangle lost", [](MeshData &m) { m.faceTriangle.pop_back(); });
        row("area not a number",
            [](MeshData &m) { m.triangleArea[2] = std::numeric_limits<double>::quiet_NaN(); });
        row("total area", [](MeshData &m) { m.area *= 1.001; });
        row("flags", [](MeshData &m) { m.triangleDegenerate.resize(3); });
        row("pair lost", [](MeshData &m) { m.edgePairs.pop_back(); });
        row("pair twice", [](MeshData &m) { m.edgePairs.push_back(m.edgePairs.back()); });
        row("pair's triangle", [](MeshData &m) { m.edgePairs[0].triangle[1] = 77; });
        row("pair's corner", [](MeshData &m) { m.edgePairs[0].corner[1][1] = -4; });
        row("pair's corner elsewhere", [](MeshData &m) { m.edgePairs[1].corner[0][0] += 3; });
        row("pair turned",
            [](MeshData &m) { std::swap(m.edgePairs[0].corner[0][1], m.edgePairs[0].corner[1][1]); });
        row("pair collapsed", [](MeshData &m) { m.edgePairs[0].corner[1] = m.edgePairs[0].corner[0]; });
        row("pairs out of order", [](MeshData &m) { std::swap(m.edgePairs.front(), m.edgePairs.back()); });
        row("length", [](MeshData &m) { m.edgePairs[4].length = 2; });
        row("diagonal", [](MeshData &m) { m.edgePairs[0].diagonal = !m.edgePairs[0].diagonal; });
        row("object", [](MeshData &m) { m.faceObject[5] = 1; });
        row("boundary", [](MeshData &m) { m.boundarySides.push_back({0, 0, OpenSide::Boundary}); });
        row("boundary out of range", [](MeshData &m) {
            m.boundarySides.push_back({0, 3, OpenSide::Boundary});
        });
        row("component", [](MeshData &m) { m.component[7] = 1; });
        row("component count", [](MeshData &m) { m.componentCount = 2; });
    }

    void validateFindsDamage()
    {
        QFETCH(std::function<void(MeshData &)>, damage);
        MeshData mesh = *test::quadCube();
        QCOMPARE(mesh.validate(), std::string());
        damage(mesh);
        QVERIFY(!mesh.validate().empty());
    }

    void facesOfLargeMeshesTakeTurnsByTheirPlaces()
    {
        // The triangles of a grid, written in an order without any sense.
        const auto grid = test::grid(60);
        const int count = grid->triangleCount();
        std::vector<int> start{0}, corners;
        for (int i = 0; i < count; ++i) {
            for (const int corner : grid->triangles[i * 1009L % count])
                corners.push_back(grid->cornerVertex[corner]);
            start.push_back(static_cast<int>(corners.size()));
        }
        const auto mesh = MeshData::build(grid->positions, start, corners, std::vector<int>(count, 0));
        QCOMPARE(mesh->validate(), std::string());
        QCOMPARE(mesh->edgePairs.size(), grid->edgePairs.size());
        const auto meanWay = [&](const std::function<int(int)> &faceAt) {
            double sum = 0;
            const auto place = [&](int i) { return mesh->cornerPosition(mesh->faceStart[faceAt(i)]); };
            for (int i = 1; i < count; ++i)
                sum += (place(i) - place(i - 1)).norm();
            return sum / count;
        };
        const double asWritten = meanWay([](int i) { return i; });
        const double asBuilt = meanWay([&](int i) { return mesh->triangleFace[i]; });
        QVERIFY2(asBuilt < 0.1 * asWritten, qPrintable(QStringLiteral("%1, %2").arg(asBuilt).arg(asWritten)));
    }

    void smallMeshesKeepTheOrderOfTheirFaces()
    {
        const auto mesh = test::sphere(12, 20);
        QVERIFY(std::is_sorted(mesh->triangleFace.begin(), mesh->triangleFace.end()));
    }

    void largeCapKeepsItsPairs()
    {
        // A prism over a gear of 10,000 points: two concave caps and as many quads.
        const int n = 10000;
        std::vector<Vec3> points;
        std::vector<std::vector<int>> faces(2);
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * 3.141592653589793 * i / n;
            const double radius = i % 2 == 0 ? 1 : 0.9;
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
            points.emplace_back(points.back() + Vec3::UnitZ());
            const int next = (i + 1) % n;
            faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
            faces[0].push_back(2 * (n - 1 - i));
            faces[1].push_back(2 * i + 1);
        }
        const auto mesh = test::polygonMesh(points, faces);
        QCOMPARE(mesh->validate(), std::string());
        QVERIFY(mesh->boundarySides.empty());
        QCOMPARE(countDiagonals(*mesh), n + 2 * (n - 3));
        QCOMPARE(static_cast<int>(mesh->edgePairs.size()), 3 * n + n + 2 * (n - 3));
        QCOMPARE(mesh->report.concavePolygons, 2);
    }
};

QTEST_APPLESS_MAIN(TestMeshData)

} // namespace tst_meshdata

#include "tst_meshdata.moc"
