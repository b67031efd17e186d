#include "views/gl/pointrenderer.h"

#include "views/gl/shaderprogram.h"

#include <cstddef>

namespace autocuts {

PointRenderer::PointRenderer(GlFunctions &gl)
    : mGl(gl), mProgram(makeShaderProgram(QStringLiteral("points"), QStringLiteral("points"))), mPoints(gl)
{
    mGl.glGenVertexArrays(1, &mArray);
    mGl.glBindVertexArray(mArray);
    mPoints.bind(GL_ARRAY_BUFFER);
    mGl.glEnableVertexAttribArray(0);
    mGl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(PointVertex), nullptr);
    mGl.glEnableVertexAttribArray(1);
    mGl.glVertexAttribPointer(1, GL_BGRA, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(PointVertex),
                              reinterpret_cast<const void *>(offsetof(PointVertex, color)));
    mGl.glBindVertexArray(0);
}

PointRenderer::~PointRenderer()
{
    mGl.glDeleteVertexArrays(1, &mArray);
}

void PointRenderer::setPoints(std::span<const PointVertex> points)
{
    mPoints.fill(points, GL_DYNAMIC_DRAW);
    mCount = static_cast<int>(points.size());
}

void PointRenderer::draw(const PointDrawing &drawing, int first, int count)
{
    if (count == 0)
        return;
    mGl.glEnable(GL_PROGRAM_POINT_SIZE);
    mProgram->bind();
    mProgram->setUniformValue("asMap", drawing.asMap);
    mProgram->setUniformValue("clipMatrix", drawing.clipMatrix);
    mProgram->setUniformValue("mapScale", drawing.mapScale);
    mProgram->setUniformValue("mapOffset", drawing.mapOffset);
    mProgram->setUniformValue("size", static_cast<float>(drawing.size));
    mGl.glBindVertexArray(mArray);
    mGl.glDrawArrays(GL_POINTS, first, count);
    mGl.glBindVertexArray(0);
    mProgram->release();
    mGl.glDisable(GL_PROGRAM_POINT_SIZE);
}

} // namespace autocuts
