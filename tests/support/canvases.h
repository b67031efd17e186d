// Both views of a document on the screen, for tests of the views and their tools.
#pragma once

#include "views/actions/actionregistry.h"
#include "views/canvas/meshview.h"
#include "views/canvas/toolmanager.h"
#include "views/canvas/uvview.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/ui/preferences.h"

#include <QTemporaryDir>

namespace autocuts::test {

//! Everything that the views need, without the window around them.
class Canvases
{
public:
    Canvases();

    //! On a grid of quads in two islands, of which the map shows 200 pixels per unit.
    static std::unique_ptr<Canvases> onGrid(int quadsPerSide);
    //! Opens a document and waits until it is drawn.
    Document &open(std::unique_ptr<Document> document);
    Document &document() { return *workspace.document(); }
    //! Places are given from a camera that looks straight at z = 1.
    void lookFromFront();
    //! Pixel of a soup corner, or of the mean of some.
    static QPoint place(const Canvas &canvas, std::initializer_list<int> soupCorners);
    //! Pixel of the middle of a triangle.
    static QPoint middle(const Canvas &canvas, int triangle);
    //! Pixel of the middle of an edge, on its first side.
    static QPoint middleOfEdge(const Canvas &canvas, int edge);
    //! The edge between two vertices at these places of the model; -1 when there is none.
    int edgeBetween(const Vec3 &a, const Vec3 &b);
    void select(SelectionMode mode);
    //! Moves the mouse over a canvas at once; the one of the screen would get there some time later.
    static void moveMouse(Canvas &canvas, const QPoint &place, Qt::MouseButtons buttons = Qt::NoButton,
                          Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    //! Presses the left button, moves in some steps through all places, and releases it at the last one.
    static void drag(Canvas &canvas, const QList<QPoint> &places,
                     Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    static void turnWheel(Canvas &canvas, const QPoint &place, int angle, Qt::KeyboardModifiers modifiers);

    QTemporaryDir folder;
    Preferences preferences;
    Workspace workspace;
    ShownMap shown;
    ViewState view;
    SolverController solver;
    MapController map;
    FileController files;
    ActionRegistry actions;
    ModelPictures pictures;
    LiveBake liveBake;
    const StudioContext context;
    ToolManager tools;
    MeshView mesh;
    UvView uv;
};

//! How many pixels are near a colour, by the sum of the differences of its components.
int countNear(const QImage &picture, const QColor &color, int distance);

} // namespace autocuts::test
