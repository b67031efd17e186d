#include "model/plain/chart.h"

#include "model/plain/unionfind.h"
#include "model/plain/uvseams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

namespace autocuts {

namespace {

//! One side of a polygon, from its lower to its higher welded vertex.
struct TriangleSide
{
    int low, high; //!< welded vertices
    int cornerLow, cornerHigh;
    int face;
    bool apart; //!< a seam whatever its UVs are

    bool sameEdge(const TriangleSide &other) const { return low == other.low && high == other.high; }
};

std::vector<TriangleSide> sortedSides(const MeshData &mesh, const std::vector<bool> &apart)
{
    std::vector<TriangleSide> sides;
    sides.reserve(mesh.cornerCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f];
        const int end = mesh.faceStart[f + 1];
        for (int c = start; c < end; ++c) {
            const int d = c + 1 < end ? c + 1 : start;
            const int a = mesh.vertexWeld[mesh.cornerVertex[c]];
            const int b = mesh.vertexWeld[mesh.cornerVertex[d]];
            const bool isApart = !apart.empty() && apart[c];
            if (a < b)
                sides.push_back({a, b, c, d, f, isApart});
            else if (b < a)
                sides.push_back({b, a, d, c, f, isApart});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const TriangleSide &a, const TriangleSide &b) {
        return std::tie(a.low, a.high, a.cornerLow, a.cornerHigh) <
               std::tie(b.low, b.high, b.cornerLow, b.cornerHigh);
    });
    return sides;
}

void findUvBox(const MeshData &mesh, const UvMatrix &uv, UvTopology &topology)
{
    topology.boxLow = Vec2::Constant(std::numeric_limits<double>::infinity());
    topology.boxHigh = -topology.boxLow;
    topology.faceHasUv.assign(mesh.faceCount(), true);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            if (!uv.row(c).allFinite())
                topology.faceHasUv[f] = false;
        }
        if (!topology.faceHasUv[f])
            continue;
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            topology.boxLow = topology.boxLow.cwiseMin(uv.row(c).transpose());
            topology.boxHigh = topology.boxHigh.cwiseMax(uv.row(c).transpose());
        }
    }
}

//! Groups the sides on one 3D edge whose UVs agree; returns one side of each group and the number of sides in
//! it.
std::vector<std::pair<const TriangleSide *, int>> joinAgreeing(std::span<const TriangleSide> sides,
                                                               const UvMatrix &uv, double tolerance,
                                                               UnionFind &faces, UnionFind &corners,
                                                               const std::vector<bool> &faceHasUv)
{
    std::vector<std::pair<const TriangleSide *, int>> groups;
    for (const TriangleSide &side : sides) {
        if (!faceHasUv[side.face])
            continue;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto &group) {
            return !side.apart && !group.first->apart &&
                   sameUv(uv, group.first->cornerLow, side.cornerLow, tolerance) &&
                   sameUv(uv, group.first->cornerHigh, side.cornerHigh, tolerance);
        });
        if (same == groups.end()) {
            groups.emplace_back(&side, 1);
            continue;
        }
        ++same->second;
        faces.unite(same->first->face, side.face);
        corners.unite(same->first->cornerLow, side.cornerLow);
        corners.unite(same->first->cornerHigh, side.cornerHigh);
    }
    return groups;
}

} // namespace

std::vector<std::vector<int>> ChartMap::faces() const
{
    std::vector<std::vector<int>> result(count);
    for (int f = 0; f < static_cast<int>(faceChart.size()); ++f) {
        if (faceChart[f] >= 0)
            result[faceChart[f]].push_back(f);
    }
    return result;
}

UvTopology findUvTopology(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &apart)
{
    UvTopology topology;
    findUvBox(mesh, uv, topology);
    const double tolerance = uvTolerance * topology.boxDiagonal();
    const std::vector<TriangleSide> sides = sortedSides(mesh, apart);

    UnionFind faces(mesh.faceCount());
    UnionFind corners(mesh.cornerCount());
    std::vector<int> edgeFace; // of each UV edge
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t j = i;
        WeldedEdge edge{{sides[i].cornerLow, sides[i].cornerHigh}};
        for (; j < sides.size() && sides[j].sameEdge(sides[i]); ++j) {
            ++edge.sides;
            edge.sidesWithUv += topology.faceHasUv[sides[j].face];
        }
        for (const auto &[side, size] : joinAgreeing({sides.data() + i, sides.data() + j}, uv, tolerance,
                                                     faces, corners, topology.faceHasUv)) {
            ++edge.copies;
            topology.uvEdges.push_back({{side->cornerLow, side->cornerHigh}, 0, size == 1});
            edgeFace.push_back(side->face);
        }
        topology.weldedEdges.push_back(edge);
        i = j;
    }

    ChartMap &charts = topology.charts;
    charts.faceChart.assign(mesh.faceCount(), -1);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (!topology.faceHasUv[f])
            continue;
        const int root = faces.find(f);
        charts.faceChart[f] = root == f ? charts.count++ : charts.faceChart[root];
    }
    for (std::size_t e = 0; e < edgeFace.size(); ++e)
        topology.uvEdges[e].chart = charts.faceChart[edgeFace[e]];
    topology.cornerRoot.resize(mesh.cornerCount());
    for (int c = 0; c < mesh.cornerCount(); ++c)
        topology.cornerRoot[c] = corners.find(c);
    return topology;
}

ChartMap findCharts(const MeshData &mesh, const UvMatrix &uv)
{
    return findUvTopology(mesh, uv).charts;
}

} // namespace autocuts
