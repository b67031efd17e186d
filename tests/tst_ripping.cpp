// Ripping maps along edges: parts move aside, slits open, nothing is covered or flipped.
#include "model/plain/chart.h"
#include "model/plain/uvseams.h"
#include "solver/definite/ripping.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/packing/movingaside.h"
#include "support/mapedits.h"

#include <QTest>

namespace tst_ripping {

using namespace autocuts;
using namespace autocuts::definite;
using test::edgesWhere;
using test::flatMap;
using test::snapshotOf;

namespace {

constexpr int size = 8;
constexpr double gutter = 0.01;

//! Edges of the grid on the line x = column / size, in the rows [first, end).
std::vector<int> columnEdges(const MeshData &mesh, int column, int first, int end)
{
    return edgesWhere(mesh, [=](const Vec3 &p, const Vec3 &q) {
        const double x = double(column) / size, y = 0.5 * (p.y() + q.y()) * size;
        return std::abs(p.x() - x) < 1e-9 && std::abs(q.x() - x) < 1e-9 && y > first && y < end;
    });
}

//! The outline of the faces in the columns and rows [first, end).
std::vector<int> outlineOf(const MeshData &mesh, int first, int end)
{
    const double low = double(first) / size, high = double(end) / size;
    return edgesWhere(mesh, [=](const Vec3 &p, const Vec3 &q) {
        const Vec3 middle = 0.5 * (p + q);
        const auto on = [](double a, double b) { return std::abs(a - b) < 1e-9; };
        const auto between = [=](double a) { return a > low && a < high; };
        return ((on(middle.x(), low) || on(middle.x(), high)) && p.x() == q.x() && between(middle.y())) ||
               ((on(middle.y(), low) || on(middle.y(), high)) && p.y() == q.y() && between(middle.x()));
    });
}

} // namespace

class TestRipping : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCutThroughSplits_data()
    {
        QTest::addColumn<bool>("mirrored");
        QTest::addColumn<int>("column");
        QTest::newRow("right part") << false << 5;
        QTest::newRow("left part") << false << 2;
        QTest::newRow("mirrored") << true << 5;
    }

    void aCutThroughSplits()
    {
        QFETCH(bool, mirrored);
        QFETCH(int, column);
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        if (mirrored)
            uv.col(0) = 1 - uv.col(0).array();
        const std::vector<int> edges = columnEdges(*mesh, column, 0, size);
        const RippedMap made = ripEdges(snapshotOf(mesh, uv), edges, gutter);
        QCOMPARE(made.edges, edges);
        QCOMPARE(made.newIslands, 1);
        QCOMPARE(made.closed, 0);
        QCOMPARE(findCharts(*mesh, made.uv).count, 2);
        const bool rightMoves = column > size / 2;
        const Eigen::RowVector2d way((rightMoves ? gutter : -gutter) * (mirrored ? -1 : 1), 0);
        for (int f = 0; f < mesh->faceCount(); ++f) {
            const bool moves = (f % size >= column) == rightMoves;
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c)
                QVERIFY((made.uv.row(c) - uv.row(c) - (moves ? way : 0 * way)).norm() <
                        (moves ? 1e-12 : 1e-300));
        }
        QCOMPARE(test::flippedIn(*mesh, uv, made.uv), 0);
        QVERIFY(overlap::findOverlaps(soupUv(*mesh, made.uv)).pairs.empty());
    }

    void aSlitOpens()
    {
        const auto mesh = test::grid(size);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const std::vector<int> edges = columnEdges(*mesh, 4, 2, 6);
        const RippedMap made = ripEdges(snapshotOf(mesh, uv), edges, gutter);
        QCOMPARE(made.edges.size(), std::size_t(4));
        QCOMPARE(made.newIslands, 0);
        QCOMPARE(made.closed, 0);
        QCOMPARE(findCharts(*mesh, made.uv).count, 1);
        const std::vector<bool> open = openCornerPairs(*mesh, made.uv);
        for (int e = 0; e < static_cast<int>(mesh->edgePairs.size()); ++e)
            QCOMPARE(open[2 * e] || open[2 * e + 1], std::find(edges.begin(), edges.end(), e) != edges.end());
        // The three vertices between the ends of the slit, which have two corners on each side.
        int moved = 0;
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            const double way = (made.uv.row(c) - uv.row(c)).norm();
            moved += way > 0;
            QVERIFY(way < 0.01 * 0.5 / size);
        }
        QCOMPARE(moved, 3 * 4);
        QCOMPARE(test::flippedIn(*mesh, uv, made.uv), 0);
        QVERIFY(overlap::findOverlaps(soupUv(*mesh, made.uv)).pairs.empty());
    }

    void oneEdgeInsideStaysClosed()
    {
        const auto mesh = test::grid(size);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const RippedMap made = ripEdges(snapshotOf(mesh, uv), columnEdges(*mesh, 4, 3, 4), gutter);
        QCOMPARE(made.edges.size(), std::size_t(1));
        QCOMPARE(made.closed, 1);
        QVERIFY(made.uv == uv);
    }

    void aSlitFromTheBorder()
    {
        const auto mesh = test::grid(size);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const RippedMap made = ripEdges(snapshotOf(mesh, uv), columnEdges(*mesh, 4, 0, 1), gutter);
        QCOMPARE(made.closed, 0);
        QCOMPARE(findCharts(*mesh, made.uv).count, 1);
        QCOMPARE(test::flippedIn(*mesh, uv, made.uv), 0);
    }

    //! There is no room around it: it stays where it is, with a gap on all sides.
    void aPartInTheMiddle()
    {
        const auto mesh = test::grid(size);
        const UvMatrix uv = flatMap(*mesh, 0.9, {0.05, 0.05});
        const RippedMap made = ripEdges(snapshotOf(mesh, uv), outlineOf(*mesh, 2, 6), gutter);
        QCOMPARE(made.edges.size(), std::size_t(16));
        QCOMPARE(made.newIslands, 1);
        QCOMPARE(made.closed, 0);
        QVERIFY((made.uv - uv).cwiseAbs().maxCoeff() < 0.01 * 0.9 / size);
        QCOMPARE(test::flippedIn(*mesh, uv, made.uv), 0);
        QVERIFY(overlap::findOverlaps(soupUv(*mesh, made.uv)).pairs.empty());
    }

    void neighboursAreNotCovered()
    {
        // Two islands of 4 x 8 faces with a narrow gap between them; the left one is cut along its middle.
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.25, 0.25});
        for (int f = 0; f < mesh->faceCount(); ++f) {
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1] && f % size >= 4; ++c)
                uv(c, 0) += 0.5 * gutter;
        }
        const RippedMap made = ripEdges(snapshotOf(mesh, uv), columnEdges(*mesh, 2, 0, size), gutter);
        QCOMPARE(made.newIslands, 1);
        QVERIFY(overlap::findOverlaps(soupUv(*mesh, made.uv)).pairs.empty());
        for (int f = 0; f < mesh->faceCount(); ++f) {
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1] && f % size >= 4; ++c)
                QVERIFY(made.uv.row(c) == uv.row(c));
        }
    }

    void pinnedPartsStay()
    {
        const auto mesh = test::grid(size);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        Snapshot snapshot = snapshotOf(mesh, uv);
        const int pinned = 3 * mesh->faceTriangle[size - 1]; // in the smaller part, at the right
        snapshot.editSteering().pins.push_back({pinned, Vec2::Zero(), true, 1});
        const RippedMap made = ripEdges(snapshot, columnEdges(*mesh, 6, 0, size), gutter);
        QCOMPARE(made.newIslands, 1);
        const int left = mesh->faceStart[0], right = mesh->faceStart[size - 1];
        QVERIFY(made.uv.row(right) == uv.row(right));
        QVERIFY(made.uv.row(left) != uv.row(left));
    }

    void lockedIslandsStayWhole()
    {
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        for (int f = 0; f < mesh->faceCount(); ++f) {
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1] && f % size >= 4; ++c)
                uv(c, 0) += 0.1;
        }
        Snapshot snapshot = snapshotOf(mesh, uv);
        snapshot.editSteering().faceFlags.assign(mesh->faceCount(), {});
        snapshot.editSteering().faceFlags[0].locked = 1; // the left island
        std::vector<int> edges = columnEdges(*mesh, 2, 0, size);
        const RippedMap locked = ripEdges(snapshot, edges, gutter);
        QCOMPARE(locked.locked, size);
        QVERIFY(locked.edges.empty());
        QVERIFY(locked.uv == uv);
        const std::vector<int> other = columnEdges(*mesh, 6, 0, size);
        edges.insert(edges.end(), other.begin(), other.end());
        const RippedMap made = ripEdges(snapshot, edges, gutter);
        QCOMPARE(made.locked, size);
        QCOMPARE(made.edges, other);
        QCOMPARE(made.newIslands, 1);
    }

    //! Every face on its own: many parts, for which there is no room.
    void allEdges_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"grid", "cube", "sphere", "torus", "dirty"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void allEdges()
    {
        QFETCH(QString, name);
        const auto mesh = test::meshNamed(name);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const RippedMap made = ripEdges(
            snapshotOf(mesh, uv), edgesWhere(*mesh, [](const Vec3 &, const Vec3 &) { return true; }), gutter);
        QCOMPARE(test::flippedIn(*mesh, uv, made.uv), 0);
        QVERIFY(made.uv.allFinite());
        // The same again: the same bits.
        QVERIFY(ripEdges(snapshotOf(mesh, uv), made.edges, gutter).uv == made.uv);
    }

    void placesAreFreeAndNear()
    {
        const auto square = [](double u, double v, double side) {
            packing::PackIsland island;
            island.points = {{u, v}, {u + side, v}, {u + side, v + side}, {u, v + side}};
            island.triangles = {{0, 1, 2}, {0, 2, 3}};
            island.boundary = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
            return island;
        };
        const packing::PackIsland own = square(0.4, 0.4, 0.1);
        packing::AsideMover alone({own}, gutter, 1);
        const auto way = alone.moveAside(0, Vec2(0, -3));
        QVERIFY(way && (*way - Vec2(0, -gutter)).norm() < 1e-12);
        // A neighbour right below: it goes elsewhere, not far.
        packing::AsideMover two({own, square(0.4, 0.295, 0.1)}, gutter, 1);
        const auto other = two.moveAside(0, Vec2(0, -1));
        QVERIFY(other && other->y() > 0 && other->norm() < 2.1 * gutter);
        // It fills its tile.
        QVERIFY(!packing::AsideMover({square(0.001, 0.001, 0.998)}, gutter, 1).moveAside(0, Vec2(1, 0)));
        // One after the other, each is an obstacle for the next where it is now.
        packing::AsideMover row({own, own}, gutter, 1);
        const auto first = row.moveAside(0, Vec2(1, 0)), second = row.moveAside(1, Vec2(1, 0));
        QVERIFY(first && second);
        QVERIFY((*first - *second).cwiseAbs().maxCoeff() > 0.1);
        const std::atomic<bool> stop = true;
        QVERIFY(!packing::AsideMover({own}, gutter, 1).moveAside(0, Vec2(1, 0), &stop));
    }
};

QTEST_GUILESS_MAIN(TestRipping)

} // namespace tst_ripping

#include "tst_ripping.moc"
