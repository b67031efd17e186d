#include "views/gl/souprenderer.h"

#include "views/gl/shaderprogram.h"

#include <cstddef>

namespace autocuts {

namespace {

constexpr int faceUnit = 0, sideUnit = 1, pictureUnit = 2, islandUnit = 3, tableUnit = 4, setUnit = 5,
              environmentUnit = 6;

QVector4D toVector(const QColor &color)
{
    return {color.redF(), color.greenF(), color.blueF(), color.alphaF()};
}

} // namespace

SoupRenderer::SoupRenderer(GlFunctions &gl, bool asMap)
    : mGl(gl), mAsMap(asMap), mVertices(gl), mUvs(gl), mGhostUvs(gl), mTangents(gl), mFaces(gl), mSides(gl),
      mIslands(gl), mSets(gl)
{
    const int patterns = asMap ? 3 : 4; // the map has no light
    for (int pattern = 0; pattern < patterns; ++pattern) {
        QByteArrayList defines{"PATTERN " + QByteArray::number(pattern)};
        if (asMap)
            defines << "IN_MAP";
        mPrograms[pattern] = makeShaderProgram(QStringLiteral("soup"), QStringLiteral("soup"), defines);
    }
    mArray = makeArray(mUvs);
    mGhostArray = makeArray(mGhostUvs);
}

SoupRenderer::~SoupRenderer()
{
    mGl.glDeleteVertexArrays(1, &mArray);
    mGl.glDeleteVertexArrays(1, &mGhostArray);
}

GLuint SoupRenderer::makeArray(GlBuffer &uvs)
{
    GLuint array = 0;
    mGl.glGenVertexArrays(1, &array);
    mGl.glBindVertexArray(array);
    mVertices.bind(GL_ARRAY_BUFFER);
    mGl.glEnableVertexAttribArray(0);
    mGl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(SoupVertex), nullptr);
    mGl.glEnableVertexAttribArray(1);
    mGl.glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(SoupVertex),
                              reinterpret_cast<const void *>(offsetof(SoupVertex, normal)));
    uvs.bind(GL_ARRAY_BUFFER);
    mGl.glEnableVertexAttribArray(2);
    mGl.glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    mTangents.bind(GL_ARRAY_BUFFER);
    mGl.glVertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, 0, nullptr); // enabled when there are some
    mGl.glBindVertexArray(0);
    return array;
}

void SoupRenderer::setVertices(std::span<const SoupVertex> vertices)
{
    mVertices.fill(vertices, GL_STATIC_DRAW);
    mCount = static_cast<int>(vertices.size());
}

void SoupRenderer::setUvs(std::span<const float> uvs)
{
    mUvs.fill(uvs, GL_STREAM_DRAW);
}

void SoupRenderer::setGhostUvs(std::span<const float> uvs)
{
    mGhostUvs.fill(uvs, GL_STREAM_DRAW);
}

void SoupRenderer::setTangents(std::span<const float> tangents)
{
    mTangents.fill(tangents, GL_DYNAMIC_DRAW);
    mHasTangents = !tangents.empty();
}

void SoupRenderer::setStyles(QOpenGLShaderProgram &p, const SoupDrawing &drawing, const ViewColors &colors)
{
    std::array<QVector4D, static_cast<int>(SideStyle::Count)> sideColors;
    std::array<float, static_cast<int>(SideStyle::Count)> halfWidths;
    for (std::size_t i = 0; i < sideColors.size(); ++i) {
        sideColors[i] = toVector(colors.sides[i]);
        halfWidths[i] = 0.5f * colors.sideWidths[i] * static_cast<float>(drawing.pixelRatio);
    }
    p.setUniformValueArray("sideColors", sideColors.data(), static_cast<int>(sideColors.size()));
    p.setUniformValueArray("sideHalfWidths", halfWidths.data(), static_cast<int>(halfWidths.size()), 1);
    p.setUniformValue("selectionColor", toVector(colors.selection));
    p.setUniformValue("hoverColor", toVector(colors.hover));
    p.setUniformValue("overlapColor", toVector(colors.overlap));
    p.setUniformValue("flippedColor", toVector(colors.flipped));
}

void SoupRenderer::draw(const SoupDrawing &drawing, const ViewColors &colors)
{
    draw(drawing, colors, {{0}, {mCount}});
}

void SoupRenderer::draw(const SoupDrawing &drawing, const ViewColors &colors, const TriangleRuns &runs)
{
    if (mCount == 0 || runs.first.empty())
        return;
    const bool textured = isPicture(drawing.pattern) && drawing.pictures && !drawing.pictures->isEmpty();
    const bool physical = textured && !mAsMap && drawing.environment && !drawing.environment->isEmpty();
    const int pattern = physical ? 3 : textured ? 2 : drawing.pattern == Pattern::Checker ? 1 : 0;
    QOpenGLShaderProgram &p = *mPrograms[pattern];
    p.bind();
    setStyles(p, drawing, colors);
    p.setUniformValue("viewMatrix", drawing.view);
    p.setUniformValue("projectionMatrix", drawing.projection);
    p.setUniformValue("mapScale", drawing.mapScale);
    p.setUniformValue("mapOffset", drawing.mapOffset);
    p.setUniformValue("pixelRatio", static_cast<float>(drawing.pixelRatio));
    p.setUniformValue("smoothShading", drawing.smooth);
    p.setUniformValue("pictureHeight",
                      static_cast<float>(pictureHeight(drawing.pattern, drawing.tileHeight)));
    p.setUniformValue("unlit", drawing.pattern == Pattern::Physical || (textured && drawing.asItIs));
    p.setUniformValue("shownChannel", drawing.shownChannel);
    p.setUniformValue("pictureLayers", drawing.pictures ? drawing.pictures->layers() : 1);
    p.setUniformValue("environment", environmentUnit);
    if (physical)
        drawing.environment->use(p, environmentUnit, drawing.toEnvironment, drawing.exposure);
    p.setUniformValue("checkerSize", static_cast<float>(drawing.checkerSize));
    p.setUniformValue("selectionShare", static_cast<float>(drawing.selectionShare));
    p.setUniformValue("tint", static_cast<float>(drawing.tint));
    p.setUniformValue("fillOpacity", static_cast<float>(drawing.fillOpacity));
    p.setUniformValue("lineOpacity", static_cast<float>(drawing.lineOpacity));
    p.setUniformValue("onPicture", drawing.onPicture);
    // QOpenGLShaderProgram has no functions for these types.
    mGl.glUniform1ui(p.uniformLocation("hoverIsland"), drawing.hoverIsland);
    mGl.glUniform2i(p.uniformLocation("hoverTriangles"), drawing.hoverTriangles[0],
                    drawing.hoverTriangles[1]);
    mGl.glUniform2i(p.uniformLocation("hoverSides"), drawing.hoverSides[0], drawing.hoverSides[1]);
    p.setUniformValue("faceTexels", faceUnit);
    p.setUniformValue("islandTexels", islandUnit);
    p.setUniformValue("sideTexels", sideUnit);
    p.setUniformValue("pictures", pictureUnit);
    p.setUniformValue("pictureTable", tableUnit);
    p.setUniformValue("setTexels", setUnit);
    p.setUniformValue("onlySet", drawing.onlySet);
    if (textured)
        drawing.pictures->bind(pictureUnit, tableUnit);
    mSets.bind(setUnit);
    mIslands.bind(islandUnit);
    mSides.bind(sideUnit);
    mFaces.bind(faceUnit);
    mGl.glActiveTexture(GL_TEXTURE0);
    mGl.glBindVertexArray(drawing.ghost ? mGhostArray : mArray);
    const bool tangents = mHasTangents && physical;
    p.setUniformValue("hasTangents", tangents);
    if (tangents)
        mGl.glEnableVertexAttribArray(3);
    else
        mGl.glDisableVertexAttribArray(3);
    mGl.glMultiDrawArrays(GL_TRIANGLES, runs.first.data(), runs.count.data(),
                          static_cast<int>(runs.first.size()));
    mGl.glBindVertexArray(0);
    p.release();
}

} // namespace autocuts
