// Transferring UVs between meshes: by equal polygons, by position, between objects, and what cannot be done.
#include "jobs/transferring.h"
#include "model/plain/chart.h"
#include "model/plain/uvlayout.h"
#include "model/transfer/uvtransfer.h"
#include "support/mappedmodels.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tst_uvtransfer {

using namespace autocuts;
using namespace autocuts::transfer;
using test::MappedModel;

namespace {

constexpr double pi = std::numbers::pi;

UvTransfer byPosition(const MappedModel &source, const test::MeshPtr &mesh)
{
    return transferUvs({*source.mesh, source.uv, *mesh, UvMatch::Position}, {});
}

//! The largest difference from the map of a function.
double errorOf(const UvMatrix &uv, const test::MeshPtr &mesh, const test::MapOf &map)
{
    return (uv - test::mapped(mesh, map).uv).cwiseAbs().maxCoeff();
}

//! The longest side of a face in the map, as a share of its length on the model.
double longestSide(const MeshData &mesh, const UvMatrix &uv)
{
    double longest = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            const int next = c + 1 < mesh.faceStart[f + 1] ? c + 1 : mesh.faceStart[f];
            const double length = (mesh.cornerPosition(c) - mesh.cornerPosition(next)).norm();
            longest = std::max(longest, (uv.row(c) - uv.row(next)).norm() / length);
        }
    }
    return longest;
}

//! The same faces and vertices in reverse order.
MappedModel reversed(const MappedModel &model)
{
    const MeshData &mesh = *model.mesh;
    const int last = mesh.vertexCount() - 1;
    std::vector<Vec3> points;
    for (int v = last; v >= 0; --v)
        points.push_back(mesh.positions.row(v));
    std::vector<std::vector<int>> faces;
    MappedModel result;
    result.uv.resize(mesh.cornerCount(), 2);
    int row = 0;
    for (int f = mesh.faceCount() - 1; f >= 0; --f) {
        std::vector<int> face;
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            face.push_back(last - mesh.cornerVertex[c]);
            result.uv.row(row++) = model.uv.row(c);
        }
        faces.push_back(face);
    }
    result.mesh = test::polygonMesh(points, faces);
    return result;
}

//! Meshes side by side, each an object of its own, moved along x.
MappedModel objects(const std::vector<MappedModel> &models, double distance)
{
    PositionMatrix positions(0, 3);
    std::vector<int> faceStart{0}, cornerVertex, faceObject;
    MappedModel result{nullptr, UvMatrix(0, 2)};
    for (std::size_t i = 0; i < models.size(); ++i) {
        const MeshData &mesh = *models[i].mesh;
        const int first = static_cast<int>(positions.rows()), corner = static_cast<int>(cornerVertex.size());
        positions.conservativeResize(first + mesh.vertexCount(), 3);
        positions.bottomRows(mesh.vertexCount()) = mesh.positions;
        positions.bottomRows(mesh.vertexCount()).col(0).array() += distance * double(i);
        for (int v : mesh.cornerVertex)
            cornerVertex.push_back(first + v);
        for (int f = 0; f < mesh.faceCount(); ++f) {
            faceStart.push_back(corner + mesh.faceStart[f + 1]);
            faceObject.push_back(static_cast<int>(i));
        }
        result.uv.conservativeResize(corner + mesh.cornerCount(), 2);
        result.uv.bottomRows(mesh.cornerCount()) = models[i].uv;
    }
    result.mesh = MeshData::build(positions, faceStart, cornerVertex, faceObject);
    return result;
}

MappedModel withoutUvs(const test::MeshPtr &mesh)
{
    return {mesh, emptyLayout(*mesh)};
}

jobs::TransferJob objectJob(const MappedModel &model, int object)
{
    jobs::TransferJob job;
    job.source = job.mesh = model.mesh;
    job.sourceUv = job.uv = model.uv;
    job.sourceObject = object;
    return job;
}

} // namespace

class TestUvTransfer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nearestPoints();
    void equalPolygonsAreCopied();
    void otherPolygonsAreAnError();
    void equalMeshesGiveEqualBits();
    void boxesOfOtherResolution_data();
    void boxesOfOtherResolution();
    void anotherTriangulation();
    void tubesAreCutAtTheirSeam_data();
    void tubesAreCutAtTheirSeam();
    void islandsStayApart_data();
    void islandsStayApart();
    void sidesOfThinPlatesStayApart();
    void slitsStayOpen();
    void onlyPartsHaveUvs();
    void farFacesAreNotMatched();
    void modelsElsewhereAreAnError();
    void otherUnitsAndAxes();
    void objectsGiveToObjects();
    void chosenAndLockedFaces();
    void badInput_data();
    void badInput();
    void stops();
};

void TestUvTransfer::nearestPoints()
{
    // Against all triangles one by one.
    const test::MeshPtr mesh = test::sphere(9, 7);
    std::vector<Triangle3> triangles;
    for (const auto &corners : mesh->triangles)
        triangles.push_back({mesh->cornerPosition(corners[0]), mesh->cornerPosition(corners[1]),
                             mesh->cornerPosition(corners[2])});
    triangles.push_back({Vec3(2, 2, 2), Vec3(2, 2, 2), Vec3(3, 2, 2)}); // without area
    const SurfaceTree tree(triangles);
    for (int i = 0; i < 300; ++i) {
        const Vec3 point(2.5 * std::sin(i), 2.5 * std::cos(1.7 * i), 2.5 * std::sin(0.3 * i + 1));
        double nearest = std::numeric_limits<double>::infinity();
        for (const Triangle3 &triangle : triangles)
            nearest = std::min(nearest, nearestOnTriangle(triangle, point).squared);
        const NearPoint found = tree.nearest(point);
        QVERIFY(found.triangle >= 0);
        QCOMPARE(found.squared, nearest);
        QVERIFY(std::abs(found.weights.sum() - 1) < 1e-12 && found.weights.minCoeff() >= 0);
        const Triangle3 &t = tree.triangle(found.triangle);
        const Vec3 there = found.weights.x() * t[0] + found.weights.y() * t[1] + found.weights.z() * t[2];
        QVERIFY(std::abs((there - point).squaredNorm() - nearest) < 1e-12);
    }
    QCOMPARE(SurfaceTree().nearest(Vec3::Zero()).triangle, -1);
}

void TestUvTransfer::equalPolygonsAreCopied()
{
    const MappedModel source = test::mapped(test::box(3), test::boxMap());
    // Deformed and elsewhere: the polygons are the same.
    PositionMatrix positions = source.mesh->positions;
    positions.col(0).array() *= 3;
    positions.col(1).array() += 1000;
    const auto mesh = MeshData::build(positions, source.mesh->faceStart, source.mesh->cornerVertex,
                                      source.mesh->faceObject);
    for (const UvMatch match : {UvMatch::Auto, UvMatch::Topology}) {
        const UvTransfer made = transferUvs({*source.mesh, source.uv, *mesh, match}, {});
        QVERIFY(made.status == UvTransfer::Status::Done);
        QVERIFY(sameBits(made.uv, source.uv));
        QCOMPARE(made.figures.copied, mesh->faceCount());
    }
    QVERIFY(byPosition(source, mesh).status == UvTransfer::Status::Apart);
}

void TestUvTransfer::otherPolygonsAreAnError()
{
    const MappedModel source = test::mapped(test::box(3), test::boxMap());
    const test::MeshPtr other = test::box(4);
    QVERIFY(transferUvs({*source.mesh, source.uv, *other, UvMatch::Topology}, {}).status ==
            UvTransfer::Status::OtherPolygons);
    jobs::TransferJob job;
    job.source = source.mesh;
    job.sourceUv = source.uv;
    job.mesh = other;
    job.uv = emptyLayout(*other);
    job.match = UvMatch::Topology;
    const Result<jobs::TransferredUvs> made = jobs::runTransfer(job, {});
    QVERIFY(!made);
    QVERIFY(made.error().message.contains(QStringLiteral("faces of the source: 54, of the model: 96")));
    QVERIFY(!made.error().remedy.isEmpty());
}

void TestUvTransfer::equalMeshesGiveEqualBits()
{
    for (const MappedModel &source :
         {test::mapped(test::box(5), test::boxMap()), test::mapped(test::tube(24, 5), test::tubeMap),
          test::mapped(test::sphere(16, 20), test::halvesMap)}) {
        QVERIFY(sameBits(byPosition(source, source.mesh).uv, source.uv));
        const MappedModel other = reversed(source);
        for (const UvMatch match : {UvMatch::Auto, UvMatch::Topology, UvMatch::Position}) {
            const UvTransfer made = transferUvs({*source.mesh, source.uv, *other.mesh, match}, {});
            QVERIFY(sameBits(made.uv, other.uv));
            QCOMPARE(made.figures.copied, other.mesh->faceCount());
        }
    }
}

void TestUvTransfer::boxesOfOtherResolution_data()
{
    QTest::addColumn<int>("cells");
    QTest::addColumn<bool>("triangles");
    QTest::newRow("coarse") << 2 << false;
    QTest::newRow("other cells") << 5 << true;
    QTest::newRow("finer") << 16 << false;
    QTest::newRow("much finer") << 40 << true;
}

void TestUvTransfer::boxesOfOtherResolution()
{
    QFETCH(int, cells);
    QFETCH(bool, triangles);
    const MappedModel source = test::mapped(test::box(8), test::boxMap());
    const test::MeshPtr mesh = test::box(cells, Vec3(2, 2, 2), triangles);
    const UvTransfer made = byPosition(source, mesh);
    QVERIFY(made.status == UvTransfer::Status::Done);
    QCOMPARE(made.figures.copied + made.figures.placed, mesh->faceCount());
    QVERIFY(errorOf(made.uv, mesh, test::boxMap()) < 1e-12);
    QCOMPARE(findCharts(*mesh, made.uv).count, 6);
    QVERIFY(std::abs(made.figures.seamLength - 24) < 1e-9);
    QVERIFY(std::abs(made.figures.sourceSeamLength - 24) < 1e-9);
    QCOMPARE(made.figures.turnedOver + made.figures.collapsed, 0);
    QVERIFY(made.figures.maxDistance < 1e-12);
}

void TestUvTransfer::anotherTriangulation()
{
    const MappedModel source = test::mapped(test::box(6), test::boxMap());
    const test::MeshPtr mesh = test::box(6, Vec3(2, 2, 2), true);
    const UvTransfer made = transferUvs({*source.mesh, source.uv, *mesh}, {});
    QVERIFY(errorOf(made.uv, mesh, test::boxMap()) < 1e-15);
    QCOMPARE(findCharts(*mesh, made.uv).count, 6);
}

void TestUvTransfer::tubesAreCutAtTheirSeam_data()
{
    QTest::addColumn<int>("segments");
    QTest::addColumn<int>("rings");
    QTest::addColumn<double>("angle");
    QTest::newRow("the same seam") << 48 << 3 << 0.0;
    QTest::newRow("coarse") << 9 << 2 << 0.1;
    QTest::newRow("across the seam") << 24 << 7 << pi / 24;
    QTest::newRow("near the seam") << 24 << 7 << 0.01;
    QTest::newRow("fine") << 100 << 12 << 0.02;
}

void TestUvTransfer::tubesAreCutAtTheirSeam()
{
    QFETCH(int, segments);
    QFETCH(int, rings);
    QFETCH(double, angle);
    const MappedModel source = test::mapped(test::tube(32, 4), test::tubeMap);
    const test::MeshPtr mesh = test::tube(segments, rings, angle);
    const UvTransfer made = byPosition(source, mesh);
    QVERIFY(made.status == UvTransfer::Status::Done);
    QCOMPARE(made.figures.placed + made.figures.copied, mesh->faceCount());
    // A face smeared across the seam would be as long as the whole map.
    QVERIFY2(longestSide(*mesh, made.uv) < 1.3, qPrintable(QString::number(longestSide(*mesh, made.uv))));
    QCOMPARE(made.figures.turnedOver + made.figures.collapsed, 0);
    // One straight seam from end to end.
    QCOMPARE(findCharts(*mesh, made.uv).count, 1);
    QVERIFY2(std::abs(made.figures.seamLength - 2) < 1e-9,
             qPrintable(QString::number(made.figures.seamLength)));
}

void TestUvTransfer::islandsStayApart_data()
{
    QTest::addColumn<int>("rings");
    QTest::addColumn<int>("segments");
    QTest::newRow("coarse") << 7 << 9;
    QTest::newRow("like it") << 15 << 21;
    QTest::newRow("fine") << 45 << 50;
    QTest::newRow("equator on edges") << 12 << 17;
}

void TestUvTransfer::islandsStayApart()
{
    QFETCH(int, rings);
    QFETCH(int, segments);
    const MappedModel source = test::mapped(test::sphere(16, 24), test::halvesMap);
    const test::MeshPtr mesh = test::sphere(rings, segments);
    const UvTransfer made = byPosition(source, mesh);
    QVERIFY(made.status == UvTransfer::Status::Done);
    QCOMPARE(made.figures.placed, mesh->faceCount());
    for (int f = 0; f < mesh->faceCount(); ++f) {
        const auto u = made.uv.middleRows(mesh->faceStart[f], 3).col(0);
        QVERIFY(u.maxCoeff() < 5 || u.minCoeff() > 5);
    }
    QCOMPARE(findCharts(*mesh, made.uv).count, 2);
    QCOMPARE(made.figures.turnedOver + made.figures.collapsed, 0);
    // The equator, not a zigzag along it.
    QVERIFY2(made.figures.seamLength < 1.25 * made.figures.sourceSeamLength,
             qPrintable(QString::number(made.figures.seamLength / made.figures.sourceSeamLength)));
    // A side of the map is at most about twice as long as on the model, as in the source.
    QVERIFY(longestSide(*mesh, made.uv) < 1.25 * longestSide(*source.mesh, source.uv));
}

void TestUvTransfer::sidesOfThinPlatesStayApart()
{
    const Vec3 size(2, 2, 0.02);
    const MappedModel source = test::mapped(test::box(6, size), test::boxMap(size));
    // Moved by more than the thickness: the wrong side is nearer.
    const test::MeshPtr lying = test::box(9, size, true);
    PositionMatrix positions = lying->positions;
    positions.col(2).array() += 0.03;
    const test::MeshPtr mesh =
        MeshData::build(positions, lying->faceStart, lying->cornerVertex, lying->faceObject);
    const UvTransfer made = byPosition(source, mesh);
    QVERIFY(made.status == UvTransfer::Status::Done);
    const UvMatrix expected = test::mapped(lying, test::boxMap(size)).uv;
    for (int f = 0; f < mesh->faceCount(); ++f) {
        const Vec3 normal = (mesh->cornerPosition(3 * f + 1) - mesh->cornerPosition(3 * f))
                                .cross(mesh->cornerPosition(3 * f + 2) - mesh->cornerPosition(3 * f));
        if (std::abs(normal.z()) > std::abs(normal.x()) + std::abs(normal.y()))
            QVERIFY((made.uv.middleRows(3 * f, 3) - expected.middleRows(3 * f, 3)).cwiseAbs().maxCoeff() <
                    1e-3);
    }
}

void TestUvTransfer::slitsStayOpen()
{
    // A flat sheet, cut from the middle of one side to its centre; the cut opens by 20 degrees on either
    // side.
    const auto slit = [](const Vec3 &point, const Vec3 &centre) -> Vec2 {
        const Vec2 from(point.x() - 0.5, point.y() - 0.5);
        double angle = std::atan2(from.y(), from.x()); // the cut is at pi
        if (std::abs(std::abs(angle) - pi) < 1e-9)
            angle = centre.y() > 0.5 ? pi : -pi;
        angle *= 8.0 / 9;
        return from.norm() * Vec2(std::cos(angle), std::sin(angle));
    };
    const MappedModel source = test::mapped(test::grid(20), slit);
    for (const int cells : {11, 14, 30}) {
        const test::MeshPtr mesh = test::grid(cells);
        const UvTransfer made = byPosition(source, mesh);
        QVERIFY(made.status == UvTransfer::Status::Done);
        QVERIFY2(longestSide(*mesh, made.uv) < 1.35,
                 qPrintable(QString::number(longestSide(*mesh, made.uv))));
        QCOMPARE(findCharts(*mesh, made.uv).count, 1);
        QVERIFY(std::abs(made.figures.seamLength - 0.5) < 2.01 / cells);
        QCOMPARE(made.figures.turnedOver, 0);
    }
}

void TestUvTransfer::onlyPartsHaveUvs()
{
    MappedModel source = test::mapped(test::box(4), test::boxMap());
    source.uv.topRows(4 * 16).setConstant(std::numeric_limits<double>::quiet_NaN()); // one side of six
    const UvTransfer same = transferUvs({*source.mesh, source.uv, *source.mesh}, {});
    QVERIFY(same.status == UvTransfer::Status::Done);
    QVERIFY(sameBits(same.uv, source.uv));
    QCOMPARE(same.figures.unmatched(), 16);
}

void TestUvTransfer::farFacesAreNotMatched()
{
    const MappedModel source = test::mapped(test::box(4), test::boxMap());
    const MappedModel both = objects({withoutUvs(test::box(5)), withoutUvs(test::box(2))}, 3);
    jobs::TransferJob job;
    job.source = source.mesh;
    job.sourceUv = source.uv;
    job.mesh = both.mesh;
    job.uv = both.uv;
    job.uv.bottomRows(96).setConstant(0.75);
    const Result<jobs::TransferredUvs> made = jobs::runTransfer(job, {});
    QVERIFY(made.ok());
    QCOMPARE(made->figures.unmatched(), 24);
    QCOMPARE(made->unmatched.size(), 24);
    QCOMPARE(made->unmatched.first(), 150);
    QVERIFY(sameBits(made->uv.bottomRows(96), job.uv.bottomRows(96))); // they keep what they had
    QVERIFY(made->warnings().first().startsWith(QStringLiteral("24 of 174 faces")));
}

void TestUvTransfer::modelsElsewhereAreAnError()
{
    const MappedModel source = test::mapped(test::box(4), test::boxMap());
    jobs::TransferJob job;
    job.source = source.mesh;
    job.sourceUv = source.uv;
    job.mesh = test::box(5, Vec3(70, 70, 70)); // between all units
    job.uv = emptyLayout(*job.mesh);
    const Result<jobs::TransferredUvs> made = jobs::runTransfer(job, {});
    QVERIFY(!made);
    QVERIFY2(made.error().message.contains(QStringLiteral("do not lie in one place")) &&
                 made.error().message.contains(QStringLiteral("size 3.464")) &&
                 made.error().message.contains(QStringLiteral("size 121.2")),
             qPrintable(made.error().message));
}

//! A source in metres gives to a model in centimetres what it gives to one in metres; it may lie on its side.
void TestUvTransfer::otherUnitsAndAxes()
{
    const MappedModel source = test::mapped(test::box(4, Vec3(2, 4, 6)), test::boxMap());
    jobs::TransferJob job;
    job.source = source.mesh;
    job.sourceUv = source.uv;
    job.mesh = test::box(5, Vec3(2, 4, 6));
    job.uv = emptyLayout(*job.mesh);
    const Result<jobs::TransferredUvs> there = jobs::runTransfer(job, {});
    QVERIFY(there.ok() && there->placement.isIdentity());
    const transfer::Placement placements[] = {{100, 0}, {0.01, 0}, {100, 1}, {1, -1}};
    for (const transfer::Placement &placement : placements) {
        job.mesh = transfer::placed(*test::box(5, Vec3(2, 4, 6)), placement);
        const Result<jobs::TransferredUvs> made = jobs::runTransfer(job, {});
        QVERIFY2(made.ok(), made ? "" : qPrintable(made.error().toString()));
        QCOMPARE(made->figures.placed, there->figures.placed);
        QCOMPARE(made->placement.scale, placement.scale);
        QCOMPARE(std::abs(made->placement.turn), std::abs(placement.turn)); // a box is the same both ways
        QVERIFY(made->warnings().join(u' ').contains(placement.turn == 0 ? u"other units" : u"axis up"));
    }
}

void TestUvTransfer::objectsGiveToObjects()
{
    const MappedModel model = objects(
        {test::mapped(test::box(4), test::boxMap()), withoutUvs(test::box(4)), withoutUvs(test::box(7)),
         withoutUvs(test::box(3, Vec3(1, 4, 1)))}, // of another shape: it stays as it is
        10);
    const Result<jobs::TransferredUvs> made = jobs::runTransfer(objectJob(model, 0), {});
    QVERIFY(made.ok());
    const int corners = 4 * 96;
    QVERIFY(sameBits(made->uv.topRows(corners), model.uv.topRows(corners)));
    QVERIFY(sameBits(made->uv.middleRows(corners, corners), model.uv.topRows(corners)));
    QVERIFY(errorOf(made->uv.middleRows(2 * corners, 4 * 294), test::box(7), test::boxMap()) < 1e-12);
    QVERIFY(sameBits(made->uv.bottomRows(4 * 54), model.uv.bottomRows(4 * 54)));
    QCOMPARE(made->unmatched.size(), 54);
    QCOMPARE(made->figures.copied, 96);
    QCOMPARE(made->figures.placed, 294);
    QVERIFY(made->figures.moved);
    QVERIFY(made->warnings().join(QLatin1Char(' ')).contains(QStringLiteral("moved onto")));
}

void TestUvTransfer::chosenAndLockedFaces()
{
    const MappedModel model = objects(
        {test::mapped(test::box(2), test::boxMap()), withoutUvs(test::box(2)), withoutUvs(test::box(2))}, 10);
    jobs::TransferJob job = objectJob(model, 0);
    job.faces.assign(72, false);
    std::fill(job.faces.begin() + 24, job.faces.begin() + 48, true);
    const Result<jobs::TransferredUvs> made = jobs::runTransfer(job, {});
    QVERIFY(made.ok());
    QVERIFY(sameBits(made->uv.middleRows(96, 96), model.uv.topRows(96)));
    QVERIFY(sameBits(made->uv.bottomRows(96), model.uv.bottomRows(96)));
    std::vector<IslandFlags> flags(72);
    std::fill(flags.begin() + 24, flags.begin() + 48, IslandFlags{.locked = 1});
    jobs::keepLocked(job, flags);
    QVERIFY(!jobs::runTransfer(job, {}));
}

void TestUvTransfer::badInput_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("mesh");
    for (const char *a : {"triangle", "cube", "grid", "torus", "dirty"}) {
        for (const char *b : {"dirty", "cube", "sphere", "triangle"})
            QTest::addRow("%s to %s", a, b) << QString::fromLatin1(a) << QString::fromLatin1(b);
    }
}

void TestUvTransfer::badInput()
{
    QFETCH(QString, source);
    QFETCH(QString, mesh);
    const test::MeshPtr from = test::meshNamed(source), to = test::meshNamed(mesh);
    const test::MeshPtr none = test::polygonMesh({}, {});
    UvMatrix uv = test::mapped(from, test::boxMap()).uv;
    const UvTransfer made = transferUvs({*from, uv, *to, UvMatch::Position}, {});
    QCOMPARE(made.uv.rows(), to->cornerCount());
    QVERIFY(made.figures.copied + made.figures.placed <= to->faceCount());
    // All UVs on one point, none, infinite ones, and no faces at all.
    QCOMPARE(transferUvs({*from, UvMatrix(UvMatrix::Zero(uv.rows(), 2)), *to}, {}).uv.rows(),
             to->cornerCount());
    uv.setConstant(std::numeric_limits<double>::infinity());
    QVERIFY(transferUvs({*from, uv, *to}, {}).status == UvTransfer::Status::NoUvs);
    QVERIFY(transferUvs({*from, emptyLayout(*from), *to}, {}).status == UvTransfer::Status::NoUvs);
    QVERIFY(transferUvs({*none, UvMatrix(0, 2), *to}, {}).status == UvTransfer::Status::NoUvs);
    uv.setZero();
    QVERIFY(transferUvs({*from, uv, *none}, {}).status == UvTransfer::Status::Done);
    jobs::TransferJob job{from, emptyLayout(*from), -1, {}, to, emptyLayout(*to), {}};
    QVERIFY(!jobs::runTransfer(job, {}));
    job.mesh = none;
    job.uv.resize(0, 2);
    QVERIFY(!jobs::runTransfer(job, {}));
    job.sourceObject = 17;
    QVERIFY(!jobs::runTransfer(job, {}));
}

void TestUvTransfer::stops()
{
    const MappedModel source = test::mapped(test::sphere(30, 30), test::halvesMap);
    const test::MeshPtr mesh = test::sphere(41, 41);
    int asked = 0;
    const auto stopsAt = [&](int call) {
        asked = 0;
        return transferUvs({*source.mesh, source.uv, *mesh}, {[&] { return ++asked >= call; }, {}});
    };
    double last = 0;
    const UvTransfer whole =
        transferUvs({*source.mesh, source.uv, *mesh}, {[&] {
                                                           ++asked;
                                                           return false;
                                                       },
                                                       [&](double fraction) {
                                                           QVERIFY(fraction >= last && fraction <= 1);
                                                           last = fraction;
                                                       }});
    QVERIFY(whole.status == UvTransfer::Status::Done && last > 0.5);
    const int calls = asked;
    QVERIFY(calls > 20);
    for (const int call : {1, 2, calls / 2, calls}) {
        QVERIFY(stopsAt(call).status == UvTransfer::Status::Stopped);
        QVERIFY(asked <= call + 16);
    }
    jobs::TransferJob job;
    job.source = source.mesh;
    job.sourceUv = source.uv;
    job.mesh = mesh;
    job.uv = emptyLayout(*mesh);
    const Result<jobs::TransferredUvs> made = jobs::runTransfer(job, {[] { return true; }, {}});
    QVERIFY(made.ok() && made->stopped);
}

QTEST_GUILESS_MAIN(TestUvTransfer)

} // namespace tst_uvtransfer

#include "tst_uvtransfer.moc"
