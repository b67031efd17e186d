// The user's constraints in UV space: pins and rectangles.
#pragma once

#include "model/plain/meshdata.h"

#include <QColor>
#include <QList>
#include <QString>

#include <vector>

namespace autocuts {

//! Longest name of a rectangle, a tag or a UV set, in characters. Chosen by hand; names from files are
//! checked against it.
inline constexpr int maxNameLength = 1000;
//! Largest id of a rectangle; chosen by hand.
inline constexpr int maxRectangleId = 1000000;

//! A corner held at a position in the texture.
struct UvPin
{
    int corner = 0;               //!< polygon corner; the pin acts on all of its soup corners
    Vec2 position = Vec2::Zero(); //!< texture space
    bool hard = true;             //!< true: held exactly; false: pulled by a spring
    double weight = 1;            //!< spring constant of a soft pin

    bool operator==(const UvPin &) const = default;
};

//! A rectangle of the texture that the given faces should stay inside. Islands are assigned by their faces,
//! so that the assignment survives when islands are cut or stitched.
struct LayoutRectangle
{
    int id = 0; //!< from 1 to maxRectangleId, unique in a document
    QString name;
    QRgb color = 0xff4080ff;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< texture space
    //! True: no corner may leave it; false: leaving costs energy (paper, Eq. 10).
    bool hard = false;
    //! The factor beta of this rectangle is SolveSettings::boxWeight * weight.
    double weight = 1;
    QList<int> faces; //!< strictly ascending

    bool operator==(const LayoutRectangle &) const = default;
};

//! The pins and rectangles of a document.
struct Constraints
{
    std::vector<UvPin> pins;                 //!< ascending by corner, at most one per corner
    std::vector<LayoutRectangle> rectangles; //!< ascending by id

    //! The pin of a corner, or null.
    const UvPin *pin(int corner) const;
    //! The rectangle with an id, or null.
    const LayoutRectangle *rectangle(int id) const;
    //! The lowest unused id; 0 when all are in use.
    int nextRectangleId() const;

    //! Returns an empty string, or the first invariant that does not hold.
    QString validate(const MeshData &mesh) const;

    bool operator==(const Constraints &) const = default;
};

//! True when the pin's corner is in the mesh, its numbers are finite, and its weight is not negative.
bool isValid(const UvPin &pin, const MeshData &mesh);
//! True when the rectangle's faces are in the mesh, lower <= upper and its numbers are in range.
bool isValid(const LayoutRectangle &rectangle, const MeshData &mesh);
//! True when the indices are strictly ascending and lie in [0, count).
bool isIndexSet(const QList<int> &indices, int count);

} // namespace autocuts
