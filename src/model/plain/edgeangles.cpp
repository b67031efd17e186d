#include "model/plain/edgeangles.h"

#include "model/plain/polygon.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts {

std::vector<Vec3> faceNormals(const MeshData &mesh)
{
    std::vector<Vec3> normals(mesh.faceCount());
    std::vector<Vec3> points;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        points.clear();
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            points.push_back(mesh.cornerPosition(c) - mesh.cornerPosition(mesh.faceStart[f]));
        normals[f] = polygonNormal(points).stableNormalized();
    }
    return normals;
}

std::vector<double> edgeAngles(const MeshData &mesh)
{
    const std::vector<Vec3> normals = faceNormals(mesh);
    std::vector<double> angles;
    angles.reserve(mesh.edgePairs.size());
    for (const EdgePair &pair : mesh.edgePairs) {
        const Vec3 &a = normals[mesh.triangleFace[pair.triangle[0]]];
        const Vec3 &b = normals[mesh.triangleFace[pair.triangle[1]]];
        angles.push_back(pair.diagonal ? 0 : std::atan2(a.cross(b).norm(), a.dot(b)));
    }
    return angles;
}

} // namespace autocuts
