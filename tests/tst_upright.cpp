// Islands that stand upright: how they are turned, and when an unwrap does so without being asked.
#include "model/plain/uvlayout.h"
#include "solver/base/cornerat.h"
#include "solver/packing/packmap.h"
#include "solver/straight/upright.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace tst_upright {

using namespace autocuts;

namespace {

constexpr double pi = std::numbers::pi;

Vec2 turned(double degrees, const Vec2 &p)
{
    const double a = degrees * pi / 180;
    return {std::cos(a) * p.x() - std::sin(a) * p.y(), std::sin(a) * p.x() + std::cos(a) * p.y()};
}

//! A flat ellipse that faces z. \param degrees by which its long axis is turned from x
test::MeshPtr ellipse(double aspect, double degrees)
{
    constexpr int sides = 48;
    std::vector<Vec3> points{Vec3::Zero()};
    std::vector<std::vector<int>> faces;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * pi * i / sides;
        const Vec2 p = turned(degrees, {aspect * std::cos(angle), std::sin(angle)});
        points.emplace_back(p.x(), p.y(), 0);
        faces.push_back({0, i + 1, (i + 1) % sides + 1});
    }
    return test::polygonMesh(points, faces);
}

//! A flat rectangle that faces z, of 4 x 2 cells. \param degrees by which its long side is turned from x
test::MeshPtr rectangle(double degrees)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            const Vec2 p = turned(degrees, Vec2(x, y));
            points.emplace_back(p.x(), p.y(), 0);
        }
    }
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x)
            faces.push_back({5 * y + x, 5 * y + x + 1, 5 * y + x + 6, 5 * y + x + 5});
    }
    return test::polygonMesh(points, faces);
}

//! The angle by which the x axis of a flat mesh is turned in its map, degrees.
double turnOf(const MeshData &mesh, const std::function<Vec2(int)> &place)
{
    // A rotation: p -> c p + d.
    const auto number = [](const Vec2 &p) { return std::complex(p.x(), p.y()); };
    const Vec2 from = mesh.cornerPosition(1).head<2>() - mesh.cornerPosition(0).head<2>();
    return std::arg(number(place(1) - place(0)) / number(from)) * 180 / pi;
}

unwrap::UnwrapResult unwrapped(const Snapshot &snapshot, PackRotation rotation = PackRotation::Free)
{
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.packing = packing::tileOptions({});
    options.packing.rotation = rotation;
    return unwrap::unwrapMesh(snapshot, options);
}

} // namespace

class TestUpright : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnsIslands_data();
    void turnsIslands();
    void isTakenWhereItIsCheap_data();
    void isTakenWhereItIsCheap();
    void wishesComeFirst_data();
    void wishesComeFirst();
};

void TestUpright::turnsIslands_data()
{
    QTest::addColumn<test::MeshPtr>("mesh");
    QTest::addColumn<double>("expected"); // degrees by which the model is turned in the map
    QTest::newRow("round: exactly") << ellipse(2, 20) << 0.0;
    QTest::newRow("straight, as it stands") << rectangle(0) << 0.0;
    QTest::newRow("straight, tilted: to the axes") << rectangle(30) << -30.0;
    QTest::newRow("straight, tilted far: to the other axis") << rectangle(60) << 30.0;
}

void TestUpright::turnsIslands()
{
    QFETCH(test::MeshPtr, mesh);
    QFETCH(double, expected);
    const std::shared_ptr<const Soup> soup = Soup::build(mesh);
    for (const double degrees : {0.0, 25.0, 130.0, -100.0}) {
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            uv.row(c) = soup->scale * turned(degrees, mesh->cornerPosition(c).head<2>()).transpose();
        const SeamedMap map = *seamedMapOf(*soup, uv, CutFlags(mesh->edgePairs.size(), false));
        const SeamedMap stands = straight::turnedUpright(*soup, map, WorldUp::Y);
        QVERIFY(stands.validate(*soup).empty());
        QCOMPARE(stands.cut, map.cut);
        const UvMatrix result = cornerUv(*soup, stands);
        const double angle = turnOf(*mesh, [&](int c) { return Vec2(result.row(c).transpose()); });
        QVERIFY2(std::abs(angle - expected) < 1e-6, qPrintable(QString::number(angle)));
        QVERIFY(std::abs(stands.distortion(*soup) - map.distortion(*soup)) < 1e-9);
    }
}

void TestUpright::isTakenWhereItIsCheap_data()
{
    QTest::addColumn<test::MeshPtr>("mesh");
    QTest::addColumn<bool>("upright");
    QTest::newRow("a disc") << ellipse(1, 0) << true;
    QTest::newRow("an ellipse along the diagonal") << ellipse(2, 45) << true;
    QTest::newRow("an ellipse that has to lie in the diagonal") << ellipse(2, 10) << false;
    QTest::newRow("a rectangle") << rectangle(30) << true;
}

void TestUpright::isTakenWhereItIsCheap()
{
    QFETCH(test::MeshPtr, mesh);
    QFETCH(bool, upright);
    Snapshot snapshot;
    snapshot.mesh = mesh;
    QCOMPARE(snapshot.settings.worldUp, WorldUp::AutoY);
    const unwrap::UnwrapResult result = unwrapped(snapshot);
    snapshot.settings.worldUp = WorldUp::Off;
    const unwrap::UnwrapResult free = unwrapped(snapshot);
    QCOMPARE(result.upright, upright);
    QVERIFY(!free.upright && free.packed && result.packed);
    QCOMPARE(result.cut, free.cut);
    QCOMPARE(result.distortion, free.distortion);
    QCOMPARE(sameBits(result.uv, free.uv), !upright);
    const double density = layoutScale(*mesh, result.uv), most = layoutScale(*mesh, free.uv);
    QVERIFY2(density >= 0.95 * most, qPrintable(QString::number(density / most)));
}

void TestUpright::wishesComeFirst_data()
{
    QTest::addColumn<std::function<void(Snapshot &)>>("wish");
    QTest::addColumn<PackRotation>("rotation");
    using Wish = std::function<void(Snapshot &)>;
    const auto nothing = [](Snapshot &) {};
    QTest::newRow("how packing turns islands") << Wish(nothing) << PackRotation::Quarter;
    QTest::newRow("align") << Wish([](Snapshot &s) { s.settings.align = CreaseMode::On; })
                           << PackRotation::Free;
    QTest::newRow("stacks") << Wish([](Snapshot &s) { s.settings.alike = AlikeMode::Stack; })
                            << PackRotation::Free;
    const auto keepOne = [](Snapshot &s) {
        s.uv = std::make_shared<const UvMatrix>(unwrapped(s).uv);
        s.editSteering().faceFlags.resize(s.mesh->faceCount());
        for (IslandFlags &flags : s.editSteering().faceFlags)
            flags.upright = 1;
    };
    QTest::newRow("islands that keep their orientation") << Wish(keepOne) << PackRotation::Free;
}

void TestUpright::wishesComeFirst()
{
    QFETCH(std::function<void(Snapshot &)>, wish);
    QFETCH(PackRotation, rotation);
    Snapshot snapshot;
    snapshot.mesh = ellipse(1, 20);
    QVERIFY(unwrapped(snapshot).upright);
    wish(snapshot);
    const unwrap::UnwrapResult result = unwrapped(snapshot, rotation);
    snapshot.settings.worldUp = WorldUp::Off;
    QVERIFY(!result.upright);
    QVERIFY(sameBits(result.uv, unwrapped(snapshot, rotation).uv));
}

QTEST_APPLESS_MAIN(TestUpright)

} // namespace tst_upright

#include "tst_upright.moc"
