// Options for how the model and the map are shown, shared by both views. Not part of the document: not
// undoable.
#pragma once

#include "views/state/toolsettings.h"

#include <QCborMap>
#include <QObject>
#include <QString>

#include <array>

namespace autocuts {

//! What the colours of the faces show, in both views.
enum class Coloring {
    Plain,
    Islands,
    SignedStretch,
    StretchMagnitude,
    PaintWeights,
    Density,
    TexelWeights,
    VertexColors
};
//! How much of the colour of the selection a selected face gets: little where colours show numbers.
constexpr double selectionShare(Coloring coloring)
{
    return coloring == Coloring::Plain || coloring == Coloring::Islands ? 0.6 : 0.2;
}

//! The pattern on the model, by its UVs, and behind the map.
//! Texture is the picture that the user chose, Materials are the base colours of all materials, Physical are
//! their texture sets, under light in the 3D view, Baked is a bake that follows
//! the map (LiveBake).
enum class Pattern { None, Checker, Texture, Lettered, Materials, Physical, Baked };
//! What is around the model in the light of which texture sets are shown.
enum class Surroundings { Studio, Sky, File };
//! True for patterns that are drawn from a picture.
constexpr bool isPicture(Pattern pattern)
{
    return pattern == Pattern::Texture || pattern == Pattern::Lettered || pattern == Pattern::Materials ||
           pattern == Pattern::Physical || pattern == Pattern::Baked;
}

//! Height in texture space of the picture of a pattern, where it is 1 wide. \param tileHeight of the texture
constexpr double pictureHeight(Pattern pattern, double tileHeight)
{
    return pattern == Pattern::Lettered ? 1 : tileHeight; // lettered cells are square
}

//! The options of both views.
struct ViewOptions
{
    Coloring coloring = Coloring::Plain;
    Pattern pattern = Pattern::None;
    bool smoothShading = false;
    bool livePacking = false; //!< while a solve runs, show the islands side by side
    bool wireframe = true;    //!< polygon edges; diagonals are never drawn
    //! Seams of the map; while a solve runs, the separation energy as a red hue (paper, figure 4).
    bool seams = true;
    bool steering = true;       //!< cut and joined edges, rectangles and pins
    bool selection = true;      //!< mark selected elements
    bool problems = true;       //!< mark flipped triangles, and hatch overlaps
    bool fillIslands = true;    //!< UV view
    bool grid = true;           //!< UV view: grid and tiles; 3D view: ground
    bool rulers = true;         //!< UV view, in texels
    bool islandMarks = true;    //!< UV view: locks, groups and stacks
    bool islandNumbers = false; //!< UV view
    bool followMap = false;     //!< the UV view frames a live map as it changes
    bool orthographic = false;  //!< 3D view
    bool xray = false;          //!< 3D view: see and select through the model
    double stretchClamp = 1;    //!< signed stretch: the log2 of the area ratio that gets the full colour
    //! Magnitude: the symmetric Dirichlet energy that gets the full colour; above 4.
    double magnitudeClamp = 8;
    double checkerSize = 16;  //!< squares along the width of the texture
    double letteredCells = 8; //!< cells of Pattern::Lettered along the width of the texture
    //! Density: the texels per unit of the model that are right; 0: the median of the map.
    double densityTarget = 0;
    double densityClamp = 1; //!< density: the log2 of the factor that gets the full colour
    //! Density: share of the right density by which faces may be off and still be right; faces then have one
    //! of three colours. 0: colours change smoothly.
    double densityTolerance = 0;
    bool densityPerCentimetre =
        false;                    //!< densities are shown as px/cm, otherwise as px per unit of the model
    double unitCentimetres = 100; //!< length of a unit of the model; metres by default
    Surroundings surroundings = Surroundings::Studio;
    bool showSurroundings = false; //!< behind the model
    double exposure = 0;           //!< of texture sets under light, in stops
    double lightTurn = 0;          //!< the surroundings are turned about the vertical by this, in degrees
    int shownChannel = -1;         //!< TextureChannel that is shown without light; -1: all under light
    QString surroundingsPath;      //!< panorama for Surroundings::File
    QString texturePath;           //!< image file; empty for none

    bool operator==(const ViewOptions &) const = default;
    QCborMap toCbor() const;
    //! Reads the options; missing or invalid ones keep their defaults.
    static ViewOptions fromCbor(const QCborMap &map);
};

//! The elements under the mouse in either view; -1 for none.
struct Hover
{
    int triangle = -1;
    int edge = -1;   //!< edge of MeshAdjacency near the mouse
    int corner = -1; //!< polygon corner near the mouse

    bool operator==(const Hover &) const = default;
};

//! View options, tool settings and hovered elements, shared by the views, the tools, the panels and the
//! actions.
class ViewState final : public QObject
{
    Q_OBJECT

public:
    explicit ViewState(QObject *parent = nullptr) : QObject(parent) {}

    const ViewOptions &options() const { return mOptions; }
    void setOptions(const ViewOptions &options);
    const ToolSettings &tools() const { return mTools; }
    void setTools(const ToolSettings &settings);
    const Hover &hover() const { return mHover; }
    void setHover(const Hover &hover);

Q_SIGNALS:
    void optionsChanged();
    void toolsChanged();
    void hoverChanged();

private:
    ViewOptions mOptions;
    ToolSettings mTools;
    Hover mHover;
};

} // namespace autocuts
