// What each map of a bake shows, against its formula; carried textures.
#include "solver/bake/rayscene.h"
#include "support/bakejobs.h"

#include <QTest>

#include <cmath>

namespace tst_bakemaps {

using namespace autocuts;
using namespace autocuts::bake;
using namespace autocuts::test;

namespace {

//! A smooth picture.
std::shared_ptr<const Picture> waves(int size)
{
    auto picture = std::make_shared<Picture>(size, size, 3);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double u = (x + 0.5) / size, v = (y + 0.5) / size;
            picture->at(x, y)[0] = static_cast<float>(0.5 + 0.4 * std::sin(20 * u + 3));
            picture->at(x, y)[1] = static_cast<float>(0.5 + 0.4 * std::sin(24 * v));
            picture->at(x, y)[2] = static_cast<float>(0.5 + 0.4 * std::sin(16 * (u + v)));
        }
    }
    return picture;
}

BakeJob carryingJob(const MappedModel &from, const MappedModel &to, std::shared_ptr<const Picture> picture,
                    TextureKind kind)
{
    BakeJob job = jobFor(to, {{MapKind::Texture, 0}}, picture->width);
    job.high = surfaceOf(from);
    job.high->textures = {{kind, {{{}, std::move(picture)}}}};
    job.kind = SourceKind::SameTriangles;
    job.floats = false;
    job.settings.grid.perSide = 2;
    return job;
}

} // namespace

class TestBakeMaps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void occlusionBesideAWall();
    void bentNormalsLeanAway();
    void curvatureOfSpheres_data();
    void curvatureOfSpheres();
    void thicknessOfASlab();
    void positionsAndMaterials();
    void texturesAreCarried();
    void carriedNormalsTurn();
    void asManyObjectsAsAFileHas();
};

//! The floor beside a wall of infinite length: (1 + cos a) / 2 with the elevation a of the wall's top.
void TestBakeMaps::occlusionBesideAWall()
{
    MappedModel room;
    constexpr double far = 1000;
    room.mesh =
        test::polygonMesh({{0, -far, 0}, {2, -far, 0}, {2, far, 0}, {0, far, 0}, {0, -far, 1}, {0, far, 1}},
                          {{0, 1, 2, 3}, {0, 3, 5, 4}});
    // The map shows the floor's middle only.
    room = test::mapped(room.mesh, [](const Vec3 &p, const Vec3 &centre) {
        return centre.z() > 0 ? Vec2(9, 9) : Vec2(p.x() / 2, p.y() + 0.5);
    });
    BakeJob job = jobFor(room, {{MapKind::Occlusion, 0}}, 16);
    job.settings.rays.rays = 4096;
    const Picture picture = only(job);
    for (const int x : {1, 4, 12}) {
        const double distance = (x + 0.5) / 8, elevation = std::atan2(1.0, distance);
        QVERIFY2(std::abs(picture.at(x, 8)[0] - (1 + std::cos(elevation)) / 2) < 0.01,
                 qPrintable(QString::number(picture.at(x, 8)[0])));
    }
    job.settings.rays.reach = 1e-6;
    QCOMPARE(only(job).at(4, 8)[0], 1.0F);
}

void TestBakeMaps::bentNormalsLeanAway()
{
    MappedModel room;
    room.mesh = test::polygonMesh({{0, -9, 0}, {2, -9, 0}, {2, 9, 0}, {0, 9, 0}, {0, -9, 1}, {0, 9, 1}},
                                  {{0, 1, 2, 3}, {0, 3, 5, 4}});
    room = test::mapped(room.mesh, [](const Vec3 &p, const Vec3 &centre) {
        return centre.z() > 0 ? Vec2(9, 9) : Vec2(p.x() / 2, p.y() / 2 + 0.5);
    });
    BakeJob job = jobFor(room, {{MapKind::BentNormal, 0}}, 16);
    job.settings.rays.rays = 1024;
    const Picture picture = only(job);
    const Vec3f close = directionAt(picture, 1, 8), away = directionAt(picture, 15, 8);
    QVERIFY(close.x() > 0.3F);
    QVERIFY(away.x() < close.x());
    QVERIFY(std::abs(close.y()) < 0.05F);
    QVERIFY(std::abs(close.norm() - 1) < 1e-3F);
}

void TestBakeMaps::curvatureOfSpheres_data()
{
    QTest::addColumn<bool>("inside");
    QTest::newRow("convex") << false;
    QTest::newRow("concave") << true;
}

void TestBakeMaps::curvatureOfSpheres()
{
    QFETCH(bool, inside);
    test::MeshPtr mesh = test::sphere(64, 128);
    if (inside) {
        std::vector<std::vector<int>> faces;
        std::vector<Vec3> points;
        for (int v = 0; v < mesh->vertexCount(); ++v)
            points.push_back(mesh->positions.row(v));
        for (int f = 0; f < mesh->faceCount(); ++f)
            faces.emplace_back(mesh->cornerVertex.rbegin() + (mesh->cornerCount() - mesh->faceStart[f + 1]),
                               mesh->cornerVertex.rbegin() + (mesh->cornerCount() - mesh->faceStart[f]));
        mesh = test::polygonMesh(points, faces);
    }
    const MappedModel ball = test::mapped(mesh, [](const Vec3 &p, const Vec3 &centre) {
        return centre.z() > 0 ? Vec2(p.head<2>() / 2 + Vec2(0.5, 0.5)) : Vec2(9, 9);
    });
    BakeJob job = jobFor(ball, {{MapKind::Curvature, 0}}, 8);
    job.settings.rays.rays = 8192;
    const double radius = 0.5; // of the ball around the point; the sphere has radius 1
    job.settings.rays.curvatureRadius = radius / Frame::of(*mesh).size;
    const double curvature = only(job).at(3, 4)[0];
    QVERIFY2(std::abs(curvature - (inside ? -radius : radius)) < 0.03,
             qPrintable(QString::number(curvature)));
    job.floats = false;
    QVERIFY(std::abs(only(job).at(3, 4)[0] - (0.5 + 0.5 * curvature)) < 1e-6);
}

void TestBakeMaps::thicknessOfASlab()
{
    // A box of 20 x 20 x 1; the map shows the middle of its top.
    const MappedModel slab =
        test::mapped(test::box(1, Vec3(20, 20, 1)), [](const Vec3 &p, const Vec3 &centre) {
            return centre.z() > 0.4 ? Vec2(p.x() + 0.5, p.y() + 0.5) : Vec2(99, 99);
        });
    BakeJob job = jobFor(slab, {{MapKind::Thickness, 0}}, 4);
    job.settings.rays.rays = 8192;
    const double limit = 4;
    job.settings.rays.thicknessLimit = limit / Frame::of(*slab.mesh).size;
    // The mean of min(1 / c, limit) / limit over directions with density 2 c of their cosine c.
    const double expected = (2 / limit) * (1 - 1 / limit) + 1 / (limit * limit);
    QVERIFY(std::abs(only(job).at(2, 2)[0] - expected) < 0.01);
}

void TestBakeMaps::positionsAndMaterials()
{
    BakeJob job =
        jobFor(plane(4), {{MapKind::Position, 0}, {MapKind::MaterialId, 0}, {MapKind::Color, 0}}, 4);
    job.low.faceMaterial = {0};
    job.low.materialColors = {{0.25F, 0.5F, 1}};
    const Baked floats = baked(job);
    QVERIFY(
        (Vec3f(floats.maps[0].at(0, 0)[0], floats.maps[0].at(0, 0)[1], 0) - Vec3f(-1.5F, 1.5F, 0)).norm() <
        1e-5F);
    QCOMPARE(floats.maps[2].at(1, 1)[0], 0.25F);
    job.floats = false;
    const Baked whole = baked(job);
    QVERIFY(std::abs(whole.maps[0].at(0, 0)[0] - 0.125F) < 1e-5F);
    QCOMPARE(whole.maps[2].at(1, 1)[0], srgbFromLinear(0.25F));
    const auto id = whole.maps[1].at(1, 1);
    job.low.faceMaterial = {1};
    const Picture other = baked(job).maps[1];
    QVERIFY(std::abs(other.at(1, 1)[0] - id[0]) + std::abs(other.at(1, 1)[1] - id[1]) > 0.2F);
    job.low.cornerColors = std::make_shared<const CornerColors>(4, CornerColor::fromLinear(0.1, 0.2, 0.3));
    job.floats = true;
    QVERIFY(std::abs(baked(job).maps[2].at(1, 1)[2] - 0.3F) < 1e-5F);
}

//! To another map and back.
void TestBakeMaps::texturesAreCarried()
{
    const test::MeshPtr mesh = test::box(6);
    const MappedModel first =
        test::mapped(mesh, [](const Vec3 &p, const Vec3 &c) { return Vec2(1.5 * test::boxMap()(p, c)); });
    const MappedModel second = test::mapped(mesh, [&](const Vec3 &p, const Vec3 &c) {
        const Vec2 uv = 1.5 * test::boxMap()(p, c);
        return Vec2(0.98 - 0.9 * uv.y(), 0.03 + 0.9 * uv.x()); // turned by a right angle, and smaller
    });
    for (const TextureKind kind : {TextureKind::Srgb, TextureKind::Linear}) {
        const auto picture = waves(512);
        const auto there = std::make_shared<const Picture>(only(carryingJob(first, second, picture, kind)));
        const BakeJob back = carryingJob(second, first, there, kind);
        const Picture again = only(back);
        // Where the first map has islands.
        const TexelSurface texels(*mesh, first.uv, {512, 512, {Vec2::Zero(), Vec2::Ones()}, 1});
        double squared = 0;
        long long count = 0;
        TexelRows rows;
        for (int band = 0; band < texels.bandCount(); ++band) {
            texels.makeBand(band, rows);
            for (int i = 0; i < rows.count * 512; ++i) {
                if (!rows.inside[i])
                    continue;
                for (int k = 0; k < 3; ++k) {
                    const int x = i % 512, y = rows.first + i / 512;
                    squared += std::pow(again.at(x, y)[k] - picture->at(x, y)[k], 2);
                    ++count;
                }
            }
        }
        QVERIFY(count > 100000);
        const double psnr = -10 * std::log10(squared / double(count));
        QVERIFY2(psnr > 45, qPrintable(QString::number(psnr)));
    }
}

//! When an island is turned, so are the directions in its normal map.
void TestBakeMaps::carriedNormalsTurn()
{
    const MappedModel first = plane();
    MappedModel turned = first, mirrored = first;
    for (Eigen::Index i = 0; i < first.uv.rows(); ++i) {
        turned.uv.row(i) = Eigen::RowVector2d(1 - first.uv(i, 1), first.uv(i, 0));
        mirrored.uv.row(i) = Eigen::RowVector2d(1 - first.uv(i, 0), first.uv(i, 1));
    }
    const Vec3f normal = Vec3f(0.6F, 0.2F, 0.7F).normalized();
    auto picture = std::make_shared<Picture>(8, 8, 3);
    for (int i = 0; i < 64; ++i) {
        for (int k = 0; k < 3; ++k)
            picture->at(i % 8, i / 8)[k] = 0.5F + 0.5F * normal[k];
    }
    const auto carried = [&](const MappedModel &to, TextureKind kind) {
        return directionAt(only(carryingJob(first, to, picture, kind)), 3, 3);
    };
    const float x = normal.x(), y = normal.y(), z = normal.z();
    QVERIFY((carried(first, TextureKind::Normal) - normal).norm() < 1e-3F);
    // u of the first map runs along v of the turned one, v against u.
    QVERIFY((carried(turned, TextureKind::Normal) - Vec3f(-y, x, z)).norm() < 1e-3F);
    QVERIFY((carried(mirrored, TextureKind::Normal) - Vec3f(-x, y, z)).norm() < 1e-3F);
    QVERIFY((carried(turned, TextureKind::NormalDirectX) - Vec3f(y, -x, z)).norm() < 1e-3F);
}

//! Objects that are paired by name have a tree of rays each. There was room for about a thousand.
void TestBakeMaps::asManyObjectsAsAFileHas()
{
    const auto mesh = test::box(1);
    const Frame frame = Frame::of(*mesh);
    std::vector<RayScene> scenes;
    for (int i = 0; i < 1500; ++i)
        scenes.emplace_back(*mesh, frame);
    const Vec3f outside(2, 0.1F, 0.2F), inwards(-1, 0, 0);
    QVERIFY(scenes.front().nearest(outside, inwards, 0, endless).point.triangle >= 0);
    QCOMPARE(scenes.back().nearest(outside, inwards, 0, endless).distance,
             scenes.front().nearest(outside, inwards, 0, endless).distance);
}

QTEST_APPLESS_MAIN(TestBakeMaps)

} // namespace tst_bakemaps

#include "tst_bakemaps.moc"
