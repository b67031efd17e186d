// Cut meshes: labels and boundary loops, cuts without effect, cutting open to disks, Tutte's embedding of
// them.
#include "model/samples/samples.h"
#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"
#include "solver/search/tutte.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tst_cutmesh {

using namespace autocuts;
using namespace autocuts::search;

namespace {

//! An n x n grid without the faces of the given numbers.
test::MeshPtr gridWithHoles(int n, const std::set<int> &holes)
{
    const test::MeshPtr whole = test::grid(n, 0.2);
    std::vector<Vec3> points;
    for (Eigen::Index v = 0; v < whole->positions.rows(); ++v)
        points.emplace_back(whole->positions.row(v));
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < whole->faceCount(); ++f) {
        if (!holes.contains(f))
            faces.emplace_back(whole->cornerVertex.begin() + whole->faceStart[f],
                               whole->cornerVertex.begin() + whole->faceStart[f + 1]);
    }
    return test::polygonMesh(points, faces);
}

//! A sphere, a torus and a grid beside each other.
test::MeshPtr severalParts()
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    double shift = 0;
    for (const test::MeshPtr &part : {test::sphere(5, 6), test::torus(6, 5), test::grid(3)}) {
        const int first = static_cast<int>(points.size());
        for (Eigen::Index v = 0; v < part->positions.rows(); ++v)
            points.push_back(Vec3(part->positions.row(v)) + Vec3(shift, 0, 0));
        for (int f = 0; f < part->faceCount(); ++f) {
            faces.emplace_back();
            for (int c = part->faceStart[f]; c < part->faceStart[f + 1]; ++c)
                faces.back().push_back(first + part->cornerVertex[c]);
        }
        shift += 5;
    }
    return test::polygonMesh(points, faces);
}

test::MeshPtr cutMeshNamed(const QString &name)
{
    if (name == QLatin1String("one hole"))
        return gridWithHoles(5, {12});
    if (name == QLatin1String("holes that touch"))
        return gridWithHoles(6, {7, 14, 28});
    if (name == QLatin1String("parts"))
        return severalParts();
    if (name == QLatin1String("handles"))
        return makeSample(QStringLiteral("torus")).value().mesh;
    return test::meshNamed(name);
}

void addMeshes()
{
    QTest::addColumn<int>("components");
    QTest::newRow("triangle") << 1;
    QTest::newRow("cube") << 1;
    QTest::newRow("quad cube") << 1;
    QTest::newRow("sphere") << 1;
    QTest::newRow("torus") << 1;
    QTest::newRow("grid") << 1;
    QTest::newRow("one hole") << 1;
    QTest::newRow("holes that touch") << 1;
    QTest::newRow("parts") << 3;
    QTest::newRow("dirty") << -1;
    QTest::newRow("character") << 1;
    QTest::newRow("handles") << 1;
    QTest::newRow("machine") << 46;
}

//! Vertices - edges + triangles of each chart; 1 for a disk.
std::vector<int> eulerNumbers(const MeshData &mesh, const CutMesh &state)
{
    std::vector<int> euler(state.chartCount, 0);
    std::vector<bool> seen(state.uvVertexCount, false);
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        int &number = euler[state.chart[s / 3]];
        number += s % 3 == 0;                                       // the triangle
        number -= state.neighbour[s] < 0 || state.neighbour[s] > s; // each edge once
        number += !seen[state.uvVertex[s]];
        seen[state.uvVertex[s]] = true;
    }
    return euler;
}

//! The edge pair between two vertices; -1 when there is none.
int edgeBetween(const MeshData &mesh, int a, int b)
{
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const std::array<int, 2> ends{mesh.vertexOfSoup(mesh.edgePairs[e].corner[0][0]),
                                      mesh.vertexOfSoup(mesh.edgePairs[e].corner[1][0])};
        if (ends == std::array<int, 2>{a, b} || ends == std::array<int, 2>{b, a})
            return static_cast<int>(e);
    }
    return -1;
}

} // namespace

class TestCutMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutCutsTheLabelsAreTheMesh()
    {
        const auto mesh = test::cube();
        const CutMesh state(*mesh, CutFlags(mesh->edgePairs.size(), false));
        QCOMPARE(state.chartCount, 1);
        QCOMPARE(state.uvVertexCount, 8);
        QVERIFY(std::find(state.neighbour.begin(), state.neighbour.end(), -1) == state.neighbour.end());
        QVERIFY(state.boundaryLoops().empty());
    }

    void cutEverywhereTheLabelsAreTheSoup()
    {
        const auto mesh = test::cube();
        const CutMesh state(*mesh, CutFlags(mesh->edgePairs.size(), true));
        QCOMPARE(state.chartCount, 12);
        QCOMPARE(state.uvVertexCount, 36);
        QCOMPARE(static_cast<int>(state.boundaryLoops().size()), 12);
    }

    void neighboursAreMutualAndShareTheirVertices()
    {
        const auto mesh = test::torus(6, 5);
        CutFlags cut(mesh->edgePairs.size(), false);
        for (std::size_t e = 0; e < cut.size(); e += 4)
            cut[e] = !mesh->edgePairs[e].diagonal;
        const CutMesh state(*mesh, cut);
        int joined = 0;
        for (int s = 0; s < mesh->soupCornerCount(); ++s) {
            const int other = state.neighbour[s];
            if (other < 0)
                continue;
            ++joined;
            QCOMPARE(state.neighbour[other], s);
            const auto end = [](int side) { return side / 3 * 3 + (side + 1) % 3; };
            QCOMPARE(state.uvVertex[s], state.uvVertex[end(other)]);
            QCOMPARE(state.uvVertex[end(s)], state.uvVertex[other]);
            QCOMPARE(state.chart[s / 3], state.chart[other / 3]);
        }
        QCOMPARE(joined, 2 * static_cast<int>(std::count(cut.begin(), cut.end(), false)));
    }

    void boundaryLoopsGoAroundTheirChart()
    {
        // The border of a 4 x 4 grid, and the ring around a face that was taken out.
        const auto mesh = gridWithHoles(4, {5});
        const CutMesh state(*mesh, CutFlags(mesh->edgePairs.size(), false));
        const auto loops = state.boundaryLoops();
        QCOMPARE(static_cast<int>(loops.size()), 2);
        std::multiset<std::size_t> sizes;
        for (const auto &loop : loops) {
            sizes.insert(loop.size());
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int side = loop[i], next = loop[(i + 1) % loop.size()];
                QCOMPARE(state.neighbour[side], -1);
                QCOMPARE(state.uvVertex[side / 3 * 3 + (side + 1) % 3], state.uvVertex[next]);
            }
        }
        QCOMPARE(sizes, (std::multiset<std::size_t>{4, 16}));
    }

    void aLoneCutEdgeHasNoEffectAndIsDropped()
    {
        // Vertices of the 4 x 4 grid are 5 * row + column.
        const auto mesh = test::grid(4);
        CutFlags cut(mesh->edgePairs.size(), false);
        cut[edgeBetween(*mesh, 6, 7)] = true;
        dropClosedCuts(*mesh, cut);
        QCOMPARE(std::count(cut.begin(), cut.end(), true), 0);
    }

    void cutsWithAnEffectStay()
    {
        const auto mesh = test::grid(4);
        CutFlags cut(mesh->edgePairs.size(), false);
        cut[edgeBetween(*mesh, 6, 7)] = true; // two in a row: the vertex between them opens
        cut[edgeBetween(*mesh, 7, 8)] = true;
        cut[edgeBetween(*mesh, 2, 7)] = true;   // one more, from the border to that vertex
        cut[edgeBetween(*mesh, 16, 17)] = true; // alone
        const CutFlags before = cut;
        dropClosedCuts(*mesh, cut);
        QCOMPARE(std::count(cut.begin(), cut.end(), true), 3);
        QVERIFY(!cut[edgeBetween(*mesh, 16, 17)]);
        const CutMesh a(*mesh, before), b(*mesh, cut);
        QCOMPARE(a.uvVertex, b.uvVertex);
        QCOMPARE(a.chart, b.chart);
    }

    void cutToDisksGivesOneDiskPerComponent_data() { addMeshes(); }
    void cutToDisksGivesOneDiskPerComponent()
    {
        const auto mesh = cutMeshNamed(QString::fromLatin1(QTest::currentDataTag()));
        QFETCH(int, components);
        if (components >= 0)
            QCOMPARE(mesh->componentCount, components);
        const CutFlags cut = cutToDisks(*mesh);
        for (std::size_t e = 0; e < cut.size(); ++e)
            QVERIFY(!(cut[e] && mesh->edgePairs[e].diagonal));
        const CutMesh state(*mesh, cut);
        QCOMPARE(state.chartCount, mesh->componentCount);
        const std::vector<int> euler = eulerNumbers(*mesh, state);
        for (std::size_t i = 0; i < euler.size(); ++i)
            QVERIFY2(euler[i] == 1, qPrintable(QStringLiteral("chart %1: %2").arg(i).arg(euler[i])));
        QCOMPARE(static_cast<int>(state.boundaryLoops().size()), state.chartCount);
    }

    void disksAreNotCut()
    {
        for (const auto &mesh : {test::grid(5, 0.3), test::triangle()}) {
            const CutFlags cut = cutToDisks(*mesh);
            QCOMPARE(std::count(cut.begin(), cut.end(), true), 0);
        }
    }

    void aSphereIsCutALittleOnly()
    {
        const auto mesh = test::sphere(8, 10);
        const CutFlags cut = cutToDisks(*mesh);
        QCOMPARE(std::count(cut.begin(), cut.end(), true), 2);
    }

    void tutteMapsDisksWithoutAFlip_data()
    {
        QTest::addColumn<bool>("open"); // leave the holes: filled with a virtual vertex each
        for (const char *name : {"triangle", "cube", "quad cube", "sphere", "torus", "grid", "one hole",
                                 "parts", "dirty", "machine"})
            QTest::newRow(name) << true;
        QTest::newRow("one hole") << false;
        QTest::newRow("holes that touch") << false;
        QTest::newRow("grid") << false;
    }
    void tutteMapsDisksWithoutAFlip()
    {
        QFETCH(bool, open);
        const auto mesh = cutMeshNamed(QString::fromLatin1(QTest::currentDataTag()));
        const auto soup = Soup::build(mesh);
        const CutFlags cut = open ? cutToDisks(*mesh) : CutFlags(mesh->edgePairs.size(), false);
        const CutMesh state(*mesh, cut);
        const std::vector<double> x = tutteEmbedding(*soup, state);
        QCOMPARE(static_cast<int>(x.size()), soup->coordinateCount());
        std::vector<int> first(state.uvVertexCount, -1);
        for (int t = 0; t < soup->triangleCount(); ++t) {
            QVERIFY2(jacobianDeterminant(*soup, x.data(), t) > 0, qPrintable(QString::number(t)));
            for (int c = 3 * t; c < 3 * t + 3; ++c) {
                int &f = first[state.uvVertex[c]];
                if (f < 0)
                    f = c;
                QVERIFY(x[2 * c] == x[2 * f] && x[2 * c + 1] == x[2 * f + 1]);
            }
        }
    }

    void tutteFillsACircleOfTheChartsArea()
    {
        // Solver units: the whole mesh, here one chart, has area pi, so its circle has radius 1.
        const auto mesh = test::grid(5, 0.3);
        const auto soup = Soup::build(mesh);
        const CutMesh state(*mesh, CutFlags(mesh->edgePairs.size(), false));
        const std::vector<double> x = tutteEmbedding(*soup, state);
        const std::vector<std::vector<int>> loops = state.boundaryLoops();
        QCOMPARE(static_cast<int>(loops.size()), 1);
        for (const int side : loops.front())
            QVERIFY(std::abs(std::hypot(x[2 * side], x[2 * side + 1]) - 1) < 1e-12);
        double farthest = 0;
        for (std::size_t c = 0; c < x.size(); c += 2)
            farthest = std::max(farthest, std::hypot(x[c], x[c + 1]));
        QVERIFY(farthest < 1 + 1e-12);
    }

    void tutteRefusesAClosedChart()
    {
        const auto mesh = test::cube();
        const CutMesh state(*mesh, CutFlags(mesh->edgePairs.size(), false));
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, tutteEmbedding(*Soup::build(mesh), state));
    }
};

QTEST_APPLESS_MAIN(TestCutMesh)

} // namespace tst_cutmesh

#include "tst_cutmesh.moc"
