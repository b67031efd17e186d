// The triangles on which the figures are measured, and sums over them. Internal to the metrics.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts::metrics {

//! Measurements of one chart.
struct ChartSums
{
    int faces = 0, vertices = 0, edges = 0;
    double area3d = 0;     //!< without zero-area triangles
    double targetArea = 0; //!< the same, each multiplied by the square of its texel weight
    double uvArea = 0;     //!< sum of absolute areas
    double signedArea = 0;

    int euler() const { return vertices - edges + faces; }
};

//! Triangles of all faces by the rule of UvMetrics, with their areas. A face has the same numbers as in the
//! mesh.
struct UvTriangles
{
    std::vector<std::array<int, 3>> corners;
    std::vector<int> face;
    std::vector<int> chart; //!< -1 without UVs
    std::vector<double> area3d;
    std::vector<double> texelWeight; //!< of its face
    std::vector<double> signedArea;  //!< signed area in UV; 0 without UVs
    std::vector<bool> zeroArea;      //!< no area in 3D
    double totalArea3d = 0, totalUvArea = 0;
    std::vector<ChartSums> charts;

    int count() const { return static_cast<int>(corners.size()); }
    double targetArea(int t) const { return texelWeight[t] * texelWeight[t] * area3d[t]; }
    bool hasUv(int t) const { return chart[t] >= 0; }
    //! True when the UV area is 0 compared with that of the whole map.
    bool uvDegenerate(int t) const;
};

UvTriangles collectUvTriangles(const MeshData &mesh, const UvMatrix &uv, const UvTopology &topology);

} // namespace autocuts::metrics
