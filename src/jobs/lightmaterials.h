// How the surface of a model reflects and emits light, for light bakes.
#pragma once

#include "model/document/documentstate.h"
#include "model/document/result.h"
#include "model/plain/litsurface.h"

#include <optional>
#include <utility>
#include <vector>

namespace autocuts::jobs {

//! The reflectance of the surface, and the materials that emit light. Colours are linear.
struct LightMaterials
{
    std::vector<std::pair<QString, Vec3f>> emission; //!< radiance of materials
    std::optional<Vec3f> albedo;                     //!< of all faces
    //! A picture of the albedo, and the UV set that it is for; empty: that of the light map. Without a
    //! picture and a colour, the albedo is ShadedSurface::baseColor().
    QString albedoFile, albedoUvSet;

    bool operator==(const LightMaterials &) const = default;
};

//! Takes long for large models and textures.
//! \param model its first UV set is the one that is baked into \param textureSet index of the UV set that the
//! textures of its materials are for \param tileHeight of the texture, see shadedSurface()
//! \param missing gets the names of textures that cannot be read
//! Errors: no UVs, no such material, no such UV set, a picture of the materials that cannot be read.
Result<LitSurface> litSurface(const DocumentState &model, const LightMaterials &materials, int textureSet,
                              double tileHeight, QStringList &missing);

} // namespace autocuts::jobs
