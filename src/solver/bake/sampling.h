// Evenly spread directions for rays.
#pragma once

#include "solver/bake/rayscene.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace autocuts::bake {

//! A number for texels and samples that does not repeat in any pattern (the finaliser of MurmurHash3).
inline std::uint32_t scrambled(std::uint32_t value)
{
    value = (value ^ (value >> 16)) * 0x85EBCA6BU;
    value = (value ^ (value >> 13)) * 0xC2B2AE35U;
    return value ^ (value >> 16);
}

//! Points in the unit square that fill it evenly: the sequence R2 (Roberts 2018), begun at a place that
//! depends on a seed.
class EvenPoints
{
public:
    explicit EvenPoints(std::uint32_t seed) : mX(scrambled(seed)), mY(scrambled(seed ^ 0x9E3779B9U)) {}

    Eigen::Vector2f next()
    {
        // Steps of 1/p and 1/p^2 of the whole range, p being the plastic number.
        mX += 3242174889U;
        mY += 2447445414U;
        return {static_cast<float>(mX >> 8) * 0x1.0p-24F, static_cast<float>(mY >> 8) * 0x1.0p-24F};
    }

private:
    std::uint32_t mX, mY;
};

//! Two directions that are orthogonal to a unit direction and to each other (Duff et al. 2017).
inline void makeBasis(const Vec3f &normal, Vec3f &first, Vec3f &second)
{
    const float sign = std::copysign(1.0F, normal.z());
    const float a = -1 / (sign + normal.z()), b = normal.x() * normal.y() * a;
    first = {1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x()};
    second = {b, sign + normal.y() * normal.y() * a, -normal.y()};
}

//! A direction around a normal; its density is proportional to the cosine between both.
inline Vec3f cosineDirection(const Vec3f &normal, const Eigen::Vector2f &point)
{
    Vec3f first, second;
    makeBasis(normal, first, second);
    const float radius = std::sqrt(point.x()), angle = 2 * std::numbers::pi_v<float> * point.y();
    return first * (radius * std::cos(angle)) + second * (radius * std::sin(angle)) +
           normal * std::sqrt(std::max(0.0F, 1 - point.x()));
}

//! A direction on the sphere, all equally likely.
inline Vec3f sphereDirection(const Eigen::Vector2f &point)
{
    const float z = 1 - 2 * point.x(), radius = std::sqrt(std::max(0.0F, 1 - z * z));
    const float angle = 2 * std::numbers::pi_v<float> * point.y();
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

} // namespace autocuts::bake
