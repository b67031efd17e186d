// Edges that the user keeps straight, and islands aligned by themselves: how marks become loops, and that
// Unwrap, Finish and Align obey.
#include "commands/keepstraight.h"
#include "commands/setseamstate.h"
#include "model/document/islands.h"
#include "model/document/makesnapshot.h"
#include "model/document/straightloops.h"
#include "model/io/meshes/meshfile.h"
#include "model/plain/chart.h"
#include "model/plain/uvlayout.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/aligning.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/unmetsteering.h"
#include "solver/unwrap/unwrap.h"
#include "support/editsupport.h"

#include <Eigen/Geometry>
#include <QTest>

#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

namespace tst_keepstraight {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

using Place = std::function<bool(const Vec3 &)>;

//! The edges with both ends at such places.
std::vector<int> edgesAt(const MeshData &mesh, const Place &place)
{
    std::vector<int> edges;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const auto isThere = [&](int end) {
            return place(mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[end][0])));
        };
        if (!pair.diagonal && isThere(0) && isThere(1))
            edges.push_back(static_cast<int>(e));
    }
    return edges;
}

void keepStraight(Document &document, const std::vector<int> &edges)
{
    QVERIFY(pushCommand(
        std::make_unique<KeepStraight>(document, true, cornerPairsOfEdges(document.mesh(), edges))));
}

//! How far the corners at such places are from one line along an axis in each island, as a share of its
//! length.
double bendOf(const MeshData &mesh, const UvMatrix &uv, const Place &place)
{
    const ChartMap charts = findCharts(mesh, uv);
    std::vector<Eigen::AlignedBox2d> boxes(charts.count);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            if (place(mesh.cornerPosition(c)))
                boxes[charts.faceChart[face]].extend(Vec2(uv.row(c).transpose()));
        }
    }
    double bend = 0;
    for (const Eigen::AlignedBox2d &box : boxes) {
        if (!box.isEmpty())
            bend = std::max(bend, box.sizes().minCoeff() / box.sizes().maxCoeff());
    }
    return bend;
}

//! A tube that gets narrower upwards, with a ring of edges at z = 0.5.
test::MeshPtr frustum()
{
    constexpr int sides = 16, rows = 4;
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int row = 0; row <= rows; ++row) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides, radius = 0.5 - 0.1 * row / rows;
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), double(row) / rows);
            const int next = (side + 1) % sides;
            if (row < rows)
                faces.push_back({row * sides + side, row * sides + next, (row + 1) * sides + next,
                                 (row + 1) * sides + side});
        }
    }
    return test::polygonMesh(points, faces);
}

bool isMiddleRow(const Vec3 &p)
{
    return std::abs(p.y() - 0.5) < 1e-9;
}

unwrap::UnwrapOptions draft()
{
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.packing.effort = 0.05;
    return options;
}

void verifyIsValid(const MeshData &mesh, const UvMatrix &uv)
{
    const metrics::UvMetrics figures = metrics::measureUv(mesh, uv);
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, std::int64_t(0));
    QCOMPARE(figures.facesWithoutUv, 0);
}

//! Both parts of splitLayout() turned and bent, in different sizes.
UvMatrix bentParts(const MeshData &mesh)
{
    UvMatrix uv = test::splitLayout(mesh);
    for (Eigen::Index c = 0; c < uv.rows(); ++c) {
        const bool isSecond = uv(c, 0) > 0.8 || (uv(c, 0) > 1.4);
        const double size = isSecond ? 0.5 : 1, u = uv(c, 0), v = uv(c, 1) + 0.1 * u * u;
        uv.row(c) << size * (std::cos(0.3) * u - std::sin(0.3) * v),
            size * (std::sin(0.3) * u + std::cos(0.3) * v);
    }
    return uv;
}

//! All but the first.
std::vector<bool> facesOfOtherIslands(const MeshData &mesh, const UvMatrix &uv)
{
    const ChartMap charts = findCharts(mesh, uv);
    std::vector<bool> faces;
    for (const int chart : charts.faceChart)
        faces.push_back(chart != 0);
    return faces;
}

} // namespace

class TestKeepStraight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void marksBecomeLoops()
    {
        const auto document = test::layoutDocument(test::grid(8, 0.3));
        QVERIFY(straightLoops(*document).empty());
        const std::vector<int> row = edgesAt(document->mesh(), isMiddleRow);
        const std::vector<int> column =
            edgesAt(document->mesh(), [](const Vec3 &p) { return std::abs(p.x() - 0.5) < 1e-9; });
        keepStraight(*document, row);
        keepStraight(*document, column);
        const std::vector<std::vector<int>> loops = straightLoops(*document);
        QCOMPARE(loops.size(), std::size_t(2)); // they cross
        for (const std::vector<int> &loop : loops) {
            QCOMPARE(loop.size(), std::size_t(8));
            for (std::size_t i = 1; i < loop.size(); ++i) {
                const auto &one = document->adjacency().edgeVertices(loop[i - 1]);
                const auto &other = document->adjacency().edgeVertices(loop[i]);
                QVERIFY(one[0] == other[0] || one[0] == other[1] || one[1] == other[0] || one[1] == other[1]);
            }
        }
    }

    void loopsEndAtCorners()
    {
        const auto box = test::layoutDocument(test::quadCube());
        const std::vector<int> side = edgesAt(box->mesh(), [](const Vec3 &p) { return p.z() == 0; });
        QCOMPARE(side.size(), std::size_t(4));
        keepStraight(*box, side);
        QCOMPARE(straightLoops(*box).size(), std::size_t(4));
    }

    void closedLoopsAreOne()
    {
        const auto torus = test::layoutDocument(test::torus(12, 8));
        const MeshData &mesh = torus->mesh();
        double top = 0;
        for (int c = 0; c < mesh.cornerCount(); ++c)
            top = std::max(top, mesh.cornerPosition(c).z());
        const std::vector<int> ring =
            edgesAt(mesh, [=](const Vec3 &p) { return std::abs(p.z() - top) < 1e-9; });
        QCOMPARE(ring.size(), std::size_t(12));
        keepStraight(*torus, ring);
        QCOMPARE(straightLoops(*torus).size(), std::size_t(1));
    }

    void unwrapObeysWithoutAlign()
    {
        const auto document = test::layoutDocument(test::grid(8, 0.15));
        const auto isRow = [](const Vec3 &p) { return std::abs(p.y() - 0.25) < 1e-9; };
        const unwrap::UnwrapResult free = unwrap::unwrapMesh(makeSnapshot(*document), draft());
        QVERIFY(!free.straight);
        QVERIFY(bendOf(document->mesh(), free.uv, isRow) > 1e-3);
        keepStraight(*document, edgesAt(document->mesh(), isRow));
        const unwrap::UnwrapResult made = unwrap::unwrapMesh(makeSnapshot(*document), draft());
        QVERIFY(made.straight && *made.straight && made.withinBound);
        const double bend = bendOf(document->mesh(), made.uv, isRow);
        QVERIFY2(
            bend < 1e-9,
            qPrintable(
                QStringLiteral("%1, islands %2").arg(bend).arg(findCharts(document->mesh(), made.uv).count)));
        verifyIsValid(document->mesh(), made.uv);
    }

    //! A closed loop that a seam opens is one line, wherever its list of edges begins.
    void loopsAcrossSeamsAreOneLine()
    {
        const auto document = test::layoutDocument(frustum());
        const MeshData &mesh = document->mesh();
        const auto isRing = [](const Vec3 &p) { return std::abs(p.z() - 0.5) < 1e-9; };
        Snapshot snapshot = makeSnapshot(*document);
        snapshot.settings.maxDistortion = 4.3;
        unwrap::UnwrapOptions options = draft();
        options.maxDistortion = 4.3;
        QVERIFY(bendOf(mesh, unwrap::unwrapMesh(snapshot, options).uv, isRing) > 0.01);
        keepStraight(*document, edgesAt(mesh, isRing));
        snapshot.steering = makeSnapshot(*document).steering;
        const unwrap::UnwrapResult made = unwrap::unwrapMesh(snapshot, options);
        verifyIsValid(mesh, made.uv);
        const double bend = bendOf(mesh, made.uv, isRing);
        QVERIFY2(bend < 1e-9, qPrintable(QString::number(bend)));
    }

    void finishStraightens()
    {
        const auto document = test::layoutDocument(test::grid(8, 0.15));
        const MeshData &mesh = document->mesh();
        unwrap::FinishInput input;
        const UvMatrix bent = 0.3 * bentParts(mesh);
        input.snapshot = makeSnapshot(*document);
        input.snapshot.uv = std::make_shared<const UvMatrix>(bent);
        input.snapshot.uvScale = layoutScale(mesh, bent);
        input.packing.effort = 0.05;
        const unwrap::FinishResult plain = unwrap::finishMap(input);
        QVERIFY(!plain.straight);
        QVERIFY(metrics::measureUv(mesh, plain.uv).axisAlignedShare < 0.9);
        input.snapshot.settings.align = CreaseMode::On;
        const unwrap::FinishResult made = unwrap::finishMap(input);
        QVERIFY(made.straight && *made.straight);
        QVERIFY(metrics::measureUv(mesh, made.uv).axisAlignedShare > 1 - 1e-9);
        verifyIsValid(mesh, made.uv);
    }

    void aStoppedUnwrapSaysWhetherItIsStraight()
    {
        Snapshot snapshot;
        snapshot.mesh = test::quadCube();
        snapshot.settings.align = CreaseMode::On;
        std::atomic<bool> stop = false;
        const JobContext job(&stop, 1, [&](const JobProgress &done) { stop = stop || done.distortion > 0; });
        const unwrap::UnwrapResult made = unwrap::unwrapMesh(snapshot, draft(), job);
        QVERIFY(made.stopped);
        verifyIsValid(*snapshot.mesh, made.uv);
        QVERIFY(made.straight || made.onlyPatches);
        if (made.straight && *made.straight)
            QVERIFY(metrics::measureUv(*snapshot.mesh, made.uv).axisAlignedShare > 1 - 1e-9);
    }

    void chosenIslandsAreAligned()
    {
        const auto document = test::layoutDocument(test::grid(8));
        const MeshData &mesh = document->mesh();
        const UvMatrix bent = 0.3 * bentParts(mesh);
        unwrap::AlignInput input;
        input.snapshot = makeSnapshot(*document);
        input.snapshot.uv = std::make_shared<const UvMatrix>(bent);
        input.snapshot.uvScale = layoutScale(mesh, bent);
        const auto scope = std::make_shared<JobScope>();
        scope->faces.resize(mesh.faceCount());
        std::set<int> moved;
        for (int face = 0; face < mesh.faceCount(); ++face) {
            const int first = mesh.faceStart[face];
            const Vec3 centre = 0.5 * (mesh.cornerPosition(first) + mesh.cornerPosition(first + 2));
            scope->faces[face] = centre.x() < 0.5;
            for (int c = first; c < mesh.faceStart[face + 1] && scope->faces[face]; ++c)
                moved.insert(c);
        }
        input.snapshot.scope = scope;
        const unwrap::AlignResult made = unwrap::alignIslands(input);
        QCOMPARE(made.uv.rows(), bent.rows());
        QVERIFY(made.after < made.before);
        Vec2 before = Vec2::Zero(), after = Vec2::Zero();
        for (int c = 0; c < mesh.cornerCount(); ++c) {
            if (moved.count(c) == 0) {
                QVERIFY(made.uv.row(c) == bent.row(c));
                continue;
            }
            before += bent.row(c).transpose();
            after += made.uv.row(c).transpose();
        }
        QVERIFY((after - before).norm() / double(moved.size()) < 0.05);
        QVERIFY(bendOf(mesh, made.uv, [](const Vec3 &p) { return p.x() == 0; }) < 1e-9);
        QVERIFY(bendOf(mesh, made.uv, [](const Vec3 &p) { return p.y() == 1 && p.x() < 0.4; }) < 1e-9);
        verifyIsValid(mesh, made.uv);
    }

    void alignedIslandsOfAFullTile_data()
    {
        QTest::addColumn<bool>("whole");
        QTest::newRow("some") << false;
        QTest::newRow("all") << true;
    }
    //! The islands of a tile get smaller when there is no room for some, and that is said.
    void alignedIslandsOfAFullTile()
    {
        QFETCH(bool, whole);
        const auto document = test::layoutDocument(test::grid(8));
        const MeshData &mesh = document->mesh();
        UvMatrix full = bentParts(mesh);
        unwrap::AlignInput input;
        input.snapshot = makeSnapshot(*document);
        input.packing.margin = 1;
        QVERIFY(unwrap::packCharts(mesh, findCharts(mesh, full),
                                   unwrap::steeredPackJob(input.snapshot, input.packing), full));
        input.snapshot.uv = std::make_shared<const UvMatrix>(full);
        input.snapshot.uvScale = layoutScale(mesh, full);
        const auto scope = std::make_shared<JobScope>();
        scope->faces.assign(mesh.faceCount(), true);
        if (!whole)
            scope->faces = facesOfOtherIslands(mesh, full);
        input.snapshot.scope = scope;
        const unwrap::AlignResult made = unwrap::alignIslands(input);
        QCOMPARE(made.uv.rows(), full.rows());
        QVERIFY(!made.noRoom);
        const auto areas = [&mesh](const UvMatrix &uv) {
            const ChartMap charts = findCharts(mesh, uv);
            std::vector<double> area(charts.count, 0);
            for (int t = 0; t < mesh.triangleCount(); ++t) {
                const auto &[a, b, c] = mesh.triangles[t];
                const Vec2 ab = (uv.row(b) - uv.row(a)).transpose(), ac = (uv.row(c) - uv.row(a)).transpose();
                area[charts.faceChart[mesh.triangleFace[t]]] += ab.x() * ac.y() - ab.y() * ac.x();
            }
            return area;
        };
        const std::vector<double> before = areas(full), after = areas(made.uv);
        const Islands islands(mesh, made.uv);
        std::vector<double> longSides;
        for (int island = 0; island < islands.count(); ++island)
            longSides.push_back(islands.box(island).sizes().maxCoeff());
        QCOMPARE(after.size(), before.size());
        verifyIsValid(mesh, made.uv);
        for (std::size_t i = 0; i < before.size(); ++i) {
            // Each island has a tile of its own. One that does not fit as it was fills it.
            const double factor = after[i] / before[i];
            const bool same = std::abs(factor - 1) < 1e-5;
            QVERIFY2(same || (made.madeSmaller && factor < 1 && longSides[i] > 0.995),
                     qPrintable(u"%1, %2"_s.arg(factor).arg(longSides[i])));
        }
    }

    void bentLinesAreSaid()
    {
        const auto document = test::layoutDocument(test::grid(8, 0.3));
        const MeshData &mesh = document->mesh();
        keepStraight(*document, edgesAt(mesh, isMiddleRow));
        const Snapshot snapshot = makeSnapshot(*document);
        UvMatrix uv(mesh.cornerCount(), 2);
        for (int c = 0; c < mesh.cornerCount(); ++c)
            uv.row(c) = mesh.cornerPosition(c).head<2>().transpose();
        QVERIFY(unwrap::bentEdges(snapshot, uv).empty());
        QVERIFY(unwrap::unmetSteering(snapshot, uv).empty());
        UvMatrix bent = uv;
        for (int c = 0; c < mesh.cornerCount(); ++c)
            bent(c, 1) += uv(c, 0) > 0.8 ? 0.02 : 0; // one end
        QCOMPARE(unwrap::bentEdges(snapshot, bent).size(), std::size_t(8));
        QVERIFY(!unwrap::unmetSteering(snapshot, bent).empty());
        // Cut in the middle, each half is straight by itself.
        UvMatrix halves = uv;
        for (int face = 0; face < mesh.faceCount(); ++face) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
                if (mesh.cornerPosition(mesh.faceStart[face]).x() > 0.49)
                    halves.row(c) << 2 + uv(c, 0), uv(c, 1) + 0.3 * uv(c, 0);
            }
        }
        QVERIFY(unwrap::bentEdges(snapshot, halves).empty());
    }

    //! Eight edges over a skull are straight after an unwrap, not only when it is finished.
    void aLineOverASkull()
    {
        if (test::meshFolder().empty())
            QSKIP(test::noMeshes);
        const QString path =
            QString::fromStdString(test::meshFolder()) + QStringLiteral("/polygons/suzanne.obj");
        Document document(readMesh(path).value());
        const MeshData &mesh = document.mesh();
        const double middle = 0.5 * (mesh.positions.col(0).minCoeff() + mesh.positions.col(0).maxCoeff());
        std::vector<std::pair<double, int>> ridge; // by the lower end
        for (const int edge : edgesAt(mesh, [&](const Vec3 &p) { return std::abs(p.x() - middle) < 1e-2; })) {
            const EdgePair &pair = mesh.edgePairs[edge];
            const auto at = [&](int end) {
                return mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[end][0]));
            };
            ridge.emplace_back(-std::min(at(0).y(), at(1).y()), edge);
        }
        std::sort(ridge.begin(), ridge.end());
        QVERIFY(ridge.size() >= 8);
        std::vector<int> edges;
        for (int i = 0; i < 8; ++i)
            edges.push_back(ridge[std::size_t(i)].second);
        keepStraight(document, edges);
        const Snapshot snapshot = makeSnapshot(document);
        QCOMPARE(snapshot.steering->straightLoops.size(), std::size_t(1));
        const unwrap::UnwrapResult made = unwrap::unwrapMesh(snapshot, draft());
        verifyIsValid(mesh, made.uv);
        QVERIFY(made.withinBound);
        QVERIFY2(
            made.unmet.bent.empty(),
            qPrintable(QStringLiteral("%1 bent, D %2").arg(made.unmet.bent.size()).arg(made.distortion)));
    }

    void pinnedIslandsAreNotAligned()
    {
        const auto document = test::layoutDocument(test::grid(4));
        unwrap::AlignInput input;
        input.snapshot = makeSnapshot(*document);
        for (int c : {0, document->mesh().cornerCount() - 1}) {
            for (int s = 0; s < document->mesh().soupCornerCount(); ++s) {
                if (document->mesh().cornerOfSoup(s) == c)
                    input.snapshot.editSteering().pins.push_back({s, Vec2(0, 0), false, 1});
            }
        }
        QVERIFY(unwrap::alignIslands(input).nothingFree);
    }
};

QTEST_APPLESS_MAIN(TestKeepStraight)

} // namespace tst_keepstraight

#include "tst_keepstraight.moc"
