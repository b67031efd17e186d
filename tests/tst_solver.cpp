// The solver: descent without flips, starts, directions against each other, steering, determinism.
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/budget.h"
#include "solver/homotopy/solver.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>

using namespace autocuts;
using namespace autocuts::homotopy;

namespace {

Snapshot snapshotOf(const test::MeshPtr &mesh, double lambda, double delta)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.lambda = lambda;
    snapshot.settings.delta = delta;
    return snapshot;
}

bool allPositive(const Soup &soup, const std::vector<double> &x)
{
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (!(jacobianDeterminant(soup, x.data(), t) > 0))
            return false;
    }
    return true;
}

} // namespace

class TestSolver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsAreValid_data()
    {
        QTest::addColumn<int>("start");
        QTest::addColumn<int>("mesh");
        const char *names[] = {"rigid", "tutte", "random", "existing"};
        const char *meshes[] = {"cube", "torus", "sphere", "grid", "triangle"};
        for (int s = 0; s < 4; ++s) {
            for (int m = 0; m < 5; ++m)
                QTest::addRow("%s %s", names[s], meshes[m]) << s << m;
        }
    }
    void startsAreValid()
    {
        QFETCH(int, start);
        QFETCH(int, mesh);
        const test::MeshPtr meshes[] = {test::cube(), test::torus(8, 6), test::sphere(6, 8),
                                        test::grid(4, 0.3), test::triangle()};
        Snapshot snapshot = snapshotOf(meshes[mesh], 0.1, 1);
        snapshot.settings.start = static_cast<StartMode>(start);
        if (snapshot.settings.start == StartMode::ExistingUv) {
            // Every third corner has no UV at all.
            snapshot.startUv = UvMatrix::Random(meshes[mesh]->soupCornerCount(), 2);
            for (Eigen::Index c = 0; c < snapshot.startUv.rows(); c += 3)
                snapshot.startUv(c, 0) = std::nan("");
        }
        Solver solver;
        solver.load(snapshot);
        QVERIFY(allPositive(solver.soup(), solver.coordinates()));
        for (int i = 0; i < 5; ++i)
            solver.step();
        QVERIFY(allPositive(solver.soup(), solver.coordinates()));
    }

    void tutteOfADiskIsContinuous()
    {
        Snapshot snapshot = snapshotOf(test::grid(6, 0.2), 0.1, 1);
        snapshot.settings.start = StartMode::Tutte;
        Solver solver;
        solver.load(snapshot);
        for (int p = 0; p < snapshot.mesh->cornerPairCount(); ++p)
            QVERIFY(solver.separation(p) < 1e-12);
    }

    void energyNeverRises_data()
    {
        QTest::addColumn<int>("solver");
        QTest::newRow("fast") << 0;
        QTest::newRow("exact") << 1;
    }
    void energyNeverRises()
    {
        QFETCH(int, solver);
        Snapshot snapshot = snapshotOf(test::torus(16, 10), 0.1, 0.05);
        snapshot.settings.solver = static_cast<SolverKind>(solver);
        Solver stepper;
        stepper.load(snapshot);
        double energy = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 60; ++i) {
            const StepResult step = stepper.step();
            QVERIFY(step.energy <= energy);
            QVERIFY(allPositive(stepper.soup(), stepper.coordinates()));
            QVERIFY(std::abs((0.9 * step.distortion + 0.1 * step.separation) - step.energy) <
                    1e-9 * step.energy);
            QCOMPARE(step.iteration, i + 1);
            energy = step.energy;
        }
    }

    void fastAndExactReachTheSameMinimum()
    {
        // At a large delta the energy has one basin.
        double energy[2];
        for (const SolverKind kind : {SolverKind::Fast, SolverKind::Exact}) {
            Snapshot snapshot = snapshotOf(test::grid(8, 0.5), 0.3, 0.5);
            snapshot.settings.solver = kind;
            snapshot.settings.start = StartMode::Tutte;
            Solver solver;
            solver.load(snapshot);
            for (int i = 0; i < 300; ++i)
                energy[kind == SolverKind::Exact] = solver.step().energy;
        }
        QVERIFY2(std::abs(energy[0] - energy[1]) < 1e-6 * energy[1],
                 qPrintable(QStringLiteral("%1 %2").arg(energy[0], 0, 'g', 12).arg(energy[1], 0, 'g', 12)));
    }

    void exactNewtonConvergesQuadratically()
    {
        // Distortion alone on a developable grid: the minimum is 4 and Newton gets there in a few steps.
        Snapshot snapshot = snapshotOf(test::grid(5), 0, 1);
        snapshot.settings.solver = SolverKind::Exact;
        snapshot.settings.start = StartMode::Tutte;
        Solver solver;
        solver.load(snapshot);
        double distortion = 0;
        for (int i = 0; i < 25; ++i)
            distortion = solver.step().distortion;
        QVERIFY2(std::abs(distortion - 4) < 1e-9, qPrintable(QString::number(distortion, 'g', 15)));
    }

    void cutPairsAreFreeAndJoinedPairsStay()
    {
        const auto mesh = test::quadCube();
        Snapshot snapshot = snapshotOf(mesh, 0.5, 1);
        snapshot.pairState.assign(mesh->cornerPairCount(), PairState::Free);
        std::vector<int> edges;
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            if (!mesh->edgePairs[e].diagonal)
                edges.push_back(static_cast<int>(e));
        }
        for (const int p : {2 * edges[0], 2 * edges[0] + 1})
            snapshot.pairState[p] = PairState::Joined;
        Solver solver;
        solver.load(snapshot);
        AnnealOptions options;
        options.lambda = 0.02;
        annealSoup(solver, options, nullptr);
        for (const int p : {2 * edges[0], 2 * edges[0] + 1})
            QVERIFY(solver.separation(p) < 0.05);
        for (int p = 0; p < mesh->cornerPairCount(); ++p) {
            if (mesh->edgePairs[p / 2].diagonal)
                QVERIFY(solver.separation(p) < 0.05);
        }
    }

    void hardPinsHoldExactlyAndSoftPinsPull_data() { energyNeverRises_data(); }
    void hardPinsHoldExactlyAndSoftPinsPull()
    {
        QFETCH(int, solver);
        Snapshot snapshot = snapshotOf(test::grid(4), 0.2, 0.1);
        snapshot.settings.solver = static_cast<SolverKind>(solver);
        snapshot.settings.start = StartMode::Tutte;
        snapshot.pins.push_back({0, Vec2(3, 2), true, 1});
        snapshot.pins.push_back({40, Vec2(4, 2.5), false, 5});
        Solver stepper;
        stepper.load(snapshot);
        for (int i = 0; i < 400; ++i)
            stepper.step();
        const auto &x = stepper.coordinates();
        QCOMPARE(x[0], 3.0);
        QCOMPARE(x[1], 2.0);
        QVERIFY(std::hypot(x[80] - 4, x[81] - 2.5) < 0.5);
        QVERIFY(allPositive(stepper.soup(), x));
    }

    void rectangleContainsItsCorners()
    {
        // A flat unit square of area pi is squeezed into a box 1.2 wide.
        const auto mesh = test::grid(4);
        Snapshot snapshot = snapshotOf(mesh, 0.3, 0.1);
        snapshot.settings.start = StartMode::Tutte;
        UvRectangle box;
        box.lower = Vec2(-0.6, -2);
        box.upper = Vec2(0.6, 2);
        for (int c = 0; c < mesh->soupCornerCount(); ++c)
            box.soupCorners.push_back(c);
        snapshot.rectangles.push_back(box);
        Solver solver;
        solver.load(snapshot);
        for (int i = 0; i < 200; ++i)
            solver.step();
        double outside = 0;
        for (int c = 0; c < mesh->soupCornerCount(); ++c)
            outside = std::max(outside, std::abs(solver.coordinates()[2 * c]) - 0.6);
        QVERIFY2(outside < 0.005 * 1.2, qPrintable(QString::number(outside)));
    }

    void updateKeepsTheMap()
    {
        Snapshot snapshot = snapshotOf(test::sphere(8, 10), 0.1, 0.1);
        Solver solver;
        solver.load(snapshot);
        for (int i = 0; i < 10; ++i)
            solver.step();
        const std::vector<double> before = solver.coordinates();
        snapshot.settings.delta = 0.05;
        snapshot.settings.solver = SolverKind::Exact;
        solver.update(snapshot);
        QCOMPARE(solver.coordinates(), before);
        QCOMPARE(solver.step().iteration, 11);
        snapshot.mesh = test::cube();
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, solver.update(snapshot));
    }

    void sameInputSameBits()
    {
        std::vector<double> x[2];
        for (auto &result : x) {
            Solver solver;
            solver.load(snapshotOf(test::torus(12, 8), 0.05, 1));
            AnnealOptions options;
            options.stepsPerLevel = 5;
            annealSoup(solver, options, nullptr);
            result = solver.coordinates();
        }
        QCOMPARE(x[0], x[1]);
    }

    void meshWithoutAreaIsRefused()
    {
        Solver solver;
        const auto flat = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, solver.load(snapshotOf(flat, 0.1, 1)));
    }

    void degenerateTrianglesStayUnfoldedAndHarmless()
    {
        // A square with a sliver of no area on its diagonal.
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                                            {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}});
        QVERIFY(mesh->triangleDegenerate[1]);
        Snapshot snapshot = snapshotOf(mesh, 0.5, 0.5);
        Solver solver;
        solver.load(snapshot);
        StepResult last;
        for (int i = 0; i < 100; ++i)
            last = solver.step();
        QVERIFY(allPositive(solver.soup(), solver.coordinates()));
        QVERIFY(last.distortion < 4.1);
    }

    void budgetFindsTheLambda()
    {
        // Runs that behave like excess = 8 lambda^0.8.
        DistortionBudget budget(4.1, 0.05);
        double distortion = 0;
        for (int i = 0; i < 8; ++i) {
            distortion = 4 + 8 * std::pow(budget.lambda(), 0.8);
            budget.report(distortion);
        }
        QVERIFY2(distortion <= 4.1 && distortion > 4.09, qPrintable(QString::number(distortion)));
    }
};

QTEST_APPLESS_MAIN(TestSolver)
#include "tst_solver.moc"
