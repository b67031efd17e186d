#include "model/layouts/mapreport.h"

#include "model/document/scenegroups.h"
#include "model/layouts/meshdoctor.h"
#include "model/plain/groupfigures.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

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
    r.symDirichletTiles = m.tileDirichlet;
    r.inTiles = m.inTiles;
    for (const auto &[chart, tile] : m.chartsOffTile)
        r.offTile.push_back({chart + 1, tile});
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

std::vector<MapReport::Part> partsOf(const Scene &scene, SceneKind kind, const metrics::UvMetrics &figures,
                                     const PackingSettings &packing)
{
    const std::vector<SceneGroup> groups = sceneGroups(scene, kind);
    const std::vector<int> groupOf = groupOfFaces(groups, scene.mesh->faceCount());
    const std::vector<metrics::GroupFigures> measured = metrics::groupFigures(
        *scene.mesh, findCharts(*scene.mesh, scene.uvSets.front().uv), scene.uvSets.front().uv, groupOf,
        static_cast<int>(groups.size()), figures.chartSymDirichlet);
    std::vector<MapReport::Part> parts;
    for (std::size_t g = 0; g < groups.size(); ++g)
        parts.push_back({groups[g].name, measured[g].faces, measured[g].charts, measured[g].symDirichlet,
                         measured[g].density * packing.textureSize,
                         measured[g].uvArea / packing.tileHeight()});
    return parts;
}

} // namespace

MapReport mapReport(const Scene &scene, const metrics::UvMetrics *figures, const PackingSettings &packing)
{
    MapReport report;
    if (figures) {
        report = reportOf(*figures);
        report.facesWithoutUvArea = facesWithoutUvArea(*scene.mesh, *figures);
        for (const metrics::TileFigures &tile : figures->tiles)
            report.tiles.push_back(
                {tile.tile, tile.faces, tile.charts, tile.density * packing.textureSize, tile.efficiency});
        report.objects = partsOf(scene, SceneKind::Objects, *figures, packing);
        report.materials = partsOf(scene, SceneKind::Materials, *figures, packing);
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

} // namespace autocuts
