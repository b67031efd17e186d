// The light bake, against what can be computed by hand.
#include "model/plain/shadingnormals.h"
#include "solver/bake/lightbake.h"
#include "solver/bake/lightjob.h"
#include "support/meshbuilders.h"

#include <Eigen/Geometry>

#include <QTest>

#include <cmath>
#include <numbers>
#include <thread>

namespace tst_lightbake {

using namespace autocuts;
using namespace autocuts::bake;

namespace {

constexpr double pi = std::numbers::pi;

//! A surface whose faces lie in the map as a grid of squares, each with its corners in the corners of a
//! square.
LitSurface gridded(const test::MeshPtr &mesh, float albedo)
{
    LitSurface surface;
    surface.mesh = mesh;
    surface.normals = shadingNormals(*mesh, {});
    surface.albedo = [albedo](const SurfacePoint &) { return Vec3f::Constant(albedo); };
    const int columns = static_cast<int>(std::ceil(std::sqrt(double(mesh->faceCount()))));
    surface.uv.resize(mesh->cornerCount(), 2);
    for (int f = 0; f < mesh->faceCount(); ++f) {
        const Vec2 low(f % columns, f / columns);
        const std::array<Vec2, 4> square{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
        for (int k = 0; mesh->faceStart[f] + k < mesh->faceStart[f + 1]; ++k)
            surface.uv.row(mesh->faceStart[f] + k) =
                ((low + Vec2(.05, .05) + .9 * square[k]) / columns).transpose();
    }
    return surface;
}

//! The unit cube with its faces inwards.
test::MeshPtr room()
{
    const test::MeshPtr cube = test::quadCube();
    std::vector<int> corners;
    for (int f = 0; f < cube->faceCount(); ++f) {
        for (int c = cube->faceStart[f + 1] - 1; c >= cube->faceStart[f]; --c)
            corners.push_back(cube->cornerVertex[c]);
    }
    return MeshData::build(cube->positions, cube->faceStart, corners, cube->faceObject);
}

//! A square of side 2 in the plane z = 0 around the origin, faced upwards, that fills the whole map.
LitSurface ground(float albedo = .5F)
{
    LitSurface surface =
        gridded(test::polygonMesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}), albedo);
    surface.uv << 0, 0, 1, 0, 1, 1, 0, 1;
    return surface;
}

LightBakeSettings settings(int size, int samples)
{
    LightBakeSettings result;
    result.width = result.height = size;
    result.samples = samples;
    result.denoise = false;
    result.margin = 0;
    return result;
}

double meanOf(const LightBakeResult &result)
{
    double sum = 0;
    long long count = 0;
    for (std::size_t i = 0; i < result.filled.size(); ++i) {
        if (result.filled[i]) {
            sum += double(result.picture.values[3 * i]);
            ++count;
        }
    }
    return sum / double(count);
}

//! Irradiance, as a share of its radiosity, that a rectangle at a height gives to the point below one of its
//! corners, parallel to it (Howell, configuration B-3).
double formFactor(double a, double b, double height)
{
    const double x = a / height, y = b / height;
    const double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * pi);
}

double formFactorBelow(double x, double y, double half, double height)
{
    const auto part = [&](double a, double b) {
        return std::copysign(1.0, a) * std::copysign(1.0, b) * formFactor(std::abs(a), std::abs(b), height);
    };
    return part(half - x, half - y) + part(half + x, half - y) + part(half - x, half + y) +
           part(half + x, half + y);
}

//! The error of the worst texel, as a share of the value that it should have, or of a quarter of the largest
//! one where it should have less.
template <typename Expected>
double worstError(const LightBakeResult &result, Expected expected)
{
    double worst = 0, brightest = 0;
    const int size = result.picture.width;
    for (const float value : result.picture.values)
        brightest = std::max(brightest, double(value));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double value = expected((x + .5) * 2 / size - 1, 1 - (y + .5) * 2 / size);
            worst = std::max(worst, std::abs(double(result.picture.at(x, y)[0]) - value) /
                                        std::max(value, .25 * brightest));
        }
    }
    return worst;
}

//! A square that shines down. \param x and y of its centre
AreaLight lampAbove(double height, double half, float radiance, double middle = 0)
{
    AreaLight lamp;
    lamp.centre = {middle, middle, height};
    lamp.right = {half, 0, 0};
    lamp.up = {0, -half, 0}; // right x up looks down
    lamp.radiance = Vec3f::Constant(radiance);
    return lamp;
}

} // namespace

class TestLightBake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! In a closed room whose walls shine and reflect, light is the same everywhere: e / (1 - a).
    void furnace_data()
    {
        QTest::addColumn<float>("albedo");
        QTest::addColumn<int>("bounces");
        QTest::newRow("black") << 0.F << 4;
        QTest::newRow("half") << .5F << 40;
        QTest::newRow("bright") << .8F << 100;
        QTest::newRow("half, direct only") << .5F << 0;
        QTest::newRow("half, one bounce") << .5F << 1;
    }

    void furnace()
    {
        QFETCH(float, albedo);
        QFETCH(int, bounces);
        LitSurface surface = gridded(room(), albedo);
        surface.emission.assign(6, Vec3f::Ones());
        LightBakeSettings how = settings(24, 512);
        how.bounces = bounces;
        const LightBakeResult result = bakeLight(surface, {}, how, {});
        double expected = 0;
        for (int i = 0; i <= bounces; ++i)
            expected += std::pow(double(albedo), i);
        const double mean = meanOf(result);
        QVERIFY2(std::abs(mean / expected - 1) < .01, qPrintable(QString::number(mean / expected)));
        QVERIFY(result.noise < .1);
    }

    //! A white sky of radiance 1 gives every point of a convex body light of 1, and nothing is reflected.
    void skyAroundABox()
    {
        Lighting lighting;
        lighting.sky = Sky{};
        const LightBakeResult result =
            bakeLight(gridded(test::quadCube(), 1), lighting, settings(24, 16), {});
        for (std::size_t i = 0; i < result.filled.size(); ++i)
            QVERIFY(!result.filled[i] || std::abs(result.picture.values[3 * i] - 1) < 1e-5F);
    }

    //! A light that is a rectangle, and the same one made of faces.
    void rectangleAboveAPlane_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("high") << 2.0 << 1024 << .005;
        QTest::newRow("near") << .1 << 16384 << .02;
    }

    void rectangleAboveAPlane()
    {
        QFETCH(double, height);
        QFETCH(int, samples);
        QFETCH(double, tolerance);
        Lighting lighting;
        lighting.areas.push_back(lampAbove(height, .5, 3));
        const LightBakeResult result = bakeLight(ground(), lighting, settings(8, samples), {});
        // Radiance L has radiosity pi L, so that light is L times the form factor; means over 4 x 4 points.
        const auto expected = [&](double x, double y) {
            double sum = 0;
            for (int i = 0; i < 16; ++i)
                sum += 3 * formFactorBelow(x + (i % 4 - 1.5) / 16, y + (i / 4 - 1.5) / 16, .5, height);
            return sum / 16;
        };
        const double error = worstError(result, expected);
        QVERIFY2(error < tolerance, qPrintable(QString::number(error)));
    }

    void facesThatShineAboveAPlane()
    {
        LitSurface surface = ground(0);
        surface.mesh = test::polygonMesh({{-1, -1, 0},
                                          {1, -1, 0},
                                          {1, 1, 0},
                                          {-1, 1, 0},
                                          {-.5, -.5, .7},
                                          {.5, -.5, .7},
                                          {.5, .5, .7},
                                          {-.5, .5, .7}},
                                         {{0, 1, 2, 3}, {4, 5, 6, 7}});
        surface.normals = shadingNormals(*surface.mesh, {});
        const UvMatrix map = surface.uv;
        surface.uv.resize(8, 2);
        surface.uv << map, UvMatrix::Constant(4, 2, std::numeric_limits<double>::quiet_NaN());
        surface.emission = {Vec3f::Zero(), Vec3f::Constant(2)};
        const LightBakeResult result = bakeLight(surface, {}, settings(8, 16384), {});
        const auto expected = [&](double x, double y) {
            double sum = 0;
            for (int i = 0; i < 16; ++i)
                sum += 2 * formFactorBelow(x + (i % 4 - 1.5) / 16, y + (i / 4 - 1.5) / 16, .5, .7);
            return sum / 16;
        };
        const double error = worstError(result, expected);
        QVERIFY2(error < .01, qPrintable(QString::number(error)));
    }

    void areaLightsShineToOneSide()
    {
        Lighting lighting;
        lighting.areas.push_back(lampAbove(1, .5, 3));
        lighting.areas[0].up *= -1;
        QCOMPARE(meanOf(bakeLight(ground(), lighting, settings(8, 16), {})), 0.0);
    }

    //! A wall along y = 0 hides the sun on one side, up to where its shadow ends.
    void shadowOfTheSun()
    {
        LitSurface surface = ground(0);
        surface.mesh = test::polygonMesh(
            {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {1, 0, .5}, {-1, 0, .5}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}});
        surface.normals = shadingNormals(*surface.mesh, {});
        const UvMatrix map = surface.uv;
        surface.uv.resize(8, 2);
        surface.uv << map, UvMatrix::Constant(4, 2, std::numeric_limits<double>::quiet_NaN());
        Lighting lighting;
        Sun sun;
        sun.towards = Vec3f(0, 1, 1).normalized();
        sun.irradiance = Vec3f(pi, pi, pi);
        lighting.suns.push_back(sun);
        const LightBakeResult result = bakeLight(surface, lighting, settings(64, 64), {});
        for (int y = 0; y < 64; ++y) {
            const double at = 1 - (y + .5) / 32; // the shadow is from -.5 to 0
            const float value = result.picture.at(32, y)[0];
            if (at > .05 || at < -.55)
                QVERIFY(std::abs(value - std::sqrt(.5F)) < 1e-3F);
            else if (at < -.05 && at > -.45)
                QCOMPARE(value, 0.F);
        }
    }

    //! A surface never has more light than its brightest source, whatever is reflected.
    void lightStaysBelowItsSource()
    {
        Lighting lighting;
        lighting.sky = Sky{};
        LightBakeSettings how = settings(32, 64);
        how.bounces = 30;
        for (const bool denoise : {false, true}) {
            how.denoise = denoise;
            const LightBakeResult result =
                bakeLight(gridded(test::meshNamed(QStringLiteral("torus")), .9F), lighting, how, {});
            const double mean = meanOf(result);
            QVERIFY(mean < 1 && mean > .8);
        }
    }

    void valuesOfTheMap()
    {
        Lighting lighting;
        lighting.sky = Sky{};
        LightBakeSettings how = settings(8, 4);
        LitSurface surface = ground(.25F);
        surface.emission = {Vec3f(.5F, 0, 0)};
        const auto baked = [&](LightValue value) {
            how.value = value;
            return bakeLight(surface, lighting, how, {}).picture.at(3, 3)[0];
        };
        QVERIFY(std::abs(double(baked(LightValue::Light)) - 1) < 1e-5);
        QVERIFY(std::abs(double(baked(LightValue::Irradiance)) - pi) < 1e-5);
        QVERIFY(std::abs(double(baked(LightValue::Lit)) - .75) < 1e-5);
        how.value = LightValue::Light;
        how.direct = false;
        QCOMPARE(baked(LightValue::Light), 0.F);
    }

    //! The mean of a clear sky is brighter beside the sun, blue away from it, and as bright as said above.
    void daylight()
    {
        const Vec3f up = Vec3f::UnitZ(), towards = Vec3f(1, 0, 1).normalized();
        const Daylight day(towards, up, 3, 2);
        const auto luminance = [](const Vec3f &c) { return c.dot(Vec3f(.2126F, .7152F, .0722F)); };
        QVERIFY(std::abs(luminance(day.radiance(up)) - 2) < .01F);
        QVERIFY(luminance(day.radiance(towards)) > luminance(day.radiance(Vec3f(-1, 0, 1).normalized())));
        const Vec3f away = day.radiance(Vec3f(-1, 0, 1).normalized());
        QVERIFY(away.z() > away.x() && away.x() > 0);
        const Daylight night(-up, up, 3, 2);
        QVERIFY(night.radiance(towards).allFinite());
    }

    void sameBytesOnAnyNumberOfThreads()
    {
        LitSurface surface = gridded(room(), .7F);
        Lighting lighting;
        lighting.areas.push_back(lampAbove(.8, .2, 5, .5));
        for (const bool denoise : {false, true}) {
            LightBakeSettings how = settings(40, 24);
            how.denoise = denoise;
            how.margin = 3;
            const LightBakeResult one = bakeLight(surface, lighting, how, JobContext(nullptr, 1));
            const LightBakeResult two = bakeLight(surface, lighting, how, JobContext(nullptr, 2));
            QVERIFY(one.picture.values == two.picture.values && one.filled == two.filled);
        }
    }

    //! Denoising brings the map nearer to the truth, and leaves the edge of a shadow where it is.
    void denoising()
    {
        LitSurface surface = gridded(room(), .7F);
        Lighting lighting;
        lighting.areas.push_back(lampAbove(.8, .2, 5, .5));
        LightBakeSettings how = settings(48, 1024);
        const LightBakeResult truth = bakeLight(surface, lighting, how, {});
        const auto error = [&](bool denoise) {
            how.samples = 16;
            how.denoise = denoise;
            const LightBakeResult result = bakeLight(surface, lighting, how, {});
            double sum = 0;
            for (std::size_t i = 0; i < result.picture.values.size(); ++i)
                sum += std::pow(double(result.picture.values[i] - truth.picture.values[i]), 2);
            return sum;
        };
        const double noisy = error(false), smooth = error(true);
        QVERIFY2(smooth < .45 * noisy, qPrintable(QStringLiteral("%1 of %2").arg(smooth).arg(noisy)));
    }

    void previewsGrowFiner()
    {
        Lighting lighting;
        lighting.sky = Sky{};
        int previews = 0;
        bool complete = true;
        double last = 0;
        const JobContext job(nullptr, 2, [&](const JobProgress &progress) {
            QVERIFY(progress.fraction >= last - 1e-9 && progress.fraction <= 1 + 1e-9);
            last = progress.fraction;
        });
        bakeLight(ground(), lighting, settings(64, 64), job, [&](const Picture &picture) {
            ++previews;
            for (const float value : picture.values)
                complete = complete && value > .99F;
        });
        QVERIFY(previews >= 6);
        QVERIFY(complete);
        QVERIFY(last > .99);
    }

    void stops()
    {
        Lighting lighting;
        lighting.sky = Sky{};
        std::atomic<bool> stop = false;
        LightBakeSettings how = settings(512, 1000000);
        how.denoise = true;
        int previews = 0;
        const LightBakeResult result = bakeLight(ground(), lighting, how, JobContext(&stop, 2),
                                                 [&](const Picture &) { stop = ++previews == 2; });
        QVERIFY(result.stopped);
        QCOMPARE(previews, 2);
        // What there is covers the whole map.
        QVERIFY(std::abs(meanOf(result) - 1) < .01);
    }

    void jobs()
    {
        LightPlan plan;
        plan.sun = Vec2(0, 90);
        plan.day = true;
        plan.sunHidden = true;
        QVERIFY(bake::lightingOf(plan, false).suns.empty() && bake::lightingOf(plan, false).sky->day);
        plan.sunHidden = false;
        QCOMPARE(bake::lightingOf(plan, false).suns.size(), std::size_t(1));
        // Tile by tile; after a stop there is what was found, or no picture.
        const bake::LightJob job = bake::lightJobOf(ground(), plan, settings(64, 8), 1);
        QCOMPARE(job.tiles, std::vector<int>{1001});
        std::vector<int> tiles;
        int previews = 0;
        const auto sink = [&](int tile, LightBakeResult &result) {
            tiles.push_back(tile);
            return !result.picture.isEmpty();
        };
        const auto preview = [&](int tile, const Picture &) { previews += tile == 1001; };
        QVERIFY(!bake::runLightBake(job, sink, preview, {}).stopped);
        QVERIFY(tiles == job.tiles && previews > 2);
        const std::atomic<bool> stop = true;
        QVERIFY(bake::runLightBake(job, sink, preview, JobContext(&stop)).stopped);
        QCOMPARE(tiles.size(), std::size_t(1));
    }

    void oddModels()
    {
        Lighting lighting;
        lighting.sky = Sky{};
        lighting.suns.push_back({});
        for (const char *name : {"dirty", "triangle"}) {
            LitSurface surface = gridded(test::meshNamed(QString::fromLatin1(name)), .5F);
            const LightBakeResult result = bakeLight(surface, lighting, settings(16, 8), {});
            for (const float value : result.picture.values)
                QVERIFY(std::isfinite(value) && value >= 0);
            surface.uv.setConstant(std::numeric_limits<double>::quiet_NaN());
            QCOMPARE(bakeLight(surface, lighting, settings(16, 8), {}).texels, 0);
        }
    }
};

QTEST_APPLESS_MAIN(TestLightBake)

} // namespace tst_lightbake

#include "tst_lightbake.moc"
