// The systems of single triangles in the preconditioner against dense inverses.
#include "solver/base/random.h"
#include "solver/newton/hubkernels.h"

#include <Eigen/Dense>

#include <QTest>

#include <vector>

namespace tst_hubkernels {

using namespace autocuts;
using namespace autocuts::newton;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using EdgeMap = Eigen::Matrix<double, 4, 6>;

//! From u0 v0 u1 v1 u2 v2 to u1 - u0, u2 - u0, v1 - v0, v2 - v0.
EdgeMap edgeMap()
{
    EdgeMap e = EdgeMap::Zero();
    for (int axis = 0; axis < 2; ++axis) {
        for (int k = 0; k < 2; ++k) {
            e(2 * axis + k, axis) = -1;
            e(2 * axis + k, 2 * (k + 1) + axis) = 1;
        }
    }
    return e;
}

} // namespace

class TestHubKernels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! A block of eight triangles without partners, each corner tied to its own hub by one spring.
    void trianglesAreSolved_data()
    {
        QTest::addColumn<double>("spring");
        QTest::addColumn<int>("rank");
        QTest::addColumn<bool>("held");
        for (const double spring : {0.0, 1e-3, 1.0, 30.0, 1e4}) {
            for (const int rank : {4, 3, 0})
                QTest::addRow("springs %g, rank %d", spring, rank) << spring << rank << false;
        }
        QTest::addRow("a corner held") << 1.0 << 4 << true;
        QTest::addRow("a corner held, soft springs") << 1e-3 << 3 << true;
    }
    void trianglesAreSolved()
    {
        QFETCH(double, spring);
        QFETCH(int, rank);
        QFETCH(bool, held);
        Random random(7);
        std::vector<EdgeMatrix, LaneAllocator<EdgeMatrix>> hessian(1);
        std::vector<Eigen::Matrix4d> dense(laneCount);
        for (int t = 0; t < laneCount; ++t) {
            Eigen::Matrix4d root = Eigen::Matrix4d::Zero();
            for (int i = 0; i < 4; ++i) {
                for (int j = 0; j < rank; ++j)
                    root(i, j) = random.uniform(-1, 1);
            }
            dense[t] = root * root.transpose();
            for (int i = 0, at = 0; i < 4; ++i) {
                for (int j = 0; j <= i; ++j)
                    hessian[0][at++][t] = static_cast<float>(dense[t](i, j));
            }
        }
        // One pair per corner, on its first side; entry 24 is that of the borders.
        std::vector<float> pairs(25);
        LinkInts numbers;
        LinkKinds kinds{};
        for (int i = 0; i < 6; ++i) {
            for (int t = 0; t < laneCount; ++t) {
                const int corner = 3 * t + i / 2;
                numbers[i][t] = i % 2 == 0 ? corner : 24;
                pairs[corner] = static_cast<float>(spring * (1 + corner % 3));
                kinds.within[t] |= i % 2 == 0 ? 1 << i : 0;
            }
        }
        LaneVector movable(6, Lanes{} + 1), residual(6), sum(6), search(6);
        const auto at = [](LaneVector &v, int corner, int axis) -> float & {
            return reinterpret_cast<float *>(v.data())[slotOf(corner) + axis];
        };
        for (int corner = 0; corner < 3 * laneCount; ++corner) {
            for (int axis = 0; axis < 2; ++axis) {
                at(residual, corner, axis) = static_cast<float>(random.uniform(-1, 1));
                at(movable, corner, axis) = held && corner % 3 == 1 ? 0 : 1;
            }
        }
        std::vector<LinkSprings, LaneAllocator<LinkSprings>> springs(1);
        std::vector<BlockInverse, LaneAllocator<BlockInverse>> inverses(1);
        prepareBlocks(hessian.data(), &numbers, &kinds, pairs.data(), nullptr,
                      held ? movable.data() : nullptr, springs.data(), inverses.data(), 0, 1);
        // With all hubs at rest the search direction is S^-1 r.
        const CornerInts hubs{};
        const float rest[2] = {0, 0};
        pullCorners(inverses.data(), &hubs, residual.data(), rest, nullptr, 0, 0, sum.data(), search.data(),
                    0, 1);
        for (int t = 0; t < laneCount; ++t) {
            Matrix6 system = edgeMap().transpose() * dense[t] * edgeMap();
            const double trace = system.trace();
            const double least = trace > 0 ? 1e-4 * trace : 1;
            Vector6 right, found;
            for (int i = 0; i < 6; ++i) {
                const int corner = 3 * t + i / 2;
                system(i, i) +=
                    double(pairs[corner]) + least + (held && corner % 3 == 1 ? 1e6 * (trace + 1) : 0);
                right(i) = at(residual, corner, i % 2);
                found(i) = at(search, corner, i % 2);
            }
            // In the norm of the system, in which the preconditioner counts.
            const Vector6 wrong = found - system.ldlt().solve(right);
            const double error = std::sqrt(wrong.dot(system * wrong) / right.dot(system.ldlt().solve(right)));
            QVERIFY2(error < 2e-3, qPrintable(QString::number(error)));
        }
    }
};

QTEST_APPLESS_MAIN(TestHubKernels)

} // namespace tst_hubkernels

#include "tst_hubkernels.moc"
