#include "cli/mapreporting.h"

#include "model/document/scenegroups.h"
#include "model/io/meshdoctor.h"
#include "model/io/savefile.h"
#include "model/io/uvexport.h"
#include "model/plain/udimtiles.h"
#include "solver/metrics/groupfigures.h"
#include "solver/metrics/uvoverlaps.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! In texels. Islands closer than this bleed into each other when the texture is filtered.
constexpr double fewestGutterTexels = 1;

MapReport reportOf(const metrics::UvMetrics &m)
{
    MapReport r;
    r.triangles = m.triangles;
    r.charts = m.charts;
    r.seamLength = m.seamLength;
    r.seamNorm = m.seamNorm;
    r.symDirichlet = m.symDirichlet;
    r.symDirichletMax = m.symDirichletMax;
    r.flipped = m.flipped;
    if (m.overlapPairs >= 0) {
        r.overlapPairs = m.overlapPairs;
        r.overlappingTriangles = m.overlappingTriangles;
        r.stackedPairs = m.stackedPairs;
    }
    r.overlapAreaRatio = m.overlapAreaRatio;
    r.packingEfficiency = m.packingUnit;
    r.minGutterTexels = m.minGutterTexels;
    r.faces = m.faces;
    r.seamEdges = m.seamEdges;
    r.symDirichletInfinite = m.symDirichletInfinite;
    r.uvDegenerate = m.uvDegenerate;
    r.mirroredCharts = m.mirroredCharts;
    r.nonDiskCharts = m.nonDiskCharts;
    r.facesWithoutUv = m.facesWithoutUv;
    r.zeroAreaTriangles = m.zeroAreaTriangles;
    r.symDirichletP99 = m.symDirichletP99;
    r.symDirichletScale = m.symDirichletScale;
    r.l2Stretch = m.l2Stretch;
    r.angleDistortion = m.angleDistortion;
    r.areaDistortion = m.areaDistortion;
    r.texelDensitySpread = m.texelDensitySpread;
    r.axisAlignedShare = m.axisAlignedShare;
    r.packingBox = m.packingBox;
    r.minGutter = m.minGutter;
    r.borderGutterTexels = m.borderGutterTexels;
    r.inUnitSquare = m.inUnitSquare;
    return r;
}

qint64 facesWithoutUvArea(const MeshData &mesh, const metrics::UvMetrics &m)
{
    std::vector<bool> collapsed(mesh.faceCount(), false);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (std::isinf(m.triangleSymDirichlet[t]))
            collapsed[mesh.triangleFace[t]] = true;
    }
    return std::count(collapsed.begin(), collapsed.end(), true);
}

QString counted(qint64 count, const char *one, const char *many)
{
    return QStringLiteral("%1 %2").arg(count).arg(QLatin1String(count == 1 ? one : many));
}

QString shortNumber(double value)
{
    return std::isfinite(value) ? QString::number(value, 'g', 7) : QStringLiteral("-");
}

QString shortCount(const MapReport::Count &value)
{
    return value ? QString::number(*value) : QStringLiteral("-");
}

std::vector<MapReport::Part> partsOf(const Scene &scene, SceneKind kind, const metrics::UvMetrics &figures,
                                     const PackingSettings &packing)
{
    const std::vector<SceneGroup> groups = sceneGroups(scene, kind);
    const std::vector<int> groupOf = groupOfFaces(groups, scene.mesh->faceCount());
    const std::vector<metrics::GroupFigures> measured =
        metrics::groupFigures(*scene.mesh, scene.uvSets.front().uv, groupOf, static_cast<int>(groups.size()),
                              figures.chartSymDirichlet);
    std::vector<MapReport::Part> parts;
    for (std::size_t g = 0; g < groups.size(); ++g)
        parts.push_back({groups[g].name, measured[g].faces, measured[g].charts, measured[g].symDirichlet,
                         measured[g].density * packing.textureSize,
                         measured[g].uvArea / packing.tileHeight()});
    return parts;
}

} // namespace

MapReport reportOn(const Scene &scene, const std::vector<IslandFlags> &faceFlags,
                   const PackingSettings &packing)
{
    MapReport report;
    if (scene.hasUv()) {
        metrics::UvMetricsOptions options;
        options.textureSize = packing.textureSize;
        options.tileHeight = packing.tileHeight();
        options.faceFlags = faceFlags;
        const metrics::UvMetrics figures = measureUv(*scene.mesh, scene.uvSets.front().uv, options);
        report = reportOf(figures);
        report.facesWithoutUvArea = facesWithoutUvArea(*scene.mesh, figures);
        report.objects = partsOf(scene, SceneKind::Objects, figures, packing);
        report.materials = partsOf(scene, SceneKind::Materials, figures, packing);
    } else {
        report.triangles = scene.mesh->triangleCount();
        report.faces = scene.mesh->faceCount();
        report.facesWithoutUv = scene.mesh->faceCount();
    }
    if (!scene.uvSets.empty())
        report.uvSet = scene.uvSets.front().name;
    const std::vector<double> &weights = scene.mesh->texelWeight;
    report.texelDensityWeights =
        std::count_if(weights.begin(), weights.end(), [](double weight) { return weight != 1; });
    report.textureSize = packing.textureSize;
    report.textureHeight = packing.height();
    report.mesh = scene.mesh->report;
    report.notes = meshDoctorNotes(scene.mesh->report);
    for (const QString &note : scene.notes)
        report.notes << note;
    return report;
}

QStringList mapProblems(const MapReport &report)
{
    QStringList problems;
    const qint64 bare = report.facesWithoutUv.value_or(0);
    if (bare > 0 && bare == report.faces.value_or(0))
        return {QStringLiteral("the file has no UVs")};
    if (bare > 0)
        problems << counted(bare, "face has no UVs", "faces have no UVs");
    if (const qint64 n = report.flipped.value_or(0))
        problems << counted(n, "triangle is flipped", "triangles are flipped");
    if (const qint64 n = report.symDirichletInfinite.value_or(0))
        problems << counted(n, "triangle has no area in the map", "triangles have no area in the map");
    const qint64 overlaps = report.overlappingTriangles.value_or(0);
    if (overlaps > 0)
        problems << counted(overlaps, "triangle overlaps", "triangles overlap");
    if (report.inUnitSquare && !*report.inUnitSquare)
        problems << QStringLiteral("the UVs leave the unit square");
    if (overlaps == 0 && report.minGutterTexels < fewestGutterTexels)
        problems << QStringLiteral("islands come as close as %1 texels at a texture size of %2")
                        .arg(report.minGutterTexels, 0, 'g', 3)
                        .arg(report.textureSize.value_or(0));
    return problems;
}

QStringList mapWarnings(const MapReport &report)
{
    const qint64 n = report.facesWithoutUvArea.value_or(0);
    if (n == 0)
        return {};
    return {
        counted(n, "face has", "faces have") +
        QStringLiteral(" no area in the map and would show a single texel. Parts that are very much smaller "
                       "than the rest need a file of their own, or a larger scale")};
}

QString reportTable(const MapReport &r)
{
    QString table;
    const auto line = [&table](const char *key, const QString &value, const QString &meaning) {
        table += QString::fromLatin1(key).leftJustified(20);
        table += meaning.isEmpty() ? value : value.leftJustified(14) + meaning;
        table += QLatin1Char('\n');
    };
    const QString texels =
        QStringLiteral("at %1 x %2 texels").arg(r.textureSize.value_or(0)).arg(r.textureHeight.value_or(0));
    line("triangles", shortCount(r.triangles), QStringLiteral("of %1 faces").arg(shortCount(r.faces)));
    if (!r.charts)
        return table; // without UVs there are no more figures
    line("charts", shortCount(r.charts), QStringLiteral("islands of the map"));
    line("seam_length", shortNumber(r.seamLength), QStringLiteral("in the units of the model"));
    line("seam_norm", shortNumber(r.seamNorm), QStringLiteral("the same for a model of area pi"));
    line("sym_dirichlet", shortNumber(r.symDirichlet), QStringLiteral("mean distortion, 4 is none"));
    line("sym_dirichlet_max", shortNumber(r.symDirichletMax), QStringLiteral("of the worst triangle"));
    if (const qint64 weighted = r.texelDensityWeights.value_or(0); weighted > 0)
        line("texel_density_weights", QString::number(weighted),
             QStringLiteral("faces: distortion is relative to them"));
    line("flipped", shortCount(r.flipped), QStringLiteral("triangles"));
    line("overlap_pairs", shortCount(r.overlapPairs), QStringLiteral("pairs of triangles"));
    if (const qint64 stacked = r.stackedPairs.value_or(0); stacked > 0)
        line("stacked_pairs", QString::number(stacked), QStringLiteral("of stacked islands, on purpose"));
    line("packing_efficiency", shortNumber(r.packingEfficiency),
         QStringLiteral("part of the unit square in use"));
    line("min_gutter_texels", shortNumber(r.minGutterTexels), texels);
    if (!r.status.isEmpty())
        line("status", r.status, {});
    return table;
}

std::vector<int> overlappingTriangles(const Scene &scene, const std::vector<IslandFlags> &faceFlags)
{
    metrics::UvOverlapOptions options;
    options.faceFlags = faceFlags;
    return metrics::overlappingTriangles(
        metrics::findUvOverlaps(*scene.mesh, scene.uvSets.front().uv, options));
}

Result<Done> writeLayout(const QString &path, const Scene &scene, const PackingSettings &packing,
                         const std::vector<int> &hatched, const std::vector<bool> &faces, int tile)
{
    const MeshData &mesh = *scene.mesh;
    UvMatrix uv = withoutOtherFaces(mesh, scene.uvSets.front().uv, faces);
    uv.rowwise() -= udimTile(tile, packing.tileHeight()).min().transpose();
    LayoutOptions options;
    options.size = std::clamp(std::max(packing.textureSize, packing.height()), 256, 4096);
    options.tileHeight = packing.tileHeight();
    options.overlapping = hatched;
    const bool svg = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
    const Result<QByteArray> bytes = svg ? layoutSvg(mesh, uv, options) : layoutPng(mesh, uv, options);
    if (!bytes)
        return bytes.error();
    return saveAtomically(path, bytes.value());
}

} // namespace autocuts
