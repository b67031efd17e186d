#include "solver/bake/lightjob.h"

#include "model/plain/udimtiles.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace autocuts::bake {

namespace {

//! \param angles azimuth clockwise from north, and elevation, in degrees. North is y where z is up, else -z.
Vec3f directionOf(const Vec2 &angles, bool zUp)
{
    const Vec2 radians = angles * std::numbers::pi / 180;
    const double east = std::cos(radians.y()) * std::sin(radians.x());
    const double north = std::cos(radians.y()) * std::cos(radians.x()), up = std::sin(radians.y());
    return (zUp ? Vec3(east, north, up) : Vec3(east, up, -north)).cast<float>();
}

AreaLight areaLight(const LightPlan::Area &area, const Vec3 &up)
{
    const Vec3 shining = (area.target - area.centre).normalized();
    Vec3 right = shining.cross(up);
    if (right.norm() < 1e-6)
        right = shining.cross(Vec3(1, 0, 0));
    right.normalize();
    return {area.centre, 0.5 * area.size.x() * right, 0.5 * area.size.y() * shining.cross(right),
            area.radiance};
}

} // namespace

Lighting lightingOf(const LightPlan &plan, bool facesShine)
{
    const Vec3f up = plan.zUp ? Vec3f::UnitZ() : Vec3f::UnitY();
    Lighting lighting;
    if (plan.sun && !plan.sunHidden) {
        lighting.suns.push_back({directionOf(*plan.sun, plan.zUp),
                                 static_cast<float>(plan.sunStrength) * plan.sunColor,
                                 static_cast<float>(plan.sunAngle * std::numbers::pi / 180)});
    }
    for (const LightPlan::Area &area : plan.areas)
        lighting.areas.push_back(areaLight(area, up.cast<double>()));
    const auto strength = static_cast<float>(plan.skyStrength);
    const std::vector<Vec3f> white{Vec3f::Ones()};
    const bool isStandard = !plan.sky && !plan.day && !plan.sun && plan.areas.empty() && !facesShine;
    const std::vector<Vec3f> colors = plan.sky ? *plan.sky : isStandard ? white : std::vector<Vec3f>();
    if (plan.day) {
        const Vec3f towards = directionOf(plan.sun.value_or(Vec2(0, 45)), plan.zUp);
        lighting.sky = Sky{up, Vec3f::Zero(), Vec3f::Zero(), Vec3f::Zero(), {}};
        lighting.sky->day.emplace(towards, up, static_cast<float>(plan.turbidity), strength);
    } else if (!colors.empty()) {
        const Vec3f zenith = strength * colors.front();
        const Vec3f horizon = colors.size() > 1 ? Vec3f(strength * colors[1]) : zenith;
        lighting.sky =
            Sky{up, zenith, horizon, colors.size() > 2 ? Vec3f(strength * colors[2]) : horizon, {}};
    }
    return lighting;
}

LightJob lightJobOf(LitSurface surface, const LightPlan &plan, const LightBakeSettings &settings,
                    double tileHeight)
{
    LightJob job;
    job.lighting = lightingOf(plan, !surface.emission.empty());
    job.settings = settings;
    job.tileHeight = tileHeight;
    const std::vector<int> tiles =
        usedTiles(islandTiles(*surface.mesh, findCharts(*surface.mesh, surface.uv), surface.uv, tileHeight));
    if (!tiles.empty())
        job.tiles = tiles;
    job.surface = std::move(surface);
    return job;
}

LightFigures runLightBake(const LightJob &job, const LightSink &sink, const LightTilePreview &preview,
                          const JobContext &context)
{
    LightFigures figures;
    const double share = 1.0 / double(job.tiles.size());
    for (std::size_t i = 0; i < job.tiles.size() && !figures.stopped; ++i) {
        const int tile = job.tiles[i];
        LightBakeSettings settings = job.settings;
        settings.tile = udimTile(tile, job.tileHeight);
        LightPreview ofTile;
        if (preview)
            ofTile = [&preview, tile](const Picture &picture) { preview(tile, picture); };
        LightBakeResult baked = bakeLight(job.surface, job.lighting, settings,
                                          context.part(double(i) * share, double(i + 1) * share), ofTile);
        figures.stopped = baked.stopped;
        figures.texels += baked.texels;
        if (!baked.picture.isEmpty() && !sink(tile, baked))
            break;
    }
    return figures;
}

} // namespace autocuts::bake
