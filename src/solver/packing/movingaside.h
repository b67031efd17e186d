// Moves single islands aside to free places near by.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/packing/layout.h"

#include <optional>

namespace autocuts::packing {

//! The islands of a map, of which one after the other is moved aside. All others are obstacles where they
//! are.
class AsideMover
{
public:
    //! \param gutter distance to all others at which there is room for an island, UV units; nearer places are
    //! taken when there is none. \pre gutter > 0
    //! \param tileHeight of the texture, see PackingSettings::tileHeight()
    AsideMover(std::vector<PackIsland> islands, double gutter, double tileHeight);

    //! Moves an island by some gutters, at most by its own size, without turning it: to the first place at
    //! which it keeps its distance to all others. An island that lies in one tile of the texture stays in it.
    //! \param direction the way that is tried first
    //! \returns the way; nothing when there is no room or when stopped. Then the island stays
    std::optional<Vec2> moveAside(int island, const Vec2 &direction, const JobContext &job = {});

private:
    Eigen::AlignedBox2d boxOf(int island) const;
    const Outline &outlineOf(int island);
    PackProblem problemAround(int island, double reach);

    std::vector<PackIsland> mIslands;
    std::vector<Eigen::AlignedBox2d> mBoxes; //!< of the islands as they were given
    std::vector<Vec2> mWays;                 //!< how far each island has been moved
    std::vector<std::optional<Outline>> mOutlines;
    double mGutter, mTileHeight;
};

} // namespace autocuts::packing
