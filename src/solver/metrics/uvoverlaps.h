// The overlaps of a map, by the one rule that figures, marks and lists follow.
#pragma once

#include "model/plain/islandflags.h"
#include "solver/metrics/uvtriangles.h"
#include "solver/overlap/overlapfinder.h"

#include <cstdint>
#include <vector>

namespace autocuts::metrics {

//! Which overlaps count, and how many are listed.
struct UvOverlapOptions
{
    //! Per face. Islands of one stack lie on each other on purpose: their overlaps do not count. Empty: none
    //! is stacked.
    std::vector<IslandFlags> faceFlags{};
    std::size_t maxPairs = 50'000'000; //!< findUvOverlaps() stops there
    JobContext job{};
};

//! The overlaps of a map as figures. Pairs are those above overlap::visibleOverlap.
struct UvOverlapFigures
{
    std::int64_t pairs = 0;
    std::int64_t sameChartPairs = 0;
    std::int64_t stackedPairs = 0; //!< of islands of one stack; not in the other figures
    std::int64_t triangles = 0;    //!< in the pairs
    double area = 0;               //!< sum of the areas of all intersections, smaller ones as well
    bool complete = true;          //!< false when stopped
};

//! Measures the overlaps of a map. \param triangles of the map
UvOverlapFigures measureUvOverlaps(const UvMatrix &uv, const UvTopology &topology,
                                   const UvTriangles &triangles, const UvOverlapOptions &options);

//! The pairs that are counted, in ascending order. Triangles have their numbers in the mesh; those of a face
//! that UvMetrics splits otherwise have the numbers of its triangles there.
[[nodiscard]] overlap::OverlapList findUvOverlaps(const MeshData &mesh, const UvMatrix &uv,
                                                  const UvOverlapOptions &options);

//! The triangles in these pairs, in ascending order.
std::vector<int> overlappingTriangles(const overlap::OverlapList &overlaps);
//! The same of findUvOverlaps(), of however many pairs, without a list of them. Those found so far when
//! stopped.
std::vector<int> overlappingTriangles(const MeshData &mesh, const UvMatrix &uv,
                                      const UvOverlapOptions &options);

} // namespace autocuts::metrics
