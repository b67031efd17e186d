// The solver: descent without flips, starts, directions against each other, steering, determinism.
#include "model/samples/samples.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/budget.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/homotopy/solver.h"
#include "solver/preference/seampreference.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <cmath>

namespace tst_solver {

using namespace autocuts;
using namespace autocuts::energy;
using namespace autocuts::homotopy;
using namespace autocuts::preference;

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
            UvMatrix uv = UvMatrix::Random(meshes[mesh]->soupCornerCount(), 2);
            for (Eigen::Index c = 0; c < uv.rows(); c += 3)
                uv(c, 0) = std::nan("");
            snapshot.startUv = std::make_shared<const UvMatrix>(uv);
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
        Steering &steering = snapshot.editSteering();
        steering.pairState.assign(mesh->cornerPairCount(), PairState::Free);
        std::vector<int> edges;
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            if (!mesh->edgePairs[e].diagonal)
                edges.push_back(static_cast<int>(e));
        }
        for (const int p : {2 * edges[0], 2 * edges[0] + 1})
            steering.pairState[p] = PairState::Joined;
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
        snapshot.editSteering().pins.push_back({0, Vec2(3, 2), true, 1});
        snapshot.editSteering().pins.push_back({40, Vec2(4, 2.5), false, 5});
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
        snapshot.editSteering().rectangles.push_back(box);
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

    void aNewBalanceSharesTheSteering()
    {
        // Step by step the same as when everything is built anew.
        Snapshot snapshot = snapshotOf(test::sphere(8, 12), 0.1, 0.2);
        Steering &steering = snapshot.editSteering();
        steering.pairState.assign(snapshot.mesh->cornerPairCount(), PairState::Free);
        steering.pairState[20] = steering.pairState[21] = PairState::Joined;
        steering.pins = {{0, Vec2(0.3, 0.2), false, 10}, {7, Vec2(0.5, 0.1), true, 1}};
        Solver shared, anew;
        shared.load(snapshot);
        anew.load(snapshot);
        for (const double delta : {0.1, 0.02, 0.005}) {
            snapshot.settings.delta = delta;
            snapshot.settings.lambda *= 0.5;
            shared.update(snapshot);
            QVERIFY(shared.snapshot().steering == snapshot.steering);
            Snapshot copy = snapshot;
            copy.editSteering();
            anew.update(copy);
            QVERIFY(anew.snapshot().steering != snapshot.steering);
            for (int i = 0; i < 5; ++i) {
                QCOMPARE(shared.step().energy, anew.step().energy);
                QVERIFY(shared.coordinates() == anew.coordinates());
            }
        }
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

    void aLiveRunEndsWithinItsBound_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<double>("bound");
        QTest::newRow("bumpy cube") << QStringLiteral("bumpycube") << 4.1;
        QTest::newRow("bumpy cube, tight") << QStringLiteral("bumpycube") << 4.04;
        QTest::newRow("character") << QStringLiteral("character") << 4.1;
        QTest::newRow("torus") << QStringLiteral("torus") << 4.1;
    }
    void aLiveRunEndsWithinItsBound()
    {
        QFETCH(QString, sample);
        QFETCH(double, bound);
        const Scene scene = makeSample(sample).value();
        Solver solver;
        solver.load(SeamPreference().applied(snapshotOf(scene.mesh, 0.05, 1)));
        QVERIFY(runToTheEnd(solver, bound));
        const Soup &soup = solver.soup();
        const std::vector<double> energy = symmetricDirichlet(soup, solver.coordinates());
        double distortion = 0;
        for (int t = 0; t < soup.triangleCount(); ++t)
            distortion += soup.weight[t] * energy[t];
        QVERIFY2(distortion <= bound, qPrintable(QString::number(distortion)));
        QVERIFY2(distortion > 4 + 0.5 * (bound - 4), qPrintable(QString::number(distortion)));
    }

    //! The distortion jumps over all that counts as near to the bound.
    void theScheduleEndsWithALambdaThatKeepsTheBound()
    {
        const auto soup = Soup::build(test::sphere(8, 12));
        LiveSchedule schedule(*soup, 4.1);
        SolveSettings settings;
        StepResult step;
        double kept = 0;
        do {
            schedule.apply(settings);
            step.distortion = settings.lambda > 0.03 ? 4.3 : 4.02 + settings.lambda;
            if (step.distortion < 4.1)
                kept = std::max(kept, settings.lambda);
        } while (schedule.report(step));
        QVERIFY(step.distortion < 4.1);
        QCOMPARE(settings.lambda, kept);
    }

    void theScheduleGivesUpABoundOutOfReach()
    {
        const auto soup = Soup::build(test::sphere(8, 12));
        LiveSchedule schedule(*soup, 4.1);
        SolveSettings settings;
        StepResult step;
        step.distortion = 4.5;
        int steps = 0;
        do {
            schedule.apply(settings);
            QVERIFY(++steps < 1000);
        } while (schedule.report(step));
        QVERIFY(settings.lambda < 1e-4);
    }
};

QTEST_APPLESS_MAIN(TestSolver)

} // namespace tst_solver

#include "tst_solver.moc"
