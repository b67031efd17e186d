// Carries textures over from one map of a model to another one.
#pragma once

#include "solver/bake/bakejob.h"

namespace autocuts::bake {

//! A model with the map that textures are made for, and the map for which they are made new.
struct CarryModel
{
    ShadedSurface low;    //!< with the new map
    ShadedSurface source; //!< with the map of the textures; its own textures do not count
    //! Both have the same triangles; otherwise the source is looked for by rays, as for a bake.
    bool sameTriangles = true;
    CageSettings cage{};
    int margin = 16; //!< texels around islands that are filled
};

//! A texture that is carried over.
struct CarryTexture
{
    TiledPicture picture;
    TextureKind kind = TextureKind::Linear;
    std::vector<bool> faces;   //!< of the new map that it is for; empty: all
    int width = 0, height = 0; //!< of the new pictures
    bool floats = false;       //!< for files of floating point numbers
};

//! Makes the pictures of all tiles that the faces lie in. Details are kept as sharp as the texels allow (see
//! sampleSharply()); normals are turned with their islands. Faces whose corners have no UVs in one of the
//! maps are left out. \param sink gets the tile of each picture and the picture; returns false to end it
BakeFigures carryTexture(const CarryModel &model, const CarryTexture &texture,
                         const std::function<bool(int tile, const Picture &picture)> &sink,
                         const JobContext &context);

} // namespace autocuts::bake
