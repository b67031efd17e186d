// Maps of small meshes, for tests of edits without a solve.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/snapshot.h"
#include "model/plain/uvlayout.h"
#include "support/meshbuilders.h"

namespace autocuts::test {

//! A snapshot of a map that is in the document.
inline Snapshot snapshotOf(const MeshPtr &mesh, const UvMatrix &uv)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    return snapshot;
}

//! The mesh seen from above, scaled and moved.
inline UvMatrix flatMap(const MeshData &mesh, double scale, const Vec2 &move)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = (scale * mesh.cornerPosition(c).head<2>() + move).transpose();
    return uv;
}

//! The edge pairs, no diagonals, whose ends are accepted. \param accept called with the two ends in 3D
template <typename Accept>
std::vector<int> edgesWhere(const MeshData &mesh, Accept accept)
{
    std::vector<int> edges;
    for (int e = 0; e < static_cast<int>(mesh.edgePairs.size()); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const auto end = [&](int i) -> Vec3 {
            return mesh.positions.row(mesh.vertexOfSoup(pair.corner[i][0]));
        };
        if (!pair.diagonal && accept(end(0), end(1)))
            edges.push_back(e);
    }
    return edges;
}

//! Triangles without area or turned against their area before; such triangles of the map before do not count.
inline int flippedIn(const MeshData &mesh, const UvMatrix &before, const UvMatrix &after)
{
    const auto area = [](const UvMatrix &uv, const std::array<int, 3> &t) {
        return cross2(uv.row(t[0]).transpose(), uv.row(t[1]).transpose(), uv.row(t[2]).transpose());
    };
    int count = 0;
    for (const auto &t : mesh.triangles)
        count += area(before, t) != 0 && !(area(before, t) * area(after, t) > 0);
    return count;
}

} // namespace autocuts::test
