#include "views/gl/backdrop.h"

#include "views/gl/shaderprogram.h"

namespace autocuts {

namespace {

constexpr int pictureUnit = 0, tableUnit = 1;

} // namespace

Backdrop::Backdrop(GlFunctions &gl) : mGl(gl)
{
    const QString screen = QStringLiteral("screen");
    for (int i = 0; i < 2; ++i)
        mRooms[i] = makeShaderProgram(screen, QStringLiteral("room"),
                                      {i == 0 ? "SURROUNDINGS false" : "SURROUNDINGS true"});
    for (int i = 0; i < 3; ++i)
        mPapers[i] = makeShaderProgram(screen, QStringLiteral("paper"), {"PATTERN " + QByteArray::number(i)});
    mGl.glGenVertexArrays(1, &mArray);
}

Backdrop::~Backdrop()
{
    mGl.glDeleteVertexArrays(1, &mArray);
}

void Backdrop::draw(const RoomDrawing &drawing, const ViewColors &colors)
{
    const bool seen = drawing.environment && !drawing.environment->isEmpty();
    QOpenGLShaderProgram &p = *mRooms[seen];
    p.bind();
    p.setUniformValue("topColor", colors.backgroundTop);
    p.setUniformValue("bottomColor", colors.backgroundBottom);
    p.setUniformValue("gridColor", colors.gridMajor);
    p.setUniformValue("axisX", colors.axes[0]);
    p.setUniformValue("axisZ", colors.axes[2]);
    p.setUniformValue("toFrame", drawing.clipMatrix.inverted());
    p.setUniformValue("groundHeight", static_cast<float>(drawing.groundHeight));
    p.setUniformValue("gridStep", static_cast<float>(drawing.gridStep));
    p.setUniformValue("pixelRatio", static_cast<float>(drawing.pixelRatio));
    p.setUniformValue("grid", drawing.grid);
    p.setUniformValue("environment", pictureUnit);
    if (seen)
        drawing.environment->use(p, pictureUnit, drawing.toEnvironment, drawing.exposure);
    fillView();
    p.release();
}

void Backdrop::draw(const PaperDrawing &drawing, const ViewColors &colors)
{
    const bool textured = isPicture(drawing.pattern) && drawing.pictures && !drawing.pictures->isEmpty();
    QOpenGLShaderProgram &p = *mPapers[textured ? 2 : drawing.pattern == Pattern::Checker ? 1 : 0];
    p.bind();
    p.setUniformValue("outsideColor", colors.mapBackground);
    p.setUniformValue("insideColor", colors.mapInside);
    p.setUniformValue("minorColor", colors.gridMinor);
    p.setUniformValue("majorColor", colors.gridMajor);
    p.setUniformValue("axisX", colors.axes[0]);
    p.setUniformValue("axisY", colors.axes[1]);
    p.setUniformValue("tileOrigin", drawing.tileOrigin);
    p.setUniformValue("originTile", drawing.originTile);
    p.setUniformValue("usedTiles", drawing.usedTiles);
    p.setUniformValue("tilePixels", QVector2D(static_cast<float>(drawing.tilePixels),
                                              static_cast<float>(drawing.tilePixels * drawing.tileHeight)));
    p.setUniformValue("tileHeight", static_cast<float>(drawing.tileHeight));
    p.setUniformValue("pictureHeight",
                      static_cast<float>(pictureHeight(drawing.pattern, drawing.tileHeight)));
    p.setUniformValue("gridOrigin", drawing.gridOrigin);
    p.setUniformValue("gridPixels", static_cast<float>(drawing.gridPixels));
    p.setUniformValue("minorStrength", static_cast<float>(drawing.minorStrength));
    p.setUniformValue("minorDivisions", static_cast<float>(drawing.minorDivisions));
    p.setUniformValue("grid", drawing.grid);
    p.setUniformValue("checkerSize", static_cast<float>(drawing.checkerSize));
    p.setUniformValue("patternStrength", static_cast<float>(drawing.patternStrength));
    p.setUniformValue("lineWidth", static_cast<float>(drawing.lineWidth));
    p.setUniformValue("pictures", pictureUnit);
    p.setUniformValue("pictureTable", tableUnit);
    p.setUniformValue("pictureSet", drawing.pictureSet);
    p.setUniformValue("shownChannel", drawing.shownChannel);
    p.setUniformValue("pictureLayers", drawing.pictures ? drawing.pictures->layers() : 1);
    if (textured)
        drawing.pictures->bind(pictureUnit, tableUnit);
    mGl.glActiveTexture(GL_TEXTURE0);
    fillView();
    p.release();
}

void Backdrop::fillView()
{
    mGl.glBindVertexArray(mArray);
    mGl.glDrawArrays(GL_TRIANGLES, 0, 3);
    mGl.glBindVertexArray(0);
}

} // namespace autocuts
