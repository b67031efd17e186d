#include "model/plain/snapshot.h"

#include "model/plain/uvlayout.h"

#include <cmath>
#include <numbers>

namespace autocuts {

UvMatrix startUvFromCorners(const MeshData &mesh, const UvMatrix &uv)
{
    UvMatrix soup = soupUv(mesh, uv);
    double area = 0, target = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const double twice = cross2(soup.row(3 * t), soup.row(3 * t + 1), soup.row(3 * t + 2));
        if (std::isfinite(twice))
            area += 0.5 * std::abs(twice);
        target += mesh.targetArea(t);
    }
    if (area > 0 && std::isfinite(area))
        soup *= std::sqrt(std::numbers::pi * (target / mesh.area) / area);
    return soup;
}

} // namespace autocuts
