#include "views/gl/stretch.h"

#include "model/plain/parallel.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts {

StretchMeter::StretchMeter(const MeshData &mesh) : mShapes(mesh.triangleCount())
{
    const MeshFrame frame = MeshFrame::of(mesh);
    parallelRanges(mesh.triangleCount(), [&](int first, int end) {
        for (int t = first; t < end; ++t) {
            if (!mesh.triangleDegenerate[t])
                mShapes[t] = shapeOf(mesh, frame, t);
        }
    });
}

StretchMeter::Shape StretchMeter::shapeOf(const MeshData &mesh, const MeshFrame &frame, int triangle)
{
    const double weight = mesh.texelWeightOf(triangle);
    std::array<Vec3, 3> p;
    for (int k = 0; k < 3; ++k)
        p[k] = weight * frame.toFrame(mesh.cornerPosition(mesh.triangles[triangle][k]));
    Shape shape;
    double longest = -1;
    for (int k = 0; k < 3; ++k) {
        const double length = (p[(k + 1) % 3] - p[k]).norm();
        if (length > longest) {
            longest = length;
            shape.first = k;
        }
    }
    // With the longest side as the base, the height of thin triangles is accurate.
    const Vec3 base = p[(shape.first + 1) % 3] - p[shape.first];
    const Vec3 side = p[(shape.first + 2) % 3] - p[shape.first];
    const double height = base.cross(side).norm() / longest;
    if (height > 0) {
        shape.inverseLength = 1 / longest;
        shape.foot = base.dot(side) / longest;
        shape.inverseHeight = 1 / height;
        shape.target = 0.5 * longest * height;
        shape.area = shape.target / (weight * weight);
    }
    return shape;
}

TriangleStretch StretchMeter::measure(const UvMatrix &uv) const
{
    const int count = static_cast<int>(mShapes.size());
    constexpr float missing = std::numeric_limits<float>::quiet_NaN();
    TriangleStretch result{std::vector<float>(count, missing), std::vector<float>(count, missing)};
    std::vector<std::array<double, 2>> energies(count); // squared norms of the Jacobian and of its inverse
    std::vector<double> ratios(count, -1);              // UV area / 3D area
    parallelRanges(count, [&](int first, int end) {
        for (int t = first; t < end; ++t) {
            const Shape &shape = mShapes[t];
            const auto origin = uv.row(3 * t + shape.first);
            const Vec2 along = uv.row(3 * t + (shape.first + 1) % 3) - origin;
            const Vec2 side = uv.row(3 * t + (shape.first + 2) % 3) - origin;
            const Vec2 x = along * shape.inverseLength;
            const Vec2 y = (side - shape.foot * x) * shape.inverseHeight;
            const double ratio = std::abs(x.x() * y.y() - x.y() * y.x());
            if (shape.inverseLength == 0 || !std::isfinite(ratio))
                continue;
            const double forward = x.squaredNorm() + y.squaredNorm();
            energies[t] = {forward, forward / (ratio * ratio)};
            ratios[t] = ratio;
        }
    });
    double area = 0, uvArea = 0;
    for (int t = 0; t < count; ++t) {
        if (ratios[t] < 0)
            continue;
        area += mShapes[t].target;
        uvArea += ratios[t] * mShapes[t].target;
    }
    if (!(uvArea > 0))
        return result;

    const double meanRatio = uvArea / area;
    double forward = 0, inverse = 0;
    for (int t = 0; t < count; ++t) {
        if (ratios[t] < 1e-12 * meanRatio)
            continue;
        forward += mShapes[t].area * energies[t][0];
        inverse += mShapes[t].area * energies[t][1];
    }
    // The mean f s^2 + b / s^2 has its minimum at s^2 = sqrt(b / f).
    const double squaredScale = std::sqrt(inverse / forward);
    result.scale = std::sqrt(squaredScale);
    parallelRanges(count, [&](int first, int end) {
        for (int t = first; t < end; ++t) {
            if (ratios[t] < 0)
                continue;
            result.areaLog2[t] = static_cast<float>(std::log2(ratios[t] / meanRatio));
            result.dirichlet[t] =
                static_cast<float>(energies[t][0] * squaredScale + energies[t][1] / squaredScale);
        }
    });
    return result;
}

} // namespace autocuts
