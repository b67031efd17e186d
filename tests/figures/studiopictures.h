// Pictures of a model and its map by the studio's own views, for the documentation.
#pragma once

#include "support/canvases.h"

namespace autocuts::figures {

//! To be called before there is an application: smooth lines, and room for them.
void prepareViews();

//! The axis of a mesh that points up.
enum class UpAxis { X, Y, Z, MinusY };

//! From where a model is seen, degrees: from the front, the camera moves to the right and upwards.
struct Look
{
    double yaw = 30, pitch = 15;
};

//! Both views with a document, without a window around them. Needs a screen with OpenGL.
class StudioPictures
{
public:
    StudioPictures();

    //! \param up the mesh is turned so that this axis is the y axis of the views
    Document &open(Scene scene, UpAxis up = UpAxis::Y);
    Document &document() { return mCanvases.document(); }
    test::Canvases &canvases() { return mCanvases; }
    //! Triggers what starts a job, and waits until it is done and its map is measured.
    template <class Start>
    void runJob(Start start)
    {
        start();
        rest();
    }
    void rest();

    //! What both views show: at first smooth shading, seams, no edges of polygons, no grid.
    ViewOptions &options() { return mOptions; }
    //! The model, filling the picture but for a margin. \param size pixels of the picture
    QImage model(const QSize &size, const Look &look);
    //! The first tile, or all of the map where that is outside.
    QImage map(const QSize &size);
    //! Aims the camera as model() does, for gestures on the view.
    void aim(const QSize &size, const Look &look);

private:
    QImage grab(Canvas &canvas, const QSize &size);

    test::Canvases mCanvases;
    ViewOptions mOptions;
};

//! Squares of a checkerboard along the texture, so that some are seen along the longer side of the model.
double fittingCheckerSize(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts::figures
