// What a gesture with islands does to them: from mouse, axis and typed number to a transform.
#pragma once

#include "commands/setuvs.h"
#include "views/tools/snapping.h"

#include <QString>

class QKeyEvent;

namespace autocuts {

//! The axis that a gesture is held to.
enum class DragAxis { Both, X, Y };

//! A gesture under way. All places are in texture space.
struct IslandDrag
{
    UvEdit edit = UvEdit::Move; //!< Move, Rotate or Scale
    Vec2 start = Vec2::Zero();  //!< of the mouse
    Vec2 current = Vec2::Zero();
    Eigen::AlignedBox2d box; //!< of the islands at the start; its centre is the pivot
    DragAxis axis = DragAxis::Both;
    QString typed; //!< a number that takes the place of the mouse: texels, degrees or a factor
    SnapTo snap = SnapTo::Nothing;
    double snapStep = 0;             //!< of Move
    Vec2 islandShift = Vec2::Zero(); //!< of Move: what snapping to other islands adds
    double pixel = 1;                //!< size of a pixel of the view at the start
    int textureSize = 1;

    //! Takes digits, point, minus, backspace, X and Y. \returns false when the key is none of them
    bool takeKey(const QKeyEvent &event);
    Vec2 pivot() const { return box.center(); }
    Eigen::Affine2d transform() const;
    //! What transform() does, with its unit, translated.
    QString text() const;

    //! Where the mouse has moved, before it snaps. \pre edit is Move
    Vec2 mouseMove() const { return current - start; }

private:
    Vec2 displacement() const;
    double angle() const; //!< degrees, counterclockwise
    double factor() const;
    std::optional<double> typedNumber() const;
};

} // namespace autocuts
