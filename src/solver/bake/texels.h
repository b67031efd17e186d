// Finds the points of a surface that the texels of its map show.
#pragma once

#include "solver/bake/rayscene.h"

#include <Eigen/Geometry>

#include <vector>

namespace autocuts::bake {

//! The texels of one tile of the texture. Texel rows run from the top, as in a Picture.
struct TexelGrid
{
    int width = 0, height = 0;
    Eigen::AlignedBox2d tile{Vec2::Zero(), Vec2::Ones()}; //!< texture space
    int perSide = 1;                                      //!< samples along each side of a texel
};

//! What the texels of some rows show.
struct TexelRows
{
    int first = 0, count = 0;         //!< rows
    std::vector<SurfacePoint> points; //!< per row, texel and sample; triangle -1 where there is no island
    //! Per row and texel: its samples lie inside of islands, or it is only beside one: then its samples have
    //! the nearest point of the surface, so that filtering across a border finds the right value.
    std::vector<bool> inside;
    std::vector<bool> overlapped; //!< per row and texel: a sample lies in two triangles
};

//! Rasterises a map. Where triangles lie on top of each other, the first one counts. Immutable after
//! construction.
class TexelSurface
{
public:
    //! Rows that are made at a time.
    static constexpr int rowsPerBand = 4;

    //! \param uv one row per corner, texture space; triangles without UVs are left out. Must outlive this.
    TexelSurface(const MeshData &mesh, const UvMatrix &uv, const TexelGrid &grid);

    const TexelGrid &grid() const { return mGrid; }
    int bandCount() const { return (mGrid.height + rowsPerBand - 1) / rowsPerBand; }
    int samplesPerTexel() const { return mGrid.perSide * mGrid.perSide; }
    void makeBand(int band, TexelRows &rows) const;
    //! True when a triangle lies in the tile or at most a texel beside it.
    bool isEmpty() const { return mTriangles.empty(); }

private:
    //! A triangle in texels: x to the right, y down.
    struct Flat
    {
        int triangle = 0;
        std::array<Vec2, 3> at;
        double low = 0, high = 0; //!< along y
    };

    void fill(const Flat &flat, TexelRows &rows, std::vector<bool> &deep) const;
    void surround(const Flat &flat, TexelRows &rows, std::vector<double> &nearest) const;

    TexelGrid mGrid;
    std::vector<Flat> mTriangles;
    std::vector<std::vector<int>> mOfBand; //!< indices into mTriangles, ascending
};

} // namespace autocuts::bake
