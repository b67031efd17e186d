// A UV map with its seams, as the seam search changes it step by step.
#pragma once

#include "solver/base/cornerat.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/search/seamgraph.h"
#include "solver/search/trianglekernel.h"

#include <memory>
#include <span>
#include <vector>

namespace autocuts::search {

//! Where to look for overlaps: around some triangles, or everywhere when there are none.
struct MapPlace
{
    std::span<const int> triangles{};
    bool wholeCharts = false; //!< the triangles are all those of their charts
};

//! Cut flags and UV coordinates, with the energy and the seam cost that the search minimises. Corners of one
//! UV vertex have bitwise equal coordinates, and no triangle is flipped. Charts are connected sets of
//! triangles over uncut edges; they are kept apart in the plane. Charts with anchors stay where these hold
//! them, all others may be anywhere.
struct CutState
{
    //! Least share of the mesh's 3D area that a chart with this triangle may have, unless the chart is a
    //! whole connected component of the mesh: 0.5 %, a requirement on the result, not a tuned number; but
    //! half of the component where that is less, or the links of a chain could not be cut.
    static double smallestChart(const Soup &soup, int triangle)
    {
        return std::min(0.005, 0.5 * soup.componentShare[soup.mesh->component[triangle]]);
    }

    //! With more charts below smallestChart() than this, the requirement is given up: growing each would
    //! lengthen the seams of rough surfaces by half and more. They are only joined where that pays.
    static constexpr int manySmallParts = 100;

    std::shared_ptr<const SeamGraph> graph;
    std::vector<char> cut;              //!< per edge pair
    std::vector<double> x;              //!< per soup corner, see Soup
    std::vector<double> triangleEnergy; //!< per triangle, see energyOf()
    double energy = 0;                  //!< sum of triangleEnergy
    //! Mean symmetric Dirichlet energy, 4 at an isometry, with the stiffness of rigid regions: what the bound
    //! is for.
    double distortion = 0;
    //! Of the seams: sum of SeamGraph::cost, and what the border costs that does not run along the axes.
    double cost = 0;
    double crooked = 0;            //!< the latter
    double length = 0;             //!< of the seams, solver units
    std::vector<int> boundary;     //!< triangle sides that are open or cut, in ascending order
    std::vector<int> chart;        //!< per triangle: its chart
    std::vector<double> chartArea; //!< per chart: share of the mesh's 3D area, see Soup::shareOfCopy()
    //! Number of charts below smallestChart() that are not whole connected components of the mesh.
    int smallParts = 0;
    std::vector<int> cutsAt; //!< per vertex of the uncut surface: number of its cut edges

    //! True when the charts with anchors are where these hold them. Before, anchors have no effect.
    bool anchored = false;
    double pinStiffness = 1;      //!< of hard pins that are not reached yet
    std::vector<char> pinReached; //!< per anchor: a hard pin whose corner lies on it and is held there
    //! True when every chart without anchors has room around it, see spreadCharts(): then it cannot come to
    //! lie on another one by what changes it.
    bool chartsAreApart = false;
    //! True when charts with anchors overlapped other charts or obstacles from the start. Then only overlaps
    //! within one chart count.
    bool chartsMayMeet = false;

    //! \param inPlace the map already lies where the anchors are
    static CutState from(std::shared_ptr<const SeamGraph> graph, const SeamedMap &map, bool inPlace = false);
    SeamedMap map() const;

    //! What the search minimises. \param mu energy that one unit of seam cost is worth
    double objective(double mu) const { return energy + mu * cost; }
    int chartCount() const { return static_cast<int>(chartArea.size()); }
    //! True for a triangle side on a border of the mesh or on a cut edge.
    bool isCutSide(int side) const { return graph->across[side] < 0 || cut[graph->edgeOf[side]] != 0; }
    //! The part of a triangle in the distortion. \param p u and v of its corners
    double distortionOf(int t, const double *p) const;
    //! Energy of a triangle times its share of the area, and what its anchors cost.
    //! \param p u and v of its corners
    double energyOf(int t, const double *p) const;
    //! Gradient and Hessian of energyOf(), as triangleDerivatives().
    void derivativesOf(int t, const double *p, double *gradient, double *hessian) const;
    //! True when a change of a chart needs no look at the others.
    bool chartsAreAlone() const { return chartsAreApart && !anchored; }
    //! True for a triangle with anchors that have an effect.
    bool isAnchored(int t) const { return anchored && graph->anchors.onTriangle(t); }
    //! Per chart: true when it has anchors that have an effect.
    std::vector<char> chartsWithAnchors() const;
    //! Number of hard pins that are not reached, and one more when charts with anchors may lie on others.
    int anchorFaults() const;
    //! UV of a soup corner.
    Vec2 at(int corner) const { return cornerAt(x, corner); }
    //! True for a vertex of the uncut surface on a border of the mesh or on a cut edge.
    bool isBoundaryVertex(int v) const { return graph->border[v] || cutsAt[v] > 0; }

    //! Sets a cut flag and cutsAt; what else follows from the flags is for updateTopology().
    void setCut(int e, bool isCut);
    //! Recomputes everything that follows from the cut flags: boundary, charts, areas, cost and length.
    void updateTopology();
    //! Recomputes triangleEnergy, energy, distortion and the cost of crooked borders from the coordinates.
    void updateEnergy();
    //! \returns false when a chart there has more than one counter-clockwise boundary loop. Such a chart
    //! overlaps itself, even when no boundary sides cross.
    bool loopsAreInOrder(const MapPlace &place = {}) const;
    //! \returns true when triangles at the boundaries overlap there. When this is false everywhere and
    //! loopsAreInOrder() is true, no chart overlaps itself. Where charts are apart, only those of the
    //! triangles are looked at. True also when stopped.
    bool boundariesOverlap(const MapPlace &place = {}, const JobContext &job = {}) const;
    //! True when no chart overlaps itself there. False also when stopped.
    bool isFreeOfOverlaps(const MapPlace &place = {}, const JobContext &job = {}) const
    {
        return loopsAreInOrder(place) && !boundariesOverlap(place, job);
    }
    //! The obstacles whose boxes meet a box. None before the charts are at their anchors.
    std::vector<const Obstacle *> obstaclesAt(const Vec2 &low, const Vec2 &high) const;
    //! Moves the charts without anchors into rows with room between them.
    void spreadCharts();

    //! Recomputes the cost of crooked borders, a part of the cost, from the coordinates.
    void updateCrooked();
    //! Recomputes smallParts from boundary, charts and areas.
    void countSmallParts();

private:
    std::vector<int> boundaryAt(const MapPlace &place) const;
    double anchorEnergy(int t, const double *p) const;
    void addAnchorDerivatives(int t, const double *p, double *gradient, double *hessian) const;
};

inline double CutState::distortionOf(int t, const double *p) const
{
    const Soup &soup = *graph->soup;
    const double density = search::triangleEnergy(p, soup.basis[t]);
    return soup.weight[t] * (graph->rigid ? 4 + graph->stiffness(t) * (density - 4) : density);
}

inline double CutState::energyOf(int t, const double *p) const
{
    const Soup &soup = *graph->soup;
    const double value = graph->energy == DistortionEnergy::SymmetricDirichlet
                             ? distortionOf(t, p)
                             : soup.weight[t] * amipsEnergy(p, soup.basis[t]);
    return isAnchored(t) ? value + anchorEnergy(t, p) : value;
}

inline void CutState::derivativesOf(int t, const double *p, double *gradient, double *hessian) const
{
    const Soup &soup = *graph->soup;
    if (graph->energy == DistortionEnergy::SymmetricDirichlet)
        triangleDerivatives(p, soup.basis[t], graph->stiffness(t) * soup.weight[t], gradient, hessian);
    else
        amipsDerivatives(p, soup.basis[t], soup.weight[t], gradient, hessian);
    if (isAnchored(t))
        addAnchorDerivatives(t, p, gradient, hessian);
}

} // namespace autocuts::search
