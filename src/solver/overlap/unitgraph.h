// Graph of the units that cuts may separate: which are linked and which overlap.
#pragma once

#include "model/plain/csrlist.h"
#include "model/plain/meshdata.h"
#include "solver/overlap/overlapfinder.h"

#include <vector>

namespace autocuts::overlap {

//! A *unit* is a set of triangles that stay together: one polygon, or several connected by protected pairs. A
//! *link* is an uncut edge pair between two units. Algorithms on this graph give every unit a *part*, a
//! label; links between different parts are then cut.
struct UnitGraph
{
    struct Link
    {
        int pair; //!< edge pair of the mesh
        int a, b; //!< the units
    };

    int unitCount = 0;
    std::vector<int> unitOfTriangle;
    CsrList triangles;       //!< of each unit, ascending
    std::vector<Link> links; //!< in the order of the edge pairs
    CsrList linksOfUnit;
    CsrList neighbours;    //!< of each unit, ascending, each once
    CsrList conflicts;     //!< units that overlap each unit, ascending, each once
    int innerOverlaps = 0; //!< overlapping pairs inside one unit: no cut can help

    int across(int link, int unit) const { return links[link].a == unit ? links[link].b : links[link].a; }
};

//! \param protectedPair per edge pair; diagonals are always protected; empty: none
//! \param overlaps pairs of triangles
UnitGraph makeUnitGraph(const MeshData &mesh, const std::vector<bool> &cut,
                        const std::vector<bool> &protectedPair, const std::vector<OverlapPair> &overlaps);

//! Chart of every triangle: connected components over uncut edge pairs, numbered by their first triangles.
std::vector<int> chartsOfCut(const MeshData &mesh, const std::vector<bool> &cut);

//! The overlaps within one chart.
struct ChartConflicts
{
    std::vector<int> triangles; //!< of the chart, ascending
    UnitGraph graph;            //!< of the whole mesh, with the overlaps of these triangles
    bool complete = true;       //!< false when cancelled
};

//! The overlaps within the chart of a triangle.
//! \param soupUv three rows per triangle
//! \param seedTriangle any triangle of the chart
//! \throws std::invalid_argument when a size does not fit the mesh
ChartConflicts conflictsOfChart(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<bool> &cut,
                                int seedTriangle, const OverlapOptions &options);

} // namespace autocuts::overlap
