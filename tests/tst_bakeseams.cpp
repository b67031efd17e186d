// Both sides of a seam show the same in baked maps.
#include "solver/bake/lightbake.h"
#include "solver/bake/seamevening.h"
#include "support/bakejobs.h"

#include <QTest>

#include <cmath>
#include <random>

namespace tst_bakeseams {

using namespace autocuts;
using namespace autocuts::bake;
using namespace autocuts::test;

namespace {

//! A ball with bumps.
MeshPtr bumpyBall()
{
    const MeshPtr ball = sphere(120, 160);
    std::vector<Vec3> points;
    for (int v = 0; v < ball->vertexCount(); ++v) {
        const Vec3 p = ball->positions.row(v);
        points.push_back(p * (1 + 0.02 * std::sin(9 * p.x()) * std::sin(9 * p.y()) * std::sin(9 * p.z())));
    }
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < ball->faceCount(); ++f)
        faces.emplace_back(ball->cornerVertex.begin() + ball->faceStart[f],
                           ball->cornerVertex.begin() + ball->faceStart[f + 1]);
    return polygonMesh(points, faces);
}

} // namespace

class TestBakeSeams : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seamsAreNotSeen_data();
    void seamsAreNotSeen();
    void onlySeamsChange();
    void hardEdgesAndOtherTilesAreLeftOut();
    void lightIsTheSameOnBothSides();
};

void TestBakeSeams::seamsAreNotSeen_data()
{
    QTest::addColumn<int>("map");
    QTest::addColumn<int>("size");
    QTest::newRow("normal") << int(MapKind::Normal) << 2048;
    QTest::newRow("object normal") << int(MapKind::ObjectNormal) << 2048;
    QTest::newRow("height") << int(MapKind::Height) << 2048;
    // Noise of few rays, which is another one on each side.
    QTest::newRow("occlusion") << int(MapKind::Occlusion) << 512;
    QTest::newRow("bent normal") << int(MapKind::BentNormal) << 512;
    QTest::newRow("curvature") << int(MapKind::Curvature) << 512;
    QTest::newRow("thickness") << int(MapKind::Thickness) << 512;
}

//! The baked surface at the seams, drawn from both sides with numbers of eight bits.
void TestBakeSeams::seamsAreNotSeen()
{
    QFETCH(int, map);
    QFETCH(int, size);
    const auto kind = static_cast<MapKind>(map);
    BakeJob job = busyJob();
    setDetailed(job, bumpyBall(), 0.2);
    job.settings.maps = {{kind, 0}};
    job.settings.grid.width = job.settings.grid.height = size;
    job.settings.rays.rays = 8;
    job.settings.grid.perSide = 1;
    job.margin = 4;
    job.floats = false;
    const Baked result = baked(job, 2);
    Picture picture = result.maps.front();
    for (float &value : picture.values)
        value = std::round(value * 255) / 255;
    const ShadedSurface &low = job.low;
    const auto drawn = [&](int triangle, int first, int second, double t) {
        std::array<float, 3> weights{};
        weights[first % 3] = static_cast<float>(1 - t);
        weights[second % 3] = static_cast<float>(t);
        const SurfacePoint point{triangle, weights[1], weights[2]};
        std::array<float, 3> value{};
        sampleRepeated(picture, low.uvAt(point), std::span(value).first(std::size_t(picture.channels)));
        if (!isInTangentSpace(kind))
            return Vec3f(value[0], value[1], value[2]);
        const Vec3f inMap = 2 * Vec3f(value[0], value[1], value[2]) - Vec3f::Ones();
        return Vec3f(0.5F * ((low.tangentFrame(point) * inMap).normalized() + Vec3f::Ones()));
    };
    double sum = 0;
    int count = 0;
    for (const EdgePair &pair : low.mesh->edgePairs) {
        const auto uvOf = [&](int end, int which) {
            return Vec2(low.uv.row(low.mesh->cornerOfSoup(pair.corner[end][which])));
        };
        if ((uvOf(0, 0) - uvOf(0, 1)).norm() < 1e-9 && (uvOf(1, 0) - uvOf(1, 1)).norm() < 1e-9)
            continue;
        for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            const Vec3f one = drawn(pair.triangle[0], pair.corner[0][0], pair.corner[1][0], t);
            const Vec3f other = drawn(pair.triangle[1], pair.corner[0][1], pair.corner[1][1], t);
            sum += (one - other).cwiseAbs().sum() / picture.channels;
            ++count;
        }
    }
    QVERIFY(count >= 40);
    QVERIFY2(255 * sum / count <= 2, qPrintable(QString::number(255 * sum / count)));
    // What the bake says of itself; it knows no rounding.
    const std::optional<double> told = result.figures.seams.front().mean();
    QVERIFY(told);
    QVERIFY2(255 * std::abs(*told - sum / count) < 0.5, qPrintable(QString::number(255 * *told)));
}

//! Noise: the sides come together, and nothing else moves.
void TestBakeSeams::onlySeamsChange()
{
    const BakeJob job = busyJob();
    constexpr int size = 256;
    for (const int channels : {1, 3}) {
        Picture picture(size, size, channels);
        std::mt19937 random(5);
        for (float &value : picture.values)
            value = static_cast<float>(random() % 1000) / 1000;
        const Picture before = picture;
        const Eigen::AlignedBox2d tile(Vec2::Zero(), Vec2::Ones());
        const std::vector<std::uint8_t> filled(std::size_t(size) * size, 1);
        const auto apart = [&](const Picture &shown) {
            SeamDifference difference;
            compareSides(job.low, tile, shown, SeamValues::Numbers, false, difference);
            return difference.mean().value();
        };
        evenSeams(job.low, tile, false, filled, picture, {});
        QVERIFY(apart(before) > 0.1);
        QVERIFY2(apart(picture) < 0.05 * apart(before), qPrintable(QString::number(apart(picture))));
        std::vector<bool> beside(std::size_t(size) * size, false);
        for (const SeamPlace &place : seamPlaces(job.low, tile, {size, size}, 64)) {
            for (const Vec2 &uv : place.uv) {
                for (const std::size_t texel : blendAt(size, size, uv).texel)
                    beside[texel] = true;
            }
        }
        double most = 0;
        for (std::size_t i = 0; i < picture.values.size(); ++i) {
            const double change = std::abs(picture.values[i] - before.values[i]);
            QVERIFY(beside[i / channels] || change == 0);
            most = std::max(most, change);
        }
        QVERIFY(most > 0.1 && most < 1);
        // Texels without a value are not used.
        Picture untouched = before;
        evenSeams(job.low, tile, false, std::vector<std::uint8_t>(filled.size(), 0), untouched, {});
        QVERIFY(untouched.values == before.values);
    }
}

void TestBakeSeams::hardEdgesAndOtherTilesAreLeftOut()
{
    const MappedModel model = mapped(box(1), boxMap());
    ShadedSurface low = surfaceOf(model);
    const auto places = [&](double side) {
        return seamPlaces(low, {Vec2::Zero(), Vec2(side, side)}, {256, 256}, 1).size();
    };
    low.normals = shadingNormals(*model.mesh, std::vector<bool>(model.mesh->edgePairs.size(), false));
    QVERIFY(places(1) > 0);
    QCOMPARE(places(0.1), std::size_t(0));
    low.normals = shadingNormals(*model.mesh, std::vector<bool>(model.mesh->edgePairs.size(), true));
    QCOMPARE(places(1), std::size_t(0));
}

void TestBakeSeams::lightIsTheSameOnBothSides()
{
    const BakeJob job = busyJob();
    LitSurface surface;
    surface.mesh = job.low.mesh;
    surface.uv = job.low.uv;
    surface.normals = job.low.normals;
    surface.albedo = [](const SurfacePoint &) { return Vec3f(0.5F, 0.5F, 0.5F); };
    Lighting lighting;
    lighting.sky = Sky();
    lighting.sky->horizon = lighting.sky->ground = Vec3f::Zero();
    LightBakeSettings settings;
    settings.width = settings.height = 256;
    settings.samples = 4;
    settings.denoise = false;
    const LightBakeResult baked = bakeLight(surface, lighting, settings, {});
    SeamDifference difference;
    compareSides(job.low, settings.tile, baked.picture, SeamValues::Numbers, false, difference);
    QVERIFY(baked.noise > 0.05);
    QVERIFY2(difference.mean().value() < 0.01, qPrintable(QString::number(difference.mean().value())));
}

QTEST_APPLESS_MAIN(TestBakeSeams)

} // namespace tst_bakeseams

#include "tst_bakeseams.moc"
