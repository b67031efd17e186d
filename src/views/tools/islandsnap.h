// Snaps moved islands to other islands.
#pragma once

#include "model/plain/types.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace autocuts {

class Document;

//! What a move snapped to; the tool draws it.
struct IslandSnapResult
{
    Vec2 move = Vec2::Zero();   //!< the displacement after snapping
    std::optional<double> u, v; //!< coordinates of the lines to which sides were aligned
    std::optional<Vec2> corner; //!< the point at which two corners meet
};

//! Stores the sides and corners of the islands that stay, and those of the moving islands at the start of the
//! gesture. Corners are preferred to sides. Sides snap to the same position, or to a distance of the packing
//! gutter.
class IslandSnap final
{
public:
    //! \param moving indices of the moving islands
    //! \param start their bounding box at the start of the gesture
    IslandSnap(const Document &document, const std::vector<int> &moving, const Eigen::AlignedBox2d &start);

    //! \param reach largest snapping distance, in texture space
    IslandSnapResult snapped(const Vec2 &move, double reach) const;

private:
    void addSides(const Eigen::AlignedBox2d &box, double margin);
    bool snapToCorner(double reach, IslandSnapResult &result) const;

    //! A position to which one side of the moved box may snap.
    struct Side
    {
        double from; //!< coordinate of the side at the start
        double to;
    };

    Eigen::AlignedBox2d mStart;
    std::array<std::vector<Side>, 2> mSides; //!< along u and v
    //! Corners on outlines; those of staying islands are sorted by u.
    std::vector<Vec2> mMoving, mStaying;
};

} // namespace autocuts
