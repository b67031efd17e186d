// Draws the triangle soup with all its lines in one pass, in 3D or in UV space.
#pragma once

#include "views/gl/environmenttexture.h"
#include "views/gl/glbuffer.h"
#include "views/gl/patterntexture.h"
#include "views/gl/soupbuffers.h"
#include "views/gl/trianglesinstrip.h"

#include <QMatrix4x4>
#include <QOpenGLShaderProgram>
#include <QVector2D>

#include <array>
#include <memory>

namespace autocuts {

//! How the soup is drawn. Sizes are in logical pixels and are multiplied by pixelRatio.
struct SoupDrawing
{
    bool ghost = false;            //!< UV view: use the ghost UVs
    QMatrix4x4 view;               //!< 3D view: from mesh frame to eye space
    QMatrix4x4 projection;         //!< 3D view: from eye space to clip space
    QVector2D mapScale, mapOffset; //!< UV view: clip space = uv * mapScale + mapOffset
    double pixelRatio = 1;
    bool smooth = false;
    bool asItIs = false;             //!< the picture of the pattern is shown without light
    Pattern pattern = Pattern::None; //!< pattern on the faces
    double checkerSize = 16;
    double tileHeight = 1;                     //!< of the texture, see PackingSettings::tileHeight()
    PatternTexture *pictures = nullptr;        //!< for patterns that are pictures; null: none
    int onlySet = 1;                           //!< set of pictures of all triangles; 0: see setSets()
    int shownChannel = 0;                      //!< of texture sets, as TextureChannel
    EnvironmentTexture *environment = nullptr; //!< texture sets are shown in its light; null: without light
    QMatrix4x4 toEnvironment;                  //!< turns directions from eye space
    double exposure = 0;                       //!< in stops
    double selectionShare = 0.6;               //!< of its colour over that of a selected face
    double tint = 0;                           //!< share of the faces' colours over the texture
    double fillOpacity = 1;                    //!< opacity of the faces
    double lineOpacity = 1;                    //!< opacity of all lines along sides
    bool onPicture = false;                    //!< in the map: a picture lies behind the islands
    std::array<int, 2> hoverTriangles{0, 0};   //!< range of triangles under the mouse: first and end
    unsigned hoverIsland = 0;                  //!< number of the island under the mouse; 0 for none
    std::array<int, 2> hoverSides{-1, -1};     //!< the sides of the edge under the mouse
};

//! Owns the buffers in graphics memory. The context must be current in all functions.
class SoupRenderer final
{
public:
    //! \param asMap draws at the UVs instead of the positions
    SoupRenderer(GlFunctions &gl, bool asMap);
    ~SoupRenderer();
    SoupRenderer(const SoupRenderer &) = delete;
    SoupRenderer &operator=(const SoupRenderer &) = delete;

    void setVertices(std::span<const SoupVertex> vertices);
    //! Sets the UVs, two numbers per soup corner.
    void setUvs(std::span<const float> uvs);
    //! Sets the ghost UVs, which are drawn for SoupDrawing::ghost.
    void setGhostUvs(std::span<const float> uvs);
    //! Sets the tangents, three numbers for each soup corner and the side of the bitangent; empty for none.
    void setTangents(std::span<const float> tangents);
    //! Sets the island number of each triangle, from 1; 0 for none.
    void setIslands(std::span<const quint32> islands) { mIslands.fill(islands); }
    //! Sets the set of pictures of each triangle, from 1; 0 for none.
    void setSets(std::span<const quint32> sets) { mSets.fill(sets); }
    void setFaces(std::span<const FaceTexel> texels) { mFaces.fill(texels); }
    void setSides(std::span<const SideTexel> texels) { mSides.fill(texels); }

    void draw(const SoupDrawing &drawing, const ViewColors &colors);
    //! Draws only some triangles.
    void draw(const SoupDrawing &drawing, const ViewColors &colors, const TriangleRuns &runs);

private:
    GLuint makeArray(GlBuffer &uvs);
    static void setStyles(QOpenGLShaderProgram &program, const SoupDrawing &drawing,
                          const ViewColors &colors);

    GlFunctions &mGl;
    const bool mAsMap;
    std::array<std::unique_ptr<QOpenGLShaderProgram>, 4> mPrograms; //!< per pattern of soup.frag
    GlBuffer mVertices, mUvs, mGhostUvs, mTangents;
    GlTexelBuffer mFaces, mSides, mIslands, mSets;
    GLuint mArray = 0, mGhostArray = 0;
    bool mHasTangents = false;
    int mCount = 0; //!< number of soup corners
};

} // namespace autocuts
