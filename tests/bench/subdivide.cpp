#include "bench/subdivide.h"

#include <algorithm>
#include <map>

namespace autocuts::bench {

test::MeshPtr subdivided(const MeshData &mesh)
{
    std::vector<Vec3> points;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        points.push_back(mesh.positions.row(v));
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
        if (isNew)
            points.push_back(0.5 * (points[a] + points[b]));
        return at->second;
    };
    std::vector<int> start{0}, corners, object;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        std::array<int, 3> v{}, m{};
        for (int k = 0; k < 3; ++k)
            v[k] = mesh.cornerVertex[mesh.triangles[t][k]];
        for (int k = 0; k < 3; ++k)
            m[k] = middle(v[k], v[(k + 1) % 3]);
        corners.insert(corners.end(),
                       {v[0], m[0], m[2], m[0], v[1], m[1], m[2], m[1], v[2], m[0], m[1], m[2]});
        for (int i = 0; i < 4; ++i) {
            start.push_back(start.back() + 3);
            object.push_back(mesh.faceObject[mesh.triangleFace[t]]);
        }
    }
    PositionMatrix positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        positions.row(static_cast<Eigen::Index>(v)) = points[v];
    return MeshData::build(std::move(positions), std::move(start), std::move(corners), std::move(object));
}

} // namespace autocuts::bench
