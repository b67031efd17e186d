#include "model/transfer/sourcesurface.h"

#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts::transfer {

Frame frameOf(const MeshData &mesh)
{
    Eigen::AlignedBox3d box;
    for (int v : mesh.cornerVertex)
        box.extend(Vec3(mesh.positions.row(v)));
    Frame frame;
    if (box.isEmpty())
        return frame;
    frame.origin = 0.5 * box.min() + 0.5 * box.max();
    if (const double size = box.diagonal().stableNorm(); size > 0)
        frame.size = size;
    return frame;
}

bool hasUvs(const MeshData &mesh, const UvMatrix &uv, int triangle)
{
    const auto &corners = mesh.triangles[triangle];
    return uv.row(corners[0]).allFinite() && uv.row(corners[1]).allFinite() && uv.row(corners[2]).allFinite();
}

SourceSurface::SourceSurface(const MeshData &mesh, const UvMatrix &uv, const Frame &frame)
{
    std::vector<Triangle3> triangles;
    std::vector<int> numberOf(mesh.triangles.size(), -1);
    Eigen::AlignedBox2d box;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (!hasUvs(mesh, uv, t))
            continue;
        numberOf[t] = triangleCount();
        Triangle3 triangle;
        std::array<Vec2, 3> own;
        for (int k = 0; k < 3; ++k) {
            triangle[k] = frame.toFrame(mesh.cornerPosition(mesh.triangles[t][k]));
            own[k] = uv.row(mesh.triangles[t][k]);
            box.extend(own[k]);
        }
        triangles.push_back(triangle);
        mUv.push_back(own);
    }
    mUvSize = box.isEmpty() ? 0 : box.diagonal().stableNorm();
    mTree = SurfaceTree(std::move(triangles));
    join(mesh, numberOf);
    measure();
}

void SourceSurface::join(const MeshData &mesh, const std::vector<int> &numberOf)
{
    mNeighbours.assign(mUv.size(), {-1, -1, -1});
    const double distance = uvTolerance * mUvSize;
    for (const EdgePair &pair : mesh.edgePairs) {
        const std::array<int, 2> number{numberOf[pair.triangle[0]], numberOf[pair.triangle[1]]};
        if (number[0] < 0 || number[1] < 0)
            continue;
        bool joined = true;
        for (const auto &corners : pair.corner) {
            const Vec2 gap = mUv[number[0]][corners[0] % 3] - mUv[number[1]][corners[1] % 3];
            joined = joined && gap.stableNorm() <= distance;
        }
        if (!joined)
            continue;
        mNeighbours[number[0]][pair.side(0)] = number[1];
        mNeighbours[number[1]][pair.side(1)] = number[0];
    }
}

void SourceSurface::measure()
{
    for (int t = 0; t < triangleCount(); ++t) {
        const Triangle3 &p = mTree.triangle(t);
        const Vec3 along = p[1] - p[0], other = p[2] - p[0];
        const double length = along.norm();
        const double height = along.cross(other).norm() / length;
        Eigen::Matrix2d map = Eigen::Matrix2d::Zero();
        if (length > 0 && height > 1e-7 * length) {
            const double foot = along.dot(other) / length;
            map.col(0) = (mUv[t][1] - mUv[t][0]) / length;
            map.col(1) = (mUv[t][2] - mUv[t][0] - foot * map.col(0)) / height;
        }
        const double half = 0.5 * map.squaredNorm(), determinant = map.determinant();
        mStretch.push_back(
            std::sqrt(half + std::sqrt(std::max(0.0, half * half - determinant * determinant))));
        mAreaRatio.push_back(determinant);
    }
}

double SourceSurface::energy(int triangle) const
{
    const double ratio = mStretch[triangle] * mStretch[triangle] / std::abs(mAreaRatio[triangle]);
    return ratio > 0 && ratio < 5e5 ? 2 * (ratio + 1 / ratio) : 1e6;
}

Vec2 SourceSurface::uvAt(const NearPoint &near) const
{
    const std::array<Vec2, 3> &uv = mUv[near.triangle];
    return near.weights[0] * uv[0] + near.weights[1] * uv[1] + near.weights[2] * uv[2];
}

Vec2 SourceSurface::continuedUv(int triangle, const Vec3 &point) const
{
    NearPoint near;
    if (const auto weights = weightsInPlane(mTree.triangle(triangle), point))
        near.weights = *weights;
    else
        near = nearestOnTriangle(mTree.triangle(triangle), point);
    near.triangle = triangle;
    return uvAt(near);
}

} // namespace autocuts::transfer
