// Snapping moved islands to the islands around them.
#pragma once

#include "model/plain/types.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace autocuts {

class Document;

//! What a move snapped to; all of it is drawn.
struct IslandSnapResult
{
    Vec2 move = Vec2::Zero();   //!< the move after snapping
    std::optional<double> u, v; //!< lines that a side came to lie on
    std::optional<Vec2> corner; //!< place where two corners met
};

//! Knows the sides and corners of the islands that stay, and those of the islands that move as they were when
//! the gesture began. Corners win over sides. Sides meet at the same place, or at the margin of packing.
class IslandSnap final
{
public:
    //! \param moving numbers of islands that move now
    //! \param start their box when the gesture began
    IslandSnap(const Document &document, const std::vector<int> &moving, const Eigen::AlignedBox2d &start);

    //! \param reach how near is near, texture space
    IslandSnapResult snapped(const Vec2 &move, double reach) const;

private:
    void addSides(const Eigen::AlignedBox2d &box, double margin);
    bool snapToCorner(double reach, IslandSnapResult &result) const;

    //! A place that a certain side of the moved box may come to.
    struct Side
    {
        double from; //!< coordinate of the side at the start
        double to;
    };

    Eigen::AlignedBox2d mStart;
    std::array<std::vector<Side>, 2> mSides; //!< along u and v
    std::vector<Vec2> mMoving, mStaying;     //!< corners on outlines; those that stay by rising u
};

} // namespace autocuts
