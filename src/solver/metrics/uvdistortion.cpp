#include "solver/metrics/uvdistortion.h"

#include <algorithm>
#include <cmath>

namespace autocuts::metrics {

namespace {

//! The linear map from a 3D triangle to its UV triangle, reduced to what the figures need.
struct TriangleMap
{
    double frobenius = 0; //!< squared Frobenius norm, a^2 + b^2 with singular values a and b
    double inverse = 0;   //!< the same of the inverse map, a^-2 + b^-2
    double aspect = 0;    //!< larger / smaller singular value
};

//! \param texelWeight by which the sides of the 3D triangle are multiplied
TriangleMap triangleMap(const MeshData &mesh, const UvMatrix &uv, const std::array<int, 3> &corners,
                        double area3d, double uvArea, double texelWeight)
{
    // A coordinate frame on the longest side keeps the height of slivers accurate.
    int longest = 0;
    double length = -1;
    for (int k = 0; k < 3; ++k) {
        const double l = (mesh.cornerPosition(corners[(k + 1) % 3]) - mesh.cornerPosition(corners[k])).norm();
        if (l > length) {
            length = l;
            longest = k;
        }
    }
    const int origin = corners[longest];
    const int along = corners[(longest + 1) % 3];
    const int apex = corners[(longest + 2) % 3];
    const Vec3 base = mesh.cornerPosition(along) - mesh.cornerPosition(origin);
    const double foot = base.dot(mesh.cornerPosition(apex) - mesh.cornerPosition(origin)) / length;
    const double height = 2 * area3d / length;
    const Vec2 x = (uv.row(along) - uv.row(origin)).transpose() / length;
    const Vec2 y = ((uv.row(apex) - uv.row(origin)).transpose() - foot * x) / height;

    TriangleMap map;
    const double determinant = uvArea / area3d;
    map.frobenius = x.squaredNorm() + y.squaredNorm();
    map.inverse = map.frobenius / (determinant * determinant);
    const double larger = 0.5 * (std::sqrt(map.frobenius + 2 * determinant) +
                                 std::sqrt(std::max(0.0, map.frobenius - 2 * determinant)));
    map.aspect = larger * larger / determinant;
    map.frobenius /= texelWeight * texelWeight;
    map.inverse *= texelWeight * texelWeight;
    return map;
}

//! Sums over triangles, weighted by area.
struct DistortionSums
{
    double forward = 0, backward = 0, area = 0;

    void add(const TriangleMap &map, double area3d)
    {
        forward += area3d * map.frobenius;
        backward += area3d * map.inverse;
        area += area3d;
    }
    void add(const DistortionSums &other)
    {
        forward += other.forward;
        backward += other.backward;
        area += other.area;
    }
    //! The mean symmetric Dirichlet energy at the scale that minimises it.
    double least() const { return area > 0 ? 2 * std::sqrt(forward * backward) / area : missingFigure; }
};

//! The mean of the energies of groups of charts, each at the scale that minimises it.
double leastOfGroups(const std::vector<DistortionSums> &charts, const DensityGroups &groups)
{
    std::vector<DistortionSums> sums(groups.density.size());
    for (std::size_t chart = 0; chart < charts.size(); ++chart) {
        if (const int group = groups.ofChart[chart]; group >= 0)
            sums[group].add(charts[chart]);
    }
    double energy = 0, area = 0;
    for (const DistortionSums &sum : sums) {
        if (sum.area > 0) {
            energy += sum.area * sum.least();
            area += sum.area;
        }
    }
    return area > 0 ? energy / area : missingFigure;
}

//! Total areas of the triangles that have both UVs and area in 3D.
struct Totals
{
    double area3d = 0, target = 0, uvArea = 0; //!< target: see UvTriangles::targetArea()
};

Totals validTotals(const UvTriangles &triangles)
{
    Totals totals;
    for (int t = 0; t < triangles.count(); ++t) {
        if (!triangles.hasUv(t) || triangles.zeroArea[t])
            continue;
        totals.area3d += triangles.area3d[t];
        totals.target += triangles.targetArea(t);
        totals.uvArea += std::abs(triangles.signedArea[t]);
    }
    return totals;
}

void countFlips(const UvTriangles &triangles, UvMetrics &metrics)
{
    double flippedArea = 0;
    metrics.triangleFlipped.assign(triangles.count(), false);
    for (int t = 0; t < triangles.count(); ++t) {
        if (!triangles.hasUv(t))
            continue;
        const bool degenerate = triangles.uvDegenerate(t);
        metrics.uvDegenerate += degenerate && !triangles.zeroArea[t];
        const bool mirrored = triangles.charts[triangles.chart[t]].signedArea < 0;
        if (degenerate || (triangles.signedArea[t] < 0) == mirrored)
            continue;
        ++metrics.flipped;
        metrics.triangleFlipped[t] = true;
        flippedArea += std::abs(triangles.signedArea[t]);
    }
    metrics.flippedUvAreaRatio = triangles.totalUvArea > 0 ? flippedArea / triangles.totalUvArea : 0;
}

//! The 99th percentile (nearest rank): the value at rank ceil(0.99 n).
double nearestRank99(std::vector<double> values)
{
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(values.size())));
    const auto place =
        std::clamp<std::ptrdiff_t>(rank - 1, 0, static_cast<std::ptrdiff_t>(values.size()) - 1);
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[place];
}

} // namespace

void measureDistortion(const MeshData &mesh, const UvMatrix &uv, const UvTriangles &triangles,
                       const DensityGroups &groups, UvMetrics &metrics)
{
    countFlips(triangles, metrics);
    const Totals totals = validTotals(triangles);
    const int count = triangles.count();
    metrics.triangleSymDirichlet.assign(count, missingFigure);
    metrics.triangleAreaStretch.assign(count, missingFigure);

    std::vector<TriangleMap> maps;
    std::vector<int> used;
    std::vector<DistortionSums> charts(triangles.charts.size());
    DistortionSums all;
    double uvArea = 0, target = 0, aspect = 0, areaRatio = 0, infiniteArea = 0;
    for (int t = 0; t < count; ++t) {
        if (!triangles.hasUv(t) || triangles.zeroArea[t])
            continue;
        const double area3d = triangles.area3d[t];
        const double absolute = std::abs(triangles.signedArea[t]);
        const double ratio = (absolute / totals.uvArea) / (triangles.targetArea(t) / totals.target);
        const TriangleMap map =
            triangleMap(mesh, uv, triangles.corners[t], area3d, absolute, triangles.texelWeight[t]);
        metrics.triangleAreaStretch[t] = std::log(ratio);
        if (!(ratio >= 1e-12) || !std::isfinite(map.frobenius) || !std::isfinite(map.inverse) ||
            !std::isfinite(map.aspect)) {
            ++metrics.symDirichletInfinite;
            infiniteArea += area3d;
            metrics.triangleSymDirichlet[t] = std::numeric_limits<double>::infinity();
            continue;
        }
        maps.push_back(map);
        used.push_back(t);
        all.add(map, area3d);
        charts[triangles.chart[t]].add(map, area3d);
        uvArea += absolute;
        target += triangles.targetArea(t);
        aspect += area3d * map.aspect;
        areaRatio += area3d * std::max(ratio, 1 / ratio);
    }
    metrics.symDirichletInfiniteAreaRatio = totals.area3d > 0 ? infiniteArea / totals.area3d : 0;
    for (const DistortionSums &chart : charts)
        metrics.chartSymDirichlet.push_back(chart.least());
    metrics.tileDirichlet = leastOfGroups(charts, groups);
    if (!(all.area > 0))
        return;

    // Scaled by s, the mean f s^2 + b / s^2 is least where s^2 = sqrt(b / f).
    const double squaredScale = std::sqrt(all.backward / all.forward);
    metrics.symDirichletScale = std::sqrt(squaredScale);
    metrics.symDirichlet = all.least();
    std::vector<double> values(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        values[i] = maps[i].frobenius * squaredScale + maps[i].inverse / squaredScale;
        metrics.triangleSymDirichlet[used[i]] = values[i];
    }
    metrics.symDirichletMax = *std::max_element(values.begin(), values.end());
    metrics.symDirichletP99 = nearestRank99(std::move(values));
    metrics.l2Stretch = std::sqrt(all.backward / 2 / all.area) * std::sqrt(uvArea / target);
    metrics.angleDistortion = aspect / all.area;
    metrics.areaDistortion = areaRatio / all.area;
}

} // namespace autocuts::metrics
