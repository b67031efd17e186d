// Chains of edges in the map, and the straight lines that they can become.
#pragma once

#include "model/plain/meshadjacency.h"
#include "model/plain/uvlayout.h"

#include <utility>
#include <vector>

namespace autocuts {

struct UvTopology;

//! Edges of the map one after the other. A point is a UV vertex, named by its first corner.
struct UvChain
{
    std::vector<int> points;     //!< at least three, from one end to the other
    std::vector<double> lengths; //!< of the edges in 3D
};

struct UvChains
{
    std::vector<UvChain> chains;
    int left = 0; //!< connected edges that are no chain: a single edge, a closed loop, a fork
};

//! The chains that the edges make in the map; an edge on a seam lies in it twice.
//! \param edges of MeshAdjacency
UvChains findUvChains(const MeshData &mesh, const MeshAdjacency &adjacency, const UvTopology &topology,
                      const std::vector<int> &edges);

//! Where the points of a chain lie when it is straight: along the line through its ends, as long as it is,
//! about the middle between its ends, spaced as in 3D. Nothing when the ends coincide.
std::vector<std::pair<int, Vec2>> straightened(const UvChain &chain, const UvMatrix &uv);

} // namespace autocuts
