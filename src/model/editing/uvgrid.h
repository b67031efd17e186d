// Grids of quads in a UV map, and the rectangles that they become.
#pragma once

#include "model/plain/uvlayout.h"

#include <utility>
#include <vector>

namespace autocuts {

struct UvTopology;

//! Faces that form a part of a regular grid of quads, and their places as rectangles. A point is a UV vertex,
//! named by its first corner.
struct UvGrid
{
    std::vector<int> faces; //!< ascending
    std::vector<std::pair<int, Vec2>> places;
};

struct UvGrids
{
    std::vector<UvGrid> grids;
    //! Faces that are in no grid: no quads, or the set that they are in is not regular (three or five quads
    //! around a point), or is closed around a tube.
    std::vector<int> left;
};

//! Finds the connected sets of quads among faces, and straightens those that are grids: all edges along the
//! axes, each column and row as wide as the mean of its edges on the model times their texel weights, at the
//! texel density of the set. The grid keeps its centre and turns to the nearest axis; a mirrored set stays
//! mirrored. \param uv one row per corner, texture space \param faces each once
UvGrids findUvGrids(const MeshData &mesh, const UvTopology &topology, const UvMatrix &uv,
                    const std::vector<int> &faces);

} // namespace autocuts
