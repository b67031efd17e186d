// What a bake finds at points all over a surface, whatever its map: laid into maps while they change.
#pragma once

#include "solver/bake/encoding.h"
#include "solver/bake/texels.h"
#include "solver/base/jobcontext.h"

#include <algorithm>
#include <vector>

namespace autocuts::bake {

//! One map's values at points of each triangle, traced once. Immutable after construction.
class SurfaceSamples final
{
public:
    //! Takes long. Points are spread evenly over the area. \param low without tangents: they belong to a map
    //! \param points about how many
    SurfaceSamples(const ShadedSurface &low, const Projection &projection, const Frame &frame,
                   const MapRequest &request, const RaySettings &rays, const Encoding &encoding, int points,
                   const JobContext &job);

    MapKind kind() const { return mKind; }
    //! False when the job was stopped.
    bool isComplete() const { return mComplete; }
    //! How many were traced.
    long long points() const { return static_cast<long long>(mValues.size()) / std::max(1, mChannels); }
    long long missed() const { return mMissed; } //!< points that found nothing of the detailed model

    //! A picture of a map of these triangles: directions, colours and numbers encoded for whole numbers, see
    //! Encoding; texels beside islands have the value of the nearest point.
    //! \param low with the UVs, and with tangents where the map is one of tangent space
    Picture lay(const ShadedSurface &low, const TexelGrid &grid, const JobContext &job) const;

private:
    //! The grid of a triangle: `steps` intervals along each side, its values from `first` on.
    struct Grid
    {
        int steps = 1;
        std::size_t first = 0;
    };

    //! Where the values of a point begin whose second and third corner have the weights i and j by steps.
    std::size_t place(const Grid &grid, int i, int j) const
    {
        const auto row = std::size_t(i) * (2 * std::size_t(grid.steps) + 3 - std::size_t(i)) / 2;
        return grid.first + std::size_t(mChannels) * (row + std::size_t(j));
    }
    void layGrids(const MeshData &mesh, int points);
    //! Returns how many points found nothing.
    int trace(int triangle, const Projection &projection, const MapProbe &probe, const MapRequest &request,
              int rays);
    void valueAt(const SurfacePoint &point, std::span<float> out) const;

    MapKind mKind;
    int mChannels = 1;
    bool mComplete = false;
    long long mMissed = 0;
    std::vector<Grid> mGrids; //!< per triangle
    std::vector<float> mValues;
    Encoding mEncoding;
};

} // namespace autocuts::bake
