// Islands and their rectangles: what fits keeps its shape, a little too large is deformed, much too large is
// left to packing, which does not take islands for obstacles that have no place yet.
#include "model/plain/uvlayout.h"
#include "solver/base/cornerat.h"
#include "solver/unwrap/liveplacing.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/rectanglefit.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <numbers>

namespace tst_rectanglefit {

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

const double side = std::sqrt(std::numbers::pi); //!< of the unit grid in solver units

//! A flat grid as its own map, with a rectangle for all faces.
struct Boxed
{
    Snapshot snapshot;
    std::shared_ptr<const Soup> soup;
    SeamedMap map;

    explicit Boxed(const Vec2 &size)
    {
        const test::MeshPtr mesh = test::grid(6, 0);
        snapshot.mesh = mesh;
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            uv.row(c) = mesh->positions.row(mesh->cornerVertex[c]).head<2>();
        snapshot.uv = std::make_shared<const UvMatrix>(uv);
        snapshot.uvScale = layoutScale(*mesh, uv);
        UvRectangle box;
        box.lower = Vec2(3, 3);
        box.upper = box.lower + size;
        for (int c = 0; c < mesh->soupCornerCount(); ++c)
            box.soupCorners.push_back(c);
        snapshot.editSteering().rectangles.push_back(box);
        soup = Soup::build(mesh);
        map = *seamedMapOf(*soup, uv / snapshot.uvScale, CutFlags(mesh->edgePairs.size(), false));
    }
};

} // namespace

class TestRectangleFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyWhatIsALittleTooLargeIsDeformed_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<bool>("deformed");
        QTest::newRow("fits") << 1.2 << false;
        QTest::newRow("a little too large") << 0.9 << true;
        QTest::newRow("much too large") << 0.4 << false;
    }
    void onlyWhatIsALittleTooLargeIsDeformed()
    {
        QFETCH(double, width);
        QFETCH(bool, deformed);
        const Boxed boxed(side * Vec2(width, 1.3));
        const FreePart part = *FreePart::of(boxed.snapshot);
        SeamedMap map = boxed.map;
        const std::atomic<bool> stop{true};
        QCOMPARE(fitToRectangles(part, boxed.soup, map, &stop), width < 1);
        QVERIFY(map.x == boxed.map.x);
        QCOMPARE(fitToRectangles(part, boxed.soup, map), width < 1);
        QCOMPARE(map.x != boxed.map.x, deformed);
        if (!deformed)
            return;
        const UvRectangle &box = boxed.snapshot.steering->rectangles.front();
        for (int c = 0; c < boxed.snapshot.mesh->soupCornerCount(); ++c) {
            const Vec2 p = cornerAt(map.x, c);
            QVERIFY((p - p.cwiseMax(box.lower).cwiseMin(box.upper)).norm() < 0.03 * side);
        }
        const double distortion = map.distortion(*boxed.soup);
        QVERIFY(distortion > 4.01 && distortion < 4.5);
    }

    //! An island that was made small for its rectangle is as large as the rectangle allows when that has
    //! become larger, in Unwrap and while solving.
    void islandsGrowWithTheirRectangle()
    {
        constexpr double small = 0.2;
        Boxed boxed(Vec2(0, 0));
        Snapshot &snapshot = boxed.snapshot;
        const UvMatrix before = small * *snapshot.uv;
        snapshot.uv = std::make_shared<const UvMatrix>(before);
        snapshot.uvScale = layoutScale(*snapshot.mesh, before);
        UvRectangle &box = snapshot.editSteering().rectangles.front();
        box.lower = Vec2::Zero();
        box.upper = Vec2::Constant(1 / snapshot.uvScale);
        const auto sideOf = [](const UvMatrix &uv) { return layoutBox(uv).sizes().maxCoeff(); };
        const UnwrapResult unwrapped = unwrapMesh(snapshot, {});
        QVERIFY(unwrapped.packed);
        QVERIFY2(sideOf(unwrapped.uv) > 0.95, qPrintable(QString::number(sideOf(unwrapped.uv))));
        QVERIFY(sideOf(unwrapped.uv) <= 1);
        LivePlacing placing;
        const FreePart part = *FreePart::of(snapshot);
        const auto place = [&] {
            return placing.place(snapshot, part, *boxed.soup, boxed.map, {}, false, {}, PackRotation::Free);
        };
        const UvMatrix grown = place();
        QVERIFY2(sideOf(grown) > 0.9, qPrintable(QString::number(sideOf(grown))));
        // There it stays.
        QVERIFY((place() - grown).cwiseAbs().maxCoeff() < 1e-9);
    }

    //! Two islands that lie in each other's rectangle change places and keep their size.
    void islandsWithoutAPlaceAreNoObstacles()
    {
        const test::MeshPtr mesh = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}});
        UvMatrix uv(8, 2);
        uv << 2.1, 0.1, 2.9, 0.1, 2.9, 0.9, 2.1, 0.9, 0.1, 0.1, 0.9, 0.1, 0.9, 0.9, 0.1, 0.9;
        PackJob pack;
        pack.options.margin = 4;
        pack.options.effort = 0.02;
        pack.rectangles = {{{Vec2(0, 0), Vec2(1, 1)}, {true, false}},
                           {{Vec2(2, 0), Vec2(3, 1)}, {false, true}}};
        QVERIFY(packCharts(*mesh, findCharts(*mesh, uv), pack, uv));
        for (int corner = 0; corner < 8; ++corner) {
            const double left = corner < 4 ? 0 : 2;
            QVERIFY(uv(corner, 0) >= left && uv(corner, 0) <= left + 1);
            QCOMPARE(std::round(1e9 * (uv.row(corner) - uv.row(corner / 4 * 4 + (corner + 1) % 4)).norm()),
                     8e8);
        }
    }
};

QTEST_GUILESS_MAIN(TestRectangleFit)

} // namespace tst_rectanglefit

#include "tst_rectanglefit.moc"
