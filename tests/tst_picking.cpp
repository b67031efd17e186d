// Picking on the model and in the map; all without OpenGL.
#include "model/plain/meshadjacency.h"
#include "solver/base/random.h"
#include "support/meshbuilders.h"
#include "views/canvas/depthmap.h"
#include "views/canvas/mappicker.h"
#include "views/canvas/meshpicker.h"

#include <QTest>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tst_picking {

using namespace autocuts;
using test::MeshPtr;

namespace {

//! A mesh with all that picking on it needs.
struct Picked
{
    explicit Picked(MeshPtr m)
        : mesh(m), frame(MeshFrame::of(*mesh)), topology(*mesh), picker(mesh, frame, topology)
    {}

    MeshPtr mesh;
    MeshFrame frame;
    SoupTopology topology;
    MeshPicker picker;
};

OrbitCamera cameraAt(double yaw, double pitch, bool orthographic = false)
{
    OrbitCamera camera;
    camera.setViewSize({600, 500});
    camera.frame(Vec3::Zero(), 1);
    camera.setDirection(yaw, pitch);
    camera.setOrthographic(orthographic);
    return camera;
}

//! The front-most triangle by areas on the screen, an independent way.
int frontMost(const Picked &picked, const OrbitCamera &camera, const QPointF &pixel)
{
    int best = -1;
    double bestDepth = std::numeric_limits<double>::infinity();
    const Vec2 mouse(pixel.x(), pixel.y());
    for (int t = 0; t < picked.mesh->triangleCount(); ++t) {
        std::array<Vec2, 3> p;
        std::array<double, 3> depth;
        for (int k = 0; k < 3; ++k) {
            const auto seen = camera.project(
                picked.frame.toFrame(picked.mesh->cornerPosition(picked.mesh->triangles[t][k])));
            p[k] = Vec2(seen->x, seen->y);
            depth[k] = seen->depth;
        }
        const double area = cross2(p[0], p[1], p[2]);
        const double a = cross2(mouse, p[1], p[2]) / area, b = cross2(p[0], mouse, p[2]) / area,
                     c = 1 - a - b;
        if (!(a >= 0 && b >= 0 && c >= 0))
            continue;
        const double d = camera.isOrthographic() ? a * depth[0] + b * depth[1] + c * depth[2]
                                                 : 1 / (a / depth[0] + b / depth[1] + c / depth[2]);
        if (d < bestDepth) {
            bestDepth = d;
            best = t;
        }
    }
    return best;
}

bool facesTheEye(const Picked &picked, const OrbitCamera &camera, int triangle)
{
    std::array<Vec3, 3> p;
    for (int k = 0; k < 3; ++k)
        p[k] = picked.frame.toFrame(picked.mesh->cornerPosition(picked.mesh->triangles[triangle][k]));
    const Vec3 toEye = camera.isOrthographic() ? Vec3(-camera.forward()) : Vec3(camera.eye() - p[0]);
    return (p[1] - p[0]).cross(p[2] - p[0]).dot(toEye) > 0;
}

MeshPtr moved(const MeshPtr &mesh, double scale, const Vec3 &offset)
{
    PositionMatrix positions = mesh->positions * scale;
    positions.rowwise() += offset.transpose();
    return MeshData::build(positions, mesh->faceStart, mesh->cornerVertex, mesh->faceObject);
}

UvMatrix soupUv(const MeshData &mesh, double (*u)(const Vec3 &), double (*v)(const Vec3 &))
{
    UvMatrix uv(mesh.soupCornerCount(), 2);
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        const Vec3 p = mesh.cornerPosition(mesh.cornerOfSoup(s));
        uv.row(s) << u(p), v(p);
    }
    return uv;
}

UvMatrix flatUv(const MeshData &mesh)
{
    return soupUv(
        mesh, [](const Vec3 &p) { return p.x(); }, [](const Vec3 &p) { return p.y(); });
}

MapCamera mapCamera(double scale = 400)
{
    MapCamera camera;
    camera.setViewSize({600, 600});
    camera.setScale(scale);
    return camera;
}

} // namespace

class TestPicking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheFrontMostTriangle_data()
    {
        QTest::addColumn<MeshPtr>("mesh");
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("sphere") << test::sphere(12, 20) << false;
        QTest::newRow("sphere, orthographic") << test::sphere(12, 20) << true;
        QTest::newRow("torus") << test::torus(16, 10) << false;
        QTest::newRow("tiny and far away") << moved(test::torus(16, 10), 1e-3, {1e6, -2e6, 5e5}) << false;
        QTest::newRow("huge") << moved(test::torus(16, 10), 1e20, {0, 0, 0}) << false;
    }

    void findsTheFrontMostTriangle()
    {
        QFETCH(MeshPtr, mesh);
        QFETCH(bool, orthographic);
        const Picked picked(mesh);
        Random random(5);
        int hits = 0;
        for (int i = 0; i < 400; ++i) {
            const OrbitCamera camera =
                cameraAt(random.uniform(-3, 3), random.uniform(-1.5, 1.5), orthographic);
            const QPointF pixel(random.uniform(0, 600), random.uniform(0, 500));
            const int expected = frontMost(picked, camera, pixel);
            QCOMPARE(picked.picker.pick(camera, pixel).triangle, expected);
            hits += expected >= 0;
        }
        QVERIFY2(hits > 60, qPrintable(QString::number(hits)));
    }

    void seesFromInside()
    {
        const Picked picked(test::sphere(12, 20));
        OrbitCamera camera = cameraAt(0.3, 0.2);
        camera.setDistance(0.01);
        for (double x = 10; x < 600; x += 50)
            QVERIFY(picked.picker.pick(camera, {x, 123}).triangle >= 0);
    }

    void edgesAndCornersAreNeverHidden()
    {
        const Picked picked(test::sphere(14, 24));
        const OrbitCamera camera = cameraAt(0.4, 0.3);
        const MeshAdjacency adjacency(*picked.mesh);
        int edges = 0, corners = 0;
        for (double y = 3; y < 500; y += 11) {
            for (double x = 5; x < 600; x += 13) {
                const PickResult pick = picked.picker.pick(camera, {x, y});
                if (pick.edge >= 0) {
                    ++edges;
                    const auto &sides = picked.topology.edgeSides[pick.edge];
                    QVERIFY(std::any_of(sides.begin(), sides.end(), [&](int side) {
                        return side >= 0 && facesTheEye(picked, camera, side / 3);
                    }));
                    QCOMPARE(picked.topology.sideEdge[pick.side], pick.edge);
                }
                if (pick.corner >= 0) {
                    ++corners;
                    const int vertex = picked.mesh->vertexWeld[picked.mesh->cornerVertex[pick.corner]];
                    const auto around = adjacency.vertexCorners(vertex);
                    QVERIFY(std::any_of(around.begin(), around.end(), [&](int corner) {
                        const int face = adjacency.faceOfCorner(corner);
                        return facesTheEye(picked, camera, picked.mesh->faceTriangle[face]);
                    }));
                }
            }
        }
        QVERIFY(edges > 100 && corners > 30);
    }

    void edgesArePickedWithinEightPixels()
    {
        const Picked picked(test::quadCube());
        const OrbitCamera camera = cameraAt(0, 0); // straight at the face z = 1
        const auto at = [&](const Vec3 &p) {
            const auto seen = camera.project(picked.frame.toFrame(p));
            return QPointF(seen->x, seen->y);
        };
        // The lower side of the front face, from above it.
        const QPointF middle = at({0.5, 0, 1});
        const PickResult near = picked.picker.pick(camera, middle - QPointF(0, 7.5));
        QVERIFY(near.edge >= 0);
        const auto &side = picked.topology.edgeSides[near.edge];
        for (int soup : {side[0], nextSoupCorner(side[0])}) {
            const Vec3 p = picked.mesh->cornerPosition(picked.mesh->cornerOfSoup(soup));
            QCOMPARE(p.y(), 0.0);
            QCOMPARE(p.z(), 1.0);
        }
        // Of the two faces at the edge the one under the mouse.
        QCOMPARE(near.side / 3, near.triangle);
        QCOMPARE(picked.picker.pick(camera, middle - QPointF(0, 8.5)).edge, -1);
        // Outside the model, too.
        QCOMPARE(picked.picker.pick(camera, middle + QPointF(0, 7.5)).edge, near.edge);
        QCOMPARE(picked.picker.pick(camera, middle + QPointF(0, 7.5)).triangle, -1);
        // The diagonal through the middle of the face is no edge.
        const PickResult centre = picked.picker.pick(camera, at({0.5, 0.5, 1}));
        QVERIFY(centre.triangle >= 0);
        QCOMPARE(centre.edge, -1);
        QCOMPARE(centre.corner, -1);
        const PickResult corner = picked.picker.pick(camera, at({1, 1, 1}) + QPointF(-4, 4));
        QVERIFY(corner.corner >= 0);
        QCOMPARE(picked.mesh->cornerPosition(corner.corner), Vec3(1, 1, 1));
    }

    void boxesTakeWhatIsVisible_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("perspective") << false;
        QTest::newRow("orthographic") << true;
    }

    void boxesTakeWhatIsVisible()
    {
        QFETCH(bool, orthographic);
        const Picked picked(test::sphere(20, 30));
        const OrbitCamera camera = cameraAt(0.5, 0.4, orthographic);
        const BoxPick all = picked.picker.pickBox(camera, QRectF(0, 0, 600, 500));
        std::vector<int> expected;
        for (int f = 0; f < picked.mesh->faceCount(); ++f) {
            if (facesTheEye(picked, camera, f))
                expected.push_back(f);
        }
        // Faces on the rim can go either way.
        std::vector<int> differing;
        std::set_symmetric_difference(all.faces.begin(), all.faces.end(), expected.begin(), expected.end(),
                                      std::back_inserter(differing));
        QVERIFY2(differing.size() * 12 < expected.size(), qPrintable(QString::number(differing.size())));
        QVERIFY(!all.edges.empty() && !all.corners.empty());
        QVERIFY(static_cast<int>(all.corners.size()) < picked.mesh->cornerCount());
        const BoxPick none = picked.picker.pickBox(camera, QRectF(0, 0, 5, 5));
        QVERIFY(none.faces.empty() && none.edges.empty() && none.corners.empty());
    }

    void boxesLeaveOutWhatIsOutside()
    {
        const Picked picked(test::quadCube());
        const OrbitCamera camera = cameraAt(0, 0);
        const BoxPick left = picked.picker.pickBox(camera, QRectF(0, 0, 280, 500));
        for (int corner : left.corners)
            QCOMPARE(picked.mesh->cornerPosition(corner).x(), 0.0);
        QCOMPARE(left.faces.size(), 0u);
        QCOMPARE(left.edges.size(),
                 1u); // the left side of the front face; what is behind is smaller and hidden
    }

    void depthMapsKeepTheNearest()
    {
        DepthMap map(QRectF(0, 0, 40, 40));
        map.add({ScreenPoint{0, 0, 5}, {40, 0, 5}, {0, 40, 5}}, true);
        QVERIFY(!map.isVisible({10, 10, 6}));
        QVERIFY(map.isVisible({10, 10, 5}));
        QVERIFY(map.isVisible({10, 10, 4}));
        QVERIFY(map.isVisible({35, 35, 9}));
        map.add({ScreenPoint{0, 0, 3}, {40, 0, 3}, {0, 40, 3}}, true);
        QVERIFY(!map.isVisible({10, 10, 5}));
        // Wild coordinates do no harm.
        map.add({ScreenPoint{-1e12, 0, 2}, {1e12, -1e9, 2}, {0, 1e12, 2}}, true);
        QVERIFY(!map.isVisible({35, 35, 9}));
    }

    void mapFindsTrianglesEdgesAndCorners()
    {
        const MeshPtr mesh = test::grid(4);
        const SoupTopology topology(*mesh);
        const UvMatrix uv = flatUv(*mesh);
        const MapCamera camera = mapCamera();
        const auto pickAt = [&](double u, double v, QPointF offset = {}) {
            return pickMap(*mesh, topology, uv, camera, camera.toScreen(Vec2(u, v)) + offset);
        };
        const PickResult inside = pickAt(0.6, 0.35);
        QCOMPARE(mesh->triangleFace[inside.triangle], 4 + 2); // second row, third column
        QCOMPARE(inside.edge, -1);
        const PickResult edge = pickAt(0.5, 0.4, {-6, 0});
        QVERIFY(edge.edge >= 0);
        QCOMPARE(mesh->triangleFace[edge.side / 3], mesh->triangleFace[edge.triangle]);
        QCOMPARE(pickAt(0.5, 0.4, {-9, 0}).edge, -1);
        const PickResult corner = pickAt(0.5, 0.5, {3, 3});
        QVERIFY(corner.corner >= 0);
        QCOMPARE(mesh->cornerPosition(corner.corner), Vec3(0.5, 0.5, 0));
        QCOMPARE(corner.soupCorner / 3, corner.triangle);
        QCOMPARE(pickAt(1.3, 0.5).triangle, -1);
    }

    void mapFindsFlippedAndTheUpper()
    {
        const MeshPtr mesh = test::grid(1);
        const SoupTopology topology(*mesh);
        UvMatrix uv = flatUv(*mesh);
        uv.col(0) = 1 - uv.col(0).array(); // mirrored
        const MapCamera camera = mapCamera();
        QVERIFY(pickMap(*mesh, topology, uv, camera, {250, 350}).triangle >= 0);
        for (int k = 0; k < 3; ++k)
            uv.row(3 + k) = uv.row(k); // both on one place
        QCOMPARE(
            pickMap(*mesh, topology, uv, camera, camera.toScreen((uv.row(0) + uv.row(1) + uv.row(2)) / 3))
                .triangle,
            1);
        uv.row(4).setConstant(std::numeric_limits<double>::quiet_NaN());
        const PickResult pick =
            pickMap(*mesh, topology, uv, camera, camera.toScreen((uv.row(0) + uv.row(1) + uv.row(2)) / 3));
        QCOMPARE(pick.triangle, 0);
        QVERIFY(pick.soupCorner < 3);
    }

    void mapBoxes()
    {
        const MeshPtr mesh = test::grid(4);
        const SoupTopology topology(*mesh);
        const UvMatrix uv = flatUv(*mesh);
        const MapCamera camera = mapCamera();
        const QRectF box(camera.toScreen(Vec2(-0.1, 0.55)), camera.toScreen(Vec2(0.3, -0.1)));
        const BoxPick pick = pickMapBox(*mesh, topology, uv, camera, box);
        QCOMPARE(pick.faces, (std::vector<int>{0, 4}));
        QCOMPARE(pick.edges.size(), 7u); // 3 along u and 4 along v
        for (int corner : pick.corners) {
            QVERIFY(mesh->cornerPosition(corner).x() < 0.3);
            QVERIFY(mesh->cornerPosition(corner).y() < 0.55);
        }
        QCOMPARE(pick.corners.size(), 15u); // of 6 vertices
    }
};

QTEST_APPLESS_MAIN(TestPicking)

} // namespace tst_picking

#include "tst_picking.moc"
