#include "views/gl/texeldensity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

std::vector<float> texelDensities(const MeshData &mesh, const UvMatrix &uv, int textureSize)
{
    std::vector<float> densities(mesh.triangleCount(), std::numeric_limits<float>::quiet_NaN());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const auto at = [&](int k) { return Vec2(uv.row(3 * t + k)); };
        const double area = std::abs(cross2(at(0), at(1), at(2))) / 2;
        if (mesh.triangleArea[t] > 0 && !mesh.triangleDegenerate[t] && std::isfinite(area))
            densities[t] = static_cast<float>(textureSize * std::sqrt(area / mesh.targetArea(t)));
    }
    return densities;
}

double medianDensity(const MeshData &mesh, std::span<const float> densities)
{
    std::vector<int> order;
    double area = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (!std::isfinite(densities[t]))
            continue;
        order.push_back(t);
        area += mesh.triangleArea[t];
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) { return densities[a] < densities[b]; });
    double below = 0;
    for (int t : order) {
        below += mesh.triangleArea[t];
        if (below >= area / 2)
            return densities[t];
    }
    return std::numeric_limits<double>::quiet_NaN();
}

} // namespace autocuts
