// The cameras of both views, the presets of navigation and the steps of the grid; all without OpenGL.
#include "solver/base/random.h"
#include "views/canvas/axisgizmo.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/mapgrid.h"
#include "views/canvas/navigation.h"
#include "views/canvas/orbitcamera.h"

#include <Eigen/Geometry>
#include <QRect>
#include <QTest>

#include <cmath>
#include <numbers>

namespace tst_cameras {

using namespace autocuts;

namespace {

Vec3 randomPoint(Random &random)
{
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
}

OrbitCamera randomCamera(Random &random, bool orthographic)
{
    OrbitCamera camera;
    camera.setViewSize({random.uniform(50, 2000), random.uniform(50, 2000)});
    camera.setTarget(0.3 * randomPoint(random));
    camera.setDirection(random.uniform(-4, 4), random.uniform(-1.5, 1.5));
    camera.setDistance(random.uniform(3, 40));
    camera.setOrthographic(orthographic);
    return camera;
}

} // namespace

class TestCameras : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void raysMeetWhatIsProjected_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("perspective") << false;
        QTest::newRow("orthographic") << true;
    }

    void raysMeetWhatIsProjected()
    {
        QFETCH(bool, orthographic);
        Random random(1);
        for (int i = 0; i < 200; ++i) {
            const OrbitCamera camera = randomCamera(random, orthographic);
            const Vec3 point = randomPoint(random);
            const auto seen = camera.project(point);
            QVERIFY(seen);
            const ViewRay ray = camera.ray({seen->x, seen->y});
            const Vec3 offset = point - ray.origin;
            QVERIFY(offset.dot(ray.direction) > 0);
            QVERIFY(offset.cross(ray.direction).norm() < 1e-9 * camera.distance());
            QVERIFY(std::abs(ray.direction.norm() - 1) < 1e-12);
        }
    }

    void matricesDrawWhereProjectSays_data() { raysMeetWhatIsProjected_data(); }

    void matricesDrawWhereProjectSays()
    {
        QFETCH(bool, orthographic);
        Random random(2);
        for (int i = 0; i < 200; ++i) {
            const OrbitCamera camera = randomCamera(random, orthographic);
            const Vec3 point = 0.55 * randomPoint(random); // within the ball that near and far hold
            const Eigen::Vector4d clip =
                camera.projectionMatrix() * camera.viewMatrix() * point.homogeneous();
            const auto seen = camera.project(point);
            QVERIFY(seen);
            const QSizeF size = camera.viewSize();
            QVERIFY(std::abs(0.5 * (1 + clip.x() / clip.w()) * size.width() - seen->x) < 1e-6);
            QVERIFY(std::abs(0.5 * (1 - clip.y() / clip.w()) * size.height() - seen->y) < 1e-6);
            QVERIFY(std::abs(clip.z() / clip.w()) <= 1);
            // Farther points have larger depths in the buffer as well.
            const Vec3 farther = point + 0.05 * camera.forward();
            const Eigen::Vector4d second =
                camera.projectionMatrix() * camera.viewMatrix() * farther.homogeneous();
            QVERIFY(second.z() / second.w() > clip.z() / clip.w());
        }
    }

    void pointsBehindTheEyeAreNotSeen()
    {
        OrbitCamera camera;
        QVERIFY(!camera.project(camera.eye() - 0.1 * camera.forward()));
        QVERIFY(camera.project(camera.eye() + 0.1 * camera.forward()));
    }

    void panningMovesTheTargetWithTheMouse()
    {
        OrbitCamera camera;
        camera.setViewSize({640, 480});
        const Vec3 target = camera.target();
        camera.pan({30, -12});
        const auto seen = camera.project(target);
        QVERIFY(seen);
        QVERIFY(std::abs(seen->x - (320 + 30)) < 1e-9);
        QVERIFY(std::abs(seen->y - (240 - 12)) < 1e-9);
    }

    void orbitingStopsAtThePoles()
    {
        OrbitCamera camera;
        camera.orbit({0, 1e5});
        QCOMPARE(camera.pitch(), std::numbers::pi / 2);
        camera.orbit({1e5, -1e6});
        QCOMPARE(camera.pitch(), -std::numbers::pi / 2);
        QVERIFY(std::abs(camera.yaw()) <= std::numbers::pi);
        QVERIFY(std::abs(camera.up().dot(camera.forward())) < 1e-12);
    }

    void framingFillsTheView_data()
    {
        QTest::addColumn<QSizeF>("size");
        QTest::newRow("wide") << QSizeF(1600, 400);
        QTest::newRow("high") << QSizeF(300, 900);
        QTest::newRow("square") << QSizeF(500, 500);
    }

    void framingFillsTheView()
    {
        QFETCH(QSizeF, size);
        OrbitCamera camera;
        camera.setViewSize(size);
        const Vec3 centre(0.2, -0.1, 0.4);
        camera.frame(centre, 0.25);
        const auto middle = camera.project(centre), side = camera.project(centre + 0.25 * camera.right());
        QVERIFY(std::abs(middle->x - size.width() / 2) < 1e-9);
        QVERIFY(std::abs(middle->y - size.height() / 2) < 1e-9);
        const double share = (side->x - middle->x) / (0.5 * std::min(size.width(), size.height()));
        QVERIFY2(share > 0.85 && share < 1.15, qPrintable(QString::number(share)));
    }

    void wildNumbersAreClamped()
    {
        OrbitCamera camera;
        for (int i = 0; i < 5000; ++i)
            camera.zoom(1.5);
        QVERIFY(camera.distance() > 0);
        for (int i = 0; i < 5000; ++i)
            camera.zoom(0.5);
        QVERIFY(std::isfinite(camera.distance()));
        QVERIFY(camera.projectionMatrix().allFinite());
        MapCamera map;
        for (int i = 0; i < 5000; ++i)
            map.zoom(2, {3, 5});
        QVERIFY(map.centre().allFinite());
        QCOMPARE(map.scale(), MapCamera::maxScale);
    }

    void mapZoomKeepsWhatIsUnderTheMouse()
    {
        Random random(3);
        MapCamera camera;
        camera.setViewSize({700, 500});
        for (int i = 0; i < 100; ++i) {
            const QPointF pixel(random.uniform(0, 700), random.uniform(0, 500));
            const Vec2 before = camera.toUv(pixel);
            camera.zoom(random.uniform(0.5, 2), pixel);
            QVERIFY((camera.toUv(pixel) - before).norm() < 1e-9);
            const QPointF back = camera.toScreen(camera.toUv(pixel));
            QVERIFY(std::hypot(back.x() - pixel.x(), back.y() - pixel.y()) < 1e-6);
        }
        // v is up.
        QVERIFY(camera.toUv({0, 10}).y() > camera.toUv({0, 20}).y());
    }

    void mapFramingShowsTheWholeBox()
    {
        MapCamera camera;
        camera.setViewSize({700, 300});
        camera.frame({Vec2(2, 3), Vec2(2.5, 7)});
        const QRectF view(0, 0, 700, 300);
        QVERIFY(view.contains(camera.toScreen(Vec2(2, 3))));
        QVERIFY(view.contains(camera.toScreen(Vec2(2.5, 7))));
        QVERIFY(camera.toScreen(Vec2(2, 3)).y() - camera.toScreen(Vec2(2, 7)).y() > 200);
        // In what the rulers leave free.
        camera.frame({Vec2(0, 0), Vec2(1, 1)}, {30, 20, 0, 0});
        const QPointF middle = camera.toScreen(Vec2(0.5, 0.5));
        QVERIFY(std::abs(middle.x() - 365) < 1e-9 && std::abs(middle.y() - 160) < 1e-9);
        QVERIFY(camera.toScreen(Vec2(0, 1)).y() > 20);
        const double scale = camera.scale();
        camera.frame({});
        QCOMPARE(camera.scale(), scale);
    }

    void presetsMoveTheCamera_data()
    {
        using enum Navigation;
        QTest::addColumn<NavigationPreset>("preset");
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::addColumn<Navigation>("expected");
        const auto row = [](const char *name, NavigationPreset preset, Qt::MouseButton button,
                            Qt::KeyboardModifiers modifiers, Navigation expected) {
            QTest::newRow(name) << preset << button << modifiers << expected;
        };
        const NavigationPreset blender = NavigationPreset::Blender, maya = NavigationPreset::Maya;
        row("blender orbit", blender, Qt::MiddleButton, Qt::NoModifier, Orbit);
        row("blender pan", blender, Qt::MiddleButton, Qt::ShiftModifier, Pan);
        row("blender zoom", blender, Qt::MiddleButton, Qt::ControlModifier, Zoom);
        row("blender left", blender, Qt::LeftButton, Qt::NoModifier, None);
        row("blender alt left", blender, Qt::LeftButton, Qt::AltModifier, None);
        row("maya orbit", maya, Qt::LeftButton, Qt::AltModifier, Orbit);
        row("maya pan", maya, Qt::MiddleButton, Qt::AltModifier, Pan);
        row("maya zoom", maya, Qt::RightButton, Qt::AltModifier, Zoom);
        row("maya left", maya, Qt::LeftButton, Qt::NoModifier, None);
        row("maya middle", maya, Qt::MiddleButton, Qt::NoModifier, None);
    }

    void presetsMoveTheCamera()
    {
        QFETCH(NavigationPreset, preset);
        QFETCH(Qt::MouseButton, button);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QFETCH(Navigation, expected);
        QCOMPARE(navigationOf(preset, button, modifiers), expected);
    }

    void sidesOfTheModel_data()
    {
        QTest::addColumn<ViewSide>("side");
        for (const ViewSide side : {ViewSide::Right, ViewSide::Left, ViewSide::Top, ViewSide::Bottom,
                                    ViewSide::Front, ViewSide::Back})
            QTest::addRow("%d", static_cast<int>(side)) << side;
    }

    void sidesOfTheModel()
    {
        QFETCH(ViewSide, side);
        OrbitCamera camera;
        camera.lookFrom(side);
        QVERIFY((camera.forward() + directionOf(side)).norm() < 1e-9);
        QVERIFY((directionOf(side) + directionOf(opposite(side))).norm() < 1e-15);
        // From above and below, the front is at the bottom or top of the picture.
        if (side == ViewSide::Top || side == ViewSide::Bottom)
            QVERIFY((camera.right() - Vec3::UnitX()).norm() < 1e-9);
        else
            QVERIFY((camera.up() - Vec3::UnitY()).norm() < 1e-9);
    }

    void axisGizmo()
    {
        const QRect view(0, 0, 400, 300);
        OrbitCamera camera;
        for (const AxisEnd &end : axisEnds(view, camera)) {
            const std::optional<AxisEnd> hit = axisEndAt(view, camera, end.centre);
            QVERIFY(hit);
            QCOMPARE(hit->side, end.side);
            QCOMPARE(hit->clicked(), end.side);
        }
        QVERIFY(!axisEndAt(view, camera, {200, 150}));
        camera.lookFrom(ViewSide::Front);
        const QPointF middle = axisEnds(view, camera).back().centre;
        QCOMPARE(axisEndAt(view, camera, middle)->side, ViewSide::Front);
        QCOMPARE(axisEndAt(view, camera, middle)->clicked(), ViewSide::Back);
    }

    void presetsHaveKeys()
    {
        const NavigationPreset blender = NavigationPreset::Blender, maya = NavigationPreset::Maya;
        QCOMPARE(navigationKeyOf(blender, Qt::Key_Home, Qt::NoModifier), NavigationKey::FrameAll);
        QCOMPARE(navigationKeyOf(blender, Qt::Key_Period, Qt::KeypadModifier), NavigationKey::FrameSelection);
        QCOMPARE(navigationKeyOf(blender, Qt::Key_Period, Qt::NoModifier), NavigationKey::None);
        QCOMPARE(navigationKeyOf(blender, Qt::Key_F, Qt::NoModifier), NavigationKey::None);
        QCOMPARE(navigationKeyOf(maya, Qt::Key_F, Qt::NoModifier), NavigationKey::FrameSelection);
        QCOMPARE(navigationKeyOf(maya, Qt::Key_A, Qt::NoModifier), NavigationKey::FrameAll);
        QCOMPARE(navigationKeyOf(maya, Qt::Key_A, Qt::ControlModifier), NavigationKey::None);
        QCOMPARE(navigationKeyOf(maya, Qt::Key_Home, Qt::NoModifier), NavigationKey::None);
    }

    void tilesThatAreUsed()
    {
        QCOMPARE(usedTiles({}, 1), Vec2(1, 1));
        QCOMPARE(usedTiles({Vec2(0.1, 0.1), Vec2(0.9, 1.01)}, 1), Vec2(1, 1));
        QCOMPARE(usedTiles({Vec2(0.1, 0.1), Vec2(2.5, 1.1)}, 1), Vec2(3, 2));
        QCOMPARE(usedTiles({Vec2(-9, -9), Vec2(-5, 1e300)}, 1), Vec2(1, 899));
    }

    void gridFollowsTheZoom_data()
    {
        QTest::addColumn<int>("textureSize");
        QTest::newRow("2048") << 2048;
        QTest::newRow("odd") << 1000;
        QTest::newRow("one texel") << 1;
    }

    void gridFollowsTheZoom()
    {
        QFETCH(int, textureSize);
        MapCamera camera;
        for (double scale = MapCamera::minScale; scale < MapCamera::maxScale; scale *= 1.3) {
            camera.setScale(scale);
            const MapGrid grid = MapGrid::of(camera, textureSize);
            QVERIFY(grid.step * scale >= 47.9);
            QVERIFY(grid.step * textureSize >= 0.999);
            QVERIFY(grid.step / grid.divisions * textureSize >= 0.998);
            QVERIFY(grid.strength >= 0 && grid.strength <= 1);
            PackingSettings texture;
            texture.textureSize = textureSize;
            const PaperDrawing paper = paperDrawing(camera, 2, texture);
            QVERIFY(paper.gridPixels >= 2 * 47.9);
        }
    }
};

QTEST_APPLESS_MAIN(TestCameras)

} // namespace tst_cameras

#include "tst_cameras.moc"
