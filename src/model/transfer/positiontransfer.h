// Takes the UVs of a mesh from the nearest points of another surface. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"
#include "model/transfer/sourcesurface.h"

#include <functional>
#include <vector>

namespace autocuts::transfer {

//! Work that can take long asks at least every 50 ms whether to stop. Both may be empty.
struct TransferControl
{
    std::function<bool()> stopped;
    std::function<void(double)> progress; //!< \param fraction in [0, 1]

    bool isStopped() const { return stopped && stopped(); }
};

//! The result of takeByPosition().
struct PositionUvs
{
    bool stopped = false;     //!< then the rest is not complete
    UvMatrix uv;              //!< one row per corner; rows of faces that were not placed are as before
    std::vector<bool> placed; //!< per face: it has its UVs from this
    //! Distances of the placed faces' corners and centres from the surface, as shares of the frame's size.
    double meanDistance = 0, maxDistance = 0;
    //! The mean distance of the centres of all wanted faces, also of those that are too far away.
    double meanOfAll = 0;
    int turnedOver = 0; //!< triangles turned over against the source
    int collapsed = 0;  //!< triangles with hardly any area in the map though the source has some
};

//! True when so few of the faces were matched that the models hardly belong together.
inline bool isApart(int matched, int faces)
{
    return 2LL * matched < faces;
}

//! Gives faces the UVs of the nearest points on a surface. The corners of one face always come from one
//! connected part of the source's map, so no face is smeared across a seam; where a face lies across one, its
//! side is chosen so that the seam along the edges of the mesh is short, and a corner beyond the border takes
//! the nearest UV on the border. The surface must face the same way, within about 80 degrees, where it does
//! so anywhere near: both sides of a thin plate keep apart.
//! \param frame in which the mesh lies where the source does
//! \param uv one row per corner: the UVs of the other faces, to which the map is joined where it meets them
//! \param wanted per face: whether it gets UVs
PositionUvs takeByPosition(const SourceSurface &source, const MeshData &mesh, const Frame &frame,
                           const UvMatrix &uv, const std::vector<bool> &wanted,
                           const TransferControl &control);

} // namespace autocuts::transfer
