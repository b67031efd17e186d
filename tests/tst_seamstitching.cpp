// Stitching seams of maps: islands come to each other, seams are zipped, nothing folds or covers itself.
#include "model/plain/uvseams.h"
#include "solver/definite/ripping.h"
#include "solver/definite/seamfitting.h"
#include "solver/definite/seamstitching.h"
#include "solver/overlap/overlapfinder.h"
#include "support/mapedits.h"

#include <QTest>

#include <numbers>

namespace tst_seamstitching {

using namespace autocuts;
using namespace autocuts::definite;
using test::edgesWhere;
using test::flatMap;
using test::snapshotOf;

namespace {

constexpr int size = 8;

//! Edges of the grid on the line x = column / size, in the rows [first, end).
std::vector<int> columnEdges(const MeshData &mesh, int column, int first = 0, int end = size)
{
    return edgesWhere(mesh, [=](const Vec3 &p, const Vec3 &q) {
        const double x = double(column) / size, y = 0.5 * (p.y() + q.y()) * size;
        return std::abs(p.x() - x) < 1e-9 && std::abs(q.x() - x) < 1e-9 && y > first && y < end;
    });
}

//! Changes the UVs of the faces in the columns [first, end).
template <typename Change>
void changeColumns(const MeshData &mesh, int first, int end, UvMatrix &uv, Change change)
{
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1] && f % size >= first && f % size < end; ++c)
            uv.row(c) = change(Vec2(uv.row(c).transpose())).transpose();
    }
}

//! The two sides of each edge have the same bits.
bool areClosed(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &edges)
{
    return std::all_of(edges.begin(), edges.end(), [&](int e) {
        return std::all_of(mesh.edgePairs[e].corner.begin(), mesh.edgePairs[e].corner.end(), [&](auto &ends) {
            return uv.row(mesh.cornerOfSoup(ends[0])) == uv.row(mesh.cornerOfSoup(ends[1]));
        });
    });
}

int countOpen(const MeshData &mesh, const UvMatrix &uv, const std::vector<int> &edges)
{
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    return static_cast<int>(
        std::count_if(edges.begin(), edges.end(), [&](int e) { return open[2 * e] || open[2 * e + 1]; }));
}

//! Triangles that do not lie as those of a map that is not mirrored.
int turnedOver(const MeshData &mesh, const UvMatrix &uv)
{
    int count = 0;
    for (const auto &t : mesh.triangles)
        count += !(cross2(uv.row(t[0]).transpose(), uv.row(t[1]).transpose(), uv.row(t[2]).transpose()) > 0);
    return count;
}

bool isFreeOfOverlaps(const MeshData &mesh, const UvMatrix &uv)
{
    return overlap::findOverlaps(soupUv(mesh, uv)).pairs.empty();
}

Vec2 turned(const Vec2 &p, double angle, double scale, const Vec2 &move)
{
    return scale * (Eigen::Rotation2Dd(angle) * p) + move;
}

//! A saddle of equilateral triangles around a vertex, laid out one after the other from the right: more than
//! a full turn.
struct Saddle
{
    static constexpr int count = 7;
    test::MeshPtr mesh;
    UvMatrix uv;

    //! \param apart the last of the triangles lies aside
    Saddle()
    {
        std::vector<Vec3> points{{0, 0, 0}};
        std::vector<std::vector<int>> faces;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            points.emplace_back(std::cos(angle), std::sin(angle), i % 2 ? 0.6 : -0.6);
            faces.push_back({0, 1 + i, 1 + (i + 1) % count});
        }
        mesh = test::polygonMesh(points, faces);
        uv.resize(mesh->cornerCount(), 2);
        for (int i = 0; i < count; ++i) {
            const Vec2 move = i + 1 < count ? Vec2(0, 0) : Vec2(3, 0);
            const double step = std::numbers::pi / 3;
            uv.row(3 * i) = move.transpose();
            uv.row(3 * i + 1) = (move + Vec2(std::cos(i * step), std::sin(i * step))).transpose();
            uv.row(3 * i + 2) = (move + Vec2(std::cos((i + 1) * step), std::sin((i + 1) * step))).transpose();
        }
        // The turn is not quite full, so that the first and the last of the six are apart.
        uv.row(17) += Eigen::RowVector2d(0, -0.05);
    }
    //! The edge between two triangles.
    int edge(int a, int b) const
    {
        for (int e = 0; e < static_cast<int>(mesh->edgePairs.size()); ++e) {
            const auto [s, t] = mesh->edgePairs[e].triangle;
            if (std::minmax({mesh->triangleFace[s], mesh->triangleFace[t]}) == std::minmax({a, b}))
                return e;
        }
        return -1;
    }
};

} // namespace

class TestSeamStitching : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void similaritiesFit()
    {
        const std::vector<Vec2> points{{0, 0}, {1, 0.5}, {0.3, 2}, {-1, 1}};
        std::vector<PointMatch> matches;
        for (const Vec2 &p : points)
            matches.push_back({turned(p, 2, 3, {5, -1}), p, 1 + p.x() * p.x()});
        const SimilarMotion motion = fitSimilar(matches);
        QVERIFY(std::abs(motion.scale() - 3) < 1e-12);
        for (const PointMatch &match : matches)
            QVERIFY((motion(match.moving) - match.fixed).norm() < 1e-12);
        // Least squares: every change of the scale is worse.
        matches[0].fixed += Vec2(0.4, 0.1);
        const auto error = [&](const SimilarMotion &m) {
            double sum = 0;
            for (const PointMatch &match : matches)
                sum += match.weight * (m(match.moving) - match.fixed).squaredNorm();
            return sum;
        };
        const SimilarMotion best = fitSimilar(matches);
        for (const double change : {-1e-3, 1e-3}) {
            SimilarMotion other = best;
            other.c += change;
            QVERIFY(error(other) > error(best));
            other = best;
            other.s += change;
            QVERIFY(error(other) > error(best));
            other = best;
            other.shift.x() += change;
            QVERIFY(error(other) > error(best));
        }
        const SimilarMotion still = fitSimilar({{{1, 2}, {3, 4}, 1}});
        QVERIFY(still.scale() == 1 && still({3, 4}) == Vec2(1, 2));
    }

    void edgesThatFitAreFound()
    {
        std::vector<EdgeMatch> edges;
        for (int i = 0; i < 9; ++i) {
            const Vec2 a(i, 0.1 * i * i), b(i + 1, 0.1 * (i + 1) * (i + 1));
            edges.push_back(
                {PointMatch{turned(a, 1, 0.5, {2, 2}), a, 1}, PointMatch{turned(b, 1, 0.5, {2, 2}), b, 1}});
        }
        QVERIFY(fitLoosely(edges));
        QCOMPARE(fittingEdges(edges).size(), edges.size());
        QVERIFY(touchingEdges(edges).empty());
        // Some belong elsewhere.
        for (const int i : {1, 4, 5})
            edges[i][0].fixed += Vec2(3, -2);
        QVERIFY(!fitLoosely(edges));
        QCOMPARE(fittingEdges(edges), (std::vector<int>{0, 2, 3, 6, 7, 8}));
        QCOMPARE(exactEdges(edges), (std::vector<int>{0, 2, 3, 6, 7, 8}));
        // Few that fit exactly are found among many that do not.
        std::vector<EdgeMatch> others = edges;
        for (int i = 0; i < 9; ++i)
            others[i][0].fixed += i == 3 || i == 7 ? Vec2(0, 0) : Vec2(0.1 + 0.01 * i, 0.2 - 0.03 * i * i);
        QCOMPARE(exactEdges(others), (std::vector<int>{3, 7}));
        QVERIFY(exactEdges({others[0], others[3], others[4]}).empty());
        // Two edges, and a small share, would fit anywhere.
        QVERIFY(fittingEdges({edges[0], edges[2], edges[1]}).empty());
        edges[2][0].fixed = edges[2][0].moving;
        edges[2][1].fixed = edges[2][1].moving + Vec2(0.01, 0);
        QCOMPARE(touchingEdges(edges), std::vector<int>{2});
    }

    void theSmallerIslandComes_data()
    {
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("scale");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("moved") << 0.0 << 1.0 << false;
        QTest::newRow("turned") << 2.5 << 1.0 << false;
        QTest::newRow("larger") << 0.0 << 1.2 << false;
        QTest::newRow("turned and smaller") << -1.0 << 0.4 << false;
        QTest::newRow("mirrored") << 0.7 << 0.8 << true;
    }

    void theSmallerIslandComes()
    {
        QFETCH(double, angle);
        QFETCH(double, scale);
        QFETCH(bool, mirrored);
        const auto mesh = test::grid(size);
        const UvMatrix whole = flatMap(*mesh, 0.5, {0.2, 0.2});
        UvMatrix uv = whole;
        changeColumns(*mesh, 5, size, uv, [&](Vec2 p) {
            if (mirrored)
                p.x() = -p.x();
            return turned(p, angle, scale, {1.5, 0.3});
        });
        const std::vector<int> seam = columnEdges(*mesh, 5);
        QCOMPARE(countOpen(*mesh, uv, seam), size);
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), seam);
        QCOMPARE(made.edges, seam);
        QVERIFY(made.refused.empty());
        QVERIFY((made.uv - whole).cwiseAbs().maxCoeff() < 1e-12);
        QVERIFY(areClosed(*mesh, made.uv, seam));
        QCOMPARE(findCharts(*mesh, made.uv).count, 1);
        QCOMPARE(turnedOver(*mesh, made.uv), 0);
        // The larger one stays to the last bit.
        UvMatrix rest = made.uv;
        changeColumns(*mesh, 5, size, rest, [](const Vec2 &) { return Vec2(0, 0); });
        UvMatrix before = uv;
        changeColumns(*mesh, 5, size, before, [](const Vec2 &) { return Vec2(0, 0); });
        QVERIFY(rest == before);
        QVERIFY(stitchSeams(snapshotOf(mesh, uv), seam).uv == made.uv);
    }

    void seamsThatDoNotFitAreSewnInTheMiddle()
    {
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        changeColumns(*mesh, 5, size, uv,
                      [](const Vec2 &p) { return Vec2(p.x() + 0.5 + 0.02 * std::sin(12 * p.y()), p.y()); });
        const std::vector<int> seam = columnEdges(*mesh, 5);
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), seam);
        QCOMPARE(made.edges, seam);
        QVERIFY(areClosed(*mesh, made.uv, seam));
        QCOMPARE(turnedOver(*mesh, made.uv), 0);
        QVERIFY(isFreeOfOverlaps(*mesh, made.uv));
        // Away from the seam the larger island stays.
        UvMatrix rest = made.uv;
        changeColumns(*mesh, 4, size, rest, [](const Vec2 &) { return Vec2(0, 0); });
        changeColumns(*mesh, 4, size, uv, [](const Vec2 &) { return Vec2(0, 0); });
        QVERIFY(rest == uv);
    }

    void otherSeamsStayOpen()
    {
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        changeColumns(*mesh, 5, size, uv, [](const Vec2 &p) { return Vec2(p + Vec2(0.5, 0)); });
        const std::vector<int> given = columnEdges(*mesh, 5, 0, 3), others = columnEdges(*mesh, 5, 3, size);
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), given);
        QCOMPARE(made.edges, given);
        QVERIFY(areClosed(*mesh, made.uv, given));
        QCOMPARE(countOpen(*mesh, made.uv, others), size - 3);
        QCOMPARE(findCharts(*mesh, made.uv).count, 1);
        QCOMPARE(turnedOver(*mesh, made.uv), 0);
        QVERIFY(isFreeOfOverlaps(*mesh, made.uv));
    }

    void slitsAreZipped()
    {
        const auto mesh = test::grid(size, 0.3);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const std::vector<int> slit = columnEdges(*mesh, 4, 2, 6);
        const RippedMap ripped = ripEdges(snapshotOf(mesh, uv), slit, 0.01);
        QCOMPARE(countOpen(*mesh, ripped.uv, slit), 4);
        const StitchedMap made = stitchSeams(snapshotOf(mesh, ripped.uv), slit);
        QCOMPARE(made.edges, slit);
        QVERIFY(areClosed(*mesh, made.uv, slit));
        QVERIFY((made.uv - uv).cwiseAbs().maxCoeff() < 1e-6);
    }

    //! A dart: the faces right of a slit from the border are turned away about its end.
    void dartsAreZippedByRelaxing()
    {
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const Vec2 end(0.2 + 0.25, 0.2 + 0.25);
        for (int f = 0; f < mesh->faceCount(); ++f) {
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c) {
                const Vec2 p = uv.row(c).transpose() - end;
                // By an angle that falls from the slit below the end to nothing above it.
                double angle = std::atan2(p.x(), -p.y());
                if (angle == 0 && f % size < 4)
                    angle = -0.0;
                const double share = 1 - std::abs(angle) / std::numbers::pi;
                const bool right = angle > 0 || (angle == 0 && f % size >= 4);
                if (p.norm() > 0)
                    uv.row(c) = (end + Eigen::Rotation2Dd((right ? 0.4 : -0.4) * share) * p).transpose();
            }
        }
        QCOMPARE(turnedOver(*mesh, uv), 0);
        const std::vector<int> slit = columnEdges(*mesh, 4, 0, 4);
        QCOMPARE(countOpen(*mesh, uv, slit), 4);
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), slit);
        QCOMPARE(made.edges, slit);
        QVERIFY(areClosed(*mesh, made.uv, slit));
        QCOMPARE(turnedOver(*mesh, made.uv), 0);
        QVERIFY(isFreeOfOverlaps(*mesh, made.uv));
        // The grid is flat, so that the whole gets nearer to it.
        const UvMatrix flat = flatMap(*mesh, 0.5, {0.2, 0.2});
        QVERIFY((made.uv - flat).norm() < 0.5 * (uv - flat).norm());
    }

    void whatWouldCoverItselfIsRefused()
    {
        const Saddle saddle;
        const int seam = saddle.edge(5, 6);
        const StitchedMap made = stitchSeams(snapshotOf(saddle.mesh, saddle.uv), {seam});
        QVERIFY(made.edges.empty());
        QCOMPARE(made.refused.size(), std::size_t(1));
        QCOMPARE(made.refused.at(SewOutcome::Covers), 1);
        QVERIFY(sameBits(made.uv, saddle.uv));
    }

    void locksAndPinsHold_data()
    {
        QTest::addColumn<bool>("lockLeft");
        QTest::addColumn<bool>("lockRight");
        QTest::addColumn<bool>("pin");
        QTest::addColumn<int>("moves"); // 0: none, 1: the larger one at the left, 2: the right one
        QTest::newRow("free") << false << false << false << 2;
        QTest::newRow("larger locked") << true << false << false << 2;
        QTest::newRow("smaller locked") << false << true << false << 1;
        QTest::newRow("both locked") << true << true << false << 0;
        QTest::newRow("smaller pinned") << false << false << true << 1;
        QTest::newRow("one locked, one pinned") << true << false << true << 0;
    }

    void locksAndPinsHold()
    {
        QFETCH(bool, lockLeft);
        QFETCH(bool, lockRight);
        QFETCH(bool, pin);
        QFETCH(int, moves);
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        changeColumns(*mesh, 5, size, uv,
                      [](const Vec2 &p) { return Vec2(p.x() + 0.5 + 0.01 * std::sin(9 * p.y()), p.y()); });
        Snapshot snapshot = snapshotOf(mesh, uv);
        Steering &steering = snapshot.editSteering();
        steering.faceFlags.assign(mesh->faceCount(), {});
        steering.faceFlags[0].locked = lockLeft;
        steering.faceFlags[size - 1].locked = lockRight;
        if (pin)
            steering.pins.push_back({3 * mesh->faceTriangle[size - 1], Vec2::Zero(), true, 1});
        const std::vector<int> seam = columnEdges(*mesh, 5);
        const StitchedMap made = stitchSeams(snapshot, seam);
        if (moves == 0) {
            QCOMPARE(made.refused.at(SewOutcome::Held), size);
            QVERIFY(made.uv == uv);
            return;
        }
        QVERIFY(areClosed(*mesh, made.uv, seam));
        const bool leftHeld = lockLeft, rightHeld = lockRight || pin;
        int changedLeft = 0, changedRight = 0;
        for (int f = 0; f < mesh->faceCount(); ++f) {
            for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c)
                (f % size < 5 ? changedLeft : changedRight) += made.uv.row(c) != uv.row(c);
        }
        QVERIFY(!leftHeld || changedLeft == 0);
        QVERIFY(!rightHeld || changedRight == 0);
        QCOMPARE(moves == 2, changedRight == 4 * size * 3);
        QCOMPARE(moves == 1, changedLeft == 4 * size * 5);
        QCOMPARE(turnedOver(*mesh, made.uv), 0);
    }

    void zipsRespectLocksAndPins()
    {
        const auto mesh = test::grid(size);
        UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        const std::vector<int> slit = columnEdges(*mesh, 4, 0, 3);
        uv = ripEdges(snapshotOf(mesh, uv), slit, 0.01).uv;
        Snapshot locked = snapshotOf(mesh, uv);
        locked.editSteering().faceFlags.assign(mesh->faceCount(), {1, 0, 0});
        QCOMPARE(stitchSeams(locked, slit).refused.at(SewOutcome::Held), 3);
        // A pin at the border, left of the slit.
        const int face = 3, corner = mesh->faceStart[face] + 1;
        Snapshot pinned = snapshotOf(mesh, uv);
        for (const int s : mesh->soupCornersOf(face)) {
            if (mesh->cornerOfSoup(s) == corner)
                pinned.editSteering().pins.push_back({s, Vec2::Zero(), true, 1});
        }
        const StitchedMap made = stitchSeams(pinned, slit);
        QCOMPARE(made.edges, slit);
        QVERIFY(made.uv.row(corner) == uv.row(corner));
        QVERIFY(areClosed(*mesh, made.uv, slit));
    }

    //! Four strips, the second of which is the largest island, and a slit in it.
    void severalSeamsAtOnce()
    {
        const auto mesh = test::grid(size);
        const UvMatrix whole = flatMap(*mesh, 0.5, {0.2, 0.2});
        UvMatrix uv = whole;
        changeColumns(*mesh, 0, 2, uv, [](const Vec2 &p) { return turned(p, 1, 0.7, {3, 0}); });
        changeColumns(*mesh, 5, 7, uv, [](const Vec2 &p) { return turned(p, 2, 1.1, {6, 0}); });
        changeColumns(*mesh, 7, 8, uv, [](const Vec2 &p) { return turned(p, 3, 1.5, {9, 0}); });
        uv = ripEdges(snapshotOf(mesh, uv), columnEdges(*mesh, 3, 2, 5), 0.01).uv;
        std::vector<int> seams;
        for (const int column : {1, 2, 3, 5, 7}) {
            const std::vector<int> edges = columnEdges(*mesh, column);
            seams.insert(seams.end(), edges.begin(), edges.end());
        }
        std::sort(seams.begin(), seams.end());
        const int open = countOpen(*mesh, uv, seams);
        QCOMPARE(open, 3 * size + 3);
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), seams);
        QCOMPARE(made.edges.size(), std::size_t(open));
        QVERIFY(made.refused.empty());
        QCOMPARE(findCharts(*mesh, made.uv).count, 1);
        QVERIFY(areClosed(*mesh, made.uv, seams));
        QVERIFY((made.uv - whole).cwiseAbs().maxCoeff() < 1e-6);
    }

    void noSeamsNothingToDo()
    {
        const auto mesh = test::grid(size);
        const UvMatrix uv = flatMap(*mesh, 0.5, {0.2, 0.2});
        std::vector<int> all = edgesWhere(*mesh, [](const Vec3 &, const Vec3 &) { return true; });
        all.push_back(static_cast<int>(mesh->edgePairs.size())); // a side on the boundary
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), all);
        QVERIFY(made.edges.empty() && made.refused.empty());
        QVERIFY(made.uv == uv);
    }

    void partsOfASphere_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"cube", "quad cube", "sphere", "torus", "dirty"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    //! Every face on its own, all seams stitched: what is closed is valid.
    void partsOfASphere()
    {
        QFETCH(QString, name);
        const auto mesh = test::meshNamed(name);
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int f = 0; f < mesh->faceCount(); ++f) {
            const int first = mesh->faceStart[f];
            const Vec3 o = mesh->cornerPosition(first), a = mesh->cornerPosition(first + 1) - o;
            const Vec3 x = a.normalized(),
                       n = a.cross(Vec3(mesh->cornerPosition(first + 2) - o)).normalized();
            for (int c = first; c < mesh->faceStart[f + 1]; ++c) {
                const Vec3 p = mesh->cornerPosition(c) - o;
                uv.row(c) = Vec2(p.dot(x) + 10 * f, p.dot(n.cross(x))).transpose();
            }
        }
        const std::vector<int> all = edgesWhere(*mesh, [](const Vec3 &, const Vec3 &) { return true; });
        const StitchedMap made = stitchSeams(snapshotOf(mesh, uv), all);
        QVERIFY(!made.edges.empty());
        QVERIFY(areClosed(*mesh, made.uv, made.edges));
        QVERIFY(findCharts(*mesh, made.uv).count < mesh->faceCount());
        QCOMPARE(test::flippedIn(*mesh, uv, made.uv), 0);
    }
};

QTEST_GUILESS_MAIN(TestSeamStitching)

} // namespace tst_seamstitching

#include "tst_seamstitching.moc"
