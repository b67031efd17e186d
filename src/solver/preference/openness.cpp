#include "solver/preference/openness.h"

#include "model/plain/parallel.h"
#include "solver/preference/raytree.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace autocuts::preference {

namespace {

//! Rays per vertex. Chosen by hand.
constexpr int rayCount = 64;
constexpr double lift = 1e-4; // distance of a ray's start from the surface, as a share of the mesh's diagonal
constexpr int blockSize = 256;

//! Directions around +z, distributed proportionally to their cosine with +z.
std::vector<Vec3> halfSphere()
{
    std::vector<Vec3> directions;
    for (int i = 0; i < rayCount; ++i) {
        const double radius = std::sqrt((i + 0.5) / rayCount);
        const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
        directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                std::sqrt(1 - radius * radius));
    }
    return directions;
}

//! Area-weighted normals of the welded vertices; zero where a vertex has none.
std::vector<Vec3> vertexNormals(const MeshData &mesh)
{
    std::vector<Vec3> normals(mesh.vertexCount(), Vec3::Zero());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        std::array<Vec3, 3> p;
        for (int k = 0; k < 3; ++k)
            p[k] = mesh.cornerPosition(mesh.triangles[t][k]);
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        for (int k = 0; k < 3; ++k)
            normals[mesh.vertexOfSoup(3 * t + k)] += normal;
    }
    for (Vec3 &normal : normals)
        normal = normal.stableNormalized();
    return normals;
}

} // namespace

std::vector<double> vertexOpenness(const MeshData &mesh, int threads)
{
    const std::vector<Vec3> directions = halfSphere();
    const std::vector<Vec3> normals = vertexNormals(mesh);
    const RayTree tree(mesh);
    const double above = lift * tree.size();
    std::vector<double> openness(mesh.vertexCount(), 1);
    const auto measure = [&](int v) {
        const Vec3 &normal = normals[v];
        if (!(normal.squaredNorm() > 0.5))
            return;
        const Vec3 u = normal.unitOrthogonal(), w = normal.cross(u);
        const Vec3 from = Vec3(mesh.positions.row(v)) + above * normal;
        int free = 0;
        for (const Vec3 &d : directions)
            free += !tree.isHit(from, d.x() * u + d.y() * w + d.z() * normal);
        openness[v] = double(free) / rayCount;
    };
    const int blocks = (mesh.vertexCount() + blockSize - 1) / blockSize;
    parallelFor(blocks, threads, [&](int block) {
        const int end = std::min(mesh.vertexCount(), (block + 1) * blockSize);
        for (int v = block * blockSize; v < end; ++v) {
            if (mesh.vertexWeld[v] == v)
                measure(v);
        }
    });
    for (int v = 0; v < mesh.vertexCount(); ++v)
        openness[v] = openness[mesh.vertexWeld[v]];
    return openness;
}

std::vector<double> edgeOpenness(const MeshData &mesh, int threads)
{
    const std::vector<double> openness = vertexOpenness(mesh, threads);
    std::vector<double> result;
    result.reserve(mesh.edgePairs.size());
    for (const EdgePair &pair : mesh.edgePairs)
        result.push_back(0.5 * (openness[mesh.vertexOfSoup(pair.corner[0][0])] +
                                openness[mesh.vertexOfSoup(pair.corner[1][0])]));
    return result;
}

} // namespace autocuts::preference
