// A surface that is made coarser by edge collapses, each of which can be undone.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <array>
#include <cstdint>
#include <vector>

namespace autocuts::multires {

//! A mesh with half-edge collapses (one end of an edge moves onto the other), so that vertices of the coarse
//! surface are vertices of the fine one. edgeCollapses() chooses them. The surface is the one that the edge
//! pairs define: each of its points is a single fan of triangles, even where several fans meet at one vertex
//! of the mesh, so every mesh is a manifold with borders here. Triangles keep their numbers. A *side* is
//! 3 t + k and runs from corner k to the next.
class ProgressiveMesh
{
public:
    struct Collapse
    {
        int removed, kept;    //!< points
        int fanBegin, fanEnd; //!< in fan(): corners of `removed` that stayed, counter-clockwise from the
                              //!< first triangle on
        std::array<int, 2> triangle{-1, -1}; //!< removed triangles, before and after the fan; -1 at a border
    };

    //! \param locked per edge pair: true where both ends must stay
    ProgressiveMesh(const MeshData &mesh, const std::vector<bool> &locked);

    //! Collapses edges until `triangles` are left or nothing can be collapsed, or the job is stopped.
    void coarsen(int triangles, const JobContext &job = {});
    //! Undoes the last collapse. \pre there is one
    void refine();

    const std::vector<Collapse> &collapses() const { return mCollapses; }
    const std::vector<int> &fan() const { return mFan; }
    int triangleCount() const { return mCount; }
    int pointCount() const { return static_cast<int>(mPosition.size()); }
    double texelWeight(int triangle) const { return mTexelWeight.empty() ? 1 : mTexelWeight[triangle]; }
    bool isAlive(int triangle) const { return mAlive[triangle]; }
    int point(int corner) const { return mPoint[corner]; }
    int across(int side) const { return mAcross[side]; }
    Vec3 position(int corner) const { return mPosition[mPoint[corner]]; }
    const Vec3 &pointPosition(int point) const { return mPosition[point]; }

    static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
    static int previous(int side) { return side % 3 == 0 ? side + 2 : side - 1; }

    //! The present surface as a mesh of its own. Its triangles keep their texel weights.
    //! \param triangles receives the numbers here of that mesh's triangles
    std::shared_ptr<const MeshData> extract(std::vector<int> &triangles) const;

private:
    void findPoints(const MeshData &mesh);
    void ringOf(int point);
    void collapse(int removed, int kept);

    std::vector<int> mPoint, mAcross;
    std::vector<bool> mAlive, mLocked;
    std::vector<Vec3> mPosition;
    std::vector<int> mObject;         //!< per triangle
    std::vector<double> mTexelWeight; //!< per triangle; empty when all are 1
    int mCount = 0;
    std::vector<Collapse> mCollapses;
    std::vector<int> mFan;
    std::vector<int> mCornerOf; //!< while collapsing: some corner of each point on the present surface
    std::vector<int> mRing;     //!< corners found by ringOf()
};

} // namespace autocuts::multires
