#include "cli/lightbaking.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace autocuts {

namespace {

//! \param angles azimuth clockwise from north, and elevation, in degrees. North is y where z is up, else -z.
bake::Vec3f directionOf(const Vec2 &angles, bool zUp)
{
    const Vec2 radians = angles * std::numbers::pi / 180;
    const double east = std::cos(radians.y()) * std::sin(radians.x());
    const double north = std::cos(radians.y()) * std::cos(radians.x()), up = std::sin(radians.y());
    return (zUp ? Vec3(east, north, up) : Vec3(east, up, -north)).cast<float>();
}

bake::AreaLight areaLight(const LightBaking::Area &area, const Vec3 &up)
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

bake::Lighting LightBaking::lighting() const
{
    const bake::Vec3f up = zUp ? bake::Vec3f::UnitZ() : bake::Vec3f::UnitY();
    bake::Lighting lighting;
    if (sun) {
        lighting.suns.push_back({directionOf(*sun, zUp), static_cast<float>(sunStrength) * sunColor,
                                 static_cast<float>(sunAngle * std::numbers::pi / 180)});
    }
    for (const Area &area : areas)
        lighting.areas.push_back(areaLight(area, up.cast<double>()));
    const auto strength = static_cast<float>(skyStrength);
    const std::vector<Color> white{Color::Ones()};
    const bool isStandard = !sky && !day && !sun && areas.empty() && emission.empty();
    const std::vector<Color> colors = sky ? *sky : isStandard ? white : std::vector<Color>();
    if (day) {
        const bake::Vec3f towards = directionOf(sun.value_or(Vec2(0, 45)), zUp);
        lighting.sky = bake::Sky{up, Color::Zero(), Color::Zero(), Color::Zero(), {}};
        lighting.sky->day.emplace(towards, up, static_cast<float>(turbidity), strength);
    } else if (!colors.empty()) {
        const Color zenith = strength * colors.front();
        const Color horizon = colors.size() > 1 ? Color(strength * colors[1]) : zenith;
        lighting.sky =
            bake::Sky{up, zenith, horizon, colors.size() > 2 ? Color(strength * colors[2]) : horizon, {}};
    }
    return lighting;
}

} // namespace autocuts
