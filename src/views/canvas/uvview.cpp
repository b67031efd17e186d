#include "views/canvas/uvview.h"

#include "model/document/materialcolor.h"
#include "model/plain/uvlayout.h"
#include "views/canvas/glresources.h"
#include "views/canvas/mapgrid.h"
#include "views/canvas/mapoverlays.h"
#include "views/canvas/mappicker.h"
#include "views/canvas/overlays.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/ui/preferences.h"

#include <QCborArray>
#include <QPainter>

#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Milliseconds that the picture may take within a paint event, and in one turn of the event loop. Chosen by
//! hand.
constexpr int timeOfPaint = 8, timeOfPieces = 16;
//! Milliseconds after which a view keeps its size: until then it shows the last picture, for a driver takes
//! long to make room for another size. Chosen by hand.
constexpr int timeToSettle = 100;

//! True when a hidden face has UVs.
bool hidesUvs(const Document &document)
{
    const std::vector<bool> &hidden = document.hidden();
    const MeshData &mesh = document.mesh();
    for (int face = 0; face < std::ssize(hidden); ++face) {
        if (hidden[face] && document.uv().row(mesh.faceStart[face]).allFinite())
            return true;
    }
    return false;
}

} // namespace

UvView::UvView(const StudioContext &context, ToolManager &tools, QWidget *parent)
    : Canvas(Kind::Map, context, tools, parent)
{
    setObjectName(u"uvView"_s);
    mSizeSettles.setSingleShot(true);
    mSizeSettles.setInterval(timeToSettle);
    connect(&mSizeSettles, &QTimer::timeout, this, qOverload<>(&UvView::update));
    connect(&context.shownMap, &ShownMap::changed, this, [this] {
        const bool isLive = studio().shownMap.isLive();
        if (isLive && studio().view.options().followMap)
            frameAll();
        else if (isLive && !mWasLive)
            frameIfLost();
        mWasLive = isLive;
    });
    const auto lookAtNewMap = [this] {
        const Document *document = studio().workspace.document();
        if (document && !document->token().sameMap(mJobsBegin))
            frameIfLost();
    };
    connect(&context.map, &MapController::done, this, lookAtNewMap);
    connect(&context.map, &MapController::failed, this, lookAtNewMap);
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] {
        const Document *document = studio().workspace.document();
        if (document && studio().map.jobs().isBusy())
            mJobsBegin = document->token();
    });
    connect(&context.view, &ViewState::toolsChanged, this, qOverload<>(&UvView::update));
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, qOverload<>(&UvView::update));
}

UvView::~UvView() = default;

void UvView::setCamera(const MapCamera &camera)
{
    mCamera = camera;
    mCamera.setViewSize(size());
    mFramesAll = false;
    update();
}

PickResult UvView::pick(const QPointF &pixel) const
{
    const MeshData *mesh = content().mesh();
    return mesh ? pickMap(*mesh, content().topology(), content().uv(), mCamera, pixel) : PickResult();
}

BoxPick UvView::pickBox(const PickRegion &region) const
{
    const MeshData *mesh = content().mesh();
    return mesh ? pickMapBox(*mesh, content().topology(), content().uv(), mCamera, region) : BoxPick();
}

std::optional<QPointF> UvView::screenOf(int soupCorner) const
{
    const Vec2 place = content().uv().row(soupCorner);
    return place.allFinite() ? std::optional(mCamera.toScreen(place)) : std::nullopt;
}

PackingSettings UvView::packing() const
{
    if (const Document *document = studio().workspace.document())
        return document->packingSettings();
    PackingSettings settings;
    settings.textureSize = studio().preferences.values().textureSize;
    return settings;
}

QMarginsF UvView::covered() const
{
    return studio().view.options().rulers ? QMarginsF(rulerSize, rulerSize, 0, 0) : QMarginsF();
}

void UvView::frameAll()
{
    constexpr double farAway = 30; // sizes of the map: beside the tile it would be too small to see
    const Eigen::AlignedBox2d tile(Vec2(0, 0), Vec2(1, packing().tileHeight()));
    Eigen::AlignedBox2d box = tile;
    if (content().mesh()) {
        const Eigen::AlignedBox2d map = layoutBox(content().uv());
        box.extend(map);
        if (!map.isEmpty() && !tile.intersects(map) &&
            box.sizes().maxCoeff() > farAway * map.sizes().maxCoeff())
            box = map;
    }
    mCamera.frame(box, covered());
    mFramesAll = true;
    update();
}

//! Frames a map that was just made where the view looks at the place of the one before, far away.
void UvView::frameIfLost()
{
    constexpr double leastSide = 24; // logical pixels
    const Eigen::AlignedBox2d box = content().mesh() ? layoutBox(content().uv()) : Eigen::AlignedBox2d();
    const Eigen::AlignedBox2d seen(mCamera.toUv(rect().bottomLeft()), mCamera.toUv(rect().topRight()));
    if (!box.isEmpty() && (!seen.intersects(box) || box.sizes().maxCoeff() * mCamera.scale() < leastSide))
        frameAll();
}

void UvView::frameSelection()
{
    Eigen::AlignedBox2d box;
    for (int s : selectedSoupCorners()) {
        const Vec2 place = content().uv().row(s);
        if (place.allFinite())
            box.extend(place);
    }
    if (box.isEmpty())
        return frameAll();
    mCamera.frame(box, covered());
    mFramesAll = false;
    update();
}

QCborMap UvView::viewState() const
{
    return {{u"centre"_s, QCborArray{mCamera.centre().x(), mCamera.centre().y()}},
            {u"scale"_s, mCamera.scale()}};
}

void UvView::restoreViewState(const QCborMap &state)
{
    const QCborArray values = state[u"centre"_s].toArray();
    const Vec2 centre(values[0].toDouble(), values[1].toDouble());
    const double scale = state[u"scale"_s].toDouble();
    if (values.size() != 2 || !centre.allFinite() || !(scale > 0))
        return;
    mCamera.setCentre(centre);
    mCamera.setScale(scale);
    mFramesAll = false;
    update();
}

//! Of texture sets; of a live bake, the normals.
int UvView::shownChannel() const
{
    const ViewOptions &options = studio().view.options();
    return options.pattern == Pattern::Baked ? int(TextureChannel::Normal)
                                             : std::max(options.shownChannel, 0);
}

PaperDrawing UvView::paper(GlResources &gl) const
{
    const ViewOptions &options = studio().view.options();
    const PackingSettings texture = packing();
    PaperDrawing paper = paperDrawing(mCamera, devicePixelRatioF(), texture);
    paper.grid = options.grid;
    paper.pattern = options.pattern;
    paper.checkerSize = options.checkerSize;
    paper.pictures = &gl.pictures;
    paper.shownChannel = shownChannel();
    if (onlySet() == 0)
        paper.pictureSet = studio().pictures.shownSet();
    if (paper.pictureSet < 0)
        paper.pattern = Pattern::None;
    paper.patternStrength = options.fillIslands && content().mesh() ? 0.3 : 1;
    paper.lineWidth = devicePixelRatioF();
    const Vec2 used =
        studio().shownMap.isLive() ? Vec2(Vec2::Ones()) : usedTiles(content().uvBox(), texture.tileHeight());
    paper.usedTiles = {static_cast<float>(used.x()), static_cast<float>(used.y())};
    return paper;
}

//! \pre the buffers are up to date
MapScene UvView::scene(GlResources &gl) const
{
    const ViewOptions &options = studio().view.options();
    MapScene scene;
    scene.paper = paper(gl);
    scene.colors = content().colors();
    scene.camera = mCamera;
    scene.pixelRatio = devicePixelRatioF();
    scene.revision = revision();
    scene.uvs = content().uvs();
    scene.ghostUvs = content().ghostUvs();
    scene.faces = content().faces();
    scene.pointCount = static_cast<int>(content().points().size());
    if (!content().mesh())
        return scene;
    SoupDrawing drawing;
    const Vec2 scale(2 * mCamera.scale() / width(), 2 * mCamera.scale() / height());
    const Vec2 offset = -scale.cwiseProduct(mCamera.centre());
    drawing.mapScale = {static_cast<float>(scale.x()), static_cast<float>(scale.y())};
    drawing.mapOffset = {static_cast<float>(offset.x()), static_cast<float>(offset.y())};
    drawing.pixelRatio = devicePixelRatioF();
    const bool plain = options.coloring == Coloring::Plain;
    const bool textured = options.pattern != Pattern::None;
    drawing.onPicture = textured;
    drawing.fillOpacity = !options.fillIslands ? 0 : plain && !textured ? 0.4 : 0.85;
    // Filled islands do not hide the pattern, but show it.
    drawing.pattern = options.pattern;
    drawing.checkerSize = options.checkerSize;
    drawing.tileHeight = packing().tileHeight();
    drawing.pictures = &gl.pictures;
    drawing.onlySet = onlySet();
    drawing.shownChannel = shownChannel();
    drawing.selectionShare = selectionShare(options.coloring);
    drawing.tint = plain ? 0 : 0.5;
    const HoverParts hover = hoverParts();
    drawing.hoverTriangles = hover.triangles;
    drawing.hoverSides = hover.sides;
    drawing.hoverIsland = hover.island;
    if (!content().ghostUvs().empty()) {
        scene.ghost = drawing;
        scene.ghost->ghost = true;
        const double strength = studio().shownMap.ghostStrength();
        scene.ghost->fillOpacity = 0.5 * strength * drawing.fillOpacity;
        scene.ghost->lineOpacity = 0;
        drawing.fillOpacity *= 1 - 0.3 * strength;
    }
    scene.map = drawing;
    scene.points.asMap = true;
    scene.points.mapScale = drawing.mapScale;
    scene.points.mapOffset = drawing.mapOffset;
    scene.points.size = 8 * devicePixelRatioF();
    return scene;
}

void UvView::drawScene(GlResources &gl)
{
    autocuts::drawScene(gl.forMap(), scene(gl));
}

bool UvView::showGradually(GlResources &gl)
{
    const QSize pixels = size() * devicePixelRatioF();
    GradualPicture &picture = gl.gradual;
    const bool lastOneDoes = picture.isShown() && mSizeSettles.isActive();
    if (!arraysComeFirst() && !lastOneDoes && !picture.isBusy() && !picture.has(scene(gl), pixels)) {
        upload();
        pictureBegins();
        picture.begin(scene(gl), pixels);
        picture.goOn(gl.forMap(), timeOfPaint);
    }
    picture.show(gl.forMap(), defaultFramebufferObject(), pixels, mCamera);
    if (picture.isBusy() || arraysComeFirst())
        workSoon();
    return true;
}

void UvView::workOn()
{
    GlResources &gl = *resources();
    if (!gl.gradual.isBusy())
        return Canvas::workOn();
    makeCurrent();
    gl.gradual.goOn(gl.forMap(), timeOfPieces);
    doneCurrent();
    if (gl.gradual.isBusy())
        workSoon();
    else
        update();
}

void UvView::drawOverlay(QPainter &painter)
{
    const ViewColors &colors = content().colors();
    const ViewOptions &options = studio().view.options();
    const Document *document = studio().workspace.document();
    const PackingSettings texture = packing();
    if (options.grid)
        drawTileNames(painter, rect(), colors, mCamera, texture.tileHeight());
    if (options.grid && document && studio().map.figuresAreFresh() && !studio().shownMap.isLive())
        drawTilesInUse(painter, rect(), colors, mCamera, texture.tileHeight(), tilesInUse());
    if (document && options.steering)
        drawRectangles(painter, document->constraints().rectangles, mCamera);
    if (document && content().uvBox().isEmpty()) {
        MapController &map = studio().map;
        if (hidesUvs(*document))
            drawMessage(painter, rect(), colors, tr("All of the map is hidden"),
                        {tr("View > Show all hidden brings it back")});
        else if (map.makesMap())
            drawMessage(painter, rect(), colors, map.jobs().title(),
                        {tr("The map appears here as soon as there is one")});
        else
            drawMessage(painter, rect(), colors, tr("No UVs yet"),
                        mEmptyHint ? QStringList{mEmptyHint()} : QStringList());
    }
    if (options.rulers)
        drawRulers(painter, rect(), colors, mCamera, texture.textureSize);
    if (document && (options.islandMarks || options.islandNumbers) && !studio().shownMap.isLive())
        drawIslandMarks(painter, rect(), colors, *document, mCamera, options.islandMarks,
                        options.islandNumbers);
    if (document && options.problems && studio().map.figuresAreFresh() && !studio().shownMap.isLive())
        drawOffTile(painter, colors, *document, mCamera, studio().map.figures()->islandsOffTile);
    if (document && studio().view.tools().pivot == Pivot::Cursor)
        drawCursor(painter, colors, mCamera.toScreen(studio().view.tools().cursor));
    if (document) {
        const QRectF legend =
            drawLegend(painter, uncovered(), colors, options, studio().preferences.values().colorBlindHeatMap,
                       content().rightDensity());
        if (content().showsStraight())
            drawStraightLegend(painter, uncovered(), colors, legend);
        drawHoverCorner(painter, *this);
    }
}

//! More than one, of the map that was measured last; otherwise none. Those of one material have its colour.
std::vector<std::pair<int, QColor>> UvView::tilesInUse() const
{
    constexpr int tint = 70; // of 255
    const Pattern pattern = studio().view.options().pattern;
    // The colours of pictures are to be seen as they are.
    const bool isTinted =
        pattern == Pattern::None || pattern == Pattern::Checker || pattern == Pattern::Lettered;
    const MapFigures &figures = *studio().map.figures();
    const Scene &scene = studio().workspace.document()->state().scene;
    std::vector<std::pair<int, QColor>> tiles;
    for (const metrics::TileFigures &tile : figures.metrics.tiles) {
        QColor color;
        if (const auto found = figures.tileMaterial.find(tile.tile);
            isTinted && found != figures.tileMaterial.end()) {
            color = shownMaterialColor(scene, found->second);
            color.setAlpha(tint);
        }
        tiles.emplace_back(tile.tile, color);
    }
    return tiles.size() > 1 ? tiles : std::vector<std::pair<int, QColor>>();
}

void UvView::navigate(Navigation navigation, const QPointF &pixels, const QPointF &start)
{
    mFramesAll = false;
    if (navigation == Navigation::Zoom)
        mCamera.zoom(dragZoomFactor(pixels.x() - pixels.y()), start);
    else // no rotation in the UV view
        mCamera.pan(pixels);
}

void UvView::zoomAt(double factor, const QPointF &pixel)
{
    mFramesAll = false;
    mCamera.zoom(factor, pixel);
}

void UvView::viewResized()
{
    mSizeSettles.start();
    mCamera.setViewSize(size());
    if (mFramesAll)
        frameAll();
}

void UvView::documentReplaced()
{
    frameAll();
}

} // namespace autocuts
