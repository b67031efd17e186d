// Draws the backgrounds of the 3D view and of the UV view.
#pragma once

#include "views/gl/environmenttexture.h"
#include "views/gl/glfunctions.h"
#include "views/gl/patterntexture.h"
#include "views/gl/viewcolors.h"
#include "views/state/viewstate.h"

#include <QMatrix4x4>
#include <QOpenGLShaderProgram>
#include <QVector2D>

#include <array>
#include <memory>

namespace autocuts {

//! The background of the 3D view.
struct RoomDrawing
{
    QMatrix4x4 clipMatrix;   //!< from mesh frame to clip space
    double groundHeight = 0; //!< in the mesh frame
    double gridStep = 0.2;   //!< in the mesh frame
    double pixelRatio = 1;
    bool grid = true;
    EnvironmentTexture *environment = nullptr; //!< is seen; null: a soft gradient
    QMatrix4x4 toEnvironment;                  //!< turns directions from the mesh frame
    double exposure = 0;                       //!< in stops
};

//! The background of the UV view. Positions are in screen pixels from the lower left corner of the view.
struct PaperDrawing
{
    QVector2D tileOrigin; //!< pixel of a tile's corner, in or near the view
    QVector2D originTile; //!< column and row of that tile
    QVector2D usedTiles{1, 1};
    double tilePixels = 1; //!< width of a tile
    double tileHeight = 1; //!< in relation to its width
    QVector2D gridOrigin;  //!< pixel of a grid line, in or near the view
    double gridPixels = 1, minorStrength = 0, minorDivisions = 2;
    bool grid = true;
    Pattern pattern = Pattern::None;
    double checkerSize = 16;
    PatternTexture *pictures = nullptr; //!< null: none
    int pictureSet = 0;                 //!< of them
    int shownChannel = 0;               //!< of texture sets, as TextureChannel
    double patternStrength = 1;         //!< 0: the pattern is not seen
    double lineWidth = 1;
};

//! Fills the whole view, so that it need not be cleared. The context must be current in all functions.
class Backdrop final
{
public:
    explicit Backdrop(GlFunctions &gl);
    ~Backdrop();
    Backdrop(const Backdrop &) = delete;
    Backdrop &operator=(const Backdrop &) = delete;

    void draw(const RoomDrawing &drawing, const ViewColors &colors);
    void draw(const PaperDrawing &drawing, const ViewColors &colors);

private:
    void fillView();

    GlFunctions &mGl;
    std::array<std::unique_ptr<QOpenGLShaderProgram>, 2> mRooms;  //!< without and with surroundings
    std::array<std::unique_ptr<QOpenGLShaderProgram>, 3> mPapers; //!< per pattern of paper.frag
    GLuint mArray = 0; //!< empty; the core profile requires a vertex array
};

} // namespace autocuts
