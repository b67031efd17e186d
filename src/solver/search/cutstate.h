// A UV map with its seams, as the seam search changes it step by step.
#pragma once

#include "solver/base/cornerat.h"
#include "solver/base/seamedmap.h"
#include "solver/search/seamgraph.h"

#include <memory>
#include <vector>

namespace autocuts::search {

//! Cut flags and UV coordinates, with the energy and the seam cost that the search minimises. Corners of one
//! UV vertex have bitwise equal coordinates, and no triangle is flipped. Charts are connected sets of
//! triangles over uncut edges; they are kept apart in the plane.
struct CutState
{
    //! Least share of the mesh's 3D area that a chart may have, unless the chart is a whole connected
    //! component of the mesh. A requirement on the result (0.5 %), not a tuned number.
    static constexpr double smallestChart = 0.005;

    std::shared_ptr<const SeamGraph> graph;
    std::vector<char> cut;              //!< per edge pair
    std::vector<double> x;              //!< per soup corner, see Soup
    std::vector<double> triangleEnergy; //!< per triangle, symmetric Dirichlet energy times share of the area
    double energy = 0;                  //!< sum of triangleEnergy: the mean energy, 4 at an isometry
    double cost = 0;                    //!< of the seams: sum of SeamGraph::cost
    double length = 0;                  //!< of the seams, solver units
    std::vector<int> boundary;          //!< triangle sides that are open or cut, in ascending order
    std::vector<int> chart;             //!< per triangle: its chart
    std::vector<double> chartArea;      //!< per chart: share of the mesh's 3D area

    static CutState from(std::shared_ptr<const SeamGraph> graph, const SeamedMap &map);
    SeamedMap map() const;

    //! What the search minimises. \param mu energy that one unit of seam cost is worth
    double objective(double mu) const { return energy + mu * cost; }
    int chartCount() const { return static_cast<int>(chartArea.size()); }
    //! True for a triangle side on a border of the mesh or on a cut edge.
    bool isCutSide(int side) const { return graph->across[side] < 0 || cut[graph->edgeOf[side]] != 0; }
    //! UV of a soup corner.
    Vec2 at(int corner) const { return cornerAt(x, corner); }
    //! Number of charts below smallestChart that are not whole connected components of the mesh.
    int smallParts() const;
    //! Number of cut edges at a vertex of the uncut surface.
    int cutsAt(int v) const;

    //! Recomputes everything that follows from the cut flags: boundary, charts, areas, cost and length.
    void updateTopology();
    //! Recomputes triangleEnergy and energy from the coordinates.
    void updateEnergy();
    //! \returns false when a chart has more than one counter-clockwise boundary loop. Such a chart overlaps
    //! itself, even when no boundary sides cross.
    bool loopsAreInOrder() const;
    //! \returns true when triangles at the boundaries overlap near the given triangles (anywhere when empty).
    //! When this is false everywhere and loopsAreInOrder() is true, no chart overlaps itself.
    bool boundariesOverlap(const std::vector<int> &triangles = {}) const;
    //! Moves the charts into rows with room between them.
    void spreadCharts();
};

} // namespace autocuts::search
