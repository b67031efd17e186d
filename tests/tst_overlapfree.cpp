// relaxWithoutOverlaps(): the shape gets better as far as it goes without covering itself.
#include "solver/definite/relaxing.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace tst_overlapfree {

using namespace autocuts;
using namespace autocuts::definite;

namespace {

//! Eight triangles of 50 degrees about a vertex, 400 together: a saddle, cut open from the rim to its middle.
//! Without distortion its two ends lie one over the other.
struct Saddle
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;
    SeamedMap map;

    //! \param degrees that all triangles together take up in the map
    explicit Saddle(double degrees)
    {
        constexpr int count = 8;
        std::vector<Vec3> points{{0, 0, 0}};
        std::vector<std::vector<int>> faces;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            points.emplace_back(std::cos(angle), std::sin(angle), k % 2 ? 0.198 : -0.198);
            faces.push_back({0, k + 1, (k + 1) % count + 1});
        }
        snapshot.mesh = test::polygonMesh(points, faces);
        soup = Soup::build(snapshot.mesh);
        const MeshData &mesh = *snapshot.mesh;
        for (const EdgePair &pair : mesh.edgePairs)
            map.cut.push_back(std::abs(mesh.triangleFace[pair.triangle[0]] -
                                       mesh.triangleFace[pair.triangle[1]]) == count - 1);
        for (int c = 0; c < mesh.soupCornerCount(); ++c) {
            const int face = mesh.triangleFace[c / 3], corner = mesh.cornerOfSoup(c) - mesh.faceStart[face];
            const double angle = degrees / count * (face + (corner == 2)) * std::numbers::pi / 180;
            const double radius = corner == 0 ? 0 : soup->scale;
            map.x.insert(map.x.end(), {radius * std::cos(angle), radius * std::sin(angle)});
        }
    }

    double distortion() const { return map.distortion(*soup); }
    //! Angle between the two sides of the cut, degrees; negative when they lie one over the other.
    double opening() const
    {
        double turned = 0;
        for (int t = 0; t < soup->triangleCount(); ++t) {
            const double *c = &map.x[6 * static_cast<std::size_t>(t)];
            const int apex = apexOf(t), next = (apex + 1) % 3, last = (apex + 2) % 3;
            const Vec2 a(c[2 * next] - c[2 * apex], c[2 * next + 1] - c[2 * apex + 1]);
            const Vec2 b(c[2 * last] - c[2 * apex], c[2 * last + 1] - c[2 * apex + 1]);
            turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
        return 360 - turned * 180 / std::numbers::pi;
    }

private:
    int apexOf(int triangle) const
    {
        const MeshData &mesh = *snapshot.mesh;
        int apex = 0;
        while (mesh.cornerVertex[mesh.triangles[triangle][apex]] != 0)
            ++apex;
        return apex;
    }
};

} // namespace

class TestOverlapFree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! What the case is worth: relaxed freely it covers itself.
    void relaxedFreelyItCoversItself()
    {
        Saddle saddle(340);
        QVERIFY(!coversItself(*saddle.soup, saddle.map));
        relaxMap(saddle.soup, saddle.snapshot, saddle.map, 50);
        QVERIFY(coversItself(*saddle.soup, saddle.map));
        QVERIFY2(std::abs(saddle.opening() + 40) < 0.5, qPrintable(QString::number(saddle.opening())));
        QVERIFY(saddle.distortion() < 4 + 1e-6);
    }

    void noOverlapArises_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::newRow("wide open") << 200.;
        QTest::newRow("nearly closed") << 340.;
    }
    void noOverlapArises()
    {
        QFETCH(double, degrees);
        Saddle saddle(degrees);
        double before = saddle.distortion();
        for (int round = 0; round < 100; ++round) {
            const int steps = relaxWithoutOverlaps(saddle.soup, saddle.snapshot, saddle.map, 1);
            QCOMPARE(saddle.map.validate(*saddle.soup), std::string());
            QVERIFY(!coversItself(*saddle.soup, saddle.map));
            QVERIFY(saddle.opening() > 0);
            if (steps == 0)
                break;
        }
        const double after = saddle.distortion();
        QVERIFY2(after < before, qPrintable(QStringLiteral("%1 -> %2").arg(before).arg(after)));
        // The opening is as narrow as the barrier lets it be.
        QVERIFY2(saddle.opening() < 10, qPrintable(QString::number(saddle.opening())));
    }

    void whereNothingIsInTheWayItIsTheFreeOne()
    {
        const test::MeshPtr mesh = test::grid(4, 0.3);
        Snapshot snapshot;
        snapshot.mesh = mesh;
        const auto soup = Soup::build(mesh);
        SeamedMap map;
        map.cut.assign(mesh->edgePairs.size(), false);
        for (int c = 0; c < mesh->soupCornerCount(); ++c) {
            const Vec3 p = mesh->cornerPosition(mesh->cornerOfSoup(c)) * soup->scale;
            map.x.insert(map.x.end(), {p.x() + 0.1 * p.y(), p.y()});
        }
        SeamedMap free = map;
        QVERIFY(relaxWithoutOverlaps(soup, snapshot, map, 200) > 1);
        relaxMap(soup, snapshot, free, 200);
        QVERIFY2(std::abs(map.distortion(*soup) - free.distortion(*soup)) < 1e-5,
                 qPrintable(QStringLiteral("%1 %2")
                                .arg(map.distortion(*soup), 0, 'g', 10)
                                .arg(free.distortion(*soup), 0, 'g', 10)));
    }

    void aMapThatCrossesItselfIsLeftAlone()
    {
        Saddle saddle(400);
        const std::vector<double> before = saddle.map.x;
        QCOMPARE(relaxWithoutOverlaps(saddle.soup, saddle.snapshot, saddle.map, 50), 0);
        QVERIFY(saddle.map.x == before);
    }

    void cancellingTakesNoStep()
    {
        const std::atomic<bool> cancel = true;
        Saddle saddle(300);
        const std::vector<double> before = saddle.map.x;
        QCOMPARE(relaxWithoutOverlaps(saddle.soup, saddle.snapshot, saddle.map, 50, &cancel), 0);
        QVERIFY(saddle.map.x == before);
    }
};

QTEST_APPLESS_MAIN(TestOverlapFree)

} // namespace tst_overlapfree

#include "tst_overlapfree.moc"
