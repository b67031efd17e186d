#include "views/canvas/gradualpicture.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! Nanoseconds that a piece should take. Chosen by hand.
constexpr double pieceTime = 6e6;
//! By how much the time for a pixel may seem to grow and to fall from one piece to the next: a piece takes
//! long by chance where the machine does something else. Chosen by hand.
constexpr double mostGrowth = 4, mostFall = 0.5;

QOpenGLFramebufferObjectFormat smoothFormat()
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(4);
    return format;
}

void drawPaper(const MapRenderers &gl, const MapScene &scene)
{
    gl.gl.glDisable(GL_BLEND);
    gl.gl.glDisable(GL_DEPTH_TEST);
    gl.backdrop.draw(scene.paper, scene.colors);
    gl.gl.glEnable(GL_BLEND);
    gl.gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

//! \param runs null: all triangles
void drawSoup(const MapRenderers &gl, const SoupDrawing &drawing, const ViewColors &colors,
              const TriangleRuns *runs = nullptr)
{
    if (!drawing.ghost) {
        gl.gl.glEnable(GL_DEPTH_TEST);
        gl.gl.glDepthFunc(GL_LEQUAL);
    }
    if (runs)
        gl.soup.draw(drawing, colors, *runs);
    else
        gl.soup.draw(drawing, colors);
    gl.gl.glDisable(GL_DEPTH_TEST);
}

} // namespace

void drawScene(const MapRenderers &gl, const MapScene &scene)
{
    drawPaper(gl, scene);
    if (scene.ghost)
        drawSoup(gl, *scene.ghost, scene.colors);
    if (scene.map) {
        drawSoup(gl, *scene.map, scene.colors);
        gl.points.draw(scene.points);
    }
}

void GradualPicture::warmUp(const MapRenderers &gl, const ViewColors &colors)
{
    // Three: llvmpipe compiles again for buffers whose size is no power of two, as most are.
    constexpr int triangles = 3;
    std::vector<float> uvs;
    for (int t = 0; t < triangles; ++t)
        uvs.insert(uvs.end(), {0, 0, 1, 0, 0, 1});
    constexpr std::array<FaceTexel, triangles> faces{};
    gl.soup.setVertices(std::vector<SoupVertex>(3 * triangles));
    gl.soup.setUvs(uvs);
    gl.soup.setGhostUvs(uvs);
    gl.soup.setFaces(faces);
    gl.soup.setIslands(std::vector<quint32>(triangles));
    gl.soup.setSides(std::vector<SideTexel>(3 * triangles));
    gl.points.setPoints(std::vector<PointVertex>(1));
    MapScene scene;
    scene.colors = colors;
    scene.uvs = scene.ghostUvs = uvs;
    scene.faces = faces;
    scene.pointCount = 1;
    scene.map.emplace().mapScale = {1, 1};
    scene.ghost = scene.map;
    scene.ghost->ghost = true;
    begin(scene, {8, 8});
    while (mBusy)
        goOn(gl, 0);
    show(gl, mDrawn->handle(), mPixels, scene.camera);
    gl.gl.glFinish();
    mShown.reset();
    mKnown = false;
    mPixelTime = firstPixelTime;
}

bool GradualPicture::has(const MapScene &scene, const QSize &pixels) const
{
    return mKnown && mPixels == pixels && mScene.revision == scene.revision &&
           mScene.camera.centre() == scene.camera.centre() && mScene.camera.scale() == scene.camera.scale();
}

void GradualPicture::begin(MapScene scene, const QSize &pixels)
{
    if (!mDrawn || mDrawn->size() != pixels)
        mDrawn = std::make_unique<QOpenGLFramebufferObject>(pixels, smoothFormat());
    mScene = std::move(scene);
    mPixels = pixels;
    mBusy = mKnown = true;
    mRow = mRows = mNext = 0;
    mLayer = Layer::Paper;
}

void GradualPicture::abandon()
{
    mKnown = mKnown && !mBusy;
    mBusy = false;
}

void GradualPicture::goOn(const MapRenderers &gl, int milliseconds)
{
    mDrawn->bind();
    gl.gl.glViewport(0, 0, mPixels.width(), mPixels.height());
    gl.gl.glEnable(GL_SCISSOR_TEST);
    gl.gl.glEnable(GL_BLEND); // as drawPaper() leaves it
    gl.gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    QElapsedTimer clock;
    clock.start();
    while (mBusy) {
        drawPiece(gl);
        if (clock.elapsed() >= milliseconds)
            break;
    }
    gl.gl.glDisable(GL_SCISSOR_TEST);
    gl.gl.glDisable(GL_BLEND);
    QOpenGLFramebufferObject::bindDefault();
}

double GradualPicture::mostWeight() const
{
    return std::max(1.0, pieceTime / mPixelTime);
}

void GradualPicture::learn(double weight, double nanoseconds)
{
    if (weight > 0)
        mPixelTime = std::clamp(nanoseconds / weight, mostFall * mPixelTime, mostGrowth * mPixelTime);
}

void GradualPicture::drawPiece(const MapRenderers &gl)
{
    QElapsedTimer clock;
    clock.start();
    double weight = 0;
    switch (mLayer) {
    case Layer::Paper:
        weight = drawPaperOfStrip(gl);
        break;
    case Layer::Ghost:
        weight = drawTriangles(gl, mScene.ghost, mScene.ghostUvs);
        break;
    case Layer::Map:
        weight = drawTriangles(gl, mScene.map, mScene.uvs);
        break;
    case Layer::Points:
        weight = drawPoints(gl);
        break;
    }
    if (weight > 0) {
        gl.gl.glFinish(); // else all pieces would wait for the last one
        learn(weight, double(clock.nsecsElapsed()));
    }
    if (mRow >= mPixels.height())
        complete(gl);
}

double GradualPicture::drawPaperOfStrip(const MapRenderers &gl)
{
    mRows = std::clamp(static_cast<int>(std::min(mostWeight() / mPixels.width(), 1e6)), 1,
                       mPixels.height() - mRow);
    // From above: llvmpipe also draws samples of the row below.
    gl.gl.glScissor(0, mPixels.height() - mRow - mRows, mPixels.width(), mRows);
    gl.gl.glClear(GL_DEPTH_BUFFER_BIT);
    drawPaper(gl, mScene);
    mLayer = Layer::Ghost;
    return double(mRows) * mPixels.width();
}

double GradualPicture::drawTriangles(const MapRenderers &gl, const std::optional<SoupDrawing> &drawing,
                                     std::span<const float> uvs)
{
    double weight = 0;
    if (drawing) {
        const QVector2D half(0.5f * float(mPixels.width()), 0.5f * float(mPixels.height()));
        const MapOnPixels map{uvs,
                              mScene.faces,
                              drawing->hoverTriangles,
                              half * drawing->mapScale,
                              half * (drawing->mapOffset + QVector2D(1, 1)),
                              double(mPixels.width())};
        const double high = mPixels.height() - mRow;
        const TriangleRuns runs = trianglesInStrip(map, high - mRows, high, mostWeight(), mNext);
        if (!runs.first.empty())
            drawSoup(gl, *drawing, mScene.colors, &runs);
        weight = runs.weight;
    }
    if (!drawing || mNext >= std::ssize(mScene.faces)) {
        mNext = 0;
        mLayer = mLayer == Layer::Ghost ? Layer::Map : Layer::Points;
    }
    return weight;
}

double GradualPicture::drawPoints(const MapRenderers &gl)
{
    const double own = mScene.points.size * mScene.points.size;
    const int left = mScene.map ? mScene.pointCount - mNext : 0;
    const int count =
        std::clamp(static_cast<int>(std::min(mostWeight() / own, 1e6)), std::min(1, left), left);
    gl.points.draw(mScene.points, mNext, count);
    mNext += count;
    if (count == left) {
        mNext = 0;
        mLayer = Layer::Paper;
        mRow += mRows;
    }
    return own * count;
}

void GradualPicture::complete(const MapRenderers &gl)
{
    if (!mComplete || mComplete->size() != mPixels)
        mComplete = std::make_unique<QOpenGLFramebufferObject>(mPixels);
    gl.gl.glDisable(GL_SCISSOR_TEST);
    gl.gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, mDrawn->handle());
    gl.gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, mComplete->handle());
    gl.gl.glBlitFramebuffer(0, 0, mPixels.width(), mPixels.height(), 0, 0, mPixels.width(), mPixels.height(),
                            GL_COLOR_BUFFER_BIT, GL_NEAREST);
    mShown = mScene.camera;
    mBusy = false;
}

void GradualPicture::show(const MapRenderers &gl, GLuint target, const QSize &pixels, const MapCamera &camera)
{
    const QColor &paper = mScene.colors.mapBackground;
    gl.gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    gl.gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.gl.glClearColor(paper.redF(), paper.greenF(), paper.blueF(), 1);
    gl.gl.glClear(GL_COLOR_BUFFER_BIT);
    if (!mShown)
        return;
    // From the upper left.
    const QSizeF size = mComplete->size();
    const double zoom = camera.scale() / mShown->scale();
    const Vec2 way = camera.scale() * mScene.pixelRatio * (mShown->centre() - camera.centre());
    QRectF place(QPointF(), zoom * size);
    place.moveCenter({0.5 * pixels.width() + way.x(), 0.5 * pixels.height() - way.y()});
    if (!mBlitter.isCreated())
        mBlitter.create();
    mBlitter.bind();
    mBlitter.blit(mComplete->texture(),
                  QOpenGLTextureBlitter::targetTransform(place, QRect(QPoint(), pixels)),
                  QOpenGLTextureBlitter::OriginBottomLeft);
    mBlitter.release();
}

} // namespace autocuts
