// The automatic cutter: its linear algebra, its trials, and what it must never do to a map.
#include "solver/definite/relaxing.h"
#include "solver/search/blockcholesky.h"
#include "solver/search/patchkernel.h"
#include "solver/search/seamoptimizer.h"
#include "solver/search/seamsearch.h"
#include "solver/search/seamseeds.h"
#include "solver/search/segments.h"
#include "solver/search/topologyupdate.h"
#include "solver/search/trianglekernel.h"
#include "solver/search/tutte.h"
#include "support/meshbuilders.h"
#include "support/props.h"

#include <Eigen/Dense>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

namespace tst_seamsearch {

using namespace autocuts;
using namespace autocuts::definite;
using namespace autocuts::search;

namespace {

test::MeshPtr meshNamed(const QString &name)
{
    if (name == QLatin1String("torus"))
        return test::torus(12, 8);
    if (name == QLatin1String("cube"))
        return test::quadCube();
    return test::sphere(10, 14);
}

std::shared_ptr<const SeamGraph> graphOf(const Snapshot &snapshot)
{
    return SeamGraph::build(Soup::build(snapshot.mesh), snapshot);
}

CutState startOf(const std::shared_ptr<const SeamGraph> &graph, int paths)
{
    SeedOptions options;
    options.paths = paths;
    const std::vector<char> cut = fewCuts(*graph, options);
    SeamedMap map{CutFlags(cut.begin(), cut.end()), {}};
    map.x = tutteEmbedding(*graph->soup, CutMesh(*graph->soup->mesh, map.cut));
    return CutState::from(graph, map);
}

//! Entries below the diagonal of the factor, per point, when all points are eliminated in the order of
//! `rank`.
double fillOf(const SeamGraph &graph)
{
    std::vector<std::set<int>> below(graph.vertexCount); // per place in the order
    for (std::size_t c = 0; c < graph.vertex.size(); ++c) {
        const int a = graph.rank[graph.vertex[c]], b = graph.rank[graph.vertex[c / 3 * 3 + (c + 1) % 3]];
        below[std::min(a, b)].insert(std::max(a, b));
    }
    std::size_t entries = 0;
    for (const std::set<int> &rows : below) {
        entries += rows.size();
        if (!rows.empty())
            below[*rows.begin()].insert(std::next(rows.begin()), rows.end());
    }
    return double(entries) / graph.vertexCount;
}

//! What does not follow from the cut flags of a state; empty when all does.
QString topologyProblem(const CutState &state)
{
    CutState fresh = state;
    fresh.updateTopology();
    if (fresh.boundary != state.boundary)
        return QStringLiteral("the boundary is out of date");
    if (fresh.chart != state.chart || fresh.chartArea.size() != state.chartArea.size())
        return QStringLiteral("the charts are out of date");
    for (std::size_t c = 0; c < fresh.chartArea.size(); ++c) {
        if (std::abs(fresh.chartArea[c] - state.chartArea[c]) > 1e-12)
            return QStringLiteral("area %1, not %2").arg(state.chartArea[c]).arg(fresh.chartArea[c]);
    }
    if (fresh.cutsAt != state.cutsAt || fresh.smallParts != state.smallParts)
        return QStringLiteral("cuts at vertices or small parts are out of date");
    if (std::abs(fresh.length - state.length) > 1e-9 || std::abs(fresh.cost - state.cost) > 1e-9)
        return QStringLiteral("length or cost are out of date");
    return {};
}

//! What is wrong with a state; empty when its sums are right and its map is valid and covers nothing twice.
QString problemWith(const CutState &state)
{
    const Soup &soup = *state.graph->soup;
    const SeamedMap map = state.map();
    const std::string broken = map.validate(soup);
    if (!broken.empty())
        return QString::fromStdString(broken);
    if (coversItself(soup, map))
        return QStringLiteral("a chart covers itself");
    CutState fresh = state;
    fresh.updateTopology();
    fresh.updateEnergy();
    if (std::abs(fresh.energy - state.energy) > 1e-9)
        return QStringLiteral("energy %1, not %2").arg(state.energy).arg(fresh.energy);
    if (std::abs(fresh.length - map.seamLength(soup)) > 1e-9)
        return QStringLiteral("the length is out of date");
    return topologyProblem(state);
}

OptimizeOptions littleEffort()
{
    OptimizeOptions options;
    options.effort = {3, {{20, 2}, {60, 1}}, 10};
    return options;
}

} // namespace

class TestSeamSearch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void choleskySolvesBlockSystems()
    {
        Random random(7);
        for (const int count : {1, 2, 9, 40}) {
            Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * count, 2 * count);
            std::vector<std::pair<int, int>> lower;
            for (int i = 0; i < count; ++i) {
                for (int k = 0; k < 3 && i > 0; ++k)
                    lower.emplace_back(i, random.below(i));
            }
            const std::vector<std::pair<int, int>> entries = lower;
            BlockCholesky system;
            system.analyze(count, lower);
            system.clear();
            for (const auto &[row, column] : entries) {
                for (int k = 0; k < 4; ++k) {
                    const double v = random.uniform(-1, 1);
                    system.offDiagonal(system.place(row, column))[k] += v;
                    dense(2 * row + k / 2, 2 * column + k % 2) += v;
                    dense(2 * column + k % 2, 2 * row + k / 2) += v;
                }
            }
            for (int i = 0; i < count; ++i) {
                system.diagonal(i) = {30, 0, 1, 25};
                dense(2 * i, 2 * i) = 30;
                dense(2 * i + 1, 2 * i) = dense(2 * i, 2 * i + 1) = 1;
                dense(2 * i + 1, 2 * i + 1) = 25;
            }
            Eigen::VectorXd right(2 * count);
            for (int i = 0; i < 2 * count; ++i)
                right[i] = random.uniform(-1, 1);
            Eigen::VectorXd x = right;
            QVERIFY(system.factorize());
            system.solve(x.data());
            QVERIFY((dense * x - right).norm() < 1e-12 * (1 + right.norm()));
            system.diagonal(count - 1) = {-1, 0, 0, 1};
            QVERIFY(!system.factorize());
        }
    }

    void triangleGradientsAreRight()
    {
        const auto soup = Soup::build(test::triangle());
        const std::array<double, 6> p{0.1, 0.2, 1.7, -0.1, 0.4, 1.1};
        double gradient[6], hessian[21];
        triangleDerivatives(p.data(), soup->basis[0], 0.7, gradient, hessian);
        Eigen::Matrix<double, 6, 6> h;
        for (int i = 0, at = 0; i < 6; ++i) {
            for (int j = 0; j <= i; ++j)
                h(i, j) = h(j, i) = hessian[at++];
        }
        for (int i = 0; i < 6; ++i) {
            auto q = p;
            constexpr double step = 1e-6;
            q[i] = p[i] + step;
            const double high = triangleEnergy(q.data(), soup->basis[0]);
            q[i] = p[i] - step;
            const double low = triangleEnergy(q.data(), soup->basis[0]);
            QVERIFY(std::abs(0.7 * (high - low) / (2 * step) - gradient[i]) <
                    1e-6 * (1 + std::abs(gradient[i])));
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(h);
        QVERIFY(solver.eigenvalues().minCoeff() > -1e-9);
        // Turned over: no energy.
        const std::array<double, 6> flipped{0, 0, 0, 1, 1, 0};
        QVERIFY(std::isinf(triangleEnergy(flipped.data(), soup->basis[0])));
    }

    //! Also at an isometry, where two singular values are equal, and in the places after the last triangle.
    void severalTrianglesAtOnceHaveTheBitsOfEach_data()
    {
        QTest::addColumn<bool>("rigid");
        QTest::newRow("free") << false;
        QTest::newRow("rigid") << true;
    }
    void severalTrianglesAtOnceHaveTheBitsOfEach()
    {
        QFETCH(bool, rigid);
        const auto soup = Soup::build(test::sphere(6, 8));
        const std::size_t count = 2 * triangleLanes + 3;
        Random random(5);
        std::vector<TriangleBlock> blocks(3);
        std::vector<int> point;
        std::vector<double> position;
        const auto stiffness = [&](std::size_t t) { return rigid ? 1.5 + double(t) : 1; };
        for (std::size_t t = 0; t < triangleLanes * blocks.size(); ++t) {
            const std::size_t source = std::min(t, count - 1);
            TriangleBlock &block = blocks[t / triangleLanes];
            for (std::size_t i = 0; i < 6; ++i)
                block.basis[i][t % triangleLanes] = soup->basis[source][i];
            block.weight[t % triangleLanes] = soup->weight[source];
            block.stiffness[t % triangleLanes] = stiffness(source);
        }
        for (std::size_t t = 0; t < count; ++t) {
            for (std::size_t i = 0; i < 6; ++i) {
                const double noise = t == 1 ? 0 : 0.1 * soup->meanEdgeLength * random.uniform(-1, 1);
                position.push_back(soup->restShape[t][i] + noise);
            }
            for (int k = 0; k < 3; ++k)
                point.push_back(static_cast<int>(point.size()));
        }
        std::vector<double> energies(triangleLanes * blocks.size());
        blockEnergies(blocks, point, position, rigid, energies);
        for (std::size_t t = 0; t < count; ++t) {
            const double *p = &position[6 * t];
            const double density = triangleEnergy(p, soup->basis[t]);
            QVERIFY(energies[t] == soup->weight[t] * (rigid ? 4 + stiffness(t) * (density - 4) : density));
            double gradient[6], hessian[21];
            triangleDerivatives(p, soup->basis[t], stiffness(t) * soup->weight[t], gradient, hessian);
            BlockDerivatives all;
            blockDerivatives(blocks, t / triangleLanes, point, position, all);
            for (int i = 0; i < 6; ++i)
                QVERIFY(all.gradient[i][t % triangleLanes] == gradient[i]);
            for (int i = 0; i < 21; ++i)
                QVERIFY(all.hessian[i][t % triangleLanes] == hessian[i]);
        }
        std::swap(position[0], position[2]);
        std::swap(position[1], position[3]);
        blockEnergies(blocks, point, position, rigid, energies);
        QVERIFY(std::isinf(energies[0]) && std::isfinite(energies[1]));
    }

    void segmentsCross()
    {
        Segments segments;
        segments.addMoving(0, 1);
        segments.addFixed(0, -1, 0, 1);
        QVERIFY(segments.cross({-1, 0, 1, 0}));
        QVERIFY(!segments.cross({-1, 0, -0.5, 0}));
        QVERIFY(!segments.cross({-1, 0, 0, 0})); // touching
        QVERIFY(!segments.cross({0, -1, 1, 0})); // at an end
        std::vector<int> touched;
        QVERIFY(segments.cross({-1, 0, 1, 0}, &touched));
        QCOMPARE(touched, (std::vector<int>{0, 1}));
    }

    void firstCutsOpenEverySurface_data()
    {
        QTest::addColumn<int>("paths");
        for (const char *name : {"sphere", "torus", "cube"}) {
            for (const int paths : {0, 3})
                QTest::addRow("%s %d", name, paths) << paths;
        }
    }
    void firstCutsOpenEverySurface()
    {
        QFETCH(int, paths);
        Snapshot snapshot;
        snapshot.mesh =
            meshNamed(QString::fromLatin1(QTest::currentDataTag()).section(QLatin1Char(' '), 0, 0));
        const CutState state = startOf(graphOf(snapshot), paths);
        QCOMPARE(problemWith(state), QString());
        QCOMPARE(state.chartCount(), 1);
        QVERIFY(state.loopsAreInOrder());
    }

    void searchNeverMakesThingsWorse_data()
    {
        QTest::addColumn<double>("mu");
        for (const char *name : {"sphere", "torus", "cube"}) {
            QTest::addRow("%s short", name) << 0.3;
            QTest::addRow("%s long", name) << 0.01;
        }
    }
    void searchNeverMakesThingsWorse()
    {
        QFETCH(double, mu);
        Snapshot snapshot;
        snapshot.mesh =
            meshNamed(QString::fromLatin1(QTest::currentDataTag()).section(QLatin1Char(' '), 0, 0));
        const auto graph = graphOf(snapshot);
        CutState state = startOf(graph, 3);
        SeamSearch search(state, 5, {mu, true, {}});
        search.relaxAll(30);
        QCOMPARE(problemWith(state), QString());
        double objective = state.objective(mu);
        for (int i = 0; i < 100; ++i) {
            if (i % 20 == 0)
                search.polish(1);
            else
                search.tryLargeMove();
            QVERIFY2(state.objective(mu) <= objective + 1e-12, qPrintable(QString::number(i)));
            objective = state.objective(mu);
            QCOMPARE(problemWith(state), QString());
        }
        int kept = 0;
        for (const SeamSearch::Counts &count : search.counts)
            kept += count.kept;
        QVERIFY(kept > 0);
    }

    void firstCutsStopWhereLittleShrinks()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 14);
        const auto graph = graphOf(snapshot);
        const auto edges = [&](double shrinkage) {
            SeedOptions options;
            options.shrinkage = shrinkage;
            const std::vector<char> cut = fewCuts(*graph, options);
            return std::count(cut.begin(), cut.end(), 1);
        };
        SeedOptions none;
        none.paths = 0;
        const std::vector<char> opened = fewCuts(*graph, none);
        QCOMPARE(edges(1000), std::count(opened.begin(), opened.end(), 1));
        QVERIFY(edges(0.1) > edges(1000));
    }

    //! Where charts touch, the borders of each are joined to its own ones.
    void bordersJoinWithinTheirChart()
    {
        constexpr int sides = 12;
        const auto isCap = [](const MeshData &mesh, int t) {
            return mesh.faceStart[mesh.triangleFace[t] + 1] - mesh.faceStart[mesh.triangleFace[t]] == sides;
        };
        Snapshot column;
        column.mesh = test::props::column(sides, 1, 1, 8, 8).mesh();
        const MeshData &mesh = *column.mesh;
        std::vector<PairState> &states = column.editSteering().pairState;
        states.assign(mesh.cornerPairCount(), PairState::Free);
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            const auto [a, b] = mesh.edgePairs[e].triangle;
            if (isCap(mesh, a) != isCap(mesh, b))
                states[2 * e] = states[2 * e + 1] = PairState::Cut;
        }
        SeedOptions options;
        options.paths = 0;
        options.joinBorders = true;
        const std::vector<char> cut = fewCuts(*graphOf(column), options);
        const CutMesh charts(mesh, CutFlags(cut.begin(), cut.end()));
        QCOMPARE(charts.chartCount, 3);
        QCOMPARE(charts.boundaryLoops().size(), std::size_t(3)); // two around the side without the path
    }

    void chartsFollowTheSeams_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::newRow("sphere") << "sphere";
        QTest::newRow("torus") << "torus";
        QTest::newRow("cube") << "cube";
    }

    //! Random sets of edges are opened and closed, so that charts fall apart, join, and do both at once.
    void chartsFollowTheSeams()
    {
        QFETCH(QString, mesh);
        Snapshot snapshot;
        snapshot.mesh = meshNamed(mesh);
        CutState state = startOf(graphOf(snapshot), 2);
        TopologyUpdate topology;
        Random random(7);
        int most = 0;
        for (int round = 0; round < 300; ++round) {
            // Closing prevails where there are many seams, opening where there are few.
            const bool opens = round % 100 < 60;
            SeamChange change;
            for (std::size_t e = 0; e < state.cut.size(); ++e) {
                if (random.uniform() < ((state.cut[e] != 0) == opens ? 0.01 : 0.08))
                    (state.cut[e] ? change.close : change.open).push_back(static_cast<int>(e));
            }
            for (const int e : change.open)
                state.setCut(e, true);
            for (const int e : change.close)
                state.setCut(e, false);
            topology.update(state, change.open, change.close);
            QCOMPARE(topologyProblem(state), QString());
            most = std::max(most, state.chartCount());
        }
        QVERIFY(most > 3);
    }

    void longerSeamsWhereTheyAreCheap_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::newRow("sphere") << QStringLiteral("sphere");
        QTest::newRow("torus") << QStringLiteral("torus");
    }
    void longerSeamsWhereTheyAreCheap()
    {
        QFETCH(QString, mesh);
        Snapshot snapshot;
        snapshot.mesh = meshNamed(mesh);
        const auto soup = Soup::build(snapshot.mesh);
        OptimizeOptions options = littleEffort();
        double before = std::numeric_limits<double>::infinity();
        for (const double bound : {4.05, 4.1, 4.2, 4.5}) {
            options.maxDistortion = bound;
            const auto found = optimizeSeams(graphOf(snapshot), options);
            QVERIFY(found.has_value());
            QVERIFY(found->map.distortion(*soup) <= bound);
            QVERIFY(!coversItself(*soup, found->map));
            const double length = found->map.seamLength(*soup);
            QVERIFY2(length < before,
                     qPrintable(QStringLiteral("%1 at %2, %3 before").arg(length).arg(bound).arg(before)));
            before = length;
        }
    }

    void everyRoundTriesItsMoves()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 14);
        OptimizeOptions options;
        options.effort = {4, {{10, 3}, {20, 2}, {30, 1}}, 1};
        int announced = 0, done = 0;
        options.start = [&](int steps) { announced = steps; };
        options.progress = [&](int steps) { done += steps; };
        QVERIFY(optimizeSeams(graphOf(snapshot), options).has_value());
        QCOMPARE(announced, 4 * 10 + 3 * 20 + 2 * 30);
        QCOMPARE(done, announced);
    }

    //! The second map has every edge for a seam. Its search would take steps, and change nothing.
    void hopelessFirstMapsAreNotSearched()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(30, 60);
        const auto graph = graphOf(snapshot);
        OptimizeOptions options;
        options.effort = {0, {{5, 2}, {5, 1}}, 0};
        const std::optional<CutState> good = firstMap(graph, littleEffort(), 0);
        QVERIFY(good.has_value());
        options.given = {good->map()};
        const auto alone = optimizeSeams(graph, options);
        SeamedMap apart;
        apart.cut.assign(snapshot.mesh->edgePairs.size(), true);
        apart.x = tutteEmbedding(*graph->soup, CutMesh(*snapshot.mesh, apart.cut));
        options.given.push_back(apart);
        int announced = 0, done = 0;
        options.start = [&](int steps) { announced = steps; };
        options.progress = [&](int steps) { done += steps; };
        const auto both = optimizeSeams(graph, options);
        QVERIFY(alone && both);
        QCOMPARE(both->iterations, alone->iterations);
        QVERIFY(both->map.x == alone->map.x);
        QCOMPARE(announced, 2 * 5 + 2 * 5);
        QCOMPARE(done, announced);
    }

    //! A comb in the plane: its first map squeezes the ends of the teeth, so that ten steps are too few.
    void flatSheetsNeedNoSeams()
    {
        test::props::Model comb;
        constexpr int teeth = 4, length = 20;
        const auto point = [&](int x, int y) {
            comb.points.emplace_back(x, y, 0);
            return static_cast<int>(comb.points.size()) - 1;
        };
        std::vector<int> spine; // y = 0 and 1
        for (int x = 0; x <= 2 * teeth; ++x) {
            spine.push_back(point(x, 0));
            spine.push_back(point(x, 1));
        }
        for (int x = 0; x < 2 * teeth; ++x)
            comb.faces.push_back({spine[2 * x], spine[2 * x + 2], spine[2 * x + 3], spine[2 * x + 1]});
        for (int tooth = 0; tooth < teeth; ++tooth) {
            int left = spine[4 * tooth + 1], right = spine[4 * tooth + 3];
            for (int y = 2; y < length; ++y) {
                const int nextLeft = point(2 * tooth, y), nextRight = point(2 * tooth + 1, y);
                comb.faces.push_back({left, right, nextRight, nextLeft});
                left = nextLeft;
                right = nextRight;
            }
        }
        Snapshot snapshot;
        snapshot.mesh = comb.mesh();
        const auto flat = flatMap(graphOf(snapshot), littleEffort());
        QVERIFY(flat.has_value());
        QCOMPARE(flat->map.seamLength(*Soup::build(snapshot.mesh)), 0.0);
    }

    void theSameOnAnyNumberOfThreads()
    {
        Snapshot snapshot;
        snapshot.mesh = test::torus(12, 8);
        OptimizeOptions options = littleEffort();
        const auto one = optimizeSeams(graphOf(snapshot), options);
        options.job = {nullptr, 3};
        const auto three = optimizeSeams(graphOf(snapshot), options);
        QVERIFY(one && three);
        QVERIFY(one->map.x == three->map.x);
        QVERIFY(one->map.cut == three->map.cut);
        options.seed = 2;
        QVERIFY(optimizeSeams(graphOf(snapshot), options)->map.x != one->map.x);
    }

    void steeringIsRespected()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 14);
        Steering &steering = snapshot.editSteering();
        steering.pairState.assign(snapshot.mesh->cornerPairCount(), PairState::Free);
        const int edges = static_cast<int>(snapshot.mesh->edgePairs.size());
        Random random(3);
        for (int i = 0; i < edges / 10; ++i) {
            const int e = random.below(edges);
            const PairState state = i % 10 == 0 ? PairState::Cut : PairState::Joined;
            steering.pairState[2 * e] = steering.pairState[2 * e + 1] = state;
        }
        const auto graph = graphOf(snapshot);
        const auto found = optimizeSeams(graph, littleEffort());
        QVERIFY(found.has_value());
        for (int e = 0; e < edges; ++e) {
            QVERIFY(graph->rule[e] != SeamGraph::Rule::AlwaysCut || found->map.cut[e]);
            QVERIFY(graph->rule[e] != SeamGraph::Rule::NeverCut || !found->map.cut[e]);
        }
    }

    void theEliminationOrderHasLittleFill_data()
    {
        // Twice what the approximate minimum degree of the whole mesh gives.
        QTest::addColumn<test::MeshPtr>("mesh");
        QTest::addColumn<double>("most");
        QTest::newRow("closed") << test::sphere(20, 30) << 24.0;
        QTest::newRow("with a border") << test::grid(24) << 20.0;
    }
    void theEliminationOrderHasLittleFill()
    {
        QFETCH(test::MeshPtr, mesh);
        QFETCH(double, most);
        Snapshot snapshot;
        snapshot.mesh = mesh;
        const double fill = fillOf(*graphOf(snapshot));
        QVERIFY2(fill < most, qPrintable(QString::number(fill)));
    }

    void aStopLeavesAValidMap()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(10, 14);
        OptimizeOptions options = littleEffort();
        std::atomic<bool> stop = true;
        options.job = &stop;
        QVERIFY(!optimizeSeams(graphOf(snapshot), options).has_value());
        stop = false;
        options.progress = [&](int) { stop = true; }; // while the first map is searched
        const auto found = optimizeSeams(graphOf(snapshot), options);
        QVERIFY(found.has_value());
        const auto soup = Soup::build(snapshot.mesh);
        QCOMPARE(found->map.validate(*soup), std::string());
        QVERIFY(!coversItself(*soup, found->map));
    }
};

QTEST_APPLESS_MAIN(TestSeamSearch)

} // namespace tst_seamsearch

#include "tst_seamsearch.moc"
