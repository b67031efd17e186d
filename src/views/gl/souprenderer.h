// Draws the triangle soup with all its lines in one pass, in 3D or as the map.
#pragma once

#include "views/gl/glbuffer.h"
#include "views/gl/soupbuffers.h"

#include <QMatrix4x4>
#include <QOpenGLShaderProgram>
#include <QVector2D>

#include <memory>

namespace autocuts {

//! How the soup is drawn. Sizes are in logical pixels, times pixelRatio on the screen.
struct SoupDrawing
{
    bool asMap = false;            //!< at its UVs instead of its positions
    bool ghost = false;            //!< map: at the other UVs
    QMatrix4x4 view;               //!< 3D: from the frame of the mesh to the eye
    QMatrix4x4 projection;         //!< 3D: from the eye to the clip space
    QVector2D mapScale, mapOffset; //!< map: clip space = uv * mapScale + mapOffset
    double pixelRatio = 1;
    bool smooth = false;
    Pattern pattern = Pattern::None; //!< 3D: on the faces
    double checkerSize = 16;
    unsigned texture = 0;                    //!< 2D texture for Pattern::Texture; 0: none
    double fillOpacity = 1;                  //!< map: of faces
    double lineOpacity = 1;                  //!< of everything drawn along sides
    std::array<int, 2> hoverTriangles{0, 0}; //!< first and end of those under the mouse
    unsigned hoverIsland = 0;                //!< number of the island under the mouse, 0 for none
    std::array<int, 2> hoverSides{-1, -1};   //!< sides of the edge under the mouse
};

//! Owns the buffers on the graphics card. The context must be current in all functions.
class SoupRenderer final
{
public:
    explicit SoupRenderer(GlFunctions &gl);
    ~SoupRenderer();
    SoupRenderer(const SoupRenderer &) = delete;
    SoupRenderer &operator=(const SoupRenderer &) = delete;

    void setVertices(std::span<const SoupVertex> vertices);
    //! Two numbers per soup corner.
    void setUvs(std::span<const float> uvs);
    //! Other UVs, which are drawn when SoupDrawing::ghost says so.
    void setGhostUvs(std::span<const float> uvs);
    //! Per triangle the number of its island, from 1; 0 for none.
    void setIslands(std::span<const quint32> islands) { mIslands.fill(islands); }
    void setFaces(std::span<const FaceTexel> texels) { mFaces.fill(texels); }
    void setSides(std::span<const SideTexel> texels) { mSides.fill(texels); }

    void draw(const SoupDrawing &drawing, const ViewColors &colors);

private:
    GLuint makeArray(GlBuffer &uvs);
    void setStyles(const SoupDrawing &drawing, const ViewColors &colors);

    GlFunctions &mGl;
    std::unique_ptr<QOpenGLShaderProgram> mProgram;
    GlBuffer mVertices, mUvs, mGhostUvs;
    GlTexelBuffer mFaces, mSides, mIslands;
    GLuint mArray = 0, mGhostArray = 0;
    int mCount = 0; //!< of soup corners
};

} // namespace autocuts
