#include "cli/mapreporting.h"

#include "model/layouts/layoutfiles.h"
#include "model/layouts/mapreport.h"
#include "model/layouts/uvexport.h"
#include "model/plain/meshpart.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/metrics/uvoverlaps.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! In texels. Islands closer than this bleed into each other when the texture is filtered.
constexpr double fewestGutterTexels = 1;

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

//! The part of a scene, with its active UV set only.
Scene sceneOfPart(const Scene &scene, const MeshPart &part)
{
    Scene some = scene;
    some.mesh = part.mesh;
    some.hardEdges.clear();
    some.source.reset();
    some.faceMaterial.clear();
    for (std::size_t f = 0; !scene.faceMaterial.empty() && f < part.face.size(); ++f)
        some.faceMaterial.push_back(scene.faceMaterial[part.face[f]]);
    some.uvSets.resize(std::min<std::size_t>(some.uvSets.size(), 1));
    for (UvSet &set : some.uvSets) {
        UvMatrix uv(static_cast<Eigen::Index>(part.corner.size()), 2);
        for (std::size_t c = 0; c < part.corner.size(); ++c)
            uv.row(static_cast<Eigen::Index>(c)) = set.uv.row(part.corner[c]);
        set.uv = std::move(uv);
    }
    return some;
}

//! Names islands that reach over the border of their tile.
QString offTileText(const std::vector<MapReport::OffTile> &islands)
{
    constexpr std::size_t mostNamed = 8;
    QStringList names;
    for (std::size_t i = 0; i < std::min(mostNamed, islands.size()); ++i)
        names << QStringLiteral("%1 (of %2)").arg(islands[i].island).arg(islands[i].tile);
    if (islands.size() > mostNamed)
        names << QStringLiteral("...");
    return counted(static_cast<qint64>(islands.size()), "island does", "islands do") +
           QStringLiteral(" not lie in one UDIM tile as a whole: ") + names.join(QStringLiteral(", "));
}

} // namespace

MapReport reportOn(const Scene &scene, const std::vector<IslandFlags> &faceFlags,
                   const PackingSettings &packing, const std::vector<bool> &faces)
{
    if (std::find(faces.begin(), faces.end(), true) != faces.end()) {
        const MeshPart part = partOf(*scene.mesh, faces);
        std::vector<IslandFlags> flags;
        for (std::size_t f = 0; !faceFlags.empty() && f < part.face.size(); ++f)
            flags.push_back(faceFlags[part.face[f]]);
        return reportOn(sceneOfPart(scene, part), flags, packing);
    }
    if (!scene.hasUv())
        return mapReport(scene, nullptr, packing);
    metrics::UvMetricsOptions options;
    options.textureSize = packing.textureSize;
    options.tileHeight = packing.tileHeight();
    options.faceFlags = faceFlags;
    const metrics::UvMetrics figures = measureUv(*scene.mesh, scene.uvSets.front().uv, options);
    return mapReport(scene, &figures, packing);
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
    if (!report.offTile.empty())
        problems << offTileText(report.offTile);
    else if (report.inTiles == false)
        problems << QStringLiteral("the UVs leave the unit square, and do not lie in UDIM tiles");
    if (overlaps == 0 && report.minGutterTexels < fewestGutterTexels)
        problems << QStringLiteral("islands come as close as %1 texels at a texture size of %2")
                        .arg(report.minGutterTexels, 0, 'g', 3)
                        .arg(report.textureSize.value_or(0));
    return problems;
}

QStringList failures(const MapReport &report, const CliOptions::FailOn &failOn)
{
    QStringList found;
    const auto count = [&](bool asked, const MapReport::Count &value, const char *one, const char *many) {
        if (const qint64 n = value.value_or(0); asked && n > 0)
            found << counted(n, one, many);
    };
    count(failOn.overlaps, report.overlappingTriangles, "triangle overlaps", "triangles overlap");
    count(failOn.flips, report.flipped, "triangle is flipped", "triangles are flipped");
    count(failOn.missing, report.facesWithoutUv, "face has no UVs", "faces have no UVs");
    if (failOn.tiles && !report.offTile.empty())
        found << offTileText(report.offTile);
    else if (failOn.tiles && report.inTiles == false)
        found << QStringLiteral("the UVs do not lie in tiles");
    // Without a map there are no such figures, and it is not what was asked for.
    if (failOn.distortion && !(report.symDirichlet <= *failOn.distortion))
        found << QStringLiteral("the distortion is %1, above %2")
                     .arg(shortNumber(report.symDirichlet), shortNumber(*failOn.distortion));
    if (failOn.gutter && report.minGutterTexels < *failOn.gutter)
        found
            << QStringLiteral("islands come as close as %1 texels").arg(shortNumber(report.minGutterTexels));
    return found;
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
    if (std::abs(r.symDirichletTiles - r.symDirichlet) > 1e-6 * r.symDirichlet)
        line("sym_dirichlet_tiles", shortNumber(r.symDirichletTiles),
             QStringLiteral("the same with each tile and island at the density that it has"));
    line("sym_dirichlet_max", shortNumber(r.symDirichletMax), QStringLiteral("of the worst triangle"));
    if (const qint64 weighted = r.texelDensityWeights.value_or(0); weighted > 0)
        line("texel_density_weights", QString::number(weighted),
             QStringLiteral("faces: distortion is relative to them"));
    line("flipped", shortCount(r.flipped), QStringLiteral("triangles"));
    line("overlap_pairs", shortCount(r.overlapPairs), QStringLiteral("pairs of triangles"));
    if (const qint64 stacked = r.stackedPairs.value_or(0); stacked > 0)
        line("stacked_pairs", QString::number(stacked), QStringLiteral("of stacked islands, on purpose"));
    line("packing_efficiency", shortNumber(r.packingEfficiency),
         r.tiles.size() > 1 ? QStringLiteral("part of the %1 tiles in use").arg(r.tiles.size())
                            : QStringLiteral("part of the texture in use"));
    const bool onlyFirst = r.tiles.size() == 1 && r.tiles.front().number == PackingSettings::firstTile;
    for (std::size_t i = 0; !onlyFirst && i < r.tiles.size(); ++i) {
        const MapReport::Tile &tile = r.tiles[i];
        line(qPrintable(QStringLiteral("tile_%1").arg(tile.number)), shortNumber(tile.packingEfficiency),
             QStringLiteral("in use by %1, %2 px per unit")
                 .arg(counted(tile.charts, "island", "islands"), shortNumber(tile.texelDensity)));
    }
    line("min_gutter_texels", shortNumber(r.minGutterTexels), texels);
    if (!r.status.isEmpty())
        line("status", r.status, {});
    return table;
}

std::vector<int> overlappingTriangles(const Scene &scene, const std::vector<IslandFlags> &faceFlags,
                                      const StopSource *stop)
{
    metrics::UvOverlapOptions options;
    options.faceFlags = faceFlags;
    options.job = JobContext(stop ? &stop->stop : nullptr);
    return metrics::overlappingTriangles(*scene.mesh, scene.uvSets.front().uv, options);
}

Result<Done> writeLayout(const CliOptions &cli, const Scene &scene, const std::vector<int> &hatched,
                         const std::vector<bool> &faces, const StopSource *stop)
{
    const PackingSettings &packing = cli.unwrap.packing;
    const MeshData &mesh = *scene.mesh;
    const UvMatrix uv = withoutOtherFaces(mesh, scene.uvSets.front().uv, faces);
    LayoutOptions options;
    options.size = std::clamp(std::max(packing.textureSize, packing.height()), 256, 4096);
    options.tileHeight = packing.tileHeight();
    options.overlapping = hatched;
    const std::vector<LayoutPicture> pictures =
        layoutPictures(cli.layout, mesh, uv, packing.tileHeight(), packing.udimTile, cli.per.has_value());
    Result<Done> done = writeLayoutPictures(pictures, mesh, uv, options, stop ? &stop->stop : nullptr);
    const bool isOver = done.ok() || !stop || stop->reason != StopReason::TimeLimit;
    return isOver ? done : writeLayoutPictures(pictures, mesh, uv, options);
}

} // namespace autocuts
