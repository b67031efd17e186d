// Re-linking: what of a session stays when its model is exchanged.
#include "model/editing/relink.h"
#include "model/io/obj/objreader.h"
#include "model/io/projects/projectmigration.h"
#include "model/plain/polygonsides.h"
#include "support/editsupport.h"
#include "support/randomedits.h"
#include "support/sessions.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tst_relink {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

struct Polygons
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
};

Polygons polygonsOf(const MeshData &mesh)
{
    Polygons result;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        result.points.push_back(mesh.positions.row(v));
    for (int f = 0; f < mesh.faceCount(); ++f)
        result.faces.emplace_back(mesh.cornerVertex.begin() + mesh.faceStart[f],
                                  mesh.cornerVertex.begin() + mesh.faceStart[f + 1]);
    return result;
}

Scene sceneOf(const Polygons &polygons)
{
    return test::sceneOf(test::polygonMesh(polygons.points, polygons.faces));
}

template <typename T>
void shuffle(std::vector<T> &values, test::Random &random)
{
    for (std::size_t i = values.size(); i > 1; --i)
        std::swap(values[i - 1], values[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
}

//! The same polygons with vertices and faces in another order, and other first corners.
Polygons renumbered(const Polygons &polygons, int seed)
{
    test::Random random(static_cast<std::uint64_t>(seed));
    std::vector<int> place(polygons.points.size());
    std::iota(place.begin(), place.end(), 0);
    shuffle(place, random);
    Polygons result = polygons;
    for (std::size_t v = 0; v < place.size(); ++v)
        result.points[static_cast<std::size_t>(place[v])] = polygons.points[v];
    for (auto &face : result.faces) {
        for (int &v : face)
            v = place[static_cast<std::size_t>(v)];
        std::rotate(face.begin(), face.begin() + random.below(static_cast<int>(face.size())), face.end());
    }
    shuffle(result.faces, random);
    return result;
}

//! A session on a bulged grid with seams, pins, rectangles and marks.
DocumentState steeredGrid()
{
    DocumentState state = test::layoutDocument(test::grid(4, 0.2))->state();
    const MeshData &mesh = *state.scene.mesh;
    test::Random random(8);
    for (int p = 0; p < static_cast<int>(mesh.edgePairs.size()); ++p) {
        if (mesh.edgePairs[p].diagonal || !random.oneIn(2))
            continue;
        state.seams.states[2 * p] = PairState(random.below(3));
        state.seams.states[2 * p + 1] = PairState(random.below(3));
        state.seams.weights[2 * p] = random.unit();
        state.seams.straight[2 * p] = state.seams.straight[2 * p + 1] = random.oneIn(2);
    }
    state.constraints.pins = {{3, {0.25, 0.5}, true, 1}, {40, {1.5, 0.5}, false, 7}};
    state.constraints.rectangles = {{1, u"head"_s, 0xff00ff00, {0, 0}, {0.5, 0.5}, false, 1, {0, 1, 4, 15}}};
    state.marks.faceFlags[0] = {.locked = 1, .upright = 1, .stack = 2, .group = 3};
    state.marks.faceFlags[15] = {.stack = 2};
    state.marks.tags = {{u"last"_s, {15}}, {u"skin"_s, {0, 5}}};
    state.selection = {SelectionMode::Faces, {2, 3}, {4}, {8, 9}};
    state.viewState = QByteArrayLiteral("camera");
    state.solveSettings.lambda = 0.5;
    state.packingSettings.margin = 3;
    return state;
}

//! Seams by what they join, without the numbers of a mesh: the positions of an edge's ends, seen from the
//! side of each face's centre, with what is decided for it.
std::vector<std::vector<double>> seamsByPosition(const DocumentState &state)
{
    const MeshData &mesh = *state.scene.mesh;
    std::vector<std::vector<double>> result;
    for (int p = 0; p < static_cast<int>(mesh.edgePairs.size()); ++p) {
        if (mesh.edgePairs[p].diagonal)
            continue;
        for (int end = 0; end < 2; ++end) {
            const Vec3 here = mesh.cornerPosition(mesh.cornerOfSoup(mesh.edgePairs[p].corner[end][0]));
            const Vec3 there = mesh.cornerPosition(mesh.cornerOfSoup(mesh.edgePairs[p].corner[1 - end][0]));
            result.push_back({here.x(), here.y(), here.z(), there.x(), there.y(), there.z(),
                              double(state.seams.states[2 * p + end]), state.seams.weights[2 * p + end],
                              double(state.seams.straight[2 * p + end])});
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

//! UVs by the positions of the corner and of its face's centre.
std::vector<std::vector<double>> uvsByPosition(const DocumentState &state)
{
    const MeshData &mesh = *state.scene.mesh;
    std::vector<std::vector<double>> result;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Vec3 low = mesh.cornerPosition(mesh.faceStart[f]);
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            low = low.cwiseMin(mesh.cornerPosition(c));
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            const Vec3 p = mesh.cornerPosition(c);
            const auto uv = state.scene.uvSets[0].uv.row(c);
            result.push_back({low.x(), low.y(), p.x(), p.y(), uv.x(), uv.y()});
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace

class TestRelink : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sidePairs();
    void sameModelKeepsEverything();
    void deformedModelKeepsEverything();
    void renumberedModel();
    void roundedPositions();
    void facesTakenAway();
    void movedAndFacesTakenAway_data();
    void movedAndFacesTakenAway();
    void aBoxThatFitsTurnedIsNotTurned();
    void allFacesAreNewButNear();
    void facesAdded();
    void changedFacesTakeTheirUvsByPosition();
    void newFacesLieBesideTheMap();
    void turnedFaceIsAnother();
    void duplicateFaces();
    void otherModelLosesAll();
    void otherUnitsAndAxes_data();
    void otherUnitsAndAxes();
    void emptyModel();
    void objBytesAreTheNewOnes();
};

void TestRelink::sidePairs()
{
    for (const test::MeshPtr &mesh : {test::cube(), test::quadCube(), test::torus(6, 5), test::dirty()}) {
        const std::vector<int> bySide = edgePairsBySide(*mesh);
        int sides = 0;
        for (int p = 0; p < static_cast<int>(mesh->edgePairs.size()); ++p) {
            if (mesh->edgePairs[p].diagonal)
                continue;
            const SidePair pair = sidePair(*mesh, p);
            QCOMPARE(bySide[pair.startCorner[0]], p);
            QCOMPARE(bySide[pair.startCorner[1]], p);
            sides += 2;
            // The first corner pair is at the start of the first side, the second at that of the second.
            for (int k = 0; k < 2; ++k) {
                QCOMPARE(pair.cornerPair[k] / 2, p);
                const int soup = mesh->edgePairs[p].corner[pair.cornerPair[k] % 2][k];
                QCOMPARE(mesh->cornerOfSoup(soup), pair.startCorner[k]);
            }
        }
        QCOMPARE(std::count_if(bySide.begin(), bySide.end(), [](int p) { return p >= 0; }), sides);
    }
}

void TestRelink::sameModelKeepsEverything()
{
    DocumentState state = steeredGrid();
    const Relinked relinked = relinkDocument(state, state.scene);
    QVERIFY(relinked.report.sameTopology);
    QCOMPARE(relinked.report.lines(), QStringList());
    QCOMPARE(relinked.report.faces, (Carried{16, 0}));
    state.selection.edges = {};
    QVERIFY(relinked.state == state);
}

void TestRelink::deformedModelKeepsEverything()
{
    DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    for (Vec3 &p : polygons.points)
        p = Vec3(7 * p.x() + 1, p.y() * p.y(), p.x() - 3 * p.z());
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QVERIFY(relinked.report.sameTopology);
    QCOMPARE(relinked.report.lines(), QStringList());
    QCOMPARE(relinked.state.validate(), QString());
    QVERIFY(relinked.state.seams == state.seams);
    QVERIFY(relinked.state.constraints == state.constraints);
    QVERIFY(relinked.state.marks == state.marks);
    QCOMPARE(relinked.state.uvScales, state.uvScales);
    QCOMPARE(relinked.state.scene.mesh->positions(1, 0), polygons.points[1].x());
}

void TestRelink::renumberedModel()
{
    const DocumentState state = steeredGrid();
    const Polygons polygons = renumbered(polygonsOf(*state.scene.mesh), 3);
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QVERIFY(!relinked.report.sameTopology);
    QCOMPARE(relinked.report.lines(), QStringList());
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(seamsByPosition(relinked.state), seamsByPosition(state));
    QCOMPARE(uvsByPosition(relinked.state), uvsByPosition(state));
    QCOMPARE(relinked.report.pins, (Carried{2, 0}));
    const MeshData &before = *state.scene.mesh;
    const MeshData &after = *relinked.state.scene.mesh;
    QVector<double> pinned;
    for (const UvPin &pin : relinked.state.constraints.pins)
        pinned << after.cornerPosition(pin.corner).x() << pin.position.x() << pin.weight;
    const auto pinBefore = [&](int i) {
        const UvPin &pin = state.constraints.pins[i];
        return QVector<double>{before.cornerPosition(pin.corner).x(), pin.position.x(), pin.weight};
    };
    QVERIFY(pinned == pinBefore(0) + pinBefore(1) || pinned == pinBefore(1) + pinBefore(0));
    QCOMPARE(relinked.state.constraints.rectangles[0].faces.size(), 4);
    QCOMPARE(relinked.report.markedFaces, (Carried{2, 0}));
    QCOMPARE(relinked.state.marks.tags.size(), std::size_t(2));
    QVERIFY(std::abs(relinked.state.uvScales[0] / state.uvScales[0] - 1) < 1e-12);
    QCOMPARE(relinked.state.viewState, state.viewState);
    QVERIFY(relinked.state.solveSettings == state.solveSettings);
    QVERIFY(relinked.state.packingSettings == state.packingSettings);
}

void TestRelink::roundedPositions()
{
    DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    for (Vec3 &p : polygons.points)
        p += Vec3(1234.5678901, 0, 0);
    state.scene.mesh = test::polygonMesh(polygons.points, polygons.faces);
    for (Vec3 &p : polygons.points) {
        for (int k = 0; k < 3; ++k)
            p[k] = std::stod(QByteArray::number(p[k], 'g', 7).toStdString());
    }
    const Relinked close = relinkDocument(state, sceneOf(renumbered(polygons, 4)));
    QCOMPARE(close.report.faces, (Carried{16, 0}));
    for (Vec3 &p : polygons.points)
        p.y() += 0.02;
    const Relinked far = relinkDocument(state, sceneOf(renumbered(polygons, 4)));
    QCOMPARE(far.report.faces, (Carried{0, 16}));
}

void TestRelink::facesTakenAway()
{
    const DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    polygons.faces.pop_back(); // with a rectangle's face, a flag and a whole tag
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    const RelinkReport &report = relinked.report;
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(report.faces, (Carried{15, 1}));
    QCOMPARE(report.newFaces.size(), 0);
    QCOMPARE(report.rectangleFaces, (Carried{3, 1}));
    QCOMPARE(report.markedFaces, (Carried{1, 1}));
    QCOMPARE(report.lostTags, QStringList{u"last"_s});
    QCOMPARE(report.pins, (Carried{2, 0}));
    const auto seams = seamsByPosition(state);
    const auto kept = seamsByPosition(relinked.state);
    QVERIFY(std::includes(seams.begin(), seams.end(), kept.begin(), kept.end()));
    QCOMPARE(seams.size() - kept.size(), std::size_t(4)); // two edges of the face, each with two ends
    QCOMPARE(report.lines().first(), u"1 of 16 faces are not in the new model: their UVs are lost"_s);
    QCOMPARE(report.lines().last(), u"tags of which no face is left: last"_s);
    // The same lengths in the texture: the solver's unit shrinks with the model.
    const double share = relinked.state.scene.mesh->area / state.scene.mesh->area;
    QVERIFY(std::abs(relinked.state.uvScales[0] / state.uvScales[0] - std::sqrt(share)) < 1e-12);
}

void TestRelink::movedAndFacesTakenAway_data()
{
    QTest::addColumn<Vec3>("move");
    QTest::addColumn<double>("stretch");
    QTest::newRow("moved") << Vec3(0, 0, 0.05) << 1.0;
    QTest::newRow("far") << Vec3(30, -5, 2) << 1.0;
    QTest::newRow("deformed") << Vec3(0, 0, 0) << 1.3;
}

//! Programs keep the numbers of vertices when faces are deleted and the rest is moved or deformed.
void TestRelink::movedAndFacesTakenAway()
{
    QFETCH(Vec3, move);
    QFETCH(double, stretch);
    const DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    polygons.faces.erase(polygons.faces.begin() + 6, polygons.faces.begin() + 8);
    for (Vec3 &point : polygons.points)
        point = Vec3(point.x(), stretch * point.y(), stretch * point.z()) + move;
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(relinked.report.faces, (Carried{14, 2}));
    QCOMPARE(relinked.report.newFaces.size(), 0);
    QCOMPARE(relinked.report.placement.isIdentity(), true);
    const UvMatrix &before = state.scene.uvSets[0].uv, &after = relinked.state.scene.uvSets[0].uv;
    QVERIFY(after.topRows(24) == before.topRows(24));
    QVERIFY(after.bottomRows(32) == before.bottomRows(32));
}

//! A round model fits turned as well. Where it lies in its place, its surface says more than its box.
void TestRelink::aBoxThatFitsTurnedIsNotTurned()
{
    const test::MeshPtr sphere = test::sphere(12, 12);
    Polygons polygons = polygonsOf(*sphere);
    for (Vec3 &point : polygons.points)
        point += Vec3(0.01, 0, 0); // no face has a counterpart
    polygons.points.push_back(Vec3(0, 0, 0));
    polygons.faces.pop_back();
    const Relinked relinked = relinkDocument(test::layoutDocument(sphere)->state(), sceneOf(polygons));
    QCOMPARE(relinked.report.faces.kept, 0);
    QVERIFY(relinked.report.placement.isIdentity());
}

//! They keep the density of the map, although no face says what that is.
void TestRelink::allFacesAreNewButNear()
{
    const DocumentState state = test::layoutDocument(test::grid(4, 0.2))->state();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    for (Vec3 &point : polygons.points)
        point = 10 * point + Vec3(0, 0, 0.01);
    polygons.points.push_back(Vec3(0, 0, 0));
    DocumentState large = relinkDocument(state, sceneOf(polygons)).state;
    for (Vec3 &point : polygons.points)
        point.z() += 0.02;
    polygons.points.push_back(Vec3(0, 0, 0));
    large.scene.uvSets[0].uv = state.scene.uvSets[0].uv;
    const std::vector<int> last = polygons.faces.back(); // the whole is no moved part
    polygons.faces.back() = {last[0], last[1], last[2]};
    polygons.faces.push_back({last[2], last[3], last[0]});
    const Relinked relinked = relinkDocument(large, sceneOf(polygons));
    QCOMPARE(relinked.report.faces.kept, 0);
    QCOMPARE(relinked.report.besideFaces, 0);
    QCOMPARE(relinked.report.placedFaces, 17);
}

void TestRelink::facesAdded()
{
    const DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    polygons.points.push_back(Vec3(2, 2, 0));
    polygons.faces.push_back({0, 1, static_cast<int>(polygons.points.size()) - 1});
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(relinked.report.faces, (Carried{16, 0}));
    QCOMPARE(relinked.report.newFaces.size(), 1);
    QCOMPARE(relinked.report.lines(),
             QStringList{u"new faces that lie flat beside the map and are still to be unwrapped: 1"_s});
    const UvMatrix &uv = relinked.state.scene.uvSets[0].uv;
    QVERIFY(uv.bottomRows(3).col(0).minCoeff() > uv.topRows(64).col(0).maxCoeff());
    QVERIFY(uv.topRows(64) == state.scene.uvSets[0].uv);
}

void TestRelink::changedFacesTakeTheirUvsByPosition()
{
    const DocumentState state = steeredGrid();
    const MeshData &mesh = *state.scene.mesh;
    // One face becomes four triangles around its middle, another loses a corner.
    Polygons polygons = polygonsOf(mesh);
    const std::vector<int> split = polygons.faces[5];
    polygons.points.push_back(0.25 * (polygons.points[split[0]] + polygons.points[split[1]] +
                                      polygons.points[split[2]] + polygons.points[split[3]]));
    const int middle = static_cast<int>(polygons.points.size()) - 1;
    polygons.faces[5] = {split[0], split[1], middle};
    for (std::size_t i = 1; i < 4; ++i)
        polygons.faces.push_back({split[i], split[(i + 1) % 4], middle});
    polygons.faces[0].pop_back();
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(relinked.report.faces, (Carried{14, 2}));
    QCOMPARE(relinked.report.newFaces.size(), 5);
    QCOMPARE(relinked.report.placedFaces, 5);
    const QStringList lines = relinked.report.lines();
    QCOMPARE(lines[0], u"2 of 16 faces are not in the new model"_s);
    QCOMPARE(lines[1], u"new faces with the UVs of the old model's nearest points: 5"_s);
    QVERIFY(lines.filter(u"without UVs"_s).isEmpty());
    // Every corner at an old vertex has one of its UVs, in all sets, and the others lie between them.
    for (std::size_t set = 0; set < state.scene.uvSets.size(); ++set) {
        const UvMatrix &before = state.scene.uvSets[set].uv, &after = relinked.state.scene.uvSets[set].uv;
        if (!before.allFinite())
            continue;
        QVERIFY(after.allFinite());
        const MeshData &now = *relinked.state.scene.mesh;
        for (int c = 0; c < now.cornerCount(); ++c) {
            if (now.cornerVertex[c] == middle)
                continue;
            bool found = false;
            for (int old = 0; old < mesh.cornerCount() && !found; ++old)
                found = mesh.cornerVertex[old] == now.cornerVertex[c] && before.row(old) == after.row(c);
            QVERIFY2(found, qPrintable(QString::number(c)));
        }
    }
    // A stop leaves it at that.
    QCOMPARE(relinkDocument(state, sceneOf(polygons), [] { return true; }).report.placedFaces, 0);
}

//! New faces right above others that stay would lie on those in the map, and walls would have hardly any area
//! there.
void TestRelink::newFacesLieBesideTheMap()
{
    const DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    const std::vector<int> base = polygons.faces[5];
    const auto first = static_cast<int>(polygons.points.size());
    for (const int vertex : base)
        polygons.points.push_back(polygons.points[static_cast<std::size_t>(vertex)] + Vec3(0, 0, 0.02));
    polygons.faces.push_back({first, first + 1, first + 2, first + 3});
    for (int k = 0; k < 4; ++k)
        polygons.faces.push_back({base[static_cast<std::size_t>(k)],
                                  base[static_cast<std::size_t>((k + 1) % 4)], first + (k + 1) % 4,
                                  first + k});
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QCOMPARE(relinked.report.faces, (Carried{16, 0}));
    QCOMPARE(relinked.report.placedFaces, 0);
    QCOMPARE(relinked.report.besideFaces, 5);
    const UvMatrix &uv = relinked.state.scene.uvSets[0].uv;
    QVERIFY(uv.topRows(64) == state.scene.uvSets[0].uv);
    QVERIFY(uv.allFinite());
    QVERIFY(uv.bottomRows(20).col(0).minCoeff() > uv.topRows(64).col(0).maxCoeff());
    // They keep their shapes, at the texel density of the others, and apart from each other.
    const MeshData &mesh = *relinked.state.scene.mesh;
    const auto areaOf = [&](int triangle) {
        const auto &t = mesh.triangles[static_cast<std::size_t>(triangle)];
        const Vec2 a = uv.row(t[0]), b = uv.row(t[1]), c = uv.row(t[2]);
        return 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
    };
    double before = 0, area = 0;
    for (int t = 0; t < 32; ++t) {
        before += std::abs(areaOf(t));
        area += mesh.triangleArea[static_cast<std::size_t>(t)];
    }
    for (int t = 32; t < mesh.triangleCount(); ++t) {
        const double ratio = areaOf(t) / (mesh.triangleArea[static_cast<std::size_t>(t)] * before / area);
        QVERIFY2(ratio > 0.8 && ratio < 1.25, qPrintable(QString::number(ratio)));
    }
    for (int a = 64; a < 84; a += 4) {
        for (int b = a + 4; b < 84; b += 4) {
            Eigen::AlignedBox2d one, other;
            for (int k = 0; k < 4; ++k) {
                one.extend(Vec2(uv.row(a + k)));
                other.extend(Vec2(uv.row(b + k)));
            }
            QVERIFY(one.intersection(other).isEmpty());
        }
    }
}

void TestRelink::turnedFaceIsAnother()
{
    const DocumentState state = steeredGrid();
    Polygons polygons = polygonsOf(*state.scene.mesh);
    std::reverse(polygons.faces[5].begin(), polygons.faces[5].end());
    const Relinked relinked = relinkDocument(state, sceneOf(polygons));
    QCOMPARE(relinked.report.faces, (Carried{15, 1}));
    QCOMPARE(relinked.report.newFaces.size(), 1);
    QCOMPARE(relinked.state.validate(), QString());
}

void TestRelink::duplicateFaces()
{
    const test::MeshPtr dirty = test::dirty();
    const DocumentState state = test::layoutDocument(dirty)->state();
    const Relinked relinked = relinkDocument(state, sceneOf(renumbered(polygonsOf(*dirty), 6)));
    QCOMPARE(relinked.report.faces, (Carried{dirty->faceCount(), 0}));
    QCOMPARE(relinked.report.newFaces.size(), 0);
    QCOMPARE(relinked.state.validate(), QString());
}

void TestRelink::otherModelLosesAll()
{
    const DocumentState state = steeredGrid();
    const Relinked relinked = relinkDocument(state, test::sceneOf(test::sphere(5, 6)));
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(relinked.report.faces, (Carried{0, 16}));
    QCOMPARE(relinked.report.seams.kept, 0);
    QCOMPARE(relinked.report.pins, (Carried{0, 2}));
    QCOMPARE(relinked.state.constraints.rectangles.size(), std::size_t(1));
    QVERIFY(relinked.state.constraints.rectangles[0].faces.isEmpty());
    QCOMPARE(relinked.state.scene.uvSets.size(), std::size_t(2));
    QCOMPARE(relinked.state.uvScales, state.uvScales);
}

void TestRelink::otherUnitsAndAxes_data()
{
    QTest::addColumn<double>("scale");
    QTest::addColumn<int>("turn");
    QTest::newRow("centimetres") << 100.0 << 0;
    QTest::newRow("metres") << 0.01 << 0;
    QTest::newRow("inches") << 1 / 0.0254 << 0;
    QTest::newRow("z up, centimetres") << 100.0 << -1;
}

//! A program that writes other units, renumbers all and turns the model loses nothing of the map.
void TestRelink::otherUnitsAndAxes()
{
    QFETCH(double, scale);
    QFETCH(int, turn);
    DocumentState state = steeredGrid();
    const Polygons polygons = renumbered(polygonsOf(*state.scene.mesh), 5);
    const Relinked plain = relinkDocument(state, sceneOf(polygons));
    Scene moved = sceneOf(polygons);
    moved.mesh = transfer::placed(*moved.mesh, {scale, turn});
    const Relinked relinked = relinkDocument(state, moved);
    QCOMPARE(relinked.report.faces, plain.report.faces);
    QCOMPARE(relinked.report.faces.lost, 0);
    QCOMPARE(relinked.state.scene.uvSets[0].uv, plain.state.scene.uvSets[0].uv);
    QVERIFY(std::abs(relinked.report.placement.scale * scale - 1) < 1e-9);
    QCOMPARE(relinked.report.placement.turn, -turn);
    QVERIFY(relinked.report.lines().first().contains(u"other units"_s));
}

void TestRelink::emptyModel()
{
    const DocumentState state = steeredGrid();
    const Relinked relinked = relinkDocument(state, test::sceneOf(test::polygonMesh({}, {})));
    QCOMPARE(relinked.state.validate(), QString());
    QCOMPARE(relinked.report.faces, (Carried{0, 16}));
    const Relinked back = relinkDocument(relinked.state, state.scene);
    QCOMPARE(back.state.validate(), QString());
    QCOMPARE(back.report.newFaces.size(), 16);
}

void TestRelink::objBytesAreTheNewOnes()
{
    const test::Session session = test::cubeSession();
    const QByteArray text = "# new\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 3 2\n";
    const Relinked relinked = relinkDocument(session.state, parseObj(text, u"new.obj"_s).value());
    QCOMPARE(relinked.report.faces, (Carried{1, 11}));
    QCOMPARE(relinked.state.scene.path, u"new.obj"_s);
    const QByteArray bytes = ProjectWriter().bytes(relinked.state, {});
    QCOMPARE(readContainer(bytes, projectVersion, {}).value().parts.at("obj"), text);
    QVERIFY(parseProject(bytes, {}).value().state == relinked.state);
}

QTEST_GUILESS_MAIN(TestRelink)

} // namespace tst_relink

#include "tst_relink.moc"
