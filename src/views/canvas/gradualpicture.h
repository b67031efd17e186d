// The picture of the map, drawn in pieces where that takes long.
#pragma once

#include "views/canvas/mapcamera.h"
#include "views/gl/backdrop.h"
#include "views/gl/pointrenderer.h"
#include "views/gl/souprenderer.h"

#include <QOpenGLFramebufferObject>
#include <QOpenGLTextureBlitter>

#include <memory>
#include <optional>

namespace autocuts {

//! What draws the parts of a map.
struct MapRenderers
{
    GlFunctions &gl;
    Backdrop &backdrop;
    SoupRenderer &soup;
    PointRenderer &points;
};

//! All that is drawn of a map but the overlay.
struct MapScene
{
    PaperDrawing paper;
    std::optional<SoupDrawing> ghost, map; //!< nothing without a model
    PointDrawing points;
    ViewColors colors;
    MapCamera camera;
    double pixelRatio = 1;
    quint64 revision = 0; //!< tells it from others with the same camera
    //! What the buffers hold, to foresee how long it takes. Must stay as long as the scene is drawn.
    std::span<const float> uvs, ghostUvs;
    std::span<const FaceTexel> faces;
    int pointCount = 0;
};

//! Draws all of it at once into the framebuffer that is bound.
void drawScene(const MapRenderers &gl, const MapScene &scene);

//! Draws a scene in pieces of some milliseconds, whatever covers what how often, and shows the last one that
//! is complete meanwhile: strips of rows of pixels, and in each strip no more triangles than take so long by
//! what the pieces before took. The buffers must stay as they are while a scene is drawn. The context must be
//! current in all functions.
class GradualPicture final
{
public:
    //! Draws something of each kind: a driver may compile shaders when they are first used, and that cannot
    //! be done in pieces. The buffers are filled with something else afterwards.
    void warmUp(const MapRenderers &gl, const ViewColors &colors);
    //! True when the scene is drawn, or is being drawn.
    bool has(const MapScene &scene, const QSize &pixels) const;
    //! Begins a scene. \pre !isBusy()
    void begin(MapScene scene, const QSize &pixels);
    bool isBusy() const { return mBusy; }
    //! Draws until the time is over, one piece at least. \pre isBusy()
    void goOn(const MapRenderers &gl, int milliseconds);
    //! Gives up the scene that is being drawn.
    void abandon();
    //! True when there is a complete scene.
    bool isShown() const { return mShown.has_value(); }
    //! Copies the last complete scene into a framebuffer, moved to where another camera sees it.
    //! \param pixels size of the framebuffer
    void show(const MapRenderers &gl, GLuint target, const QSize &pixels, const MapCamera &camera);

private:
    enum class Layer { Paper, Ghost, Map, Points };

    void drawPiece(const MapRenderers &gl);
    double drawPaperOfStrip(const MapRenderers &gl);
    double drawTriangles(const MapRenderers &gl, const std::optional<SoupDrawing> &drawing,
                         std::span<const float> uvs);
    double drawPoints(const MapRenderers &gl);
    void learn(double weight, double nanoseconds);
    double mostWeight() const;
    void complete(const MapRenderers &gl);

    MapScene mScene;                 //!< drawn last, or being drawn
    QSize mPixels;                   //!< of it
    std::optional<MapCamera> mShown; //!< of the complete picture
    bool mBusy = false, mKnown = false;
    //! Nanoseconds for a pixel of a triangle, by the last pieces. The first is more than any takes.
    static constexpr double firstPixelTime = 1000;
    double mPixelTime = firstPixelTime;
    int mRow = 0, mRows = 1;     //!< strip of rows of pixels, from above
    Layer mLayer = Layer::Paper; //!< next in the strip
    int mNext = 0;               //!< triangle or point in the layer
    std::unique_ptr<QOpenGLFramebufferObject> mDrawn, mComplete;
    QOpenGLTextureBlitter mBlitter;
};

} // namespace autocuts
