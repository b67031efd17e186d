// Straight where the model is straight: what becomes a line, what stays round, mirrored maps, what is up, and
// that nothing else is touched.
#include "model/plain/uvlayout.h"
#include "solver/base/cornerat.h"
#include "solver/definite/relaxing.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/straight/islandmirror.h"
#include "solver/straight/linenewton.h"
#include "solver/straight/straightening.h"
#include "solver/straight/turning.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>

namespace tst_straight {

using namespace autocuts;
using namespace autocuts::straight;

namespace {

constexpr double pi = std::numbers::pi;

//! A mesh of quads over a rectangle of cells; `place` puts the nodes into space.
test::MeshPtr sheet(
    int columns, int rows, const std::function<Vec3(double, double)> &place,
    const std::function<bool(int, int)> &has = [](int, int) { return true; })
{
    std::vector<Vec3> points;
    for (int y = 0; y <= rows; ++y) {
        for (int x = 0; x <= columns; ++x)
            points.push_back(place(x, y));
    }
    std::vector<std::vector<int>> faces;
    const auto node = [&](int x, int y) { return y * (columns + 1) + x; };
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            if (has(x, y))
                faces.push_back({node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)});
        }
    }
    return test::polygonMesh(points, faces);
}

//! A map of a mesh, and what a job needs besides.
struct Mapped
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;
    SeamedMap map;

    //! \param uv the place of a vertex in the map, in the units of the mesh
    Mapped(const test::MeshPtr &mesh, const std::function<Vec2(const Vec3 &)> &uv)
    {
        snapshot.mesh = mesh;
        snapshot.settings.align = CreaseMode::On;
        soup = Soup::build(mesh);
        UvMatrix rows(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            rows.row(c) = soup->scale * uv(mesh->cornerPosition(c)).transpose();
        map = *seamedMapOf(*soup, rows, CutFlags(mesh->edgePairs.size(), false));
    }

    void straighten(double bound = 4.1, const JobContext &job = {})
    {
        straight::straighten(soup, snapshot, StraightPlan::of(snapshot), bound, map, job);
    }
    UvMatrix uv() const { return cornerUv(*soup, map); }
    double alignedShare() const { return metrics::measureUv(*snapshot.mesh, uv()).axisAlignedShare; }
    bool isValid() const { return map.validate(*soup).empty() && !definite::coversItself(*soup, map); }
    //! Of all corners at places that fit.
    double range(int axis, const std::function<bool(const Vec3 &)> &fits) const
    {
        double least = 1e300, most = -1e300;
        for (int c = 0; c < snapshot.mesh->soupCornerCount(); ++c) {
            if (!fits(snapshot.mesh->cornerPosition(snapshot.mesh->cornerOfSoup(c))))
                continue;
            least = std::min(least, map.x[2 * c + axis]);
            most = std::max(most, map.x[2 * c + axis]);
        }
        return most - least;
    }
};

Vec2 turned(double degrees, double x, double y)
{
    const double a = degrees * pi / 180;
    return {std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y};
}

Vec3 flat(double x, double y)
{
    return {x, y, 0};
}

//! A flat strip whose map is bent.
Mapped bentStrip(double bend)
{
    return {sheet(12, 4, flat), [=](const Vec3 &p) {
                const double angle = bend * p.x() / 12, radius = 12 / bend - (p.y() - 2);
                return Vec2(radius * std::sin(angle), -radius * std::cos(angle));
            }};
}

test::MeshPtr disc(int sides, int rings)
{
    std::vector<Vec3> points{{0, 0, 0}};
    std::vector<std::vector<int>> faces;
    for (int r = 1; r <= rings; ++r) {
        for (int s = 0; s < sides; ++s)
            points.push_back({r * std::cos(2 * pi * s / sides), r * std::sin(2 * pi * s / sides), 0});
    }
    const auto node = [&](int r, int s) { return 1 + (r - 1) * sides + s % sides; };
    for (int s = 0; s < sides; ++s) {
        faces.push_back({0, node(1, s), node(1, s + 1)});
        for (int r = 1; r < rings; ++r)
            faces.push_back({node(r, s), node(r + 1, s), node(r + 1, s + 1), node(r, s + 1)});
    }
    return test::polygonMesh(points, faces);
}

//! A tube whose first and last columns are apart, as after a cut; a little bent along its axis.
test::MeshPtr openTube(int sides, int rows, double bend)
{
    return sheet(sides, rows, [=](double x, double y) {
        const double a = 2 * pi * x / sides * 0.999, radius = 1.5;
        const double angle = bend * y / rows, length = 0.4 * y;
        if (bend == 0)
            return Vec3(radius * std::cos(a), length, -radius * std::sin(a));
        const double arc = 0.4 * rows / bend, out = arc + radius * std::cos(a);
        return Vec3(out * std::cos(angle), out * std::sin(angle), -radius * std::sin(a));
    });
}

unwrap::UnwrapOptions draft()
{
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.packing.effort = 0.05;
    return options;
}

unwrap::UnwrapResult unwrapped(const Snapshot &snapshot, const JobContext &job = {})
{
    return unwrap::unwrapMesh(snapshot, draft(), job);
}

} // namespace

class TestStraight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesHoldAndTheRestIsAMinimum();
    void symmetryHoldsExactly();
    void whatIsStraightOnTheModelBecomesStraight_data();
    void whatIsStraightOnTheModelBecomesStraight();
    void discsStayRound_data();
    void discsStayRound();
    void theBoundIsKept();
    void pinnedIslandsStay();
    void aStoppedJobChangesNothing();
    void chosenLoopsBecomeLines();
    void symmetricIslandsGetSymmetricMaps();
    void pairsGetMirroredMaps();
    void upIsUp_data();
    void upIsUp();
    void samplesAreValidAndTheSameOnAnyThreads_data();
    void samplesAreValidAndTheSameOnAnyThreads();
    void offAndAutoOnRoundSurfacesChangeNothing();
    void lockedIslandsKeepTheirBits();
    void aLiveMapAtRestIsStraight();
};

void TestStraight::linesHoldAndTheRestIsAMinimum()
{
    const Mapped strip = bentStrip(0.6);
    const CutMesh charts(*strip.snapshot.mesh, strip.map.cut);
    const Island island = islandsOf(*strip.soup, charts, strip.map.x).front();
    std::vector<Line> lines;
    for (const Chain &chain : straightChains(island)) {
        const Vec2 along =
            (island.position[chain.points.back()] - island.position[chain.points.front()]).normalized();
        // One line that runs along no axis.
        lines.push_back({chain.points, std::abs(along.y()) < 0.5 ? Vec2(Vec2::UnitY()) : turned(20, 1, 0)});
    }
    QCOMPARE(lines.size(), std::size_t(4));
    Positions at = island.position;
    LineNewton newton(island, lines);
    const std::optional<double> energy = newton.minimize(at, 50);
    QVERIFY(energy && std::abs(*energy - island.energy(at)) < 1e-12);
    std::vector<std::vector<Vec2>> normals(island.pointCount());
    for (const Line &line : lines) {
        for (const int p : line.points) {
            QVERIFY(std::abs(line.normal.dot(at[p] - at[line.points.front()])) < 1e-12);
            normals[p].push_back(line.normal);
        }
        if (line.normal == Vec2(Vec2::UnitY())) {
            for (const int p : line.points)
                QVERIFY(at[p].y() == at[line.points.front()].y());
        }
    }
    // By finite differences: no point that is free to move along a direction gains by it.
    const double step = 1e-5;
    const auto slope = [&](const std::vector<int> &points, const Vec2 &direction) {
        Positions there = at, back = at;
        for (const int p : points) {
            there[p] += step * direction;
            back[p] -= step * direction;
        }
        return (island.energy(there) - island.energy(back)) / (2 * step);
    };
    for (int p = 0; p < island.pointCount(); ++p) {
        if (normals[p].size() == 1)
            QVERIFY(std::abs(slope({p}, {normals[p][0].y(), -normals[p][0].x()})) < 1e-4);
        else if (normals[p].empty())
            QVERIFY(std::abs(slope({p}, Vec2::UnitX())) < 1e-4 && std::abs(slope({p}, Vec2::UnitY())) < 1e-4);
    }
    // The costs of the lines are about what the map with them has more than the one without.
    Positions free = island.position;
    const double least = *LineNewton(island, {}).minimize(free, 50);
    double sum = 0;
    for (const double cost : newton.costs(at, free))
        sum += cost;
    QVERIFY(*energy > least && sum > 0.5 * (*energy - least) && sum < 2 * (*energy - least));
}

void TestStraight::symmetryHoldsExactly()
{
    const Mapped strip = bentStrip(0.3);
    const CutMesh charts(*strip.snapshot.mesh, strip.map.cut);
    Island island = islandsOf(*strip.soup, charts, strip.map.x).front();
    for (Vec2 &p : island.position)
        p = turned(33, p.x(), p.y());
    const std::vector<IslandMirror> mirrors = mirrorsOf(*strip.snapshot.mesh, {island});
    QCOMPARE(mirrors[0].island, 0);
    const MirrorPoints &image = mirrors[0].points;
    placeAtAxis(island.position, image);
    QVERIFY(LineNewton(island, {}, image).minimize(island.position, 20));
    for (int p = 0; p < island.pointCount(); ++p)
        QVERIFY(island.position[p].x() == -island.position[image[p]].x() &&
                island.position[p].y() == island.position[image[p]].y());
}

void TestStraight::whatIsStraightOnTheModelBecomesStraight_data()
{
    QTest::addColumn<QString>("shape");
    for (const char *shape : {"square", "bent strip", "L", "tube"})
        QTest::newRow(shape) << QString::fromLatin1(shape);
}

void TestStraight::whatIsStraightOnTheModelBecomesStraight()
{
    QFETCH(QString, shape);
    const auto made = [&]() -> Mapped {
        if (shape == QLatin1String("square"))
            return {test::grid(5), [](const Vec3 &p) { return turned(27, p.x(), p.y()); }};
        if (shape == QLatin1String("bent strip"))
            return bentStrip(0.5);
        if (shape == QLatin1String("L"))
            return {sheet(6, 6, flat, [](int x, int y) { return x < 2 || y < 2; }),
                    [](const Vec3 &p) { return turned(40, p.x() + 0.02 * p.y() * p.y(), p.y()); }};
        // Unrolled, and bent as a sheet.
        return {openTube(16, 10, 0), [](const Vec3 &p) {
                    const double angle = std::atan2(-p.z(), p.x());
                    const double along = 1.5 * (angle < -1e-9 ? angle + 2 * pi : std::max(angle, 0.0));
                    return turned(10, along, p.y() + 0.01 * along * along);
                }};
    };
    Mapped mapped = made();
    QVERIFY(mapped.isValid());
    QVERIFY(mapped.alignedShare() < 0.5);
    mapped.straighten();
    QVERIFY(mapped.isValid());
    QCOMPARE(mapped.alignedShare(), 1.0);
    QVERIFY(mapped.map.distortion(*mapped.soup) < 4.001);
}

void TestStraight::discsStayRound_data()
{
    QTest::addColumn<int>("sides");
    for (const int sides : {13, 16, 24, 60})
        QTest::addRow("%d", sides) << sides;
}

void TestStraight::discsStayRound()
{
    QFETCH(int, sides);
    Mapped mapped(disc(sides, 3), [](const Vec3 &p) { return turned(17, p.x(), p.y()); });
    mapped.straighten();
    QVERIFY(mapped.isValid());
    QVERIFY(mapped.map.distortion(*mapped.soup) < 4.002);
    QVERIFY(mapped.alignedShare() < 0.45);
}

void TestStraight::theBoundIsKept()
{
    for (const double bend : {0.5, 2.0, 4.0}) {
        const test::MeshPtr tube = openTube(16, 12, bend);
        Snapshot snapshot;
        snapshot.mesh = tube;
        snapshot.settings.align = CreaseMode::On;
        const unwrap::UnwrapResult result = unwrapped(snapshot);
        const metrics::UvMetrics figures = metrics::measureUv(*tube, result.uv);
        QVERIFY(result.withinBound && result.packed);
        QVERIFY(figures.symDirichlet <= 4.1 + 1e-9);
        QCOMPARE(figures.flipped, 0);
        QCOMPARE(figures.overlapPairs, std::int64_t(0));
    }
}

void TestStraight::pinnedIslandsStay()
{
    Mapped mapped = bentStrip(0.5);
    mapped.snapshot.editSteering().pins.push_back({3, cornerAt(mapped.map.x, 3), true, 1});
    const std::vector<double> before = mapped.map.x;
    mapped.straighten();
    QVERIFY(mapped.map.x == before);
}

void TestStraight::aStoppedJobChangesNothing()
{
    Mapped mapped = bentStrip(0.5);
    const std::vector<double> before = mapped.map.x;
    const std::atomic<bool> stop{true};
    mapped.straighten(4.1, &stop);
    QVERIFY(mapped.map.x == before);
}

void TestStraight::chosenLoopsBecomeLines()
{
    // The map is wavy, and so is the model: nothing but the chosen loop becomes straight.
    Mapped mapped(sheet(12, 6, [](double x, double y) { return Vec3(x, y + 0.3 * std::sin(x), 0); }),
                  [](const Vec3 &p) { return Vec2(p.x(), p.y()); });
    mapped.snapshot.settings.align = CreaseMode::Off;
    const auto isChosen = [](const Vec3 &p) { return std::abs(p.y() - 0.3 * std::sin(p.x()) - 3) < 1e-9; };
    std::vector<std::pair<double, int>> loop;
    const MeshData &mesh = *mapped.snapshot.mesh;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const Vec3 a = mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[0][0]));
        const Vec3 b = mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[1][0]));
        if (!pair.diagonal && isChosen(a) && isChosen(b))
            loop.emplace_back(a.x() + b.x(), static_cast<int>(e));
    }
    std::sort(loop.begin(), loop.end());
    QCOMPARE(loop.size(), std::size_t(12));
    mapped.snapshot.editSteering().straightLoops.emplace_back();
    for (const auto &[place, edge] : loop)
        mapped.snapshot.editSteering().straightLoops.back().push_back(edge);
    QVERIFY(mapped.range(1, isChosen) > 0.1);
    mapped.straighten(4.3);
    QVERIFY(mapped.isValid());
    QVERIFY(mapped.range(1, isChosen) < 1e-12);
    QVERIFY(mapped.range(1, [](const Vec3 &p) { return p.y() - 0.3 * std::sin(p.x()) < 1e-9; }) > 0.01);
}

void TestStraight::symmetricIslandsGetSymmetricMaps()
{
    // Symmetric about x = 3; its map is not.
    Mapped mapped(sheet(
                      6, 5, [](double x, double y) { return Vec3(x, y, 0.1 * (x - 3) * (x - 3)); },
                      [](int x, int y) { return y < 3 || (x > 1 && x < 4); }),
                  [](const Vec3 &p) { return turned(25, p.x() + 0.02 * p.x() * p.y(), p.y()); });
    mapped.snapshot.settings.align = CreaseMode::Off;
    mapped.snapshot.settings.mirrorMaps = true;
    mapped.straighten();
    QVERIFY(mapped.isValid());
    const double width = mapped.range(0, [](const Vec3 &p) { return std::abs(p.x() - 3) < 1e-9; });
    QVERIFY(width < 1e-12);
    QVERIFY(mapped.range(1, [](const Vec3 &p) { return p.y() == 0 && (p.x() == 0 || p.x() == 6); }) < 1e-12);
}

void TestStraight::pairsGetMirroredMaps()
{
    const auto bump = [](double x, double y) { return 0.03 * x * x + 0.05 * y; };
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (const double side : {-1.0, 1.0}) {
        const int first = static_cast<int>(points.size());
        for (int y = 0; y <= 3; ++y) {
            for (int x = 0; x <= 4; ++x)
                points.emplace_back(side * (1 + x + 0.2 * y), y, bump(x, y));
        }
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 4; ++x) {
                std::vector<int> face{first + 5 * y + x, first + 5 * y + x + 1, first + 5 * y + x + 6,
                                      first + 5 * y + x + 5};
                if (side < 0)
                    std::reverse(face.begin(), face.end());
                faces.push_back(face);
            }
        }
    }
    Mapped mapped(test::polygonMesh(points, faces), [](const Vec3 &p) {
        return p.x() > 0 ? Vec2(p.x(), p.y()) : Vec2(turned(30, p.x() + 0.1 * p.y(), p.y()));
    });
    mapped.snapshot.settings.align = CreaseMode::Off;
    mapped.snapshot.settings.mirrorMaps = true;
    mapped.straighten();
    QVERIFY(mapped.isValid());
    const MeshData &mesh = *mapped.snapshot.mesh;
    const UvMatrix uv = mapped.uv();
    const auto at = [&](int vertex) {
        const auto corner = std::find(mesh.cornerVertex.begin(), mesh.cornerVertex.end(), vertex);
        return Vec2(uv.row(corner - mesh.cornerVertex.begin()).transpose());
    };
    const int count = static_cast<int>(points.size()) / 2;
    for (int v = 1; v < count; ++v) {
        const Vec2 one = at(v) - at(0), other = at(v + count) - at(count);
        QVERIFY((one - Vec2(-other.x(), other.y())).norm() < 1e-12);
    }
}

void TestStraight::upIsUp_data()
{
    QTest::addColumn<WorldUp>("up");
    QTest::addColumn<CreaseMode>("align");
    for (const CreaseMode align : {CreaseMode::Off, CreaseMode::On}) {
        QTest::addRow("y, align %d", static_cast<int>(align)) << WorldUp::Y << align;
        QTest::addRow("z, align %d", static_cast<int>(align)) << WorldUp::Z << align;
    }
}

void TestStraight::upIsUp()
{
    QFETCH(WorldUp, up);
    QFETCH(CreaseMode, align);
    // Every side of the cube is an island.
    Snapshot snapshot;
    snapshot.mesh = test::quadCube();
    snapshot.settings.align = align;
    snapshot.settings.worldUp = up;
    snapshot.settings.seams = SeamMode::Only;
    snapshot.editSteering().givenSeams.assign(snapshot.mesh->edgePairs.size(), true);
    const unwrap::UnwrapResult result = unwrapped(snapshot);
    const int axis = up == WorldUp::Y ? 1 : 2;
    const MeshData &mesh = *snapshot.mesh;
    int upright = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face] + 4; ++c) {
            const int next = c + 1 < mesh.faceStart[face] + 4 ? c + 1 : mesh.faceStart[face];
            const double rise = mesh.cornerPosition(next)[axis] - mesh.cornerPosition(c)[axis];
            const Vec2 along = (result.uv.row(next) - result.uv.row(c)).transpose();
            QVERIFY(along.cwiseAbs().minCoeff() < 1e-9);
            if (rise != 0) {
                QVERIFY(rise * along.y() > 0.01);
                ++upright;
            }
        }
    }
    QCOMPARE(upright, 8);
}

void TestStraight::samplesAreValidAndTheSameOnAnyThreads_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"machine", "bumpycube", "torus", "quad cube", "dirty"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestStraight::samplesAreValidAndTheSameOnAnyThreads()
{
    QFETCH(QString, name);
    Snapshot snapshot;
    snapshot.mesh = test::meshNamed(name);
    snapshot.settings.align = CreaseMode::On;
    snapshot.settings.mirrorMaps = true;
    const unwrap::UnwrapResult one = unwrapped(snapshot), two = unwrapped(snapshot, JobContext(nullptr, 2));
    QVERIFY(sameBits(one.uv, two.uv));
    const metrics::UvMetrics figures = metrics::measureUv(*snapshot.mesh, one.uv);
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, std::int64_t(0));
    if (name == QLatin1String("quad cube"))
        QCOMPARE(figures.axisAlignedShare, 1.0);
    if (name == QLatin1String("machine"))
        QVERIFY(figures.axisAlignedShare > 0.55 && one.distortion <= 4.1);
}

void TestStraight::offAndAutoOnRoundSurfacesChangeNothing()
{
    Snapshot snapshot;
    snapshot.mesh = test::sphere(8, 10);
    const unwrap::UnwrapResult off = unwrapped(snapshot);
    snapshot.settings.align = CreaseMode::Auto;
    QVERIFY(sameBits(unwrapped(snapshot).uv, off.uv));
}

void TestStraight::lockedIslandsKeepTheirBits()
{
    Snapshot snapshot;
    snapshot.mesh = test::quadCube();
    snapshot.settings.seams = SeamMode::Only;
    snapshot.editSteering().givenSeams.assign(snapshot.mesh->edgePairs.size(), true);
    UvMatrix uv = unwrapped(snapshot).uv;
    uv *= Eigen::Rotation2Dd(0.3).toRotationMatrix();
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
    snapshot.editSteering().faceFlags.resize(snapshot.mesh->faceCount());
    snapshot.editSteering().faceFlags[0].locked = 1;
    snapshot.settings.align = CreaseMode::On;
    const unwrap::UnwrapResult result = unwrapped(snapshot);
    for (int c = 0; c < 4; ++c)
        QVERIFY(result.uv.row(c) == uv.row(c));
    const Vec2 other = (result.uv.row(5) - result.uv.row(4)).cwiseAbs().transpose();
    QVERIFY(other.minCoeff() < 1e-9);
}

void TestStraight::aLiveMapAtRestIsStraight()
{
    const auto snapshot = std::make_shared<Snapshot>();
    snapshot->mesh = test::quadCube();
    snapshot->settings.align = CreaseMode::On;
    std::shared_ptr<const unwrap::LiveMapResult> last;
    unwrap::LiveMap live([&](std::shared_ptr<const unwrap::LiveMapResult> map) { last = std::move(map); });
    live.begin(snapshot, {});
    QVERIFY(live.work({}) && last && last->withinBound);
    const metrics::UvMetrics figures = metrics::measureUv(*snapshot->mesh, last->uv);
    QVERIFY(figures.axisAlignedShare > 1 - 1e-9);
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, std::int64_t(0));
}

QTEST_APPLESS_MAIN(TestStraight)

} // namespace tst_straight

#include "tst_straight.moc"
