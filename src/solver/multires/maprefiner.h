// Takes collapses back inside a UV map: no triangle folds, no chart comes to cover itself.
#pragma once

#include "solver/base/soup.h"
#include "solver/multires/pointfan.h"
#include "solver/multires/progressivemesh.h"

#include <vector>

namespace autocuts::multires {

//! A map of the present surface of a ProgressiveMesh, refined with it. A point that comes back inside a chart
//! is placed where its triangles are distorted least; one that comes back on a seam or border is placed on
//! the straight side that ran there, on each bank of its own, so that the outlines of the charts stay as they
//! are. That always succeeds up to the precision of numbers: the triangles around the kept point saw all of
//! the polygon already.
class MapRefiner
{
public:
    //! \param scale of the mesh's units to those of the map
    MapRefiner(ProgressiveMesh &mesh, double scale);

    //! UV of corner 3 t + k, and whether a side is cut, on living triangles. To be set before refining.
    std::vector<Vec2> uv;
    std::vector<char> cut;
    //! What a seam costs per length around each point; empty: 1.
    std::vector<double> pointCost;
    //! False when seams must stay where they are.
    bool mayStraighten = true;

    //! Takes collapses back until that many triangles live (or all of them). \returns the number of points
    //! that had to be placed although a triangle folded
    int refineTo(int triangles);

private:
    struct Sector
    {
        int begin, end;         //!< corners of the fan
        bool hasFirst, hasLast; //!< with the triangle that comes back before, behind the fan
    };
    //! A collapse that is taken back: the points, and the map around the kept one before.
    struct Comeback
    {
        int removed = -1, kept = -1;
        std::vector<int> fan;     //!< corners at the kept point that go over to the removed one
        std::vector<Vec2> keptUv; //!< per corner of the fan
        Vec2 firstEnd, lastEnd;   //!< UVs at both ends of the fan
    };
    [[nodiscard]] bool refineOne();
    void findSectors(const std::vector<int> &fan, bool hasFirst, bool hasLast);
    Vec2 placeIn(const Sector &sector, const Comeback &back, bool &good);
    void addToFan(const Vec3 &p, const Vec3 &a3, const Vec3 &b3, const Vec2 &a, const Vec2 &b);
    void sweep();
    double costOf(int side) const;
    void straighten();
    bool changeBank(int triangle);
    bool sectorOf(int corner);
    double improve(int corner, int steps);
    void makeRoom(int corner);

    ProgressiveMesh &mMesh;
    double mScale;
    std::vector<Sector> mSectors;
    PointFan mPointFan;
    std::vector<int> mAround; //!< corners of a sector
};

} // namespace autocuts::multires
