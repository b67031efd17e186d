#include "views/canvas/meshview.h"

#include "views/canvas/axisgizmo.h"
#include "views/canvas/glresources.h"
#include "views/canvas/overlays.h"
#include "views/control/pictures/livebake.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QCborArray>
#include <QPainter>

#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

QMatrix4x4 toQt(const Eigen::Matrix4d &m)
{
    QMatrix4x4 result;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            result(row, column) = static_cast<float>(m(row, column));
    }
    return result;
}

//! Turns the light about the vertical.
QMatrix4x4 lightTurn(double degrees)
{
    QMatrix4x4 turn;
    turn.rotate(static_cast<float>(degrees), 0, 1, 0);
    return turn;
}

} // namespace

MeshView::MeshView(const StudioContext &context, ToolManager &tools, QWidget *parent)
    : Canvas(Kind::Model, context, tools, parent)
{
    setObjectName(u"meshView"_s);
}

MeshView::~MeshView() = default;

void MeshView::setCamera(const OrbitCamera &camera)
{
    mCamera = camera;
    mCamera.setViewSize(size());
    update();
}

const MeshPicker &MeshView::picker() const
{
    const Document &document = *studio().workspace.document();
    const QList<int> &hidden = document.state().hiddenFaces;
    if (!mPicker || mPickerMesh != content().mesh() || mPickerHidden != hidden) {
        mPickerMesh = content().mesh();
        mPickerHidden = hidden;
        mPicker = std::make_unique<const MeshPicker>(content().sharedMesh(), content().frame(),
                                                     content().topology(), document.hidden());
    }
    return *mPicker;
}

PickResult MeshView::pick(const QPointF &pixel) const
{
    return content().mesh() ? picker().pick(mCamera, pixel, isXray()) : PickResult();
}

BoxPick MeshView::pickBox(const PickRegion &region) const
{
    return content().mesh() ? picker().pickBox(mCamera, region, isXray()) : BoxPick();
}

std::vector<int> MeshView::trianglesAt(const QPointF &pixel) const
{
    if (!isXray() || !content().mesh())
        return ToolCanvas::trianglesAt(pixel);
    return picker().trianglesAt(mCamera, pixel);
}

std::optional<QPointF> MeshView::screenOf(int soupCorner) const
{
    const MeshData &mesh = *content().mesh();
    if (content().isHidden(soupCorner))
        return std::nullopt;
    const Vec3 place = content().frame().toFrame(mesh.cornerPosition(mesh.cornerOfSoup(soupCorner)));
    const std::optional<ScreenPoint> point = mCamera.project(place);
    return point ? std::optional(QPointF(point->x, point->y)) : std::nullopt;
}

void MeshView::frameAll()
{
    const MeshData *mesh = content().mesh();
    const bool somethingHidden = mesh && !studio().workspace.document()->state().hiddenFaces.isEmpty();
    std::vector<int> corners;
    for (int s = 0; somethingHidden && s < mesh->soupCornerCount(); ++s) {
        if (!content().isHidden(s))
            corners.push_back(s);
    }
    if (!corners.empty())
        return frameCorners(corners);
    mCamera.frame(Vec3::Zero(), 1);
    update();
}

void MeshView::frameCorners(const std::vector<int> &soupCorners)
{
    Eigen::AlignedBox3d box;
    for (int s : soupCorners)
        box.extend(
            content().frame().toFrame(content().mesh()->cornerPosition(content().mesh()->cornerOfSoup(s))));
    mCamera.frame(box.center(), std::max(0.5 * box.sizes().norm(), 0.005));
    update();
}

void MeshView::frameSelection()
{
    const std::vector<int> corners = selectedSoupCorners();
    if (corners.empty())
        return frameAll();
    frameCorners(corners);
}

QCborMap MeshView::viewState() const
{
    const Vec3 &target = mCamera.target();
    return {{u"target"_s, QCborArray{target.x(), target.y(), target.z()}},
            {u"yaw"_s, mCamera.yaw()},
            {u"pitch"_s, mCamera.pitch()},
            {u"distance"_s, mCamera.distance()}};
}

void MeshView::restoreViewState(const QCborMap &state)
{
    const QCborArray values = state[u"target"_s].toArray();
    const Vec3 target(values[0].toDouble(), values[1].toDouble(), values[2].toDouble());
    const double yaw = state[u"yaw"_s].toDouble(mCamera.yaw()),
                 pitch = state[u"pitch"_s].toDouble(mCamera.pitch());
    const double distance = state[u"distance"_s].toDouble(mCamera.distance());
    if (values.size() == 3 && target.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < 1e4)
        mCamera.setTarget(target);
    if (std::isfinite(yaw) && std::isfinite(pitch))
        mCamera.setDirection(yaw, pitch);
    if (distance > 0)
        mCamera.setDistance(distance);
    update();
}

void MeshView::drawScene(GlResources &gl)
{
    const ViewOptions &options = studio().view.options();
    mCamera.setOrthographic(options.orthographic);
    SoupDrawing drawing;
    drawing.view = toQt(mCamera.viewMatrix());
    drawing.projection = toQt(mCamera.projectionMatrix());

    RoomDrawing room;
    // The far plane is farther away for the ground, which extends beyond the model.
    room.clipMatrix = toQt(mCamera.projectionMatrix(6) * mCamera.viewMatrix());
    room.pixelRatio = devicePixelRatioF();
    room.grid = options.grid;
    const QMatrix4x4 toEnvironment = lightTurn(options.lightTurn);
    const bool lit = (options.pattern == Pattern::Physical && options.shownChannel < 0) ||
                     (options.pattern == Pattern::Baked && studio().liveBake.isLit());
    room.environment = lit && options.showSurroundings ? &gl.environment : nullptr;
    room.toEnvironment = toEnvironment;
    room.exposure = options.exposure;
    room.groundHeight = content().mesh() ? content().frame().lower.y() : 0;
    gl.backdrop.draw(room, content().colors());
    if (!content().mesh() || !content().canBeDrawn())
        return;

    drawing.pixelRatio = devicePixelRatioF();
    drawing.smooth = options.smoothShading;
    drawing.pattern = options.pattern;
    drawing.asItIs = options.pattern == Pattern::Baked && studio().liveBake.isReceiving();
    drawing.checkerSize = options.checkerSize;
    drawing.tileHeight = studio().workspace.document()->packingSettings().tileHeight();
    drawing.pictures = &gl.pictures;
    drawing.onlySet = onlySet();
    drawing.shownChannel = std::max(options.shownChannel, 0);
    drawing.environment = lit ? &gl.environment : nullptr;
    // The view turns directions without changing their lengths.
    drawing.toEnvironment = toEnvironment * QMatrix4x4(drawing.view.normalMatrix()).transposed();
    drawing.exposure = options.exposure;
    drawing.selectionShare = selectionShare(options.coloring);
    drawing.tint = options.coloring == Coloring::Plain ? 0 : 0.5;
    const HoverParts hover = hoverParts();
    drawing.hoverTriangles = hover.triangles;
    drawing.hoverSides = hover.sides;
    drawing.hoverIsland = hover.island;
    drawModel(gl, drawing);
    PointDrawing points;
    points.clipMatrix = drawing.projection * drawing.view;
    points.size = 8 * devicePixelRatioF();
    gl.points.draw(points);
}

//! In X-ray, first everything faintly, then what is in front a little stronger.
void MeshView::drawModel(GlResources &gl, SoupDrawing drawing)
{
    gl.gl.glEnable(GL_BLEND);
    gl.gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (isXray()) {
        drawing.fillOpacity = 0.18;
        drawing.lineOpacity = 0.5;
        gl.soup.draw(drawing, content().colors());
        drawing.fillOpacity = 0.4;
        drawing.lineOpacity = 1;
    }
    gl.gl.glEnable(GL_DEPTH_TEST);
    gl.gl.glDepthFunc(GL_LEQUAL);
    gl.soup.draw(drawing, content().colors());
    if (isXray())
        gl.gl.glDisable(GL_DEPTH_TEST); // for the points
}

void MeshView::drawOverlay(QPainter &painter)
{
    const ViewColors &colors = content().colors();
    if (!content().mesh()) {
        drawMessage(painter, rect(), colors, tr("Open a model"),
                    {tr("Drop a file here, or choose File > Open")});
        return;
    }
    drawAxisGizmo(painter, rect(), colors, mCamera, mHoveredAxis);
    QStringList badges;
    if (isXray())
        badges << tr("X-ray");
    if (const auto hidden = studio().workspace.document()->state().hiddenFaces.size(); hidden > 0)
        badges << tr("Hidden faces: %1").arg(hidden);
    if (!badges.isEmpty())
        drawBadge(painter, rect(), colors, badges.join(tr(", ")));
    const QRectF legend =
        drawLegend(painter, uncovered(), colors, studio().view.options(),
                   studio().preferences.values().colorBlindHeatMap, content().rightDensity());
    if (content().showsStraight())
        drawStraightLegend(painter, uncovered(), colors, legend);
    drawHoverCorner(painter, *this);
}

void MeshView::navigate(Navigation navigation, const QPointF &pixels, const QPointF &)
{
    switch (navigation) {
    case Navigation::Orbit:
        mCamera.orbit(pixels);
        break;
    case Navigation::Pan:
        mCamera.pan(pixels);
        break;
    case Navigation::Zoom:
        mCamera.zoom(dragZoomFactor(pixels.x() - pixels.y()));
        break;
    case Navigation::None:
        break;
    }
}

void MeshView::zoomAt(double factor, const QPointF &)
{
    mCamera.zoom(factor);
}

void MeshView::lookFrom(ViewSide side)
{
    mCamera.lookFrom(side);
    update();
}

bool MeshView::overlayTakes(const QPointF &pixel, bool pressed)
{
    const std::optional<AxisEnd> end = axisEndAt(rect(), mCamera, pixel);
    if (end && pressed)
        lookFrom(end->clicked());
    const std::optional<ViewSide> hovered = end ? std::optional(end->side) : std::nullopt;
    if (mHoveredAxis != hovered) {
        mHoveredAxis = hovered;
        update();
    }
    return end.has_value();
}

void MeshView::viewResized()
{
    mCamera.setViewSize(size());
}

void MeshView::documentReplaced()
{
    mPicker.reset();
    mCamera = OrbitCamera();
    mCamera.setViewSize(size());
    frameAll();
}

} // namespace autocuts
