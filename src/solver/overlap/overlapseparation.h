// Makes a map overlap-free by cutting more edges.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <cstdint>
#include <vector>

namespace autocuts::overlap {

//! How charts that overlap themselves are cut.
enum class SeparationMethod {
    MinCut, //!< between the two sheets of each overlap, along the shortest seam
    Greedy  //!< into breadth-first regions (paper, figure 11 right)
};

struct SeparationOptions
{
    SeparationMethod method = SeparationMethod::MinCut;
    std::vector<double> pairWeight; //!< per edge pair, factor >= 0 on the cost of cutting it; empty: all 1
    double minAreaRatio = 1e-10;    //!< an overlap counts above this share of the total UV area
    JobContext job;
};

struct [[nodiscard]] SeparationResult
{
    std::vector<bool> cut;         //!< per edge pair: the edges cut before and the new seams
    std::int64_t overlapPairs = 0; //!< overlapping triangle pairs inside one chart, before cutting
    int unresolvedPairs = 0;       //!< of these, pairs inside one polygon or protected group, which remain
    int newSeams = 0;              //!< edge pairs cut
    double newSeamLength = 0;      //!< 3D length, mesh units
    bool complete = true;          //!< false when cancelled: then nothing was cut
};

//! Cuts charts that overlap themselves until no chart does. A chart is a connected set of triangles over
//! uncut edge pairs. UV values do not change; the packing moves the new charts apart. Polygons are never
//! split.
//! \param soupUv one row per soup corner; the sides of uncut pairs agree
//! \param cut per edge pair, true for seams
//! \param protectedPair per edge pair, true where it must not be cut; diagonals never are; empty: none
//! \throws std::invalid_argument when a size does not fit the mesh
SeparationResult separateOverlaps(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                                  const std::vector<bool> &protectedPair,
                                  const SeparationOptions &options = {});

} // namespace autocuts::overlap
