// The steps of the packer, one by one on islands laid out by hand: what is in the way, bottom-left and
// compaction.
#include "solver/packing/bottomleft.h"
#include "solver/packing/compaction.h"
#include "support/packchecks.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tst_packingsteps {

using namespace autocuts;
using namespace autocuts::packing;
using namespace autocuts::test;

namespace {

constexpr double gutter = 0.02;
constexpr double infinite = std::numeric_limits<double>::infinity();

//! Islands in a bin, where they stand; what comes out is checked without the packer's own test.
struct Desk
{
    std::vector<PackIsland> islands;
    PackProblem problem;
    WorkMeter work{1e6, nullptr};

    Desk(std::vector<PackIsland> given, const Vec2 &size) : islands(std::move(given))
    {
        problem.upper = size;
        problem.gutter = gutter;
        for (const PackIsland &island : islands) {
            problem.outlines.push_back(makeOutline(island, 1));
            problem.locked.push_back(island.locked);
            problem.given.push_back({0, problem.outlines.back().centre});
        }
    }
    Layout asGiven() const { return {1, problem.given}; }

    //! The rule of the packer that a layout breaks, or nothing.
    QString broken(const Layout &layout) const
    {
        PackOptions settings;
        // As the packer does, the bin is a little larger than what its steps are told.
        settings.lower = problem.lower - Vec2::Constant(1e-9);
        settings.upper = problem.upper + Vec2::Constant(1e-9);
        settings.textureSize = 1;
        settings.margin = problem.gutter;
        settings.border = 0;
        PackResult result;
        result.scale = layout.scale;
        for (int i = 0; i < problem.count(); ++i) {
            const Pose &pose = layout.poses[i];
            const Turn turn(pose.angle, problem.locked[i] ? 1 : layout.scale);
            result.placements.push_back({pose.angle, pose.position - turn(problem.outlines[i].centre)});
        }
        return brokenRule(islands, settings, result);
    }
    std::vector<int> order() const
    {
        std::vector<int> result;
        for (int i = 0; i < problem.count(); ++i) {
            if (problem.movable(i))
                result.push_back(i);
        }
        return result;
    }
};

bool samePoses(const Layout &a, const Layout &b)
{
    return std::equal(
        a.poses.begin(), a.poses.end(), b.poses.begin(), b.poses.end(),
        [](const Pose &p, const Pose &q) { return p.angle == q.angle && p.position == q.position; });
}

//! Four unit squares with room between them, in a square.
Desk fourSquares(double side)
{
    const double far = side - 1.1;
    return {{box(0.1, 0.1, 1, 1), box(far, 0.1, 1, 1), box(0.1, far, 1, 1), box(far, far, 1, 1)},
            Vec2(side, side)};
}

} // namespace

class TestPackingSteps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Such as the islands of other tiles. A single island among them is fitted as if it were alone.
    void lockedIslandsOutOfReachDoNotCount_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("one") << 1;
        QTest::newRow("several") << 9;
    }
    void lockedIslandsOutOfReachDoNotCount()
    {
        QFETCH(int, count);
        std::vector<PackIsland> islands = randomStars(count, 7);
        PackOptions settings;
        settings.effort = 0.05;
        settings.margin = 4;
        settings.lower = Vec2(1, 0);
        settings.upper = Vec2(2, 1);
        const PackResult alone = packIslands(islands, settings);
        // They touch the borders of the tiles beside and above.
        const double border = 0.5 * settings.margin / settings.textureSize + 1e-7;
        islands.push_back(box(border, border, 1 - 2 * border, 1 - 2 * border));
        islands.push_back(box(1 + border, 1 + border, 1 - 2 * border, 1 - 2 * border));
        islands[count].locked = islands[count + 1].locked = true;
        const PackResult among = packIslands(islands, settings);
        QVERIFY(alone.complete && among.complete);
        QCOMPARE(among.scale, alone.scale);
        QCOMPARE(among.efficiency, alone.efficiency);
        for (int i = 0; i < count; ++i) {
            QCOMPARE(among.placements[i].angle, alone.placements[i].angle);
            QCOMPARE(among.placements[i].translation, alone.placements[i].translation);
        }
        // One that reaches over the border is in the way.
        islands.push_back(box(0.9, 0.4, 0.4, 0.2));
        islands.back().locked = true;
        const PackResult around = packIslands(islands, settings);
        QVERIFY(around.complete);
        QVERIFY(around.scale < alone.scale);
        QCOMPARE(brokenRule(islands, settings, around), QString());
    }

    // Compaction.

    void twoThatAreTooNearArePushedApart()
    {
        Desk desk({box(1, 1, 1, 1), box(2 + 0.5 * gutter, 1, 1, 1)}, Vec2(4, 3));
        QVERIFY(!desk.broken(desk.asGiven()).isEmpty());
        Compaction bodies(desk.problem, desk.asGiven());
        QVERIFY(bodies.resolve(60, desk.work));
        const Layout &after = bodies.layout();
        QCOMPARE(desk.broken(after), QString());
        QCOMPARE(after.scale, 1.);
        // No farther than needed, and both the same way.
        const Pose &left = after.poses[0], &right = after.poses[1];
        const double gap = right.position.x() - left.position.x() - 1;
        QVERIFY2(gap >= gutter && gap < 1.02 * gutter, qPrintable(QString::number(gap / gutter)));
        QVERIFY(std::abs(left.position.x() + right.position.x() - 4 - 0.5 * gutter) < 0.1 * gutter);
        for (const Pose &pose : after.poses)
            QVERIFY(std::abs(pose.position.y() - 1.5) < 0.1 * gutter && std::abs(pose.angle) < 0.1 * gutter);
    }

    void whatIsLockedStays()
    {
        std::vector<PackIsland> islands{box(1, 1, 1, 1), box(2 + 0.5 * gutter, 1, 1, 1)};
        islands[0].locked = true;
        Desk desk(islands, Vec2(4, 3));
        Compaction bodies(desk.problem, desk.asGiven());
        QVERIFY(bodies.resolve(60, desk.work));
        QCOMPARE(desk.broken(bodies.layout()), QString());
        QCOMPARE(bodies.layout().poses[0].position, desk.problem.given[0].position);
        QCOMPARE(bodies.layout().poses[0].angle, 0.);
        QVERIFY(bodies.layout().poses[1].position.x() >= 2.5 + gutter);
    }

    void theWallsPush()
    {
        Desk desk({box(-0.2, 0.5, 1, 1), box(2.3, 2.4, 1, 1)}, Vec2(3, 3));
        desk.problem.rotation = PackRotation::None;
        Compaction bodies(desk.problem, desk.asGiven());
        QVERIFY(bodies.resolve(60, desk.work));
        QCOMPARE(desk.broken(bodies.layout()), QString());
        QVERIFY((bodies.layout().poses[0].position - Vec2(0.5, 1)).norm() < 0.1 * gutter);
        QVERIFY((bodies.layout().poses[1].position - Vec2(2.5, 2.5)).norm() < 0.1 * gutter);
    }

    void turnsAreMadeOnlyWhereTheyAreAllowed_data()
    {
        QTest::addColumn<int>("rotation");
        QTest::addColumn<bool>("standsSquare");
        QTest::addColumn<bool>("turns");
        QTest::newRow("free") << int(PackRotation::Free) << false << true;
        QTest::newRow("free, but square") << int(PackRotation::Free) << true << false;
        QTest::newRow("quarter") << int(PackRotation::Quarter) << false << false;
        QTest::newRow("none") << int(PackRotation::None) << false << false;
    }
    void turnsAreMadeOnlyWhereTheyAreAllowed()
    {
        QFETCH(int, rotation);
        // The corner of the one pushes the end of the other, long one.
        Desk desk({box(1, 1, 0.4, 3), box(1.4 + 0.2 * gutter, 3.6, 0.5, 0.5)}, Vec2(3, 5));
        desk.problem.rotation = static_cast<PackRotation>(rotation);
        QFETCH(bool, standsSquare);
        for (Outline &outline : desk.problem.outlines) {
            QVERIFY(outline.squareAngle);
            if (!standsSquare)
                outline.squareAngle.reset();
        }
        Compaction bodies(desk.problem, desk.asGiven());
        QVERIFY(bodies.resolve(60, desk.work));
        QCOMPARE(desk.broken(bodies.layout()), QString());
        QTEST(bodies.layout().poses[0].angle > 0, "turns");
    }

    void withoutRoomItSaysSo()
    {
        Desk desk({box(0, 0, 1, 1), box(0.9, 0, 1, 1)}, Vec2(1.9, 1));
        Compaction bodies(desk.problem, desk.asGiven());
        QVERIFY(!bodies.resolve(60, desk.work));
    }

    void compactingMakesTheIslandsAsLargeAsTheyFit_data()
    {
        QTest::addColumn<double>("ceiling");
        QTest::newRow("no ceiling") << infinite;
        QTest::newRow("ceiling") << 1.1;
        QTest::newRow("ceiling below") << 0.9;
    }
    void compactingMakesTheIslandsAsLargeAsTheyFit()
    {
        QFETCH(double, ceiling);
        Desk desk = fourSquares(2.6);
        QCOMPARE(desk.broken(desk.asGiven()), QString());
        const Layout after = compactLayout(desk.problem, desk.asGiven(), ceiling, desk.work);
        QCOMPARE(desk.broken(after), QString());
        const double largest = 0.5 * (2.6 - gutter);
        if (ceiling < 1)
            QVERIFY(after.scale == 1 && samePoses(after, desk.asGiven()));
        else if (ceiling < largest)
            QCOMPARE(after.scale, ceiling);
        else
            QVERIFY2(after.scale > 0.99 * largest && after.scale <= largest,
                     qPrintable(QString::number(after.scale / largest)));
    }

    void aLayoutThatIsFullStaysAsItIs()
    {
        // Two by two squares with the gutter between them fill the bin.
        const double far = 1 + gutter * 1.0001;
        Desk desk({box(0, 0, 1, 1), box(far, 0, 1, 1), box(0, far, 1, 1), box(far, far, 1, 1)},
                  Vec2(1 + far, 1 + far));
        QCOMPARE(desk.broken(desk.asGiven()), QString());
        const Layout after = compactLayout(desk.problem, desk.asGiven(), infinite, desk.work);
        QCOMPARE(desk.broken(after), QString());
        QVERIFY2(after.scale >= 1 && after.scale < 1.001, qPrintable(QString::number(after.scale, 'g', 8)));
    }

    void compactingNeverMakesALayoutWorse()
    {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Desk desk(randomStars(20, seed), Vec2(1, 1));
            BottomLeft packer(desk.problem, 256, 4);
            std::optional<Layout> before;
            for (double scale = 0.9; !before && scale > 0.1; scale *= 0.9) {
                before = packer.pack(scale, desk.order(), 0, 0.8, desk.work);
                if (before && !desk.broken(*before).isEmpty())
                    before.reset();
            }
            QVERIFY(before);
            const Layout after = compactLayout(desk.problem, *before, infinite, desk.work);
            QVERIFY(after.scale >= before->scale);
            QCOMPARE(desk.broken(after), QString());
        }
    }

    // Bottom-left.

    void islandsStandInARowFromTheLowerLeftCorner()
    {
        Desk desk({box(7, 3, 0.9, 0.5), box(5, 5, 0.7, 0.9), box(0, 0, 0.8, 0.3)}, Vec2(3, 2));
        desk.problem.rotation = PackRotation::None;
        BottomLeft packer(desk.problem, 512, 8);
        const std::optional<Layout> layout = packer.pack(1, {2, 0, 1}, 0, 0.72, desk.work);
        QVERIFY(layout);
        QCOMPARE(packer.reached(), 1.);
        QCOMPARE(layout->scale, 1.);
        QCOMPARE(desk.broken(*layout), QString());
        const double pixel = std::sqrt((3 + gutter) * (2 + gutter)) / 512;
        const auto near = [&](int island, double left, double width, double height) {
            const Vec2 place = layout->poses[island].position - Vec2(left + 0.5 * width, 0.5 * height);
            // One island is rounded up to whole pixels, after two others.
            return place.minCoeff() > -1e-12 && place.maxCoeff() < 6 * pixel &&
                   layout->poses[island].angle == 0;
        };
        QVERIFY(near(2, 0, 0.8, 0.3));
        QVERIFY(near(0, 0.8 + gutter, 0.9, 0.5));
        QVERIFY(near(1, 1.7 + 2 * gutter, 0.7, 0.9));
    }

    void aFullRowIsFollowedByOneAboveIt()
    {
        Desk desk({box(0, 0, 1, 0.4), box(0, 0, 1, 0.4), box(0, 0, 1, 0.4), box(0, 0, 0.3, 0.1)},
                  Vec2(2.2, 2));
        desk.problem.rotation = PackRotation::None;
        BottomLeft packer(desk.problem, 512, 8);
        const std::optional<Layout> layout = packer.pack(1, desk.order(), 0, 0.72, desk.work);
        QVERIFY(layout);
        QCOMPARE(desk.broken(*layout), QString());
        const auto lower = [&](int island) {
            return layout->poses[island].position.y() - (island == 3 ? 0.05 : 0.2);
        };
        QVERIFY(lower(0) < 0.03 && lower(1) < 0.03);
        QVERIFY(lower(2) >= 0.4 + gutter && lower(2) < 0.4 + gutter + 0.03);
        // The small one goes beside the third, and not higher.
        QVERIFY(std::abs(lower(3) - lower(2)) < 0.01);
    }

    void holesAndTurnsAreUsed()
    {
        // The bar fits only into the ring, and only upright.
        Desk desk({ring(2, 1.6), box(0, 0, 1.5, 0.2), box(0, 0, 1.5, 0.2)}, Vec2(2.05, 2.05));
        desk.problem.rotation = PackRotation::Quarter;
        BottomLeft packer(desk.problem, 512, 8);
        const std::optional<Layout> layout = packer.pack(1, desk.order(), 0, 0.72, desk.work);
        QVERIFY(layout);
        QCOMPARE(desk.broken(*layout), QString());
        for (const int bar : {1, 2})
            QVERIFY((layout->poses[bar].position - Vec2(1.02, 1.02)).cwiseAbs().maxCoeff() < 0.8);
    }

    void lockedIslandsAreGoneAround()
    {
        PackIsland wall = box(0.5, 0, 0.2, 0.9);
        wall.locked = true;
        Desk desk({wall, box(0, 0, 0.6, 0.6), box(0, 0, 0.4, 0.4)}, Vec2(1.5, 1));
        desk.problem.rotation = PackRotation::None;
        BottomLeft packer(desk.problem, 512, 8);
        const std::optional<Layout> layout = packer.pack(1, {1, 2}, 0, 0.72, desk.work);
        QVERIFY(layout);
        QCOMPARE(desk.broken(*layout), QString());
        QCOMPARE(layout->poses[0].position, desk.problem.given[0].position);
        QVERIFY(layout->poses[1].position.x() > 0.7 + 0.3);
        QVERIFY(layout->poses[2].position.x() < 0.5 - 0.2);
    }

    void whatFindsNoPlaceIsSaid()
    {
        Desk desk({box(0, 0, 1, 1), box(0, 0, 0.5, 0.5), box(0, 0, 0.9, 0.9)}, Vec2(1.8, 1.1));
        BottomLeft packer(desk.problem, 256, 4);
        QVERIFY(!packer.pack(1, desk.order(), 0, 0.72, desk.work));
        QVERIFY(std::abs(packer.reached() - 2. / 3) < 1e-12);
        QVERIFY(!packer.pack(1.2, desk.order(), 0, 0.72, desk.work));
        QCOMPARE(packer.reached(), 0.);
        // The next call knows nothing of that.
        const std::optional<Layout> layout = packer.pack(0.6, desk.order(), 0, 0.72, desk.work);
        QVERIFY(layout);
        QCOMPARE(layout->scale, 0.6);
        QCOMPARE(packer.reached(), 1.);
        QCOMPARE(desk.broken(*layout), QString());
    }
};

QTEST_APPLESS_MAIN(TestPackingSteps)

} // namespace tst_packingsteps

#include "tst_packingsteps.moc"
