// How the model and the map are shown, for both views together. Not part of the work: not undoable.
#pragma once

#include <QCborMap>
#include <QObject>
#include <QString>

#include <array>

namespace autocuts {

//! What gives the faces their colour, in both views.
enum class Coloring { Plain, Islands, SignedStretch, StretchMagnitude, PaintWeights };
//! The pattern that the UVs put on the model, and that lies behind the map.
enum class Pattern { None, Checker, Texture };

//! Which side panels of a picture are shown.
struct ViewOptions
{
    Coloring coloring = Coloring::Plain;
    Pattern pattern = Pattern::None;
    bool smoothShading = false;
    bool livePacking = false; //!< while solving, the islands are shown beside each other
    bool wireframe = true;    //!< edges of polygons; diagonals are never drawn
    bool seams = true;     //!< seams of the map; while solving the separation energy as a red hue (figure 4)
    bool steering = true;  //!< forced cuts and joins, rectangles and pins
    bool selection = true; //!< what is selected
    bool problems = true;  //!< flipped triangles, and overlaps hatched
    bool fillIslands = true;   //!< UV view
    bool grid = true;          //!< UV view: grid, unit square and tiles; 3D view: ground
    bool rulers = true;        //!< UV view, in texels
    bool orthographic = false; //!< 3D view
    double stretchClamp = 1;   //!< signed stretch: the log2 of the area ratio that gets the full colour
    double magnitudeClamp = 8; //!< magnitude: the symmetric Dirichlet energy that gets the full colour; > 4
    double checkerSize = 16;   //!< squares along a side of the unit square
    QString texturePath;       //!< image file, empty: none

    bool operator==(const ViewOptions &) const = default;
    QCborMap toCbor() const;
    //! Fields that are missing or not valid keep their defaults.
    static ViewOptions fromCbor(const QCborMap &map);
};

//! What the mouse is over, in whichever view it is. -1 for none.
struct Hover
{
    int triangle = -1;
    int edge = -1;   //!< of MeshAdjacency, near the mouse
    int corner = -1; //!< polygon corner, near the mouse

    bool operator==(const Hover &) const = default;
};

//! Options and hover, shared by the views, the panels and the actions.
class ViewState final : public QObject
{
    Q_OBJECT

public:
    explicit ViewState(QObject *parent = nullptr) : QObject(parent) {}

    const ViewOptions &options() const { return mOptions; }
    void setOptions(const ViewOptions &options);
    const Hover &hover() const { return mHover; }
    void setHover(const Hover &hover);

Q_SIGNALS:
    void optionsChanged();
    void hoverChanged();

private:
    ViewOptions mOptions;
    Hover mHover;
};

} // namespace autocuts
