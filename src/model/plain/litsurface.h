// A model that light falls on. Plain: no Qt.
#pragma once

#include "model/plain/shadedsurface.h"

#include <functional>

namespace autocuts {

//! All of it reflects diffusely, on both sides.
struct LitSurface
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv;                //!< the map into which light is baked: per corner, texture space
    std::vector<Vec3f> normals; //!< shading normals, per corner
    //! The share of light that a point reflects, linear, in [0, 1]. Called from several threads.
    std::function<Vec3f(const SurfacePoint &)> albedo;
    std::vector<Vec3f> emission; //!< radiance of each face, to both sides; empty: none shines
};

} // namespace autocuts
