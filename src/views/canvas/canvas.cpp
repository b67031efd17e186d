#include "views/canvas/canvas.h"

#include "views/canvas/glresources.h"
#include "views/canvas/overlays.h"
#include "views/canvas/toolmanager.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QOpenGLVersionFunctionsFactory>
#include <QPainter>
#include <QPointer>
#include <QScopedValueRollback>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace autocuts {

namespace {

//! Milliseconds that uploading pictures may take in one turn of the event loop. Chosen by hand.
constexpr int timeOfTurn = 8;

//! The last work between two paints. The timers of all views may be served in one turn of the event loop;
//! then only one view goes on.
struct LastWork
{
    const Canvas *view = nullptr;
    QElapsedTimer time; //!< since its end
};
LastWork lastWork;
constexpr int timeOfOthers = 2; // milliseconds

QSurfaceFormat canvasFormat()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8); // QPainter needs it for clipping
    format.setSamples(4);
    return format;
}

} // namespace

Canvas::Canvas(Kind kind, const StudioContext &context, ToolManager &tools, QWidget *parent)
    : ToolCanvas(kind, context, parent), mTools(tools), mContent(context, kind == Kind::Map)
{
    setFormat(canvasFormat());
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(80, 80);
    connect(&mContent, &SceneContent::changed, this, &Canvas::changePicture);
    mWorkSoon.setSingleShot(true);
    connect(&mWorkSoon, &QTimer::timeout, this, &Canvas::takeTurn);
    mUploadSoon.setSingleShot(true);
    connect(&mUploadSoon, &QTimer::timeout, this, &Canvas::uploadOn);
    for (const auto &[made, pattern] :
         {std::pair(&mTexture, Pattern::Texture), {&mLetters, Pattern::Lettered}}) {
        connect(made, &MadePictures::changed, this, [this, pattern = pattern] {
            mTextureStale |= mPictured == pattern;
            changePicture();
        });
    }
    connect(&context.pictures, &ModelPictures::changed, this, [this] {
        mTextureStale |= mPictured == Pattern::Materials || mPictured == Pattern::Physical;
        changePicture();
    });
    connect(&context.liveBake, &LiveBake::changed, this, [this] {
        mTextureStale |= mPictured == Pattern::Baked;
        changePicture();
    });
    connect(&tools, &ToolManager::overlayChanged, this, qOverload<>(&QWidget::update));
    connect(&tools, &ToolManager::toolChanged, this, &Canvas::updateCursor);
    connect(&tools, &ToolManager::toolChanged, this, &Canvas::changePicture); // it may mark nothing
    connect(&tools, &ToolManager::hintChanged, this, [this] {
        if (mNavigation == Navigation::None)
            updateCursor(); // the cursor may show the state of the tool
    });
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mNavigation = Navigation::None;
        mToolPressed = false;
        studio().view.setHover({});
        if (onlySet() == 0 || mPictured == Pattern::Baked) {
            mTextureStale = true;
            mUploaded = Pattern::None; // the pictures of another model do not stay
        }
        documentReplaced();
    });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Hidden)
            studio().view.setHover({}); // it may be hidden now
    });
    connect(&context.view, &ViewState::optionsChanged, this, &Canvas::choosePicture);
    choosePicture();
}

Canvas::~Canvas()
{
    releaseGl();
}

QRect Canvas::uncovered() const
{
    QRect view = rect();
    if (mCover && mCover->isVisible())
        view.setBottom(std::min(view.bottom(), mapFromGlobal(mCover->mapToGlobal(QPoint())).y() - 1));
    return view;
}

void Canvas::initializeGL()
{
    releaseGl();
    auto *functions = QOpenGLVersionFunctionsFactory::get<GlFunctions>(QOpenGLWidget::context());
    try {
        if (!functions || !functions->initializeOpenGLFunctions())
            throw std::runtime_error(tr("The graphics driver does not offer OpenGL 3.3.").toStdString());
        mGl = std::make_unique<GlResources>(*functions, kind() == Kind::Map);
        if (kind() == Kind::Map)
            mGl->gradual.warmUp(mGl->forMap(), mContent.colors());
    } catch (const std::exception &error) {
        mGlError = QString::fromStdString(error.what());
        return;
    }
    mTextureStale = true;
    mEnvironment.reset();
    mContextGone =
        connect(QOpenGLWidget::context(), &QOpenGLContext::aboutToBeDestroyed, this, &Canvas::releaseGl);
    mContent.markAll();
}

void Canvas::releaseGl()
{
    disconnect(mContextGone);
    if (!mGl)
        return;
    makeCurrent();
    mGl.reset();
    doneCurrent();
}

void Canvas::changePicture()
{
    ++mRevision;
    if (mContent.isLarge() && !mContent.isUpToDate())
        workSoon();
    else
        update();
}

bool Canvas::isTurnOfOthers() const
{
    return lastWork.view != this && lastWork.time.isValid() && !lastWork.time.hasExpired(timeOfOthers);
}

void Canvas::takeTurn()
{
    if (!mGl || !isVisible())
        return; // the next paint goes on
    if (isTurnOfOthers())
        return workSoon();
    workOn();
    lastWork.view = this;
    lastWork.time.start();
}

void Canvas::workOn()
{
    if (!mContent.isLarge() || mContent.isUpToDate())
        return update();
    const int parts = mContent.refreshOne();
    if (parts == 0)
        return workSoon();
    makeCurrent();
    uploadArrays(parts);
    doneCurrent();
    mArraysAreNew = true;
    update();
}

void Canvas::resizeGL(int, int)
{
    viewResized();
}

void Canvas::choosePicture()
{
    const ViewOptions &options = studio().view.options();
    mTextureStale |= options.pattern != mPictured;
    mPictured = options.pattern;
    askForTexture(mTexture, options.texturePath);
    if (options.pattern == Pattern::Lettered)
        askForLetters(mLetters, static_cast<int>(std::lround(options.letteredCells)));
    ++mRevision;
}

int Canvas::onlySet() const
{
    return mPictured == Pattern::Materials || mPictured == Pattern::Physical ? 0 : 1;
}

const Pictures &Canvas::wantedPictures() const
{
    static const Pictures none;
    switch (mPictured) {
    case Pattern::None:
    case Pattern::Checker:
        return none;
    case Pattern::Texture:
        return mTexture.pictures();
    case Pattern::Baked:
        return studio().liveBake.pictures();
    case Pattern::Lettered:
        return mLetters.pictures();
    case Pattern::Materials:
    case Pattern::Physical:
        return studio().pictures.pictures();
    }
    return none;
}

//! Pictures of the same pattern stay until others are there. Those of a bake that goes on replace each other
//! one after another; else a slow upload would never end.
void Canvas::uploadPictures()
{
    PatternTexture &shown = mGl->pictures;
    const bool same = mUploaded == mPictured;
    bool others = shown.show(); // complete since the last turn
    const bool waits = same && mPictured == Pattern::Baked && shown.isBusy() && mPainting;
    if (!waits && std::exchange(mTextureStale, false)) {
        const bool stays = same && shown.has(wantedPictures());
        if (!stays)
            shown.begin(wantedPictures(), same);
        others = others || stays || !same; // others are shown only when they are complete
        mUploaded = mPictured;
    }
    if (shown.isBusy() && mPainting)
        mUploadSoon.start(); // not in the turn in which both views are painted
    else if (shown.isBusy())
        shown.goOn(std::numeric_limits<int>::max());
    others = shown.show() || others;
    if (others && onlySet() == 0)
        mGl->soup.setSets(studio().pictures.triangleSets());
}

//! Between two paints.
void Canvas::uploadOn()
{
    if (!mGl || !mGl->pictures.isBusy())
        return;
    if (isTurnOfOthers()) {
        mUploadSoon.start();
        return;
    }
    makeCurrent();
    mGl->pictures.goOn(timeOfTurn);
    doneCurrent();
    lastWork.view = this;
    lastWork.time.start();
    if (mGl->pictures.isBusy())
        mUploadSoon.start();
    else
        changePicture();
}

//! What only the 3D view needs for texture sets.
void Canvas::uploadForLight()
{
    const bool liveNormals = mPictured == Pattern::Baked && studio().liveBake.isLit();
    if (kind() != Kind::Model || (mPictured != Pattern::Physical && !liveNormals))
        return;
    const ModelPictures &pictures = studio().pictures;
    if (const auto &environment = pictures.light().environment(); environment != mEnvironment) {
        mEnvironment = environment;
        mGl->environment.set(*environment);
    }
    if (mContent.mesh() && (liveNormals || pictures.haveNormals()) && mContent.isUpToDate() &&
        !studio().shownMap.isLive() && mTangentsStale && !mTangents.isRunning())
        makeTangents();
}

//! On another thread. A model has those of its map before until they are there.
void Canvas::makeTangents()
{
    mTangentsStale = false;
    const Scene &scene = studio().workspace.document()->state().scene;
    const auto end = [this, of = scene.mesh](std::span<const float> tangents) {
        if (mGl && mContent.mesh() == of.get() && !studio().shownMap.isLive()) {
            makeCurrent();
            mGl->soup.setTangents(tangents);
            doneCurrent();
        }
        changePicture(); // asks for others when the map has changed meanwhile
    };
    mTangents.start(
        [mesh = scene.mesh, uv = studio().workspace.document()->uv(), hardEdges = scene.hardEdges](
            const std::atomic<bool> &) { return soupTangents(*mesh, uv, hardEdges); },
        [end](const std::vector<float> &tangents) { end(tangents); }, [end](const QString &) { end({}); });
}

//! \param parts SceneContent::Part
void Canvas::uploadArrays(int parts)
{
    if (parts != 0)
        ++mRevision;
    mTangentsStale |= (parts & (SceneContent::Vertices | SceneContent::Uvs)) != 0;
    if ((parts & SceneContent::Vertices) || ((parts & SceneContent::Uvs) && studio().shownMap.isLive()))
        mGl->soup.setTangents({}); // a map that is solved has none
    if (parts & SceneContent::Vertices)
        mGl->soup.setVertices(mContent.vertices());
    if (parts & SceneContent::Uvs)
        mGl->soup.setUvs(mContent.uvs());
    if (parts & SceneContent::Ghost)
        mGl->soup.setGhostUvs(mContent.ghostUvs());
    if (parts & SceneContent::Faces) {
        mGl->soup.setFaces(mContent.faces());
        mGl->soup.setIslands(mContent.triangleIslands());
    }
    if (parts & SceneContent::Sides)
        mGl->soup.setSides(mContent.sides());
    if (parts & SceneContent::Points)
        mGl->points.setPoints(mContent.points());
}

void Canvas::upload()
{
    if (!mPainting || !mContent.isLarge())
        uploadArrays(mContent.refresh());
    else if (!mContent.isUpToDate())
        workSoon();
    uploadPictures();
    uploadForLight();
}

void Canvas::resizeEvent(QResizeEvent *event)
{
    const QScopedValueRollback resizing(mResizing, true);
    ToolCanvas::resizeEvent(event);
    update();
}

void Canvas::paintEvent(QPaintEvent *event)
{
    if (mResizing)
        return; // the window paints it after all views have their sizes
    const QScopedValueRollback painting(mPainting, true);
    ToolCanvas::paintEvent(event);
}

void Canvas::paintGL()
{
    if (mGl) {
        GlFunctions &gl = mGl->gl;
        gl.glDisable(GL_BLEND);
        gl.glDisable(GL_DEPTH_TEST);
        gl.glDisable(GL_CULL_FACE);
        gl.glDisable(GL_SCISSOR_TEST);
        gl.glDisable(GL_STENCIL_TEST);
        gl.glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        if (!mPainting || !showGradually(*mGl)) {
            mGl->gradual.abandon(); // its buffers change
            upload();
            drawScene(*mGl);
        }
        gl.glDisable(GL_BLEND);
        gl.glDisable(GL_DEPTH_TEST);
    }
    if (mGl) {
        // A separate paint device, because a painter on the widget draws to the wrong place while the whole
        // window is grabbed.
        QOpenGLPaintDevice device(size() * devicePixelRatioF());
        device.setDevicePixelRatio(devicePixelRatioF());
        QPainter painter(&device);
        painter.setFont(font());
        painter.setRenderHint(QPainter::Antialiasing);
        drawOverlay(painter);
        if (mContent.mesh() && mTools.tool())
            mTools.tool()->drawOverlay(painter, *this);
    } else {
        QPainter painter(this);
        painter.fillRect(rect(), mContent.colors().backgroundBottom);
        drawMessage(painter, rect(), mContent.colors(), tr("No 3D graphics"), {mGlError});
    }
}

void Canvas::updateCursor()
{
    if (const AbstractTool *tool = mTools.tool())
        setCursor(tool->cursor());
}

std::vector<int> Canvas::selectedSoupCorners() const
{
    const Document *document = studio().workspace.document();
    if (!document)
        return {};
    const MeshData &mesh = document->mesh();
    const SoupTopology &topology = mContent.topology();
    const Selection &selection = document->selection();
    std::vector<bool> selected(mesh.soupCornerCount());
    for (int face : selection.faces) {
        for (const int s : mesh.soupCornersOf(face))
            selected[s] = true;
    }
    for (int edge : selection.edges) {
        for (int side : topology.edgeSides[edge]) {
            if (side >= 0)
                selected[side] = selected[nextSoupCorner(side)] = true;
        }
    }
    std::vector<bool> corners(mesh.cornerCount());
    for (int corner : selection.corners)
        corners[corner] = true;
    std::vector<int> result;
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        if (selected[s] || corners[mesh.cornerOfSoup(s)])
            result.push_back(s);
    }
    return result;
}

Canvas::HoverParts Canvas::hoverParts() const
{
    HoverParts parts;
    const Document *document = studio().workspace.document();
    const Hover &hover = studio().view.hover();
    if (!document || (mTools.tool() && !mTools.tool()->marksHover()))
        return parts;
    const SoupTopology &topology = mContent.topology();
    const SelectionMode mode = document->selection().mode;
    if (mode == SelectionMode::Edges) {
        if (hover.edge >= 0 && hover.edge < static_cast<int>(topology.edgeSides.size()))
            parts.sides = topology.edgeSides[hover.edge];
    } else if (mode != SelectionMode::Vertices && hover.triangle >= 0 &&
               hover.triangle < document->mesh().triangleCount()) {
        const int face = document->mesh().triangleFace[hover.triangle];
        const std::vector<quint32> &islands = mContent.triangleIslands();
        if (mode == SelectionMode::Islands && hover.triangle < static_cast<int>(islands.size()))
            parts.island = islands[hover.triangle];
        const auto triangles = document->mesh().trianglesOf(face);
        parts.triangles = {*triangles.begin(), *triangles.end()};
    }
    return parts;
}

} // namespace autocuts
