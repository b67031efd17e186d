// Undoes collapses inside a UV map: no triangle flips and no chart overlaps itself.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/soup.h"
#include "solver/multires/pointfan.h"
#include "solver/multires/progressivemesh.h"

#include <vector>

namespace autocuts::multires {

//! A map of the present surface of a ProgressiveMesh, refined with it. A point that comes back inside a chart
//! is placed where its triangles are distorted least. A point that comes back on a seam or border is placed
//! on the straight side that replaced it, separately on each side of the seam, so that the outlines of charts
//! do not change. This always succeeds up to rounding: the kept point sees the whole polygon around the
//! returning one.
class MapRefiner
{
public:
    //! \param scale factor from mesh units to those of the map
    MapRefiner(ProgressiveMesh &mesh, double scale);

    //! UV per corner 3 t + k, and whether side 3 t + k is cut, for triangles of the present surface. To be
    //! set before refining.
    std::vector<Vec2> uv;
    std::vector<char> cut;
    //! Cost of a seam per length around each point; empty: 1.
    std::vector<double> pointCost;
    //! False when seams must not be moved.
    bool mayStraighten = true;

    //! Undoes collapses until the surface has `triangles` triangles (or all of them), or the job is stopped.
    //! \returns the number of points that had to be placed although a triangle flips
    int refineTo(int triangles, const JobContext &job = {});

private:
    struct Sector
    {
        int begin, end;         //!< range of corners in the fan
        bool hasFirst, hasLast; //!< with the returning triangle before the fan, after it
    };
    //! An edge collapse that is being undone: its points, and the map around the kept point before.
    struct Comeback
    {
        int removed = -1, kept = -1;
        std::vector<int> fan;                //!< corners at the kept point that return to the removed one
        std::vector<Vec2> keptUv;            //!< per corner of the fan
        Vec2 firstEnd, lastEnd;              //!< UVs at both ends of the fan
        std::array<int, 2> triangle{-1, -1}; //!< as in the collapse
    };
    [[nodiscard]] bool refineOne();
    void findSectors(const std::vector<int> &fan, bool hasFirst, bool hasLast);
    Vec2 placeIn(const Sector &sector, const Comeback &back, bool &good);
    void addToFan(int triangle, const Vec3 &p, const Vec3 &a3, const Vec3 &b3, const Vec2 &a, const Vec2 &b);
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
    std::vector<int> mAround; //!< corners found by sectorOf()
};

} // namespace autocuts::multires
