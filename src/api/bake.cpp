// Bakes surfaces into pictures.
#include "api/failure.h"
#include "api/jobinput.h"
#include "api/meshinput.h"
#include "model/plain/shadingnormals.h"
#include "model/plain/udimtiles.h"
#include "model/transfer/surfacedistance.h"
#include "solver/bake/bakejob.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace autocuts;
using namespace autocuts::api;

namespace {

static_assert(int(bake::MapKind::Height) == AUTOCUTS_BAKE_HEIGHT &&
              int(bake::MapKind::Color) == AUTOCUTS_BAKE_COLOR &&
              int(bake::CageDirection::Corrected) == AUTOCUTS_CAGE_CORRECTED);

bool isMap(int map)
{
    return map >= AUTOCUTS_BAKE_NORMAL && map <= AUTOCUTS_BAKE_HEIGHT;
}

autocuts_bake_options optionsOf(const autocuts_bake_options *options)
{
    autocuts_bake_options own;
    autocuts_bake_options_init(&own);
    if (options)
        std::memcpy(&own, options, std::min(options->size, sizeof own));
    const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
    if (!within(own.width, 1, PackingSettings::maxTextureSize) ||
        !within(own.height, 1, PackingSettings::maxTextureSize))
        throw badInput("the size of the pictures is out of range", "Use 1 to 65536 texels");
    if (!within(own.samples, 1, 8) || !within(own.rays, 1, 65536) || own.dilation < 0 || own.threads < 1)
        throw badInput("the samples, rays, dilation or threads of the bake are out of range");
    if (!within(own.tile, PackingSettings::firstTile, PackingSettings::lastTile))
        throw badInput("there is no such UDIM tile", "Use 1001 to 9999");
    if (!within(own.cage_direction, AUTOCUTS_CAGE_SMOOTH, AUTOCUTS_CAGE_CORRECTED))
        throw badInput("there is no such direction of the cage");
    if (!std::isfinite(own.cage) || !(own.ray_reach >= 0) || !(own.curvature_radius > 0) ||
        !(own.thickness_limit > 0))
        throw badInput("a distance of the bake is not a number that can be used");
    return own;
}

//! \param tileHeight 0: the surface is baked from, its map is of no matter
ShadedSurface surfaceOf(const autocuts_mesh &mesh, double tileHeight)
{
    ShadedSurface surface;
    surface.mesh = meshOf(mesh);
    surface.normals = shadingNormals(*surface.mesh, hardEdgesOf(mesh, *surface.mesh));
    if (mesh.face_materials)
        surface.faceMaterial.assign(mesh.face_materials, mesh.face_materials + mesh.face_count);
    if (mesh.colors) {
        CornerColors colors;
        for (int c = 0; c < surface.mesh->cornerCount(); ++c)
            colors.push_back(
                CornerColor::fromLinear(mesh.colors[3 * c], mesh.colors[3 * c + 1], mesh.colors[3 * c + 2]));
        surface.cornerColors = sharedColors(std::move(colors), std::size_t(surface.mesh->cornerCount()));
    }
    if (tileHeight > 0) {
        surface.tileHeight = tileHeight;
        surface.uv.resize(surface.mesh->cornerCount(), 2);
        for (Eigen::Index c = 0; c < surface.uv.rows(); ++c)
            surface.uv.row(c) << mesh.uvs[2 * c], mesh.uvs[2 * c + 1] * tileHeight;
        surface.tangents = mikkTangents(*surface.mesh, surface.uv, surface.normals);
    }
    return surface;
}

bake::BakeJob jobOf(const autocuts_mesh &mesh, const autocuts_mesh *high,
                    const autocuts_bake_options &options, const JobContext &context)
{
    bake::BakeJob job;
    job.settings.grid.width = options.width;
    job.settings.grid.height = options.height;
    job.settings.grid.perSide = options.samples;
    job.settings.rays = {options.rays, options.ray_reach, options.curvature_radius, options.thickness_limit};
    job.settings.cage.direction = static_cast<bake::CageDirection>(options.cage_direction);
    job.tiles = {options.tile};
    job.margin = options.dilation;
    job.greenDown = options.directx != 0;
    job.floats = options.floats != 0;
    job.low = surfaceOf(mesh, static_cast<double>(options.height) / options.width);
    if (!high)
        return job;
    job.kind = bake::SourceKind::Detailed;
    job.high = surfaceOf(*high, 0);
    if (options.cage >= 0)
        job.settings.cage.distance = options.cage;
    else
        job.settings.cage.distance =
            transfer::proposedCage(*job.low.mesh, *job.high->mesh, context.stopFlag())
                .value_or(bake::CageSettings().distance);
    if (options.cage_positions)
        job.settings.cage.positions = Eigen::Map<const PositionMatrix>(
            options.cage_positions, static_cast<Eigen::Index>(mesh.vertex_count), 3);
    return job;
}

} // namespace

void autocuts_bake_options_init(autocuts_bake_options *options)
{
    const PackingSettings packing;
    const bake::RaySettings rays;
    *options = {};
    options->size = sizeof *options;
    options->width = packing.textureSize;
    options->height = packing.height();
    options->tile = PackingSettings::firstTile;
    options->samples = 2;
    options->rays = rays.rays;
    options->cage = bake::CageSettings().distance;
    options->ray_reach = rays.reach;
    options->curvature_radius = rays.curvatureRadius;
    options->thickness_limit = rays.thicknessLimit;
    options->dilation = bake::BakeJob().margin;
    options->threads = 1;
}

int autocuts_bake_channels(int map)
{
    if (!isMap(map))
        return 0;
    return bake::channelsOf({}, {static_cast<bake::MapKind>(map), 0});
}

autocuts_status autocuts_bake(const autocuts_mesh *mesh, const autocuts_mesh *high,
                              const autocuts_bake_options *options, const int *maps, size_t map_count,
                              float *const *pictures, autocuts_baked *baked, autocuts_error *error)
{
    return guarded(error, [&] {
        if (!mesh || !mesh->uvs)
            throw badInput("there is no mesh with UVs");
        if (map_count > 0 && (!maps || !pictures))
            throw badInput("there are no maps, or there is no place for their pictures");
        const autocuts_bake_options own = optionsOf(options);
        std::atomic<bool> stop = false;
        const JobContext context(&stop, own.threads, sinkOf(own.progress, own.user, stop));
        bake::BakeJob job = jobOf(*mesh, high, own, context);
        for (std::size_t i = 0; i < map_count; ++i) {
            if (!isMap(maps[i]) || !pictures[i])
                throw badInput("map " + std::to_string(i) + " is none that can be baked, or has no picture");
            job.settings.maps.push_back({static_cast<bake::MapKind>(maps[i]), 0});
        }
        const auto sink = [&](std::size_t map, int, const Picture &picture) {
            std::ranges::copy(picture.values, pictures[map]);
            return true;
        };
        const bake::BakeFigures figures = bake::runBake(job, sink, context);
        if (figures.stopped)
            throw Failure{AUTOCUTS_STOPPED, "stopped before the pictures were baked"};
        if (baked)
            *baked = {figures.texels, figures.missed};
    });
}
