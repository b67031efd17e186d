#include "views/control/figures/islandfigures.h"

#include "commands/islandtransform.h"
#include "solver/metrics/uvmetrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

constexpr double shownDensity = 5e-4; //!< what fields for a density round off, in texels per unit

//! Sums over the triangles of one island.
struct IslandSums
{
    double area3d = 0, target = 0, areaUv = 0; //!< target: see MeshData::targetArea()

    double density(int textureSize) const
    {
        return target > 0 ? textureSize * std::sqrt(areaUv / target)
                          : std::numeric_limits<double>::quiet_NaN();
    }
};

std::vector<IslandSums> sumsOf(const Document &document)
{
    const MeshData &mesh = *document.weightedMesh();
    const Islands &islands = document.islands();
    std::vector<IslandSums> sums(islands.count());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int island = islands.islandOfFace(mesh.triangleFace[t]);
        if (island < 0)
            continue;
        const auto uv = [&](int k) { return Vec2(document.uv().row(mesh.triangles[t][k])); };
        IslandSums &sum = sums[island];
        sum.area3d += mesh.triangleArea[t];
        sum.target += mesh.targetArea(t);
        sum.areaUv += std::abs(cross2(uv(0), uv(1), uv(2))) / 2;
    }
    return sums;
}

} // namespace

std::vector<IslandFigures> islandFigures(const Document &document, const std::vector<double> &distortion)
{
    const std::vector<IslandSums> sums = sumsOf(document);
    double area = 0;
    for (const IslandSums &sum : sums)
        area += sum.area3d;
    std::vector<IslandFigures> figures(sums.size());
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const std::vector<int> &faces = document.islands().faces(int(i));
        figures[i].faces = static_cast<int>(faces.size());
        figures[i].areaShare = area > 0 ? sums[i].area3d / area : 0;
        figures[i].texelDensity = sums[i].density(document.packingSettings().textureSize);
        figures[i].shownDensity =
            document.weightedMesh()->texelWeight.empty() || !(sums[i].area3d > 0)
                ? std::numeric_limits<double>::quiet_NaN()
                : document.packingSettings().textureSize * std::sqrt(sums[i].areaUv / sums[i].area3d);
        figures[i].distortion =
            i < distortion.size() ? distortion[i] : std::numeric_limits<double>::quiet_NaN();
        figures[i].flags = document.marks().flagsOf(faces);
        figures[i].tags = document.marks().tagsOf(faces);
    }
    return figures;
}

std::vector<double> islandDistortions(const Document &document)
{
    return metrics::measureShapes(*document.weightedMesh(), document.uv(),
                                  document.packingSettings().tileHeight())
        .chartSymDirichlet;
}

double medianTexelDensity(const std::vector<IslandFigures> &figures)
{
    std::vector<std::pair<double, double>> densities; // and their areas
    double area = 0;
    for (const IslandFigures &island : figures) {
        if (!std::isfinite(island.texelDensity))
            continue;
        densities.emplace_back(island.texelDensity, island.areaShare);
        area += island.areaShare;
    }
    std::sort(densities.begin(), densities.end());
    double below = 0;
    for (const auto &[density, share] : densities) {
        below += share;
        if (below >= area / 2)
            return density;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double meanTexelDensity(const Document &document, const std::vector<int> &islands)
{
    double sum = 0, area = 0;
    const std::vector<IslandFigures> figures = islandFigures(document, {});
    for (int island : islands) {
        if (std::isfinite(figures[island].texelDensity)) {
            sum += figures[island].areaShare * figures[island].texelDensity;
            area += figures[island].areaShare;
        }
    }
    return area > 0 ? sum / area : std::numeric_limits<double>::quiet_NaN();
}

std::unique_ptr<SetUvs> setTexelDensity(Document &document, const std::vector<int> &islands, double density)
{
    const std::vector<IslandSums> sums = sumsOf(document);
    const int textureSize = document.packingSettings().textureSize;
    std::vector<int> scaled;
    for (int island : islands) {
        const double present = sums[island].density(textureSize);
        if (present > 0 && !(std::abs(present - density) < shownDensity))
            scaled.push_back(island);
    }
    const IslandTransform transform(document, UvEdit::Scale, scaled);
    return transform.command([&](int island) {
        const Vec2 centre = document.islands().box(island).center();
        Eigen::Affine2d result = Eigen::Affine2d::Identity();
        result.linear() *= density / sums[island].density(textureSize);
        result.translation() = centre - result.linear() * centre;
        return result;
    });
}

} // namespace autocuts
