// Chains of connected edges in a UV map, and straightening them.
#pragma once

#include "model/plain/meshadjacency.h"
#include "model/plain/uvlayout.h"

#include <utility>
#include <vector>

namespace autocuts {

struct UvTopology;

//! A chain of edges in the UV map. A point is a UV vertex, named by its first corner.
struct UvChain
{
    std::vector<int> points;     //!< at least three points, from one end to the other
    std::vector<double> lengths; //!< 3D lengths of the edges
};

struct UvChains
{
    std::vector<UvChain> chains;
    //! Number of connected sets of edges that are not chains: a single edge, a closed loop, a branching set.
    int left = 0;
};

//! Finds the chains that the given edges form in the UV map. An edge on a seam is in the map twice.
//! \param edges edges of MeshAdjacency
UvChains findUvChains(const MeshData &mesh, const MeshAdjacency &adjacency, const UvTopology &topology,
                      const std::vector<int> &edges);

//! The positions of a chain's points when it is made straight: on the line through its two ends, with the
//! length of the chain, centred between its ends, and spaced as in 3D. Empty when the ends coincide.
std::vector<std::pair<int, Vec2>> straightened(const UvChain &chain, const UvMatrix &uv);

} // namespace autocuts
