// unfoldUnits(): what no seam may part and yet lies over itself, laid out flat.
#include "solver/definite/relaxing.h"
#include "solver/definite/unfolding.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tst_unfolding {

using namespace autocuts;
using namespace autocuts::definite;

namespace {

//! A mesh in the plane, laid out about its vertex 0: the others at a distance of 1, at the given angles. What
//! lies more than a full turn apart covers something else, without a flipped triangle.
struct Fan
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;
    SeamedMap map;

    //! \param degrees per vertex; that of vertex 0 counts nothing
    Fan(const std::vector<Vec3> &points, const std::vector<std::vector<int>> &faces,
        const std::vector<double> &degrees)
    {
        snapshot.mesh = test::polygonMesh(points, faces);
        soup = Soup::build(snapshot.mesh);
        map.cut.assign(mesh().edgePairs.size(), false);
        for (int c = 0; c < mesh().soupCornerCount(); ++c) {
            const int vertex = mesh().cornerVertex[mesh().cornerOfSoup(c)];
            const double angle = degrees[vertex] * std::numbers::pi / 180;
            const double radius = vertex == 0 ? 0 : 1;
            map.x.insert(map.x.end(), {radius * std::cos(angle), radius * std::sin(angle)});
        }
    }

    //! Two squares on top of each other with the common edge 0 1, and a third one on the right of the upper
    //! one. \param spread degrees that each of the two takes up about vertex 0
    static Fan threeSquares(double spread)
    {
        Fan fan({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}, {1, -1, 0}, {2, 0, 0}, {2, 1, 0}},
                {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 6, 7, 2}},
                {0, 0, spread / 2, spread, -spread, -spread / 2, 0, 0});
        // The third one is somewhere else, as large as it should be.
        const MeshData &mesh = fan.mesh();
        for (int c = 0; c < mesh.soupCornerCount(); ++c) {
            if (mesh.triangleFace[c / 3] != 2)
                continue;
            const Vec3 p = mesh.cornerPosition(mesh.cornerOfSoup(c)) * fan.soup->scale;
            fan.map.x[2 * static_cast<std::size_t>(c)] = p.x() + 10;
            fan.map.x[2 * static_cast<std::size_t>(c) + 1] = p.y();
        }
        fan.map.cut[fan.edgeOf(0, 2)] = true;
        return fan;
    }

    const MeshData &mesh() const { return *snapshot.mesh; }
    std::size_t edgeOf(int face, int other) const
    {
        const auto &pairs = mesh().edgePairs;
        for (std::size_t e = 0; e < pairs.size(); ++e) {
            const int a = mesh().triangleFace[pairs[e].triangle[0]],
                      b = mesh().triangleFace[pairs[e].triangle[1]];
            if ((a == face && b == other) || (a == other && b == face))
                return e;
        }
        qFatal("the faces %d and %d have no common edge", face, other);
    }
    void join(std::size_t edge)
    {
        snapshot.editSteering().pairState.resize(mesh().cornerPairCount(), PairState::Free);
        snapshot.editSteering().pairState[2 * edge] = snapshot.editSteering().pairState[2 * edge + 1] =
            PairState::Joined;
    }
    //! How far the four corners of a face are from a square, as part of its side.
    double squareError(int face) const
    {
        std::vector<Vec2> corners(4);
        for (int c = 0; c < mesh().soupCornerCount(); ++c) {
            const auto i = 2 * static_cast<std::size_t>(c);
            if (mesh().triangleFace[c / 3] == face)
                corners[mesh().cornerOfSoup(c) - mesh().faceStart[face]] = {map.x[i], map.x[i + 1]};
        }
        // A square is what two of its neighbouring corners say.
        const Vec2 side = corners[1] - corners[0], up(-side.y(), side.x());
        return std::max((corners[3] - corners[0] - up).norm(), (corners[2] - corners[1] - up).norm()) /
               side.norm();
    }
    //! The coordinates of a face's corners.
    std::vector<double> coordinatesOf(int face) const
    {
        std::vector<double> result;
        for (int t = 0; t < mesh().triangleCount(); ++t) {
            if (mesh().triangleFace[t] == face)
                result.insert(result.end(), map.x.begin() + 6 * t, map.x.begin() + 6 * (t + 1));
        }
        return result;
    }
};

} // namespace

class TestUnfolding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aJoinedPairComesOutFlat()
    {
        Fan fan = Fan::threeSquares(200);
        fan.join(fan.edgeOf(0, 1));
        QCOMPARE(fan.map.validate(*fan.soup), std::string());
        QVERIFY(coversItself(*fan.soup, fan.map));
        const std::vector<double> third = fan.coordinatesOf(2);
        const CutFlags cut = fan.map.cut;
        unfoldUnits(*fan.soup, fan.snapshot, fan.map);
        QCOMPARE(fan.map.validate(*fan.soup), std::string());
        QVERIFY(!coversItself(*fan.soup, fan.map));
        QVERIFY(fan.map.cut == cut); // together still
        for (const int face : {0, 1})
            QVERIFY2(fan.squareError(face) < 0.01, qPrintable(QString::number(fan.squareError(face))));
        QCOMPARE(fan.coordinatesOf(2), third);
    }

    void aPolygonComesOutFlat()
    {
        // A hexagon about one of its corners.
        std::vector<Vec3> points;
        for (int k = 0; k < 6; ++k)
            points.emplace_back(std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3), 0);
        Fan fan(points, {{0, 1, 2, 3, 4, 5}}, {0, 0, 100, 200, 300, 400});
        QCOMPARE(fan.map.validate(*fan.soup), std::string());
        QVERIFY(coversItself(*fan.soup, fan.map));
        unfoldUnits(*fan.soup, fan.snapshot, fan.map);
        QCOMPARE(fan.map.validate(*fan.soup), std::string());
        QVERIFY(!coversItself(*fan.soup, fan.map));
        QVERIFY2(fan.map.distortion(*fan.soup) < 4.001,
                 qPrintable(QString::number(fan.map.distortion(*fan.soup), 'g', 8)));
    }

    void itBecomesAChartOfItsOwn()
    {
        // A free square hangs on one of the two that are joined.
        Fan fan({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, 0, 0}},
                {{0, 1, 2, 3}, {0, 4, 5, 1}, {0, 3, 6, 7}}, {0, 0, 100, 200, -200, -100, 210, 220});
        fan.join(fan.edgeOf(0, 1));
        QCOMPARE(fan.map.validate(*fan.soup), std::string());
        QVERIFY(coversItself(*fan.soup, fan.map));
        const std::vector<double> free = fan.coordinatesOf(2);
        unfoldUnits(*fan.soup, fan.snapshot, fan.map);
        QCOMPARE(fan.map.validate(*fan.soup), std::string());
        for (std::size_t e = 0; e < fan.map.cut.size(); ++e)
            QCOMPARE(fan.map.cut[e], e == fan.edgeOf(0, 2));
        QCOMPARE(fan.coordinatesOf(2), free);
    }

    void whatIsNotKeptTogetherIsLeftAlone_data()
    {
        QTest::addColumn<double>("spread");
        QTest::addColumn<bool>("joined");
        QTest::newRow("an overlap that a seam can part") << 200. << false;
        QTest::newRow("no overlap") << 170. << true;
    }
    void whatIsNotKeptTogetherIsLeftAlone()
    {
        QFETCH(double, spread);
        QFETCH(bool, joined);
        Fan fan = Fan::threeSquares(spread);
        if (joined)
            fan.join(fan.edgeOf(0, 1));
        const SeamedMap before = fan.map;
        QCOMPARE(coversItself(*fan.soup, before), !joined);
        unfoldUnits(*fan.soup, fan.snapshot, fan.map);
        QVERIFY(fan.map.x == before.x);
        QVERIFY(fan.map.cut == before.cut);
    }
};

QTEST_APPLESS_MAIN(TestUnfolding)

} // namespace tst_unfolding

#include "tst_unfolding.moc"
