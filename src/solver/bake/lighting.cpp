#include "solver/bake/lighting.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::bake {

namespace {

//! Per channel Y, x, y and coefficient A to E: slope along the turbidity, and offset (table of the paper).
constexpr double shapes[3][5][2] = {
    {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}},
    {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}},
    {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}}};

//! For x and y of the zenith: rows for turbidity^2, turbidity and 1, columns for the cube of the sun's angle
//! from the zenith down to 1.
constexpr double zeniths[2][3][4] = {{{0.00166, -0.00375, 0.00209, 0},
                                      {-0.02903, 0.06377, -0.03202, 0.00394},
                                      {0.11693, -0.21196, 0.06052, 0.25886}},
                                     {{0.00275, -0.00610, 0.00317, 0},
                                      {-0.04214, 0.08970, -0.04153, 0.00516},
                                      {0.15346, -0.26756, 0.06670, 0.26688}}};

double zenithChromaticity(const double (&table)[3][4], double turbidity, double angle)
{
    const double powers[3] = {turbidity * turbidity, turbidity, 1};
    double sum = 0;
    for (int row = 0; row < 3; ++row) {
        const double *c = table[row];
        sum += powers[row] * (((c[0] * angle + c[1]) * angle + c[2]) * angle + c[3]);
    }
    return sum;
}

double angleBetween(double cosine)
{
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

} // namespace

double Daylight::Channel::at(double cosine, double sunAngle) const
{
    const double c = std::cos(sunAngle);
    return (1 + shape[0] * std::exp(shape[1] / std::max(cosine, 0.01))) *
           (1 + shape[2] * std::exp(shape[3] * sunAngle) + shape[4] * c * c);
}

Daylight::Daylight(const Vec3f &towards, const Vec3f &up, float turbidity, float luminance)
    : mTowards(towards), mUp(up)
{
    const double angle = std::min(angleBetween(towards.dot(up)), std::numbers::pi / 2);
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 5; ++k)
            mChannels[i].shape[k] = shapes[i][k][0] * double(turbidity) + shapes[i][k][1];
        mChannels[i].zenith =
            i == 0 ? double(luminance) : zenithChromaticity(zeniths[i - 1], double(turbidity), angle);
        mScale[i] = mChannels[i].zenith / mChannels[i].at(1, angle);
    }
}

Vec3f Daylight::radiance(const Vec3f &direction) const
{
    const double cosine = direction.dot(mUp), sunAngle = angleBetween(direction.dot(mTowards));
    std::array<double, 3> values;
    for (int i = 0; i < 3; ++i)
        values[i] = mScale[i] * mChannels[i].at(cosine, sunAngle);
    const auto [luminance, x, y] = values;
    const Vec3 xyz(x / y * luminance, luminance, (1 - x - y) / y * luminance);
    Eigen::Matrix3d toRgb; // primaries of sRGB
    toRgb << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
    return (toRgb * xyz).cwiseMax(0.0).cast<float>();
}

Vec3f Sky::radiance(const Vec3f &direction) const
{
    const float height = direction.dot(up);
    if (height < 0)
        return ground;
    return day ? day->radiance(direction) : Vec3f(horizon + height * (zenith - horizon));
}

} // namespace autocuts::bake
