#include "views/control/figures/mapfigures.h"

#include "model/io/meshes/instances.h"
#include "model/plain/udimtiles.h"
#include "solver/metrics/uvoverlaps.h"
#include "views/control/session/jobrunner.h"

#include <algorithm>
#include <string_view>

namespace autocuts {

namespace {

//! The search for overlapping pairs stops at this number. Chosen by hand.
constexpr int maxListedOverlaps = 100'000;

//! The tiles in use whose islands have one material; empty where there is one tile only.
std::map<int, int> materialsOfTiles(const Scene &scene, const MeshData &mesh, const UvMatrix &uv,
                                    double tileHeight)
{
    std::map<int, int> materials;
    const std::vector<int> tiles = udimTiles(mesh, uv, tileHeight);
    if (usedTiles(tiles).size() < 2)
        return materials;
    constexpr int several = -2;
    for (std::size_t face = 0; face < tiles.size(); ++face) {
        const int material = face < scene.faceMaterial.size() ? scene.faceMaterial[face] : -1;
        const auto [found, isNew] = materials.try_emplace(tiles[face], material);
        if (!isNew && found->second != material)
            found->second = several;
    }
    std::erase_if(materials, [](const auto &tile) { return tile.first == 0 || tile.second < 0; });
    return materials;
}

MapFigures measured(const MeshData &mesh, const UvMatrix &uv, const std::vector<IslandFlags> &faceFlags,
                    const PackingSettings &packing, JobControl &control)
{
    MapFigures figures;
    figures.textureSize = packing.textureSize;
    figures.textureHeight = packing.height();
    metrics::UvMetricsOptions options;
    options.textureSize = packing.textureSize;
    options.tileHeight = packing.tileHeight();
    options.faceFlags = faceFlags;
    options.job = &control.stop();
    figures.metrics = metrics::measureUv(mesh, uv, options);
    if (figures.metrics.overlapPairs == 0)
        return figures;
    metrics::UvOverlapOptions overlapOptions;
    overlapOptions.faceFlags = faceFlags;
    overlapOptions.maxPairs = maxListedOverlaps;
    overlapOptions.job = &control.stop();
    overlap::OverlapList overlaps = metrics::findUvOverlaps(mesh, uv, overlapOptions);
    figures.overlapping = metrics::overlappingTriangles(overlaps);
    std::stable_sort(
        overlaps.pairs.begin(), overlaps.pairs.end(),
        [](const overlap::OverlapPair &a, const overlap::OverlapPair &b) { return a.area > b.area; });
    for (const overlap::OverlapPair &pair : overlaps.pairs)
        figures.overlapPairs.push_back({pair.first, pair.second});
    return figures;
}

//! Adds the figures of the document's islands. \param file the measured map \param uv that of the document
void ofDocument(MapFigures &figures, const MeshData &mesh, const UvMatrix &file, const UvMatrix &uv,
                const PackingSettings &packing, JobControl &control)
{
    const auto bits = [](const UvMatrix &map) {
        return std::string_view(reinterpret_cast<const char *>(map.data()),
                                static_cast<std::size_t>(map.size()) * sizeof(double));
    };
    const auto take = [&figures](const metrics::UvMetrics &own) {
        figures.islandDistortion = own.chartSymDirichlet;
        figures.islandsOffTile = own.chartsOffTile;
    };
    if (bits(file) == bits(uv)) {
        take(figures.metrics);
        return;
    }
    metrics::UvMetricsOptions options;
    options.textureSize = packing.textureSize;
    options.tileHeight = packing.tileHeight();
    options.overlaps = options.gutter = false;
    options.job = &control.stop();
    take(metrics::measureUv(mesh, uv, options));
}

} // namespace

MapFigures measuredMap(const MeasuredModel &model, JobControl &control)
{
    const PackingSettings &packing = model.packing;
    const MeshData &mesh = *model.mesh;
    const UvMatrix &uv = model.scene.uvSets.front().uv;
    const Scene file = asWritten(model.scene, model.scene.format, packing.tileHeight());
    const UvMatrix &map = file.uvSets.front().uv;
    MapFigures figures = measured(mesh, map, withInstanceStacks(file, model.faceFlags), packing, control);
    ofDocument(figures, mesh, map, uv, packing, control);
    figures.tileMaterial = materialsOfTiles(model.scene, mesh, map, packing.tileHeight());
    return figures;
}

} // namespace autocuts
