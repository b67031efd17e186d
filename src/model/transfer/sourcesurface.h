// A surface with UVs, cut along its seams. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"
#include "model/transfer/surfacetree.h"

#include <vector>

namespace autocuts::transfer {

//! Positions, moved and scaled so that lengths are shares of a model's size.
struct Frame
{
    Vec3 origin = Vec3::Zero();
    double size = 1;

    Vec3 toFrame(const Vec3 &point) const { return (point - origin) / size; }
};

//! The frame in which the bounding box of the mesh is around the origin, with a diagonal of 1. Vertices
//! without a face do not count.
Frame frameOf(const MeshData &mesh);

//! Faces farther away than this share of the source's size are not matched.
inline constexpr double matchReach = 0.05;

//! True when all corners of the triangle have UVs.
bool hasUvs(const MeshData &mesh, const UvMatrix &uv, int triangle);

//! The triangles of a mesh that have UVs, joined where the map is continuous. They have numbers of their own.
class SourceSurface
{
public:
    //! \param uv one row per corner
    SourceSurface(const MeshData &mesh, const UvMatrix &uv, const Frame &frame);

    int triangleCount() const { return static_cast<int>(mUv.size()); }
    const SurfaceTree &tree() const { return mTree; }
    //! The triangle across side k in the map; -1 at seams and borders.
    int neighbour(int triangle, int k) const { return mNeighbours[triangle][k]; }

    //! The UV of a point of the surface.
    Vec2 uvAt(const NearPoint &near) const;
    //! The UV of a point by the linear map of one triangle, which goes on beyond its sides.
    Vec2 continuedUv(int triangle, const Vec3 &point) const;
    //! UV length per length on the surface, in the direction in which it is largest; 0 without area.
    double stretch(int triangle) const { return mStretch[triangle]; }
    //! UV area per area on the surface, negative where the map is mirrored.
    double areaRatio(int triangle) const { return mAreaRatio[triangle]; }
    //! Symmetric Dirichlet energy where the area is kept: 4 where the map is conformal. At most 1e6.
    double energy(int triangle) const;
    //! Diagonal of the bounding box of the UVs.
    double uvSize() const { return mUvSize; }

private:
    void join(const MeshData &mesh, const std::vector<int> &numberOf);
    void measure();

    SurfaceTree mTree;
    std::vector<std::array<Vec2, 3>> mUv;
    std::vector<std::array<int, 3>> mNeighbours;
    std::vector<double> mStretch, mAreaRatio;
    double mUvSize = 0;
};

} // namespace autocuts::transfer
