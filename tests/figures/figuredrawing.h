// Pictures of surfaces and UV maps beside each other, for the figures of the documentation.
#pragma once

#include "solver/base/soup.h"

#include <QString>

#include <vector>

class QPainter;
class QRectF;

namespace autocuts::figures {

//! One state of a solve: the surface above, its map below.
struct Panel
{
    QString caption;             //!< may have several lines
    std::vector<double> x;       //!< coordinates of the soup
    std::vector<double> redness; //!< per edge pair, in [0, 1]: how much it is apart
};

//! From where the surface is seen, degrees; y is up.
struct View
{
    double yaw = 30, pitch = 20;
};

//! Symmetric Dirichlet energy of one triangle; 4 is isometric.
double energyOf(const Soup &soup, const std::vector<double> &x, int triangle);

//! The surface from the outside, shaded, its parted edges red.
void drawSurface(QPainter &painter, const QRectF &place, const Soup &soup, const std::vector<double> &redness,
                 const View &view);

//! The triangles in the plane, white where nothing is distorted and blue where the energy is 6 or more; edges
//! that are apart red.
void drawMap(QPainter &painter, const QRectF &place, const Soup &soup, const Panel &panel);

//! Panels in a row, as a PNG of few colours. \returns false when it cannot be written
bool drawFigure(const QString &path, const Soup &soup, const std::vector<Panel> &panels, const View &view);

} // namespace autocuts::figures
