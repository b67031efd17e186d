// The multifrontal solver against the general one, on matrices of several shapes.
#include "solver/base/random.h"
#include "solver/linear/cholmodsolver.h"
#include "solver/linear/frontalsolver.h"

#include <QTest>

#include <stdexcept>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tst_frontal {

using namespace autocuts;
using namespace autocuts::linear;

namespace {

//! Lower triangle of a positive definite matrix of 2 x 2 blocks over the given edges, numbered at random.
LinearSolver::Matrix blockMatrix(int nodes, const std::vector<std::pair<int, int>> &edges, unsigned seed)
{
    Random random(seed);
    std::vector<int> number(nodes);
    for (int i = 0; i < nodes; ++i)
        number[i] = i;
    for (int i = nodes - 1; i > 0; --i)
        std::swap(number[i], number[random.below(i + 1)]);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, double value) {
        if (row >= column)
            entries.emplace_back(row, column, value);
    };
    // A random symmetric 4 x 4 block per edge, made definite by its own diagonal.
    for (const auto &[a, b] : edges) {
        const int place[4] = {2 * number[a], 2 * number[a] + 1, 2 * number[b], 2 * number[b] + 1};
        double sum[4] = {0, 0, 0, 0};
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                const double value = random.uniform(-1, 1);
                add(place[i], place[j], value);
                add(place[j], place[i], value);
                sum[i] += std::abs(value);
                sum[j] += std::abs(value);
            }
        }
        for (int i = 0; i < 4; ++i)
            add(place[i], place[i], sum[i]);
    }
    for (int i = 0; i < 2 * nodes; ++i)
        add(i, i, 0.01);
    for (int i = 0; i < nodes; ++i)
        add(2 * i + 1, 2 * i, 0);
    LinearSolver::Matrix matrix(2 * nodes, 2 * nodes);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

std::vector<std::pair<int, int>> edgesOf(const QString &shape, int &nodes)
{
    std::vector<std::pair<int, int>> edges;
    if (shape == QLatin1String("one node")) {
        nodes = 1;
    } else if (shape == QLatin1String("path")) {
        nodes = 50;
        for (int i = 1; i < nodes; ++i)
            edges.emplace_back(i - 1, i);
    } else if (shape == QLatin1String("star")) {
        nodes = 60;
        for (int i = 1; i < nodes; ++i)
            edges.emplace_back(0, i);
    } else if (shape == QLatin1String("dense")) {
        nodes = 45;
        for (int i = 0; i < nodes; ++i) {
            for (int j = 0; j < i; ++j)
                edges.emplace_back(i, j);
        }
    } else {
        // Triangulated grids, one or three of them side by side.
        const int side = 40, parts = shape == QLatin1String("grid") ? 1 : 3;
        nodes = parts * side * side;
        for (int v = 0; v < nodes; ++v) {
            const int x = v % side, y = v / side % side;
            if (x + 1 < side)
                edges.emplace_back(v, v + 1);
            if (y + 1 < side)
                edges.emplace_back(v, v + side);
            if (x + 1 < side && y + 1 < side)
                edges.emplace_back(v, v + side + 1);
        }
    }
    return edges;
}

//! In the order of elimination that the general library proposes for the nodes.
LinearSolver::Matrix ordered(const LinearSolver::Matrix &lower)
{
    const int nodes = static_cast<int>(lower.rows()) / 2;
    std::vector<Eigen::Triplet<double>> graph, entries;
    for (int k = 0; k < lower.outerSize(); ++k) {
        for (LinearSolver::Matrix::InnerIterator it(lower, k); it; ++it)
            graph.emplace_back(it.row() / 2, it.col() / 2, 1.0);
    }
    LinearSolver::Matrix pattern(nodes, nodes);
    pattern.setFromTriplets(graph.begin(), graph.end());
    const std::vector<int> rank = eliminationRanks(pattern);
    for (int k = 0; k < lower.outerSize(); ++k) {
        for (LinearSolver::Matrix::InnerIterator it(lower, k); it; ++it) {
            const int row = 2 * rank[it.row() / 2] + static_cast<int>(it.row() % 2);
            const int column = 2 * rank[it.col() / 2] + static_cast<int>(it.col() % 2);
            entries.emplace_back(std::max(row, column), std::min(row, column), it.value());
        }
    }
    // Off the diagonal, both halves of a block are wanted.
    LinearSolver::Matrix result(lower.rows(), lower.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

Eigen::VectorXd rightHand(Eigen::Index size)
{
    Random random(5);
    Eigen::VectorXd b(size);
    for (Eigen::Index i = 0; i < size; ++i)
        b[i] = random.uniform(-1, 1);
    return b;
}

} // namespace

class TestFrontal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void solvesLikeTheGeneralSolver_data()
    {
        QTest::addColumn<QString>("shape");
        for (const char *shape : {"one node", "path", "star", "dense", "grid", "three grids"})
            QTest::newRow(shape) << QString::fromLatin1(shape);
    }
    void solvesLikeTheGeneralSolver()
    {
        QFETCH(QString, shape);
        int nodes = 0;
        const auto edges = edgesOf(shape, nodes);
        const LinearSolver::Matrix matrix = ordered(blockMatrix(nodes, edges, 3));
        const Eigen::VectorXd b = rightHand(matrix.rows());
        CholmodSolver general;
        general.analyze(matrix, LinearSolver::Order::Natural);
        QVERIFY(general.factorize(matrix));
        Eigen::VectorXd expected;
        general.solve(b, expected);
        for (const int threads : {1, 3}) {
            ThreadTeam team(threads);
            FrontalSolver frontal(team);
            frontal.analyze(matrix, LinearSolver::Order::Natural);
            Eigen::VectorXd x;
            // Twice: the second factorisation must not see the first.
            for (int i = 0; i < 2; ++i) {
                QVERIFY(frontal.factorize(matrix));
                frontal.solve(b, x);
                const double error = (x - expected).norm() / expected.norm();
                QVERIFY2(error < 1e-3, qPrintable(QString::number(error)));
            }
        }
    }

    void threadsDoNotChangeTheBits()
    {
        int nodes = 0;
        const auto edges = edgesOf(QStringLiteral("grid"), nodes);
        const LinearSolver::Matrix matrix = ordered(blockMatrix(nodes, edges, 4));
        const Eigen::VectorXd b = rightHand(matrix.rows());
        Eigen::VectorXd first;
        for (const int threads : {1, 2, 5}) {
            ThreadTeam team(threads);
            FrontalSolver frontal(team);
            frontal.analyze(matrix, LinearSolver::Order::Natural);
            QVERIFY(frontal.factorize(matrix));
            Eigen::VectorXd x;
            frontal.solve(b, x);
            if (first.size() == 0)
                first = x;
            QVERIFY(x == first);
        }
    }

    //! A live solve factorises thirty times a second for as long as it runs.
    void memoryDoesNotGrow_data()
    {
        QTest::addColumn<QString>("shape");
        for (const char *shape : {"grid", "three grids"})
            QTest::newRow(shape) << QString::fromLatin1(shape);
    }
    void memoryDoesNotGrow()
    {
#if defined(__GLIBC__) && !defined(AUTOCUTS_SANITIZED)
        QFETCH(QString, shape);
        int nodes = 0;
        const auto edges = edgesOf(shape, nodes);
        const LinearSolver::Matrix matrix = ordered(blockMatrix(nodes, edges, 3));
        ThreadTeam team;
        FrontalSolver frontal(team);
        frontal.analyze(matrix, LinearSolver::Order::Natural);
        const auto inUse = [&](int times) {
            for (int i = 0; i < times; ++i) {
                if (!frontal.factorize(matrix))
                    return std::size_t(0);
            }
            const struct mallinfo2 info = mallinfo2();
            return info.uordblks + info.hblkhd;
        };
        const std::size_t before = inUse(5), after = inUse(100);
        QVERIFY(before > 0 && after > 0);
        // Memory is used again in another order each time, so that some of it still grows.
        QVERIFY2(after < before + before / 2,
                 qPrintable(QStringLiteral("%1 bytes, then %2").arg(before).arg(after)));
#else
        QSKIP("this library of C does not tell how much memory is in use");
#endif
    }

    void indefiniteMatricesAreRefused()
    {
        int nodes = 0;
        const auto edges = edgesOf(QStringLiteral("grid"), nodes);
        LinearSolver::Matrix matrix = ordered(blockMatrix(nodes, edges, 3));
        ThreadTeam team;
        FrontalSolver frontal(team);
        frontal.analyze(matrix, LinearSolver::Order::Natural);
        matrix.coeffRef(40, 40) -= 50;
        QVERIFY(!frontal.factorize(matrix));
        matrix.coeffRef(40, 40) += 50;
        QVERIFY(frontal.factorize(matrix));
        Eigen::VectorXd x;
        const Eigen::VectorXd b = rightHand(matrix.rows());
        frontal.solve(b, x);
        const LinearSolver::Matrix full = matrix.selfadjointView<Eigen::Lower>();
        QVERIFY((full * x - b).norm() < 1e-3 * b.norm());
    }

    void otherPatternsAreRefused()
    {
        ThreadTeam team;
        FrontalSolver frontal(team);
        const LinearSolver::Matrix matrix = ordered(blockMatrix(4, {{0, 1}, {1, 2}}, 1));
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                                 frontal.analyze(matrix, LinearSolver::Order::FillReducing));
        LinearSolver::Matrix odd(3, 3);
        odd.setIdentity();
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, frontal.analyze(odd, LinearSolver::Order::Natural));
        LinearSolver::Matrix holes(4, 4);
        holes.setIdentity();
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, frontal.analyze(holes, LinearSolver::Order::Natural));
    }
};

QTEST_APPLESS_MAIN(TestFrontal)

} // namespace tst_frontal

#include "tst_frontal.moc"
