// Distances between the borders of charts.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshdata.h"
#include "solver/overlap/boxtree.h"

#include <functional>

namespace autocuts::overlap {

//! A piece of a chart's border.
struct BorderSegment
{
    Vec2 from, to;
    int chart = 0;
};

//! The borders of charts: the sides of their triangles without a neighbour at the same place.
//! \param uv one row per corner \param charts sides of faces without a chart are left out
std::vector<BorderSegment> chartBorders(const MeshData &mesh, const ChartMap &charts, const UvMatrix &uv);

//! Finds charts that are near each other, by their borders.
class NearCharts
{
public:
    explicit NearCharts(std::vector<BorderSegment> borders);

    //! The least distance between two charts, 0 where their borders cross; infinite with fewer than two.
    double smallestDistance() const;
    //! Calls visit(a, b, distance of the segments) for the charts of any two segments that are nearer to each
    //! other than a distance. The same two charts may come several times.
    void visitNearer(double distance, const std::function<void(int, int, double)> &visit) const;

private:
    void searchNearest(int segment, double &best) const;

    std::vector<BorderSegment> mBorders;
    BoxTree mTree;
    std::vector<int> mNodeChart; //!< per node: the chart of all segments below it, -1: several
};

} // namespace autocuts::overlap
