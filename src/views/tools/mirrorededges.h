// Finds the edges of a model that are mirror images of each other.
#pragma once

#include "model/plain/meshdata.h"

#include <memory>
#include <vector>

namespace autocuts {

//! For every edge pair, the edge pair at its mirror image in the plane x = 0.
class MirroredEdges final
{
public:
    //! Midpoints match when the distance from the mirror image is at most a quarter of the edge's length;
    //! chosen by hand.
    explicit MirroredEdges(std::shared_ptr<const MeshData> mesh);

    //! The mesh of the edges.
    const MeshData *mesh() const { return mMesh.get(); }
    //! The mirror image of an edge pair; -1 when there is none, and for diagonals. Edges on the plane are
    //! their own images.
    int mirrored(int edgePair) const { return mMirrored[edgePair]; }

private:
    std::shared_ptr<const MeshData> mMesh;
    std::vector<int> mMirrored;
};

} // namespace autocuts
