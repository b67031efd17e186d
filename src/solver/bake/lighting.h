// The lights of a light bake: suns, a sky and area lights.
#pragma once

#include "solver/bake/rayscene.h"

#include <optional>
#include <vector>

namespace autocuts::bake {

// Colours are linear RGB. Radiance is light per area and solid angle; a white surface in a sky of radiance 1
// has radiance 1 itself.

//! Light from so far away that its rays are parallel, but for the angle that it fills.
struct Sun
{
    Vec3f towards = Vec3f::UnitY();   //!< unit, from the model to the sun
    Vec3f irradiance = Vec3f::Ones(); //!< of a surface that faces the sun
    float angle = 0.0093F;            //!< diameter as seen from the model, radians
};

//! A clear sky (Preetham, Shirley, Smits 1999, "A Practical Analytic Model for Daylight"), without its sun.
class Daylight
{
public:
    //! \param towards the sun, unit; a sun below the horizon counts as one on it \param turbidity from 2,
    //! clear, to 10, hazy \param luminance of the zenith
    Daylight(const Vec3f &towards, const Vec3f &up, float turbidity, float luminance);

    //! \param direction unit, above the horizon
    Vec3f radiance(const Vec3f &direction) const;

private:
    //! Luminance Y and chromaticities x and y.
    struct Channel
    {
        std::array<double, 5> shape{};
        double zenith = 0;

        double at(double cosine, double sunAngle) const;
    };

    Vec3f mTowards, mUp;
    std::array<Channel, 3> mChannels;
    std::array<double, 3> mScale{};
};

//! Light from all around: one colour, a gradient, or that of a day.
struct Sky
{
    Vec3f up = Vec3f::UnitY();
    Vec3f zenith = Vec3f::Ones(), horizon = Vec3f::Ones();
    Vec3f ground = Vec3f::Ones(); //!< from below the horizon
    std::optional<Daylight> day;  //!< instead of zenith and horizon

    Vec3f radiance(const Vec3f &direction) const;
};

//! A rectangle that shines to one side, along right x up. It is not seen itself and hides nothing.
struct AreaLight
{
    Vec3 centre = Vec3::Zero();                                 //!< in units of the model
    Vec3 right = 0.5 * Vec3::UnitX(), up = 0.5 * Vec3::UnitY(); //!< from the centre to the sides
    Vec3f radiance = Vec3f::Ones();
};

//! All lights besides faces that shine.
struct Lighting
{
    std::vector<Sun> suns;
    std::optional<Sky> sky;
    std::vector<AreaLight> areas;
};

} // namespace autocuts::bake
