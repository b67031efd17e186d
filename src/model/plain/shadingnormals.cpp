#include "model/plain/shadingnormals.h"

#include "model/plain/edgeangles.h"
#include "model/plain/unionfind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace autocuts {

namespace {

//! The 3D view of the studio and the shading of most other programs use angles of 30 to 40 degrees.
const double creaseCosine = std::cos(40 * 3.14159265358979 / 180);

//! A polygon side on a 3D edge. \c pair is an edge pair, or -1 for a side without a partner.
struct EdgeSide
{
    int object, low, high, pair;

    auto edge() const { return std::tie(object, low, high); }
};

//! The edge pairs on edges with more than two sides.
std::vector<bool> nonManifoldPairs(const MeshData &mesh)
{
    std::vector<bool> result(mesh.edgePairs.size(), false);
    if (mesh.report.nonManifoldEdges == 0)
        return result;
    std::vector<EdgeSide> sides;
    const auto add = [&](int soupCorner, int nextCorner, int pair) {
        const int a = mesh.vertexOfSoup(soupCorner), b = mesh.vertexOfSoup(nextCorner);
        sides.push_back(
            {mesh.faceObject[mesh.triangleFace[soupCorner / 3]], std::min(a, b), std::max(a, b), pair});
    };
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (!pair.diagonal)
            add(pair.corner[0][0], pair.corner[1][0], static_cast<int>(e));
    }
    for (const BoundarySide &side : mesh.boundarySides)
        add(3 * side.triangle + side.side, 3 * side.triangle + (side.side + 1) % 3, -1);
    std::sort(sides.begin(), sides.end(),
              [](const EdgeSide &a, const EdgeSide &b) { return a.edge() < b.edge(); });
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last =
            std::find_if(first, sides.end(), [&](const EdgeSide &s) { return s.edge() != first->edge(); });
        if (last - first > 1) { // a pair has two sides itself
            for (auto side = first; side != last; ++side) {
                if (side->pair >= 0)
                    result[side->pair] = true;
            }
        }
        first = last;
    }
    return result;
}

//! The corners that share a normal: for each corner, the first one of its group.
std::vector<int> smoothGroups(const MeshData &mesh, const std::vector<Vec3> &faceNormals,
                              const std::vector<bool> &hardEdges)
{
    const std::vector<bool> nonManifold = nonManifoldPairs(mesh);
    UnionFind sets(mesh.cornerCount());
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (!pair.diagonal) {
            const Vec3 &a = faceNormals[mesh.triangleFace[pair.triangle[0]]];
            const Vec3 &b = faceNormals[mesh.triangleFace[pair.triangle[1]]];
            if (nonManifold[e] || (hardEdges.empty() ? a.dot(b) < creaseCosine : hardEdges[e]))
                continue;
        }
        for (const auto &end : pair.corner)
            sets.unite(mesh.cornerOfSoup(end[0]), mesh.cornerOfSoup(end[1]));
    }
    std::vector<int> groups(mesh.cornerCount());
    for (int c = 0; c < mesh.cornerCount(); ++c)
        groups[c] = sets.find(c);
    return groups;
}

//! The angle of each polygon at each of its corners, at most pi.
std::vector<double> cornerAngles(const MeshData &mesh)
{
    std::vector<double> angles(mesh.cornerCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f], end = mesh.faceStart[f + 1];
        for (int c = start; c < end; ++c) {
            const Vec3 p = mesh.cornerPosition(c);
            const Vec3 next = mesh.cornerPosition(c + 1 < end ? c + 1 : start) - p;
            const Vec3 previous = mesh.cornerPosition(c > start ? c - 1 : end - 1) - p;
            angles[c] =
                std::acos(std::clamp(next.stableNormalized().dot(previous.stableNormalized()), -1.0, 1.0));
        }
    }
    return angles;
}

} // namespace

std::vector<Eigen::Vector3f> shadingNormals(const MeshData &mesh, const std::vector<bool> &hardEdges)
{
    const std::vector<Vec3> normals = faceNormals(mesh);
    const std::vector<int> groups = smoothGroups(mesh, normals, hardEdges);
    const std::vector<double> angles = cornerAngles(mesh);
    std::vector<Vec3> groupSum(mesh.cornerCount(), Vec3::Zero());
    std::vector<Vec3> vertexSum(mesh.vertexCount(), Vec3::Zero());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            const Vec3 weighted = angles[c] * normals[f];
            groupSum[groups[c]] += weighted;
            vertexSum[mesh.vertexWeld[mesh.cornerVertex[c]]] += weighted;
        }
    }
    std::vector<Eigen::Vector3f> result(mesh.cornerCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            Vec3 normal = Vec3::UnitZ();
            for (const Vec3 &sum :
                 {groupSum[groups[c]], vertexSum[mesh.vertexWeld[mesh.cornerVertex[c]]], normals[f]}) {
                if (sum.norm() > 1e-6) { // shorter ones are what rounding left of a sum that cancels out
                    normal = sum.normalized();
                    break;
                }
            }
            result[c] = normal.cast<float>();
        }
    }
    return result;
}

} // namespace autocuts
