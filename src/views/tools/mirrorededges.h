// Which edges of a model are mirror images of each other.
#pragma once

#include "model/plain/meshdata.h"

#include <memory>
#include <vector>

namespace autocuts {

//! For every edge pair the one that its mirror image about the plane x = 0 falls on.
class MirroredEdges final
{
public:
    //! Looks for middles of edges that are not farther from the mirror image than a quarter of the length.
    explicit MirroredEdges(std::shared_ptr<const MeshData> mesh);

    //! The mesh that this is about.
    const MeshData *mesh() const { return mMesh.get(); }
    //! -1 when there is none, and for diagonals; edges on the plane are their own images.
    int mirrored(int edgePair) const { return mMirrored[edgePair]; }

private:
    std::shared_ptr<const MeshData> mMesh;
    std::vector<int> mMirrored;
};

} // namespace autocuts
