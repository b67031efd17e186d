// How much work an unwrap is, counted in triangles times Newton steps: the same on every machine.
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace tst_countedwork {

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

//! Points and triangles of closed shapes with knobs, no two alike.
struct Knobs
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;

    //! \param which tells it from others
    void add(int rings, int which)
    {
        const int segments = 2 * rings, first = static_cast<int>(points.size());
        const double size = 1 + 0.1 * which;
        const auto place = [&](double up, double around) {
            const double radius =
                size * (1 + 0.3 * std::sin((3 + which % 3) * around + which) * std::sin(3 * up));
            return Vec3(radius * std::sin(up) * std::cos(around) + 5 * which,
                        radius * std::sin(up) * std::sin(around), radius * std::cos(up));
        };
        points.push_back(place(0, 0));
        for (int r = 1; r < rings; ++r) {
            for (int s = 0; s < segments; ++s)
                points.push_back(place(std::numbers::pi * r / rings, 2 * std::numbers::pi * s / segments));
        }
        points.push_back(place(std::numbers::pi, 0));
        const int last = static_cast<int>(points.size()) - 1;
        const auto at = [&](int r, int s) { return first + 1 + (r - 1) * segments + s % segments; };
        for (int s = 0; s < segments; ++s) {
            faces.push_back({first, at(1, s), at(1, s + 1)});
            faces.push_back({last, at(rings - 1, s + 1), at(rings - 1, s)});
            for (int r = 1; r + 1 < rings; ++r) {
                faces.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
                faces.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
            }
        }
    }
    test::MeshPtr mesh() const { return test::polygonMesh(points, faces); }
};

//! Triangles times Newton steps.
long long workOn(const test::MeshPtr &mesh, UnwrapQuality quality)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    UnwrapOptions options;
    options.quality = quality;
    options.pack = false;
    std::atomic<long long> work = 0;
    (void)unwrapMesh(snapshot, options, JobContext().countedBy(work));
    return work;
}

} // namespace

class TestCountedWork : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void partsCostWhatTheyCostAlone_data()
    {
        QTest::addColumn<UnwrapQuality>("quality");
        QTest::addColumn<int>("parts");
        QTest::addColumn<int>("rings");
        QTest::newRow("draft") << UnwrapQuality::Draft << 6 << 8;
        QTest::newRow("standard") << UnwrapQuality::Standard << 3 << 5;
    }
    void partsCostWhatTheyCostAlone()
    {
        QFETCH(UnwrapQuality, quality);
        QFETCH(int, parts);
        QFETCH(int, rings);
        Knobs together;
        long long alone = 0;
        for (int i = 0; i < parts; ++i) {
            Knobs one;
            one.add(rings, i);
            together.add(rings, i);
            alone += workOn(one.mesh(), quality);
        }
        const long long all = workOn(together.mesh(), quality);
        qInfo() << "together" << all << "alone" << alone;
        QVERIFY(all > 0);
        QVERIFY(all < 1.3 * double(alone));
    }

    //! By way of a coarse mesh, a finer one costs only what its last steps cost.
    void workGrowsWithTheTriangles()
    {
        Knobs coarse, fine;
        coarse.add(56, 1);
        fine.add(112, 1);
        const long long less = workOn(coarse.mesh(), UnwrapQuality::Draft),
                        more = workOn(fine.mesh(), UnwrapQuality::Draft);
        qInfo() << coarse.faces.size() << less << fine.faces.size() << more;
        QVERIFY(less > 0);
        QVERIFY(more < 2 * less);
    }

    void trianglesWithoutAreaCostLittle()
    {
        Knobs clean;
        clean.add(12, 1);
        Knobs degenerate = clean;
        const std::size_t count = clean.faces.size();
        for (std::size_t face = 0; face < count; face += 7) {
            const auto [a, b, c] =
                std::array{clean.faces[face][0], clean.faces[face][1], clean.faces[face][2]};
            const int middle = static_cast<int>(degenerate.points.size());
            degenerate.points.push_back((degenerate.points[a] + degenerate.points[b]) / 2);
            degenerate.faces[face] = {a, middle, c};
            degenerate.faces.push_back({middle, b, c});
            degenerate.faces.push_back({a, b, middle});
        }
        const long long without = workOn(clean.mesh(), UnwrapQuality::Draft),
                        with = workOn(degenerate.mesh(), UnwrapQuality::Draft);
        qInfo() << "without" << without << "with" << with;
        QVERIFY(without > 0);
        QVERIFY(with < 2 * without);
    }
};

QTEST_GUILESS_MAIN(TestCountedWork)

} // namespace tst_countedwork

#include "tst_countedwork.moc"
