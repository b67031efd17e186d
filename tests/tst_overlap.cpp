// Overlaps: exact orientation, and the finder against brute force.
#include "model/plain/uvlayout.h"
#include "solver/base/random.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/predicates.h"
#include "support/objuv.h"
#include "support/overlapmaps.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <set>

namespace tst_overlap {

using namespace autocuts;
using namespace autocuts::overlap;

namespace {

bool samePairs(const std::vector<OverlapPair> &a, const std::vector<OverlapPair> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const OverlapPair &p, const OverlapPair &q) {
        return p.first == q.first && p.second == q.second &&
               std::abs(p.area - q.area) <= 1e-13 + 1e-12 * q.area;
    });
}

UvMatrix triangles(const std::vector<std::array<Vec2, 3>> &list)
{
    UvMatrix uv(3 * static_cast<Eigen::Index>(list.size()), 2);
    for (std::size_t i = 0; i < list.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            uv.row(3 * static_cast<Eigen::Index>(i) + k) = list[i][k].transpose();
    }
    return uv;
}

} // namespace

class TestOverlap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void groupsMayLieOnEachOther()
    {
        const std::array<Vec2, 3> one{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
        const std::array<Vec2, 3> beside{Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
        const UvMatrix uv = triangles({one, one, beside, one, beside});
        const auto pairsWithin = [&](const std::vector<int> &group) {
            std::set<std::pair<int, int>> pairs;
            visitOverlapsWithin(uv, group, {},
                                [&](int a, int b, double) { return pairs.emplace(a, b).second; });
            return pairs;
        };
        QVERIFY(pairsWithin({0, 1, 0, 2, 1}).empty());
        QVERIFY((pairsWithin({0, 1, 0, 0, 1}) == std::set<std::pair<int, int>>{{0, 3}}));
        QVERIFY(
            (pairsWithin({7, 7, 2, 7, 2}) == std::set<std::pair<int, int>>{{0, 1}, {0, 3}, {1, 3}, {2, 4}}));
    }

    void orientationIsExact()
    {
        // Points on a fine lattice, many of them in one line: integers say what is true.
        Random random(7);
        int zero = 0;
        for (int i = 0; i < 20000; ++i) {
            std::int64_t x[3], y[3];
            const std::int64_t dx = random.below(1000) - 500, dy = random.below(1000) - 500;
            const std::int64_t startX = (std::int64_t(1) << 50) + random.below(1 << 30);
            const std::int64_t startY = (std::int64_t(1) << 50) + random.below(1 << 30);
            for (int k = 0; k < 3; ++k) {
                const std::int64_t step = random.below(100000);
                x[k] = startX + step * dx + (random.below(4) == 0);
                y[k] = startY + step * dy + (random.below(4) == 0);
            }
            const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
            const int expected = area > 0 ? 1 : area < 0 ? -1 : 0;
            std::array<Vec2, 3> point;
            for (int k = 0; k < 3; ++k)
                point[k] = 0x1p-51 * Vec2(static_cast<double>(x[k]), static_cast<double>(y[k]));
            const auto &[a, b, c] = point;
            QCOMPARE(orientation(a, b, c), expected);
            QCOMPARE(orientation(b, a, c), -expected);
            QCOMPARE(orientation(c, a, b), expected);
            zero += expected == 0;
        }
        QVERIFY(zero > 1000);
        QCOMPARE(orientation({1e-20, 0}, {1, 1e-20}, {2, 2e-20}), -1);
    }

    void finderAgreesWithBruteForce_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("size");
        for (int seed = 1; seed <= 8; ++seed)
            QTest::addRow("seed %d", seed) << seed << (seed % 2 ? 0.1 : 0.4);
    }

    void finderAgreesWithBruteForce()
    {
        QFETCH(int, seed);
        QFETCH(double, size);
        Random random(static_cast<std::uint64_t>(seed));
        std::vector<std::array<Vec2, 3>> list;
        for (int i = 0; i < 300; ++i) {
            std::array<Vec2, 3> t;
            const Vec2 place(random.uniform(), random.uniform());
            // On a coarse lattice every third time, so that shared corners and collinear sides come up.
            for (Vec2 &p : t) {
                p = place + size * Vec2(random.uniform(), random.uniform());
                if (i % 3 == 0)
                    p = Vec2(std::round(16 * p.x()) / 16, std::round(16 * p.y()) / 16);
            }
            switch (random.below(12)) {
            case 0:
                if (!list.empty())
                    t = list[random.below(static_cast<int>(list.size()))];
                break;
            case 1:
                if (!list.empty()) {
                    t = list[random.below(static_cast<int>(list.size()))];
                    std::swap(t[0], t[1]);
                }
                break;
            case 2:
                t[2] = t[0];
                break;
            case 3:
                t[2] = 0.5 * (t[0] + t[1]);
                break;
            case 4:
                t[1] = Vec2(std::numeric_limits<double>::quiet_NaN(), 0);
                break;
            default:
                break;
            }
            list.push_back(t);
        }
        const UvMatrix uv = triangles(list);
        std::vector<std::array<Vec2, 3>> finite = list;
        for (auto &t : finite) {
            if (!t[1].allFinite())
                t = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
        }
        OverlapOptions options;
        const OverlapList found = findOverlaps(uv, options);
        QVERIFY(found.complete);
        const auto expected = test::bruteForce(triangles(finite), options.minAreaRatio * totalUvArea(uv));
        QVERIFY(expected.size() > 20);
        QVERIFY(samePairs(found.pairs, expected));
    }

    void intersectionAreaIsRight()
    {
        const std::array<Vec2, 3> a{Vec2(0, 0), Vec2(2, 0), Vec2(0, 2)};
        QCOMPARE(intersectionArea(a, a), 2.0);
        QCOMPARE(intersectionArea(a, {Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)}), 0.0);
        QCOMPARE(intersectionArea(a, {Vec2(1, 0), Vec2(2, 0), Vec2(1, 1)}), 0.5);
        QCOMPARE(intersectionArea(a, {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1)}), 0.5);
        // Far from the origin no digits are lost in the area.
        std::array<Vec2, 3> b = a;
        for (Vec2 &p : b)
            p += Vec2(1 << 20, 1 << 20);
        QCOMPARE(intersectionArea(b, b), 2.0);
    }

    void touchingTrianglesNeverCount()
    {
        // A jittered grid: neighbours share sides and corners only.
        const auto mesh = test::grid(40);
        Random random(3);
        UvMatrix corner(mesh->cornerCount(), 2);
        std::vector<Vec2> place(mesh->vertexCount());
        for (int v = 0; v < mesh->vertexCount(); ++v)
            place[v] = mesh->positions.row(v).head<2>().transpose() * 0.7 +
                       Vec2(random.uniform(), random.uniform()) * 0.005;
        for (int c = 0; c < mesh->cornerCount(); ++c)
            corner.row(c) = place[mesh->cornerVertex[c]].transpose();
        OverlapOptions options;
        options.minAreaRatio = 0;
        QCOMPARE(findOverlaps(soupUv(*mesh, corner), options).pairs.size(), std::size_t(0));
    }

    void turnedRegularGridHasNone()
    {
        // Many exactly and nearly collinear points.
        const auto mesh = test::grid(30);
        const UvMatrix corner = test::mapped(*mesh, [](const Vec3 &p) {
            return Vec2(0.6 * p.x() - 0.3 * p.y() + 0.1, 0.3 * p.x() + 0.6 * p.y());
        });
        QCOMPARE(findOverlaps(soupUv(*mesh, corner)).pairs.size(), std::size_t(0));
    }

    void nearlyTouching_data()
    {
        QTest::addColumn<double>("depth");
        QTest::addColumn<int>("pairs");
        QTest::newRow("apart") << -1e-9 << 0;
        QTest::newRow("touching") << 0.0 << 0;
        QTest::newRow("an ulp deep") << 1e-16 << 0;
        QTest::newRow("below the threshold") << 5e-11 << 0;
        QTest::newRow("above the threshold") << 1e-9 << 1;
        QTest::newRow("deep") << 1e-3 << 1;
    }

    void nearlyTouching()
    {
        QFETCH(double, depth);
        QFETCH(int, pairs);
        const UvMatrix uv = triangles(
            {{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, {Vec2(1, depth), Vec2(0, depth), Vec2(0.5, -1)}});
        QCOMPARE(findOverlaps(uv).pairs.size(), std::size_t(pairs));
    }

    void stackedTurnedMirroredAndNested()
    {
        const std::array<Vec2, 3> t{Vec2(0, 0), Vec2(3, 0), Vec2(0, 3)};
        const UvMatrix uv = triangles({t,
                                       t,                                            // the same again
                                       {t[1], t[2], t[0]},                           // turned
                                       {t[0], t[2], t[1]},                           // mirrored
                                       {Vec2(0.5, 0.5), Vec2(1, 0.5), Vec2(0.5, 1)}, // inside
                                       {Vec2(10, 10), Vec2(11, 10), Vec2(10, 11)}}); // elsewhere
        const OverlapList list = findOverlaps(uv);
        QCOMPARE(list.pairs.size(), std::size_t(10));
        for (const OverlapPair &pair : list.pairs)
            QCOMPARE(pair.area, pair.second == 4 ? 0.125 : 4.5);
        const std::vector<int> some{1, 4, 5};
        QCOMPARE(findOverlapsAmong(uv, some).pairs, (std::vector<OverlapPair>{{1, 4, 0.125}}));
    }

    void stopsWhenAsked()
    {
        const UvMatrix uv =
            triangles(std::vector<std::array<Vec2, 3>>(100, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}));
        OverlapOptions options;
        options.maxPairs = 10;
        QCOMPARE(findOverlaps(uv, options).complete, false);
        QCOMPARE(findOverlaps(uv, options).pairs.size(), std::size_t(10));
        const std::atomic<bool> cancel{true};
        options = {};
        options.job = &cancel;
        QCOMPARE(findOverlaps(uv, options).complete, false);
        QVERIFY(findOverlaps(UvMatrix(0, 2)).pairs.empty());
    }
};

QTEST_APPLESS_MAIN(TestOverlap)

} // namespace tst_overlap

#include "tst_overlap.moc"
