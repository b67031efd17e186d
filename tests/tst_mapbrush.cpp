// Brushes on a definite map: what they move, and that they neither turn triangles over nor bring overlaps.
#include "model/plain/flippedtriangles.h"
#include "model/plain/uvlayout.h"
#include "solver/base/random.h"
#include "solver/definite/mapbrush.h"
#include "solver/metrics/uvmetrics.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_mapbrush {

using namespace autocuts;
using definite::BrushSpot;
using definite::MapBrush;
using test::MeshPtr;

namespace {

//! The map of a grid by x and y. \param gap by which the right half is moved away
UvMatrix gridMap(const MeshData &mesh, double gap = 0)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        double middle = 0;
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            middle += mesh.cornerPosition(c).x() / (mesh.faceStart[face + 1] - mesh.faceStart[face]);
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            uv.row(c) =
                mesh.cornerPosition(c).head<2>().transpose() + Eigen::RowVector2d(middle > 0.5 ? gap : 0, 0);
    }
    return uv;
}

std::vector<bool> nothingHeld(const MeshData &mesh)
{
    return std::vector<bool>(mesh.cornerCount(), false);
}

MapBrush brushOn(const MeshPtr &mesh, const UvMatrix &uv)
{
    return MapBrush(mesh, uv, nothingHeld(*mesh), std::vector<IslandFlags>(mesh->faceCount()));
}

//! A round brush over the nearest triangle.
BrushSpot spotAt(const MeshData &mesh, const UvMatrix &uv, const Vec2 &centre, double radius,
                 double strength = 1)
{
    BrushSpot spot;
    spot.centre = centre;
    spot.radius = radius;
    spot.effect = [=](double d) { return strength * std::pow(1 - d * d / (radius * radius), 2); };
    double best = std::numeric_limits<double>::infinity();
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        Vec2 middle = Vec2::Zero();
        for (int corner : mesh.triangles[t])
            middle += uv.row(corner).transpose() / 3;
        if (const double distance = (middle - centre).norm(); distance < best) {
            best = distance;
            spot.triangle = t;
        }
    }
    return spot;
}

metrics::UvMetrics measured(const MeshData &mesh, const UvMatrix &uv)
{
    return metrics::measureUv(mesh, uv);
}

} // namespace

class TestMapBrush : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void relaxingLowersTheDistortionUnderIt()
    {
        const MeshPtr mesh = test::grid(16);
        UvMatrix uv = gridMap(*mesh);
        for (Eigen::Index c = 0; c < uv.rows(); ++c) { // a dent around the middle
            const Vec2 off = uv.row(c).transpose() - Vec2(0.5, 0.5);
            uv.row(c) += 0.05 * std::exp(-40 * off.squaredNorm()) * Eigen::RowVector2d(1, 0.5);
        }
        MapBrush brush = brushOn(mesh, uv);
        double before = measured(*mesh, uv).symDirichlet;
        for (int i = 0; i < 20; ++i) {
            QVERIFY(brush.relax(spotAt(*mesh, brush.uv(), {0.5, 0.5}, 0.4)));
            const double now = measured(*mesh, brush.uv()).symDirichlet;
            QVERIFY(now <= before + 1e-12);
            before = now;
        }
        QVERIFY2(before < 4.01, qPrintable(QString::number(before)));
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            if ((uv.row(c).transpose() - Vec2(0.5, 0.5)).norm() > 0.45)
                QCOMPARE(brush.uv().row(c), uv.row(c));
        }
    }

    void relaxingAnEvenMapChangesNothingMuch()
    {
        const MeshPtr mesh = test::grid(8);
        const UvMatrix uv = gridMap(*mesh);
        MapBrush brush = brushOn(mesh, uv);
        brush.relax(spotAt(*mesh, uv, {0.5, 0.5}, 0.3));
        QVERIFY((brush.uv() - uv).cwiseAbs().maxCoeff() < 1e-9);
    }

    void grabbedPointsFollowAndComeBack()
    {
        const MeshPtr mesh = test::grid(16);
        const UvMatrix uv = gridMap(*mesh);
        MapBrush brush = brushOn(mesh, uv);
        brush.grab(spotAt(*mesh, uv, {0.5, 0.5}, 0.3));
        QVERIFY(brush.pull({0.1, 0.05}));
        double furthest = 0;
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            const Vec2 way = (brush.uv().row(c) - uv.row(c)).transpose();
            const double distance = (uv.row(c).transpose() - Vec2(0.5, 0.5)).norm();
            furthest = std::max(furthest, way.norm());
            if (distance >= 0.3)
                QVERIFY(way.isZero(0));
            else
                QVERIFY((way - std::pow(1 - distance * distance / 0.09, 2) * Vec2(0.1, 0.05)).norm() < 1e-12);
        }
        QVERIFY(std::abs(furthest - Vec2(0.1, 0.05).norm()) < 1e-12);
        QVERIFY(brush.pull({0, 0}));
        QCOMPARE(brush.uv(), uv); // to the bit
    }

    void pinchingDrawsTogetherAndApart()
    {
        const MeshPtr mesh = test::grid(16);
        const UvMatrix uv = gridMap(*mesh);
        const auto meanDistance = [&](const UvMatrix &map) {
            double sum = 0;
            for (Eigen::Index c = 0; c < map.rows(); ++c)
                sum += (map.row(c).transpose() - Vec2(0.5, 0.5)).norm();
            return sum;
        };
        for (const double amount : {0.3, -0.3}) {
            MapBrush brush = brushOn(mesh, uv);
            for (int i = 0; i < 30; ++i)
                brush.pinch(spotAt(*mesh, brush.uv(), {0.5, 0.5}, 0.3), amount);
            QCOMPARE(meanDistance(brush.uv()) < meanDistance(uv), amount > 0);
            QVERIFY((brush.uv() - uv).cwiseAbs().maxCoeff() > 0.02);
            QCOMPARE(measured(*mesh, brush.uv()).flipped, 0);
            QCOMPARE(measured(*mesh, brush.uv()).overlapPairs, 0);
        }
    }

    void islandsDoNotRunIntoEachOther()
    {
        const MeshPtr mesh = test::grid(16);
        const UvMatrix uv = gridMap(*mesh, 0.02);
        MapBrush brush = brushOn(mesh, uv);
        brush.grab(spotAt(*mesh, uv, {0.45, 0.5}, 0.2));
        brush.pull({0.15, 0});
        const UvMatrix &pulled = brush.uv();
        QCOMPARE(measured(*mesh, pulled).overlapPairs, 0);
        double right = 0;
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            if (uv(c, 0) <= 0.5)
                right = std::max(right, pulled(c, 0));
            else
                QCOMPARE(pulled.row(c), uv.row(c)); // the other island stays
        }
        QVERIFY2(right > 0.505 && right <= 0.52, qPrintable(QString::number(right)));
    }

    void smallIslandsAreNotSwallowed()
    {
        // A far and quick pull over a small island: face 0 of a grid, moved into the way.
        const MeshPtr mesh = test::grid(16);
        UvMatrix uv = gridMap(*mesh, 2);
        const Eigen::RowVector2d from = uv.row(0);
        for (int c = mesh->faceStart[0]; c < mesh->faceStart[1]; ++c)
            uv.row(c) = Eigen::RowVector2d(0.55, 0.45) + (uv.row(c) - from) * 0.2;
        MapBrush brush = brushOn(mesh, uv);
        brush.grab(spotAt(*mesh, uv, {0.4, 0.5}, 0.35));
        brush.pull({0.25, 0});
        QCOMPARE(measured(*mesh, brush.uv()).overlapPairs, 0);
    }

    void stackedIslandsMayLieOnEachOther()
    {
        const MeshPtr mesh = test::grid(8);
        const UvMatrix uv = gridMap(*mesh, -0.5); // exactly on each other
        std::vector<IslandFlags> flags(mesh->faceCount());
        for (IslandFlags &flag : flags)
            flag.stack = 1;
        MapBrush stacked(mesh, uv, nothingHeld(*mesh), flags);
        stacked.grab(spotAt(*mesh, uv, {0.25, 0.5}, 0.3));
        QVERIFY(stacked.pull({0.2, 0}));
    }

    void heldPointsStay()
    {
        const MeshPtr mesh = test::grid(16);
        const UvMatrix uv = gridMap(*mesh);
        std::vector<bool> held(mesh->cornerCount(), false);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            held[c] = uv.row(c) == Eigen::RowVector2d(0.5, 0.5);
        MapBrush brush(mesh, uv, held, std::vector<IslandFlags>(mesh->faceCount()));
        for (int i = 0; i < 10; ++i)
            brush.pinch(spotAt(*mesh, brush.uv(), {0.4, 0.4}, 0.3), 0.3);
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            if (held[c])
                QCOMPARE(brush.uv().row(c), uv.row(c));
        }
        QVERIFY(brush.uv() != uv);
    }

    void mirroredMapsAreBrushedLikeOthers()
    {
        const MeshPtr mesh = test::grid(16);
        UvMatrix uv = gridMap(*mesh);
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            const Vec2 off = uv.row(c).transpose() - Vec2(0.5, 0.5);
            uv.row(c) += 0.05 * std::exp(-40 * off.squaredNorm()) * Eigen::RowVector2d(1, 0.5);
        }
        UvMatrix turned = uv;
        turned.col(0) = 1 - turned.col(0).array();
        MapBrush brush = brushOn(mesh, uv), mirrored = brushOn(mesh, turned);
        BrushSpot spot = spotAt(*mesh, uv, {0.45, 0.5}, 0.3);
        brush.relax(spot);
        spot.centre.x() = 0.55;
        mirrored.relax(spot);
        UvMatrix back = mirrored.uv();
        back.col(0) = 1 - back.col(0).array();
        QVERIFY(brush.uv() != uv);
        QVERIFY((back - brush.uv()).cwiseAbs().maxCoeff() < 1e-9);
    }

    void anyStrokesLeaveTheMapValid_data()
    {
        QTest::addColumn<double>("gap");
        QTest::newRow("one island") << 0.0;
        QTest::newRow("two islands") << 0.01;
    }

    void anyStrokesLeaveTheMapValid()
    {
        QFETCH(double, gap);
        const MeshPtr grid = test::grid(12, 0.3);
        const UvMatrix uv = gridMap(*grid, gap);
        MapBrush brush = brushOn(grid, uv);
        Random random(7);
        for (int stroke = 0; stroke < 60; ++stroke) {
            const Vec2 centre(random.uniform(), random.uniform());
            const BrushSpot spot = spotAt(*grid, brush.uv(), centre, 0.1 + 0.3 * random.uniform());
            switch (stroke % 3) {
            case 0:
                brush.relax(spot);
                break;
            case 1:
                brush.pinch(spot, random.uniform() - 0.5);
                break;
            default:
                brush.grab(spot);
                brush.pull({random.uniform() - 0.5, random.uniform() - 0.5});
                brush.pull({random.uniform() - 0.5, random.uniform() - 0.5});
            }
            const metrics::UvMetrics m = measured(*grid, brush.uv());
            QCOMPARE(m.flipped, 0);
            QCOMPARE(m.overlapPairs, 0);
        }
        QVERIFY((brush.uv() - uv).cwiseAbs().maxCoeff() > 0.1);
    }

    void brokenMapsDoNoHarm()
    {
        const MeshPtr mesh = test::dirty();
        Random random(3);
        UvMatrix uv(mesh->cornerCount(), 2);
        for (Eigen::Index c = 0; c < uv.rows(); ++c)
            uv.row(c) = Eigen::RowVector2d(random.uniform(), random.uniform());
        uv.row(0).setConstant(std::nan(""));
        MapBrush brush = brushOn(mesh, uv);
        for (int t = -1; t <= mesh->triangleCount(); ++t) {
            BrushSpot spot = spotAt(*mesh, uv, {0.5, 0.5}, 0.4);
            spot.triangle = t;
            brush.relax(spot);
            brush.pinch(spot, 0.3);
            brush.grab(spot);
            brush.pull({0.1, 0.1});
        }
        for (Eigen::Index c = 1; c < uv.rows(); ++c)
            QVERIFY(brush.uv().row(c).allFinite());
    }
};

QTEST_APPLESS_MAIN(TestMapBrush)

} // namespace tst_mapbrush

#include "tst_mapbrush.moc"
