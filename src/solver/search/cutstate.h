// A seamed map in the form that a seam search changes step by step.
#pragma once

#include "solver/base/cornerat.h"
#include "solver/base/seamedmap.h"
#include "solver/search/seamgraph.h"

#include <memory>
#include <vector>

namespace autocuts::search {

//! Cut flags and coordinates, with the sums that are to be minimised kept up to date. Corners of one UV
//! vertex have bitwise equal coordinates; no triangle is turned over. The charts lie apart from each other.
struct CutState
{
    //! Share of the whole that a chart must have unless it is a whole piece of the mesh.
    static constexpr double smallestChart = 0.005;

    std::shared_ptr<const SeamGraph> graph;
    std::vector<char> cut;              //!< per edge pair
    std::vector<double> x;              //!< per soup corner, see Soup
    std::vector<double> triangleEnergy; //!< per triangle, weighted by area
    double energy = 0;                  //!< their sum: the mean symmetric Dirichlet energy
    double cost = 0;                    //!< of the seams: length times painted weight
    double length = 0;                  //!< of the seams
    std::vector<int> boundary;          //!< open or cut triangle sides, rising
    std::vector<int> chart;             //!< per triangle
    std::vector<double> chartArea;      //!< share of the whole, per chart

    static CutState from(std::shared_ptr<const SeamGraph> graph, const SeamedMap &map);
    SeamedMap map() const;

    double objective(double mu) const { return energy + mu * cost; }
    int chartCount() const { return static_cast<int>(chartArea.size()); }
    bool isCutSide(int side) const { return graph->across[side] < 0 || cut[graph->edgeOf[side]] != 0; }
    Vec2 at(int corner) const { return cornerAt(x, corner); }
    //! Number of charts below smallestChart that are not whole pieces of the mesh.
    int smallParts() const;
    //! Number of cut edges at a point of the surface.
    int cutsAt(int v) const;

    //! Brings everything derived from the flags up to date.
    void updateTopology();
    //! Brings the energies up to date.
    void updateEnergy();
    //! False when a chart has more than one boundary loop that runs counter-clockwise: it covers itself then,
    //! even when no boundary crosses another.
    bool loopsAreInOrder() const;
    //! True when triangles at the boundaries overlap each other near the given triangles (all when empty).
    //! With loops in order no chart covers itself otherwise.
    bool boundariesOverlap(const std::vector<int> &triangles = {}) const;
    //! Moves the charts apart from each other, in rows.
    void spreadCharts();
};

} // namespace autocuts::search
