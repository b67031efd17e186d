#include "solver/metrics/uvtriangles.h"

#include "model/plain/polygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace autocuts::metrics {

namespace {

int apexOfFace(const MeshData &mesh, int face, std::vector<Vec3> &points)
{
    const int start = mesh.faceStart[face];
    const int end = mesh.faceStart[face + 1];
    if (end - start == 3)
        return 0;
    points.clear();
    for (int c = start; c < end; ++c)
        points.push_back(mesh.cornerPosition(c));
    return std::max(0, fanApex(points));
}

void addFans(const MeshData &mesh, const UvTopology &topology, UvTriangles &triangles)
{
    std::vector<Vec3> points;
    while (triangles.count() < mesh.triangleCount()) {
        const int f = mesh.triangleFace[triangles.count()];
        const int start = mesh.faceStart[f];
        const int n = mesh.faceStart[f + 1] - start;
        const int apex = apexOfFace(mesh, f, points);
        for (int i = 1; i + 1 < n; ++i) {
            triangles.corners.push_back({start + apex, start + (apex + i) % n, start + (apex + i + 1) % n});
            triangles.face.push_back(f);
            triangles.chart.push_back(topology.charts.faceChart[f]);
        }
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
        if (!triangles.zeroArea[t])
            chart.area3d += triangles.area3d[t];
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
    addFans(mesh, topology, triangles);
    measureAreas(mesh, uv, triangles);
    countChartElements(mesh, topology, triangles);
    return triangles;
}

} // namespace autocuts::metrics
