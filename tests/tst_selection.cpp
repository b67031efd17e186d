// Adjacency and ways to select: loops, paths, growing, islands, similar islands.
#include "model/document/islands.h"
#include "model/editing/selectiontools.h"
#include "model/editing/similarislands.h"
#include "support/editsupport.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <numeric>

namespace tst_selection {

using namespace autocuts;

namespace {

//! The edge between two points of a mesh; -1 when there is none.
int edgeBetween(const MeshData &mesh, const MeshAdjacency &adjacency, const Vec3 &a, const Vec3 &b)
{
    for (int e = 0; e < adjacency.edgeCount(); ++e) {
        if (adjacency.isDiagonal(e))
            continue;
        const Vec3 p = mesh.positions.row(adjacency.edgeVertices(e)[0]);
        const Vec3 q = mesh.positions.row(adjacency.edgeVertices(e)[1]);
        if ((p.isApprox(a) && q.isApprox(b)) || (p.isApprox(b) && q.isApprox(a)) ||
            ((p - a).norm() + (q - b).norm() < 1e-9) || ((p - b).norm() + (q - a).norm() < 1e-9))
            return e;
    }
    return -1;
}

double lengthOf(const MeshAdjacency &adjacency, const std::vector<int> &edges)
{
    return std::accumulate(edges.begin(), edges.end(), 0.0,
                           [&](double sum, int e) { return sum + adjacency.edgeLength(e); });
}

//! Triangles on a square lattice, all diagonals in the same direction.
test::MeshPtr triangleGrid(int n)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x)
            points.emplace_back(x, y, 0);
    }
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x;
            faces.push_back({a, a + 1, a + n + 2});
            faces.push_back({a, a + n + 2, a + n + 1});
        }
    }
    return test::polygonMesh(points, faces);
}

Selection selectionOf(SelectionMode mode, QList<int> items)
{
    Selection selection;
    selection.mode = mode;
    (mode == SelectionMode::Vertices ? selection.corners
     : mode == SelectionMode::Edges  ? selection.edges
                                     : selection.faces) = std::move(items);
    return selection;
}

} // namespace

class TestSelection : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void adjacencyFits_data();
    void adjacencyFits();
    void loopOfQuads();
    void loopEndsAtOddVertices();
    void loopOfTriangles();
    void loopOfBoundary();
    void shortestPathIsShortest();
    void pathObeysFactors();
    void pathBetweenPartsDoesNotExist();
    void growAndShrinkFaces();
    void growAndShrinkEdges();
    void growAndShrinkVertices();
    void islandsAndParts();
    void similarIslandsAreFound();
    void settingNormalizesAndTells();
};

void TestSelection::adjacencyFits_data()
{
    QTest::addColumn<int>("which");
    for (int i = 0; i < 6; ++i)
        QTest::addRow("mesh %d", i) << i;
}

void TestSelection::adjacencyFits()
{
    QFETCH(int, which);
    const auto fin = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    const test::MeshPtr meshes[] = {test::triangle(),   test::quadCube(),  test::grid(3),
                                    test::sphere(5, 7), test::torus(6, 5), fin};
    const MeshData &mesh = *meshes[which];
    const MeshAdjacency adjacency(mesh);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const int face = adjacency.faceOfCorner(c);
        QVERIFY(c >= mesh.faceStart[face] && c < mesh.faceStart[face + 1]);
        const int next = c + 1 < mesh.faceStart[face + 1] ? c + 1 : mesh.faceStart[face];
        const int edge = adjacency.edgeOfCorner(c);
        QVERIFY(edge >= 0 && !adjacency.isDiagonal(edge));
        const auto &faces = adjacency.edgeFaces(edge);
        QVERIFY(faces[0] == face || faces[1] == face);
        const int a = mesh.vertexWeld[mesh.cornerVertex[c]];
        const int b = mesh.vertexWeld[mesh.cornerVertex[next]];
        QVERIFY(adjacency.edgeVertices(edge)[0] == a || adjacency.edgeVertices(edge)[1] == a);
        QCOMPARE(adjacency.otherEnd(edge, a), b);
        QVERIFY(qFuzzyCompare(adjacency.edgeLength(edge),
                              (mesh.positions.row(a) - mesh.positions.row(b)).norm()));
        const auto corners = adjacency.vertexCorners(a);
        QVERIFY(std::find(corners.begin(), corners.end(), c) != corners.end());
        const auto edges = adjacency.vertexEdges(a);
        QVERIFY(std::find(edges.begin(), edges.end(), edge) != edges.end());
        QVERIFY(std::is_sorted(edges.begin(), edges.end()));
    }
    std::vector<int> all = adjacency.cornersByVertex();
    std::sort(all.begin(), all.end());
    for (int c = 0; c < mesh.cornerCount(); ++c)
        QCOMPARE(all[c], c);
}

void TestSelection::loopOfQuads()
{
    const auto mesh = test::grid(6);
    const MeshAdjacency adjacency(*mesh);
    const double y = 2.0 / 6;
    const auto loop =
        edgeLoop(*mesh, adjacency, edgeBetween(*mesh, adjacency, {3.0 / 6, y, 0}, {4.0 / 6, y, 0}));
    QCOMPARE(loop.size(), std::size_t(6)); // the row, from border to border
    for (int e : loop) {
        for (int v : adjacency.edgeVertices(e))
            QCOMPARE(mesh->positions(v, 1), y);
    }
    const auto ring = test::torus(12, 8);
    const MeshAdjacency onRing(*ring);
    std::vector<std::size_t> sizes;
    for (int e = 0; e < onRing.edgeCount(); ++e) {
        if (onRing.isDiagonal(e))
            continue;
        const auto closed = edgeLoop(*ring, onRing, e);
        QVERIFY(closed.size() == 12 || closed.size() == 8);
        QCOMPARE(edgeLoop(*ring, onRing, closed.back()), closed); // the same from every edge of it
    }
}

void TestSelection::loopEndsAtOddVertices()
{
    const auto mesh = test::quadCube(); // three edges at every corner
    const MeshAdjacency adjacency(*mesh);
    const int edge = edgeBetween(*mesh, adjacency, {0, 0, 0}, {1, 0, 0});
    QCOMPARE(edgeLoop(*mesh, adjacency, edge), std::vector<int>{edge});
}

void TestSelection::loopOfTriangles()
{
    const auto mesh = triangleGrid(5);
    const MeshAdjacency adjacency(*mesh);
    const auto row = edgeLoop(*mesh, adjacency, edgeBetween(*mesh, adjacency, {1, 2, 0}, {2, 2, 0}));
    QCOMPARE(row.size(), std::size_t(5));
    const auto diagonal = edgeLoop(*mesh, adjacency, edgeBetween(*mesh, adjacency, {1, 1, 0}, {2, 2, 0}));
    QCOMPARE(diagonal.size(), std::size_t(5));
    for (int e : diagonal) {
        for (int v : adjacency.edgeVertices(e))
            QCOMPARE(mesh->positions(v, 0), mesh->positions(v, 1));
    }
    const auto ball = test::sphere(9, 16);
    const MeshAdjacency onBall(*ball);
    const int equatorial = edgeBetween(*ball, onBall, ball->positions.row(1 + 4 * 16).transpose(),
                                       ball->positions.row(2 + 4 * 16).transpose());
    QCOMPARE(edgeLoop(*ball, onBall, equatorial).size(), std::size_t(16));
}

void TestSelection::loopOfBoundary()
{
    const auto mesh = test::grid(5);
    const MeshAdjacency adjacency(*mesh);
    const auto loop = edgeLoop(*mesh, adjacency, edgeBetween(*mesh, adjacency, {0, 0, 0}, {0.2, 0, 0}));
    QCOMPARE(loop.size(), std::size_t(20));
    QVERIFY(std::all_of(loop.begin(), loop.end(), [&](int e) { return adjacency.isBoundary(e); }));
}

void TestSelection::shortestPathIsShortest()
{
    const auto mesh = triangleGrid(6);
    const MeshAdjacency adjacency(*mesh);
    const auto path = shortestPath(adjacency, 0, 6 * 7 + 6);
    QCOMPARE(path.size(), std::size_t(6));
    QVERIFY(qFuzzyCompare(lengthOf(adjacency, path), 6 * std::sqrt(2.0)));
    const auto across = shortestPath(adjacency, 6, 6 * 7); // against the diagonals
    QVERIFY(qFuzzyCompare(lengthOf(adjacency, across), 12.0));
    QVERIFY(shortestPath(adjacency, 3, 3).empty());
    QCOMPARE(shortestPath(adjacency, 6, 6 * 7), across);
}

void TestSelection::pathObeysFactors()
{
    const auto mesh = test::grid(4);
    const MeshAdjacency adjacency(*mesh);
    std::vector<double> factor(adjacency.edgeCount(), 1);
    const auto direct = shortestPath(adjacency, 0, 4, factor);
    QCOMPARE(direct.size(), std::size_t(4));
    for (int e : direct)
        factor[e] = 10;
    const auto around = shortestPath(adjacency, 0, 4, factor);
    QCOMPARE(around.size(), std::size_t(6)); // up, along the next row, down
    for (int e : around)
        QCOMPARE(factor[e], 1.0);
}

void TestSelection::pathBetweenPartsDoesNotExist()
{
    const auto mesh =
        test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}},
                          {{0, 1, 2}, {3, 4, 5}});
    const MeshAdjacency adjacency(*mesh);
    QVERIFY(shortestPath(adjacency, 0, 4).empty());
    QVERIFY(shortestPath(adjacency, 0, 6).empty()); // an isolated vertex
    QCOMPARE(linkedFaces(*mesh, {1}), QList<int>{1});
}

void TestSelection::growAndShrinkFaces()
{
    const auto mesh = test::grid(6);
    const MeshAdjacency adjacency(*mesh);
    const Selection one = selectionOf(SelectionMode::Faces, {2 * 6 + 2});
    const Selection nine = grown(*mesh, adjacency, one);
    QCOMPARE(nine.faces, QList<int>({7, 8, 9, 13, 14, 15, 19, 20, 21}));
    QVERIFY(shrunk(*mesh, adjacency, nine) == one);
    QVERIFY(shrunk(*mesh, adjacency, one).isEmpty());
    Selection all = one;
    for (int i = 0; i < 6; ++i)
        all = grown(*mesh, adjacency, all);
    QCOMPARE(all.faces.size(), 36);
    QVERIFY(shrunk(*mesh, adjacency, all) == all); // nothing unselected around it
    QVERIFY(grown(*mesh, adjacency, selectionOf(SelectionMode::Faces, {})).isEmpty());
    const Selection islands = selectionOf(SelectionMode::Islands, {3});
    QVERIFY(grown(*mesh, adjacency, islands) == islands);
}

void TestSelection::growAndShrinkEdges()
{
    const auto mesh = test::grid(6);
    const MeshAdjacency adjacency(*mesh);
    const int edge = edgeBetween(*mesh, adjacency, {2.0 / 6, 2.0 / 6, 0}, {3.0 / 6, 2.0 / 6, 0});
    const Selection one = selectionOf(SelectionMode::Edges, {edge});
    const Selection seven = grown(*mesh, adjacency, one);
    QCOMPARE(seven.edges.size(), 7); // itself and three at each end
    QCOMPARE(seven.validate(*mesh), QString());
    QVERIFY(shrunk(*mesh, adjacency, seven) == one);
}

void TestSelection::growAndShrinkVertices()
{
    const auto mesh = test::grid(6);
    const MeshAdjacency adjacency(*mesh);
    const auto corners = adjacency.vertexCorners(2 * 7 + 2);
    const Selection one = selectionOf(SelectionMode::Vertices, QList<int>(corners.begin(), corners.end()));
    QCOMPARE(one.corners.size(), 4);
    const Selection five = grown(*mesh, adjacency, one);
    QCOMPARE(five.corners.size(), 20); // the vertex and its four neighbours
    QVERIFY(shrunk(*mesh, adjacency, five) == one);
}

void TestSelection::islandsAndParts()
{
    const auto document = test::layoutDocument(test::grid(4));
    const Islands &islands = document->islands();
    QCOMPARE(islands.count(), 2);
    QCOMPARE(facesOfIslands(islands, {0, 1}), QList<int>({0, 1, 4, 5, 8, 9, 12, 13}));
    QCOMPARE(facesOfIslands(islands, {0, 3}).size(), 16);
    QVERIFY(facesOfIslands(islands, {}).isEmpty());
    QCOMPARE(linkedFaces(document->mesh(), {0}).size(), 16);
    QCOMPARE(islands.box(1).min(), Vec2(1.5, 0));
    QCOMPARE(islands.box(1).max(), Vec2(2, 1));
    QCOMPARE(islands.corners(document->mesh(), {1}).size(), std::size_t(32));
}

void TestSelection::similarIslandsAreFound()
{
    // Strips of two squares: at the origin, moved and turned, twice as long, and cut into triangles.
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    const auto strip = [&](const auto &place) {
        const int first = static_cast<int>(points.size());
        for (int i = 0; i < 6; ++i)
            points.push_back(place(i % 3, i / 3));
        return first;
    };
    const auto quads = [&](int f) {
        faces.push_back({f, f + 1, f + 4, f + 3});
        faces.push_back({f + 1, f + 2, f + 5, f + 4});
    };
    quads(strip([](double x, double y) { return Vec3(x, y, 0); }));
    quads(strip([](double x, double y) { return Vec3(10 - y, 0.6 * x, 0.8 * x); }));
    quads(strip([](double x, double y) { return Vec3(20 + 2 * x, y, 0); }));
    const int f = strip([](double x, double y) { return Vec3(30 + x, y, 0); });
    faces.push_back({f, f + 1, f + 3});
    faces.push_back({f + 1, f + 4, f + 3});
    const auto mesh = test::polygonMesh(points, faces);
    const MeshAdjacency adjacency(*mesh);
    UvMatrix uv(mesh->cornerCount(), 2);
    for (int c = 0; c < mesh->cornerCount(); ++c)
        uv.row(c) = mesh->cornerPosition(c).head<2>().transpose();
    const Islands islands(*mesh, uv);
    QCOMPARE(islands.count(), 4);
    QCOMPARE(similarIslands(*mesh, adjacency, islands, 0, Similarity::Topology), (std::vector<int>{0, 1, 2}));
    QCOMPARE(similarIslands(*mesh, adjacency, islands, 0, Similarity::Shape), (std::vector<int>{0, 1}));
    QCOMPARE(similarIslands(*mesh, adjacency, islands, 2, Similarity::Shape), (std::vector<int>{2}));
    QCOMPARE(similarIslands(*mesh, adjacency, islands, 3, Similarity::Topology), (std::vector<int>{3}));
}

void TestSelection::settingNormalizesAndTells()
{
    const auto document = test::layoutDocument(test::quadCube());
    QSignalSpy spy(document.get(), &Document::selectionChanged);
    test::EventLog log(*document);
    Selection wild;
    wild.faces = {5, 1, 1, -3, 99};
    wild.corners = {24, 23, 0};
    for (int e = 0; e < document->adjacency().edgeCount(); ++e)
        wild.edges.append(e);
    document->setSelection(wild);
    QCOMPARE(spy.count(), 1);
    QCOMPARE(document->selection().faces, QList<int>({1, 5}));
    QCOMPARE(document->selection().corners, QList<int>({0, 23}));
    QCOMPARE(document->selection().edges.size(), 12); // without the diagonals
    QCOMPARE(document->validate(), QString());
    document->setSelection(wild);
    QCOMPARE(spy.count(), 1);
    QVERIFY(log.take().isEmpty());
    QVERIFY(document->undoStack().isClean());
    QCOMPARE(document->undoStack().count(), 0);
}

QTEST_GUILESS_MAIN(TestSelection)

} // namespace tst_selection

#include "tst_selection.moc"
