// Solving parts of maps: chains of edges made straight, selections relaxed.
#include "model/editing/edgechains.h"
#include "model/plain/chart.h"
#include "solver/homotopy/localsolve.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace tst_localsolve {

using namespace autocuts;
using namespace autocuts::homotopy;

namespace {

constexpr int size = 8;

//! The grid as it lies in 3D, bent: rows of constant y become arcs.
UvMatrix bentLayout(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const Vec3 p = mesh.cornerPosition(c);
        const double angle = 1.5 * (p.x() - 0.5), radius = 1 + p.y();
        uv.row(c) << radius * std::sin(angle), radius * std::cos(angle);
    }
    return uv;
}

//! Edges of the grid along y = row / size, in the columns [first, end).
std::vector<int> rowEdges(const MeshData &mesh, const MeshAdjacency &adjacency, int row, int first, int end)
{
    std::set<int> edges;
    for (int e = 0; e < adjacency.edgeCount(); ++e) {
        if (adjacency.isDiagonal(e))
            continue;
        const auto [a, b] = adjacency.edgeVertices(e);
        const Vec3 p = mesh.positions.row(a), q = mesh.positions.row(b);
        const double y = double(row) / size, middle = 0.5 * (p.x() + q.x()) * size;
        if (std::abs(p.y() - y) < 1e-9 && std::abs(q.y() - y) < 1e-9 && middle > first && middle < end)
            edges.insert(e);
    }
    return {edges.begin(), edges.end()};
}

int turnedOver(const MeshData &mesh, const UvMatrix &uv)
{
    int count = 0;
    for (const auto &t : mesh.triangles)
        count += !(cross2(uv.row(t[0]).transpose(), uv.row(t[1]).transpose(), uv.row(t[2]).transpose()) > 0);
    return count;
}

std::vector<int> allFaces(const MeshData &mesh)
{
    std::vector<int> faces(mesh.faceCount());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

} // namespace

class TestLocalSolve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void chainsAreFound()
    {
        const auto mesh = test::grid(size);
        const MeshAdjacency adjacency(*mesh);
        const UvMatrix uv = bentLayout(*mesh);
        const UvTopology topology = findUvTopology(*mesh, uv);
        std::vector<int> edges = rowEdges(*mesh, adjacency, 3, 1, 6);
        QCOMPARE(edges.size(), std::size_t(5));
        UvChains found = findUvChains(*mesh, adjacency, topology, edges);
        QCOMPARE(found.chains.size(), std::size_t(1));
        QCOMPARE(found.left, 0);
        QCOMPARE(found.chains[0].points.size(), std::size_t(6));
        for (double length : found.chains[0].lengths)
            QCOMPARE(length, 1.0 / size);
        // A second row, and a single edge, which is no chain.
        for (int edge : rowEdges(*mesh, adjacency, 5, 0, 8))
            edges.push_back(edge);
        edges.push_back(rowEdges(*mesh, adjacency, 7, 2, 3).front());
        found = findUvChains(*mesh, adjacency, topology, edges);
        QCOMPARE(found.chains.size(), std::size_t(2));
        QCOMPARE(found.left, 1);
        // All edges of a face: a loop.
        edges.clear();
        for (int c = mesh->faceStart[9]; c < mesh->faceStart[10]; ++c)
            edges.push_back(adjacency.edgeOfCorner(c));
        found = findUvChains(*mesh, adjacency, topology, edges);
        QVERIFY(found.chains.empty());
        QCOMPARE(found.left, 1);
    }

    void chainsBecomeStraight_data()
    {
        QTest::addColumn<int>("row");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("inside") << 4 << false;
        QTest::newRow("lower border") << 0 << false;
        QTest::newRow("upper border") << size << false;
        QTest::newRow("mirrored") << 4 << true;
    }

    void chainsBecomeStraight()
    {
        QFETCH(int, row);
        QFETCH(bool, mirrored);
        const auto mesh = test::grid(size);
        const MeshAdjacency adjacency(*mesh);
        UvMatrix uv = bentLayout(*mesh);
        QCOMPARE(turnedOver(*mesh, uv), 0);
        if (mirrored)
            uv.col(0) *= -1;
        const UvTopology topology = findUvTopology(*mesh, uv);
        const auto chains =
            findUvChains(*mesh, adjacency, topology, rowEdges(*mesh, adjacency, row, 0, size));
        LocalProblem problem;
        problem.faces = allFaces(*mesh);
        problem.pointOfCorner = topology.cornerRoot;
        problem.targets = straightened(chains.chains.at(0), uv);
        QCOMPARE(problem.targets.size(), std::size_t(size + 1));
        const LocalSolution solution = solveLocally(*mesh, uv, problem);
        QCOMPARE(solution.outcome, LocalSolution::Outcome::Solved);
        QCOMPARE(solution.foldedFaces, 0);
        const Vec2 first = problem.targets.front().second, last = problem.targets.back().second;
        for (const auto &[point, place] : problem.targets) {
            QCOMPARE(Vec2(solution.uv.row(point).transpose()), place);
            QVERIFY(std::abs(cross2(first, last, place)) < 1e-12);
        }
        UvMatrix upright = solution.uv;
        if (mirrored)
            upright.col(0) *= -1;
        QCOMPARE(turnedOver(*mesh, upright), 0);
        QCOMPARE(findCharts(*mesh, solution.uv).count, 1);
        QVERIFY(solution.after < 4.5 && solution.after < solution.before);
    }

    void pinsHoldWhileAChainBecomesStraight()
    {
        const auto mesh = test::grid(size);
        const MeshAdjacency adjacency(*mesh);
        const UvMatrix uv = bentLayout(*mesh);
        const UvTopology topology = findUvTopology(*mesh, uv);
        LocalProblem problem;
        problem.faces = allFaces(*mesh);
        problem.pointOfCorner = topology.cornerRoot;
        problem.held = {topology.cornerRoot[0]};
        const auto chains = findUvChains(*mesh, adjacency, topology, rowEdges(*mesh, adjacency, 6, 0, size));
        problem.targets = straightened(chains.chains.at(0), uv);
        const LocalSolution solution = solveLocally(*mesh, uv, problem);
        QCOMPARE(solution.outcome, LocalSolution::Outcome::Solved);
        QVERIFY(solution.uv.row(0) == uv.row(0));
        QCOMPARE(turnedOver(*mesh, solution.uv), 0);
    }

    void relaxingLeavesTheRest()
    {
        const auto mesh = test::grid(size);
        UvMatrix uv(mesh->cornerCount(), 2);
        // Without stretch but for a dent in the middle.
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            const Vec3 p = mesh->cornerPosition(c);
            const double away = std::hypot(p.x() - 0.5, p.y() - 0.5);
            const double dent = 0.12 * std::exp(-30 * away * away);
            uv.row(c) << 0.5 * (p.x() + dent), 0.5 * (p.y() - dent);
        }
        QCOMPARE(turnedOver(*mesh, uv), 0);
        const UvTopology topology = findUvTopology(*mesh, uv);
        LocalProblem problem;
        problem.reference = allFaces(*mesh);
        problem.pointOfCorner = topology.cornerRoot;
        for (int f = 0; f < mesh->faceCount(); ++f) {
            const int column = f % size, row = f / size;
            if (column >= 1 && column <= 6 && row >= 1 && row <= 6) {
                problem.faces.push_back(f);
                continue;
            }
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c)
                problem.held.push_back(topology.cornerRoot[c]);
        }
        const LocalSolution solution = solveLocally(*mesh, uv, problem);
        QCOMPARE(solution.outcome, LocalSolution::Outcome::Solved);
        QVERIFY2(solution.before > 4.2 && solution.after < 4.01,
                 qPrintable(QStringLiteral("%1 %2").arg(solution.before).arg(solution.after)));
        for (int point : problem.held)
            QVERIFY(solution.uv.row(point) == uv.row(point));
        QCOMPARE(turnedOver(*mesh, solution.uv), 0);
        // The same again: the same bits.
        QVERIFY(solveLocally(*mesh, uv, problem).uv == solution.uv);
    }

    void whatCannotBeSolvedStays()
    {
        const auto mesh = test::grid(2);
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            uv.row(c) = mesh->cornerPosition(c).head<2>().transpose();
        LocalProblem problem;
        problem.pointOfCorner = findUvTopology(*mesh, uv).cornerRoot;
        QCOMPARE(solveLocally(*mesh, uv, problem).outcome, LocalSolution::Outcome::Empty);
        problem.faces = allFaces(*mesh);
        problem.held = problem.pointOfCorner;
        QCOMPARE(solveLocally(*mesh, uv, problem).outcome, LocalSolution::Outcome::Empty);
        // The middle beyond the border, whose points are held.
        const int middle = problem.pointOfCorner[2];
        QCOMPARE(Vec2(uv.row(middle).transpose()), Vec2(0.5, 0.5));
        problem.targets = {{middle, Vec2(3, 0.5)}};
        problem.held.erase(std::remove(problem.held.begin(), problem.held.end(), middle), problem.held.end());
        const LocalSolution solution = solveLocally(*mesh, uv, problem);
        QCOMPARE(solution.outcome, LocalSolution::Outcome::Stuck);
        QVERIFY(solution.uv == uv);
        const std::atomic<bool> cancel = true;
        problem.targets = {{middle, Vec2(0.6, 0.5)}};
        QCOMPARE(solveLocally(*mesh, uv, problem, &cancel).outcome, LocalSolution::Outcome::Cancelled);
    }
};

QTEST_GUILESS_MAIN(TestLocalSolve)

} // namespace tst_localsolve

#include "tst_localsolve.moc"
