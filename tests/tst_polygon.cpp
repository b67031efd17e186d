// Splitting polygons into triangles: the fan rule, ear clipping, and polygons that are no good at all.
#include "model/plain/polygon.h"

#include <Eigen/Geometry>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tst_polygon {

using namespace autocuts;

using Polygon = std::vector<Vec3>;

namespace {

Polygon flat(const std::vector<Vec2> &points)
{
    Polygon polygon;
    for (const Vec2 &p : points)
        polygon.emplace_back(p.x(), p.y(), 0);
    return polygon;
}

//! Alternating radii: a star, or a gear wheel when the points are many.
Polygon star(int corners, double inner)
{
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double radius = i % 2 == 0 ? 1 : inner;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return flat(points);
}

//! A strip of constant width that winds inwards.
Polygon spiral(int steps)
{
    std::vector<Vec2> points;
    const auto at = [&](int i, double radius) {
        const double angle = 0.3 * i;
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i <= steps; ++i)
        points.push_back(at(i, 10 + 0.3 * i + 2));
    for (int i = steps; i >= 0; --i)
        points.push_back(at(i, 10 + 0.3 * i));
    return flat(points);
}

//! Teeth on a bar; every tooth hides the others.
Polygon comb(int teeth)
{
    std::vector<Vec2> points{{0, -1}, {2.0 * teeth, -1}};
    for (int i = teeth - 1; i >= 0; --i) {
        for (const Vec2 &p :
             {Vec2(2.0 * i + 2, 0), Vec2(2.0 * i + 1.7, 3), Vec2(2.0 * i + 1.0, 3), Vec2(2.0 * i + 0.7, 0)})
            points.push_back(p);
    }
    return flat(points);
}

double area(const Polygon &p)
{
    return 0.5 * polygonNormal(p).norm();
}

//! n - 2 triangles, every side in exactly one of them and every diagonal in two that run against each other.
void checkTopology(const Polygon &polygon, const std::vector<std::array<int, 3>> &triangles)
{
    const int n = static_cast<int>(polygon.size());
    QCOMPARE(static_cast<int>(triangles.size()), n - 2);
    std::vector<std::pair<int, int>> sides;
    for (const auto &t : triangles) {
        for (int k = 0; k < 3; ++k)
            sides.emplace_back(t[k], t[(k + 1) % 3]);
    }
    std::sort(sides.begin(), sides.end());
    QVERIFY(std::adjacent_find(sides.begin(), sides.end()) == sides.end());
    int outerSides = 0, lonelyDiagonals = 0;
    for (const auto &[from, to] : sides) {
        QVERIFY(from >= 0 && from < n && from != to);
        const bool outer = (from + 1) % n == to;
        const bool paired = std::binary_search(sides.begin(), sides.end(), std::pair(to, from));
        outerSides += outer && !paired;
        lonelyDiagonals += !outer && !paired;
    }
    QCOMPARE(outerSides, n);
    QCOMPARE(lonelyDiagonals, 0);
}

//! The rule written down as plainly as possible.
int plainFanApex(const Polygon &p)
{
    const int n = static_cast<int>(p.size());
    const Vec3 normal = polygonNormal(p);
    for (int apex = 0; apex < n; ++apex) {
        bool good = true;
        for (int i = 1; i + 1 < n; ++i) {
            const Vec3 x = (p[(apex + i) % n] - p[apex]).cross(p[(apex + i + 1) % n] - p[apex]);
            good = good && x.x() * normal.x() + x.y() * normal.y() + x.z() * normal.z() >= 0;
        }
        if (good)
            return apex;
    }
    return -1;
}

std::uint64_t splitMix(std::uint64_t &state)
{
    std::uint64_t z = state += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
}

double uniform(std::uint64_t &state)
{
    return static_cast<double>(splitMix(state) >> 11) * 0x1p-53;
}

} // namespace

class TestPolygon : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void simplePolygonIsCovered_data()
    {
        QTest::addColumn<Polygon>("polygon");
        QTest::addColumn<int>("apex");
        QTest::newRow("square") << flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}) << 0;
        QTest::newRow("arrow") << flat({{0, 0}, {2, -1}, {0, 2}, {-2, -1}}) << 0;
        QTest::newRow("arrow turned") << flat({{2, -1}, {0, 2}, {-2, -1}, {0, 0}}) << 1;
        QTest::newRow("L") << flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) << 0;
        QTest::newRow("L turned") << flat({{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}}) << 2;
        QTest::newRow("U") << flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}) << -1;
        QTest::newRow("collinear") << flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}) << 0;
        QTest::newRow("U with collinear points") << flat({{0, 0},
                                                          {1.5, 0},
                                                          {3, 0},
                                                          {3, 2},
                                                          {3, 3},
                                                          {2, 3},
                                                          {2, 2},
                                                          {2, 1},
                                                          {1, 1},
                                                          {1, 3},
                                                          {0, 3},
                                                          {0, 1}})
                                                 << -1;
        QTest::newRow("star") << star(10, 0.3) << -1;
        QTest::newRow("gear") << star(200, 0.9) << -1;
        QTest::newRow("gear of 10,000 points") << star(10000, 0.999) << -1;
        QTest::newRow("spiral") << spiral(60) << -1;
        QTest::newRow("spiral of 10,000 points") << spiral(4999) << -1;
        QTest::newRow("comb") << comb(2000) << -1;
        QTest::newRow("circle of 10,000 points") << star(10000, 1) << 0;
    }

    void simplePolygonIsCovered()
    {
        QFETCH(Polygon, polygon);
        QFETCH(int, apex);
        QCOMPARE(fanApex(polygon), apex);
        const double whole = area(polygon);
        // Where it lies, how it is turned and how large it is must not matter.
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()));
        for (const double scale : {1.0, 1e-150, 1e-20, 1e20, 1e149}) {
            for (const bool turned : {false, true}) {
                Polygon moved;
                for (const Vec3 &p : polygon)
                    moved.push_back(scale * (turned ? turn * p : p));
                const auto triangles = triangulatePolygon(moved);
                checkTopology(moved, triangles);
                if (turned && apex == 0)
                    continue; // rounding alone decides about collinear points
                double sum = 0;
                int flipped = 0;
                for (const auto &t : triangles) {
                    const Vec3 n = polygonNormal({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
                    flipped += n.z() < -1e-12 * whole;
                    sum += 0.5 * n.z();
                }
                QCOMPARE(flipped, 0);
                QVERIFY(std::abs(sum - whole) <= 1e-12 * whole);
            }
        }
    }

    void farFromTheOrigin()
    {
        Polygon polygon = flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
        for (Vec3 &p : polygon)
            p += Vec3(1e9, -2e9, 3e9);
        const auto triangles = triangulatePolygon(polygon);
        checkTopology(polygon, triangles);
        double sum = 0;
        for (const auto &t : triangles)
            sum += area({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
        QCOMPARE(sum, 7.0);
    }

    void fanRuleIsThePlainOne()
    {
        std::uint64_t state = 7;
        int withoutApex = 0, laterApex = 0;
        for (int round = 0; round < 3000; ++round) {
            const int n = 4 + static_cast<int>(splitMix(state) % 20);
            const double wobble = uniform(state);
            Polygon polygon;
            for (int i = 0; i < n; ++i) {
                const double angle = 2 * std::numbers::pi * i / n;
                const double radius = 1 - 0.9 * wobble * uniform(state);
                // Every second one on a lattice, so that exact zeros occur.
                const Vec3 p(radius * std::cos(angle), radius * std::sin(angle),
                             0.2 * wobble * uniform(state));
                polygon.push_back(round % 2 == 0 ? p : Vec3((8 * p).array().round()));
            }
            const int apex = plainFanApex(polygon);
            withoutApex += apex < 0;
            laterApex += apex > 0;
            QCOMPARE(fanApex(polygon), apex);
            checkTopology(polygon, triangulatePolygon(polygon));
        }
        QVERIFY2(withoutApex > 100, qPrintable(QString::number(withoutApex)));
        QVERIFY2(laterApex > 100, qPrintable(QString::number(laterApex)));
    }

    void hopelessPolygonStillGivesTriangles_data()
    {
        QTest::addColumn<Polygon>("polygon");
        QTest::newRow("one point") << Polygon(5, Vec3(1, 2, 3));
        QTest::newRow("a line") << flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}});
        QTest::newRow("there and back") << flat({{0, 0}, {1, 0}, {2, 0}, {1, 0}});
        QTest::newRow("bow tie") << flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
        QTest::newRow("repeated points")
            << flat({{0, 0}, {0, 0}, {3, 0}, {3, 3}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
        QTest::newRow("hole with a bridge")
            << flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
        std::vector<Vec2> pentagram;
        for (int i = 0; i < 5; ++i)
            pentagram.emplace_back(std::cos(0.8 * std::numbers::pi * i),
                                   std::sin(0.8 * std::numbers::pi * i));
        QTest::newRow("pentagram") << flat(pentagram);
        std::uint64_t state = 3;
        Polygon noise;
        for (int i = 0; i < 3000; ++i)
            noise.emplace_back(uniform(state), uniform(state), uniform(state));
        QTest::newRow("noise of 3,000 points") << noise;
    }

    void hopelessPolygonStillGivesTriangles()
    {
        QFETCH(Polygon, polygon);
        checkTopology(polygon, triangulatePolygon(polygon));
    }

    void bridgeToAHoleKeepsTheHoleOpen()
    {
        const Polygon polygon =
            flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
        double sum = 0;
        for (const auto &t : triangulatePolygon(polygon)) {
            sum += area({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
            const Vec3 middle = (polygon[t[0]] + polygon[t[1]] + polygon[t[2]]) / 3;
            QVERIFY(std::max(std::abs(middle.x() - 2), std::abs(middle.y() - 2)) >= 1);
        }
        QCOMPARE(sum, 12.0);
    }

    void warpedQuadIsSplitAlongTheConvexDiagonal()
    {
        // Seen from above a dart whose notch is at corner 2; only diagonals through it stay inside.
        const Polygon polygon{{0, 0, 0}, {2, 0, 0.3}, {0.5, 0.5, -0.2}, {0, 2, 0.1}};
        QCOMPARE(fanApex(polygon), 0);
        const Polygon turned{{2, 0, 0.3}, {0.5, 0.5, -0.2}, {0, 2, 0.1}, {0, 0, 0}};
        QCOMPARE(fanApex(turned), 1);
    }
};

QTEST_APPLESS_MAIN(TestPolygon)

} // namespace tst_polygon

#include "tst_polygon.moc"
