#include "solver/metrics/uvtriangles.h"

#include "model/plain/polygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace autocuts::metrics {

namespace {

using Triangles = std::vector<std::array<int, 3>>;

//! True when the triangles of one polygon do not all have the same winding in the map.
bool turnsOver(const Triangles &triangles, const UvMatrix &uv)
{
    double sum = 0, absolute = 0;
    for (const auto &t : triangles) {
        const double area = cross2(uv.row(t[0]), uv.row(t[1]), uv.row(t[2]));
        sum += area;
        absolute += std::abs(area);
    }
    return absolute - std::abs(sum) > 1e-12 * absolute;
}

//! The triangles of a polygon of which those of the mesh are turned over in the map; those of the mesh when
//! there are no better ones.
Triangles trianglesInMap(const MeshData &mesh, const UvMatrix &uv, int face, const Triangles &ofMesh)
{
    std::vector<Vec3> points, flat;
    const int start = mesh.faceStart[face];
    for (int c = start; c < mesh.faceStart[face + 1]; ++c) {
        points.push_back(mesh.cornerPosition(c));
        flat.emplace_back(uv(c, 0), uv(c, 1), 0);
    }
    if (fanApex(points) >= 0)
        return ofMesh;
    Triangles result = triangulatePolygon(flat);
    for (auto &triangle : result) {
        for (int &corner : triangle)
            corner += start;
    }
    return turnsOver(result, uv) ? ofMesh : result;
}

void addTriangles(const MeshData &mesh, const UvMatrix &uv, const UvTopology &topology,
                  UvTriangles &triangles)
{
    triangles.corners = mesh.triangles;
    triangles.face = mesh.triangleFace;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        triangles.chart.push_back(topology.charts.faceChart[mesh.triangleFace[t]]);
        triangles.texelWeight.push_back(mesh.texelWeightOf(t));
    }
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const auto count = mesh.trianglesOf(f).size();
        if (count < 2 || !topology.faceHasUv[f])
            continue;
        const auto first = triangles.corners.begin() + mesh.faceTriangle[f];
        const Triangles ofMesh(first, first + static_cast<std::ptrdiff_t>(count));
        if (turnsOver(ofMesh, uv))
            std::ranges::copy(trianglesInMap(mesh, uv, f, ofMesh), first);
    }
}

void measureAreas(const MeshData &mesh, const UvMatrix &uv, UvTriangles &triangles)
{
    const int count = triangles.count();
    triangles.area3d.resize(count);
    triangles.signedArea.assign(count, 0.0);
    triangles.zeroArea.resize(count);
    for (int t = 0; t < count; ++t) {
        const auto &corner = triangles.corners[t];
        const Vec3 a = mesh.cornerPosition(corner[0]);
        const Vec3 b = mesh.cornerPosition(corner[1]);
        const Vec3 c = mesh.cornerPosition(corner[2]);
        const double longest =
            std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
        triangles.area3d[t] = 0.5 * (b - a).cross(c - a).norm();
        triangles.zeroArea[t] = !(triangles.area3d[t] > 1e-10 * longest);
        if (std::isfinite(triangles.area3d[t]))
            triangles.totalArea3d += triangles.area3d[t];
        if (!triangles.hasUv(t))
            continue;
        const double area = 0.5 * cross2(uv.row(corner[0]), uv.row(corner[1]), uv.row(corner[2]));
        triangles.signedArea[t] = area;
        triangles.totalUvArea += std::abs(area);
        ChartSums &chart = triangles.charts[triangles.chart[t]];
        chart.signedArea += area;
        chart.uvArea += std::abs(area);
        if (!triangles.zeroArea[t]) {
            chart.area3d += triangles.area3d[t];
            chart.targetArea += triangles.targetArea(t);
        }
    }
}

void countChartElements(const MeshData &mesh, const UvTopology &topology, UvTriangles &triangles)
{
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (!topology.faceHasUv[f])
            continue;
        ChartSums &chart = triangles.charts[topology.charts.faceChart[f]];
        ++chart.faces;
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            chart.vertices += topology.cornerRoot[c] == c;
    }
    for (const UvEdge &edge : topology.uvEdges)
        ++triangles.charts[edge.chart].edges;
}

} // namespace

bool UvTriangles::uvDegenerate(int t) const
{
    return std::abs(signedArea[t]) < 1e-14 * totalUvArea || signedArea[t] == 0;
}

UvTriangles collectUvTriangles(const MeshData &mesh, const UvMatrix &uv, const UvTopology &topology)
{
    UvTriangles triangles;
    triangles.charts.resize(topology.charts.count);
    addTriangles(mesh, uv, topology, triangles);
    measureAreas(mesh, uv, triangles);
    countChartElements(mesh, topology, triangles);
    return triangles;
}

} // namespace autocuts::metrics
