// The packer: the exact test, strange input, locks, turns, scale, cancelling, determinism, real islands.
#include "model/plain/chart.h"
#include "solver/packing/islandgeometry.h"
#include "solver/packing/layoutcheck.h"
#include "support/islandfiles.h"
#include "support/meshbuilders.h"
#include "support/packchecks.h"

#include <Eigen/Geometry>

#include <QTest>

#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <tuple>

namespace tst_packing {

using namespace autocuts;
using namespace autocuts::packing;
using namespace autocuts::test;

namespace {

PackOptions quick(double effort = 0.05)
{
    PackOptions settings;
    settings.effort = effort;
    return settings;
}

PackIsland regular(int sides)
{
    std::vector<Vec2> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        points.push_back({std::cos(angle), std::sin(angle)});
    }
    return polygon(points);
}

//! Two islands as given, with the gutter of one hundredth.
bool isValidPair(const PackIsland &first, const PackIsland &second)
{
    PackProblem problem;
    problem.lower = Vec2(-20, -20);
    problem.upper = Vec2(20, 20);
    problem.gutter = 0.01;
    Layout layout{1, {}};
    for (const PackIsland &island : {first, second}) {
        problem.outlines.push_back(makeOutline(island, 1));
        problem.locked.push_back(false);
        layout.poses.push_back({0, problem.outlines.back().centre});
    }
    problem.given = layout.poses;
    WorkMeter work(1, nullptr);
    return isValidLayout(problem, layout, work);
}

} // namespace

class TestPacking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void exactTest()
    {
        const PackIsland square = box(0, 0, 1, 1);
        QVERIFY(isValidPair(square, box(1.0101, 0, 1, 1)));
        QVERIFY(!isValidPair(square, box(1.0099, 0, 1, 1)));
        QVERIFY2(!isValidPair(square, box(1, 0, 1, 1)), "touching");
        QVERIFY2(!isValidPair(square, box(1, 1, 1, 1)), "touching at a corner");
        QVERIFY2(isValidPair(square, box(1.0072, 1.0072, 1, 1)), "corners are apart diagonally");
        QVERIFY2(!isValidPair(square, box(0.25, 0.25, 0.5, 0.5)), "inside");
        QVERIFY2(!isValidPair(box(0.25, 0.25, 0.5, 0.5), square), "around");
        QVERIFY2(!isValidPair(square, square), "in the same place");
        QVERIFY2(isValidPair(ring(4, 2), box(-0.5, -0.5, 1, 1)), "in the hole");
        QVERIFY2(!isValidPair(ring(4, 2), box(1.2, 1.2, 0.5, 0.5)), "in the ring");
    }

    void exactTestSeesSpikesThatPassThroughAnEdge()
    {
        // All corners are far from all edges; only the sides cross.
        const PackIsland flat = polygon({{-5, 0}, {5, 0}, {0, 0.02}});
        const PackIsland spike = polygon({{2, -5}, {2.02, 5}, {1.98, 5}});
        QVERIFY(!isValidPair(flat, spike));
        QVERIFY(isValidPair(flat, shiftedBy(spike, {0, 5.1})));
    }

    void exactTestFillsFoldedIslands()
    {
        // The second triangle is folded back onto the first: an even-odd rule would call it empty.
        PackIsland folded = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
        folded.triangles.push_back({0, 2, 1});
        folded.triangles.push_back({0, 3, 2});
        folded.boundary.clear();
        QVERIFY(!isValidPair(folded, box(2.5, 0.5, 0.5, 0.5)));
        QVERIFY(isValidPair(folded, box(4.5, 0.5, 0.5, 0.5)));
    }

    void strangeInput_data()
    {
        QTest::addColumn<std::vector<PackIsland>>("islands");
        QTest::addColumn<double>("margin");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const PackIsland square = box(0, 0, 1, 1);
        PackIsland point;
        point.points = {{3, 4}, {3, 4}};
        PackIsland nowhere;
        PackIsland broken = square;
        broken.points[2] = Vec2(nan, 1);
        PackIsland huge = square;
        for (Vec2 &p : huge.points)
            p *= 1e90;
        PackIsland infinite = square;
        infinite.points[1].x() = std::numeric_limits<double>::infinity();
        const PackIsland needle = polygon({{0, 0}, {7, 0}, {3, 0}});
        const PackIsland sliver = polygon({{0, 0}, {7, 0}, {3, 1e-7}});
        std::vector<PackIsland> crowd{box(0, 0, 100, 100)};
        for (int i = 0; i < 3000; ++i)
            crowd.push_back(box(i, 0, 0.1 + 0.01 * (i % 7), 0.3));

        QTest::newRow("none") << std::vector<PackIsland>{} << 8.0;
        QTest::newRow("no points") << std::vector<PackIsland>{nowhere, nowhere} << 8.0;
        QTest::newRow("one") << std::vector<PackIsland>{square} << 8.0;
        QTest::newRow("one point") << std::vector<PackIsland>{point} << 8.0;
        QTest::newRow("points") << std::vector<PackIsland>(20, point) << 8.0;
        QTest::newRow("point and square") << std::vector<PackIsland>{point, square, point} << 8.0;
        QTest::newRow("needles") << std::vector<PackIsland>(30, needle) << 8.0;
        QTest::newRow("slivers") << std::vector<PackIsland>{sliver, sliver, needle, square} << 8.0;
        QTest::newRow("not finite") << std::vector<PackIsland>{broken, infinite, square} << 8.0;
        QTest::newRow("huge and small") << std::vector<PackIsland>{huge, square, square} << 8.0;
        QTest::newRow("no margin") << std::vector<PackIsland>(9, square) << 0.0;
        QTest::newRow("wide margin") << std::vector<PackIsland>(9, square) << 500.0;
        QTest::newRow("far away") << std::vector<PackIsland>{shiftedBy(square, {1e7, -1e7}), square} << 8.0;
        QTest::newRow("giant and crowd") << crowd << 4.0;
    }

    void strangeInput()
    {
        QFETCH(std::vector<PackIsland>, islands);
        QFETCH(double, margin);
        for (const PackRotation rotation : {PackRotation::Free, PackRotation::Quarter, PackRotation::None}) {
            PackOptions settings = quick(0.02);
            settings.margin = margin;
            settings.rotation = rotation;
            const PackResult result = packIslands(islands, settings);
            QVERIFY(result.complete);
            QVERIFY(result.scale > 0);
            QCOMPARE(result.placements.size(), islands.size());
            QVERIFY(isFinite(result));
            if (islands.size() < 100) {
                std::vector<PackIsland> usable = islands;
                for (PackIsland &island : usable) {
                    std::erase_if(island.boundary, [&](const std::array<int, 2> &e) {
                        return !island.points[e[0]].allFinite() || !island.points[e[1]].allFinite();
                    });
                }
                const QString broken = brokenRule(usable, settings, result);
                QVERIFY2(broken.isEmpty(), qPrintable(broken));
            }
        }
    }

    void marginsAloneDoNotFit()
    {
        PackOptions settings = quick();
        settings.margin = 1500;
        const PackResult result = packIslands(std::vector<PackIsland>(9, box(0, 0, 1, 1)), settings);
        QVERIFY(!result.complete);
        QCOMPARE(result.scale, 1.0);
        QCOMPARE(result.placements[3].angle, 0.0);
        QCOMPARE(result.placements[3].translation, Vec2(0, 0));
    }

    void settingsAreChecked()
    {
        const auto throws = [](const PackOptions &settings) {
            try {
                std::ignore = packIslands({}, settings);
            } catch (const std::invalid_argument &) {
                return true;
            }
            return false;
        };
        PackOptions settings;
        QVERIFY(!throws(settings));
        settings.upper = settings.lower;
        QVERIFY(throws(settings));
        settings = {};
        settings.margin = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(throws(settings));
        settings = {};
        settings.textureSize = 0;
        QVERIFY(throws(settings));
    }

    void singleIslandTakesTheBestAngle()
    {
        PackOptions settings = quick();
        settings.margin = 0;
        PackIsland tilted = box(-0.5, -0.5, 1, 1);
        const Turn turn(0.3, 1);
        for (Vec2 &p : tilted.points)
            p = turn(p);
        const PackResult result = packIslands({tilted}, settings);
        QVERIFY(result.complete);
        QVERIFY(result.efficiency > 0.99999);
        settings.rotation = PackRotation::None;
        const double side = std::cos(0.3) + std::sin(0.3);
        QVERIFY(std::abs(packIslands({tilted}, settings).efficiency - 1 / (side * side)) < 1e-5);
    }

    void gutterOfRandomIslands_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("margin");
        QTest::newRow("few") << 5 << 8.0;
        QTest::newRow("tens") << 40 << 8.0;
        QTest::newRow("no margin") << 40 << 0.0;
        QTest::newRow("wide margin") << 40 << 60.0;
        QTest::newRow("too many for separation") << 700 << 4.0;
    }

    void gutterOfRandomIslands()
    {
        QFETCH(int, count);
        QFETCH(double, margin);
        std::vector<PackRotation> rotations{PackRotation::Free, PackRotation::Quarter, PackRotation::None};
        if (count == 40) // steps do not depend on the number of islands
            rotations.insert(rotations.end(), {PackRotation::Half, PackRotation::Eighth,
                                               PackRotation::Twelfth, PackRotation::TwentyFourth});
        for (const PackRotation rotation : rotations) {
            std::vector<PackIsland> islands = randomStars(count, 7);
            for (std::size_t i = 0; i < islands.size(); i += 5)
                islands[i].upright = true;
            PackOptions settings = quick(0.1);
            settings.margin = margin;
            settings.rotation = rotation;
            settings.lower = Vec2(-1, 2);
            settings.upper = Vec2(1, 3);
            const PackResult result = packIslands(islands, settings);
            QVERIFY(result.complete);
            const QString broken = brokenRule(islands, settings, result);
            QVERIFY2(broken.isEmpty(), qPrintable(broken));
            for (std::size_t i = 0; i < islands.size(); ++i) {
                const double angle = result.placements[i].angle;
                const int directions = islands[i].upright ? 1 : directionsOf(rotation);
                const double step = 2 * std::numbers::pi / directions;
                if (directions == 1)
                    QCOMPARE(angle, 0.0);
                else if (directions > 1)
                    QVERIFY(std::abs(angle - step * std::round(angle / step)) < 1e-12);
            }
        }
    }

    void aStepTurnsASingleIsland()
    {
        // A needle fits best along the diagonal.
        PackIsland needle = box(0, 0, 1, 0.02);
        PackOptions settings = quick(0.05);
        const auto angleWith = [&](PackRotation rotation) {
            settings.rotation = rotation;
            const PackResult result = packIslands({needle}, settings);
            return result.complete ? std::remainder(result.placements[0].angle * 180 / std::numbers::pi, 180)
                                   : std::nan("");
        };
        QVERIFY(std::abs(std::abs(angleWith(PackRotation::Eighth)) - 45) < 1e-9);
        QVERIFY(std::abs(std::abs(angleWith(PackRotation::TwentyFourth)) - 45) < 1e-9);
        const double thirds = std::abs(angleWith(PackRotation::Twelfth));
        QVERIFY(std::abs(thirds - 30) < 1e-9 || std::abs(thirds - 60) < 1e-9);
        QVERIFY(std::abs(angleWith(PackRotation::Half)) < 1e-9);
        needle.upright = true;
        QCOMPARE(angleWith(PackRotation::Free), 0.0);
    }

    void squareBordersRunAlongTheAxes_data()
    {
        QTest::addColumn<PackIsland>("island");
        QTest::addColumn<bool>("isSquare");
        QTest::newRow("box") << box(0, 0, 1, 1) << true;
        QTest::newRow("strip") << box(0, 0, 1, 0.7) << true;
        QTest::newRow("corner") << polygon({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}) << true;
        QTest::newRow("ring of boxes") << ring(1, 0.5) << true;
        QTest::newRow("star") << randomStars(1, 3).front() << false;
        QTest::newRow("circle") << regular(32) << false;
        QTest::newRow("hexagon") << regular(6) << false;
    }

    void squareBordersRunAlongTheAxes()
    {
        QFETCH(PackIsland, island);
        QFETCH(bool, isSquare);
        constexpr double tilt = 0.5;
        for (Vec2 &p : island.points)
            p = Eigen::Rotation2Dd(tilt) * p;
        QCOMPARE(makeOutline(island, 1).squareAngle.has_value(), isSquare);
        if (!isSquare)
            return;
        for (const int others : {0, 6}) {
            std::vector<PackIsland> islands = randomStars(others, 5);
            islands.push_back(island);
            const PackOptions settings = quick(0.1);
            const PackResult result = packIslands(islands, settings);
            QVERIFY(result.complete);
            const QString broken = brokenRule(islands, settings, result);
            QVERIFY2(broken.isEmpty(), qPrintable(broken));
            const double angle = result.placements.back().angle + tilt;
            QVERIFY2(std::abs(std::remainder(angle, std::numbers::pi / 2)) < 1e-9,
                     qPrintable(QString::number(angle)));
        }
        // What is so long that it limits the scale of all may lie along the diagonal, if that gains much.
        const double leaning = packIslands({box(0, 0, 1, 0.02)}, quick(0.1)).placements.front().angle;
        QVERIFY(std::abs(std::remainder(leaning, std::numbers::pi / 2)) > 0.1);
        const std::vector<PackIsland> cylinder{box(0, 0, 2 * std::numbers::pi, 2), regular(32), regular(32)};
        const double straight = packIslands(cylinder, quick(0.1)).placements.front().angle;
        QVERIFY(std::abs(std::remainder(straight, std::numbers::pi / 2)) < 1e-9);
        // Who asks for steps gets these, counted from how the island was.
        PackOptions steps = quick(0.1);
        steps.rotation = PackRotation::Quarter;
        const double angle = packIslands({island, island}, steps).placements.front().angle;
        QVERIFY(std::abs(std::remainder(angle, std::numbers::pi / 2)) < 1e-9);
    }

    //! Two of a hexagon's sides run along an axis: packing the map again leaves it so, if it is asked to.
    void straightIslandsStaySo()
    {
        for (const double tilt : {0.0, 0.3}) {
            PackIsland island = regular(6);
            for (Vec2 &p : island.points)
                p = Eigen::Rotation2Dd(tilt) * p;
            QCOMPARE(standsOnAxes(makeOutline(island, 1)), tilt == 0);
            std::vector<PackIsland> islands = randomStars(6, 5);
            islands.insert(islands.end(), 6, island);
            for (const bool keep : {false, true}) {
                PackOptions settings = quick(0.1);
                settings.keepStraight = keep;
                const PackResult result = packIslands(islands, settings);
                QVERIFY(result.complete);
                const QString broken = brokenRule(islands, settings, result);
                QVERIFY2(broken.isEmpty(), qPrintable(broken));
                const bool stay = std::all_of(
                    result.placements.begin() + 6, result.placements.end(), [](const PackPlacement &place) {
                        return std::abs(std::remainder(place.angle, std::numbers::pi / 2)) < 1e-9;
                    });
                QCOMPARE(stay, keep && tilt == 0);
            }
        }
    }

    void holesAreUsed()
    {
        PackOptions settings = quick(0.2);
        settings.margin = 2;
        const PackResult result = packIslands({ring(1, 0.8), box(0, 0, 0.7, 0.7)}, settings);
        QVERIFY(result.complete);
        // Only the ring limits the scale: the box goes into its hole.
        QVERIFY(result.efficiency > 0.80);
    }

    void anExceptionInAThreadReachesTheCaller()
    {
        const std::vector<PackIsland> islands = randomStars(30, 3);
        PackOptions settings = quick(0.2);
        settings.starts = 4;
        const JobContext job(nullptr, 4, [](const JobProgress &) { throw std::bad_alloc(); });
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, std::ignore = packIslands(islands, settings, job));
    }

    void sameArgumentsGiveTheSameBits()
    {
        const std::vector<PackIsland> islands = randomStars(30, 3);
        PackOptions settings = quick(0.2);
        settings.starts = 3;
        const PackResult first = packIslands(islands, settings);
        QVERIFY(sameBits(first, packIslands(islands, settings)));
        QVERIFY2(sameBits(first, packIslands(islands, settings, {nullptr, 2})), "another number of threads");
        settings.seed = 2;
        QVERIFY2(!sameBits(first, packIslands(islands, settings)), "the seed matters");
    }

    void lockedIslandsStay()
    {
        std::vector<PackIsland> islands = randomStars(25, 5);
        islands.push_back(box(0.4, 0.4, 0.2, 0.2));
        islands.push_back(box(0.9, -0.2, 0.3, 0.5));
        islands.push_back(box(0.45, 0.45, 0.3, 0.3)); // overlaps another locked one: not our business
        for (std::size_t i = 25; i < islands.size(); ++i)
            islands[i].locked = true;
        const PackOptions settings = quick(0.2);
        const PackResult result = packIslands(islands, settings);
        QVERIFY(result.complete);
        for (std::size_t i = 25; i < islands.size(); ++i) {
            QCOMPARE(result.placements[i].angle, 0.0);
            QCOMPARE(result.placements[i].translation, Vec2(0, 0));
        }
        const QString broken = brokenRule(islands, settings, result);
        QVERIFY2(broken.isEmpty(), qPrintable(broken));
        QVERIFY(result.efficiency > 0.4);
    }

    void noRoomBesideALockedIsland()
    {
        PackIsland all = box(-1, -1, 3, 3);
        all.locked = true;
        const PackResult result = packIslands({all, box(0, 0, 1, 1)}, quick());
        QVERIFY(!result.complete);
        QVERIFY(isFinite(result));
    }

    void keepScale()
    {
        std::vector<PackIsland> islands = randomStars(40, 11);
        PackOptions settings = quick(0.3);
        const double largest = packIslands(islands, settings).scale;
        // Near what can be reached: shelves are not enough.
        for (PackIsland &island : islands) {
            for (Vec2 &p : island.points)
                p *= 0.9 * largest;
        }
        settings.keepScale = true;
        const PackResult result = packIslands(islands, settings);
        QVERIFY(result.complete);
        QCOMPARE(result.scale, 1.0);
        const QString broken = brokenRule(islands, settings, result);
        QVERIFY2(broken.isEmpty(), qPrintable(broken));

        settings.effort = 0.05;
        const PackResult tooLarge = packIslands(std::vector<PackIsland>(5, box(0, 0, 0.9, 0.9)), settings);
        QVERIFY(!tooLarge.complete);
        QCOMPARE(tooLarge.scale, 1.0);
    }

    //! Whether one island fits needs no search.
    void keepScaleOfOneIsland_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<bool>("fits");
        QTest::newRow("small") << 0.5 << true;
        QTest::newRow("only along a diagonal") << 1.2 << true;
        QTest::newRow("too long") << 1.5 << false;
    }
    void keepScaleOfOneIsland()
    {
        QFETCH(double, width);
        PackOptions settings = quick(1000);
        settings.keepScale = true;
        settings.rotation = PackRotation::Free;
        int reports = 0;
        const JobContext job(nullptr, 1, [&reports](const JobProgress &) { ++reports; });
        const std::vector<PackIsland> islands{box(0, 0, width, 0.05)};
        const PackResult result = packIslands(islands, settings, job);
        QTEST(result.complete, "fits");
        QCOMPARE(result.scale, 1.0);
        const QString broken = brokenRule(islands, settings, result);
        QVERIFY2(!result.complete || broken.isEmpty(), qPrintable(broken));
        QCOMPARE(reports, 1); // the end
    }

    void cancelReturnsTheBestSoFar()
    {
        const std::vector<PackIsland> islands = randomStars(60, 13);
        std::atomic<bool> cancel{true};
        PackOptions settings = quick(1000);
        const PackResult none = packIslands(islands, settings, &cancel);
        QVERIFY(isFinite(none));
        cancel = false;
        double reported = 0;
        const PackResult result = packIslands(islands, settings, {&cancel, 1, [&](const JobProgress &done) {
                                                                      reported = done.fraction;
                                                                      cancel = true;
                                                                  }});
        QVERIFY(reported > 0);
        QVERIFY(result.complete);
        const QString broken = brokenRule(islands, settings, result);
        QVERIFY2(broken.isEmpty(), qPrintable(broken));
    }

    void chartsRoundTrip()
    {
        const auto mesh = test::quadCube();
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            // Every face at its own place and size, all in one heap.
            const int face = c / 4;
            const double size = 1 + 0.5 * face;
            uv.row(c) << size * ((c % 4 == 1 || c % 4 == 2) ? 1 : 0) + 0.01 * face,
                size * (c % 4 >= 2 ? 1 : 0);
        }
        const ChartMap charts = findCharts(*mesh, uv);
        QCOMPARE(charts.count, 6);
        equalizeTexelDensity(*mesh, charts, uv);
        for (int f = 0; f < 6; ++f)
            QVERIFY(std::abs((uv.row(4 * f + 1) - uv.row(4 * f)).norm() - (uv.row(1) - uv.row(0)).norm()) <
                    1e-12);
        const std::vector<PackIsland> islands = makePackIslands(*mesh, uv, charts);
        QCOMPARE(islands.size(), std::size_t(6));
        QCOMPARE(islands[2].points.size(), std::size_t(4));
        QCOMPARE(islands[2].triangles.size(), std::size_t(2));
        QCOMPARE(islands[2].boundary.size(), std::size_t(4));
        const PackResult result = packIslands(islands, quick(0.1));
        UvMatrix packed = uv;
        applyPlacements(result, *mesh, charts, packed);
        QCOMPARE(findCharts(*mesh, packed).count, 6);
        QVERIFY(packed.minCoeff() >= 0 && packed.maxCoeff() <= 1);
        QVERIFY(std::abs((packed.row(1) - packed.row(0)).norm() -
                         result.scale * (uv.row(1) - uv.row(0)).norm()) < 1e-12);
        QVERIFY(result.efficiency > 0.6);
    }

    void lockedChartsSetTheDensity()
    {
        const auto mesh = test::quadCube();
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            const double size = c / 4 == 2 ? 0.25 : 1;
            uv.row(c) << size * ((c % 4 == 1 || c % 4 == 2) ? 1 : 0) + 0.01 * (c / 4),
                size * (c % 4 >= 2 ? 1 : 0);
        }
        const ChartMap charts = findCharts(*mesh, uv);
        std::vector<bool> locked(6, false);
        locked[charts.faceChart[2]] = true;
        const UvMatrix before = uv;
        equalizeTexelDensity(*mesh, charts, uv, locked);
        QCOMPARE(uv.middleRows(8, 4), before.middleRows(8, 4));
        QVERIFY(std::abs((uv.row(1) - uv.row(0)).norm() - 0.25) < 1e-12);
    }

    //! Of a strip of two quads one is stretched: the other one gets the density of the rest.
    void facesThatKeepTheirShapeSetTheDensity()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0},
                                             {1, 0, 0},
                                             {2, 0, 0},
                                             {0, 1, 0},
                                             {1, 1, 0},
                                             {2, 1, 0},
                                             {5, 0, 0},
                                             {6, 0, 0},
                                             {6, 1, 0},
                                             {5, 1, 0}},
                                            {{0, 1, 4, 3}, {1, 2, 5, 4}, {6, 7, 8, 9}});
        UvMatrix uv(12, 2);
        uv << 0, 0, 1, 0, 1, 1, 0, 1, 1, 0, 1.5, 0, 1.5, 1, 1, 1, 5, 0, 8, 0, 8, 3, 5, 3;
        equalizeTexelDensity(*mesh, findCharts(*mesh, uv), uv, {}, DensityBasis::FlatParts);
        QVERIFY(std::abs((uv.row(1) - uv.row(0)).norm() - (uv.row(9) - uv.row(8)).norm()) < 1e-12);
    }

    void realIslands()
    {
        const std::vector<std::string> files = test::islandFiles();
        if (files.empty())
            QSKIP("no island files: set AUTOCUTS_ISLANDS");
        double sum = 0;
        for (const std::string &file : files) {
            const test::UvMesh data = test::readUvMesh(file);
            QVERIFY(data.mesh);
            const ChartMap charts = findCharts(*data.mesh, data.uv);
            const std::vector<PackIsland> islands = makePackIslands(*data.mesh, data.uv, charts);
            const PackOptions settings = quick(0.5);
            const PackResult result = packIslands(islands, settings);
            QVERIFY(result.complete);
            sum += result.efficiency;
            qInfo("%s: %d islands, efficiency %.4f", file.c_str(), charts.count, result.efficiency);
        }
        QVERIFY2(sum / static_cast<double>(files.size()) >= 0.62, "mean efficiency");
    }
};

QTEST_APPLESS_MAIN(TestPacking)

} // namespace tst_packing

#include "tst_packing.moc"
