// The lights of a light bake in the terms of its user. Plain: no Qt.
#pragma once

#include "model/plain/shadedsurface.h"

#include <optional>
#include <vector>

namespace autocuts {

//! Suns, skies and lamps. Colours are linear RGB.
struct LightPlan
{
    //! A rectangle, and the point at which it shines.
    struct Area
    {
        Vec3 centre = Vec3::Zero(), target = Vec3::Zero(); //!< in units of the model
        Vec2 size = Vec2::Ones();
        Vec3f radiance = Vec3f::Ones();

        bool operator==(const Area &) const = default;
    };

    std::optional<Vec2> sun; //!< azimuth clockwise from north and elevation, degrees; see zUp
    bool sunHidden = false;  //!< it only gives a clear day its place
    double sunStrength = 3;  //!< irradiance
    double sunAngle = 0.53;  //!< diameter, degrees
    Vec3f sunColor = Vec3f::Ones();
    //! One to three colours: zenith, horizon, ground; none: dark. Not set: white where there is no other
    //! light, else dark.
    std::optional<std::vector<Vec3f>> sky;
    bool day = false; //!< a clear sky instead, with the sun's place
    double skyStrength = 1, turbidity = 3;
    std::vector<Area> areas;
    bool zUp = false; //!< north is y, else -z

    bool operator==(const LightPlan &) const = default;
};

} // namespace autocuts
