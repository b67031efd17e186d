// Grids of quads become rectangles: widths, place and orientation; what is no grid is left.
#include "model/editing/uvgrid.h"
#include "model/plain/chart.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numeric>

namespace tst_uvgrid {

using namespace autocuts;

namespace {

std::vector<int> allFaces(const MeshData &mesh)
{
    std::vector<int> faces(mesh.faceCount());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

//! A sheet of columns x rows quads. Column i is i + 1 wide, every row is 1 high.
test::MeshPtr unevenSheet(int columns, int rows)
{
    std::vector<Vec3> points;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i)
            points.emplace_back(0.5 * i * (i + 1), j, 0);
    }
    std::vector<std::vector<int>> faces;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int first = j * (columns + 1) + i;
            faces.push_back({first, first + 1, first + columns + 2, first + columns + 1});
        }
    }
    return test::polygonMesh(points, faces);
}

UvMatrix mapped(const MeshData &mesh, const std::function<Vec2(const Vec3 &)> &place)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = place(mesh.cornerPosition(c)).transpose();
    return uv;
}

UvGrids gridsOf(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &faces)
{
    return findUvGrids(mesh, findUvTopology(mesh, uv), uv, faces);
}

//! The map after its points were put to their places.
UvMatrix placed(const MeshData &mesh, UvMatrix uv, const UvGrids &grids)
{
    const UvTopology topology = findUvTopology(mesh, uv);
    for (const UvGrid &grid : grids.grids) {
        for (const auto &[point, place] : grid.places) {
            for (int c = 0; c < mesh.cornerCount(); ++c) {
                if (topology.cornerRoot[c] == point)
                    uv.row(c) = place.transpose();
            }
        }
    }
    return uv;
}

double areaOf(const MeshData &mesh, const UvMatrix &uv)
{
    double area = 0;
    for (const auto &c : mesh.triangles)
        area += cross2(uv.row(c[0]), uv.row(c[1]), uv.row(c[2])) / 2;
    return area;
}

} // namespace

class TestUvGrid : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aBentSheetBecomesARectangle_data()
    {
        QTest::addColumn<double>("angle");
        QTest::addColumn<bool>("mirrored");
        QTest::addColumn<bool>("turned");
        QTest::newRow("as it lies") << 0.1 << false << false;
        QTest::newRow("a quarter turn") << 1.4 << false << true;
        QTest::newRow("upside down") << 3.3 << false << false;
        QTest::newRow("mirrored") << 0.2 << true << false;
        QTest::newRow("mirrored, three quarters") << -1.7 << true << true;
    }
    void aBentSheetBecomesARectangle()
    {
        QFETCH(double, angle);
        QFETCH(bool, mirrored);
        QFETCH(bool, turned);
        const test::MeshPtr mesh = unevenSheet(4, 3);
        const Eigen::Rotation2Dd turn(angle);
        const UvMatrix uv = mapped(*mesh, [&](const Vec3 &p) -> Vec2 {
            const Vec2 bent(0.05 * p.x(), 0.05 * (p.y() + 0.05 * p.x() * p.x()));
            return Vec2(0.5, 0.5) + turn * Vec2(mirrored ? -bent.x() : bent.x(), bent.y());
        });
        const UvGrids grids = gridsOf(*mesh, uv, allFaces(*mesh));
        QCOMPARE(grids.grids.size(), std::size_t(1));
        QVERIFY(grids.left.empty());
        const UvMatrix after = placed(*mesh, uv, grids);
        const double before = areaOf(*mesh, uv), area = areaOf(*mesh, after);
        QVERIFY(std::abs(area - before) < 1e-12); // the density stays
        QCOMPARE(before < 0, mirrored);
        const double density = std::sqrt(std::abs(before) / mesh->area);
        for (int face = 0; face < mesh->faceCount(); ++face) {
            for (int k = 0; k < 4; ++k) {
                const int from = mesh->faceStart[face] + k, to = mesh->faceStart[face] + (k + 1) % 4;
                const Vec2 edge = after.row(to) - after.row(from);
                const Vec3 on = mesh->cornerPosition(to) - mesh->cornerPosition(from);
                QVERIFY(std::abs(edge.norm() - density * on.norm()) < 1e-12);
                const int axis = (std::abs(on.x()) > 0) != turned ? 0 : 1;
                QVERIFY(std::abs(edge[1 - axis]) < 1e-12);
            }
        }
        // It lies where it was and hardly turned.
        double change = 0, size = 0;
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            change = std::max(change, (after.row(c) - uv.row(c)).norm());
            size = std::max(size, (uv.row(c) - uv.row(0)).norm());
        }
        QVERIFY(change < 0.4 * size);
    }

    void widthsAreMeans()
    {
        // The upper row of a trapezium is half as wide as the lower one.
        const test::MeshPtr mesh =
            test::polygonMesh({{0, 0, 0}, {2, 0, 0}, {1.5, 1, 0}, {0.5, 1, 0}}, {{0, 1, 2, 3}});
        const UvMatrix uv = mapped(*mesh, [](const Vec3 &p) { return Vec2(0.1 * p.x(), 0.1 * p.y()); });
        const UvMatrix after = placed(*mesh, uv, gridsOf(*mesh, uv, {0}));
        const Vec2 diagonal = after.row(2) - after.row(0);
        QVERIFY(std::abs(diagonal.x() - 0.15) < 1e-12);
        QVERIFY(std::abs(diagonal.y() - 0.1 * std::sqrt(1.25)) < 1e-12);
    }

    void holesAndPartsAreGrids()
    {
        const test::MeshPtr mesh = unevenSheet(4, 4);
        const UvMatrix uv = mapped(*mesh, [](const Vec3 &p) { return Vec2(p.x(), p.y() + 0.1 * p.x()); });
        // Around a hole, and the rest in one corner.
        std::vector<int> faces = allFaces(*mesh);
        std::erase_if(faces, [](int f) { return f == 5; });
        QCOMPARE(gridsOf(*mesh, uv, faces).grids.size(), std::size_t(1));
        // Two parts that do not touch.
        const UvGrids two = gridsOf(*mesh, uv, {0, 1, 14, 15});
        QCOMPARE(two.grids.size(), std::size_t(2));
        QCOMPARE(two.grids[0].faces, (std::vector<int>{0, 1}));
        QCOMPARE(two.grids[1].faces, (std::vector<int>{14, 15}));
    }

    void whatIsNoGridIsLeft()
    {
        // Three quads around a corner of a cube.
        const test::MeshPtr cube = test::quadCube();
        const UvMatrix flat =
            mapped(*cube, [](const Vec3 &p) { return Vec2(p.x() + 0.4 * p.z(), p.y() + 0.3 * p.z()); });
        const UvGrids corner = gridsOf(*cube, flat, allFaces(*cube));
        QVERIFY(corner.grids.empty());
        QCOMPARE(corner.left, allFaces(*cube));

        // A ring that is closed in the map; open, it is a grid.
        const int around = 8;
        std::vector<Vec3> points;
        std::vector<std::vector<int>> faces;
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::acos(-1.0) * i / around;
            for (const double radius : {1.0, 2.0})
                points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
            const int next = (i + 1) % around;
            faces.push_back({2 * i, 2 * i + 1, 2 * next + 1, 2 * next});
        }
        const test::MeshPtr ring = test::polygonMesh(points, faces);
        const UvMatrix closed = mapped(*ring, [](const Vec3 &p) { return Vec2(p.x(), p.y()); });
        QCOMPARE(gridsOf(*ring, closed, allFaces(*ring)).left.size(), std::size_t(around));
        std::vector<int> most = allFaces(*ring);
        most.pop_back();
        const UvGrids open = gridsOf(*ring, closed, most);
        QCOMPARE(open.grids.size(), std::size_t(1));
        QVERIFY(open.left.empty());

        // Triangles, faces without UVs.
        const test::MeshPtr triangle = test::triangle();
        QCOMPARE(gridsOf(*triangle, UvMatrix::Zero(3, 2), {0}).left, (std::vector<int>{0}));
        const test::MeshPtr sheet = unevenSheet(1, 1);
        QCOMPARE(gridsOf(*sheet, emptyLayout(*sheet), {0}).left, (std::vector<int>{0}));
    }
};

QTEST_GUILESS_MAIN(TestUvGrid)

} // namespace tst_uvgrid

#include "tst_uvgrid.moc"
