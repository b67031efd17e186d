#include "solver/bake/bentedges.h"

#include "model/plain/unionfind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::bake {

namespace {

const float flatCosine = std::cos(std::numbers::pi_v<float> / 180);

struct Edge
{
    std::array<Vec3f, 2> ends;
    Eigen::AlignedBox3f box;
};

Vec3f cornerOf(const MeshData &mesh, const Frame &frame, int triangle, int k)
{
    return frame.toFrame(mesh.cornerPosition(mesh.triangles[triangle][k % 3]));
}

} // namespace

std::vector<std::vector<std::array<Vec3f, 2>>> bentEdgesNear(const MeshData &mesh, const Frame &frame,
                                                             float reach)
{
    const int count = mesh.triangleCount();
    std::vector<Vec3f> normals(count);
    for (int t = 0; t < count; ++t) {
        const Vec3f a = cornerOf(mesh, frame, t, 0);
        normals[t] =
            (cornerOf(mesh, frame, t, 1) - a).cross(cornerOf(mesh, frame, t, 2) - a).stableNormalized();
    }
    UnionFind flat(count);
    const auto isBent = [&](const EdgePair &pair) {
        return !(normals[pair.triangle[0]].dot(normals[pair.triangle[1]]) >= flatCosine);
    };
    for (const EdgePair &pair : mesh.edgePairs) {
        if (!isBent(pair))
            flat.unite(pair.triangle[0], pair.triangle[1]);
    }
    std::vector<std::vector<Edge>> edges(count); // of a flat part, by its root
    const auto add = [&](int triangle, int side) {
        Edge edge{{cornerOf(mesh, frame, triangle, side), cornerOf(mesh, frame, triangle, side + 1)}, {}};
        edge.box.extend(edge.ends[0]).extend(edge.ends[1]);
        edges[flat.find(triangle)].push_back(edge);
    };
    for (const EdgePair &pair : mesh.edgePairs) {
        for (int which = 0; isBent(pair) && which < 2; ++which)
            add(pair.triangle[which], pair.side(which));
    }
    for (const BoundarySide &side : mesh.boundarySides)
        add(side.triangle, side.side);
    // Along one axis, only edges that begin before the triangle ends can be near.
    float longest = 0;
    for (std::vector<Edge> &part : edges) {
        for (const Edge &edge : part)
            longest = std::max(longest, edge.box.sizes().x());
        std::sort(part.begin(), part.end(),
                  [](const Edge &a, const Edge &b) { return a.box.min().x() < b.box.min().x(); });
    }
    std::vector<std::vector<std::array<Vec3f, 2>>> result(count);
    for (int t = 0; t < count; ++t) {
        Eigen::AlignedBox3f box;
        for (int k = 0; k < 3; ++k)
            box.extend(cornerOf(mesh, frame, t, k));
        const std::vector<Edge> &part = edges[flat.find(t)];
        auto edge = std::lower_bound(part.begin(), part.end(), box.min().x() - reach - longest,
                                     [](const Edge &a, float x) { return a.box.min().x() < x; });
        for (; edge != part.end() && edge->box.min().x() <= box.max().x() + reach; ++edge) {
            if (box.exteriorDistance(edge->box) <= reach)
                result[t].push_back(edge->ends);
        }
    }
    return result;
}

} // namespace autocuts::bake
