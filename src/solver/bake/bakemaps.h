// The values that a bake computes for points of a surface.
#pragma once

#include "solver/bake/projection.h"
#include "solver/bake/sampling.h"

#include <span>
#include <string_view>
#include <vector>

namespace autocuts::bake {

enum class MapKind {
    Normal,       //!< shading normal in the tangent space of the simple model
    ObjectNormal, //!< shading normal in the space of the model
    Occlusion,    //!< share of the light from around that arrives; 1: all
    BentNormal,   //!< mean direction from which light arrives, in tangent space
    Curvature,    //!< mean curvature times a radius
    Thickness,    //!< distance to the other side, as a share of a limit
    Position,     //!< in the units of the model
    Color,        //!< of the first texture, of vertices, or of the material; linear
    MaterialId,   //!< a colour for each material
    Height,       //!< above the simple model, in the units of the model
    Texture       //!< a channel of texture sets
};

//! One map that a bake is to make.
struct MapRequest
{
    MapKind kind = MapKind::Normal;
    int texture = 0; //!< MapKind::Texture: index into ShadedSurface::textures

    bool operator==(const MapRequest &) const = default;
};

//! How rays are sent around. Distances are shares of the model's size (Frame::size).
struct RaySettings
{
    int rays = 64;    //!< per texel, for maps that send rays around
    double reach = 0; //!< what is farther away does not occlude; 0: everything does
    double curvatureRadius = 0.01;
    double thicknessLimit = 0.25;
};

constexpr bool sendsRays(MapKind kind)
{
    return kind == MapKind::Occlusion || kind == MapKind::BentNormal || kind == MapKind::Curvature ||
           kind == MapKind::Thickness;
}
//! True for directions, which are in [-1, 1] and of unit length.
constexpr bool isDirection(MapKind kind)
{
    return kind == MapKind::Normal || kind == MapKind::ObjectNormal || kind == MapKind::BentNormal;
}
constexpr bool isInTangentSpace(MapKind kind)
{
    return kind == MapKind::Normal || kind == MapKind::BentNormal;
}
//! The name of each map that is not a texture, in options and names of files.
std::span<const std::pair<std::string_view, MapKind>> mapNames();
std::string_view nameOf(MapKind kind);

int channelsOf(const ShadedSurface &source, const MapRequest &request);

//! Computes the values of maps at single points.
class MapProbe final
{
public:
    //! \param low the surface into whose map is baked; all must outlive this
    MapProbe(const ShadedSurface &low, const Frame &frame, const RaySettings &settings)
        : mLow(low), mFrame(frame), mSettings(settings)
    {}

    //! \param at the point of the simple model \param source that of the detailed one; its surface is not
    //! null \param rays how many to send \param out a value per channel
    void probe(const MapRequest &request, const SurfacePoint &at, const Source &source, int rays,
               EvenPoints &points, std::span<float> out) const;

private:
    Vec3f inTangentSpace(const SurfacePoint &at, const Vec3f &direction) const;
    float occlusion(const Source &source, int rays, EvenPoints &points, Vec3f *open) const;
    float curvature(const Source &source, int rays, EvenPoints &points) const;
    float thickness(const Source &source, int rays, EvenPoints &points) const;
    void texture(const MapRequest &request, const SurfacePoint &at, const Source &source,
                 std::span<float> out) const;

    const ShadedSurface &mLow;
    Frame mFrame;
    RaySettings mSettings;
};

} // namespace autocuts::bake
