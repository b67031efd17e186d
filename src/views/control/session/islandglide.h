// How the islands of one map get to their places in the next one.
#pragma once

#include "model/plain/meshdata.h"

#include <span>
#include <vector>

namespace autocuts {

//! A map, and where it is open.
struct OpenedMap
{
    const UvMatrix &uv;                //!< one finite row per soup corner, texture space
    std::span<const float> separation; //!< per corner pair, see ShownMap::separation()
};

//! Takes the islands of a map to their places in the next one. An island whose seams stayed moves, turns and
//! changes its scale as a whole; the others keep their old places.
class IslandGlide
{
public:
    //! On larger meshes the map before only shines through for as long: their buffers take long to fill.
    static constexpr int mostTriangles = 100'000;

    //! \pre both maps are of this mesh
    IslandGlide(const MeshData &mesh, const OpenedMap &before, const OpenedMap &after);

    //! The map before on its way. \param share of the way, from 0 to 1
    UvMatrix at(double share) const;
    //! The number of islands that move.
    int movingCount() const { return static_cast<int>(mMotions.size()); }

private:
    struct Motion
    {
        Vec2 from, to; //!< centre of the island
        double angle, logScale;
    };

    UvMatrix mBefore;
    std::vector<int> mMotionOf; //!< per triangle; -1: it stays
    std::vector<Motion> mMotions;
};

} // namespace autocuts
