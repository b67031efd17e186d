// Charts (UV islands) and the disjoint sets behind them.
#include "model/plain/chart.h"
#include "model/plain/unionfind.h"
#include "model/plain/uvseams.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <set>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tst_chart {

using namespace autocuts;

namespace {

//! UVs that are the x and y of the corners' positions.
UvMatrix planarUv(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = mesh.cornerPosition(c).head<2>().transpose();
    return uv;
}

} // namespace

class TestChart : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unionFindDoesNotDependOnTheOrder()
    {
        UnionFind forwards(8), backwards(8);
        const std::vector<std::pair<int, int>> unions{{6, 7}, {1, 2}, {2, 6}, {4, 5}, {5, 4}};
        for (const auto &[a, b] : unions)
            forwards.unite(a, b);
        for (auto it = unions.rbegin(); it != unions.rend(); ++it)
            backwards.unite(it->second, it->first);
        const auto expected = std::pair(std::vector<int>{0, 1, 1, 2, 3, 3, 1, 1}, 4);
        QVERIFY(forwards.labels() == expected);
        QVERIFY(backwards.labels() == expected);
        QVERIFY(!forwards.unite(7, 1));
        QVERIFY(forwards.unite(0, 7));
        QCOMPARE(forwards.find(7), 0);
        QVERIFY(UnionFind(0).labels() == std::pair(std::vector<int>{}, 0));
    }

    void oneSheetIsOneChart()
    {
        const auto mesh = test::grid(4);
        const ChartMap charts = findCharts(*mesh, planarUv(*mesh));
        QCOMPARE(charts.count, 1);
        QVERIFY(charts.faceChart == std::vector<int>(16, 0));
    }

    //! Corner pairs are open by the same distance that parts charts.
    void openPairsFollowTheRuleOfCharts()
    {
        const auto mesh = test::grid(4);
        UvMatrix uv = planarUv(*mesh);
        const double tolerance = uvTolerance * std::sqrt(2); // the diagonal of the map's box
        const auto moved = [&](double distance) {
            UvMatrix result = uv;
            for (int f = 0; f < 4; ++f) {
                for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c)
                    result.row(c) -= Eigen::RowVector2d::Constant(distance / std::sqrt(2));
            }
            return result;
        };
        const auto countOpen = [&](const UvMatrix &map) {
            const std::vector<bool> open = openCornerPairs(*mesh, map);
            return std::count(open.begin(), open.end(), true);
        };
        QCOMPARE(findCharts(*mesh, moved(0.9 * tolerance)).count, 1);
        QCOMPARE(countOpen(moved(0.9 * tolerance)), 0);
        // Each coordinate differs by less than the tolerance here.
        QCOMPARE(findCharts(*mesh, moved(1.1 * tolerance)).count, 2);
        QCOMPARE(countOpen(moved(1.1 * tolerance)), 8);
        // A face without UVs has no neighbour in the map.
        uv.topRows(mesh->faceStart[1]).setConstant(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(countOpen(uv), 4);
    }

    void cutSeparatesChartsInFaceOrder()
    {
        const auto mesh = test::grid(4);
        UvMatrix uv = planarUv(*mesh);
        for (int f = 0; f < mesh->faceCount(); ++f) {
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c)
                uv(c, 0) += f % 4 < 2 ? 5 : 0; // the left half moves away
        }
        const ChartMap charts = findCharts(*mesh, uv);
        QCOMPARE(charts.count, 2);
        QVERIFY(charts.faces()[0] == (std::vector<int>{0, 1, 4, 5, 8, 9, 12, 13}));
        QVERIFY(charts.faces()[1] == (std::vector<int>{2, 3, 6, 7, 10, 11, 14, 15}));
    }

    void sidesCanBeSeamsWhateverTheirUvs()
    {
        const auto mesh = test::grid(4);
        const UvMatrix uv = planarUv(*mesh);
        std::vector<bool> apart(mesh->cornerCount(), false);
        const auto cut = [&](int face) { // the right side of a face, seen from both faces
            apart[mesh->faceStart[face] + 1] = apart[mesh->faceStart[face + 1] + 3] = true;
        };
        // A slit: one island, in which the vertex between the two edges is there twice.
        const auto vertices = [&] {
            const UvTopology topology = findUvTopology(*mesh, uv, apart);
            return std::set<int>(topology.cornerRoot.begin(), topology.cornerRoot.end()).size();
        };
        const std::size_t before = vertices();
        cut(5);
        QCOMPARE(vertices(), before);
        cut(9);
        QCOMPARE(vertices(), before + 1);
        QCOMPARE(findUvTopology(*mesh, uv, apart).charts.count, 1);
        cut(1);
        cut(13);
        QCOMPARE(vertices(), before + 5);
        QVERIFY(findUvTopology(*mesh, uv, apart).charts.faces()[0] ==
                (std::vector<int>{0, 1, 4, 5, 8, 9, 12, 13}));
    }

    void halfCutEdgeDoesNotJoin()
    {
        // Two triangles that agree at one end of their common edge only.
        const auto mesh =
            test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}});
        UvMatrix uv = planarUv(*mesh);
        QCOMPARE(findCharts(*mesh, uv).count, 1);
        uv(4, 0) += 0.1;
        QCOMPARE(findCharts(*mesh, uv).count, 2);
    }

    void toleranceIsAMillionthOfTheBox_data()
    {
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 1e-150, 1e150, 1e300})
            QTest::addRow("%g", scale) << scale;
    }

    void toleranceIsAMillionthOfTheBox()
    {
        QFETCH(double, scale);
        const auto mesh =
            test::polygonMesh({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}});
        for (const auto &[shift, count] : {std::pair(4.9e-6, 1), std::pair(5.1e-6, 2)}) {
            UvMatrix uv = planarUv(*mesh); // the diagonal of the box is 5
            uv(4, 0) -= shift;
            QCOMPARE(findCharts(*mesh, scale * uv).count, count);
        }
    }

    void faceWithoutUvHasNoChart()
    {
        const auto mesh = test::grid(3);
        UvMatrix uv = planarUv(*mesh);
        uv(mesh->faceStart[4] + 2, 1) = std::numeric_limits<double>::quiet_NaN();
        uv(mesh->faceStart[5], 0) = std::numeric_limits<double>::infinity();
        const ChartMap charts = findCharts(*mesh, uv);
        QCOMPARE(charts.faceChart[4], -1);
        QCOMPARE(charts.faceChart[5], -1);
        QCOMPARE(charts.count, 1);
        uv.setConstant(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(findCharts(*mesh, uv).count, 0);
    }

    void nonManifoldSheetsJoinWhereTheirUvsAgree()
    {
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                            {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
        UvMatrix uv = planarUv(*mesh);
        QCOMPARE(findCharts(*mesh, uv).count, 1);
        uv.row(6).array() += 1; // the fin leaves
        QCOMPARE(findCharts(*mesh, uv).count, 2);
    }
};

QTEST_APPLESS_MAIN(TestChart)

} // namespace tst_chart

#include "tst_chart.moc"
