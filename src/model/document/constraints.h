// What the user fixed in UV space: pins and rectangles.
#pragma once

#include "model/plain/meshdata.h"

#include <QColor>
#include <QList>
#include <QString>

#include <vector>

namespace autocuts {

//! Longest name of a rectangle, a tag or a UV set, in characters.
inline constexpr int maxNameLength = 1000;
//! Largest id of a rectangle.
inline constexpr int maxRectangleId = 1000000;

//! A corner held at a place of the texture.
struct UvPin
{
    int corner = 0;               //!< polygon corner; all its soup corners are held
    Vec2 position = Vec2::Zero(); //!< texture space
    bool hard = true;             //!< hard: exactly there; soft: a spring
    double weight = 1;            //!< spring constant of a soft pin

    bool operator==(const UvPin &) const = default;
};

//! A rectangle of the texture that the given faces should stay inside. Islands are assigned through their
//! faces, so an assignment survives when islands are cut or joined.
struct LayoutRectangle
{
    int id = 0; //!< 1 to maxRectangleId, unique in a document
    QString name;
    QRgb color = 0xff4080ff;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< texture space
    bool hard = false; //!< hard: no corner may leave; soft: leaving costs energy
    double weight = 1; //!< beta of this rectangle = SolveSettings::boxWeight * weight
    QList<int> faces;  //!< strictly rising

    bool operator==(const LayoutRectangle &) const = default;
};

//! The pins and rectangles of a document.
struct Constraints
{
    std::vector<UvPin> pins;                 //!< rising by corner, at most one per corner
    std::vector<LayoutRectangle> rectangles; //!< rising by id

    //! Null when there is none.
    const UvPin *pin(int corner) const;
    //! Null when there is none.
    const LayoutRectangle *rectangle(int id) const;
    //! The lowest id that is free; 0 when there is none.
    int nextRectangleId() const;

    //! Empty when all invariants hold, else the first broken one.
    QString validate(const MeshData &mesh) const;

    bool operator==(const Constraints &) const = default;
};

//! True when the pin fits the mesh and its numbers are finite and not negative where they must not be.
bool isValid(const UvPin &pin, const MeshData &mesh);
//! True when the rectangle fits the mesh, lower <= upper and its numbers are in range.
bool isValid(const LayoutRectangle &rectangle, const MeshData &mesh);
//! True when the indices rise strictly and lie in [0, count).
bool isIndexSet(const QList<int> &indices, int count);

} // namespace autocuts
