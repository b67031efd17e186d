#include "figures/studiopictures.h"

#include "model/plain/uvlayout.h"
#include "support/patience.h"
#include "views/ui/task.h"

#include <QSurfaceFormat>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::figures {

namespace {

constexpr double filled = 0.9;    // share of a picture
constexpr int margin = 90;        // pixels around a picture, where the views draw axes and legends
constexpr int squaresAcross = 30; // of the checkerboard, along the diagonal of the model

Vec3 turned(const Vec3 &p, UpAxis up)
{
    switch (up) {
    case UpAxis::X:
        return {-p.y(), p.x(), p.z()};
    case UpAxis::Y:
        return p;
    case UpAxis::Z:
        return {p.x(), p.z(), -p.y()};
    case UpAxis::MinusY:
        return {-p.x(), -p.y(), p.z()};
    }
    return p;
}

//! The mesh with another axis upwards.
std::shared_ptr<const MeshData> turned(const MeshData &mesh, UpAxis up)
{
    auto result = std::make_shared<MeshData>(mesh);
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v)
        result->positions.row(v) = turned(Vec3(mesh.positions.row(v)), up);
    return result;
}

//! Moves the camera so that the model fills the view.
void fit(OrbitCamera &camera, const SceneContent &content)
{
    const MeshData &mesh = *content.mesh();
    const auto project = [&](Eigen::AlignedBox2d &box) {
        const OrbitProjector projector(camera);
        for (int c = 0; c < mesh.cornerCount(); ++c) {
            ScreenPoint point;
            if (projector.project(content.frame().toFrame(mesh.cornerPosition(c)), point))
                box.extend(Vec2(point.x, point.y));
        }
    };
    camera.frame(Vec3::Zero(), 1);
    for (int i = 0; i < 4; ++i) {
        Eigen::AlignedBox2d box;
        project(box);
        const Vec2 all(camera.viewSize().width(), camera.viewSize().height());
        const Vec2 middle = box.center() - 0.5 * all;
        const double unit = camera.unitsPerPixel();
        camera.setTarget(camera.target() + unit * (middle.x() * camera.right() - middle.y() * camera.up()));
        camera.setDistance(
            camera.distance() *
            box.sizes().cwiseQuotient(filled * (all.array() - 2 * margin).matrix()).maxCoeff());
    }
}

} // namespace

void prepareViews()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSamples(4);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    qputenv("QT_SCALE_FACTOR", "2"); // the pictures are made smaller again
}

StudioPictures::StudioPictures()
{
    mOptions.smoothShading = true;
    mOptions.wireframe = false;
    mOptions.grid = false;
    mOptions.rulers = false;
    mOptions.islandMarks = false;
    mOptions.selection = false;
}

Document &StudioPictures::open(Scene scene, UpAxis up)
{
    if (up != UpAxis::Y)
        scene.mesh = turned(*scene.mesh, up);
    Document &document = mCanvases.open(std::make_unique<Document>(std::move(scene)));
    rest();
    return document;
}

void StudioPictures::rest()
{
    const auto isDone = [this] {
        return !mCanvases.map.jobs().isBusy() && !mCanvases.solver.isPausing() &&
               mCanvases.map.figuresAreFresh();
    };
    if (!QTest::qWaitFor(isDone, 20 * test::patience))
        qFatal("a job does not end");
}

QImage StudioPictures::grab(Canvas &canvas, const QSize &size)
{
    mCanvases.view.setOptions(mOptions);
    Task::waitForAll(); // textures are read there
    QCoreApplication::processEvents();
    QImage picture = canvas.picture();
    picture.setDevicePixelRatio(1);
    return picture.scaled(canvas.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .copy({{margin, margin}, size})
        .convertToFormat(QImage::Format_RGB32);
}

void StudioPictures::aim(const QSize &size, const Look &look)
{
    mCanvases.mesh.resize(size + 2 * QSize(margin, margin));
    QCoreApplication::processEvents();
    OrbitCamera camera = mCanvases.mesh.camera();
    camera.setDirection(look.yaw * std::numbers::pi / 180, look.pitch * std::numbers::pi / 180);
    fit(camera, mCanvases.mesh.content());
    mCanvases.mesh.setCamera(camera);
}

QImage StudioPictures::model(const QSize &size, const Look &look)
{
    aim(size, look);
    return grab(mCanvases.mesh, size);
}

QImage StudioPictures::map(const QSize &size)
{
    mCanvases.uv.resize(size + 2 * QSize(margin, margin));
    QCoreApplication::processEvents();
    Eigen::AlignedBox2d box(Vec2(0, 0), Vec2(1, 1));
    box.extend(layoutBox(document().uv()));
    MapCamera camera;
    camera.setCentre(box.center());
    camera.setScale(0.96 * std::min(size.width() / box.sizes().x(), size.height() / box.sizes().y()));
    mCanvases.uv.setCamera(camera);
    return grab(mCanvases.uv, size);
}

double fittingCheckerSize(const MeshData &mesh, const UvMatrix &uv)
{
    double area = 0, uvArea = 0;
    Eigen::AlignedBox3d box;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        std::array<Vec3, 3> p;
        std::array<Vec2, 3> q;
        for (int k = 0; k < 3; ++k) {
            const int corner = mesh.cornerOfSoup(3 * t + k);
            p[k] = mesh.cornerPosition(corner);
            q[k] = uv.row(corner);
            box.extend(p[k]);
        }
        const Vec2 a = q[1] - q[0], b = q[2] - q[0];
        area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
        uvArea += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
    }
    const double uvPerUnit = std::sqrt(uvArea / std::max(area, 1e-300));
    return std::clamp(std::round(squaresAcross / (uvPerUnit * box.diagonal().norm())), 4.0, 200.0);
}

} // namespace autocuts::figures
