#include "api/jobinput.h"

#include "api/failure.h"
#include "api/meshinput.h"
#include "solver/packing/packmap.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace autocuts::api {

namespace {

PackRotation rotationOf(int rotation)
{
    switch (rotation) {
    case AUTOCUTS_ROTATION_NONE:
        return PackRotation::None;
    case AUTOCUTS_ROTATION_FREE:
        return PackRotation::Free;
    case AUTOCUTS_ROTATION_15:
        return PackRotation::TwentyFourth;
    case AUTOCUTS_ROTATION_30:
        return PackRotation::Twelfth;
    case AUTOCUTS_ROTATION_45:
        return PackRotation::Eighth;
    case AUTOCUTS_ROTATION_90:
        return PackRotation::Quarter;
    case AUTOCUTS_ROTATION_180:
        return PackRotation::Half;
    default:
        throw badInput("there is no such rotation",
                       "Use none, free, or steps of 15, 30, 45, 90 or 180 degrees");
    }
}

//! The value of an enumeration whose numbers in the header are those of the engine.
template <class Enum>
Enum valueOf(int number, Enum last, const char *what)
{
    if (number < 0 || number > static_cast<int>(last))
        throw badInput(std::string("there is no such ") + what);
    return static_cast<Enum>(number);
}

double shareOf(double value, const char *what)
{
    if (!(value >= 0 && value <= 1))
        throw badInput(std::string(what) + " is not from 0 to 1");
    return value;
}

} // namespace

autocuts_options optionsOf(const autocuts_options *options)
{
    autocuts_options own;
    autocuts_options_init(&own);
    if (options)
        std::memcpy(&own, options, std::min(options->size, sizeof own));
    if (own.threads < 1)
        throw badInput("the number of threads is below 1");
    return own;
}

SymmetryMode symmetryOf(int choice)
{
    switch (choice) {
    case AUTOCUTS_SYMMETRY_OFF:
        return SymmetryMode::Off;
    case AUTOCUTS_SYMMETRY_ON:
        return SymmetryMode::On;
    case AUTOCUTS_SYMMETRY_AUTO:
        return SymmetryMode::Auto;
    default:
        throw badInput("the choice for symmetry is unknown");
    }
}

SolveSettings settingsOf(const autocuts_options &options)
{
    static_assert(int(SurfaceKind::HardSurface) == AUTOCUTS_SURFACE_HARD &&
                  int(AlikeMode::Stack) == AUTOCUTS_ALIKE_STACK && int(CreaseMode::On) == AUTOCUTS_ON &&
                  int(SeamMode::Only) == AUTOCUTS_SEAMS_ONLY && int(WorldUp::AutoZ) == AUTOCUTS_AXIS_AUTO_Z);
    SolveSettings settings;
    if (!(options.max_distortion > 4 && options.max_distortion <= SolveSettings::maxBound))
        throw badInput("the bound on the distortion is not above 4", "4.1 is usual");
    settings.maxDistortion = options.max_distortion;
    settings.surface = valueOf(options.surface, SurfaceKind::HardSurface, "kind of surface");
    settings.flat = options.flat_rigid != 0 ? FlatMode::Rigid : FlatMode::Free;
    settings.alike = valueOf(options.alike, AlikeMode::Stack, "choice for alike parts");
    settings.creases = valueOf(options.creases, CreaseMode::On, "choice for creases");
    settings.creaseStrength = shareOf(options.crease_strength, "the strength of creases");
    settings.visibility = shareOf(options.visibility, "the weight of visibility");
    settings.symmetry = symmetryOf(options.symmetry);
    settings.mirrorMaps = options.mirror != 0;
    settings.align = valueOf(options.align, CreaseMode::On, "choice for aligning");
    settings.worldUp = valueOf(options.world_up, WorldUp::AutoZ, "axis");
    settings.seams = valueOf(options.seams, SeamMode::Only, "choice of seams");
    if (!(options.sharp_angle >= 0 && options.sharp_angle <= 180))
        throw badInput("the angle of sharp edges is not from 0 to 180 degrees");
    const auto from = [&](autocuts_seam_source source) { return (options.seams_from & source) != 0; };
    settings.givenSeams = {from(AUTOCUTS_SEAMS_FROM_EDGES),     from(AUTOCUTS_SEAMS_FROM_UVS),
                           from(AUTOCUTS_SEAMS_FROM_SHARP),     from(AUTOCUTS_SEAMS_FROM_HARD),
                           from(AUTOCUTS_SEAMS_FROM_MATERIALS), options.sharp_angle};
    return settings;
}

PackingSettings packingOf(const autocuts_options &options)
{
    PackingSettings packing;
    if (options.texture_width < 1 || options.texture_height < 1 ||
        std::max(options.texture_width, options.texture_height) > PackingSettings::maxTextureSize)
        throw badInput("the size of the texture is out of range", "Use 1 to 65536 texels");
    packing.setTexture(options.texture_width, options.texture_height);
    if (!(options.margin >= 0) || !std::isfinite(options.margin) || !std::isfinite(options.tile_border))
        throw badInput("the margin is not a number that can be used", "Use 0 texels or more");
    packing.margin = options.margin;
    packing.border = options.tile_border;
    packing.rotation = rotationOf(options.rotation);
    packing.keepScale = options.keep_scale != 0;
    if (!(options.pack_time > 0 && options.pack_time <= PackingSettings::maxEffort))
        throw badInput("the time for packing is out of range", "Use up to 3600 seconds");
    packing.effort = options.pack_time;
    return packing;
}

JobContext::Sink sinkOf(autocuts_progress progress, void *user, std::atomic<bool> &stop)
{
    if (!progress)
        return {};
    return [progress, user, &stop](const JobProgress &now) {
        if (progress(now.fraction, user) != 0)
            stop = true;
    };
}

void fill(const autocuts_mesh *mesh, const autocuts_options *options, MapNeed need, Job &job)
{
    if (!mesh)
        throw badInput("there is no mesh");
    const autocuts_options own = optionsOf(options);
    job.options.quality = valueOf(own.quality, unwrap::UnwrapQuality::Best, "quality");
    job.snapshot.settings = settingsOf(own);
    job.options.maxDistortion = own.max_distortion;
    job.options.packing = packing::tileOptions(packingOf(own));
    job.snapshot.tileHeight = job.options.packing.tileHeight();
    if (!(own.density >= 0) || !std::isfinite(own.density))
        throw badInput("the density is not a number that can be used", "Use 0 or more texels per unit");
    job.density = own.density;
    if (own.better)
        job.better = [take = own.better, user = own.better_user](autocuts_map *map) { take(map, user); };
    if (need == MapNeed::Needed && !mesh->uvs)
        throw badInput("the mesh has no UVs");
    job.snapshot.mesh = meshOf(*mesh);
    if (!(job.snapshot.mesh->area > 0))
        throw badInput("all faces are without area, there is nothing to map",
                       "Check the scale and the vertices of the mesh");
    takeWishes(*mesh, job.snapshot);
    job.context = JobContext(&job.stop, own.threads, sinkOf(own.progress, own.user, job.stop));
}

} // namespace autocuts::api
