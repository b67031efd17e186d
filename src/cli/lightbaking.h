// What the command line says about a light bake.
#pragma once

#include "solver/bake/lightbake.h"

#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace autocuts {

//! The options of the command that bakes light. Colours are linear.
struct LightBaking
{
    using Color = bake::Vec3f;
    //! A rectangle, and the point at which it shines.
    struct Area
    {
        Vec3 centre, target;
        Vec2 size;
        Color radiance;
    };

    bake::LightBakeSettings settings; //!< without the size
    std::optional<Vec2> sun;          //!< azimuth and elevation, degrees
    double sunStrength = 3;           //!< irradiance
    double sunAngle = 0.53;           //!< diameter, degrees
    Color sunColor = Color::Ones();
    std::optional<std::vector<Color>> sky; //!< one to three: zenith, horizon, ground; none: dark
    bool day = false;                      //!< a clear sky instead
    double skyStrength = 1, turbidity = 3;
    std::vector<Area> areas;
    std::vector<std::pair<QString, Color>> emission; //!< radiance of materials
    std::optional<Color> albedo;                     //!< of all faces
    QString albedoFile, albedoUvSet;
    bool zUp = false;
    std::optional<int> bits; //!< of the numbers in the file

    //! A white sky where no light is named.
    bake::Lighting lighting() const;
};

} // namespace autocuts
