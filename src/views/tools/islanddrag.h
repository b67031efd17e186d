// Computes the transform of an island gesture from the mouse, the axis and a typed number.
#pragma once

#include "commands/setuvs.h"
#include "views/tools/snapping.h"

#include <QString>

class QKeyEvent;

namespace autocuts {

//! The axis to which a gesture is restricted.
enum class DragAxis { Both, X, Y };

//! A gesture in progress. Positions are in texture space.
struct IslandDrag
{
    UvEdit edit = UvEdit::Move; //!< Move, Rotate or Scale
    Vec2 start = Vec2::Zero();  //!< of the mouse
    Vec2 current = Vec2::Zero();
    Eigen::AlignedBox2d box;   //!< of the islands at the start
    Vec2 pivot = Vec2::Zero(); //!< of the handles; the mouse turns and scales about it
    DragAxis axis = DragAxis::Both;
    QString typed; //!< a number that replaces the mouse: a length, degrees or a factor
    SnapTo snap = SnapTo::Nothing;
    Vec2 snapStep = Vec2::Zero();    //!< for Move
    Vec2 islandShift = Vec2::Zero(); //!< for Move: added by snapping to other islands
    double pixel = 1;                //!< size of a pixel of the view at the start
    Vec2 unit = Vec2::Ones();        //!< typed and shown lengths per length in texture space
    bool inTexels = true;            //!< what these are

    //! Handles digits, point, minus, backspace, X and Y. \returns false for other keys
    bool takeKey(const QKeyEvent &event);
    //! \param about point that turning and scaling leave in place
    Eigen::Affine2d transform(const Vec2 &about) const;
    Eigen::Affine2d transform() const { return transform(pivot); }
    //! The value of transform() with its unit, translated.
    QString text() const;

    //! The displacement of the mouse, before snapping. \pre edit is Move
    Vec2 mouseMove() const { return current - start; }

private:
    Vec2 displacement() const;
    double angle() const; //!< degrees, counter-clockwise
    double factor() const;
    std::optional<double> typedNumber() const;
};

} // namespace autocuts
