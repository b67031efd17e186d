// A model with all that its look depends on: normals, UVs, colours and textures. Plain: no Qt.
#pragma once

#include "model/plain/cornercolors.h"
#include "model/plain/picture.h"
#include "model/plain/tangents.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace autocuts {

//! Directions and colours.
using Vec3f = Eigen::Vector3f;

//! A point of a triangle; weights of its second and third corner, in [0, 1].
struct SurfacePoint
{
    int triangle = -1; //!< -1: none
    float second = 0, third = 0;

    //! The value of something that varies linearly over the triangle.
    template <class T>
    T between(const T &a, const T &b, const T &c) const
    {
        using Factor = typename T::Scalar;
        return a * Factor(1 - second - third) + b * Factor(second) + c * Factor(third);
    }
};

//! The pictures of one channel of a material: for each UDIM tile one, or one that repeats.
struct TiledPicture
{
    std::map<int, std::shared_ptr<const Picture>> tiles; //!< by UDIM number; see udimtiles.h
    std::shared_ptr<const Picture> repeated;             //!< where there is no tile; may be null

    //! The picture at a UV in file units (a tile is 1 x 1), and the place in it; null where there is none.
    const Picture *at(const Vec2 &uv) const;
};

//! What the numbers of a texture mean, and so how they are interpolated and carried over.
enum class TextureKind {
    Srgb,         //!< colours, averaged in linear light
    Linear,       //!< numbers
    Normal,       //!< tangent space normals, green up (OpenGL)
    NormalDirectX //!< tangent space normals, green down
};

//! A channel of texture sets.
struct SurfaceTexture
{
    TextureKind kind = TextureKind::Linear;
    std::vector<TiledPicture> ofMaterial; //!< by material; the last one is for faces without a material
    //! Per triangle of the model, see sampleSharply(); empty: 1.
    std::vector<float> stretch{};
};

//! A model as a bake sees it: the one that gets the maps, or the detailed one.
struct ShadedSurface
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv;                                      //!< per corner, texture space; no rows: without UVs
    double tileHeight = 1;                            //!< of that texture space, see udimtiles.h
    std::vector<Vec3f> normals;                       //!< shading normals, per corner
    std::vector<Tangent> tangents;                    //!< per soup corner; empty: no tangent space is needed
    std::shared_ptr<const CornerColors> cornerColors; //!< vertex colours, per corner; null: none
    std::vector<int> faceMaterial;                    //!< -1 for none; empty: none have one
    std::vector<Vec3f> materialColors;                //!< linear
    std::vector<SurfaceTexture> textures;
    std::vector<int> faceGroup; //!< who sees whom, see bake::Projection; empty: all are of group 0

    //! The values at a point.
    Vec3 position(const SurfacePoint &point) const;
    Vec3f faceNormal(int triangle) const;                 //!< unit length; zero without area
    Vec3f shadingNormal(const SurfacePoint &point) const; //!< unit length; the face's where there is none
    Vec2 uvAt(const SurfacePoint &point) const;
    //! Columns: tangent, bitangent and normal, interpolated without making them unit, as renderers do it.
    Eigen::Matrix3f tangentFrame(const SurfacePoint &point) const;
    int materialOf(int triangle) const;
    //! The picture of a texture at a point, null where there is none. \param at gets the place in it, 1 x 1
    //! being the whole picture
    const Picture *pictureAt(int texture, const SurfacePoint &point, Vec2 &at) const;
    //! The colour, linear: of the first texture, else of the vertices, else of the material, if one is known.
    std::optional<Vec3f> baseColor(const SurfacePoint &point) const;
    int groupOf(int triangle) const
    {
        return faceGroup.empty() ? 0 : faceGroup[mesh->triangleFace[triangle]];
    }
};

} // namespace autocuts
