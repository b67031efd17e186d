// What can be asked of a map, and the defaults of the options.
#include "api/failure.h"
#include "api/mapoutput.h"
#include "model/plain/udimtiles.h"
#include "solver/bake/texels.h"
#include "solver/metrics/uvmetrics.h"

#include <cmath>

using namespace autocuts;
using namespace autocuts::api;

namespace {

using Color = std::array<std::uint8_t, 4>;

//! A colour for each island, far from that of its neighbours in number.
Color colorOf(std::int32_t island)
{
    constexpr double golden = 0.6180339887498949;
    const double hue = 6 * std::fmod(golden * island, 1.0);
    const auto channel = [&](double offset) {
        const double x = std::fmod(hue + offset, 6.0);
        const double share = std::clamp(std::min(x, 4 - x), 0.0, 1.0);
        return static_cast<std::uint8_t>(std::lround(255 * (0.45 + 0.4 * share)));
    };
    return {channel(2), channel(0), channel(4), 255};
}

//! True when another island, or none, is beside the texel.
bool isAtBorder(const std::vector<std::int32_t> &islands, int width, int x, int y)
{
    const std::int32_t own = islands[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    for (const auto &[dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)}) {
        const int column = x + dx, row = y + dy;
        if (column < 0 || row < 0 || column >= width || row * width >= int(islands.size()) ||
            islands[std::size_t(row) * std::size_t(width) + std::size_t(column)] != own)
            return true;
    }
    return false;
}

void draw(const autocuts_map &map, int tile, int width, int height, std::uint8_t *rgba)
{
    bake::TexelGrid grid;
    grid.width = width;
    grid.height = height;
    grid.tile = udimTile(tile, map.tileHeight);
    const bake::TexelSurface surface(*map.mesh, map.uv, grid);
    std::vector<std::int32_t> islands(std::size_t(width) * std::size_t(height), -1);
    std::vector<bool> overlapped(islands.size(), false);
    bake::TexelRows rows;
    for (int band = 0; band < surface.bandCount(); ++band) {
        surface.makeBand(band, rows);
        const std::size_t first = std::size_t(rows.first) * std::size_t(width);
        for (std::size_t i = 0; i < rows.inside.size(); ++i) {
            if (rows.inside[i])
                islands[first + i] =
                    map.islands[std::size_t(map.mesh->triangleFace[rows.points[i].triangle])];
            overlapped[first + i] = rows.overlapped[i];
        }
    }
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            Color color{};
            if (islands[i] >= 0)
                color = overlapped[i] ? Color{220, 40, 40, 255} : colorOf(islands[i]);
            if (islands[i] >= 0 && isAtBorder(islands, width, x, y)) {
                for (std::size_t k = 0; k < 3; ++k)
                    color[k] /= 2;
            }
            std::ranges::copy(color, rgba + 4 * i);
        }
    }
}

} // namespace

const char *autocuts_version(void)
{
    return AUTOCUTS_VERSION;
}

void autocuts_options_init(autocuts_options *options)
{
    const SolveSettings settings;
    const PackingSettings packing;
    const unwrap::UnwrapOptions unwrap;
    *options = {};
    options->size = sizeof *options;
    options->quality = static_cast<int>(unwrap.quality);
    options->max_distortion = unwrap.maxDistortion;
    options->seams_from = AUTOCUTS_SEAMS_FROM_EDGES | AUTOCUTS_SEAMS_FROM_UVS;
    options->sharp_angle = settings.givenSeams.sharpAngle;
    options->surface = static_cast<int>(settings.surface);
    options->flat_rigid = settings.flat == FlatMode::Rigid;
    options->alike = static_cast<int>(settings.alike);
    options->creases = static_cast<int>(settings.creases);
    options->crease_strength = settings.creaseStrength;
    options->visibility = settings.visibility;
    options->symmetry = AUTOCUTS_SYMMETRY_AUTO;
    options->align = static_cast<int>(settings.align);
    options->world_up = static_cast<int>(settings.worldUp);
    options->texture_width = packing.textureSize;
    options->texture_height = packing.height();
    options->margin = packing.margin;
    options->tile_border = packing.border;
    options->rotation = AUTOCUTS_ROTATION_FREE;
    options->pack_time = packing.effort;
    options->threads = 1;
}

void autocuts_map_free(autocuts_map *map)
{
    delete map;
}

size_t autocuts_map_corner_count(const autocuts_map *map)
{
    return map->given.size() / 2;
}

size_t autocuts_map_face_count(const autocuts_map *map)
{
    return map->islands.size();
}

size_t autocuts_map_island_count(const autocuts_map *map)
{
    return map->islandCount;
}

const double *autocuts_map_uvs(const autocuts_map *map)
{
    return map->given.data();
}

const int32_t *autocuts_map_islands(const autocuts_map *map)
{
    return map->islands.data();
}

const uint8_t *autocuts_map_seams(const autocuts_map *map)
{
    return map->seams.data();
}

autocuts_outcome autocuts_map_outcome(const autocuts_map *map)
{
    return map->outcome;
}

autocuts_status autocuts_measure(const autocuts_map *map, autocuts_figures *figures, autocuts_error *error)
{
    return guarded(error, [&] {
        if (!map || !figures)
            throw badInput("there is no map, or no place for its figures");
        metrics::UvMetricsOptions options;
        options.textureSize = map->textureSize;
        options.tileHeight = map->tileHeight;
        const metrics::UvMetrics measured = metrics::measureUv(*map->mesh, map->uv, options);
        *figures = {measured.symDirichlet, measured.seamNorm, measured.packingUnit, measured.minGutterTexels,
                    measured.charts,       measured.flipped,  measured.overlapPairs};
    });
}

autocuts_status autocuts_draw(const autocuts_map *map, int tile, int width, int height, uint8_t *rgba,
                              autocuts_error *error)
{
    return guarded(error, [&] {
        if (!map || !rgba)
            throw badInput("there is no map, or no place for its picture");
        if (width < 1 || height < 1 || width > PackingSettings::maxTextureSize ||
            height > PackingSettings::maxTextureSize)
            throw badInput("the size of the picture is out of range", "Use 1 to 65536 pixels");
        if (tile < PackingSettings::firstTile || tile > PackingSettings::lastTile)
            throw badInput("there is no such UDIM tile", "Use 1001 to 9999");
        draw(*map, tile, width, height, rgba);
    });
}
