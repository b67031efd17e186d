// The surface that textures are carried over from, on the triangles of the new model where that is possible.
#pragma once

#include "model/document/scene.h"
#include "model/plain/shadedsurface.h"

namespace autocuts {

//! A model with the map that textures are for.
struct CarriedSurface
{
    ShadedSurface surface;
    bool sameTriangles = true; //!< as those of the new model; otherwise they are to be found by rays
};

//! Of a model whose polygons are all in the new one, in the same order or at the same positions, each
//! triangle stands for its own in the new model. The first UV sets count. Takes long. \param tileHeight see
//! shadedSurface()
CarriedSurface carriedSurface(const Scene &before, const Scene &after, double tileHeight);

} // namespace autocuts
