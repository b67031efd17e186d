// What stitchSoup() and stitchTo() join and what they leave apart, on soups of a few quads laid out by hand.
#include "solver/definite/stitching.h"
#include "support/meshbuilders.h"

#include <Eigen/Geometry>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace tst_stitching {

using namespace autocuts;
using namespace autocuts::definite;

namespace {

constexpr double delta = 0.01; //!< half separated are corners that are 0.1 apart

Vec2 at(const std::vector<double> &x, int soupCorner)
{
    const auto i = 2 * static_cast<std::size_t>(soupCorner);
    return {x[i], x[i + 1]};
}

//! Quads side by side in the plane, with what a solver would know about them.
struct Patch
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;

    explicit Patch(test::MeshPtr mesh)
    {
        snapshot.mesh = std::move(mesh);
        snapshot.settings.delta = delta;
        soup = Soup::build(snapshot.mesh);
    }
    //! Two unit squares with one common edge from (1, 0) to (1, 1).
    static Patch twoQuads()
    {
        return Patch(test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                                       {{0, 1, 4, 3}, {1, 2, 5, 4}}));
    }

    const MeshData &mesh() const { return *snapshot.mesh; }
    int faceOf(int soupCorner) const { return mesh().triangleFace[soupCorner / 3]; }
    int vertexOf(int soupCorner) const { return mesh().cornerVertex[mesh().cornerOfSoup(soupCorner)]; }
    //! The edge of two faces.
    std::size_t edgeOf(int face, int other) const
    {
        const auto &pairs = mesh().edgePairs;
        for (std::size_t e = 0; e < pairs.size(); ++e) {
            const int a = mesh().triangleFace[pairs[e].triangle[0]],
                      b = mesh().triangleFace[pairs[e].triangle[1]];
            if (std::min(a, b) == std::min(face, other) && std::max(a, b) == std::max(face, other) && a != b)
                return e;
        }
        qFatal("the faces %d and %d have no common edge", face, other);
    }
    void decide(std::size_t edge, PairState state)
    {
        snapshot.editSteering().pairState.resize(mesh().cornerPairCount(), PairState::Free);
        snapshot.editSteering().pairState[2 * edge] = snapshot.editSteering().pairState[2 * edge + 1] = state;
    }
    //! Every face at its place, moved by a map that depends on the face.
    std::vector<double> laidOut(const std::function<Vec2(int face, const Vec2 &place)> &moved) const
    {
        std::vector<double> x;
        for (int c = 0; c < mesh().soupCornerCount(); ++c) {
            const Vec3 p = mesh().cornerPosition(mesh().cornerOfSoup(c)) * soup->scale;
            const Vec2 at = moved(faceOf(c), p.head<2>());
            x.insert(x.end(), {at.x(), at.y()});
        }
        return x;
    }
    //! The second of two quads moved aside by a distance.
    std::vector<double> withGap(double gap) const
    {
        return laidOut([gap](int face, const Vec2 &p) { return Vec2(p.x() + face * gap, p.y()); });
    }
    //! The corners of each vertex are in one place, to the last bit, and that is the mean of where they were.
    void verifyAveraged(const std::vector<double> &before, const std::vector<double> &after) const
    {
        const auto vertices = static_cast<int>(mesh().positions.rows());
        for (int vertex = 0; vertex < vertices; ++vertex) {
            Vec2 sum = Vec2::Zero();
            std::vector<int> corners;
            for (int c = 0; c < mesh().soupCornerCount(); ++c) {
                if (vertexOf(c) == vertex) {
                    sum += at(before, c);
                    corners.push_back(c);
                }
            }
            for (const int c : corners) {
                QCOMPARE(at(after, c), at(after, corners.front()));
                QVERIFY((at(after, c) - sum / double(corners.size())).norm() < 1e-12);
            }
        }
    }
};

} // namespace

class TestStitching : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nearPairsJoin_data()
    {
        QTest::addColumn<double>("gap"); // of half separated ones
        QTest::addColumn<PairState>("state");
        QTest::addColumn<bool>("joins");
        QTest::newRow("nearer than half separated") << 0.99 << PairState::Free << true;
        QTest::newRow("farther than that") << 1.01 << PairState::Free << false;
        QTest::newRow("cut, and in one place") << 0.0 << PairState::Cut << false;
        QTest::newRow("cut, and near") << 0.5 << PairState::Cut << false;
        QTest::newRow("joined, and far apart") << 6.0 << PairState::Joined << true;
        QTest::newRow("joined, and one upon the other") << -6.0 << PairState::Joined << true;
    }
    void nearPairsJoin()
    {
        QFETCH(double, gap);
        QFETCH(PairState, state);
        QFETCH(bool, joins);
        Patch patch = Patch::twoQuads();
        const std::size_t edge = patch.edgeOf(0, 1);
        patch.decide(edge, state);
        const std::vector<double> x = patch.withGap(gap * std::sqrt(delta));
        const SeamedMap map = stitchSoup(patch.soup, patch.snapshot, x);
        QCOMPARE(map.validate(*patch.soup), std::string());
        QCOMPARE(map.cut[edge], !joins);
        if (!joins) {
            QVERIFY(map.x == x);
            return;
        }
        patch.verifyAveraged(x, map.x);
    }

    void oneEndThatIsFarKeepsAnEdgeOpen()
    {
        // The second quad is turned about the lower end of the common edge.
        const Patch patch = Patch::twoQuads();
        const Vec2 end(patch.soup->scale, 0);
        const Eigen::Rotation2Dd turn(-0.3);
        const std::vector<double> x = patch.laidOut(
            [&](int face, const Vec2 &p) { return face == 0 ? p : Vec2(end + turn * Vec2(p - end)); });
        const SeamedMap map = stitchSoup(patch.soup, patch.snapshot, x);
        QVERIFY(map.cut[patch.edgeOf(0, 1)]);
        QVERIFY(map.x == x);
    }

    void cornersOfOneVertexGetOnePlace()
    {
        // Four quads about a vertex, each moved a little in its own direction.
        const Patch patch(test::grid(2));
        const std::vector<double> x = patch.laidOut([](int face, const Vec2 &p) {
            return Vec2(p + 0.02 * Vec2(std::cos(2 * face), std::sin(3 * face)));
        });
        const SeamedMap map = stitchSoup(patch.soup, patch.snapshot, x);
        QCOMPARE(map.validate(*patch.soup), std::string());
        QVERIFY(std::find(map.cut.begin(), map.cut.end(), true) == map.cut.end());
        patch.verifyAveraged(x, map.x);
    }

    void aSlitStaysOpenAtItsBorderAndClosesAtItsTip()
    {
        // The cut goes from the middle of the lower border to the middle.
        const Patch patch(test::grid(2));
        const std::size_t edge = patch.edgeOf(0, 1);
        CutFlags cut(patch.mesh().edgePairs.size(), false);
        cut[edge] = true;
        const double shift = 0.02;
        const std::vector<double> x = patch.laidOut(
            [&](int face, const Vec2 &p) { return Vec2(p.x() + (face % 2 ? shift : -shift), p.y()); });
        const SeamedMap map = stitchTo(patch.soup, patch.snapshot, cut, x);
        QCOMPARE(map.validate(*patch.soup), std::string());
        QVERIFY(map.cut == cut);
        const double middle = 0.5 * patch.soup->scale;
        for (int c = 0; c < patch.mesh().soupCornerCount(); ++c) {
            const Vec2 place = at(map.x, c);
            if (patch.vertexOf(c) == 1) // the border's end
                QVERIFY(std::abs(place.x() - middle - (patch.faceOf(c) == 1 ? shift : -shift)) < 1e-12);
            else if (patch.vertexOf(c) == 4) // the tip
                QVERIFY(std::abs(place.x() - middle) < 0.5 * shift && std::abs(place.y() - middle) < 1e-12);
        }
    }

    //! One edge inside a patch, cut: both its ends are held together all around it.
    void aCutThatOpensNothingIsDropped()
    {
        Patch patch(test::grid(3));
        const std::size_t edge = patch.edgeOf(3, 4); // its ends are the inner vertices 5 and 9
        patch.decide(edge, PairState::Cut);
        const std::vector<double> x = patch.laidOut([](int, const Vec2 &p) { return p; });
        const SeamedMap map = stitchSoup(patch.soup, patch.snapshot, x);
        QVERIFY(std::find(map.cut.begin(), map.cut.end(), true) == map.cut.end());
        QCOMPARE(map.seamLength(*patch.soup), 0.);
    }

    //! Half way between the ends of the common edge the second quad would be turned inside out.
    void whatWouldFoldIsPulledTogether_data()
    {
        QTest::addColumn<double>("degrees");
        for (const int degrees : {100, 150, 180, 200, 270})
            QTest::addRow("%d", degrees) << double(degrees);
    }
    void whatWouldFoldIsPulledTogether()
    {
        QFETCH(double, degrees);
        Patch patch = Patch::twoQuads();
        const std::size_t edge = patch.edgeOf(0, 1);
        patch.decide(edge, PairState::Joined);
        const Vec2 middle = patch.soup->scale * Vec2(1.5, 0.5);
        const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
        const std::vector<double> x = patch.laidOut(
            [&](int face, const Vec2 &p) { return face == 0 ? p : Vec2(middle + turn * Vec2(p - middle)); });
        SeamedMap map = stitchSoup(patch.soup, patch.snapshot, x);
        QCOMPARE(map.validate(*patch.soup), std::string());
        QVERIFY(!map.cut[edge]);
        relaxMap(patch.soup, patch.snapshot, map, 50);
        QVERIFY2(map.distortion(*patch.soup) < 4 + 1e-6,
                 qPrintable(QString::number(map.distortion(*patch.soup), 'g', 10)));
    }

    //! The six squares of a cube, each on its own: a closed surface has no map without a seam.
    void whatCannotJoinStaysCut()
    {
        const Patch patch(test::quadCube());
        std::vector<double> x;
        for (const auto &shape : patch.soup->restShape)
            x.insert(x.end(), shape.begin(), shape.end());
        const SeamedMap map =
            stitchTo(patch.soup, patch.snapshot, CutFlags(patch.mesh().edgePairs.size(), false), x);
        QCOMPARE(map.validate(*patch.soup), std::string());
        QVERIFY(std::count(map.cut.begin(), map.cut.end(), true) >= 2);
        for (std::size_t e = 0; e < map.cut.size(); ++e) {
            if (map.cut[e])
                continue;
            for (const auto &[a, b] : patch.mesh().edgePairs[e].corner)
                QCOMPARE(at(map.x, a), at(map.x, b));
        }
    }
};

QTEST_APPLESS_MAIN(TestStitching)

} // namespace tst_stitching

#include "tst_stitching.moc"
