// Light from all around the model, prepared for shading (image-based light, split-sum).
#pragma once

#include "model/plain/picture.h"

#include <array>
#include <atomic>
#include <vector>

namespace autocuts {

//! What shaders need of the surroundings. Directions: y up, the middle of a panorama at -z.
struct Environment
{
    static constexpr int levelCount = 6;
    static constexpr int sideOf(int level) { return 256 >> level; }

    //! Cube maps in the order and orientation of OpenGL, RGB. Level k is what a surface with the roughness
    //! k / (levelCount - 1) reflects.
    std::array<std::vector<float>, levelCount> levels;
    //! Coefficients of the light on a diffuse surface, for nine spherical harmonics.
    std::array<std::array<float, 3>, 9> irradiance{};

    bool isEmpty() const { return levels[0].empty(); }
};

//! Prepares a panorama (equirectangular, 1 or more channels, linear). Takes a second or so; ends early with
//! an empty one when `stop` becomes true. B. Karis, "Real Shading in Unreal Engine 4", 2013 (split-sum); R.
//! Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001.
Environment prepareEnvironment(const Picture &panorama, const std::atomic<bool> *stop = nullptr);

//! A dark room with large soft lights.
Picture studioPanorama();
//! A clear sky with the sun behind haze, over a bright ground.
Picture skyPanorama();

} // namespace autocuts
