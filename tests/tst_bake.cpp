// The baker: which points texels show, padding, rays to a detailed model, tiles, threads, damaged models.
#include "solver/bake/dilation.h"
#include "solver/bake/surfacesamples.h"
#include "support/bakejobs.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <numbers>

namespace tst_bake {

using namespace autocuts;
using namespace autocuts::bake;
using namespace autocuts::test;

namespace {

constexpr double pi = std::numbers::pi;

} // namespace

class TestBake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void texelsShowTheirPoints();
    void texelsBesideIslandsShowTheNearestPoint();
    void overlapsAreCounted();
    void sharedSidesAreNoOverlaps();
    void dilationTakesTheNearest();
    void detailedNormals_data();
    void detailedNormals();
    void cageDirections();
    void cageOfItsOwn();
    void facesBehindAreNotMet();
    void whatIsOutOfReachIsMissed();
    void groupsSeeTheirOwn();
    void heights();
    void tilesAreBaked();
    void wholeNumbersAreEncoded();
    void surfaceSamplesFollowTheMap_data();
    void surfaceSamplesFollowTheMap();
    void threadsGiveTheSame();
    void passesGiveTheSame();
    void stopped();
    void damagedModels();
};

void TestBake::texelsShowTheirPoints()
{
    const MappedModel low = plane(2);
    const TexelSurface texels(*low.mesh, low.uv, {8, 4, {Vec2::Zero(), Vec2::Ones()}, 2});
    const ShadedSurface surface = surfaceOf(low);
    QCOMPARE(texels.bandCount(), 1);
    TexelRows rows;
    texels.makeBand(0, rows);
    QCOMPARE(rows.points.size(), std::size_t(8 * 4 * 4));
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            QVERIFY(rows.inside[y * 8 + x]);
            for (int s = 0; s < 4; ++s) {
                const Vec3 at = surface.position(rows.points[(y * 8 + x) * 4 + s]);
                const double u = (x + 0.25 + 0.5 * (s % 2)) / 8, v = 1 - (y + 0.25 + 0.5 * (s / 2)) / 4.0;
                QVERIFY((at - Vec3(2 * u - 1, 2 * v - 1, 0)).norm() < 1e-6);
            }
        }
    }
}

void TestBake::texelsBesideIslandsShowTheNearestPoint()
{
    MappedModel low = plane();
    low.uv *= 0.5; // the lower left quarter
    const TexelSurface texels(*low.mesh, low.uv, {8, 8, {Vec2::Zero(), Vec2::Ones()}, 1});
    const ShadedSurface surface = surfaceOf(low);
    TexelRows rows;
    texels.makeBand(0, rows); // rows 0 to 3, above the island
    const auto pointAt = [&](int x, int y) { return rows.points[y * 8 + x]; };
    QVERIFY(!rows.inside[3 * 8 + 1]);
    QVERIFY((surface.position(pointAt(1, 3)) - Vec3(-0.5 + 1.5 / 4, 0.5, 0)).norm() < 1e-6);
    QVERIFY((surface.position(pointAt(4, 3)) - Vec3(0.5, 0.5, 0)).norm() < 1e-6); // its corner
    QCOMPARE(pointAt(1, 1).triangle, -1);
    QCOMPARE(pointAt(6, 3).triangle, -1);
    texels.makeBand(1, rows);
    QVERIFY(rows.inside[1]);
    QVERIFY(!rows.inside[4]);
}

void TestBake::overlapsAreCounted()
{
    const MappedModel two = test::mapped(
        test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}}),
        [](const Vec3 &p, const Vec3 &) { return Vec2(p.x() * 0.5 + p.z() * 0.25, p.y()); });
    const Baked result = baked(jobFor(two, {{MapKind::Position, 0}}, 8));
    QCOMPARE(result.figures.texels, 6 * 8);
    QCOMPARE(result.figures.overlapped, 2 * 8);
    QCOMPARE(result.maps[0].at(3, 0)[2], 0.0F); // the first face counts
    QCOMPARE(result.maps[0].at(5, 0)[2], 1.0F);
}

void TestBake::sharedSidesAreNoOverlaps()
{
    const MappedModel grid =
        test::mapped(test::grid(7), [](const Vec3 &p, const Vec3 &) { return p.head<2>(); });
    BakeJob job = jobFor(grid, {{MapKind::Position, 0}}, 14); // samples lie on diagonals
    job.settings.grid.perSide = 2;
    const Baked result = baked(job);
    QCOMPARE(result.figures.overlapped, 0);
    QCOMPARE(result.figures.texels, 14 * 14);
}

void TestBake::dilationTakesTheNearest()
{
    constexpr int size = 40, margin = 7;
    Picture picture(size, size, 1);
    std::vector<std::uint8_t> filled(size * size, 0);
    std::vector<std::array<int, 2>> seeds;
    unsigned state = 1;
    for (int i = 0; i < 25; ++i) {
        state = state * 1664525 + 1013904223;
        const int x = static_cast<int>((state >> 8) % size), y = static_cast<int>((state >> 20) % size);
        if (filled[y * size + x])
            continue;
        seeds.push_back({x, y});
        filled[y * size + x] = 1;
        picture.at(x, y)[0] = static_cast<float>(seeds.size());
    }
    const Picture before = picture;
    dilate(picture, filled, margin, JobContext(nullptr, 2));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            int best = margin * margin + 1;
            for (const auto &seed : seeds)
                best = std::min(best, (seed[0] - x) * (seed[0] - x) + (seed[1] - y) * (seed[1] - y));
            QCOMPARE(filled[y * size + x] != 0, best <= margin * margin);
            if (!filled[y * size + x])
                continue;
            const auto &from = seeds[static_cast<std::size_t>(picture.at(x, y)[0]) - 1];
            QCOMPARE((from[0] - x) * (from[0] - x) + (from[1] - y) * (from[1] - y), best);
            if (best == 0)
                QCOMPARE(picture.at(x, y)[0], before.at(x, y)[0]);
        }
    }
}

void TestBake::detailedNormals_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<bool>("mirrored");
    QTest::newRow("flat") << 0.0 << false;
    QTest::newRow("tilted") << 20.0 << false;
    QTest::newRow("mirrored map") << 20.0 << true;
}

void TestBake::detailedNormals()
{
    QFETCH(double, angle);
    QFETCH(bool, mirrored);
    MappedModel low = plane();
    if (mirrored)
        low.uv.col(0) = (1 - low.uv.col(0).array()).eval();
    // A large plane through the origin, turned about y.
    const double c = std::cos(angle * pi / 180), s = std::sin(angle * pi / 180);
    const test::MeshPtr high = test::polygonMesh(
        {{-2 * c, -2, 2 * s}, {2 * c, -2, -2 * s}, {2 * c, 2, -2 * s}, {-2 * c, 2, 2 * s}}, {{0, 1, 2, 3}});
    BakeJob job = jobFor(low, {{MapKind::Normal, 0}, {MapKind::ObjectNormal, 0}}, 8);
    setDetailed(job, high, 0.5);
    const Baked result = baked(job);
    QCOMPARE(result.figures.missed, 0);
    const Vec3f inSpace(static_cast<float>(s), 0, static_cast<float>(c));
    const Vec3f inMap(mirrored ? -inSpace.x() : inSpace.x(), 0, inSpace.z());
    for (int i = 0; i < 64; ++i) {
        QVERIFY((directionAt(result.maps[0], i % 8, i / 8) - inMap).norm() < 1e-4F);
        QVERIFY((directionAt(result.maps[1], i % 8, i / 8) - inSpace).norm() < 1e-4F);
    }
    job.greenDown = true;
    setDetailed(job, test::polygonMesh({{-2, -2, -1}, {2, -2, -1}, {2, 2, 1}, {-2, 2, 1}}, {{0, 1, 2, 3}}),
                0.9);
    const Vec3f down = directionAt(only(job), 4, 4);
    QVERIFY(down.y() > 0.4F); // the surface rises towards +y: green up would be negative
}

//! A ridge whose sides meet at a right angle, below a plane that is its detailed model: where rays of each
//! kind arrive.
void TestBake::cageDirections()
{
    const auto ridge =
        test::polygonMesh({{-1, -1, 0}, {0, -1, 1}, {1, -1, 0}, {-1, 1, 0}, {0, 1, 1}, {1, 1, 0}},
                          {{0, 1, 4, 3}, {1, 2, 5, 4}});
    const MappedModel low = test::mapped(
        ridge, [](const Vec3 &p, const Vec3 &) { return Vec2(p.x() / 2 + 0.5, p.y() / 2 + 0.5); });
    // A roof above it, parallel to the sides.
    const auto roof = test::polygonMesh(
        {{-2, -2, -0.8}, {0, -2, 1.2}, {2, -2, -0.8}, {-2, 2, -0.8}, {0, 2, 1.2}, {2, 2, -0.8}},
        {{0, 1, 4, 3}, {1, 2, 5, 4}});
    const auto shift = [&](CageDirection direction, int x) {
        BakeJob job = jobFor(low, {{MapKind::Position, 0}}, 64);
        setDetailed(job, roof, 0.1);
        job.settings.cage.direction = direction;
        const Picture picture = only(job);
        const auto texel = picture.at(x, 32);
        const double lowX = (x + 0.5) / 32 - 1;
        // How far the ray ran along the side, away from the ridge.
        const Vec3 moved = Vec3(texel[0], 0, texel[2]) - Vec3(lowX, 0, 1 - std::abs(lowX));
        return moved.dot(Vec3(lowX < 0 ? -1 : 1, 0, -1).normalized());
    };
    // In the middle of a side, and beside the ridge. (At the borders normals are those of the side.)
    QVERIFY(shift(CageDirection::Smoothed, 48) < -0.02);
    QVERIFY(shift(CageDirection::Smoothed, 33) < -0.1);
    QVERIFY(std::abs(shift(CageDirection::Shading, 48)) < 1e-4);
    QVERIFY(std::abs(shift(CageDirection::Shading, 33)) < 1e-4);
    QVERIFY(std::abs(shift(CageDirection::Corrected, 48)) < 1e-4);
    QVERIFY(shift(CageDirection::Corrected, 33) < -0.1);
}

void TestBake::cageOfItsOwn()
{
    BakeJob job = jobFor(plane(), {{MapKind::Position, 0}}, 8);
    setDetailed(job, test::polygonMesh({{-5, -5, 1}, {5, -5, 1}, {5, 5, 1}, {-5, 5, 1}}, {{0, 1, 2, 3}}),
                0.01);
    QCOMPARE(baked(job).figures.missed, 64);
    PositionMatrix cage = job.low.mesh->positions;
    cage.rowwise() += Eigen::RowVector3d(2, 0, 2); // aslant
    job.settings.cage.positions = cage;
    const Baked result = baked(job);
    QCOMPARE(result.figures.missed, 0);
    const auto texel = result.maps[0].at(0, 7);
    QVERIFY((Vec3f(texel[0], texel[1], texel[2]) - Vec3f(-0.4375F + 1, -0.4375F, 1)).norm() < 1e-4F);
}

void TestBake::facesBehindAreNotMet()
{
    // Two layers above the plane: the outer one faces down, the inner one up.
    const auto layers = test::polygonMesh({{-1, -1, 0.2},
                                           {-1, 1, 0.2},
                                           {1, 1, 0.2},
                                           {1, -1, 0.2},
                                           {-1, -1, 0.1},
                                           {1, -1, 0.1},
                                           {1, 1, 0.1},
                                           {-1, 1, 0.1}},
                                          {{0, 1, 2, 3}, {4, 5, 6, 7}});
    BakeJob job = jobFor(plane(), {{MapKind::Position, 0}}, 4);
    setDetailed(job, layers, 0.3);
    QVERIFY(std::abs(only(job).at(1, 1)[2] - 0.1F) < 1e-5F);
}

void TestBake::whatIsOutOfReachIsMissed()
{
    // It covers the left half only.
    BakeJob job = jobFor(plane(), {{MapKind::Occlusion, 0}}, 8);
    job.margin = 0;
    setDetailed(job,
                test::polygonMesh({{-1, -1, 0.1}, {0, -1, 0.1}, {0, 1, 0.1}, {-1, 1, 0.1}}, {{0, 1, 2, 3}}),
                0.1);
    const Baked result = baked(job);
    QCOMPARE(result.figures.texels, 64);
    QCOMPARE(result.figures.missed, 32);
}

void TestBake::groupsSeeTheirOwn()
{
    const auto twoSheets = [](double first, double second) {
        return test::polygonMesh({{-1, -1, first},
                                  {1, -1, first},
                                  {1, 1, first},
                                  {-1, 1, first},
                                  {-1, -1, second},
                                  {1, -1, second},
                                  {1, 1, second},
                                  {-1, 1, second}},
                                 {{0, 1, 2, 3}, {4, 5, 6, 7}});
    };
    BakeJob job = jobFor(test::mapped(twoSheets(0, 0.05),
                                      [](const Vec3 &p, const Vec3 &) {
                                          return Vec2(p.x() / 4 + (p.z() > 0 ? 0.75 : 0.25), p.y() / 2 + 0.5);
                                      }),
                         {{MapKind::Height, 0}}, 8);
    setDetailed(job, twoSheets(0.01, 0.08), 0.1);
    QVERIFY(std::abs(only(job).at(1, 1)[0] - 0.08F) < 1e-4F); // the outer sheet hides the inner one
    job.low.faceGroup = job.high->faceGroup = {0, 1};
    const Picture apart = only(job);
    QVERIFY(std::abs(apart.at(1, 1)[0] - 0.01F) < 1e-4F);
    QVERIFY(std::abs(apart.at(6, 1)[0] - 0.03F) < 1e-4F);
    job.low.faceGroup = {0, 2}; // nobody is of group 2
    QCOMPARE(baked(job).figures.missed, 32);
    job.high->faceGroup = {0, 3};
    QCOMPARE(baked(job).figures.missed, 32);
}

void TestBake::heights()
{
    BakeJob job = jobFor(plane(10), {{MapKind::Height, 0}}, 4);
    const auto sheet = [](double z) {
        return test::polygonMesh({{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}}, {{0, 1, 2, 3}});
    };
    for (const double z : {0.5, -0.75}) {
        setDetailed(job, sheet(z), 0.1);
        job.floats = true;
        QVERIFY(std::abs(only(job).at(2, 2)[0] - z) < 1e-4);
        job.floats = false; // 1 is the height of the cage
        QVERIFY(std::abs(only(job).at(2, 2)[0] - (0.5 + 0.5 * z / (0.1 * std::sqrt(200.0)))) < 1e-4);
    }
}

void TestBake::tilesAreBaked()
{
    MappedModel low = plane(2);
    low.uv.col(0).array() += 1; // tile 1002
    low.uv.col(1).array() += 1; // tile 1012
    BakeJob job = jobFor(low, {{MapKind::Position, 0}}, 4);
    job.margin = 0;
    job.tiles = {1001, 1012};
    std::map<int, Picture> pictures;
    runBake(job,
            [&](std::size_t, int tile, const Picture &picture) {
                pictures[tile] = picture;
                return true;
            },
            {});
    QCOMPARE(pictures.size(), std::size_t(2));
    QVERIFY(std::abs(pictures[1012].at(0, 0)[0] + 0.75F) < 1e-5F);
    QCOMPARE(pictures[1001].at(0, 3)[0], 0.0F);
    job.low.tileHeight = 0.5; // of a texture that is wider than high
    job.low.uv.col(1) *= 0.5;
    job.settings.grid.height = 2;
    job.tiles = {1012};
    const Picture wide = only(job);
    QVERIFY(std::abs(wide.at(0, 0)[1] - 0.5F) < 1e-5F);
}

void TestBake::wholeNumbersAreEncoded()
{
    BakeJob job =
        jobFor(plane(), {{MapKind::Normal, 0}, {MapKind::Occlusion, 0}, {MapKind::Curvature, 0}}, 8);
    job.low.uv *= 0.5;
    job.margin = 0;
    job.floats = false;
    const Baked result = baked(job);
    for (const Picture &picture : result.maps) {
        for (const float value : picture.values)
            QVERIFY(value >= 0 && value <= 1);
    }
    // The background is flat and open.
    QVERIFY((directionAt(result.maps[0], 7, 0) - Vec3f::UnitZ()).norm() < 1e-6F);
    QCOMPARE(result.maps[1].at(7, 0)[0], 1.0F);
    QCOMPARE(result.maps[2].at(7, 0)[0], 0.5F);
}

void TestBake::surfaceSamplesFollowTheMap_data()
{
    QTest::addColumn<int>("map");
    QTest::newRow("normal") << int(MapKind::Normal);
    QTest::newRow("object normal") << int(MapKind::ObjectNormal);
    QTest::newRow("position") << int(MapKind::Position);
    QTest::newRow("height") << int(MapKind::Height);
}

//! What was traced once and is laid into a map is what a bake into that map finds, in any map.
void TestBake::surfaceSamplesFollowTheMap()
{
    QFETCH(int, map);
    BakeJob job = busyJob();
    job.settings.maps = {{static_cast<MapKind>(map), 0}};
    job.settings.grid.width = job.settings.grid.height = 128;
    job.settings.grid.perSide = 1;
    job.margin = 0;
    job.floats = false;
    const Frame frame = Frame::of(*job.low.mesh);
    const Projection projection(job.low, *job.high, frame, job.settings.cage);
    const SurfaceSamples samples(job.low, projection, frame, job.settings.maps[0], job.settings.rays,
                                 encodingOf(job, frame), 200000, JobContext(nullptr, 2));
    QVERIFY(samples.isComplete());
    QCOMPARE(samples.missed(), 0);
    for (const double angle : {0.0, 0.7}) {
        for (Eigen::Index i = 0; i < job.low.uv.rows(); ++i) {
            const Vec2 at = Vec2(job.low.uv.row(i)) - Vec2(0.5, 0.5);
            job.low.uv.row(i) = (0.7 * (Eigen::Rotation2Dd(angle) * at) + Vec2(0.5, 0.5)).transpose();
        }
        job.low.tangents = mikkTangents(*job.low.mesh, job.low.uv, job.low.normals);
        const Picture wanted = only(job);
        const Picture laid = samples.lay(job.low, job.settings.grid, JobContext(nullptr, 2));
        double sum = 0;
        int apart = 0;
        for (std::size_t i = 0; i < wanted.values.size(); ++i) {
            sum += std::abs(wanted.values[i] - laid.values[i]);
            apart += std::abs(wanted.values[i] - laid.values[i]) > 0.1F;
        }
        QVERIFY2(255 * sum / double(wanted.values.size()) < 1,
                 qPrintable(QString::number(255 * sum / double(wanted.values.size()))));
        QVERIFY(apart < 200);
        const TexelGrid &grid = job.settings.grid;
        QVERIFY(samples.lay(job.low, grid, {}).values == laid.values);
    }
}

void TestBake::threadsGiveTheSame()
{
    const BakeJob job = busyJob();
    const Baked one = baked(job, 1), three = baked(job, 3);
    for (std::size_t m = 0; m < one.maps.size(); ++m)
        QVERIFY(one.maps[m].values == three.maps[m].values);
    QCOMPARE(one.figures.texels, three.figures.texels);
    QVERIFY(one.figures.texels > 1500);
    QCOMPARE(one.figures.missed, 0);
}

void TestBake::passesGiveTheSame()
{
    BakeJob job = busyJob();
    job.settings.maps.erase(job.settings.maps.begin() + 1); // how rays spread depends on the maps of a pass
    const Baked one = baked(job);
    job.memory = 1;
    const Baked three = baked(job);
    QVERIFY(one.maps[0].values == three.maps[0].values);
    QVERIFY(one.maps[2].values == three.maps[2].values);
    QCOMPARE(one.figures.texels, three.figures.texels);
}

void TestBake::stopped()
{
    BakeJob job = busyJob();
    std::atomic<bool> stop = false;
    int given = 0;
    const BakeFigures figures = runBake(
        job,
        [&](std::size_t, int, const Picture &) {
            ++given;
            return true;
        },
        JobContext(&stop, 2, [&](const JobProgress &progress) {
            if (progress.fraction > 0.3)
                stop = true;
        }));
    QVERIFY(figures.stopped);
    QCOMPARE(given, 0);
}

void TestBake::damagedModels()
{
    // Everything that is wrong with meshes and maps: no value is NaN.
    for (const char *name : {"dirty", "cube", "torus"}) {
        MappedModel low = test::mapped(test::meshNamed(QString::fromLatin1(name)),
                                       [](const Vec3 &p, const Vec3 &) { return Vec2(p.x(), p.y()); });
        low.uv.row(0).setConstant(std::numeric_limits<double>::quiet_NaN());
        low.uv.row(3).setConstant(1e300);
        BakeJob job = jobFor(low,
                             {{MapKind::Normal, 0},
                              {MapKind::BentNormal, 0},
                              {MapKind::Curvature, 0},
                              {MapKind::Thickness, 0},
                              {MapKind::Position, 0},
                              {MapKind::Height, 0}},
                             16);
        setDetailed(job, low.mesh, 0.05);
        for (const CageDirection direction :
             {CageDirection::Smoothed, CageDirection::Shading, CageDirection::Corrected}) {
            job.settings.cage.direction = direction;
            for (const Picture &picture : baked(job).maps) {
                for (const float value : picture.values)
                    QVERIFY(std::isfinite(value));
            }
        }
    }
    BakeJob empty = jobFor(plane(), {{MapKind::Normal, 0}}, 4);
    setDetailed(empty, test::polygonMesh({}, {}), 0.1);
    QCOMPARE(baked(empty).figures.missed, 16);
}

QTEST_APPLESS_MAIN(TestBake)

} // namespace tst_bake

#include "tst_bake.moc"
