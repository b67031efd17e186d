// Draws vertex marks.
#pragma once

#include "views/gl/glbuffer.h"
#include "views/gl/soupbuffers.h"

#include <QMatrix4x4>
#include <QOpenGLShaderProgram>
#include <QVector2D>

#include <memory>

namespace autocuts {

//! How the marks are drawn.
struct PointDrawing
{
    bool asMap = false;
    QMatrix4x4 clipMatrix;         //!< 3D view: from mesh frame to clip space
    QVector2D mapScale, mapOffset; //!< UV view: clip space = uv * mapScale + mapOffset
    double size = 7;               //!< diameter in screen pixels
};

//! Draws round marks of one size. The context must be current in all functions.
class PointRenderer final
{
public:
    explicit PointRenderer(GlFunctions &gl);
    ~PointRenderer();
    PointRenderer(const PointRenderer &) = delete;
    PointRenderer &operator=(const PointRenderer &) = delete;

    void setPoints(std::span<const PointVertex> points);
    void draw(const PointDrawing &drawing) { draw(drawing, 0, mCount); }
    //! Draws only some of them.
    void draw(const PointDrawing &drawing, int first, int count);

private:
    GlFunctions &mGl;
    std::unique_ptr<QOpenGLShaderProgram> mProgram;
    GlBuffer mPoints;
    GLuint mArray = 0;
    int mCount = 0;
};

} // namespace autocuts
