// Energy terms: gradients and Hessians against finite differences on three meshes, and what each term
// promises.
#include "model/plain/texelweights.h"
#include "solver/base/random.h"
#include "solver/energy/constraintterms.h"
#include "solver/energy/distortion.h"
#include "solver/energy/isotropic.h"
#include "solver/energy/separation.h"
#include "solver/homotopy/initialuv.h"
#include "support/meshbuilders.h"

#include <Eigen/Dense>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

namespace tst_energy {

using namespace autocuts;
using namespace autocuts::energy;
using namespace autocuts::homotopy;

namespace {

struct Case
{
    std::shared_ptr<const Soup> soup;
    std::vector<double> x; //!< distorted, positively oriented
};

Case distortedCase(const test::MeshPtr &mesh, double amount, unsigned seed)
{
    Case result;
    result.soup = Soup::build(mesh);
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.start = StartMode::Random;
    snapshot.settings.seed = seed;
    result.x = initialUv(*result.soup, snapshot);
    Random random(seed + 100);
    // Moves corners by a part of the size of their triangle and takes back what folds it.
    for (int t = 0; t < result.soup->triangleCount(); ++t) {
        double *p = &result.x[6 * static_cast<std::size_t>(t)];
        const std::vector<double> before(p, p + 6);
        const double size = std::hypot(p[2] - p[0], p[3] - p[1]);
        for (int i = 0; i < 6; ++i)
            p[i] += amount * size * random.uniform(-1, 1);
        if (!(jacobianDeterminant(*result.soup, result.x.data(), t) > 0.2))
            std::copy(before.begin(), before.end(), p);
    }
    return result;
}

std::vector<double> gradientOf(const EnergyTerm &term, const Soup &soup, const std::vector<double> &x,
                               HessianBlocks *blocks = nullptr)
{
    HessianBlocks local;
    HessianBlocks &b = blocks ? *blocks : local;
    b.resize(soup.triangleCount(), static_cast<int>(soup.pairCorners.size()));
    std::vector<double> gradient(x.size(), 0.0);
    term.addDerivatives(x, gradient, b);
    return gradient;
}

//! Largest error of the gradient against central differences, relative to the largest entry.
double gradientError(const EnergyTerm &term, const Soup &soup, const std::vector<double> &x, double h)
{
    const std::vector<double> gradient = gradientOf(term, soup, x);
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        std::vector<double> y = x;
        y[i] = x[i] + h;
        const double up = term.value(y);
        y[i] = x[i] - h;
        const double down = term.value(y);
        error = std::max(error, std::abs((up - down) / (2 * h) - gradient[i]));
        largest = std::max(largest, std::abs(gradient[i]));
    }
    return largest > 0 ? error / largest : error;
}

Eigen::Matrix<double, 6, 6> unpacked(const std::array<double, 21> &packed)
{
    Eigen::Matrix<double, 6, 6> m;
    int at = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j)
            m(i, j) = m(j, i) = packed[at++];
    }
    return m;
}

//! The Hessian of one triangle's part of a distortion term by central differences of its gradient.
Eigen::Matrix<double, 6, 6> differenceHessian(const EnergyTerm &term, const Soup &soup,
                                              const std::vector<double> &x, int t, double h)
{
    Eigen::Matrix<double, 6, 6> m;
    for (int j = 0; j < 6; ++j) {
        std::vector<double> y = x;
        const std::size_t at = 6 * static_cast<std::size_t>(t);
        y[at + j] = x[at + j] + h;
        const std::vector<double> up = gradientOf(term, soup, y);
        y[at + j] = x[at + j] - h;
        const std::vector<double> down = gradientOf(term, soup, y);
        for (int i = 0; i < 6; ++i)
            m(i, j) = (up[at + i] - down[at + i]) / (2 * h);
    }
    return m;
}

//! Coordinates of a triangle to its Jacobian, row by row.
Eigen::Matrix<double, 4, 6> jacobianMap(const Soup::Basis &b)
{
    Eigen::Matrix<double, 4, 6> map = Eigen::Matrix<double, 4, 6>::Zero();
    for (int k = 0; k < 3; ++k) {
        for (int row = 0; row < 2; ++row) {
            for (int column = 0; column < 2; ++column)
                map(2 * row + column, 2 * k + row) = b[2 * k + column];
        }
    }
    return map;
}

//! The Hessian with the part in the Jacobian's four coordinates replaced by the nearest positive semidefinite
//! matrix, found by eigenvalues: what the closed form must equal.
Eigen::Matrix<double, 6, 6> projected(const Eigen::Matrix<double, 6, 6> &hessian, const Soup::Basis &basis)
{
    const Eigen::Matrix<double, 4, 6> map = jacobianMap(basis);
    const Eigen::Matrix4d inverse = (map * map.transpose()).inverse();
    const Eigen::Matrix4d inner = inverse * map * hessian * map.transpose() * inverse;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(0.5 * (inner + inner.transpose()));
    return map.transpose() * eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
           eigen.eigenvectors().transpose() * map;
}

} // namespace

class TestEnergy : public QObject
{
    Q_OBJECT

private:
    void addMeshes()
    {
        QTest::addColumn<int>("mesh");
        QTest::newRow("quad cube") << 0;
        QTest::newRow("bulged grid") << 1;
        QTest::newRow("sphere") << 2;
        QTest::newRow("sphere with texel weights") << 3;
    }
    Case makeCase(int mesh, double amount = 0.35)
    {
        const test::MeshPtr sphere = test::sphere(5, 7);
        std::vector<double> weights;
        for (int face = 0; face < sphere->faceCount(); ++face)
            weights.push_back(face % 3 == 0 ? 2.5 : face % 3 == 1 ? 1 : 0.4);
        const test::MeshPtr meshes[] = {test::quadCube(), test::grid(3, 0.4), sphere,
                                        withTexelWeights(sphere, weights)};
        return distortedCase(meshes[mesh], amount, 7 + mesh);
    }

private Q_SLOTS:
    void distortionGradient_data()
    {
        QTest::addColumn<int>("mesh");
        QTest::addColumn<int>("kind");
        for (int mesh = 0; mesh < 4; ++mesh) {
            QTest::addRow("symmetric Dirichlet %d", mesh) << mesh << 0;
            QTest::addRow("AMIPS %d", mesh) << mesh << 1;
        }
    }
    void distortionGradient()
    {
        QFETCH(int, mesh);
        QFETCH(int, kind);
        const Case c = makeCase(mesh);
        const auto term = makeDistortionTerm(c.soup, static_cast<DistortionEnergy>(kind));
        term->setFactor(1.7);
        QVERIFY(gradientError(*term, *c.soup, c.x, 1e-6) < 1e-6);
    }

    void distortionHessianIsTheProjectedOne_data() { distortionGradient_data(); }
    void distortionHessianIsTheProjectedOne()
    {
        QFETCH(int, mesh);
        QFETCH(int, kind);
        const Case c = makeCase(mesh);
        const auto term = makeDistortionTerm(c.soup, static_cast<DistortionEnergy>(kind));
        HessianBlocks blocks;
        gradientOf(*term, *c.soup, c.x, &blocks);
        int indefinite = 0;
        for (int t = 0; t < c.soup->triangleCount(); ++t) {
            const Eigen::Matrix<double, 6, 6> exact = differenceHessian(*term, *c.soup, c.x, t, 1e-5);
            const Eigen::Matrix<double, 6, 6> expected = projected(exact, c.soup->basis[t]);
            const Eigen::Matrix<double, 6, 6> closed = unpacked(blocks.triangle[t]);
            QVERIFY2((closed - expected).norm() <= 1e-5 * expected.norm(),
                     qPrintable(QStringLiteral("triangle %1: %2 of %3")
                                    .arg(t)
                                    .arg((closed - expected).norm())
                                    .arg(expected.norm())));
            indefinite += (exact - expected).norm() > 1e-3 * exact.norm();
        }
        // The projection must have had something to do somewhere, else this tests only half of it.
        QVERIFY(indefinite > 0);
    }

    void isometryIsTheMinimum()
    {
        for (const DistortionEnergy kind : {DistortionEnergy::SymmetricDirichlet, DistortionEnergy::Amips}) {
            const Case c = makeCase(2, 0);
            const auto term = makeDistortionTerm(c.soup, kind);
            QVERIFY(std::abs(term->value(c.x) - 4) < 1e-9);
            for (const double g : gradientOf(*term, *c.soup, c.x))
                QVERIFY(std::abs(g) < 1e-9);
        }
    }

    void conformalEnergyForgivesScaleMoreThanShape()
    {
        // Stretching by k in both directions against stretching by k in one and 1 / k in the other.
        const double k = 1.5;
        QVERIFY(AmipsDensity::value(k, k) < AmipsDensity::value(k, 1 / k));
        const double symmetricRatio =
            (SymmetricDirichletDensity::value(k, k) - 4) / (SymmetricDirichletDensity::value(k, 1 / k) - 4);
        const double amipsRatio = (AmipsDensity::value(k, k) - 4) / (AmipsDensity::value(k, 1 / k) - 4);
        QVERIFY(amipsRatio < 0.5 * symmetricRatio);
    }

    void flippedTriangleHasInfiniteEnergy()
    {
        Case c = makeCase(0);
        std::swap(c.x[0], c.x[2]);
        std::swap(c.x[1], c.x[3]);
        const auto term = makeDistortionTerm(c.soup, DistortionEnergy::SymmetricDirichlet);
        QCOMPARE(term->value(c.x), std::numeric_limits<double>::infinity());
        QCOMPARE(symmetricDirichlet(*c.soup, c.x)[0], std::numeric_limits<double>::infinity());
        QVERIFY(std::isfinite(symmetricDirichlet(*c.soup, c.x)[1]));
    }

    void separationGradient_data() { addMeshes(); }
    void separationGradient()
    {
        QFETCH(int, mesh);
        const Case c = makeCase(mesh);
        for (const double delta : {1.0, 0.1, 0.01}) {
            SeparationTerm term(c.soup);
            term.setFactor(0.8);
            term.setDelta(delta);
            Snapshot snapshot;
            snapshot.mesh = c.soup->mesh;
            term.setWeights(pairWeights(*c.soup, snapshot));
            QVERIFY(gradientError(term, *c.soup, c.x, 1e-6 * std::sqrt(delta)) < 1e-6);
        }
    }

    void separationSpringsAreAMajoriser_data() { addMeshes(); }
    void separationSpringsAreAMajoriser()
    {
        // The quadratic that the springs describe touches the energy at x and is never below it.
        QFETCH(int, mesh);
        const Case c = makeCase(mesh);
        SeparationTerm term(c.soup);
        term.setFactor(1);
        term.setDelta(0.05);
        Snapshot snapshot;
        snapshot.mesh = c.soup->mesh;
        term.setWeights(pairWeights(*c.soup, snapshot));
        HessianBlocks blocks;
        const std::vector<double> gradient = gradientOf(term, *c.soup, c.x, &blocks);
        Random random(5);
        for (int trial = 0; trial < 50; ++trial) {
            std::vector<double> y = c.x;
            double model = term.value(c.x);
            for (std::size_t i = 0; i < y.size(); ++i) {
                const double d = random.uniform(-0.3, 0.3);
                y[i] += d;
                model += gradient[i] * d;
            }
            for (std::size_t p = 0; p < c.soup->pairCorners.size(); ++p) {
                const auto [a, b] = c.soup->pairCorners[p];
                for (int axis = 0; axis < 2; ++axis) {
                    const double d =
                        (y[2 * a + axis] - c.x[2 * a + axis]) - (y[2 * b + axis] - c.x[2 * b + axis]);
                    model += 0.5 * blocks.pair[p] * d * d;
                }
            }
            QVERIFY(term.value(y) <= model + 1e-12);
        }
    }

    void separationOfAFarPairIsItsLength()
    {
        const auto mesh = test::grid(1);
        const auto soup = Soup::build(mesh);
        SeparationTerm term(soup);
        term.setFactor(1);
        term.setDelta(1e-12);
        std::vector<double> weights(soup->pairLength.size());
        for (std::size_t p = 0; p < weights.size(); ++p)
            weights[p] = soup->pairLength[p];
        term.setWeights(weights);
        std::vector<double> x(soup->coordinateCount());
        for (int t = 0; t < soup->triangleCount(); ++t) {
            for (int i = 0; i < 6; ++i)
                x[6 * t + i] = soup->restShape[t][i] + 10 * t;
        }
        QVERIFY(std::abs(term.value(x) - soup->pairLength[0]) < 1e-9);
    }

    void pairWeightsFollowTheSteering()
    {
        const auto mesh = test::quadCube();
        const auto soup = Soup::build(mesh);
        Snapshot snapshot;
        snapshot.mesh = mesh;
        Steering &steering = snapshot.editSteering();
        steering.pairState.assign(mesh->cornerPairCount(), PairState::Free);
        steering.pairWeight.assign(mesh->cornerPairCount(), 1.0);
        int edge = 0;
        while (mesh->edgePairs[edge].diagonal)
            ++edge;
        steering.pairState[2 * edge] = PairState::Cut;
        steering.pairState[2 * edge + 1] = PairState::Joined;
        int painted = edge + 1;
        while (mesh->edgePairs[painted].diagonal)
            ++painted;
        steering.pairWeight[2 * painted] = 3;
        const std::vector<double> weights = pairWeights(*soup, snapshot);
        QCOMPARE(weights[2 * edge], 0.0);
        QCOMPARE(weights[2 * edge + 1], 100 * soup->pairLength[2 * edge + 1]);
        QCOMPARE(weights[2 * painted], 3 * soup->pairLength[2 * painted]);
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            if (mesh->edgePairs[e].diagonal)
                QCOMPARE(weights[2 * e], 100 * soup->pairLength[2 * e]);
        }
        snapshot.settings.weighting = SeamWeighting::Count;
        QCOMPARE(pairWeights(*soup, snapshot)[2 * painted + 1], soup->meanEdgeLength);
    }

    void pinGradientAndHessian()
    {
        const Case c = makeCase(1);
        const PinTerm term({{0, Vec2(0.3, -0.2), false, 2.0}, {5, Vec2(-1, 1), false, 0.5}});
        QVERIFY(gradientError(term, *c.soup, c.x, 1e-5) < 1e-8);
        HessianBlocks blocks;
        gradientOf(term, *c.soup, c.x, &blocks);
        QCOMPARE(blocks.ground[0], 2.0);
        QCOMPARE(blocks.ground[11], 0.5);
        QCOMPARE(blocks.ground[4], 0.0);
    }

    void boxGradientAndHessian()
    {
        const Case c = makeCase(1);
        std::vector<int> corners;
        for (int i = 0; i < c.soup->mesh->soupCornerCount(); i += 2)
            corners.push_back(i);
        UvRectangle box;
        box.lower = Vec2(-0.2, -0.3);
        box.upper = Vec2(0.4, 0.1);
        box.soupCorners = corners;
        const BoxTerm term({box}, 100);
        QVERIFY(gradientError(term, *c.soup, c.x, 1e-6) < 1e-5);
        HessianBlocks blocks;
        gradientOf(term, *c.soup, c.x, &blocks);
        for (const int corner : corners) {
            const double u = c.x[2 * corner];
            QCOMPARE(blocks.ground[2 * corner], u < -0.2 || u > 0.4 ? 200.0 : 0.0);
        }
        QCOMPARE(blocks.ground[2], 0.0); // corner 1 is not in the box's list
        // Inside nothing is felt.
        UvRectangle wide = box;
        wide.lower = Vec2(-100, -100);
        wide.upper = Vec2(100, 100);
        QCOMPARE(BoxTerm({wide}, 100).value(c.x), 0.0);
        UvRectangle hard = box;
        hard.hard = true;
        hard.weight = 0.5;
        QVERIFY(std::abs(BoxTerm({hard}, 100).value(c.x) / term.value(c.x) - 50) < 1e-9);
    }

    void flipFreeStepStopsAtTheFlip()
    {
        const auto soup = Soup::build(test::triangle());
        const auto &s = soup->restShape[0];
        const std::vector<double> x(s.begin(), s.end());
        std::vector<double> move(6, 0.0);
        move[5] = -s[5]; // the top corner falls onto the base: flat at step 1
        QVERIFY(std::abs(maxFlipFreeStep(*soup, x, move, 10) - 1) < 1e-12);
        move[5] = s[5];
        QCOMPARE(maxFlipFreeStep(*soup, x, move, 10), 10.0);
        move.assign(6, 3.0);
        QCOMPARE(maxFlipFreeStep(*soup, x, move, 10), 10.0);
        // Shrinking about the origin: the area has a double root at step 1.
        for (int i = 0; i < 6; ++i)
            move[i] = -x[i];
        QVERIFY(std::abs(maxFlipFreeStep(*soup, x, move, 10) - 1) < 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestEnergy)

} // namespace tst_energy

#include "tst_energy.moc"
